#!/usr/bin/env python3
"""Same bytes from several programs: same_bytes.py [--runs N] [--seed S] [--golden] [--ends-of-0.4 RULES] PROGRAM...

Runs every program on the same inputs with the same options, every second one on eight threads instead of one, and
compares standard output and the exit code; one program alone is compared with itself:
  - every file of samples/ in several modes;
  - N random command lines on random keys of laws/keys.py (default 200): rows, pieces, pictures, fits and comparisons;
  - with --golden, the commands of every case of golden/, without the lines that are messages.
Standard error is not compared: the words of messages may differ. Prints each difference with the command line and
leaves its input in the folder same_bytes.failed. Exit 1: something differs.

The first program may be version 0.4, whose default ends are half instead of one-sided. --ends-of-0.4 one-sided gives it
--ends one-sided where neither the command nor the input names a preset or ends, and leaves out what this changes
besides: fits, --identify, --meta, and rules in words. --ends-of-0.4 gte gives the others --preset gte there instead.

For an old and a new build of the program:
  tests/same_bytes.py --runs 5000 --golden OLD/tcbsample build/release/tcbsample
"""

import argparse
import concurrent.futures
import itertools
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

TESTS = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(TESTS / "laws"))
from keys import FINE_TIMES, TIMES, Keys  # noqa: E402

SAMPLES = TESTS.parent / "samples"
NEEDS = re.compile(rb'^needs: .*\n|,"needs":"[^"]*"', re.MULTILINE)  # of --explain; version 0.2 has none
MESSAGE = re.compile(rb"error:|note:|^tcbsample: ")

PRESETS = "gte wildmagic vtk fbx nel 3dsmax cryengine lightwave".split()
FIELDS = ("time position s velocity acceleration jerk speed tangent curvature torsion segment u key").split()


def write_keys(rng, folder):
    """Writes random keys as a file; returns its name and the keys."""
    keys = Keys(rng, times=rng.choice([TIMES, TIMES, FINE_TIMES]), shortest=rng.choice([1, 2]))
    form = rng.choice(["csv", "csv", "tsv", "json", "jsonl", *["ssv"] * (not keys.sparse)])
    path, text = folder / f"keys.{form}", keys.text(form, column=rng.choice(["t", "t", "time_ms"]))
    if rng.random() < 0.1:  # a cell that is no number
        text = text.replace("1", rng.choice(["NA", "nan", "o.5"]), 1)
    path.write_text(text)
    return path.name, keys


def random_mode(rng):
    return rng.choice(
        [
            lambda: ["--step", rng.choice(["0.1", "1/24", "0.37", "1001/30000", "2"])],
            lambda: ["--fps", rng.choice(["24", "30000/1001", "3"])],
            lambda: ["--count", str(rng.choice([1, 2, 7, 100]))],
            lambda: ["--per-segment", str(rng.choice([1, 2, 5]))],
            lambda: ["--at", ",".join(f"{rng.uniform(0, 4):.3f}" for _ in range(rng.randint(1, 5)))],
            lambda: ["--arc-step", rng.choice(["0.5", "3", "1/7"])],
            lambda: ["--arc-count", str(rng.choice([1, 2, 9, 60]))],
            lambda: ["--arc-at", ",".join(f"{rng.uniform(0, 9):.2f}" for _ in range(rng.randint(1, 4)))],
            lambda: ["--tolerance", rng.choice(["1", "0.1", "0.01"])],
            lambda: ["--emit", rng.choice(["hermite", "bezier", "poly"])],
            lambda: ["--fit", rng.choice(["1", "0.1", "0.01"])],
            lambda: ["--plot"],
            lambda: ["--check", "samples.csv"],
            lambda: ["--identify", "samples.csv"],
            lambda: ["--limits=all"],
            lambda: ["--limits=speed=2", "--retime"],
        ]
    )()


# Options that a mode refuses, as they have no effect in it.
OF_RULES = {"--preset", "--tangents", "--ends", "--equal-speed", "--side"}
OF_RANGE = {"--from", "--to", "--end", "--keys"}
OF_NUMBERS = {"--digits", "--fixed", "--hex", "--golden", "--exact-input", "--no-output-header", "--time-format"}
OF_ROWS = {"--output-delimiter", "--file-column"}
REFUSED = {
    "--fit": OF_RULES | OF_RANGE | {"--fields", "--golden", "--exact-input", "--extrapolate", "--closed", "--period",
                                    "--parameter", "--tcb", "--rotation-output", "--rotation-curve", "--rename",
                                    "--no-ease", "--keys", "--no-overshoot"},
    "--plot": OF_NUMBERS | OF_ROWS | {"--time-zero", "--fields", "--meta", "--side", "-f", "--columns", "--extrapolate"},
    "--check": OF_RANGE | OF_NUMBERS | OF_ROWS | {"--meta", "--explain"},
    "--identify": OF_RULES | OF_RANGE | OF_NUMBERS | OF_ROWS | {"--no-overshoot", "--max-gap", "--meta", "--explain", "--fields", "--closed", "--period"},
    "--limits=all": OF_RANGE | OF_NUMBERS | {"--meta", "--explain", "--fields", "--side", "--extrapolate", *OF_ROWS},
    "--limits=speed=2": {"--explain", "--exact-input"},
    "--emit": {"--fields", "--keys", "--end", "--extrapolate", "--side", "--rotation-output"},
    "--per-segment": {"--from", "--to", "--keys"},
    "--tolerance": {"--from", "--to"},
    "--at": {"--from", "--to", "--keys"},
    "--arc-at": {"--from", "--to", "--keys"},
}


def random_options(rng, keys):
    """Mostly options that agree with each other; one run in ten draws from all, to compare refusals."""
    mode = random_mode(rng)
    groups = [list(mode)]  # an option and its value
    any_of_all = rng.random() < 0.1
    given = {mode[0]}

    def maybe(chance, *words, needs=True):
        if (rng.random() < chance and needs and words[0] not in REFUSED.get(mode[0], ())) or (
                any_of_all and rng.random() < 0.5 * chance):
            groups.append(words)
            given.add(words[0])

    by_step = mode[0] in ("--step", "--fps", "--arc-step")
    by_place = mode[0] in ("--at", "--arc-at")
    fields = rng.sample(FIELDS, rng.randint(1, 6)) if rng.random() < 0.4 else []
    options = keys.options()
    if rng.random() < 0.3:
        options = ["--preset", rng.choice(PRESETS), *options[4 if "--ends" in options else 2:]]
    while options:
        words = options[:1 if options[0] in ("--closed", "--equal-speed") else 2]
        options = options[len(words):]
        maybe(1, *words)
    maybe(0.1, "--no-ease")
    rules = rng.choices("hold linear repeat offset oscillate error".split(), k=rng.randint(1, 2))
    maybe(0.5 if by_place else 0, "--extrapolate", ",".join(rules))
    maybe(0.15, "--from", f"{rng.uniform(-2, 3):.2f}")
    maybe(0.15, "--to", f"{rng.uniform(1, 9):.2f}")
    maybe(0.4, "--end", rng.choice("drop keep fit fit-down fit-up".split()), needs=by_step)
    maybe(0.15, "--keys")
    measured = mode[0].startswith("--arc") or mode[0] == "--tolerance" or {"s", "speed", "tangent"} & set(fields)
    maybe(0.2, "--metric", rng.choice(["x", "1"]), needs=measured)
    maybe(0.1, "--sort")
    maybe(0.1, "--duplicates", rng.choice("first last break spread".split()))
    maybe(0.1, "--no-overshoot")
    maybe(0.1, "--time-zero", rng.choice(["first", "-1.5"]))
    maybe(0.1, "--missing", rng.choice("skip-row skip-cell break".split()), needs="--missing" not in given)
    maybe(0.15, "--tcb", rng.choice(["0.5,0,0", "0,-1,0", "0.1,0.2,-0.3"]))
    maybe(0.02, "--parameter", rng.choice("uniform chordal centripetal 0.3".split()))
    if mode[0] in ("--check", "--identify", "--limits=all"):
        maybe(0.4, "-f", rng.choice(["json", "svg"]))
    else:
        maybe(0.4, "-f", rng.choice("csv tsv ssv json jsonl npy".split()))
    maybe(1 if fields else 0, "--fields", ",".join(fields))
    changing = {"velocity", "acceleration", "jerk", "tangent", "curvature", "torsion", "speed"} & set(fields)
    maybe(0.2, "--side", rng.choice(["left", "right"]), needs=changing)
    maybe(0.15, *rng.choice([["--digits", "6"], ["--digits", "17"], ["--fixed", "3"], ["--hex"]]))
    maybe(0.1, "--no-output-header", needs="-f" not in given)
    maybe(0.1, "--output-delimiter", rng.choice([";", "tab"]), needs="-f" not in given)
    maybe(0.5, "--output-decimal", ",", needs="--output-delimiter" in given and "--hex" not in given)
    maybe(0.05, "--file-column")
    maybe(0.1, "--meta", needs="-f" not in given)
    maybe(0.1, "--explain", needs="--meta" not in given)
    maybe(0.08, "--golden")
    maybe(0.3, "--exact-input", needs="--golden" in given)
    if keys.rotations:
        maybe(0.3, "--rotation-output", rng.choice(["quaternion", "axis-angle", "matrix", "euler=ZYX"]))
    maybe(0.05, "--rename", "x=px")
    maybe(0.05, "--scale", "x=0.01")
    maybe(0.3, "--fit-keys", "hermite", needs=mode[0] == "--fit")
    maybe(0.3, "--abs", "1e-6", needs=mode[0] == "--check")
    return [word for group in groups for word in group]


def run(program, arguments, folder, stdin=None):
    try:
        done = subprocess.run([program] + arguments, cwd=folder, capture_output=True, stdin=stdin, timeout=20)
        return done.returncode, NEEDS.sub(b"", done.stdout) if "--explain" in arguments else done.stdout, done.stderr
    except subprocess.TimeoutExpired:
        return "timeout", b"", b""


NAMES_RULES = {"--preset", "--ends", "--closed", "--period"}
TELLS_RULES = {"--plot", "--explain", "svg"}
RULES_OF_INPUT = re.compile(rb'"(preset|ends|closed)":')


def rules_in_common(options, folder, ends_of_old):
    """What the first program and the others get, so that their rules are the same; nothing: that is impossible."""
    if ends_of_old is None:
        return [], []
    given = set(options)
    if given & {"--fit", "--identify", "--meta"} or (given & TELLS_RULES and "--preset" not in given):
        return None
    if NAMES_RULES & given or RULES_OF_INPUT.search((folder / options[-1]).read_bytes()):
        return [], []
    return (["--ends", "one-sided"], []) if ends_of_old == "one-sided" else ([], ["--preset", "gte"])


def run_all(programs, options, folder, ends_of_old=None):
    """The first program on one thread, the second on eight, and so on; one program alone on both. Nothing where they
    cannot be compared."""
    several = programs if len(programs) > 1 else programs * 2
    rules = rules_in_common(options, folder, ends_of_old)
    if rules is None:
        return []
    return [run(program, ["-j", "18"[i % 2], *rules[min(i, 1)], *options], folder) for i, program in enumerate(several)]


def write_samples(rng, folder, program, keys, name):
    """Samples of the keys by the first program, for --check and --identify; in some of them a number is changed."""
    group = ["--group", "id"] if len(keys.labels) > 1 else []
    _, rows, _ = run(program, ["--count", "9", *group, name], folder)
    if rng.random() < 0.3:
        rows = rows.replace(b"1", b"2", rng.randint(1, 3))
    (folder / "samples.csv").write_bytes(rows)


class Comparison:
    def __init__(self, programs):
        self.programs = programs
        self.compared = self.accepted = self.differences = self.timeouts = 0

    def report(self, what, results, folder=None):
        if not results:
            return
        if any(result[0] == "timeout" for result in results):
            self.timeouts += 1
            return
        self.compared += 1
        self.accepted += results[0][0] == 0
        if any(result[:2] != results[0][:2] for result in results[1:]):
            self.differences += 1
            print(f"differs: {what}")
            for program, (code, out, err) in zip(itertools.cycle(self.programs), results):
                print(f"  {program}: exit code {code}, {len(out)} bytes; {err[:300].decode(errors='replace').strip()}")
            if folder:
                shutil.copytree(folder, f"same_bytes.failed/{self.differences}", dirs_exist_ok=True)


def sample_runs():
    for file in sorted(SAMPLES.iterdir()):
        if file.suffix not in (".csv", ".tsv", ".txt", ".json", ".jsonl"):
            continue
        for mode in ("--step 1/30", "--count 1001", "--arc-count 777", "--per-segment 3 -f jsonl", "--tolerance 0.1"):
            if file.name != "events.jsonl" or "--step" not in mode:  # nanoseconds: too many rows
                yield [*mode.split(), "--fields", "time,position,s", file.name]


def golden_case(program, case):
    """Standard output of a case without messages, and the exit code."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "case"
        shutil.copytree(case, folder)
        binaries = pathlib.Path(scratch) / "bin"
        binaries.mkdir()
        (binaries / "tcbsample").symlink_to(program)
        path = f"{binaries}:{os.environ['PATH']}"
        done = subprocess.run(["sh", "./cmd"], cwd=folder, capture_output=True, stdin=subprocess.DEVNULL,
                              env={**os.environ, "PATH": path})
        out = NEEDS.sub(b"", done.stdout) if "--explain" in (case / "cmd").read_text() else done.stdout
        lines = [line for line in out.split(b"\n") if not MESSAGE.search(line)]
        return done.returncode, b"\n".join(lines), done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", metavar="PROGRAM")
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--golden", action="store_true")
    parser.add_argument("--ends-of-0.4", dest="ends_of_old", choices=["one-sided", "gte"])
    arguments = parser.parse_args()
    programs = [str(pathlib.Path(program).resolve()) for program in arguments.programs]
    comparison = Comparison(programs)

    def random_run(index):
        rng = random.Random(f"{arguments.seed} {index}")
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            name, keys = write_keys(rng, folder)
            write_samples(rng, folder, programs[0], keys, name)
            options = random_options(rng, keys) + [name]
            results = run_all(programs, options, folder, arguments.ends_of_old)
            comparison.report(f"run {index}: tcbsample " + " ".join(options), results, folder)

    for options in sample_runs():
        results = run_all(programs, options, SAMPLES, arguments.ends_of_old)
        comparison.report("samples: tcbsample " + " ".join(options), results)
    if arguments.golden:
        for case in sorted((TESTS / "golden").rglob("cmd")):
            results = [golden_case(program, case.parent) for program in programs]
            comparison.report(f"case {case.parent.relative_to(TESTS)}", results)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        list(pool.map(random_run, range(arguments.runs)))

    print(f"{comparison.compared} compared, {comparison.accepted} accepted, {comparison.differences} differ, "
          f"{comparison.timeouts} took too long")
    return comparison.differences > 0


if __name__ == "__main__":
    sys.exit(main())
