"""Rows of --golden --exact-input are at exact times, however they are asked for: decimals, ratios, lists, files, ranges,
steps, rates and counts. Times and positions have 40 digits, rounded once."""
import decimal
from fractions import Fraction

from keys import ENDS, Keys
from law import blocks, check, require, same, write

decimal.getcontext().prec = 40


def in_digits(value):
    return decimal.Decimal(value.numerator) / decimal.Decimal(value.denominator)


def grid(rng, keys, part):
    """Options, and the times that they mean."""
    first, last = part.knots[0], part.knots[-1]
    mode, (low, *_, high) = rng.choice(["at", "file", "range", "step", "rate", "count", "per-segment"]), keys.places(rng, 3, True)
    if mode in ("at", "file"):
        wanted = rng.sample([low, high, *keys.places(rng, 6, True)], 5)
        write("times", "\n".join(wanted) + "\n")
        return ["--at", "@times" if mode == "file" else ",".join(wanted)], list(map(Fraction, wanted))
    if mode == "per-segment":
        n = rng.randint(1, 4)
        return ["--per-segment", str(n)], [a + (b - a) * j / n for a, b in zip(part.knots, part.knots[1:]) for j in range(n)] + [last]
    step = (Fraction(high) - Fraction(low)) / rng.choice([3, 7, Fraction(100, 11), Fraction(9000001, 1000000)])
    if mode == "range":
        return ["--at", f"{low}:{high}:{step}"], [Fraction(low) + step * j for j in range(int((Fraction(high) - Fraction(low)) / step) + 1)]
    bounds = rng.choice([[], ["--from", low, "--to", high]])
    begin, end = (Fraction(low), Fraction(high)) if bounds else (first, last)
    if not bounds and not keys.closed and rng.random() < 0.4:  # where the curve rests
        begin, end = first - step / 30, last + step / 7
        bounds = ["--from", str(begin), "--to", str(end), "--extrapolate", "hold"]
    if mode == "count":
        rows = rng.randint(2, 9)
        n = rows if keys.closed and not bounds else rows - 1
        options, wanted = ["--count", str(rows)], [begin + (end - begin) * j / n for j in range(rows)]
    else:
        options = ["--step", str(step)] if mode == "step" else ["--rate", str(1 / step)]
        wanted = [begin + step * j for j in range(int((end - begin) / step) + 1)]
        if rng.random() < 0.3:
            options += ["--end", "keep"]
            wanted += [end] * (wanted[-1] != end)
    if rng.random() < 0.3:  # rows that are nearly at keys are left out
        options += ["--keys"]
        close = (wanted[1] - wanted[0]) / 10 ** 9 if len(wanted) > 1 else 0
        at_keys = [t for t in part.knots if begin <= t <= end]
        wanted = sorted({*at_keys, *(t for t in wanted if all(abs(t - key) > close for key in at_keys))})
    return options + bounds, wanted


def law(rng):
    keys = Keys(rng, "equal gaps sizes rotations", ["long", "sixty", "short", "sixty"], ends=ENDS[:-1], repeats=rng.choice([True, False]))
    parts = keys.parts(Fraction)
    options, wanted = grid(rng, keys, parts[0])
    for part, rows in zip(parts, blocks(keys.text(), *keys.options(), "--golden", "--exact-input", "--digits", "40", *options), strict=True):
        require(len(rows) == len(wanted), f"{len(rows)} rows, expected {len(wanted)}")
        for row, t in zip(rows, wanted):
            same(decimal.Decimal(row["t"]), in_digits(t), "time")
            for c, name in enumerate(keys.channels):
                same(decimal.Decimal(row[name]), in_digits(Fraction(part.at(c, min(max(t, part.knots[0]), part.knots[-1]))[0])), name)


check(law, 40, least=4)
