"""Distance of rows from those of --golden, field by field: distance.py PROGRAM MANUAL [CURVES].

The distance is in units in the last place of the exact number, or of a thousandth of the largest number of its column
on that curve, whichever is more. No distance may exceed the largest or the mean in the table of MANUAL.
"""
import math
import random
import re
import subprocess
import sys

program, manual = sys.argv[1:3]
curves = int(sys.argv[3]) if len(sys.argv) > 3 else 40
rng = random.Random(7)
fields = ["position", "s", "velocity", "acceleration", "jerk", "speed", "tangent", "curvature", "torsion", "u"]
by_length = ["time", "position", "velocity", "speed", "u"]
per_channel = ["position", "velocity", "acceleration", "jerk", "tangent"]
tangents = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]


def keys():
    t, lines = rng.uniform(-9, 9), ["t,x,y,z,tension,continuity,bias"]
    for _ in range(6):
        numbers = [t] + [rng.uniform(-10, 10) for _ in range(3)] + [rng.uniform(-1, 1) for _ in range(3)]
        lines.append(",".join(map(repr, numbers)))
        t += rng.uniform(0.05, 3)
    return "\n".join(lines) + "\n"


def table(text, options):
    out = subprocess.run([program, *options], input=text, text=True, capture_output=True, check=True).stdout
    return [[float(cell) if cell else None for cell in line.split(",")] for line in out.splitlines()[1:]]


distances = {}
for number in range(curves):
    text = keys()
    for kind, names, mode in (("", fields, ["--count", "41"]), ("by length: ", by_length, ["--arc-count", "11"])):
        options = ["--tangents", rng.choice(tangents), *mode, "--fields", ",".join(names)]
        columns = [name for name in names for _ in range(3 if name in per_channel else 1)]
        fast, exact = table(text, options), table(text, [*options, "--golden"])
        for column, name in enumerate(columns):
            pairs = [(f[column], e[column]) for f, e in zip(fast, exact, strict=True)]
            pairs = [(f, e) for f, e in pairs if f is not None and e is not None]
            largest = max((abs(e) for _, e in pairs), default=0)
            for f, e in pairs:
                unit = math.ulp(max(abs(e), largest / 1000))
                distances.setdefault(kind + name, []).append(abs(f - e) / unit)

promised = {}
lines = open(manual, encoding="utf-8").read().replace("\\-", "-").splitlines()
for line in lines[lines.index("field                   largest   mean") + 1:]:
    row = re.fullmatch(r"(.*?\S) {2,}([\d.]+) +([\d.]+)", line)
    if not row:
        break
    promised[row[1]] = float(row[2]), float(row[3])

failed = set(distances) != set(promised)
for name, values in distances.items():
    largest, mean = max(values), sum(values) / len(values)
    print(f"{name:24}{largest:7.1f}{mean:7.2f}")
    failed |= name in promised and (largest > promised[name][0] or mean > promised[name][1])
sys.exit(1 if failed else 0)
