"""--limits and --retime against Sturm sequences of fractions: limits.py PROGRAM [CURVES] [SEED].

Random curves by all rules: cusps, corners, tension 1, |T|, |C|, |B| to 8, closed curves, ease, equal speeds, groups,
channels with keys of their own, sizes from 1e-100 to 1e100. The maximum that is printed is attained, its bound is not
exceeded, and they differ by one unit of the last digit at most. With scaled times the tightest limit is met within
1e-12, by the pieces that are printed, or with ease by the factor.
Exit 1: a number is wrong, and its command is printed.
"""
import json
import math
import random
import subprocess
import sys
from fractions import Fraction as F

sys.dont_write_bytecode = True
from cubics import Cubics

program = sys.argv[1]
curves = int(sys.argv[2]) if len(sys.argv) > 2 else 20
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
rules = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]
end_rules = ["half", "one-sided", "mirror", "chord", "zero", "natural", "natural-tension", "cry", "lightwave", "velocity"]
orders = {"position": 0, "velocity": 1, "speed": 1, "acceleration": 2, "jerk": 3, "curvature": 0}


def add(a, b):
    n = max(len(a), len(b))
    return [(a[i] if i < len(a) else 0) + (b[i] if i < len(b) else 0) for i in range(n)]


def times(a, b):
    r = [F(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            r[i + j] += x * y
    return r


def compose(outer, inner):
    r = [outer[-1]]
    for c in reversed(outer[:-1]):
        r = times(r, inner)
        r[0] += c
    return r


def derive(a):
    return [i * a[i] for i in range(1, len(a))] or [F(0)]


def trim(a):
    a = list(a)
    while len(a) > 1 and a[-1] == 0:
        a.pop()
    return a


def value(a, x):
    r = F(0)
    for c in reversed(a):
        r = r * x + c
    return r


def divide(a, b):
    """Quotient and remainder."""
    a, q = list(a), []
    while len(a) >= len(b):
        q.append(F(a[-1]) / b[-1])
        for i in range(len(b)):
            a[len(a) - len(b) + i] -= q[-1] * b[i]
        a.pop()
    return q[::-1] or [F(0)], trim(a or [F(0)])


def whole(a):
    """a times a positive number, with whole coefficients."""
    scale = math.lcm(*(F(c).denominator for c in a))
    numbers = [int(c * scale) for c in a]
    divisor = math.gcd(*numbers) or 1
    return [c // divisor for c in numbers]


def remainder(a, b):
    """A positive multiple of the remainder, for whole coefficients."""
    a, lead = list(a), b[-1]
    while len(a) >= len(b):
        top = a.pop() * (1 if lead > 0 else -1)
        a = [abs(lead) * c for c in a]
        for i in range(len(b) - 1):
            a[len(a) - len(b) + 1 + i] -= top * b[i]
    return trim(a or [0])


def sturm(p):
    chain = [whole(p), whole(trim(derive(p)))]
    while len(chain[-1]) > 1:
        r = remainder(chain[-2], chain[-1])
        if not any(r):
            break
        chain.append(whole([-c for c in r]))
    return chain


def changes(chain, x):
    signs = [s for s in (value(p, x) for p in chain) if s != 0]
    return sum((a < 0) != (b < 0) for a, b in zip(signs, signs[1:]))


def roots(p, bits=80):
    """Points within 2^-bits of each root in (0, 1)."""
    p = trim(p)
    if len(p) < 2:
        return
    chain = sturm(p)
    if len(chain[-1]) > 1:  # roots that are multiple become single
        chain = sturm(trim(divide(p, chain[-1])[0]))
    todo = [(F(0), F(1), changes(chain, F(0)), changes(chain, F(1)))]
    while todo:
        a, b, at_a, at_b = todo.pop()
        if at_a == at_b:
            continue
        if at_a - at_b == 1:
            if value(chain[0], b) == 0:
                yield b
                continue
            falls = value(chain[0], b) < 0
            for _ in range(bits):
                m = (a + b) / 2
                y = value(chain[0], m)
                if y == 0:
                    a = b = m
                    break
                a, b = (a, m) if (y < 0) == falls else (m, b)
            yield (a + b) / 2
            continue
        m = (a + b) / 2
        at_m = changes(chain, m)
        todo += [(a, m, at_a, at_m), (m, b, at_m, at_b)]


def common(a, b):
    """The common divisor of the largest degree."""
    a, b = trim(list(a)), trim(list(b))
    while any(b):
        a, b = b, trim(divide(a, b)[1])
    return a


def largest(over, under):
    """The largest value on [0, 1]."""
    slope = trim(add(times(derive(over), under), [-x for x in times(over, derive(under))]))
    places = [F(0), F(1), *roots(slope)]
    if any(value(under, x) < F(1, 2 ** 100) * sum(abs(c) for c in under) for x in places):  # values change fast there
        places = [F(0), F(1), *roots(slope, 600)]
    return max(value(over, x) / value(under, x) for x in places)


def rests(velocity):
    """Whether all components of a velocity are 0 at the same place of [0, 1]."""
    shared = [F(0)]
    for x in velocity:
        shared = common(shared, x)
    return value(shared, F(0)) == 0 or value(shared, F(1)) == 0 or any(True for _ in roots(shared))


def pieces(cubics, eases, steps):
    """(begin, duration, polynomials over time, polynomials over u) of each part."""
    begin = F(0)
    for segment, (e, f), h in zip(cubics, eases, steps):
        if f + e > 1:
            f, e = f / (f + e), e / (f + e)
        parts = [(F(1), [F(0), F(1)])]
        if f or e:
            k = 1 / (2 - f - e)
            parts = [(f, [0, 0, k * f]), (1 - f - e, [k * f, 2 * k * (1 - f - e)]), (e, [1 - k * e, 2 * k * e, -k * e])]
        for size, warp in parts:
            if size:
                yield h * size, [compose(list(x), [F(c) for c in warp]) for x in segment], [list(x) for x in segment]


def squares(vectors):
    total = [F(0)]
    for x in vectors:
        total = add(total, times(x, x))
    return total


def heading(velocity, end):
    """The direction of a path at an end of a part, from the first derivative that is not 0, and how many are 0."""
    for order in range(3):
        vector = [value(v, F(end)) * (-1 if end and order % 2 else 1) for v in velocity]
        if any(vector):
            return vector, order
        velocity = [derive(v) for v in velocity]
    return None, 3


def turns_at_rest(parts, channels, closed):
    """Whether the path has a corner at a key at which it rests."""
    velocities = [[derive(by_u[c]) for c in channels] for _, _, by_u in parts]
    pairs = list(zip(velocities, velocities[1:] + velocities[:1] if closed else velocities[1:]))
    for before, after in pairs:
        (a, m), (b, n) = heading(before, 1), heading(after, 0)
        if a is None or b is None or m == n == 0 or before == after:
            continue
        dot = lambda x, y: sum(p * q for p, q in zip(x, y))
        if dot(a, a) * dot(b, b) - dot(a, b) ** 2 > F(1, 2 ** 80) * dot(a, a) * dot(b, b):
            return True
    return False


def exact_maximum(parts, name, kind, channels, closed=False):
    """Of a size its square, of a minimum its negative."""
    order = orders[name.split("_")[0]]
    best = None
    if name == "curvature" and turns_at_rest(parts, channels, closed):
        return None
    for duration, by_time, by_u in parts:
        if name == "curvature":
            v = [derive(by_u[c]) for c in channels]
            crosses = [add(times(v[i], derive(v[j])), [-x for x in times(derive(v[i]), v[j])])
                       for i in channels for j in channels if i < j]
            over, s = trim(squares(crosses)), squares(v)
            if any(over) and rests(v):
                return None
            found = largest(over, trim(times(times(s, s), s))) if any(over) else F(0)
        else:
            vectors = []
            for c in channels:
                p = by_time[c]
                for _ in range(order):
                    p = derive(p)
                vectors.append([x / duration ** order for x in p])
            over = squares(vectors) if kind == "size" else [x if kind == "maximum" else -x for x in vectors[0]]
            found = largest(trim(over), [F(1)])
        best = found if best is None else max(best, found)
    return best


def unit(*texts):
    """One unit of the last digit of decimals, which may have lost zeros at their ends."""
    def last(text):
        mantissa, _, exponent = text.lower().partition("e")
        return int(exponent or 0) - len(mantissa.partition(".")[2])
    return F(10) ** min(map(last, texts))


def random_curve():
    channels, closed = rng.randint(1, 3), rng.random() < 0.3
    n = rng.randint(3 if closed else 2, 6)
    size = 10.0 ** rng.choice([0, 0, 0, rng.randint(-100, 100)])
    pace = 10.0 ** rng.choice([0, 0, 0, rng.randint(-8, 8)])
    is_whole, eased = rng.random() < 0.3, rng.random() < 0.25
    kind = rng.choice(["plain", "tcb", "large", "tense", "cusp"])
    reach = {"plain": 0, "tcb": 1, "large": 8, "tense": 1, "cusp": 1}[kind]
    keys, t = [], 0.0
    for i in range(n):
        p = [float(rng.randint(-5, 5)) if is_whole else rng.uniform(-1, 1) * size for _ in range(channels)]
        if kind == "cusp" and i and rng.random() < 0.4:
            p = list(keys[-1][1])
        tcb = [rng.uniform(-reach, reach) for _ in range(3)]
        if is_whole:
            tcb = [float(round(x)) for x in tcb]
        if kind == "tense" and rng.random() < 0.6:
            tcb[0] = 1.0
        ease = [rng.choice([0.0, 0.25, 0.5, 1.0, rng.random()]) for _ in range(2)] if eased else [0.0, 0.0]
        keys.append((t, p, tcb, ease))
        t += (1.0 if is_whole else rng.uniform(0.05, 2)) * pace
    if closed and keys[-1][1] == keys[0][1]:  # it would be the end of the period
        keys[-1][1][0] += 1.0 if is_whole else size
    return keys, t if closed else None, eased, kind


def norm(vector):
    """The length of a vector of fractions, to 300 bits."""
    square = sum(x * x for x in vector)
    if square == 0:
        return F(0)
    shift = 2 * (300 + (square.denominator.bit_length() - square.numerator.bit_length()) // 2)
    scaled = square * F(2) ** shift
    return F(math.isqrt(scaled.numerator // scaled.denominator)) / F(2) ** (shift // 2)


def exact_parts(keys, key_times, rule, ends, period, velocity, equal=False):
    of = lambda numbers: [F(x) for x in numbers]
    stamps = of(key_times)
    end = None if period is None else F(period)
    curve = Cubics(stamps, [(0, of(p), of(tcb)) for _, p, tcb, _ in keys], rule, ends, end, of(velocity),
                   norm if equal else None)
    stops = curve.times
    eases = [(F(keys[(i + 1) % len(keys)][3][0]), F(keys[i][3][1])) for i in range(len(curve.cubics))]
    return list(pieces(curve.cubics, eases, [b - a for a, b in zip(stops, stops[1:])]))


def sparse_parts(keys, rule, ends, velocity):
    """Of channels that have keys of their own, and are constant around them."""
    stops = [F(key[0]) for key in keys]
    curves = []
    for c, given in enumerate(velocity):
        own = [key for key in keys if key[1][c] is not None]
        times = [F(key[0]) for key in own]
        cubics = Cubics(times, [(0, [F(key[1][c])], [F(x) for x in key[2]]) for key in own], rule, ends, None,
                        [F(given)]).cubics if len(own) > 1 else []
        curves.append((times, [F(key[1][c]) for key in own], cubics))
    parts = []
    for a, b in zip(stops, stops[1:]):
        over = []
        for times, positions, cubics in curves:
            if b <= times[0] or a >= times[-1]:
                over.append([positions[0] if b <= times[0] else positions[-1]])
                continue
            i = max(j for j in range(len(times) - 1) if times[j] <= a)
            h = times[i + 1] - times[i]
            over.append(compose(list(cubics[i][0]), [(a - times[i]) / h, (b - a) / h]))
        parts.append((b - a, over, over))
    return parts


def run(command, text, codes=(0,)):
    try:
        done = subprocess.run([program, *command], input=text, capture_output=True, text=True, timeout=60)
    except subprocess.TimeoutExpired:
        sys.exit(f"{' '.join(command)}: takes more than a minute\n{text}")
    if done.returncode not in codes:
        sys.exit(f"{' '.join(command)}: {done.stderr}\n{text}")
    return done


def hermite_parts(rows, channels, first):
    """The parts of printed pieces, whose numbers begin in the column `first`."""
    parts = []
    for row in rows:
        duration, *ends = map(F, row[first + 1:])
        cubics = []
        for c in range(channels):
            p, v, q, w = ends[4 * c:4 * c + 4]
            v, w = v * duration, w * duration
            cubics.append([p, v, 3 * (q - p) - 2 * v - w, 2 * (p - q) + v + w])
        parts.append((duration, cubics, cubics))
    return parts


def rows_of(keys, eased, group):
    numbers = lambda key: [key[0], *key[1], *key[2], *(key[3] if eased else [])]
    return [",".join(group + ["" if x is None else repr(x) for x in numbers(key)]) for key in keys]


maxima = wide = unbounded = retimed = 0
for number in range(curves):
    keys, period, eased, kind = random_curve()
    channels = len(keys[0][1])
    rule, ends = rng.choice(rules), (rng.choice(end_rules), rng.choice(end_rules))
    velocity = [rng.uniform(-2, 2) for _ in range(channels)]
    equal = rng.random() < 0.15
    sparse = not period and not eased and not equal and channels > 1 and len(keys) > 2 and rng.random() < 0.3
    groups = {(): keys}
    if not period and rng.random() < 0.15:  # the same keys, and those in the opposite order
        again = [(t, p, tcb, ease) for (t, *_), (_, p, tcb, ease) in zip(keys, reversed(keys))]
        groups = {("g=a",): keys, ("g=b",): again}
    if sparse:
        for c in range(channels):
            for i in rng.sample(range(len(keys)), rng.randint(1, len(keys) - 1)):
                if sum(x is not None for x in keys[i][1]) > 1:
                    keys[i][1][c] = None
    header = ["g"] * (len(groups) > 1) + ["t", *"xyz"[:channels], "tension", "continuity", "bias"]
    header += ["ease_in", "ease_out"] if eased else []
    lines = [line for title, of in groups.items() for line in rows_of(of, eased, [x[2:] for x in title])]
    text = "\n".join([",".join(header), *lines]) + "\n"
    with_velocity = ":".join(map(repr, velocity))
    options = ["--tangents", rule, "-q", "--tcb-scale", "none"]
    options += ["--equal-speed"] if equal else []
    options += ["--missing", "skip-cell"] if sparse else []
    options += ["-g", "g"] if len(groups) > 1 else []
    options += [f"--period={period!r}"] if period else \
        ["--ends", ",".join(e + (f"={with_velocity}" if e == "velocity" else "") for e in ends)]
    names = ["speed", "acceleration", "jerk", "curvature", "position_x", "velocity_x", "acceleration_x", "jerk_x"]
    wanted = rng.sample([n for n in names if channels > 1 or n != "curvature"], 2 if eased else 4)
    command = [*options, "--limits=" + ",".join(wanted), "-f", "json", "-"]
    report = json.loads(run(command, text).stdout, parse_float=str, parse_int=str)
    exact = {title: sparse_parts(of, rule, ends, velocity) if sparse else
             exact_parts(of, [key[0] for key in of], rule, ends, period, velocity, equal)
             for title, of in groups.items()}
    for entry in report["limits"]:
        extreme, name = entry["extreme"], entry["name"]
        measured = [0] if name.endswith("_x") else list(range(channels))
        best = exact_maximum(exact[tuple(entry["curve"])], name, extreme, measured, bool(period))
        maxima += 1
        if best is None or entry["maximum"] is None:
            unbounded += 1
            if (best is None) != (entry["maximum"] is None):
                sys.exit(f"curve {number}: {name}: {entry['maximum']}, but {best and float(best)}\n{' '.join(command)}\n{text}")
            continue
        shown, bound = F(entry["maximum"]), F(entry["bound"])
        doubt = abs(best) / 2 ** 70
        if extreme == "size":
            good = shown * shown <= best + doubt and bound * bound >= best - doubt
        else:
            sign = -1 if extreme == "minimum" else 1
            good = sign * shown <= best + doubt and sign * bound >= best - doubt
        wide += abs(bound - shown) > unit(entry["maximum"], entry["bound"])
        if not good or abs(bound - shown) > F(3, 10 ** 14) * max(abs(shown), abs(bound)):
            sys.exit(f"curve {number}: {name} {extreme}: {entry['maximum']} to {entry['bound']}, exactly {float(best)}\n"
                     f"{' '.join(command)}\n{text}")
    if number % 2 or ends.count("lightwave") and not period:
        continue
    # One factor for all curves, from the first key: that of the tightest limit.
    limits = {}
    for entry in report["limits"]:
        if entry["extreme"] == "size" and orders[entry["name"].split("_")[0]] and F(entry["maximum"]) != 0:
            limits[entry["name"]] = abs(float(entry["maximum"])) * rng.uniform(0.01, 1.2)
    jumps = {channel for corner in report["corners"] for channel in corner["channels"]}
    if jumps:
        limits = {name: limit for name, limit in limits.items() if orders[name.split("_")[0]] == 1}
    if not limits:
        continue
    asked = ["--limits=" + ",".join(f"{name}={limit!r}" for name, limit in limits.items()), "--retime=fit"]
    command = [*options, *asked, "--emit", "hermite", "-"]
    if eased:  # which pieces do not have
        command = [option for option in options if option != "-q"] + [*asked, "--per-segment", "1", "-"]
        factor = F(run(command, text).stderr.split("scaled by ")[1].split(",")[0])
        scaled = [[(duration * factor, *over) for duration, *over in parts] for parts in exact.values()]
    else:
        rows = [line.split(",") for line in run(command, text).stdout.splitlines()[1:] if line]
        scaled = [hermite_parts(rows, channels, len(groups) > 1)]
    closest = 0.0
    for name, limit in limits.items():
        measured = [0] if name.endswith("_x") else list(range(channels))
        best = max(exact_maximum(parts, name, "size", measured) for parts in scaled)
        closest = max(closest, math.sqrt(float(best / F(limit) ** 2)))
    retimed += 1
    if not 1 - 1e-12 <= closest <= 1 + 1e-15:
        sys.exit(f"curve {number}: the tightest limit is met to {closest!r}: {' '.join(command)}\n{text}")
print(f"{curves} curves: {maxima} maxima, {unbounded} without a bound, {wide} bounds more than one unit away, "
      f"{retimed} with scaled times")
if wide:
    sys.exit("bounds are more than one unit away")
