"""Golden rows do not depend on each other: golden_rows.py PROGRAM [CURVES] [SEED].

Random curves with steps and positions from 1e-300 to 1e300, also with lengths, and rotations. Each list of places is
printed in one run, in reverse, shuffled, and row by row; each row has the same bytes in all of them, and
no error is one of a library. Then numbers within a few units of powers of ten are printed with 1 to 40 digits, exactly,
as bounded numbers and as what lies at a length, against decimals rounded once.
Exit 1: a row differs, and its command is printed.
"""
import decimal
import os
import random
import subprocess
import sys
import tempfile
from decimal import Decimal

program = os.path.abspath(sys.argv[1])
curves = int(sys.argv[2]) if len(sys.argv) > 2 else 12
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
folder = tempfile.TemporaryDirectory()
os.chdir(folder.name)
failures = compared = 0


def fail(what):
    global failures
    failures += 1
    if failures <= 10:
        print(what, file=sys.stderr)


def run(text, *arguments):
    with open("k.csv", "w") as file:
        file.write(text)
    result = subprocess.run([program, "--golden", "--quiet", "--no-output-header", *arguments, "k.csv"],
                            capture_output=True, text=True)
    if result.returncode and not result.stderr.startswith(("tcbsample: error: ", "k.csv:", "k.csv: ")):
        fail(f"{result.stderr}: {' '.join(arguments)}\n{text}")
    return result.stdout.splitlines() if result.returncode == 0 else None


def hostile():
    return rng.choice([0, 1, -1, rng.uniform(-9, 9)]) * 10.0 ** rng.choice([0, 0, 0, 1, -1, rng.randint(-300, 299)])


def keys():
    count = rng.randint(2, 5)
    kind = rng.choice(["plain", "plain", "plain", "axis"])
    times = sorted({hostile() if rng.random() < 0.4 else i for i in range(count)})
    while len(times) < 2:
        times.append(times[-1] + 1)
    if kind == "plain":
        rows = [[repr(hostile()) for _ in range(rng.choice([1, 3]))] for _ in times]
        width = min(map(len, rows))
        names, rows = "xyz"[:width], [row[:width] for row in rows]
    else:
        names = ["ax", "ay", "az", "angle"]
        axes = rng.choice([[["0", "0", "1"]], [["1", "2", "-1"]], [["1", "0", "0"], ["0.6", "-0.8", "1e-9"]]])
        rows = [[*rng.choice(axes), repr(rng.choice([0, 0, 1, rng.uniform(-3, 3)]))] for _ in times]
    lines = [",".join([repr(t), *row]) for t, row in zip(times, rows)]
    return kind, times, "\n".join([",".join(["t", *names]), *lines]) + "\n"


for _ in range(curves):
    kind, times, text = keys()
    places = [t + rng.random() * (next_time - t) for t, next_time in zip(times, times[1:])] + [times[0], times[-1]]
    options, fields = [], ["time", "position", "velocity", "acceleration", "speed", "tangent", "curvature", "torsion"]
    if kind == "axis":
        options = ["--rotation", "axis-angle=ax:ay:az:angle"]
        options += ["--rotation-curve", rng.choice(["squad", "casteljau", "components", "slerp"])]
        fields = ["time", "position", "angular_velocity"]
    if kind == "plain" and rng.random() < 0.2:
        fields.append("s")
    rng.shuffle(fields)
    options += ["--fields", ",".join(fields[:rng.randint(2, len(fields))])]
    shuffled = places[:]
    rng.shuffle(shuffled)
    alone = {}
    for place in places:
        rows = run(text, *options, f"--at={place!r}")
        alone[place] = rows
    for order in (places, places[::-1], shuffled):
        if any(alone[place] is None for place in order):
            continue
        listed = f"--at={','.join(map(repr, order))}"
        rows = run(text, *options, listed)
        compared += len(order)
        if rows != [row for place in order for row in alone[place]]:
            fail(f"rows depend on others: {' '.join(options)} {listed}\n{text}")


def significant(value, count):
    with decimal.localcontext() as context:
        context.prec = count
        return +value


decimal.getcontext().prec = 400
for digits in range(1, 41):
    numbers = []
    for exponent in (0, 1, -1, rng.randint(-30, 30)):
        for unit in (digits, digits + 1, rng.choice([16, 17, 31])):
            off = Decimal(rng.choice([-6, -5, -4, -2, -1, 1, 4, 5, 6])).scaleb(exponent - unit)
            numbers.append(Decimal(10) ** exponent + off)
    # Between two keys with one position and no tangents the curve is constant.
    text = "t,x,tension\n" + "".join(f"{2 * i},{x},1\n{2 * i + 1},{x},1\n" for i, x in enumerate(numbers))
    middles = ",".join(f"{2 * i}.5" for i in range(len(numbers)))
    for options in ([], ["--exact-input"]):
        rows = run(text, "--digits", str(digits), f"--at={middles}", "--fields", "position", "--ends", "zero", *options)
        for shown, number in zip(rows, numbers, strict=True):
            exact = number if options else Decimal(float(number))
            compared += 1
            if Decimal(shown) != significant(exact, digits):
                fail(f"{shown} for {exact}, expected {significant(exact, digits)}: {digits} digits, {options}")
    # A tangent of a line is the root of a rational; what lies at a length is found by floats.
    slope = float(numbers[0])
    exact = Decimal(slope) / (1 + Decimal(slope) ** 2).sqrt()
    line = f"t,x,y\n0,0,0\n1,1,{slope!r}\n"
    for place in ("--at=0.5", "--arc-at=0.25"):
        rows = run(line, "--digits", str(digits), "--ends", "chord", place, "--fields", "tangent")
        compared += 1
        if Decimal(rows[0].split(",")[1]) != significant(exact, digits):
            fail(f"{rows[0]}, expected {significant(exact, digits)}: {digits} digits, {place}\n{line}")

print(f"{compared} rows and numbers compared, {failures} differ")
sys.exit(1 if failures else 0)
