"""The segments of a curve by the formulas of the rules, at any exact number: fractions, or floats of many digits."""


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


class Cubics:
    """The cubic (p, b, c, d) of each channel of each segment, p + b u + c u^2 + d u^3.

    Keys are (any, position, (T, C, B), ...); `closed` is the period; `norm`: for equal speeds.
    """

    def __init__(self, times, keys, rule, ends, closed=None, velocity=None, norm=None):
        if rule == "linear":
            ends, norm = ("chord", "chord"), None
        self.closed = closed is not None
        self.size = n = len(keys)
        self.keys, self.times = keys, times + ([times[0] + closed] if self.closed else [])
        position = lambda i: keys[i % n][1]
        chord = lambda i: [y - x for x, y in zip(position(i), position(i + 1))]
        step = lambda i: self.times[(i % n) + 1] - self.times[i % n] if self.closed else self.times[i + 1] - self.times[i]
        ins, outs = {}, {}
        for i in range(n):
            if not self.closed and i in (0, n - 1):
                continue
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
        self.cubics = []
        for i in range(n if self.closed else n - 1):
            k = (i + 1) % n
            self.cubics.append([(p, o, 3 * (q - p) - 2 * o - m, -2 * (q - p) + o + m)
                                for p, q, o, m in zip(position(i), position(k), outs[i], ins[k])])
