"""Random keys of every kind, in every form, and their exact curves.

Numbers are texts, as a file has them; `number` says what they mean: by default the nearest double, as a fraction.
"""
import copy
import json
import math
from fractions import Fraction

from curves import Curve

RULES = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]
ENDS = ["half", "one-sided", "mirror", "chord", "zero", "natural", "natural-tension", "cry", "lightwave", "velocity"]
ROTATION_CURVES = ["squad", "casteljau", "components", "slerp"]
TIMES = ["whole", "short", "double", "negative", "uneven", "far"]
FINE_TIMES = ["long", "nanoseconds", "large", "sixty", "tiny"]  # of which doubles leave little


def double(text):
    return Fraction(float(Fraction(text)))


def is_exact(time):
    """Whether the program takes a time as the decimal that it is, and not as the nearest double."""
    mantissa = time.lower().partition("e")[0]
    return "." not in mantissa or len(mantissa.replace(".", "").lstrip("-0")) > 17


def decimal(value, digits):
    """A fraction with so many decimals, as text."""
    scaled = value * 10 ** digits
    whole = str(abs(scaled.numerator // scaled.denominator)).rjust(digits + 1, "0")
    return ("-" if value < 0 else "") + (whole[:-digits] + "." + whole[-digits:] if digits else whole)


def random_times(rng, count, style, gap=()):
    """Increasing times as texts, with a step that is longer than all others before the keys of `gap`. A style may be a unit,
    of which all times are multiples."""
    styles = {
        "whole": (rng.randint(-9, 9), lambda: rng.randint(1, 4), 0),
        "short": (Fraction(rng.randint(-99, 99), 10), lambda: Fraction(rng.randint(1, 30), 10), 1),
        "double": (rng.uniform(-9, 9), lambda: rng.uniform(0.01, 3), None),
        "negative": (-rng.randint(9, 99), lambda: Fraction(rng.randint(1, 99), 4), 2),
        "uneven": (rng.uniform(-9, 9), lambda: 10 ** rng.uniform(-3, 3), None),
        "far": (10 ** 6 + Fraction(rng.randint(0, 999), 1000), lambda: Fraction(rng.randint(100, 3000), 1000), 3),
        "long": (Fraction(1403637576252524268, 10 ** 9), lambda: Fraction(rng.randint(10 ** 7, 10 ** 10), 10 ** 9), 9),
        "nanoseconds": (1403637576252524268, lambda: rng.randint(10 ** 7, 10 ** 10), 0),
        "large": (10 ** 28 + 1, lambda: rng.randint(1, 10 ** 28), 0),
        "sixty": (rng.choice([0, 1, 1700000000]), lambda: Fraction(rng.randint(10 ** 59, 2 * 10 ** 60), 10 ** 60), 60),
        "tiny": (Fraction(rng.randint(0, 9), 10 ** 300), lambda: Fraction(rng.randint(1, 99), 10 ** 300), 300)}
    of_unit = (0, lambda: style * rng.choice([1, 2, 5, rng.randint(1, 100)]), -1)
    first, step, digits = styles.get(style, of_unit)
    t, times = Fraction(first), []
    for i in range(count):
        times.append(repr(float(t)) if digits is None else decimal(t, digits) if digits >= 0 else str(t))
        t = Fraction(times[-1]) + (Fraction(step()) if i + 1 not in gap else 2 * (Fraction(times[-1]) -
                                   Fraction(times[0])) + 5 * max(Fraction(step()) for _ in range(20)))
    return times


def unit(rng):
    q = [rng.gauss(0, 1) for _ in range(4)]
    return [x / math.hypot(*q) for x in q]


def turned(rng, q, widest):
    """A rotation, of any sign, by an angle up to the widest."""
    _, *axis = unit(rng)
    half = rng.uniform(0, widest) / 2
    a, b, c, d = math.cos(half), *(math.sin(half) * x / math.hypot(*axis) for x in axis)
    w, x, y, z = q
    turn = [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b,
            w * d + x * c - y * b + z * a]
    sign, size = rng.choice([1, 1, -1]), math.hypot(*turn)
    return [sign * number / size for number in turn]


class Keys:
    """Keys of one curve or several, with the options that say what curves they are.

    `without`: words for the kinds that a law cannot have, of tcb, own (columns of single channels), ease, velocities,
    closed, gaps, groups, sparse (missing cells), equal (speeds), linear, sizes (beside 1), rotations, and hold.
    """

    def __init__(self, rng, without="", times=TIMES, always="", channels=None, count=None, reach=(1, 1, 8), widest=2.2, shortest=2,
                 ends=ENDS, rotation_curves=ROTATION_CURVES, repeats=None):
        has = lambda kind, chance: kind not in without and (kind in always or rng.random() < chance)
        pick = rng.choice
        self.channels = ["x", "y", "z"][:channels or pick([1, 2, 3])]
        without, always, count = without.split(), always.split(), count or pick([2, 3, 4, 6, 9])
        self.closed = has("closed", 0.25) and count > 2
        cuts = []
        if not self.closed and has("gaps", 0.15):
            cuts = sorted(pick([(shortest,), (shortest, 2 * shortest + 1)]))
            count = max(count, cuts[-1] + shortest)
        self.times = random_times(rng, count + 1, pick(times), cuts)
        self.times, self.end = self.times[:-1], self.times[-1]
        steps = [Fraction(b) - Fraction(a) for a, b in zip(self.times, self.times[1:])]
        self.period = str(Fraction(self.end) - Fraction(self.times[0]))
        self.gap = 2 * max((step for i, step in enumerate(steps) if i + 1 not in cuts), default=1) if cuts else None
        self.cuts = [0, *cuts, count]
        self.sparse = has("sparse", 0.15) and len(self.channels) > 1 and count > 3 and not cuts
        self.linear = has("linear", 0.05)
        self.tcb = has("tcb", 0.75)
        self.given = not self.sparse and not self.linear and has("velocities", 0.15)
        self.tcb = self.tcb and not self.given
        self.own = not self.given and self.tcb and has("own", 0.15)
        self.ease = not self.sparse and has("ease", 0.2)
        self.equal = not (self.sparse or self.given or self.own or self.linear) and has("equal", 0.15)
        self.rotations = not (self.linear or self.own) and has("rotations", 0.25)
        self.rule = "linear" if self.linear else pick(RULES)
        self.size = 10.0 ** pick([0, 0, 0, -100, 100, 8]) if "sizes" not in without else 1.0
        ends = [end for end in ends if end != "velocity" or not self.rotations and self.size < 1e20]
        self.ends = ["half", "half"] if self.closed else [pick(ends), pick(ends)]
        self.rotation_curve = pick([curve for curve in rotation_curves if curve != "slerp" or not self.given])
        self.labels = ["a", "b-c", "7"][:pick([2, 3])] if has("groups", 0.15) else [""]
        self.velocity = [self.position(rng, "short") for _ in self.channels]
        reach, style, hold = pick(reach), pick(["whole", "short", "double", "long"]), has("hold", 0.3)
        self.repeats = self.closed and repeats is not False and (repeats or rng.random() < 0.5)  # the first key, at the end of the period
        self.curves = [self.random_curve(rng, count, style, reach, hold, widest) for _ in self.labels]

    def position(self, rng, style):
        if style == "whole":
            return repr(rng.randint(-5, 5) * self.size)
        if style == "long" and self.size == 1:
            return decimal(Fraction(rng.randint(-10 ** 41, 10 ** 41), 10 ** 40), 40)
        return repr((round(rng.uniform(-10, 10), 1) if style == "short" else rng.uniform(-10, 10)) * self.size)

    def random_curve(self, rng, count, style, reach, hold, widest):
        """Lists of texts of each key: positions, parameters, ease, velocities before and after, and a rotation and its."""
        rows, q = [], unit(rng)
        for i in range(count):
            positions = [self.position(rng, style) for _ in self.channels]
            if hold and rows and rng.random() < 0.3:
                positions = rows[-1][0]
            parameter = lambda: rng.choice(["0", "1", "-1", repr(round(rng.uniform(-reach, reach), 2)),
                                            repr(rng.uniform(-reach, reach))])
            tcb = [[parameter() for _ in range(3)] if self.tcb else ["0"] * 3]
            tcb = [[parameter() for _ in range(3)] for _ in self.channels] if self.own else tcb * len(self.channels)
            part = lambda: rng.choice(["0", "0", "0.25", "0.5", "1", repr(rng.random())])
            velocities = [[self.position(rng, style) for _ in self.channels] for _ in range(2)]
            if rng.random() < 0.5:
                velocities[1] = velocities[0]
            spins = [[repr(rng.gauss(0, 0.3)) for _ in range(4)] for _ in range(2)]
            rows.append([positions, tcb, [part(), part()] if self.ease else ["0", "0"], velocities, [*map(repr, q)], spins])
            q = turned(rng, q, widest)
        while self.closed and rows[-1][0] == rows[0][0]:  # it would be the end of the period
            rows[-1][0] = [self.position(rng, "double") for _ in self.channels]
        if self.sparse:  # but the key that the end of the period repeats has all cells
            for channel in range(1, len(self.channels)):
                for i in rng.sample(range(self.repeats, count), rng.randint(0, count - 2 - self.repeats)):
                    rows[i][0] = [x if c != channel else "" for c, x in enumerate(rows[i][0])]
            for i in rng.sample(range(self.repeats, count), rng.randint(0, count - 3 - self.repeats)):
                rows[i][4] = [""] * 4
        return rows

    def names(self):
        names = ["id"] * (len(self.labels) > 1) + ["t", *self.channels]
        if self.own:
            names += [f"{name}_{c}" for c in self.channels for name in ("tension", "continuity", "bias")]
        elif self.tcb:
            names += ["tension", "continuity", "bias"]
        names += ["ease_in", "ease_out"] * self.ease
        names += [f"{c}_{side}" for c in self.channels for side in ("vin", "vout")] * self.given
        names += ["qw", "qx", "qy", "qz"] * self.rotations
        return names + [f"q{c}_{side}" for c in "wxyz" for side in ("vin", "vout")] * (self.rotations and self.given)

    def rows(self):
        for label, curve in zip(self.labels, self.curves):
            times = self.times + [self.end] * self.repeats
            for t, (positions, tcb, ease, velocities, rotation, spins) in zip(times, curve + curve[:1] * self.repeats):
                row = [label] * (len(self.labels) > 1) + [t, *positions]
                row += sum(tcb[:len(tcb) if self.own else 1], []) * (self.own or self.tcb) + ease * self.ease
                row += sum(([a, b] for a, b in zip(*velocities)), []) * self.given
                row += rotation * self.rotations
                yield row + sum(([a, b] for a, b in zip(*spins)), []) * (self.rotations and self.given)

    def text(self, form="csv", time=str, column="t"):
        """The table; `time` writes the text of a time."""
        names = [column if name == "t" else name for name in self.names()]
        rows = [[time(cell) if name == "t" else cell for name, cell in zip(self.names(), row)] for row in self.rows()]
        if form in ("json", "jsonl"):
            row = lambda cells: "{" + ", ".join(f"{json.dumps(name)}: {json.dumps(cell) if name == 'id' else cell or 'null'}"
                                                for name, cell in zip(names, cells)) + "}"
            objects = list(map(row, rows))
            return "\n".join(objects) + "\n" if form == "jsonl" else "[" + ",\n".join(objects) + "]\n"
        delimiter = {"csv": ",", "tsv": "\t", "ssv": " ", "semicolons": ";"}[form]
        return "".join(delimiter.join(row) + "\n" for row in [names, *rows])

    def options(self):
        ends = ",".join(f"velocity={':'.join(self.velocity)}" if end == "velocity" else end for end in self.ends)
        options = ["--tangents", self.rule] + (["--ends", ends] if not self.closed and not self.linear else [])
        options += ["--tcb-scale", "none"] * (self.tcb and not self.linear)
        if self.closed:
            options += ["--closed"] if self.repeats else ["--period", self.period]
        options += ["--equal-speed"] * self.equal
        options += ["--missing", "skip-cell"] if self.sparse else []
        options += ["--max-gap", str(self.gap)] if self.gap else []
        options += ["--group", "id"] if len(self.labels) > 1 else []
        return options + (["--rotation-curve", self.rotation_curve] if self.rotations else [])

    def alone(self, curve, part):
        """The keys between two gaps of one curve, as keys of their own."""
        keys, first, last = copy.copy(self), *self.cuts[part:part + 2]
        keys.labels, keys.gap, keys.cuts = [""], None, [0, last - first]
        keys.times, keys.curves = self.times[first:last], [self.curves[curve][first:last]]
        return keys

    def time(self, text):
        """A time of a key as the program takes it."""
        return Fraction(text) if is_exact(text) else double(text)

    def parts(self, number=double, curve=Curve, **others):
        """The exact curves between gaps, of each label."""
        return [Part(self, rows, first, last, number, curve, others) for rows in self.curves
                for first, last in zip(self.cuts, self.cuts[1:])]

    def places(self, rng, count, exact=False):
        """Sorted times in each part and at a key, as texts: of doubles, or decimals and ratios."""
        places = []
        for first, last in zip(self.cuts, self.cuts[1:]):
            low, high = Fraction(self.times[first]), Fraction(self.end if self.closed else self.times[last - 1])
            places.append(rng.choice(self.times[first:last]))
            for _ in range(count):
                t = low + (high - low) * Fraction(rng.randint(1, 4095), 4096)
                texts = [str(t), decimal(t, rng.choice([15, 18, 25, 40, 60]))] if exact else [repr(float(t))]
                places += [one for one in rng.sample(texts, len(texts)) if low <= Fraction(one) <= high][:1]
        return sorted(set(places), key=Fraction)


class Part:
    """The exact curve of some keys: `whole`, or one of each channel, if these have keys or parameters of their own."""

    def __init__(self, keys, rows, first, last, number, curve, others):
        self.keys, self.number = keys, number
        time = keys.time if number == double else number
        self.knots, period = [time(t) for t in keys.times[first:last]], None
        if keys.closed:
            period = time(keys.end) - self.knots[0]
        self.rows, self.velocity = rows[first:last], [number(x) for x in keys.velocity]
        everything, self.curves, self.whole = range(len(keys.channels)), [], None
        for channels in [[c] for c in everything] if keys.sparse or keys.own else [everything]:
            exact = [(t, [number(row[0][c]) for c in channels], [number(x) for x in row[1][channels[0]]],
                      [number(x) for x in row[2]], [[number(v[c]) for c in channels] for v in row[3]] if keys.given else None)
                     for t, row in zip(self.knots, self.rows) if row[0][channels[0]]]
            if len(exact) > 1:
                made = curve(exact, keys.rule, keys.ends, period, [self.velocity[c] for c in channels], **others)
                self.curves += [(made, i) for i in range(len(channels))]
        if not keys.sparse and not keys.own and self.curves:
            self.whole = self.curves[0][0]
        self.period, self.knots = period, self.knots + ([self.knots[0] + period] if keys.closed else [])

    def place(self, channel, t, left=False):
        """The curve of a channel, its segment and the time in it; without a segment, where the channel rests."""
        curve, _ = self.curves[channel]
        while self.period and t < curve.times[0]:
            t += self.period
        is_outside = t < curve.times[0] or t > curve.times[-1] or t == curve.times[0] and left and t > self.knots[0] or (
            t == curve.times[-1] and not left and t < self.knots[-1])
        return curve, None if is_outside and self.keys.sparse else curve.segment_at(t, left), t

    def at(self, channel, t, left=False):
        """Position, velocity, acceleration and jerk at a time."""
        curve, i, t = self.place(channel, t, left)
        if i is None:
            rest = curve.keys[0 if t <= curve.times[0] else -1][1][self.curves[channel][1]]
            return rest, 0, 0, 0
        return list(curve.derivatives(i, curve.part_of(i, t)))[self.curves[channel][1]]

    def size(self, channel, t, left=False):
        curve, i, t = self.place(channel, t, left)
        return curve.size(0 if i is None else i, self.curves[channel][1])

    def over_time(self, channel, t):
        """The coefficients from a time on by powers of time; of keys without ease."""
        curve, i, t = self.place(channel, t)
        if i is None:
            return self.at(channel, t)
        return curve.over_time(i, self.curves[channel][1], t - curve.times[i])

    def rotations(self):
        """The curve of rotations, of keys that all have one."""
        import quaternions  # which needs mpmath
        exact = lambda texts: [quaternions.to_mpf(self.number(x)) for x in texts]
        keys = [(quaternions.to_mpf(t), exact(row[4]), exact(row[1][0]), exact(row[2])) for t, row in zip(self.knots, self.rows)]
        curve = quaternions.Rotations(keys, self.keys.rotation_curve, self.keys.rule, self.keys.ends,
                                      self.period and quaternions.to_mpf(self.period), self.keys.equal)
        if self.keys.given:
            curve.give([list(map(exact, row[5])) for row in self.rows])
        return curve
