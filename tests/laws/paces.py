"""Rows at a pace are where the curve has the length that the pace says, by the quadrature of curves.py, with the velocities
of the pace: constant, ease with random ramps, and profiles of keys with tension 1, which are s0 + (s1 - s0) (3 w^2 - 2 w^3).
Golden rows are rounded once."""
from curves import MeasuredCurve, norm, tiny
from keys import Keys
from law import blocks, check, require, same, write
from mpmath import mp, mpf

mp.dps = 40


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


def profiled(knots, t):
    """The distance on a profile of keys with tension 1, and its derivatives."""
    (t0, s0), (t1, s1) = next((a, b) for a, b in zip(knots, knots[1:]) if t < b[0] or b == knots[-1])
    h, w, d = t1 - t0, (t - t0) / (t1 - t0), s1 - s0
    return s0 + d * (3 * w**2 - 2 * w**3), d * (6 * w - 6 * w**2) / h, d * (6 - 12 * w) / h**2


def expected(curve, s, speed, change):
    """Position, velocity, speed and acceleration where the curve has the length s, and the speed by the local parameter."""
    i, w = curve.place_at(s)
    x, v, a = zip(*[(p + w * (b + w * (c + w * d)), b + w * (2 * c + w * 3 * d), 2 * c + 6 * d * w)
                    for p, b, c, d in curve.cubics[i]])
    local = norm(v)
    if local < tiny() * max(curve.size(i, c) for c in range(len(x))):  # it rests
        return x, [None] * len(x), abs(speed), [None] * len(x), local
    direction = [z / local for z in v]
    along = sum(z * y for z, y in zip(direction, a))
    bend = [(y - z * along) / local**2 for y, z in zip(a, direction)]
    return x, [z * speed for z in direction], abs(speed), [y * speed**2 + z * change for y, z in zip(bend, direction)], local


def law(rng):
    kind = rng.choice(["constant", "ease", "profile"])
    natural = ["natural"] * (kind != "profile")  # whose ends have tangents also with tension 1
    keys = Keys(rng, "own sparse groups gaps velocities linear sizes hold" + " closed equal" * (kind == "profile"), ["whole", "short", "double"], reach=[1],
                count=rng.choice([2, 3, 4]), ends=["half", "one-sided", *natural])
    golden = kind != "profile" and rng.random() < 0.5
    (part,) = keys.parts(lambda text: mpf(float(text)), MeasuredCurve, equal=keys.equal)
    curve = part.whole
    total = sum(curve.length(i) for i in range(len(curve.cubics)))
    first, last, a, b, rows = curve.times[0], curve.times[-1], mpf(0), mpf(0), rng.choice([3, 4])
    pace = kind
    if kind == "profile":
        knots = [(mpf(0), mpf(rng.randrange(9)) / 8)]
        for _ in range(rng.randrange(1, 4)):
            knots.append((knots[-1][0] + rng.randrange(1, 5), mpf(rng.randrange(9)) / 8))
        write("profile", "time,fraction,tension\n" + "".join(f"{float(t)},{float(s)},1\n" for t, s in knots))
        pace, first, last = "@profile", mpf(0), knots[-1][0]
    elif kind == "ease":
        a, b = mpf(rng.randrange(17)) / 16, mpf(rng.randrange(17)) / 16
        a, b = (1 - a, 1 - b) if a + b > 1 else (a, b)
        pace = f"ease={float(a)},{float(b)}" if (a, b) != (mpf(1) / 4, mpf(1) / 4) else "ease"
    options = [*keys.options(), "--pace", pace, "--count", str(rows), "--fields", "time,position,s,velocity,speed,acceleration"]
    (found,) = blocks(keys.text(), *options, *["--golden"] * golden)
    require(len(found) == rows, f"{len(found)} rows, expected {rows}")
    for j, row in enumerate(found):
        if kind == "profile":
            time = last * j / (rows - 1)
            distance, speed, change = profiled(knots, time)
        else:
            time = mpf(float(row["t"]))  # rows are at their printed times
            distance, speed, change = eased((time - first) / (last - first), a, b)
            speed, change = speed / (last - first), change / (last - first) ** 2
        s = distance * total
        x, v, fast, acceleration, local = expected(curve, s, speed * total, change * total)
        size = max(curve.size(i, c) for i in range(len(curve.cubics)) for c in range(len(x)))
        smooth = golden or local > size / 1000  # else the place has an error, by which the derivatives are magnified
        bend = abs(fast) ** 2 * size / local**2 + abs(change * total) if local > 0 else 0
        wanted = {"t": (time, abs(time)), "s": (s, total), "speed": (fast, abs(fast))}
        for c, name in enumerate(keys.channels):
            wanted.update({name: (x[c], size), name + "_v": (v[c], abs(fast)), name + "_a": (acceleration[c], bend)})
        for name, (want, unit) in wanted.items():
            if want is None or name[-2:] in ("_v", "_a") and not smooth:
                continue
            want = mpf(0) if abs(want) < mpf(10) ** -28 * unit else want
            if golden:
                same(float(row[name]), float(want), f"{name} of row {j}")
            else:
                require(abs(float(row[name]) - want) <= 1e-10 * unit, f"{name} of row {j}: {row[name]}, expected {float(want)}")


check(law, 6, least=10)
