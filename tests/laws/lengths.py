"""Golden rows by arc length are those of a quadrature of its own, in 70 digits: times, lengths and positions at --arc-at,
--arc-count and --arc-step. All rules and ends, closed curves, ease, equal speeds, rests, cusps, tension 1 and next to it,
sizes from 1e-200 to 1e200, lengths at keys, next to them and next to 0, and 1 to 40 digits; each number is rounded once."""
import math
from fractions import Fraction

from curves import MeasuredCurve, norm
from keys import ENDS, RULES
from law import check, lines, require, same
from mpmath import mp, mpf

mp.dps = 70
BITS, POINTS = 240, 40
SMALL = mpf(10) ** -48  # more than the error of what is computed here, in parts of the terms


def gauss_rule():
    """The nodes on [-1, 1] and the weights, as whole numbers of 2^-BITS."""
    rule = []
    with mp.workdps(90):
        for i in range(POINTS):
            x = mp.cos(mp.pi * (i + mpf(3) / 4) / (POINTS + mpf(1) / 2))
            for _ in range(8):
                before, value = mpf(1), x
                for k in range(2, POINTS + 1):
                    before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
                slope = POINTS * (x * value - before) / (x * x - 1)
                x -= value / slope
            rule.append((int(mp.ldexp(x, BITS)), int(mp.ldexp(2 / ((1 - x * x) * slope * slope), BITS))))
    return rule


RULE = gauss_rule()


class Lengths:
    """The lengths of one segment."""

    def __init__(self, cubic):
        self.velocity = [(b, 2 * c, 3 * d) for _, b, c, d in cubic]
        self.panels, self.total = [], mpf(0)  # (from, to, the length before it)
        cuts = self.slowest()
        self.scale = sum(self.rule(a, b) for a, b in zip(cuts, cuts[1:]))
        if self.scale == 0:
            return
        for a, b in zip(cuts, cuts[1:]):
            self.add(a, b, self.rule(a, b), 260)

    def slowest(self):
        """0, 1, and the minima of the speed between them."""
        slope = [mpf(0)] * 4  # a half of the derivative of its square
        for x, y, z in self.velocity:
            for i, value in enumerate((x * y, y * y + 2 * x * z, 3 * y * z, 2 * z * z)):
                slope[i] += value
        size = max(map(abs, slope))
        while slope and abs(slope[-1]) <= size * mpf(10) ** -60:
            slope.pop()
        roots = mp.polyroots(slope[::-1], maxsteps=500, extraprec=400) if len(slope) > 1 else []
        places = {z.real for z in roots if 0 < z.real < 1 and abs(z.imag) < mpf(10) ** -20}
        return [mpf(0), *sorted(places), mpf(1)]

    def speed(self, u):
        return norm([x + u * (y + u * z) for x, y, z in self.velocity])

    def rule(self, a, b):
        """The length over [a, b] by one rule, in whole numbers of the largest coefficient."""
        m, h = (a + b) / 2, (b - a) / 2
        q = [mpf(0)] * 5
        for x, y, z in self.velocity:
            v = (x + m * (y + m * z), h * (y + 2 * m * z), h * h * z)
            for i in range(3):
                for j in range(3):
                    q[i + j] += v[i] * v[j]
        largest = max(map(abs, q))
        if largest == 0:
            return mpf(0)
        exponent = mp.frexp(largest)[1]
        exponent += exponent % 2
        q0, q1, q2, q3, q4 = (int(mp.ldexp(c, BITS - exponent)) for c in q)
        total = 0
        for z, weight in RULE:
            square = q0 + (z * (q1 + (z * (q2 + (z * (q3 + (z * q4 >> BITS)) >> BITS)) >> BITS)) >> BITS)
            total += weight * math.isqrt(max(square, 0) << BITS)
        return mp.ldexp(mpf(total), exponent // 2 - 2 * BITS) * h

    def add(self, a, b, whole, halvings):
        m = (a + b) / 2
        left, right = self.rule(a, m), self.rule(m, b)
        if halvings == 0 or abs(left + right - whole) < self.scale * mpf(10) ** -54:
            self.panels.append((a, b, self.total))
            self.total += left + right
        else:
            self.add(a, m, left, halvings - 1)
            self.add(m, b, right, halvings - 1)

    def place(self, s):
        """Where the length from the start is s: by Newton's method on the logarithms, which meets powers at once."""
        first = max(i for i, (_, _, before) in enumerate(self.panels) if i == 0 or before <= s)
        a, b, before = self.panels[first]
        low, high, into = mpf(0), b - a, s - before
        x = high * min(into / self.rule(a, b), 1) if into else mpf(0)
        for _ in range(400):
            if x == 0:
                break
            length, speed = self.rule(a, a + x), self.speed(a + x)
            low, high = (x, high) if length < into else (low, x)
            new = x * (into / length) ** (length / (x * speed)) if speed and length else (low + high) / 2
            if not low <= new <= high:
                new = (low + high) / 2
            if abs(new - x) <= x * mpf(10) ** -60:
                return a + new
            x = new
        return a + x


def fraction(x):
    sign, man, exp, _ = x._mpf_
    return (-1 if sign else 1) * Fraction(int(man)) * Fraction(2) ** exp


def rounded(value, digits):
    """As it is printed: the nearest double, or a decimal of so many digits."""
    if digits is None:
        return Fraction(float(value))
    if value == 0:
        return value
    exponent = len(str(abs(value.numerator))) - len(str(value.denominator))
    if abs(value) < Fraction(10) ** exponent:
        exponent -= 1
    unit = Fraction(10) ** (exponent - digits + 1)
    return round(value / unit) * unit


def random_keys(rng):
    channels, n = rng.choice([1, 2, 2, 3]), rng.choice([2, 3, 3, 4, 5])
    shape = rng.choice(["plain", "whole", "wide", "line", "rests", "tense"])
    size, pace = (10.0 ** rng.choice([0, 0, 0, rng.randint(-200, 200)]) for _ in range(2))
    pace = 10.0 ** rng.choice([0, 0, 0, rng.randint(-12, 12)])
    corners = [[0.0, 0.0, 0.0], [3.0, 4.0, 0.0], [3.0, 0.0, 0.0], [8.0, 12.0, 0.0], [0.0, 12.0, 9.0]]
    along = [rng.uniform(-1, 1) for _ in range(channels)]
    tense = shape == "tense" or (shape in ("whole", "line", "rests") and rng.random() < 0.5)
    keys, t = [], rng.choice([0.0, 0.0, rng.uniform(-9, 9)]) * pace
    for i in range(n):
        p = [rng.uniform(-1, 1) * size * (10.0 ** rng.randint(-9, 9) if shape == "wide" else 1) for _ in range(channels)]
        if shape == "whole":
            p = [x if channels > 1 else float(rng.randint(-9, 9)) for x in corners[rng.randrange(5)][:channels]]
        if shape == "line":
            p = [x * size * (i if rng.random() < 0.7 else rng.randint(-3, 9)) for x in along]
        if shape == "rests" and i and rng.random() < 0.5:
            p = list(keys[-1][1])
        tcb = [0.0, 0.0, 0.0] if shape == "plain" else [rng.choice([0.0, 0.0, rng.uniform(-1, 1)]) for _ in range(3)]
        if tense:
            tcb[0] = rng.choice([1.0, 1.0, 1.0, 1 - 1e-13, 1 - 1e-5])
        keys.append((t, p, tcb))
        t += rng.choice([1.0, rng.uniform(0.05, 2)]) * pace
    return keys, t


def near(rng, s):
    """The text of a length, or of one next to it."""
    digits = rng.choice([17, 17, 25, 45])
    text = mp.nstr(s, digits, min_fixed=0, max_fixed=0)
    return repr(math.nextafter(float(text), rng.choice([0, math.inf]))) if rng.random() < 0.2 else text


def by_length(rng):
    keys, back = random_keys(rng)
    channels = len(keys[0][1])
    eased, closed = rng.random() < 0.2, rng.random() < 0.25 and len(keys) > 2
    equal, decimal = rng.random() < 0.2, rng.random() < 0.3
    rule, ends = rng.choice(RULES), [rng.choice(ENDS), rng.choice(ENDS)]
    velocity = [rng.uniform(-3, 3) for _ in range(channels)]
    eases = [[rng.choice([0.0, 0.5, rng.random()]) for _ in range(2)] if eased else [0.0, 0.0] for _ in keys]
    if closed and keys[0][1] == keys[-1][1]:
        return
    number_of = (lambda x: mpf(repr(x))) if decimal else mpf
    exact = [(number_of(t), [*map(number_of, p)], [*map(number_of, tcb)], [*map(number_of, ease)])
             for (t, p, tcb), ease in zip(keys, eases)]
    period = number_of(back) - exact[0][0] if closed else None
    curve = MeasuredCurve(exact, rule, ends, period, [*map(number_of, velocity)], equal=equal)
    options = ["--tangents", rule]
    if closed:
        keys.append((back, *keys[0][1:]))
        eases.append(eases[0])
        options.append("--closed")
    else:
        spelled = [e + ("=" + ":".join(map(repr, velocity)) if e == "velocity" else "") for e in ends]
        options += ["--ends", ",".join(spelled)]
    options += ["--equal-speed"] * equal + ["--exact-input"] * decimal
    digits = rng.choice([None, None, None, 1, 5, 15, 17, 20, 30, 40])
    options += ["--digits", str(digits)] if digits else []
    text = ",".join(["t", *"xyz"[:channels], "tension", "continuity", "bias"] + ["ease_in", "ease_out"] * eased) + "\n"
    for (t, p, tcb), ease in zip(keys, eases):
        text += ",".join(map(repr, [t, *p, *tcb, *(ease if eased else [])])) + "\n"

    lengths = [Lengths(cubic) for cubic in curve.cubics]
    starts = [mpf(0)]
    for one in lengths:
        starts.append(starts[-1] + one.total)
    total = starts[-1]
    if total == 0 or float(total) == 0 or math.isinf(float(total)):
        return
    mode = rng.choice(["at", "at", "count", "step"])
    if mode == "count":
        count = rng.choice([2, 3, 5, 8, len(keys)])
        arguments = ["--arc-count", str(count)]
        places = [total * j / (count if closed else count - 1) for j in range(count)]
    elif mode == "step":
        step = repr(float(total) / rng.uniform(1, 9))
        arguments = ["--arc-step", step]
        places = [mpf(step) * j for j in range(int(total / mpf(step)) + 1)]
    else:
        texts = [rng.choice([repr(rng.random() * float(total)), near(rng, rng.choice(starts)), "0", "5e-324",
                             repr(float(total) * 10.0 ** rng.randint(-40, -1))]) for _ in range(10)]
        longest = fraction(total * (1 - mpf(2) ** -50))  # the length of plain rows has an error
        texts = [x for x in texts if Fraction(x) <= longest] or ["0"]
        arguments = ["--arc-at", ",".join(texts)]
        places = [mpf(Fraction(x).numerator) / Fraction(x).denominator for x in texts]
    rows = lines(text, "--golden", *options, *arguments, "--fields", "time,s,position")
    same(len(rows), len(places), "rows")
    for row, s in zip(rows, places):
        i = 0  # at a key, the earliest time of its length
        while i + 1 < len(lengths) and s > starts[i + 1] * (1 + SMALL):
            i += 1
        is_last = mode == "count" and not closed and s is places[-1] and s != 0
        if is_last:  # the last of a count is at the last key, or at the earliest one of the same length
            i, w = max(k for k, one in enumerate(lengths) if one.total != 0), mpf(1)
        elif s == 0 or lengths[i].total == 0:
            w = mpf(0)
        else:
            w = mpf(1) if s >= starts[i + 1] * (1 - SMALL) else lengths[i].place(s - starts[i])
        passed, h = curve.unwarp(i, w), curve.times[i + 1] - curve.times[i]
        off = mpf(0)  # of the place: the error of the length over the speed, or less where the curve nearly rests
        if w not in (0, 1):
            speed, change = lengths[i].speed(w), norm([2 * (c + 3 * d * w) for _, _, c, d in curve.cubics[i]])
            off = min(SMALL * s / speed if speed else mpf(1), mp.sqrt(2 * SMALL * s / change) if change else mpf(1))
        off_time = max(off, abs(curve.unwarp(i, min(w + off, 1)) - passed))
        wanted = [(curve.times[i] + passed * h, SMALL * (abs(curve.times[i]) + passed * h) + off_time * h), (s, SMALL * s)]
        for p, b, c, d in curve.cubics[i]:
            terms = abs(b) + w * (abs(c) + w * abs(d))
            wanted.append((p + w * (b + w * (c + w * d)), SMALL * (abs(p) + w * terms) + off * (terms + abs(d))))
        for cell, (value, doubt) in zip(row, wanted, strict=True):
            low, high = (rounded(fraction(value + x), digits) for x in (-doubt, doubt))
            shown = Fraction(cell) if digits else Fraction(float(cell))
            require(low <= shown <= high, f"{','.join(row)}: {cell}, expected {mp.nstr(value, 45)}")


check(by_length, 10, least=10)
