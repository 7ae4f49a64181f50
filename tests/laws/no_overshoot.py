"""Curves of --no-overshoot stay between their keys.

The tangents are limited here by the rule of Fritsch and Carlson in fractions: no exact piece leaves the range of its two
keys, and --golden prints these pieces, rounded once. No row of --golden leaves it either, also by length, with ease and
with equal speeds. Pieces of doubles are limited to 3 (1 - 2^-50) of the chord, and leave the range by rounding errors at
most. A tangent that needs no limit has the bits that it has without the option."""
import math
from fractions import Fraction

from keys import Keys
from law import blocks, check, near, require, same


def factor(sides, room):
    """That of a key, from (tangent, chord) of its sides."""
    least = Fraction(1)
    for tangent, chord in sides:
        if tangent != 0 and tangent * chord <= 0:
            return Fraction(0)
        if abs(tangent) > 3 * abs(chord):
            least = min(least, 3 * chord / tangent * room)
    return least


def limited(cubics, closed, room):
    """The cubics of one channel with limited tangents, as (p, out, q, in) of each segment."""
    count, pieces = len(cubics), [[p, b, p + b + c + d, b + 2 * c + 3 * d] for p, b, c, d in cubics]
    for key in range(count + (not closed)):
        before = [pieces[key - 1]] if key > 0 or closed else []
        after = [pieces[key % count]] if key < count or closed else []
        scale = factor([(x[3], x[2] - x[0]) for x in before] + [(x[1], x[2] - x[0]) for x in after], room)
        for piece, place in [(x, 3) for x in before] + [(x, 1) for x in after]:
            piece[place] *= scale
    return pieces


def leaves(p, out, q, into):
    """How far the cubic leaves the range of its ends: at most a bound on it, exactly 0 if it does not."""
    c, d = 3 * (q - p) - 2 * out - into, -2 * (q - p) + out + into
    places, square = [], c * c - 3 * d * out  # where it is stationary: out + 2 c u + 3 d u^2 = 0
    if d == 0:
        places = [-out / (2 * c)] if c != 0 else []
    elif square > 0:
        shift = 2 * (200 + abs(square.denominator.bit_length() - square.numerator.bit_length()))
        root = Fraction(math.isqrt(int(square * 2 ** shift))) / 2 ** (shift // 2)
        places = [(-c + root) / (3 * d), (-c - root) / (3 * d)]
    values = [p + u * (out + u * (c + u * d)) for u in places if 0 < u < 1]
    return max([Fraction(0), *(x - max(p, q) for x in values), *(min(p, q) - x for x in values)])


def law(rng):
    keys = Keys(rng, "linear sparse own rotations")
    text, options = keys.text(), [*keys.options(), "--no-overshoot"]
    ends = lambda part, name, i: [float(part.rows[k % len(part.rows)][0][keys.channels.index(name)]) for k in (i, i + 1)]
    for place in ["--per-segment=3", "--arc-count=7"][:1 if keys.gap else 2]:
        for part, rows in zip(keys.parts(), blocks(text, *options, place, "--golden", "--fields", "position,segment"), strict=True):
            first = int(rows[0]["segment"])
            for row in rows:
                for name in keys.channels:
                    p, q = ends(part, name, int(row["segment"]) - first)
                    require(min(p, q) <= float(row[name]) <= max(p, q), f"golden {place} {row} leaves the range")
    options += ["--no-ease"] * keys.ease + ["--emit", "hermite"]
    printed, golden = blocks(text, *options), blocks(text, *options, "--golden")
    free = blocks(text, *[option for option in options if option != "--no-overshoot"])
    for part, *of_part in zip(keys.parts(), printed, golden, free, strict=True):
        for c, name in enumerate(keys.channels):
            cubics = [segment[c] for segment in part.whole.cubics]
            exact, near_exact = limited(cubics, keys.closed, 1), limited(cubics, keys.closed, 1 - Fraction(1, 2 ** 50))
            for i, (row, gold, unlimited) in enumerate(zip(*of_part, strict=True)):
                columns = [f"{name}_{suffix}" for suffix in ("p0", "v0", "p1", "v1")]
                h, found = Fraction(float(row["duration"])), [Fraction(float(row[column])) for column in columns]
                most = leaves(found[0], found[1] * h, found[2], found[3] * h)
                require(most <= Fraction(1, 2 ** 49) * abs(found[2] - found[0]), f"{row} leaves the range by {float(most)}")
                if keys.equal:
                    continue
                h = part.knots[i + 1] - part.knots[i]
                require(leaves(*exact[i]) <= 0, f"the exact piece {i} leaves the range")
                over_time = lambda piece: [piece[0], piece[1] / h, piece[2], piece[3] / h]
                same([float(gold[column]) for column in columns], list(map(float, over_time(exact[i]))), f"piece {i} of --golden")
                for column, want in zip(columns, over_time(near_exact[i])):
                    near(float(row[column]), want, 4 * Fraction(math.ulp(float(want))), f"{column} of piece {i}")
                _, b, c2, d = cubics[i]
                for column, now, was in zip(columns[1::2], exact[i][1::2], (b, b + 2 * c2 + 3 * d)):
                    require(now != was or row[column] == unlimited[column], f"{column} of piece {i} needs no limit: {row[column]}, "
                            f"but {unlimited[column]} without it")


check(law, 25, least=5)
