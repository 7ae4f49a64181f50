"""The pieces of --emit against exact fractions: pieces.py PROGRAM [CURVES] [SEED].

Random keys, rules, ranges, closed curves and missing cells. With --golden no bit may differ from the fractions of
cubics.py, rounded once. Without it, each number is within the bound of tcbsample-numerics(7), and the pieces have the
positions of samples. Exit 1: a number differs, and its command is printed.
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
forms = {"hermite": ["_p0", "_v0", "_p1", "_v1"], "bezier": ["_b0", "_b1", "_b2", "_b3"],
         "poly": ["^0", "^1", "^2", "^3"]}
compared = failures = 0


def require(condition, what):
    global compared, failures
    compared += 1
    if not condition:
        failures += 1
        if failures <= 20:
            print(what, file=sys.stderr)


def run(text, options):
    done = subprocess.run([program, *options], input=text, text=True, capture_output=True)
    if done.returncode != 0:
        sys.exit(f"{options}: {done.stderr}\n{text}")
    names, *rows = [line.split(",") for line in done.stdout.splitlines()]
    return names, [[float(cell) for cell in row] for row in rows]


def number_text(style):
    if style == "short":
        return str(rng.randint(-999, 999) / 10)
    return repr(rng.choice([rng.uniform(-10, 10), rng.uniform(-10, 10), rng.uniform(-1, 1) * 1e6]))


class Keys:
    """Keys as texts, and the exact cubics of each channel between them."""

    def __init__(self):
        self.style = rng.choice(["short", "double"])
        self.channels = ["x", "y", "z"][:rng.choice([1, 2, 3])]
        count = rng.choice([2, 3, 4, 6, 9])
        self.closed = count > 2 and rng.random() < 0.25
        self.sparse = count > 3 and rng.random() < 0.25
        self.exact_input = rng.random() < 0.3
        t, self.times = rng.choice([0.0, round(rng.uniform(-9, 9), 2), 1e6 * rng.random()]), []
        for _ in range(count):
            self.times.append(repr(t))
            t = t + rng.choice([1.0, 0.1, rng.uniform(0.01, 3)])
        self.end = repr(t)
        self.positions = [[number_text(self.style) for _ in self.channels] for _ in range(count)]
        if self.sparse:
            for channel in range(len(self.channels)):
                for key in rng.sample(range(count), rng.randint(0, count - 2)):
                    self.positions[key][channel] = ""
            for row in self.positions:
                row[0] = row[0] or "1"  # a row without any position is still a key
        self.tcbs = [[rng.choice(["0", "0", repr(rng.uniform(-1, 1)), "1", "-1", "1.75"]) for _ in range(3)]
                     for _ in range(count)]
        self.rule = rng.choice(rules)
        self.ends = ["half", "half"] if self.closed else [rng.choice(end_rules), rng.choice(end_rules)]
        self.velocity = [repr(round(rng.uniform(-3, 3), 2)) for _ in self.channels]

    def text(self):
        lines = [",".join(["t", *self.channels, "tension", "continuity", "bias"])]
        lines += [",".join([t, *p, *tcb]) for t, p, tcb in zip(self.times, self.positions, self.tcbs)]
        return "\n".join(lines) + "\n"

    def options(self):
        spelled = [e + ("=" + ":".join(self.velocity) if e == "velocity" else "") for e in self.ends]
        options = ["--tangents", self.rule] + ([] if self.closed else ["--ends", ",".join(spelled)])
        if self.closed:
            options += ["--period", str(Fraction(self.end) - Fraction(self.times[0]))]
        return options + (["--missing", "skip-cell"] if self.sparse else [])

    def number(self, text):
        return Fraction(text) if self.exact_input else Fraction(float(text))

    def knots(self):
        return [self.number(t) for t in self.times + ([self.end] if self.closed else [])]

    def own_cubics(self, channel):
        """(times, cubics) of a channel through its own keys, with cubics per unit of time."""
        rows = [i for i, p in enumerate(self.positions) if p[channel] != ""]
        times = [self.number(self.times[i]) for i in rows]
        keys = [(None, [self.number(self.positions[i][channel])], [self.number(x) for x in self.tcbs[i]]) for i in rows]
        knots = self.knots()
        if len(rows) == 1 and not self.closed:
            return [knots[0], knots[-1]], [(keys[0][1][0], Fraction(0), Fraction(0), Fraction(0))]
        curve = Cubics(times, keys, self.rule, self.ends, knots[-1] - knots[0] if self.closed else None,
                       [self.number(self.velocity[channel])])
        cubics = []
        for i, (a, b) in enumerate(zip(curve.times, curve.times[1:])):
            p, c1, c2, c3 = curve.cubics[i][0]
            h = b - a
            cubics.append((p, c1 / h, c2 / h ** 2, c3 / h ** 3))
        return curve.times, cubics

    def polynomial(self, channel, start, end):
        """The coefficients about `start` on the piece up to `end`, and the largest terms of their sums."""
        times, cubics = self.own_cubics(channel)
        if self.closed:  # the keys before the first one are those of the last period
            period = self.knots()[-1] - self.knots()[0]
            while start < times[0]:
                start, end = start + period, end + period
        elif start < times[0] or end > times[-1]:  # an open channel rests outside its keys
            at = cubics[0][0] if start < times[0] else value(cubics[-1], times[-1] - times[-2])
            return (at, Fraction(0), Fraction(0), Fraction(0)), [abs(at), 0, 0, 0]
        i = max(k for k in range(len(cubics)) if times[k] <= start)
        x = start - times[i]
        p, a, b, c = cubics[i]
        h = times[i + 1] - times[i]
        size = max(abs(p), abs(value(cubics[i], h)), abs(a * h), abs(b * h * h), abs(c * h ** 3))
        return ((value(cubics[i], x), a + x * (2 * b + 3 * c * x), b + 3 * c * x, c),
                [size, size / h, size / h ** 2, size / h ** 3])


def value(cubic, x):
    p, a, b, c = cubic
    return p + x * (a + x * (b + x * c))


def numbers_of(form, polynomial, h):
    p, a, b, c = polynomial
    last, slope = value(polynomial, h), a + h * (2 * b + 3 * c * h)
    if form == "hermite":
        return [p, a, last, slope]
    if form == "bezier":
        return [p, p + a * h / 3, last - slope * h / 3, last]
    return [p, a, b, c]


def position_of(form, numbers, h, x):
    """The position at the time x after the start, from the printed numbers."""
    p, a, q, b = numbers[:4]
    if form == "bezier":
        p, a, q, b = numbers[0], 3 * (numbers[1] - numbers[0]) / h, numbers[3], 3 * (numbers[3] - numbers[2]) / h
    if form in ("hermite", "bezier"):
        chord = (q - p) / h
        return value((p, a, (3 * chord - 2 * a - b) / h, (a + b - 2 * chord) / h ** 2), x)
    return value(numbers[:4], x)


def bounds(form, sizes, h):
    """The largest term behind each number, of which its error may be a few units in the last place."""
    p, a, b, c = sizes
    slope = max(a, 2 * b * h, 3 * c * h * h)
    if form == "hermite":
        return [p, slope, p, slope]
    if form == "bezier":
        return [p, max(p, slope * h), max(p, slope * h), p]
    return [p, slope, max(b, 3 * c * h), c]


def ulps(got, want, size=None):
    """The error in units in the last place of the number, or of `size`."""
    if Fraction(got) == want:
        return Fraction(0)
    return abs(Fraction(got) - want) / Fraction(math.ulp(float(want if size is None else max(size, abs(want)))))


for number in range(curves):
    keys = Keys()
    text, form = keys.text(), rng.choice(list(forms))
    options = ["--emit", form, *keys.options()]
    knots = keys.knots()
    ranges = [(knots[0], knots[-1])]
    if rng.random() < 0.5:
        low, high = sorted(rng.uniform(float(knots[0]), float(knots[-1])) for _ in range(2))
        ranges = [(keys.number(repr(low)), keys.number(repr(high)))]
        options += ["--from", repr(low), "--to", repr(high)]
    start, end = ranges[0]
    if start >= end:
        continue
    pieces = [(max(a, start), min(b, end)) for a, b in zip(knots, knots[1:]) if max(a, start) < min(b, end)]
    whole = set(zip(knots, knots[1:]))
    for golden in ([], ["--golden"], ["--golden", "--exact-input"]):
        if bool(golden) and ("--exact-input" in golden) != keys.exact_input:
            continue
        names, rows = run(text, options + golden)
        what = f"seed {seed} curve {number}: {' '.join(options + golden)}\n{text}"
        want_names = ["start", "duration"] + [c + suffix for c in keys.channels for suffix in forms[form]]
        require(names == want_names, f"{names}: {what}")
        require(len(rows) == len(pieces), f"{len(rows)} rows: {what}")
        for row, (a, b) in zip(rows, pieces):
            require(row[0] == float(a), f"start {row[0]!r}, expected {float(a)!r}: {what}")
            if golden or not keys.exact_input:
                require(row[1] == float(b - a), f"duration {row[1]!r}, expected {float(b - a)!r}: {what}")
            cells = row[2:]
            for channel, name in enumerate(keys.channels):
                got = cells[channel * 4:(channel + 1) * 4]
                polynomial, sizes = keys.polynomial(channel, a, b)
                want = numbers_of(form, polynomial, b - a)
                for k, (g, w, size) in enumerate(zip(got, want, bounds(form, sizes, b - a), strict=True)):
                    place = f"{name}{forms[form][k]} at {float(a)!r}"
                    if golden:
                        require(g == float(w), f"{place}: {g!r}, expected {float(w)!r}: {what}")
                    elif not keys.exact_input:
                        is_whole = (a, b) in whole and not keys.sparse
                        by_itself = is_whole and (k % 3 == 0 or form != "bezier")
                        off = ulps(g, w, None if by_itself else size)
                        tiny = size != 0 and abs(Fraction(g) - w) < size / 2 ** 90
                        require(off <= (2 if is_whole else 4) or tiny,
                                f"{place}: {float(off)} ulp: {g!r}, expected {float(w)!r}: {what}")

    if form == "hermite" and not keys.sparse:  # the positions are those of samples, bit for bit
        _, rows = run(text, options)
        for which, column in ((0, 2), (1, 4)):
            times = ",".join(repr(float(piece[which])) for piece in pieces)
            _, at_times = run(text, keys.options() + ["--at", times, "--fields", "position"])
            got, want = [row[column::4] for row in rows], at_times
            require(got == want, f"positions {got}, expected {want}: seed {seed} curve {number}: {options}\n{text}")
    # Evaluated exactly, the printed numbers give the positions of samples, within a few units in the last place.
    _, rows = run(text, options)
    times = [repr(row[0] + row[1] * u) for row in rows for u in (0.25, 0.625)]
    inside = [start <= Fraction(float(t)) <= end for t in times]
    _, samples = run(text, keys.options() + ["--at", ",".join(t for t, on in zip(times, inside) if on)])
    for sample in samples:
        row = [row for row in rows if row[0] <= sample[0]][-1]
        x, h = Fraction(sample[0]) - Fraction(row[0]), Fraction(row[1])
        for channel in range(len(keys.channels)):
            numbers = [Fraction(cell) for cell in row[2 + channel * 4:2 + (channel + 1) * 4]]
            size = keys.polynomial(channel, keys.number(repr(row[0])), keys.number(repr(row[0])) + h / 2)[1][0]
            off = abs(position_of(form, numbers, h, x) - Fraction(sample[1 + channel]))
            require(off <= 8 * Fraction(math.ulp(float(size))),
                    f"position at {sample[0]!r}: {float(off / Fraction(math.ulp(float(size))))} ulp: "
                    f"seed {seed} curve {number}: {options}\n{text}")
    if number % 5 != 0:
        continue
    # s is that of a sample at the start of the piece, and length the difference to the end.
    what = f"seed {seed} curve {number}: {' '.join(options)} --fields s,length\n{text}"
    for golden in ([], ["--golden"] + (["--exact-input"] if keys.exact_input else [])):
        _, rows = run(text, options + golden + ["--fields", "length,s"])
        times = [repr(float(t)) for t in [a for a, _ in pieces] + [pieces[-1][1]]]
        _, at_times = run(text, keys.options() + golden + ["--at", ",".join(times), "--fields", "s"])
        lengths = [row[0] for row in at_times]
        # Cubics of missing cells are cut, each way with rounded coefficients: units are those of the largest term.
        largest = max(keys.polynomial(channel, a, b)[1][0] for channel in range(len(keys.channels)) for a, b in pieces)
        largest = float(largest) if keys.sparse and not golden else 0.0
        for row, before, after in zip(rows, lengths[:-1], lengths[1:], strict=True):
            off = (0 if golden else 4 if keys.sparse else 1) * math.ulp(max(before, largest))
            require(abs(row[-1] - before) <= off, f"s {row[-1]!r}, expected {before!r}: {what}")
            near = (1 if golden else 8) * math.ulp(max(after, largest))
            require(abs(row[-2] - (after - before)) <= near, f"length {row[-2]!r}, expected {after - before!r}: {what}")

print(f"{compared} comparisons, {failures} failures")
sys.exit(1 if failures else 0)
