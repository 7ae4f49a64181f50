"""Pieces of --emit are the cubics of the curve, rounded once with --golden, and within the bounds of tcbsample-numerics(7)
without; the positions and rotations that they give are those of samples."""
import math
from fractions import Fraction

from keys import FINE_TIMES, TIMES, Keys, double
from law import blocks, check, near, same

FORMS = {"hermite": ["_p0", "_v0", "_p1", "_v1"], "bezier": ["_b0", "_b1", "_b2", "_b3"], "poly": ["^0", "^1", "^2", "^3"]}


def value(cubic, x):
    p, a, b, c = cubic
    return p + x * (a + x * (b + x * c))


def numbers_of(form, cubic, h):
    """The numbers of a piece, from its coefficients by powers of time."""
    p, a, b, c = cubic
    last, slope = value(cubic, h), a + h * (2 * b + 3 * c * h)
    return {"hermite": [p, a, last, slope], "bezier": [p, p + a * h / 3, last - slope * h / 3, last], "poly": [p, a, b, c]}[form]


def cubic_of(form, numbers, h):
    """The coefficients, from the numbers of a piece."""
    p, a, q, b = numbers
    if form == "poly":
        return numbers
    if form == "bezier":
        p, a, q, b = p, 3 * (a - p) / h, b, 3 * (b - q) / h
    chord = (q - p) / h
    return p, a, (3 * chord - 2 * a - b) / h, (a + b - 2 * chord) / h ** 2


def bounds(form, size, h):
    """The largest term behind each number, of which its error may be a few units in the last place."""
    slope = max(size / h, 3 * size / h)
    return {"hermite": [size, slope, size, slope], "bezier": [size, slope * h, slope * h, size],
            "poly": [size, slope, 3 * size / h ** 2, size / h ** 3]}[form]


def ulps(count, of):
    return count * Fraction(math.ulp(float(of)))


def law(rng):
    exact = rng.random() < 0.3
    keys = Keys(rng, times=FINE_TIMES[:4] if exact else TIMES, rotation_curves=["components"])
    number, form = Fraction if exact else double, rng.choice(list(FORMS))
    text, options, parts = keys.text(), [*keys.options(), *["--no-ease"] * keys.ease], keys.parts(number)
    emit, wanted = [*options, "--emit", form], [list(zip(part.knots, part.knots[1:])) for part in parts]
    if len(parts) == 1 and rng.random() < 0.5:
        low, high = keys.places(rng, 2, exact)[:2]
        emit += ["--from", low, "--to", high]
        low, high = number(low), number(high)
        wanted = [[(max(a, low), min(b, high)) for a, b in wanted[0] if max(a, low) < min(b, high)]]
    golden = blocks(text, *emit, "--golden", *["--exact-input"] * exact)
    plain = blocks(text, *emit)
    for part, pieces, rows, others in zip(parts, wanted, golden, plain, strict=True):
        whole = set(zip(part.knots, part.knots[1:])) if not keys.sparse else set()
        for (a, b), row, other in zip(pieces, rows, others, strict=True):
            same([float(row["start"]), float(row["duration"])], [float(a), float(b - a)], "start and duration")
            for c, name in enumerate(keys.channels if not keys.equal else []):
                want = numbers_of(form, part.over_time(c, a), b - a)
                size = part.size(c, a)
                for k, (suffix, exactly, term) in enumerate(zip(FORMS[form], want, bounds(form, size, b - a))):
                    same(float(row[name + suffix]), float(exactly), f"{name}{suffix} at {row['start']}")
                    if exact:
                        continue
                    by_itself = (a, b) in whole and (k % 3 == 0 or form != "bezier")
                    bound = ulps(2 if (a, b) in whole else 4, abs(exactly) if by_itself else max(term, abs(exactly)))
                    near(float(other[name + suffix]), exactly, max(bound, term / 2 ** 90), f"{name}{suffix} at {row['start']}")
    if exact:
        return
    # Evaluated exactly, the printed numbers give the positions of samples.
    inside = sorted({(float(row["start"]) + float(row["duration"]) * u) for row in plain[0] for u in (0.25, 0.625)})
    inside = [t for t in inside if float(parts[0].knots[0]) < t < float(parts[0].knots[-1])]
    samples = blocks(text, *options, "--at", ",".join(map(repr, inside))) if not keys.gap else []
    for rows, pieces in zip(samples, plain):
        for sample in rows:
            t = Fraction(float(sample["t"]))
            piece = [row for row in pieces if Fraction(float(row["start"])) <= t][-1]
            start, h = Fraction(float(piece["start"])), Fraction(float(piece["duration"]))
            cubic = lambda name: cubic_of(form, [Fraction(float(piece[name + suffix])) for suffix in FORMS[form]], h)
            for name in keys.channels:
                size = max(map(abs, numbers_of("hermite", cubic(name), h)[::2] + [x * h for x in numbers_of("hermite", cubic(name), h)[1::2]]))
                near(float(sample[name]), value(cubic(name), t - start), ulps(8 if not keys.sparse else 64, size), f"{name} at {sample['t']}")
            if keys.rotations and form == "hermite":
                q = [float(value(cubic("q" + c), t - start)) for c in "wxyz"]
                for c, x in zip("wxyz", q):
                    near(float(sample["q" + c]), x / math.hypot(*q), 4e-15 / min(math.hypot(*q), 1), f"q{c} at {sample['t']}")
        for before, after in zip(pieces, pieces[1:]):
            for name in ["qw", "qx", "qy", "qz"] * (keys.rotations and form == "hermite"):
                same(after[name + "_p0"], before[name + "_p1"], f"{name} where the piece at {after['start']} begins")


def lengths(rng):
    """`s` is that of a sample at the start of the piece, and `length` the difference to the end."""
    keys = Keys(rng, "groups gaps sparse", rotation_curves=["components"])
    text, options, golden = keys.text(), [*keys.options(), *["--no-ease"] * keys.ease], ["--golden"] * (rng.random() < 0.3)
    (rows,) = blocks(text, *options, *golden, "--emit", "hermite", "--fields", "length,s")
    ends = [row["start"] for row in rows] + [repr(float(keys.parts()[0].knots[-1]))]
    (at_ends,) = blocks(text, *options, *golden, "--at", ",".join(ends), "--fields", "s")
    s = [float(row["s"]) for row in at_ends]
    for row, before, after in zip(rows, s[:-1], s[1:], strict=True):
        near(float(row["s"]), Fraction(before), ulps(0 if golden else 1, before), "s")
        near(float(row["length"]), Fraction(after) - Fraction(before), ulps(1 if golden else 8, after), "length")


check(lambda rng: law(rng) if rng.random() < 0.85 else lengths(rng), 20, least=10)
