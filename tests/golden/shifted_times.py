"""--time-zero first against keys that begin at 0: shifted_times.py PROGRAM [CURVES] [SEED].

Random keys at frames or at decimals are written twice: from 0, and from another time, with --time-zero first. Rows at any
grid, with and without --golden, have the same bytes, and rows compare with each other. Exit 1: bytes differ, and the
command is printed.
"""
import random
import subprocess
import sys
import tempfile
from decimal import Decimal

program = sys.argv[1]
curves = int(sys.argv[2]) if len(sys.argv) > 2 else 40
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
folder = tempfile.TemporaryDirectory()


def run(options, text):
    done = subprocess.run([program, "-q", *options], input=text, text=True, capture_output=True, timeout=60)
    return done.returncode, done.stdout, done.stderr


def keys(name, times, positions):
    return f"{name},x,y\n" + "".join(f"{t},{x},{y}\n" for t, (x, y) in zip(times, positions))


for number in range(curves):
    count = rng.randrange(2, 6)
    positions = [(rng.randrange(-99, 99) / 10, rng.randrange(-99, 99) / 7) for _ in range(count)]
    places = [0]
    for _ in range(count - 1):
        places.append(places[-1] + rng.randrange(1, 9))
    if rng.random() < 0.5:
        name, rate = "frame", rng.choice(["24", "25", "30000/1001", "24000/1001"])
        zero = rng.choice([rng.randrange(1, 50), rng.randrange(1, 100000)])
        from_0, from_zero = places, [place + zero for place in places]
        options = ["--input-fps", rate]
        grids = [["--fps", rate], ["--fps", "60"], ["-n", "7"], ["--step", "0.013"], ["--per-segment", "3"]]
    else:
        name, decimals = "t", rng.choice([1, 2, 3, 6])
        zero = rng.randrange(1, 3 * 10**decimals) + rng.choice([0, 0, 17 * 10 ** (8 + decimals)])
        from_0 = [Decimal(place).scaleb(-decimals) for place in places]
        from_zero = [Decimal(place + zero).scaleb(-decimals) for place in places]
        options = []
        grids = [["--step", "0.01" if decimals > 1 else "0.1"], ["-n", "7"], ["--fps", "7"], ["--fps", "10"], ["--per-segment", "3"]]
    options += rng.choice(grids) + rng.choice([[], ["--fields", "time,position,velocity"]]) + rng.choice([[], ["--golden"]])
    expected = run(options, keys(name, from_0, positions))
    shifted = run([*options, "--time-zero", "first"], keys(name, from_zero, positions))
    if expected[0] != 0 or expected[:2] != shifted[:2]:
        sys.exit(f"curve {number}: {' '.join(options)} --time-zero first\n{keys(name, from_zero, positions)}{expected}\n{shifted}")
    rows = folder.name + "/rows.csv"
    with open(rows, "w") as file:
        file.write(shifted[1])
    if "--golden" in options:
        continue
    checked = run(["--check", rows, *options, "--time-zero", "first"], keys(name, from_zero, positions))
    if checked[0] != 0:
        sys.exit(f"curve {number}: --check rows.csv {' '.join(options)} --time-zero first\n{keys(name, from_zero, positions)}{shifted[1]}\n{checked}")
print(f"{curves} curves")
