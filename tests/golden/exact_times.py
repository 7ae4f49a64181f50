"""Rows of --golden --exact-input against exact fractions: exact_times.py PROGRAM [CURVES] [SEED].

Random keys whose times have up to 60 digits, and times of rows as decimals, ratios, lists, files, ranges, steps, rates
and counts. The time and the position of each row, in 40 digits, are those of fractions by cubics.py, rounded once.
Exit 1: a number differs, and its command is printed.
"""
import decimal
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

sys.dont_write_bytecode = True
from cubics import Cubics

program = os.path.abspath(sys.argv[1])
curves = int(sys.argv[2]) if len(sys.argv) > 2 else 60
seed = int(sys.argv[3]) if len(sys.argv) > 3 else 20260101
rng = random.Random(seed)
rules = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]
decimal.getcontext().prec = 40
folder = tempfile.TemporaryDirectory()
os.chdir(folder.name)
compared = failures = 0


def require(condition, what):
    global compared, failures
    compared += 1
    if not condition:
        failures += 1
        if failures <= 10:
            print(what, file=sys.stderr)


def rounded(value):
    return decimal.Decimal(value.numerator) / decimal.Decimal(value.denominator)


def decimal_text(low, high, digits):
    """A decimal with so many decimals between two fractions."""
    scale = 10 ** digits
    number = rng.randint(int(low * scale) + 1, int(high * scale))
    return f"{number // scale}.{number % scale:0{digits}}"


def time_text(low, high):
    if rng.random() < 0.5:
        return decimal_text(low, high, rng.choice([2, 15, 18, 25, 33, 60]))
    divisor = rng.choice([3, 7, 11, 1001, 10 ** 20 + 39])
    return f"{rng.randint(int(low * divisor) + 1, int(high * divisor))}/{divisor}"


def position(curve, t):
    t = min(max(t, curve.times[0]), curve.times[-1])
    i = max([k for k in range(len(curve.cubics)) if curve.times[k] < t], default=0)
    p, b, c, d = curve.cubics[i][0]
    u = (t - curve.times[i]) / (curve.times[i + 1] - curve.times[i])
    return p + u * (b + u * (c + u * d))


for number in range(curves):
    start = rng.choice([0, 0, 1, 1700000000])
    digits = rng.choice([2, 15, 18, 25, 33, 60])
    texts = [decimal_text(start + i + Fraction(1, 10), start + i + Fraction(9, 10), digits)
             for i in range(rng.choice([2, 3, 5]))]
    closed = len(texts) > 2 and rng.random() < 0.25
    times = [Fraction(t) for t in texts]
    positions = [decimal_text(0, 20, rng.choice([1, 5, 40])) for _ in texts]
    tcbs = [[rng.choice(["0", "0", "0.5", "-0.12345678901234567890123"]) for _ in range(3)] for _ in texts]
    keys = "\n".join(["t,x,tension,continuity,bias"] +
                     [",".join([t, x, *tcb]) for t, x, tcb in zip(texts, positions, tcbs)]) + "\n"
    rule = rng.choice(rules)
    period = decimal_text(times[-1] - times[0] + Fraction(1, 3), times[-1] - times[0] + 2, digits) if closed else None
    curve = Cubics(times, [(None, [Fraction(x)], [Fraction(v) for v in tcb]) for x, tcb in zip(positions, tcbs)],
                   rule, ["half", "half"], Fraction(period) if closed else None)
    options = ["--golden", "--exact-input", "--digits", "40", "--tangents", rule]
    options += ["--period", period] if closed else ["--ends", "half"]
    first, last = curve.times[0], curve.times[-1]

    mode = rng.choice(["at", "file", "range", "step", "rate", "count", "per-segment", "pieces"])
    low, high, bounds = first, last, []
    if mode in ("step", "rate", "count", "pieces") and rng.random() < 0.6:
        middle = (first + last) / 2
        texts_of_bounds = time_text(first, middle), time_text(middle, last)
        low, high = (Fraction(t) for t in texts_of_bounds)
        bounds = ["--from", texts_of_bounds[0], "--to", texts_of_bounds[1]]
    elif mode in ("step", "rate", "count", "segments") and not closed and rng.random() < 0.5:
        low, high = first - Fraction(1, 30), last + Fraction(1, 7)  # where the curve rests
        bounds = ["--from", str(low), "--to", str(high), "--extrapolate", "hold"]
    keep = False
    if mode in ("at", "file"):
        wanted = [time_text(first, last) for _ in range(rng.randint(1, 6))] + [rng.choice(texts)]
        want = [Fraction(t) for t in wanted]
        if mode == "file":
            with open("times", "w") as file:
                file.write("\n".join(wanted) + "\n")
        options += ["--at", "@times" if mode == "file" else ",".join(wanted)]
    elif mode == "range":
        a, b = time_text(first, last), time_text(first, last)
        if Fraction(a) > Fraction(b):
            a, b = b, a
        step = Fraction(rng.choice(["1/3", "0.1", "0.0900000000000000000000000000000000001"]))
        want = [Fraction(a) + step * j for j in range(int((Fraction(b) - Fraction(a)) / step) + 1)]
        options += ["--at", f"{a}:{b}:{step}"]
    elif mode in ("step", "rate"):
        text = rng.choice(["1/3", "0.1", "1001/30000", "0.0900000000000000000000000000000000001"])
        step = Fraction(text) if mode == "step" else 1 / (3 * Fraction(text) * 10)
        if mode == "step" and rng.random() < 0.3:  # the last row is at the end, which is no double
            step = (high - low) / rng.choice([3, 7])
            text = str(step)
        options += ["--step", text] if mode == "step" else ["--rate", str(1 / step)]
        want = [low + step * j for j in range(int((high - low) / step) + 1)]
        keep = rng.random() < 0.3
        if keep:
            options += ["--end", "keep"]
            want += [high] if want[-1] != high else []
    elif mode in ("count",):
        rows = rng.randint(2, 9)
        parts = rows if closed and not bounds else rows - 1
        want = [low + (high - low) * j / parts for j in range(rows)]
        options += ["--" + mode, str(rows)]
    elif mode == "pieces":
        want = [max(a, low) for a, b in zip(curve.times, curve.times[1:]) if max(a, low) < min(b, high)]
        ends = [min(b, high) for a, b in zip(curve.times, curve.times[1:]) if max(a, low) < min(b, high)]
        options += ["--emit", "hermite"]
    else:
        parts = rng.randint(1, 4)
        want = [a + (b - a) * j / parts for a, b in zip(curve.times, curve.times[1:]) for j in range(parts)] + [last]
        options += ["--per-segment", str(parts)]
    options += bounds
    if mode in ("step", "rate", "count", "segments"):
        if rng.random() < 0.3:  # rows that are nearly at keys are left out
            options += ["--keys"]
            near = (want[1] - want[0]) / 10 ** 9 if len(want) > 1 else 0
            at_keys = [t for t in curve.times if low <= t <= high]
            want = sorted({*at_keys, *(t for t in want if all(abs(t - key) > near for key in at_keys))})
    done = subprocess.run([program, "-q", *options], input=keys, text=True, capture_output=True)
    what = f"seed {seed} curve {number}: {' '.join(options)}\n{keys}"
    if done.returncode != 0:
        require(False, f"{done.stderr}{what}")
        continue
    rows = [line.split(",") for line in done.stdout.splitlines()][1:]
    require(len(rows) == len(want), f"{len(rows)} rows, expected {len(want)}: {what}")
    for row, time in zip(rows, want):
        t, x = row[:2]
        place = position(curve, time)
        if mode == "pieces":
            duration = ends[want.index(time)] - time
            require(decimal.Decimal(x) == rounded(duration), f"duration {x}, expected {rounded(duration)}: {what}")
            x = row[2]
        require(decimal.Decimal(t) == rounded(time), f"t {t}, expected {rounded(time)}: {what}")
        require(decimal.Decimal(x) == rounded(place), f"x {x}, expected {rounded(place)}: {what}")

print(f"{curves} curves, {compared} comparisons, {failures} differ")
sys.exit(1 if failures else 0)
