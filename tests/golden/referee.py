"""Rows of --golden against arithmetic of 60 digits: referee.py PROGRAM [CURVES].

Resamples random keys with --golden, and computes every number again with mpmath, by an independent implementation of
the formulas, those of the segments in cubics.py. No bit may differ. Exit 77: there is no mpmath.
"""
import random
import subprocess
import sys

sys.dont_write_bytecode = True
from cubics import Cubics

try:
    import mpmath
    from mpmath import mpf, mp
except ImportError:
    print("skipped: there is no python3-mpmath")
    sys.exit(77)

mp.dps = 60
as_script = __name__ == "__main__"  # other tests import Curve
program = sys.argv[1] if as_script else None
curves = 0 if not as_script else int(sys.argv[2]) if len(sys.argv) > 2 else 40
rng = random.Random(20260101)
half = mpf(1) / 2


def norm(v):
    return mpmath.sqrt(sum(x * x for x in v))


class Curve(Cubics):
    """Keys are (time, position, (T, C, B), (ease_in, ease_out))."""

    def __init__(self, keys, rule, ends, closed=None, equal=False, velocity=None, exponent=None):
        times = [k[0] for k in keys]
        if exponent is not None:
            times = [mpf(0)]
            for a, b in zip(keys, keys[1:]):
                times.append(times[-1] + norm([y - x for x, y in zip(a[1], b[1])]) ** exponent)
        super().__init__(times, keys, rule, ends, closed, velocity, norm if equal else None)
        self.warps, self.lengths = [], {}
        for i in range(len(self.cubics)):
            f, e = keys[i][3][1], keys[(i + 1) % len(keys)][3][0]
            if f + e > 1:
                f, e = f / (f + e), e / (f + e)
            self.warps.append((f, e))

    def warp(self, i, u):
        """The warped u, and its first and second derivative."""
        f, e = self.warps[i]
        if f + e == 0:
            return u, mpf(1), mpf(0)
        k = 1 / (2 - f - e)
        if u < f or f == 1:
            return k / f * u * u, 2 * k / f * u, 2 * k / f
        if u < 1 - e or e == 0:
            return k * (2 * u - f), 2 * k, mpf(0)
        return 1 - k / e * (1 - u) ** 2, 2 * k / e * (1 - u), -2 * k / e

    def unwarp(self, i, w):
        f, e = self.warps[i]
        if f + e == 0:
            return w
        k = 1 / (2 - f - e)
        if w < k * f:
            return mpmath.sqrt(w * f / k)
        if w < 1 - k * e:
            return half * (w / k + f)
        return 1 - mpmath.sqrt((1 - w) * e / k)

    def segment_at(self, t):
        for i in range(len(self.cubics) - 1):
            if t < self.times[i + 1]:
                return i
        return len(self.cubics) - 1

    def derivative_square(self, i):
        q = [mpf(0)] * 5
        for _, b, c, d in self.cubics[i]:
            v = (b, 2 * c, 3 * d)
            for j in range(3):
                for k in range(3):
                    q[j + k] += v[j] * v[k]
        return q

    def cuts(self, i):
        """0, 1, and the minima of the speed between them."""
        q = self.derivative_square(i)
        slope = [k * q[k] for k in range(4, 0, -1)]
        while slope and slope[0] == 0:
            slope.pop(0)
        places = []
        if len(slope) > 1:
            with mp.workdps(90):
                places = [z.real for z in mpmath.polyroots(slope, maxsteps=500, extraprec=400)]
        return [mpf(0)] + sorted(z for z in places if 0 < z < 1) + [mpf(1)]

    def length(self, i, u=None):
        """From the start of a segment to u."""
        if u is None:
            if i not in self.lengths:
                self.lengths[i] = self.length(i, mpf(1))
            return self.lengths[i]
        q = self.derivative_square(i)
        cuts = [z for z in self.cuts(i) if z < u] + [u]
        def speed(z):
            return norm([b + z * (2 * c + z * 3 * d) for _, b, c, d in self.cubics[i]])
        total = mpf(0)
        for a, b in zip(cuts, cuts[1:]):
            m = (a + b) / 2
            for lo, hi in ((a, m), (m, b)):
                total += mpmath.quad(speed, [lo, hi], maxdegree=9)
        return total

    def place_at(self, s):
        """(segment, u) where the curve has the length s."""
        i = 0
        while i + 1 < len(self.cubics) and s > self.length(i):
            s -= self.length(i)
            i += 1
        low, high, u, at, base = mpf(0), mpf(1), s / self.length(i), mpf(0), mpf(0)
        for _ in range(200):
            value = self.length(i, u) - s
            speed = norm([b + u * (2 * c + u * 3 * d) for _, b, c, d in self.cubics[i]])
            if value > 0:
                high = u
            else:
                low = u
            new = u - value / speed if speed != 0 else (low + high) / 2
            if not low < new < high:
                new = (low + high) / 2
            if abs(new - u) < mpf(10) ** -55:
                return i, new
            u = new
        return i, u

    def row(self, fields, i, passed, w, t, s=None):
        _, w1, w2 = self.warp(i, passed)
        h = self.times[i + 1] - self.times[i]
        rate, bend = w1 / h, w2 / h ** 2
        x, v, a, j = [], [], [], []
        for p, b, c, d in self.cubics[i]:
            d1, d2, d3 = b + w * (2 * c + w * 3 * d), 2 * c + 6 * d * w, 6 * d
            x.append(p + w * (b + w * (c + w * d)))
            v.append(d1 * rate)
            a.append(d2 * rate ** 2 + d1 * bend)
            j.append(d3 * rate ** 3 + 3 * d2 * rate * bend)
        tiny = mpf(10) ** -40
        size = max([abs(z) for cubic in self.cubics[i] for z in cubic]) / h
        moves = norm(v) > tiny * size
        minors = [v[p] * a[q] - v[q] * a[p] for p in range(len(v)) for q in range(p + 1, len(v))]
        area = norm(minors)
        bends = moves and area > tiny * norm(v) * (norm(a) + size)
        for field in fields:
            if field == "time":
                yield t
            elif field == "position":
                yield from x
            elif field == "velocity":
                yield from v
            elif field == "acceleration":
                yield from a
            elif field == "jerk":
                yield from j
            elif field == "speed":
                yield norm(v)
            elif field == "tangent":
                yield from [z / norm(v) if moves else None for z in v]
            elif field == "curvature":
                yield None if not moves else area / norm(v) ** 3 if bends else mpf(0)
            elif field == "torsion":
                if not bends:
                    yield None
                elif len(v) < 3:
                    yield mpf(0)
                else:
                    det = (v[0] * (a[1] * j[2] - a[2] * j[1]) - v[1] * (a[0] * j[2] - a[2] * j[0])
                           + v[2] * (a[0] * j[1] - a[1] * j[0]))
                    yield det / area ** 2
            elif field == "u":
                yield passed
            elif field == "segment":
                yield mpf(i)
            elif field == "s":
                yield s if s is not None else sum((self.length(k) for k in range(i)), mpf(0)) + self.length(i, w)


def text(x):
    return repr(x) if isinstance(x, float) else str(x)


def random_keys(channels, n, style):
    t, keys = rng.choice([0.0, rng.uniform(-9, 9), 1e6 * rng.random()]), []
    for _ in range(n):
        p = [rng.uniform(-10, 10) if style != "short" else rng.randint(-99, 99) / 10 for _ in range(channels)]
        tcb = [rng.choice([0.0, 0.0, rng.uniform(-1, 1), 1.0, -1.0]) for _ in range(3)] if style != "plain" else [0.0] * 3
        ease = [rng.choice([0.0, rng.random() * 0.9]) for _ in range(2)] if style == "ease" else [0.0, 0.0]
        keys.append((t, p, tcb, ease))
        t += rng.choice([1.0, rng.uniform(0.01, 3)])
    return keys


def write(keys, style, timed=True):
    channels = len(keys[0][1])
    parameters = ["tension", "continuity", "bias"]
    axes = ["x", "y", "z"][:channels]
    names = (["t"] if timed else []) + axes + parameters
    if style == "ease":
        names += ["ease_in", "ease_out"]
    # Channels may have columns of their own, which the common ones do not change.
    own = [i for i in range(3) if style == "own" and rng.random() < 0.7]
    names += [f"{parameters[i]}_{axis}" for i in own for axis in axes]
    lines = [",".join(names)]
    for t, p, tcb, ease in keys:
        common = [0.375 if i in own else tcb[i] for i in range(3)]
        cells = ([t] if timed else []) + p + common + (ease if style == "ease" else [])
        lines.append(",".join(map(text, cells + [tcb[i] for i in own for _ in axes])))
    return "\n".join(lines) + "\n"


def run(keys_text, options):
    done = subprocess.run([program, "--golden", "--no-output-header", *options], input=keys_text, text=True,
                          capture_output=True)
    if done.returncode != 0:
        sys.exit(f"{options}: {done.stderr}")
    return [[float(cell) if cell else None for cell in line.split(",")] for line in done.stdout.splitlines()]


compared = differ = 0


def compare(got, want, what):
    global compared, differ
    for g, w in zip(got, want, strict=True):
        w = None if w is None else 0.0 if abs(w) < mpf(10) ** -40 else float(w)  # what 60 digits leave of zero
        compared += 1
        if g != w:
            differ += 1
            if differ < 20:
                print(f"{what}: {g!r}, expected {w!r}", file=sys.stderr)


rules = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig", "linear"]
end_rules = ["half", "one-sided", "mirror", "chord", "zero", "natural", "natural-tension", "cry", "lightwave", "velocity"]
local = ["time", "position", "velocity", "acceleration", "jerk", "speed", "tangent", "curvature", "torsion", "u", "segment"]
exact = lambda x: mpf(x)


def made(keys, number, dec=exact):
    return [(dec(t), list(map(dec, p)), list(map(dec, tcb)), list(map(dec, e))) for t, p, tcb, e in keys]


for number in range(curves):
    channels = rng.choice([1, 2, 3, 3])
    style = rng.choice(["plain", "tcb", "short", "ease", "own"])
    keys = random_keys(channels, rng.choice([2, 3, 4, 6, 9]), style)
    rule, ends = rng.choice(rules), [rng.choice(end_rules), rng.choice(end_rules)]
    velocity = [rng.uniform(-3, 3) for _ in range(channels)]
    equal, closed = rng.random() < 0.25 and rule != "linear", rng.random() < 0.25 and len(keys) > 2
    timed = rng.random() < 0.8
    exponent = None
    options = ["--tangents", rule]
    if equal:
        options.append("--equal-speed")
    period = None
    decimal = timed and rng.random() < 0.3
    number_of = (lambda x: mpf(text(x))) if decimal else exact
    if decimal:
        options.append("--exact-input")
    if not timed:
        keys = [(float(i), *k[1:]) for i, k in enumerate(keys)]
        name, exponent = rng.choice([("chordal", 1), ("centripetal", half), (None, None), ("0.75", mpf(3) / 4)])
        closed = False
        if name:
            options += ["--parameter", name]
    if closed:
        last = keys[-1][0] - keys[0][0] + 1.25
        keys.append((keys[0][0] + last, keys[0][1], keys[0][2], keys[0][3]))
        period = number_of(keys[-1][0]) - number_of(keys[0][0])
        options.append("--closed")
    elif rule != "linear":
        spelled = [e + ("=" + ":".join(map(text, velocity)) if e == "velocity" else "") for e in ends]
        options += ["--ends", ",".join(spelled)]
    curve = Curve(made(keys[:-1] if closed else keys, number, number_of), rule, ends, period, equal,
                  list(map(number_of, velocity)), exponent)
    fields = ["time", "position", "s", "segment"] if number % 8 == 7 else local
    count = 7 if "s" in fields else 101
    rows = run(write(keys, style, timed), [*options, "--count", str(count), "--fields", ",".join(fields)])
    for j, row in enumerate(rows):
        # With exact input, times are exact until they are printed; else rows are at the printed times.
        intervals = count if closed else count - 1
        exact_time = curve.times[0] + (curve.times[-1] - curve.times[0]) * j / intervals
        t = exact_time if decimal else number_of(row[0])
        i = min(int(row[-1]), len(curve.cubics) - 1)
        if exponent is not None and j + 1 == len(rows):
            t = curve.times[-1]  # the last row is the last key
        passed = (t - curve.times[i]) / (curve.times[i + 1] - curve.times[i])
        want = list(curve.row(fields, i, passed, curve.warp(i, passed)[0], t))
        compare(row, want, f"curve {number} {options} row {j}")
    if number % 4 != 1:
        continue
    s_text = text(round(rng.uniform(0.1, 0.9) * float(curve.length(0)), 3))
    fields = ["s", "time", "position", "velocity", "speed", "u", "segment"]
    places = [mpf(s_text), mpf(s_text) / 3, mpf(s_text) * half]
    rows = run(write(keys, style, timed), [*options, "--arc-at", f"{s_text},{s_text}/3,{s_text}/2", "--fields", ",".join(fields)])
    for row, s in zip(rows, places, strict=True):
        i, w = curve.place_at(s)
        passed = curve.unwarp(i, w)
        t = curve.times[i] + passed * (curve.times[i + 1] - curve.times[i])
        compare(row, list(curve.row(fields, i, passed, w, t, s)), f"curve {number} {options} at length {s_text}")

if as_script:
    print(f"{compared} values, {differ} differ")
    sys.exit(1 if differ else 0)
