"""The frame of laws: cases with random keys, the program, and what is required of it.

    LAW.py PROGRAM [CASES [SEED]]

A law is a function of `rng`, which it gives to check(). A case that fails is printed with its number, its commands and
their input; exit 1: there is one. The same SEED gives the same cases, and CASES may end at the one that failed.
"""
import os
import random
import shlex
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
program = os.path.abspath(sys.argv[1])
seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
folder = tempfile.TemporaryDirectory()  # in which the program runs
facts = 0
ran = []  # commands of the case with their input


def run(text, *options, codes=(0,), timeout=60, **others):
    """A run of the program with keys on its standard input. Another exit code than one of `codes` is a failure."""
    ran.append((options, text))
    try:
        done = subprocess.run([program, *options], input=text, capture_output=True, text=True, timeout=timeout,
                              cwd=folder.name, **others)
    except subprocess.TimeoutExpired:
        raise Failure(f"no end after {timeout} seconds") from None
    if done.returncode not in codes:
        raise Failure(f"exit code {done.returncode}: {done.stderr}")
    return done


def lines(text, *options):
    """The rows of a table as lists of cells, without the header and without empty lines."""
    return [line.split(",") for line in run(text, "-q", *options).stdout.splitlines()[1:] if line]


def numbers(text, *options):
    return [[float(cell) if cell else None for cell in row] for row in lines(text, *options)]


def blocks(text, *options):
    """The rows of each curve, between empty lines or with one label, by the names of their columns."""
    header, *rows = run(text, "-q", *options).stdout.splitlines()
    names, found, last = header.split(","), [], None
    for row in [dict(zip(names, line.split(","), strict=True)) if line else None for line in rows]:
        if row and (not last or last.get("id") != row.get("id")):
            found.append([])
        if row:
            found[-1].append(row)
        last = row
    return found


class Failure(Exception):
    """What is required of a case does not hold."""


def require(holds, what):
    global facts
    facts += 1
    if not holds:
        raise Failure(what)


def same(got, want, what):
    require(got == want, f"{what}: {got}, expected {want}")


def near(got, want, bound, what):
    """Whether a number is within a bound of an exact one."""
    off = abs(type(want)(got) - want)
    require(off <= bound, f"{what}: {got}, expected {float(want)!r} within {float(bound):.3g}; off by {float(off):.3g}")


def write(name, text):
    with open(os.path.join(folder.name, name), "w") as file:
        file.write(text)


def check(law, cases, least=0):
    """Runs the law for so many cases, or those of the command line. `least`: of the facts per case, so that a law whose
    cases are all refused is noticed."""
    cases, failures = int(sys.argv[2]) if len(sys.argv) > 2 else cases, 0
    for case in range(cases):
        ran.clear()
        try:
            law(random.Random(f"{seed} {case}"))
        except (Failure, ValueError, LookupError) as failure:  # the latter where rows or columns are missing
            failures += 1
            if failures <= 10:
                options, text = ran[-1]
                print(f"seed {seed}, case {case}: {failure!r}", shlex.join(options), text, sep="\n", file=sys.stderr)
    print(f"{cases} cases, {facts} facts, {failures} failures")
    sys.exit(1 if failures or facts < max(1, least * cases) else 0)
