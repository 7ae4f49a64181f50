"""Curves of rotations by the formulas of the rules, with mpmath: squad, casteljau, components, slerp.

A quaternion is (w, x, y, z). Nothing here is taken from the program: a slerp is a power of a rotation, and derivatives
are differences of values of 50 digits.
"""
import mpmath
from mpmath import mpf

from curves import end_tangent, factors, tangents, to_mpf, warp  # noqa: F401

step = mpf(10) ** -16  # of central differences: what they leave out is about its square


def dot(p, q):
    return sum(x * y for x, y in zip(p, q))


def norm(v):
    return mpmath.sqrt(dot(v, v))


def scaled(v, factor):
    return [x * factor for x in v]


def normalized(q):
    return scaled(q, 1 / norm(q))


def product(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def matrix(q):
    w, x, y, z = q
    return [w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w),
            2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w),
            2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z]


def log(q):
    length = norm(q[1:])
    return [mpf(0)] * 3 if length == 0 else scaled(q[1:], mpmath.atan2(length, q[0]) / length)


def exp(v):
    angle = norm(v)
    return [mpmath.cos(angle), *(v if angle == 0 else scaled(v, mpmath.sin(angle) / angle))]


def turned(q, v):
    return product(q, exp(v))


def slerp(p, q, u):
    return turned(p, scaled(log(product(conjugate(p), q)), u))


def nearest(q, to):
    return scaled(q, -1) if dot(q, to) < 0 else list(q)


class Rotations:
    """Keys are (time, quaternion, (T, C, B), (ease_in, ease_out)); `closed` is the period."""

    def __init__(self, keys, curve, rule, ends, closed=None, equal=False):
        self.curve, self.closed = curve, closed is not None
        self.times = [key[0] for key in keys] + ([keys[0][0] + closed] if self.closed else [])
        self.keys = keys
        self.quaternions = [normalized(keys[0][1])]
        for key in keys[1:] + ([keys[0]] if self.closed else []):
            self.quaternions.append(nearest(normalized(key[1]), self.quaternions[-1]))
        self.ends, self.two = ends, len(keys) == 2 and not self.closed
        self.count = len(self.times) - 1
        self.chords = [self.chord(i) for i in range(self.count)]
        self.set_tangents(rule, equal)

    def chord(self, i):
        p, q = self.quaternions[i:i + 2]
        return [y - x for x, y in zip(p, q)] if self.curve == "components" else log(product(conjugate(p), q))

    def set_tangents(self, rule, equal):
        n, h = self.count, [b - a for a, b in zip(self.times, self.times[1:])]
        self.outs, self.ins = [None] * n, [None] * n  # of segment i: at its start, and at its end
        # The numbers of the last key of a closed curve are those of the first, or their negatives.
        flips = self.closed and self.curve == "components" and dot(self.quaternions[0], self.quaternions[-1]) < 0
        flip = -1 if flips else 1
        for i in range(0 if self.closed else 1, n):
            before = scaled(self.chords[i - 1], flip if i == 0 else 1)
            into, out = tangents(rule, before, self.chords[i], h[i - 1], h[i], *self.keys[i][2])
            if equal:
                a, b = norm(into) / h[i - 1], norm(out) / h[i]
                if a + b != 0:
                    into, out = scaled(into, 2 * b / (a + b)), scaled(out, 2 * a / (a + b))
            self.ins[i - 1], self.outs[i] = scaled(into, flip if i == 0 else 1), out
        if self.closed:
            return
        one, two = self.keys[0][2], self.keys[-1][2]
        (fa, fb, _, _), (_, _, fc, fd) = factors(*one), factors(*two)
        other = (self.ins[0], self.outs[-1]) if n > 1 else (self.chords[0], self.chords[0])
        self.outs[0] = end_tangent(self.ends[0], fb, fa, one[0], self.chords[0], other[0], h[0], None, n == 1)
        self.ins[-1] = end_tangent(self.ends[1], fc, fd, two[0], self.chords[-1], other[1], h[-1], None, n == 1)

    def give(self, velocities):
        """Replaces the tangents by given velocities of the four numbers, before and after each key."""
        for i in range(self.count):
            h = self.times[i + 1] - self.times[i]
            self.outs[i] = scaled(self.rate(i, velocities[i][1]), h)
            self.ins[i] = scaled(self.rate(i + 1, velocities[(i + 1) % len(velocities)][0]), h)
        self.ends = None

    def rate(self, i, velocity):
        """A velocity of the four numbers as that of chords."""
        given = self.keys[i % len(self.keys)][1]
        if self.curve == "components":
            return scaled(velocity, 1 / dot(given, self.quaternions[i]))
        return scaled(product(conjugate(given), velocity)[1:], 1 / dot(given, given))

    def controls(self, i):
        """The four points of casteljau. At a natural end, the middle of the keys, as the Python package splines has it."""
        p, q = self.quaternions[i:i + 2]
        points = [p, turned(p, scaled(self.outs[i], mpf(1) / 3)), turned(q, scaled(self.ins[i], mpf(-1) / 3)), q]
        if self.ends is None:
            return points
        if not self.closed and not self.two and i == 0 and self.ends[0] == "natural":
            points[1] = slerp(p, q, mpf(1) / 2)
        if not self.closed and not self.two and i == self.count - 1 and self.ends[1] == "natural":
            points[2] = slerp(p, q, mpf(1) / 2)
        return points

    def value(self, i, w):
        """The quaternion at the eased parameter."""
        p, q = self.quaternions[i:i + 2]
        out, into, chord = self.outs[i], self.ins[i], self.chords[i]
        if self.curve == "slerp":
            return slerp(p, q, w)
        if self.curve == "squad":
            a = turned(p, scaled([x - y for x, y in zip(out, chord)], mpf(1) / 2))
            b = turned(q, scaled([y - x for x, y in zip(into, chord)], mpf(1) / 2))
            return slerp(slerp(p, q, w), slerp(a, b, w), 2 * w * (1 - w))
        if self.curve == "components":
            return normalized([x + w * (o + w * (3 * d - 2 * o - m + w * (o + m - 2 * d)))
                               for x, o, m, d in zip(p, out, into, chord)])
        points = self.controls(i)
        while len(points) > 1:
            points = [slerp(x, y, w) for x, y in zip(points, points[1:])]
        return points[0]

    def widest(self, i):
        """The largest angle of a slerp at the control points: near pi the curve is ill-conditioned."""
        p, q = self.quaternions[i:i + 2]
        if self.curve == "squad":
            a = turned(p, scaled([x - y for x, y in zip(self.outs[i], self.chords[i])], mpf(1) / 2))
            b = turned(q, scaled([y - x for x, y in zip(self.ins[i], self.chords[i])], mpf(1) / 2))
            places = [(slerp(p, q, mpf(k) / 4), slerp(a, b, mpf(k) / 4)) for k in range(5)] + [(a, b)]
        elif self.curve == "casteljau":
            points = self.controls(i)
            places = list(zip(points, points[1:]))
        elif self.curve == "components":
            middle = [(x + y) / 2 + (o - m) / 8 for x, y, o, m in zip(p, q, self.outs[i], self.ins[i])]
            return mpf(0) if norm(middle) > mpf("0.5") else mpmath.pi
        else:
            places = []
        return max([mpmath.acos(max(-1, min(1, dot(x, y)))) for x, y in places], default=mpf(0))

    def segment_at(self, t):
        for i in range(self.count - 1):
            if t < self.times[i + 1]:
                return i
        return self.count - 1

    def at(self, t, i=None):
        """The quaternion, and the angular velocity in the world frame."""
        i = self.segment_at(t) if i is None else i
        h = self.times[i + 1] - self.times[i]
        f, e = self.keys[i][3][1], self.keys[(i + 1) % len(self.keys)][3][0]
        if f + e > 1:
            f, e = f / (f + e), e / (f + e)
        w, rate, _ = warp(f, e, (t - self.times[i]) / h)
        q = self.value(i, w)
        slope = [(y - x) / (2 * step) for x, y in zip(self.value(i, w - step), self.value(i, w + step))]
        return q, scaled(product(slope, conjugate(q))[1:], 2 * rate / h)

    def beyond(self, how, t):
        """The quaternion outside the keys."""
        first, last = self.times[0], self.times[-1]
        if how in ("hold", "linear"):
            end = first if t < first else last
            q, velocity = self.at(end)
            return q if how == "hold" else product(exp(scaled(velocity, (t - end) / 2)), q)
        cycle = int(mpmath.floor((t - first) / (last - first)))
        place = t - cycle * (last - first)
        if how == "oscillate" and cycle % 2:
            place = last - (place - first)
        q = self.at(place)[0]
        if how == "offset":
            whole = product(self.quaternions[-1], conjugate(self.quaternions[0]))
            for _ in range(abs(cycle)):
                q = product(whole if cycle > 0 else conjugate(whole), q)
        return q
