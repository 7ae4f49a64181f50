"""Pictures of any finite numbers are right.

Curves of extents from 5e-324 to 1.7e308, wide, narrow, and constant, with one key or several, are drawn by -f svg, --plot,
--check, --limits and --fit. A picture is well-formed, has no number that is not finite, and its keys and the numbers of
its axes lie on straight lines over the numbers they stand for, as fractions say; or an error of the data says why there is
none. Keys of every other kind are drawn, too."""
import math
import re
import sys
import xml.etree.ElementTree
from fractions import Fraction as F

from keys import Keys
from law import check, require, run, write

largest = F(sys.float_info.max)
suffixes = {"k": 3, "M": 6, "G": 9}


def nearest(value):
    return float(max(-largest, min(largest, value)))


def size(rng):
    exponent = rng.choice([-324, -320, -310, -308, -300, -200, -160, -100, -20, -3, 0, 3, 20, 100, 160, 200, 300, 307, 308])
    return F(rng.randrange(10, 18), 10) * F(10) ** exponent


def numbers(rng, count):
    """Numbers of one channel, or times before they are sorted."""
    kind = rng.randrange(6)
    base = rng.choice([-1, 1]) * size(rng)
    if kind == 0:
        return [nearest(base)] * count
    if kind == 1:  # next to a number that is larger
        extent = abs(base) / F(10) ** rng.randrange(0, 17)
        return [nearest(base + extent * rng.randrange(0, 101) / 100) for _ in range(count)]
    if kind == 2:
        return [nearest(rng.choice([-1, 1]) * size(rng)) for _ in range(count)]
    if kind == 3:
        return [rng.randrange(-3, 4) * 5e-324 for _ in range(count)]
    extent = size(rng)
    return [nearest(extent * rng.randrange(-100, 101) / 100) for _ in range(count)]


def times(rng, count):
    while True:
        all = sorted(set(numbers(rng, count) if rng.randrange(3) == 0 else range(count)))
        if len(all) == count or count == 1:
            return all[:1] if count == 1 else all


def parsed(text):
    """The number of an axis."""
    power = suffixes.get(text[-1], 0)
    return F(text[:-1] if power else text) * F(10) ** power


def base_of(title, name):
    rest = title[len(name):].strip()
    if not rest:
        return F(0)
    sign, base = rest.split()
    return F(base) * (-1 if sign == "+" else 1)


def require_line(pairs, what):
    """Pixels are on a straight line over their numbers, to a little more than the two decimals of a pixel, and the last
    place of a number, whose decimals the axis shows."""
    (low, at_low), (high, at_high) = min(pairs), max(pairs)
    if low == high:
        require(max(at for _, at in pairs) - min(at for _, at in pairs) <= F(3, 100), f"{what}: one number at several places")
        return
    for value, at in pairs:
        expected = at_low + (value - low) / (high - low) * (at_high - at_low)
        bound = F(6, 100) + 2 * F(math.ulp(nearest(max(abs(low), abs(high))))) / (high - low) * abs(at_high - at_low)
        require(abs(at - expected) <= bound, f"{what}: {nearest(value)} is at {nearest(at)} instead of {nearest(expected)}")


def look(svg, t, x, options):
    root = xml.etree.ElementTree.fromstring(svg)
    without_texts = re.sub(r"(?s)<style>.*?</style>|<title>.*?</title>|<text.*?</text>", "", svg)
    require(not re.search(r"nan|inf", without_texts), "a number that is not finite")
    require(not any(re.search(r"\d{7}", d) for d in re.findall(r' d="([^"]*)"', svg)), "a place far outside of the picture")
    if len(x) != 1 or options[0] not in ("-f", "--limits"):
        return
    every = [(e.tag.split("}")[1], e.attrib, e.text) for e in root.iter()]
    dots = [(F(a["cx"]), F(a["cy"])) for tag, a, _ in every if tag == "circle" and a.get("class") in ("k", "q")]
    dots = dots[: len(t)]  # the others are of the legend
    require(len(dots) >= len(t), "dots are missing")
    headings = [(a, s) for tag, a, s in every if tag == "text" and a.get("class") == "n"]
    up = [F(0)] + [base_of(s, "x") for a, s in headings if a.get("text-anchor") != "middle"]
    right = [F(0)] + [base_of(s, "t") for a, s in headings if a.get("text-anchor") == "middle"]
    frame = next(a for tag, a, _ in every if tag == "rect" and a.get("class") == "f")
    left, bottom = F(frame["x"]), F(frame["y"]) + F(frame["height"])
    ticks = [(a, s) for tag, a, s in every if tag == "text" and a.get("class") == "v"]
    over_t = [(parsed(s) + right[-1], F(a["x"])) for a, s in ticks if F(a["y"]) > bottom + 10 and a.get("text-anchor") == "middle"]
    over_x = [(parsed(s) + up[-1], F(a["y"]) - 4) for a, s in ticks if F(a["y"]) <= bottom + 10]
    require_line([(F(v), at) for v, (at, _) in zip(t, dots)] + over_t, "times")
    require_line([(F(v), at) for v, (_, at) in zip(x[0], dots)] + over_x, "numbers")
    for right_pixel, up_pixel in dots:
        require(left - 1 <= right_pixel <= left + F(frame["width"]) + 1 and
                bottom - F(frame["height"]) - 1 <= up_pixel <= bottom + 1, "a key outside of its frame")


WAYS = [["-f", "svg", "-n", "5"], ["-f", "svg", "--per-segment", "3"], ["--plot"], ["--check", "rows", "-f", "svg"],
        ["--check", "rows", "--plot"], ["--limits", "-f", "svg"], ["--fit", "0.1", "-f", "svg"],
        ["--plot", "--input-fps", "25"], ["--plot", "--time-unit", "ms"]]


def table(t, x):
    lines = [",".join(["t", *"xyz"[: len(x)]]), *(",".join(repr(float(v)) for v in row) for row in zip(t, *x))]
    return "\n".join(lines) + "\n"


def law(rng):
    if rng.random() < 0.2:  # every kind of keys
        keys = Keys(rng)
        way = rng.choice(WAYS[:3])
        return look(run(keys.text(), *way, *keys.options()).stdout, [], [], way)
    count, channels = rng.choice([1, 2, 2, 3, 4, 6]), rng.choice([1, 1, 1, 2, 3])
    t = times(rng, count)
    x = [numbers(rng, len(t)) for _ in range(channels)]
    text = table(t, x)
    write("rows", table(t, [numbers(rng, len(t)) for _ in range(channels)]) if rng.randrange(2) else text)
    options = rng.choice(WAYS[:1] + WAYS)
    if options[0] != "--fit":
        options = options + rng.choice([[], ["--ends", "zero"]])
    options = options + rng.choice([[], ["--axes", "x:y"] * (channels > 1)])
    done = run(text, *options, codes=(0, 1, 2))
    # Doubles may have no room for rows.
    require("of its own" not in done.stderr and (done.returncode != 2 or "two rows near" in done.stderr), done.stderr)
    if done.stdout:
        look(done.stdout, [float(v) for v in t], x, options)


check(law, 40, least=2)
