"""Rows at a pace against arithmetic of 40 digits: paces.py PROGRAM [CURVES] [SEED].

Random keys are sampled with --pace: constant, ease with random ramps, and profiles of keys with tension 1, whose curve is
s0 + (s1 - s0) (3 w^2 - 2 w^3). The arc length of each row, its place on the curve, velocity, speed and acceleration are
computed by the quadrature of referee.py. Of rows with --golden, each number is the double that is nearest to it. Exit 77: there is no mpmath.
"""
import random
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
program = sys.argv[1]
curves = int(sys.argv[2]) if len(sys.argv) > 2 else 20
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)

from referee import Curve, exact, made, mp, mpf, norm, random_keys, text, write

mp.dps = 40

folder = tempfile.TemporaryDirectory()


def ramp(w):
    return w**3 - w**4 / 2, 3 * w**2 - 2 * w**3, 6 * w - 6 * w**2


def eased(p, a, b):
    """The part of the length at the part p of the duration, and its derivatives."""
    top = 1 / (1 - a / 2 - b / 2)
    if p < a:
        distance, speed, change = ramp(p / a)
        return top * a * distance, top * speed, top * change / a
    if p > 1 - b:
        distance, speed, change = ramp((1 - p) / b)
        return 1 - top * b * distance, top * speed, -top * change / b
    return top * (p - a / 2), top, mpf(0)


def profiled(keys, t):
    """The distance on a profile of keys with tension 1, and its derivatives."""
    for (t0, s0), (t1, s1) in zip(keys, keys[1:]):
        if t < t1 or t1 == keys[-1][0]:
            h, w, d = t1 - t0, (t - t0) / (t1 - t0), s1 - s0
            return s0 + d * (3 * w**2 - 2 * w**3), d * (6 * w - 6 * w**2) / h, d * (6 - 12 * w) / h**2
    raise ValueError(t)


def place_at(curve, s):
    """(segment, u) where the curve has the length s: by Newton's method, or halves."""
    i = 0
    while i + 1 < len(curve.cubics) and s > curve.length(i):
        s -= curve.length(i)
        i += 1
    if s == 0 or abs(s - curve.length(i)) < mpf(10) ** -30 * s:
        return i, mpf(0 if s == 0 else 1)
    low, high, u = mpf(0), mpf(1), min(s / curve.length(i), mpf(1))
    while high - low > mpf(10) ** -32:
        value = curve.length(i, u) - s
        if abs(value) < mpf(10) ** -34 * curve.length(i):
            break
        low, high = (low, u) if value > 0 else (u, high)
        speed = norm([b + u * (2 * c + u * 3 * d) for _, b, c, d in curve.cubics[i]])
        new = u - value / speed if speed != 0 else (low + high) / 2
        u = new if low < new < high else (low + high) / 2
    return i, u


def expected(curve, s, speed, change):
    """Position, velocity, speed and acceleration where the curve has the length s."""
    i, w = place_at(curve, s)
    x, v, a = [], [], []
    for p, b, c, d in curve.cubics[i]:
        x.append(p + w * (b + w * (c + w * d)))
        v.append(b + w * (2 * c + w * 3 * d))
        a.append(2 * c + 6 * d * w)
    local = norm(v)
    if local == 0:
        return x, [None] * len(x), abs(speed), [None] * len(x), local
    direction = [z / local for z in v]
    along = sum(z * y for z, y in zip(direction, a))
    bend = [(y - z * along) / local**2 for y, z in zip(a, direction)]
    return x, [z * speed for z in direction], abs(speed), [y * speed**2 + z * change for y, z in zip(bend, direction)], local


compared = 0
for number in range(curves):
    channels, style = rng.choice([2, 3]), rng.choice(["plain", "tcb", "ease"])
    keys = random_keys(channels, rng.choice([2, 3, 5]), style)
    rule, ends = rng.choice(["velocity", "uniform", "kb1984"]), rng.choice(["half", "one-sided", "natural"])
    kind = rng.choice(["constant", "ease", "profile"])
    if kind == "profile" and ends == "natural":  # whose ends have tangents also with tension 1
        ends = "half"
    golden = kind != "profile" and rng.random() < 0.5
    decimal = golden and rng.random() < 0.5
    curve = Curve(made(keys, number, (lambda x: mpf(text(x))) if decimal else exact), rule, [ends, ends])
    total = sum(curve.length(i) for i in range(len(curve.cubics)))
    options = ["--tangents", rule, "--ends", f"{ends},{ends}", "--fields", "time,position,s,velocity,speed,acceleration"]
    options += ["--golden"] if golden else []
    options += ["--exact-input"] if decimal else []
    first, last = curve.times[0], curve.times[-1]
    if kind == "profile":
        knots = [(mpf(0), mpf(rng.randrange(9)) / 8)]
        for _ in range(rng.randrange(1, 4)):
            knots.append((knots[-1][0] + rng.randrange(1, 5), mpf(rng.randrange(9)) / 8))
        name = f"{folder.name}/profile.csv"
        with open(name, "w") as file:
            file.write("time,fraction,tension\n" + "".join(f"{float(t)},{float(s)},1\n" for t, s in knots))
        options += ["--pace", "@" + name]
    elif kind == "ease":
        a = mpf(rng.randrange(17)) / 16
        b = mpf(rng.randrange(17)) / 16
        if a + b > 1:
            a, b = 1 - a, 1 - b
        options += ["--pace", f"ease={float(a)},{float(b)}" if (a, b) != (mpf(1) / 4, mpf(1) / 4) else "ease"]
    else:
        a = b = mpf(0)
        options += ["--pace", "constant"]
    rows = rng.choice([3, 5])
    done = subprocess.run([program, "-q", "-n", str(rows), "--no-output-header", *options], input=write(keys, style), text=True,
                          capture_output=True, timeout=60)
    if done.returncode != 0:
        sys.exit(f"{options}: {done.stderr}")
    got = [[float(cell) if cell else None for cell in line.split(",")] for line in done.stdout.splitlines()]
    if len(got) != rows:
        sys.exit(f"{options}: {len(got)} rows, expected {rows}")
    for j, row in enumerate(got):
        if kind == "profile":
            distance, speed, change = profiled(knots, knots[-1][0] * j / (rows - 1))
            time, scale = knots[-1][0] * j / (rows - 1), total
        else:
            time = first + (last - first) * j / (rows - 1)
            if not decimal:  # rows are at their printed times
                time = mpf(row[0])
            distance, speed, change = eased((time - first) / (last - first), a, b)
            speed, change = speed / (last - first), change / (last - first) ** 2
            scale = total
        s = distance * scale
        x, v, fast, acceleration, local = expected(curve, s, speed * scale, change * scale)
        size = max(abs(z) for cubic in curve.cubics for parts in cubic for z in parts)
        smooth = golden or local > size / 1000  # else the place has an error, by which the derivatives are magnified
        wanted = [(time, abs(time)), *((z, size) for z in x), (s, total)]
        wanted += [(z if smooth else None, abs(fast)) for z in v] + [(fast, abs(fast))]
        bend = (abs(fast) ** 2 * size / local**2 + abs(change * scale)) if smooth and local > 0 else 0
        wanted += [(z if smooth else None, bend) for z in acceleration]
        if local < size * mpf(10) ** -25:  # the curve rests
            wanted = [(None if cell is None else want, unit) for cell, (want, unit) in zip(row, wanted)]
        for cell, (want, unit) in zip(row, wanted, strict=True):
            if want is None:
                continue
            compared += 1
            if golden and cell == float(0 if abs(want) < mpf(10) ** -28 * unit else want):
                continue
            if golden or cell is None or abs(cell - want) > 1e-10 * unit + mpf(10) ** -300:
                sys.exit(f"curve {number}, row {j}: {cell}, expected {float(want)}\n{' '.join(options)}\n{write(keys, style)}{done.stdout}")
print(f"{compared} numbers of {curves} curves")
