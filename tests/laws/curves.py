"""Curves by the formulas of the rules, in any exact number: fractions, or floats of many digits. Nothing is taken from the
program."""
from fractions import Fraction

try:
    import mpmath  # of MeasuredCurve
except ImportError:
    mpmath = None


def factors(t, c, b):
    return ((1 - t) * (1 + c) * (1 + b), (1 - t) * (1 - c) * (1 - b),
            (1 - t) * (1 - c) * (1 + b), (1 - t) * (1 + c) * (1 - b))


def tangents(rule, d0, d1, h0, h1, t, c, b):
    """(in, out) of a key, local units, from the chords and steps on both sides."""
    fa, fb, fc, fd = factors(t, c, b)
    uin = [(fc * x + fd * y) / 2 for x, y in zip(d0, d1)]
    uout = [(fa * x + fb * y) / 2 for x, y in zip(d0, d1)]
    scaled = lambda f, g: ([f * x for x in uin], [g * x for x in uout])
    f, g = 2 * h0 / (h0 + h1), 2 * h1 / (h0 + h1)
    if rule == "velocity":
        return ([h0 * (fc * x / h0 + fd * y / h1) / 2 for x, y in zip(d0, d1)],
                [h1 * (fa * x / h0 + fb * y / h1) / 2 for x, y in zip(d0, d1)])
    if rule == "finite-difference":
        return ([h0 * (fc * h1 * x / h0 + fd * h0 * y / h1) / (h0 + h1) for x, y in zip(d0, d1)],
                [h1 * (fa * h1 * x / h0 + fb * h0 * y / h1) / (h0 + h1) for x, y in zip(d0, d1)])
    if rule == "uniform":
        return scaled(1, 1)
    if rule == "interval":
        return scaled(f, g)
    if rule == "interval-c":
        return scaled(f + abs(c) * (1 - f), g + abs(c) * (1 - g))
    if rule == "kb1984":
        return scaled(g, f)
    if rule == "synfig":
        return scaled(3 * h0 / (h0 + 2 * h1), 3 * h1 / (h1 + 2 * h0))
    if rule == "linear":
        return list(d0), list(d1)
    raise ValueError(rule)


def end_tangent(rule, own, missing, t, d, m, h, velocity, two):
    if rule == "half":
        return [own * x / 2 for x in d]
    if rule == "one-sided":
        return [own * x for x in d]
    if rule == "mirror":
        return [(own + missing) * x / 2 for x in d]
    if rule == "chord":
        return list(d)
    if rule == "zero":
        return [0 * x for x in d]
    if rule == "natural":
        return list(d) if two else [(3 * x - y) / 2 for x, y in zip(d, m)]
    if rule == "natural-tension":
        return [(1 - t) * (x if two else (3 * x - y) / 2) for x, y in zip(d, m)]
    if rule == "cry":
        return [(1 - t) * (x if two else 3 * (x - y) / 2) for x, y in zip(d, m)]
    if rule == "lightwave":
        return [own * x * 3600 * h / (3600 * h + 1) for x in d]
    if rule == "velocity":
        return [h * x for x in velocity]
    raise ValueError(rule)


class Curve:
    """A curve through keys (time, position, (T, C, B), (ease_in, ease_out), velocities).

    Velocities, before and after the key, are those that a file gives; None, or left out, for tangents by the rule.
    `period` is that of a closed curve; `norm`: for equal speeds. `cubics` has (p, b, c, d) of each channel of each
    segment, p + b u + c u^2 + d u^3.
    """

    def __init__(self, keys, rule="velocity", ends=("half", "half"), period=None, velocity=None, norm=None):
        if rule == "linear":
            ends, norm = ("chord", "chord"), None
        self.closed = period is not None
        self.keys, n = keys, len(keys)
        self.times = [key[0] for key in keys] + ([keys[0][0] + period] if self.closed else [])
        position = lambda i: keys[i % n][1]
        chord = lambda i: [y - x for x, y in zip(position(i), position(i + 1))]
        step = lambda i: self.times[(i % n) + 1] - self.times[i % n] if self.closed else self.times[i + 1] - self.times[i]
        ins, outs = {}, {}
        for i in range(0 if self.closed else 1, n if self.closed else n - 1):
            ins[i], outs[i] = tangents(rule, chord(i - 1), chord(i), step(i - 1), step(i), *keys[i][2])
            if norm is not None:
                vin, vout = norm(ins[i]) / step(i - 1), norm(outs[i]) / step(i)
                if vin + vout != 0:
                    ins[i] = [x * 2 * vout / (vin + vout) for x in ins[i]]
                    outs[i] = [x * 2 * vin / (vin + vout) for x in outs[i]]
        if not self.closed:
            fa, fb, _, _ = factors(*keys[0][2])
            outs[0] = end_tangent(ends[0], fb, fa, keys[0][2][0], chord(0), ins.get(1, chord(0)), step(0), velocity, n == 2)
            _, _, fc, fd = factors(*keys[-1][2])
            ins[n - 1] = end_tangent(ends[1], fc, fd, keys[-1][2][0], chord(n - 2), outs.get(n - 2, chord(0)), step(n - 2),
                                     velocity, n == 2)
        for i, key in enumerate(keys):
            if key[4:] and key[4] is not None:
                before, after = key[4]
                ins[i] = [step(i - 1) * x for x in before] if self.closed or i > 0 else None
                outs[i] = [step(i) * x for x in after] if self.closed or i + 1 < n else None
        self.cubics = []
        for i in range(len(self.times) - 1):
            k = (i + 1) % n
            self.cubics.append([(p, o, 3 * (q - p) - 2 * o - m, -2 * (q - p) + o + m)
                                for p, q, o, m in zip(position(i), position(k), outs[i], ins[k])])
        self.eases = []
        for i in range(len(self.cubics)):
            f, e = (keys[i][3][1], keys[(i + 1) % n][3][0]) if keys[i][3:] else (0, 0)
            self.eases.append((f, e) if f + e <= 1 else (f / (f + e), e / (f + e)))

    def segment_at(self, t, left=False):
        """The segment from a time on, or up to it."""
        return max((i for i in range(len(self.cubics)) if self.times[i] < t or self.times[i] == t and not left), default=0)

    def part_of(self, i, t):
        return (t - self.times[i]) / (self.times[i + 1] - self.times[i])

    def warp(self, i, u):
        """The warped u, and its first and second derivative."""
        return warp(*self.eases[i], u)

    def derivatives(self, i, passed, w=None):
        """Position, velocity, acceleration and jerk of each channel at the part `passed` of the time of a segment."""
        warped, w1, w2 = self.warp(i, passed)
        w, h = warped if w is None else w, self.times[i + 1] - self.times[i]
        rate, bend = w1 / h, w2 / h ** 2
        for p, b, c, d in self.cubics[i]:
            d1, d2, d3 = b + w * (2 * c + w * 3 * d), 2 * c + 6 * d * w, 6 * d
            yield (p + w * (b + w * (c + w * d)), d1 * rate, d2 * rate ** 2 + d1 * bend,
                   d3 * rate ** 3 + 3 * d2 * rate * bend)

    def at(self, t, left=False):
        i = self.segment_at(t, left)
        return list(self.derivatives(i, self.part_of(i, t)))

    def size(self, i, channel):
        """The largest number in the sum of a cubic: what its rounding errors are measured by."""
        p, b, c, d = self.cubics[i][channel]
        return max(abs(x) for x in (p, p + b + c + d, b, b + 2 * c + 3 * d))

    def over_time(self, i, channel, x):
        """The coefficients of a cubic without ease about x after the start of its segment, by powers of time."""
        p, b, c, d = self.cubics[i][channel]
        h = self.times[i + 1] - self.times[i]
        b, c, d = b / h, c / h ** 2, d / h ** 3
        return p + x * (b + x * (c + x * d)), b + x * (2 * c + 3 * d * x), c + 3 * d * x, d


def warp(f, e, u):
    if f + e == 0:
        return u, 1, 0
    k = 1 / (2 - f - e)
    if u < f or f == 1:
        return k / f * u * u, 2 * k / f * u, 2 * k / f
    if u < 1 - e or e == 0:
        return k * (2 * u - f), 2 * k, 0
    return 1 - k / e * (1 - u) ** 2, 2 * k / e * (1 - u), -2 * k / e


def to_mpf(value):
    return mpmath.mpf(value.numerator) / value.denominator if isinstance(value, (int, Fraction)) else value


def tiny():
    """What digits leave of zero, in units of what is subtracted."""
    return mpmath.mpf(10) ** (-2 * mpmath.mp.dps // 3)


def norm(v):
    return mpmath.sqrt(to_mpf(sum(x * x for x in v)))


class MeasuredCurve(Curve):
    """A curve in floats of many digits, with its lengths and what is made of square roots."""

    def __init__(self, keys, *arguments, equal=False, exponent=None):
        if exponent is not None:  # times are made from distances
            times = [mpmath.mpf(0)]
            for a, b in zip(keys, keys[1:]):
                times.append(times[-1] + norm([y - x for x, y in zip(a[1], b[1])]) ** exponent)
            keys = [(t, *key[1:]) for t, key in zip(times, keys)]
        super().__init__(keys, *arguments, norm=norm if equal else None)
        self.lengths, self.squares = {}, {}

    def unwarp(self, i, w):
        f, e = self.eases[i]
        if f + e == 0:
            return w
        k = 1 / (2 - f - e)
        if w < k * f:
            return mpmath.sqrt(w * f / k)
        return (w / k + f) / 2 if w < 1 - k * e else 1 - mpmath.sqrt((1 - w) * e / k)

    def square(self, i):
        """The square of the speed by the local parameter: the coefficients of a quartic, and where it is least."""
        if i not in self.squares:
            q = [mpmath.mpf(0)] * 5
            for _, *more in self.cubics[i]:
                v = [k * x for k, x in enumerate(more, 1)]
                for j in range(3):
                    for k in range(3):
                        q[4 - j - k] += v[j] * v[k]
            slope = [k * x for k, x in zip((4, 3, 2, 1), q)]
            while slope and slope[0] == 0:
                slope.pop(0)
            with mpmath.workdps(90):
                places = [z.real for z in mpmath.polyroots(slope, maxsteps=500, extraprec=400)] if len(slope) > 1 else []
            self.squares[i] = q, sorted(z for z in places if 0 < z < 1)
        return self.squares[i]

    def speed(self, i, u):
        return mpmath.sqrt(abs(mpmath.polyval(self.square(i)[0], u)))

    def length(self, i, u=1, begin=0):
        """Between two local parameters."""
        if (i, u, begin) not in self.lengths:
            cuts = [mpmath.mpf(begin), *(z for z in self.square(i)[1] if begin < z < u), mpmath.mpf(u)]
            halves = [(lo, hi) for a, b in zip(cuts, cuts[1:]) for lo, hi in ((a, (a + b) / 2), ((a + b) / 2, b))]
            self.lengths[i, u, begin] = sum(mpmath.quad(lambda z: self.speed(i, z), half, maxdegree=9) for half in halves)
        return self.lengths[i, u, begin]

    def place_at(self, s):
        """(segment, u) where the curve has the length s: by Newton's method, or halves."""
        i, near = 0, mpmath.mpf(10) ** (5 - mpmath.mp.dps)
        while i + 1 < len(self.cubics) and s > self.length(i):
            s -= self.length(i)
            i += 1
        if s == 0 or abs(s - self.length(i)) < near * s:
            return i, mpmath.mpf(s != 0)
        low, high, u, missing = mpmath.mpf(0), mpmath.mpf(1), mpmath.mpf(0), s
        for _ in range(200):
            low, high = (low, u) if missing < 0 else (u, high)
            speed = self.speed(i, u)
            new = u + missing / speed if speed > near * s else (low + high) / 2
            new = new if low < new < high else (low + high) / 2
            missing += self.length(i, u, new) if new < u else -self.length(i, new, u)
            if abs(new - u) < near:
                return i, new
            u = new
        return i, u

    def row(self, fields, i, passed, t, w=None, s=None):
        """The numbers of a row; None is an empty cell."""
        w = self.warp(i, passed)[0] if w is None else w
        x, *changes = map(list, zip(*self.derivatives(i, passed, w)))
        size = max([abs(z) for cubic in self.cubics[i] for z in cubic]) / (self.times[i + 1] - self.times[i])
        found = {"time": t, "u": passed, "segment": i, "position": x, "velocity": changes[0], "acceleration": changes[1],
                 "jerk": changes[2], **shape(*changes, size * tiny())}
        for field in fields:
            if field == "s":
                yield s if s is not None else sum(self.length(k) for k in range(i)) + self.length(i, w)
            elif isinstance(found[field], list):
                yield from found[field]
            else:
                yield found[field]


def shape(v, a, j, nothing=0):
    """The fields that derivatives give. `nothing` is the speed of what rests, which is 0 if they are fractions."""
    speed = norm(v)
    area = norm([v[p] * a[q] - v[q] * a[p] for p in range(len(v)) for q in range(p + 1, len(v))])
    moves = speed > nothing
    bends = moves and area > 0 and (not nothing or area > tiny() * speed * norm(a) + nothing * speed)
    det = v[0] * (a[1] * j[2] - a[2] * j[1]) - v[1] * (a[0] * j[2] - a[2] * j[0]) + v[2] * (
        a[0] * j[1] - a[1] * j[0]) if len(v) == 3 else 0
    return {"speed": speed, "tangent": [to_mpf(z) / speed if moves else None for z in v],
            "curvature": None if not moves else area / speed ** 3 if bends else 0,
            "torsion": to_mpf(det) / area ** 2 if bends else None}
