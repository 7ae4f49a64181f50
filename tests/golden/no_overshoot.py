"""Curves of --no-overshoot against exact fractions: no_overshoot.py PROGRAM [CURVES] [SEED].

Random keys, rules, ends, closed curves, given velocities and ease, |T|, |C|, |B| to 8, sizes from 1e-100 to 1e100. The
tangents are limited here by the rule of Fritsch and Carlson in fractions: no exact piece leaves the range of its two
keys, and --golden prints these pieces, rounded once. No row of --golden leaves it either, also by length and with
equal speeds. Pieces of doubles are limited to 3 (1 - 2^-50) of the chord and leave the range by rounding errors at
most. A tangent that needs no limit has the bits that it has without the option.
Exit 1: a number differs, and its command is printed.
"""
import math
import random
import subprocess
import sys
from fractions import Fraction

sys.dont_write_bytecode = True
from cubics import Cubics

program = sys.argv[1]
curves = int(sys.argv[2]) if len(sys.argv) > 2 else 60
seed = int(sys.argv[3]) if len(sys.argv) > 3 else 20260101
rng = random.Random(seed)
rules = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]
end_rules = ["half", "one-sided", "mirror", "chord", "zero", "natural", "natural-tension", "cry", "lightwave", "velocity"]
room_of_doubles = 1 - Fraction(1, 2 ** 50)
compared = failures = 0


def require(condition, what):
    global compared, failures
    compared += 1
    if not condition:
        failures += 1
        if failures <= 10:
            print(what, file=sys.stderr)


def run(text, options):
    done = subprocess.run([program, "-q", *options], input=text, text=True, capture_output=True)
    if done.returncode != 0:
        sys.exit(f"{options}: {done.stderr}\n{text}")
    return [[float(cell) for cell in line.split(",")] for line in done.stdout.splitlines()[1:]]


def factor(sides, room):
    """That of a key, from (tangent, chord) of its sides."""
    least = Fraction(1)
    for tangent, chord in sides:
        if tangent == 0:
            continue
        if tangent * chord <= 0:
            return Fraction(0)
        if abs(tangent) > 3 * abs(chord):
            least = min(least, 3 * chord / tangent * room)
    return least


def limited(curve, channels, closed, room=1):
    """The cubics with limited tangents, as (p, out, q, in) of each segment and channel."""
    count = len(curve.cubics)
    pieces = [[[p, b, p + b + c + d, b + 2 * c + 3 * d] for p, b, c, d in segment] for segment in curve.cubics]
    for channel in range(channels):
        for key in range(count + (0 if closed else 1)):
            before = pieces[key - 1][channel] if key > 0 or closed else None
            after = pieces[key % count][channel] if key < count or closed else None
            sides = [(x[3], x[2] - x[0]) for x in [before] if x] + [(x[1], x[2] - x[0]) for x in [after] if x]
            scale = factor(sides, room)
            if before:
                before[3] = before[3] * scale
            if after:
                after[1] = after[1] * scale
    return pieces


def leaves(p, out, q, into):
    """How far the cubic leaves the range of its ends: at most a bound on it, exactly 0 if it does not."""
    c, d = 3 * (q - p) - 2 * out - into, -2 * (q - p) + out + into
    low, high = min(p, q), max(p, q)
    value = lambda u: p + u * (out + u * (c + u * d))
    # Stationary places: out + 2 c u + 3 d u^2 = 0.
    places = []
    if d == 0:
        places = [-out / (2 * c)] if c != 0 else []
    else:
        square = c * c - 3 * d * out
        if square > 0:
            scale = 10 ** 60
            root = Fraction(math.isqrt(int(square * scale * scale / (c * c + abs(3 * d * out)))), scale)
            unit = c * c + abs(3 * d * out)
            root = root * Fraction(math.isqrt(int(unit * scale * scale)), scale) if unit < scale else root * math.isqrt(int(unit))
            places = [(-c + root) / (3 * d), (-c - root) / (3 * d)]
    most = Fraction(0)
    for u in places:
        if 0 < u < 1:
            most = max(most, value(u) - high, low - value(u))
    return most


for number in range(curves):
    count = rng.choice([2, 3, 4, 6])
    channels = rng.choice([1, 2])
    closed = count > 2 and rng.random() < 0.3
    size = 10.0 ** rng.choice([0, 0, 0, -100, 100, 8])
    times = [0]
    for _ in range(count):
        times.append(times[-1] + rng.choice([1, 2, 0.5, 3.25]))
    positions = [[repr(round(rng.uniform(-9, 9), 3) * size) for _ in range(channels)] for _ in range(count)]
    for i in range(1, count):
        if rng.random() < 0.2:
            positions[i] = positions[i - 1]
    closed = closed and positions[-1] != positions[0]  # such a key would be the first one
    span = rng.choice([0.5, 1, 8])
    tcbs = [[repr(round(rng.uniform(-span, span), 2)) if rng.random() < 0.7 else "0" for _ in range(3)]
            for _ in range(count)]
    given = rng.random() < 0.2
    ease = not given and rng.random() < 0.2
    equal = not given and rng.random() < 0.2
    names = ["x", "y"][:channels]
    velocities = [[repr(round(rng.uniform(-9, 9), 2) * size) for _ in names] for _ in range(count)]
    header = ["t", *names] + ([] if given else ["tension", "continuity", "bias"]) + ([n + "_v" for n in names] if given else []) + (["ease_in", "ease_out"] if ease else [])
    lines = [",".join(header)]
    for i in range(count):
        lines.append(",".join([repr(times[i]), *positions[i]] + ([] if given else tcbs[i]) + (velocities[i] if given else []) +
                              ([".25", ".5"] if ease else [])))
    text = "\n".join(lines) + "\n"
    rule, ends = rng.choice(rules), [rng.choice(end_rules), rng.choice(end_rules)]
    velocity = [repr(round(rng.uniform(-9, 9), 2) * size) for _ in names]
    spelled = [e + ("=" + ":".join(velocity) if e == "velocity" else "") for e in ends]
    options = ["--tangents", rule] + ([] if given else ["--tcb-scale", "none"]) + (["--period", repr(times[-1])] if closed else ["--ends", ",".join(spelled)])
    options += ["--equal-speed"] if equal else []
    options += ["--no-overshoot"]
    what = f"seed {seed} curve {number}: {' '.join(options)}\n{text}"
    if ease:  # rows of an eased curve stay in the range, too
        for row in run(text, options + ["--per-segment", "7", "--fields", "position,segment"]):
            i = int(row[-1])
            for channel in range(channels):
                p, q = float(positions[i][channel]), float(positions[(i + 1) % count][channel])
                slack = 1e-15 * max(abs(p), abs(q))
                require(min(p, q) - slack <= row[channel] <= max(p, q) + slack, f"{row}: {what}")
        options += ["--no-ease"]
    printed = run(text, options + ["--emit", "hermite"])
    for row in printed:
        h = Fraction(row[1])
        for channel in range(channels):
            p, v, q, w = [Fraction(x) for x in row[2 + 4 * channel:6 + 4 * channel]]
            most = leaves(p, v * h, q, w * h)
            require(most <= Fraction(1, 2 ** 49) * abs(q - p), f"{row} leaves by {float(most)}: {what}")
    for place in ["--per-segment=3", "--arc-count=7"]:
        for row in run(text, options + [place, "--golden", "--fields", "position,segment"]):
            i = int(row[-1])
            for channel in range(channels):
                p, q = float(positions[i][channel]), float(positions[(i + 1) % count][channel])
                require(min(p, q) <= row[channel] <= max(p, q), f"golden {place} {row}: {what}")
    if equal:
        continue
    keys = [(None, [Fraction(float(x)) for x in p], [Fraction(float(x)) for x in tcb]) for p, tcb in zip(positions, tcbs)]
    knots = [Fraction(t) for t in times[:count]]
    exact = Cubics(knots, keys, rule, ["half", "half"] if closed else ends,
                   Fraction(times[-1]) if closed else None, [Fraction(float(x)) for x in velocity])
    if given:
        for i, segment in enumerate(exact.cubics):
            h = exact.times[i + 1] - exact.times[i]
            for channel in range(channels):
                p, _, _, _ = segment[channel]
                q = keys[(i + 1) % count][1][channel]
                o = h * Fraction(float(velocities[i][channel]))
                m = h * Fraction(float(velocities[(i + 1) % count][channel]))
                segment[channel] = (p, o, 3 * (q - p) - 2 * o - m, -2 * (q - p) + o + m)
    pieces, near_pieces = limited(exact, channels, closed), limited(exact, channels, closed, room_of_doubles)
    golden = run(text, options + ["--emit", "hermite", "--golden"])
    require(len(golden) == len(pieces), f"{len(golden)} pieces: {what}")
    for i, (row, double, piece, near_piece) in enumerate(zip(golden, printed, pieces, near_pieces)):
        h = exact.times[i + 1] - exact.times[i]
        for channel in range(channels):
            p, o, q, m = piece[channel]
            _, near_o, _, near_m = near_piece[channel]
            require(leaves(p, o, q, m) <= 0, f"the exact piece {i} leaves the range: {what}")
            want = [float(x) for x in (p, o / h, q, m / h)]
            found = row[2 + 4 * channel:6 + 4 * channel]
            require(found == want, f"--golden {found}, expected {want}: {what}")
            near, want = double[2 + 4 * channel:6 + 4 * channel], [float(x) for x in (p, near_o / h, q, near_m / h)]
            require(all(abs(a - b) <= 4 * math.ulp(b) for a, b in zip(near, want)), f"{near}, expected {want}: {what}")

print(f"{curves} curves, {compared} comparisons, {failures} differ")
sys.exit(1 if failures else 0)
