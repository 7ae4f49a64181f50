"""Finds mutations of src/read and src/sample that quick tests do not notice: mutate.py BUILD [COUNT] [SEED] [PATH...].

Changes one operator or constant of a source at a time, builds, and runs the quick tests of these folders. Prints the
mutations that survive: each needs a test, unless it is equivalent. BUILD is a configured build folder of these sources,
with optimization off. Each source is restored afterwards. Exit 1: a mutation survived.
"""
import os
import random
import re
import signal
import subprocess
import sys

build = sys.argv[1]
count = int(sys.argv[2]) if len(sys.argv) > 2 else 40
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
places = sys.argv[4:] or ["src/read", "src/sample"]
targets = ["tcbsample", "units"]
tests = "^(golden|units)/"

swaps = [(r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "), (r" == ", " != "), (r" != ", " == "),
         (r" && ", " || "), (r" \|\| ", " && "), (r" \+ 1\b", ""), (r" - 1\b", ""), (r"\btrue\b", "false"),
         (r"\bfalse\b", "true"), (r"\(!", "("), (r"\bmin\(", "max("), (r"\bmax\(", "min(")]


def sources():
    for place in places:
        path = os.path.join(root, place)
        if os.path.isfile(path):
            yield path
        for folder, _, names in os.walk(path):
            yield from (os.path.join(folder, name) for name in sorted(names) if name.endswith(".cpp"))


def mutations():
    """(path, line number, line, mutated line) of all places."""
    for path in sorted(sources()):
        with open(path, encoding="utf-8") as file:
            lines = file.read().split("\n")
        for number, line in enumerate(lines):
            code = line.split("//")[0]
            if code.lstrip().startswith(("#", "template", "using")):
                continue
            for pattern, other in swaps:
                for found in re.finditer(pattern, code):
                    yield path, number, line, line[:found.start()] + other + line[found.end():]


def is_noticed():
    """Whether the mutated source does not compile, or a test fails."""
    made = subprocess.run(["ninja", "-C", build, "-j2", *targets], capture_output=True)
    if made.returncode != 0:
        return True
    try:
        done = subprocess.run(["ctest", "-j2", "-R", tests, "-LE", "slow", "--stop-on-failure", "--timeout", "20"], cwd=build,
                              capture_output=True, timeout=300)
    except subprocess.TimeoutExpired:
        return True
    return done.returncode != 0


for number in (signal.SIGINT, signal.SIGTERM):  # so that the source is restored
    signal.signal(number, lambda *_: sys.exit(2))
everything = list(mutations())
chosen = rng.sample(everything, min(count, len(everything)))
survived = 0
for path, number, line, mutated in chosen:
    with open(path, encoding="utf-8") as file:
        text = file.read()
    lines = text.split("\n")
    lines[number] = mutated
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
        noticed = is_noticed()
    finally:
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    survived += not noticed
    where = f"{os.path.relpath(path, root)}:{number + 1}"
    print(f"{'noticed ' if noticed else 'SURVIVED'} {where}: {mutated.strip()}", flush=True)
print(f"{len(chosen)} of {len(everything)} mutations, {survived} survived")
sys.exit(1 if survived else 0)
