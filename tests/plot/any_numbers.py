"""Pictures of any finite numbers: any_numbers.py PROGRAM [PICTURES] [SEED].

Curves of random extents, from 5e-324 to 1.7e308, wide, narrow, and constant, with one key or several, are drawn by
-f svg, --plot, --check, --limits and --fit. A picture is well-formed, has no number that is not finite, and its keys
and the numbers of its axes lie on straight lines over the numbers they stand for, as fractions say; or an error of
the data says why there is none. Exit 1: something differs, and its command is printed.
"""
import math
import random
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
from fractions import Fraction as F

program = sys.argv[1]
pictures = int(sys.argv[2]) if len(sys.argv) > 2 else 60
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
folder = tempfile.TemporaryDirectory()
largest = F(sys.float_info.max)
drawn = 0
suffixes = {"k": 3, "M": 6, "G": 9}


def nearest(value):
    return float(max(-largest, min(largest, value)))


def size():
    exponent = rng.choice([-324, -320, -310, -308, -300, -200, -160, -100, -20, -3, 0, 3, 20, 100, 160, 200, 300, 307, 308])
    return F(rng.randrange(10, 18), 10) * F(10) ** exponent


def numbers(count):
    """Numbers of one channel, or times before they are sorted."""
    kind = rng.randrange(6)
    base = rng.choice([-1, 1]) * size()
    if kind == 0:
        return [nearest(base)] * count
    if kind == 1:  # next to a number that is larger
        extent = abs(base) / F(10) ** rng.randrange(0, 17)
        return [nearest(base + extent * rng.randrange(0, 101) / 100) for _ in range(count)]
    if kind == 2:
        return [nearest(rng.choice([-1, 1]) * size()) for _ in range(count)]
    if kind == 3:
        return [rng.randrange(-3, 4) * 5e-324 for _ in range(count)]
    extent = size()
    return [nearest(extent * rng.randrange(-100, 101) / 100) for _ in range(count)]


def times(count):
    while True:
        all = sorted(set(numbers(count) if rng.randrange(3) == 0 else range(count)))
        if len(all) == count or count == 1:
            return all[:1] if count == 1 else all


def run(options, text):
    command = [program, *options]
    try:
        done = subprocess.run(command, input=text, capture_output=True, text=True, timeout=60)
    except subprocess.TimeoutExpired:
        fail("no end after a minute", options, text)
    is_narrow = done.returncode == 2 and "two rows near" in done.stderr  # doubles have no room for rows
    if done.returncode not in (0, 1) and not is_narrow or "of its own" in done.stderr:
        fail(f"exit code {done.returncode}: {done.stderr}", options, text)
    return done


def fail(what, options, text):
    sys.exit(f"picture {number}: {what}\n{' '.join(options)}\n{text}")


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


def require_line(pairs, what, options, text):
    """Pixels are on a straight line over their numbers, to a little more than the two decimals of a pixel, and the last
    place of a number, whose decimals the axis shows."""
    (low, at_low), (high, at_high) = min(pairs), max(pairs)
    if low == high:
        if max(at for _, at in pairs) - min(at for _, at in pairs) > F(3, 100):
            fail(f"{what}: one number at several places", options, text)
        return
    for value, at in pairs:
        expected = at_low + (value - low) / (high - low) * (at_high - at_low)
        if abs(at - expected) > F(6, 100) + 2 * F(math.ulp(nearest(max(abs(low), abs(high))))) / (high - low) * abs(at_high - at_low):
            fail(f"{what}: {float(value)} is at {float(at)} instead of {float(expected)}", options, text)


def look(svg, t, x, options, text):
    root = xml.etree.ElementTree.fromstring(svg)
    if re.search(r"nan|inf", re.sub(r"(?s)<style>.*?</style>|<title>.*?</title>|<text.*?</text>", "", svg)):
        fail("a number that is not finite", options, text)
    for d in re.findall(r' d="([^"]*)"', svg):
        if re.search(r"\d{7}", d):
            fail("a place far outside of the picture", options, text)
    if len(x) != 1 or options[0] not in ("-f", "--limits"):
        return
    every = [(e.tag.split("}")[1], e.attrib, e.text) for e in root.iter()]
    dots = [(F(a["cx"]), F(a["cy"])) for tag, a, _ in every if tag == "circle" and a.get("class") in ("k", "q")]
    dots = dots[: len(t)]  # the others are of the legend
    if len(dots) < len(t):
        fail("dots are missing", options, text)
    headings = [(a, s) for tag, a, s in every if tag == "text" and a.get("class") == "n"]
    up = [F(0)] + [base_of(s, "x") for a, s in headings if a.get("text-anchor") != "middle"]
    right = [F(0)] + [base_of(s, "t") for a, s in headings if a.get("text-anchor") == "middle"]
    frame = next(a for tag, a, _ in every if tag == "rect" and a.get("class") == "f")
    left, bottom = F(frame["x"]), F(frame["y"]) + F(frame["height"])
    ticks = [(a, s) for tag, a, s in every if tag == "text" and a.get("class") == "v"]
    over_t = [(parsed(s) + right[-1], F(a["x"])) for a, s in ticks if F(a["y"]) > bottom + 10 and a.get("text-anchor") == "middle"]
    over_x = [(parsed(s) + up[-1], F(a["y"]) - 4) for a, s in ticks if F(a["y"]) <= bottom + 10]
    require_line([(F(v), at) for v, (at, _) in zip(t, dots)] + over_t, "times", options, text)
    require_line([(F(v), at) for v, (_, at) in zip(x[0], dots)] + over_x, "numbers", options, text)
    for right_pixel, up_pixel in dots:
        if not (left - 1 <= right_pixel <= left + F(frame["width"]) + 1 and bottom - F(frame["height"]) - 1 <= up_pixel <= bottom + 1):
            fail("a key outside of its frame", options, text)


keys, rows = folder.name + "/keys.csv", folder.name + "/rows.csv"
ways = [["-f", "svg", "-n", "5"], ["-f", "svg", "--per-segment", "3"], ["--plot"], ["--check", rows, "-f", "svg"],
        ["--check", rows, "--plot"], ["--limits", "-f", "svg"], ["--fit", "0.1", "-f", "svg"],
        ["--plot", "--input-fps", "25"], ["--plot", "--time-unit", "ms"]]


def table(t, x):
    lines = [",".join(["t", *"xyz"[: len(x)]]), *(",".join(repr(float(v)) for v in row) for row in zip(t, *x))]
    return "\n".join(lines) + "\n"


for number in range(pictures):
    count, channels = rng.choice([1, 2, 2, 3, 4, 6]), rng.choice([1, 1, 1, 2, 3])
    t = times(count)
    x = [numbers(len(t)) for _ in range(channels)]
    text = table(t, x)
    with open(keys, "w") as file:
        file.write(text)
    with open(rows, "w") as file:
        file.write(table(t, [numbers(len(t)) for _ in range(channels)]) if rng.randrange(2) else text)
    options = rng.choice(ways[:1] + ways)
    if options[0] != "--fit":
        options = options + rng.choice([[], ["--ends", "zero"]])
    options = options + rng.choice([[], ["--axes", "x:y"] * (channels > 1)])
    done = run([*options, keys], text)
    if not done.stdout:
        continue
    drawn += 1
    look(done.stdout, [float(v) for v in t], x, [*options, keys], text)
print(f"{drawn} pictures, {pictures - drawn} refused")
if drawn < pictures / 2:
    sys.exit("too few pictures")
