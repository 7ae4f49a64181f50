"""--max-gap against each part alone: gaps.py PROGRAM [CASES] [SEED].

The list of random keys is cut where their times are further apart, and each part is a file of its own, with the rows of
the same grid, at the same times, or of the same segments. All rows together, the note on gaps, and a comparison with
rows in gaps are as these parts say. Exit 1: something differs, and its command is printed.
"""
import random
import subprocess
import sys
import tempfile
from fractions import Fraction as F

program = sys.argv[1]
cases = int(sys.argv[2]) if len(sys.argv) > 2 else 20
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
header = "t,x,y,tension,bias"
folder = tempfile.TemporaryDirectory()


def run(options, text, codes=(0,)):
    done = subprocess.run([program, *options, "-"], input=text, capture_output=True, text=True, timeout=60)
    if done.returncode not in codes:
        sys.exit(f"{' '.join(options)}: exit code {done.returncode}: {done.stderr}\n{text}")
    return done.stdout, done.stderr


def expect(what, is_right, options, text):
    if not is_right:
        sys.exit(f"case {number}: {what}: {' '.join(options)} -\n{text}")


def of(keys):
    return "\n".join([header, *(",".join(map(str, [float(key[0]), *key[1:]])) for key in keys)]) + "\n"


def lines(rows):
    return rows.splitlines()[1:]


def at(part, times, options):
    """The rows of one part at some of its times; a single key is its own row."""
    if len(part) == 1:
        return [f"{float(t):g},{part[0][1]},{part[0][2]}" for t in times]
    return lines(run([*options, "--at", ",".join(str(float(t)) for t in times)], of(part))[0]) if times else []


for number in range(cases):
    most = F(rng.choice([1, 2, 3, 5]))
    keys, t = [], F(rng.randint(-80, 80), 8)
    for _ in range(rng.randint(2, 14)):
        keys.append((t, rng.randint(-9, 9), rng.randint(-9, 9), rng.choice([0, 0.25, 0.5]), rng.choice([0, -0.5])))
        t += rng.choice([F(rng.randint(1, 8 * int(most)), 8), most, most + F(1, 8), most * rng.randint(2, 9)])
    parts = [[keys[0]]]
    for before, key in zip(keys, keys[1:]):
        if key[0] - before[0] > most:
            parts.append([])
        parts[-1].append(key)
    gaps = [(a[-1][0], b[0][0]) for a, b in zip(parts, parts[1:])]
    rules = ["--tangents", rng.choice(["velocity", "uniform", "interval"]), "--ends", rng.choice(["half", "natural", "zero"])]
    options = [*rules, "--max-gap", str(most)]
    text = of(keys)

    step = F(rng.randint(1, 24), 8)
    first = keys[0][0]
    grid = [first + j * step for j in range(int((keys[-1][0] - first) / step) + 1)]
    on = [[t for t in grid if part[0][0] <= t <= part[-1][0]] for part in parts]
    command = [*options, "--step", str(float(step))]
    rows, notes = run(command, text)
    expected = [row for part, times in zip(parts, on) for row in at(part, times, rules)]
    expect("rows at steps", [row for row in lines(rows) if row] == expected, command, text)
    blocks = [block.splitlines() for block in rows.split("\n", 1)[1].split("\n\n")]
    expect("rows of a part together", [len(block) for block in blocks] == [len(times) for times in on if times], command, text)
    if gaps:
        largest = max(b - a for a, b in gaps)
        words = f"{len(gaps)} gap{'s' if len(gaps) > 1 else ''} between keys begin{'' if len(gaps) > 1 else 's'} a new curve; " \
            f"the largest is {float(largest):g}\n"
        expect(f"the note {words}", words in notes, command, text)
    else:
        expect("no note", "gap" not in notes, command, text)

    command = [*options, "--check", f"{folder.name}/rows.csv"]
    outside = [(2 * a + b) / 3 for a, b in gaps if a + 1 < b][:rng.randint(0, 3)]
    for extra in {0, len(outside)}:
        with open(f"{folder.name}/rows.csv", "w") as file:
            file.write("t,x,y\n" + "".join(row + "\n" for row in expected))
            file.write("".join(f"{float(t)},0,0\n" for t in outside[:extra]))
        report, _ = run(command, text, (0, 1))
        counts = [int(line.split(": ")[2].split(";")[0]) for line in report.splitlines() if "rows outside" in line]
        expect(f"a comparison with {extra} rows in gaps", sum(counts) == extra and f"\nrows: {len(expected)}\n" in report and
               "\nmismatches: 0\n" in report, command, text + report)

    inside = sorted(rng.choice(times) for times in on if times for _ in range(2))
    command = [*options, "--at", ",".join(str(float(t)) for t in inside)]
    rows, _ = run(["-q", *command], text)
    expected = [row for part in parts for row in at(part, [t for t in inside if part[0][0] <= t <= part[-1][0]], rules)]
    expect("rows at times", [row for row in lines(rows) if row] == expected, command, text)
    if outside:
        command = [*options, f"--at={float(outside[0])}"]
        _, words = run(command, text, (1, 2))
        a, b = next((a, b) for a, b in gaps if a < outside[0] < b)
        expect("the gap of a time", f"is in the gap from {float(a):g} to {float(b):g};" in words, command, text + words)

    if min(map(len, parts)) > 1:
        for form in (["--per-segment", str(rng.randint(1, 4))], ["--emit", "hermite"]):
            command = [*options, *form]
            rows, _ = run(["-q", *command], text)
            alone = [row for part in parts for row in lines(run([*rules, *form], of(part))[0])]
            expect("rows of segments", [row for row in lines(rows) if row] == alone, command, text)
print(f"{cases} cases")
