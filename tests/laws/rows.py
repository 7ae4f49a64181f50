"""Rows of keys of every kind are those of the exact curve: with --golden each number is rounded once, without it numbers
are near, and JSON has the rows of CSV. Also rows by length, equal speeds, and times made from distances."""
import math
from fractions import Fraction

from curves import MeasuredCurve, shape, tiny
from keys import FINE_TIMES, TIMES, Keys, double
from law import blocks, check, near, same
from mpmath import mp, mpf

mp.dps = 45
ORDERS = {"position": "", "velocity": "_v", "acceleration": "_a", "jerk": "_j"}
SHAPE = ["speed", "tangent", "curvature", "torsion"]


def named(keys, values):
    """Numbers of fields by the names of their columns."""
    for field, value in values.items():
        if field in ORDERS or field == "tangent":
            yield from zip([c + ORDERS.get(field, "_t") for c in keys.channels], value)
        else:
            yield field, value


def at_times(rng):
    exact = rng.random() < 0.4
    keys = Keys(rng, "equal", rng.choice([TIMES, FINE_TIMES[:4]]) if exact else TIMES)
    left, number = rng.random() < 0.3, Fraction if exact else double
    places = keys.places(rng, 10, exact)
    options = [*keys.options(), "--at", ",".join(places), *["--side", "left"] * left]
    options += ["--fields", ",".join(["time", *ORDERS, *SHAPE])]
    golden = blocks(keys.text(rng.choice(["csv", "tsv", "json", "jsonl"])), *options, "-f", "csv", "--golden",
                    *["--exact-input"] * exact)
    plain = golden if exact else blocks(keys.text(), *options)
    for part, rows, others in zip(keys.parts(number), golden, plain, strict=True):
        inside = [text for text in places if part.knots[0] <= number(text) <= part.knots[-1]]
        for text, row, other in zip(inside, rows, others, strict=True):
            t = number(text)
            same(float(row["t"]), float(t), "time")
            state = [part.at(c, t, left) for c in range(len(keys.channels))]
            values = dict(zip(ORDERS, zip(*state)))
            values.update(shape(*list(values.values())[1:]))
            if keys.rotations and keys.size > 1e20:  # then a torsion of 0 is only known to 134 digits
                values.pop("torsion")
            for name, want in named(keys, values):
                same(row[name] and float(row[name]), "" if want is None else float(want), f"{name} at {text}")
            for c, name in enumerate(keys.channels):
                size = Fraction(math.ulp(float(part.size(c, t, left))))
                near(float(other[name]), state[c][0], 3 * size, f"{name} at {text} without --golden")


def measured(rng):
    keys = Keys(rng, "own sparse groups gaps velocities rotations sizes hold", ["whole", "short", "double"], count=rng.choice([2, 3, 4]))
    of_double = lambda text: mpf(float(Fraction(text)))
    exponent, times = None, None
    if not keys.closed and rng.random() < 0.5:
        name, exponent = rng.choice([("chordal", 1), ("centripetal", mpf(1) / 2), ("uniform", 0), ("0.75", mpf(3) / 4)])
    (part,) = keys.parts(of_double, MeasuredCurve, equal=keys.equal, exponent=exponent)
    curve, options, text = part.whole, keys.options(), keys.text()
    if exponent is not None:
        text = "".join(line.split(",", 1)[1] + "\n" for line in text.splitlines())
        options += ["--parameter", name]
    fields = ["time", "position", "velocity", "acceleration", "speed", "s", "u", "segment"]
    golden = ["--golden", "--fields", ",".join(fields)]

    def compare(row, i, passed, t, **others):
        want = dict(zip(fields, grouped(curve.row(fields, i, passed, t, **others), fields, len(keys.channels))))
        want["t"] = want.pop("time")
        for name, value in named(keys, want):
            same(row[name] and float(row[name]), "" if value is None else 0.0 if abs(value) < tiny() else float(value), f"{name} at {row['t']}")

    (rows,) = blocks(text, *options, *golden, "--count", "5")
    for j, row in enumerate(rows):
        i = int(row["segment"])
        t = curve.times[-1] if exponent is not None and j + 1 == len(rows) else mpf(float(row["t"]))
        compare(row, i, curve.part_of(i, t), t)
    s = repr(round(rng.uniform(0.1, 0.9) * float(curve.length(0)), 3))
    (rows,) = blocks(text, *options, *golden, "--arc-at", f"{s},{s}/3")
    for row, length in zip(rows, [mpf(s), mpf(s) / 3], strict=True):
        i, w = curve.place_at(length)
        passed = curve.unwarp(i, w)
        compare(row, i, passed, curve.times[i] + passed * (curve.times[i + 1] - curve.times[i]), w=w, s=length)


def grouped(numbers, fields, channels):
    numbers = iter(numbers)
    for field in fields:
        yield [next(numbers) for _ in range(channels)] if field in ORDERS else next(numbers)


check(lambda rng: at_times(rng) if rng.random() < 0.8 else measured(rng), 10, least=20)
