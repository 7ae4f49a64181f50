"""--limits finds the exact maxima, and --retime meets the limits: against Sturm sequences of fractions, and angular speeds
against refined samples of 60 digits.

A maximum that is printed is attained, its bound is not exceeded, and they differ by one unit of the last digit at most.
With scaled times the tightest limit is met within 1e-12, by the pieces that are printed, or with ease by the factor."""
import json
import math
from fractions import Fraction as F

import quaternions as q4
from curves import Curve
from keys import Keys
from law import blocks, check, require, run
from mpmath import mp, mpf
from polynomials import add, common, compose, derive, largest, roots, times, trim, value

mp.dps = 60
ORDERS = {"position": 0, "velocity": 1, "speed": 1, "acceleration": 2, "jerk": 3, "curvature": 0}
MEASURES = ["speed", "acceleration", "jerk", "curvature", "position_x", "velocity_x", "acceleration_x", "jerk_x"]


def norm(vector):
    """The length of a vector of fractions, to 300 bits."""
    square = sum(x * x for x in vector)
    if square == 0:
        return F(0)
    shift = 2 * (300 + (square.denominator.bit_length() - square.numerator.bit_length()) // 2)
    scaled = square * F(2) ** shift
    return F(math.isqrt(scaled.numerator // scaled.denominator)) / F(2) ** (shift // 2)


def pieces_of(part):
    """(duration, polynomials over time, polynomials over u) of each piece, from 0 to 1."""
    for i, (a, b) in enumerate(zip(part.knots, part.knots[1:])):
        h, channels = b - a, range(len(part.curves))
        if part.keys.sparse:
            over = [[x * h ** k for k, x in enumerate(part.over_time(c, a))] for c in channels]
            yield h, over, over
            continue
        over, (f, e) = [list(curve.cubics[i][k]) for curve, k in part.curves], part.curves[0][0].eases[i]
        k = 1 / (2 - f - e)
        warps = [(f, [F(0), F(0), k * f]), (1 - f - e, [k * f, 2 * k * (1 - f - e)]), (e, [1 - k * e, 2 * k * e, -k * e])]
        for size, warp in warps if f or e else [(F(1), [F(0), F(1)])]:
            if size:
                yield h * size, [compose(x, warp) for x in over], over


def squares(vectors):
    total = [F(0)]
    for x in vectors:
        total = add(total, times(x, x))
    return total


def rests(velocity):
    """Whether all components of a velocity are 0 at the same place of [0, 1]."""
    shared = [F(0)]
    for x in velocity:
        shared = common(shared, x)
    return value(shared, F(0)) == 0 or value(shared, F(1)) == 0 or any(True for _ in roots(shared))


def heading(velocity, end):
    """The direction of a path at an end of a piece, from the first derivative that is not 0, and how many are 0."""
    for order in range(3):
        vector = [value(v, F(end)) * (-1 if end and order % 2 else 1) for v in velocity]
        if any(vector):
            return vector, order
        velocity = [derive(v) for v in velocity]
    return None, 3


def turns_at_rest(pieces, channels, closed):
    """Whether the path has a corner at a key at which it rests."""
    velocities = [[derive(by_u[c]) for c in channels] for _, _, by_u in pieces]
    for before, after in zip(velocities, velocities[1:] + velocities[:1] * closed):
        (a, m), (b, n) = heading(before, 1), heading(after, 0)
        if a is None or b is None or m == n == 0 or before == after:
            continue
        dot = lambda x, y: sum(p * q for p, q in zip(x, y))
        if dot(a, a) * dot(b, b) - dot(a, b) ** 2 > F(1, 2 ** 80) * dot(a, a) * dot(b, b):
            return True
    return False


def exact_maximum(pieces, name, extreme, channels, closed=False):
    """Of a size its square, of a minimum its negative; None without a bound."""
    order, found = ORDERS[name.split("_")[0]], []
    if name == "curvature" and turns_at_rest(pieces, channels, closed):
        return None
    for duration, by_time, by_u in pieces:
        if name == "curvature":
            v = [derive(by_u[c]) for c in channels]
            over = trim(squares([add(times(v[i], derive(v[j])), [-x for x in times(derive(v[i]), v[j])])
                                 for i in channels for j in channels if i < j]))
            if any(over) and rests(v):
                return None
            s = squares(v)
            found.append(largest(over, trim(times(times(s, s), s))) if any(over) else F(0))
            continue
        vectors = [by_time[c] for c in channels]
        for _ in range(order):
            vectors = [derive(x) for x in vectors]
        vectors = [[x / duration ** order for x in vector] for vector in vectors]
        over = squares(vectors) if extreme == "size" else [x if extreme == "maximum" else -x for x in vectors[0]]
        found.append(largest(trim(over), [F(1)]))
    return max(found)


def unit(*texts):
    """One unit of the last digit of decimals, which may have lost zeros at their ends."""
    def last(text):
        mantissa, _, exponent = text.lower().partition("e")
        return int(exponent or 0) - len(mantissa.partition(".")[2])
    return F(10) ** min(map(last, texts))


def report_of(text, options, wanted):
    return json.loads(run(text, "-q", *options, f"--limits={','.join(wanted)}", "-f", "json").stdout, parse_float=str, parse_int=str)


def maxima(rng):
    keys = Keys(rng, "rotations linear", ["whole", "short", "double", "negative"], count=rng.choice([2, 3, 4, 5, 6]))
    text, options, channels = keys.text(), keys.options(), list(range(len(keys.channels)))
    wanted = rng.sample([n for n in MEASURES if len(channels) > 1 or n != "curvature"], 2 if keys.ease else 4)
    report, parts = report_of(text, options, wanted), keys.parts(curve=Curve, norm=norm if keys.equal else None)
    exact, entries = [list(pieces_of(part)) for part in parts], report["limits"]
    require(len(entries) >= len(parts) * len(wanted), f"{len(entries)} maxima")
    for i, entry in enumerate(entries):
        name, extreme = entry["name"], entry["extreme"]
        what = f"{name} {extreme}: {entry['maximum']} to {entry['bound']}"
        best = exact_maximum(exact[i * len(parts) // len(entries)], name, extreme, [0] if name.endswith("_x") else channels, keys.closed)
        require((best is None) == (entry["maximum"] is None), what)
        if best is None:
            continue
        shown, bound, doubt = F(entry["maximum"]), F(entry["bound"]), abs(best) / 2 ** 70
        reached = (lambda x: x * x) if extreme == "size" else (lambda x: x if extreme == "maximum" else -x)
        require(reached(shown) <= best + doubt and reached(bound) >= best - doubt and
                abs(bound - shown) <= min(unit(entry["maximum"], entry["bound"]), F(3, 10 ** 14) * max(abs(shown), abs(bound))),
                f"{what}, exactly {float(best)}")
    if "lightwave" not in keys.ends or keys.closed:
        retime(rng, keys, text, options, exact, report)


def retime(rng, keys, text, options, exact, report):
    """One factor for all curves, from the first key: that of the tightest limit."""
    limits = {entry["name"]: abs(float(entry["maximum"])) * rng.uniform(0.01, 1.2) for entry in report["limits"]
              if entry["extreme"] == "size" and ORDERS[entry["name"].split("_")[0]] and F(entry["maximum"]) != 0}
    if report["corners"]:
        limits = {name: limit for name, limit in limits.items() if ORDERS[name.split("_")[0]] == 1}
    if not limits:
        return
    asked = [*options, "--limits=" + ",".join(f"{name}={limit!r}" for name, limit in limits.items()), "--retime=fit"]
    if keys.ease:  # which pieces do not have
        factor = F(run(text, *asked, "--per-segment", "1").stderr.split("scaled by ")[1].split(",")[0])
        scaled = [[(duration * factor, *over) for duration, *over in pieces] for pieces in exact]
    else:
        scaled = []
        for rows in blocks(text, *asked, "--emit", "hermite"):
            scaled.append([])
            for row in rows:
                h, over = F(row["duration"]), []
                for name in keys.channels:
                    p, v, q, w = (F(row[f"{name}_{suffix}"]) for suffix in ("p0", "v0", "p1", "v1"))
                    over.append([p, v * h, 3 * (q - p) - 2 * v * h - w * h, 2 * (p - q) + v * h + w * h])
                scaled[-1].append((h, over, over))
    closest = 0.0
    for name, limit in limits.items():
        channels = [0] if name.endswith("_x") else list(range(len(keys.channels)))
        best = max(exact_maximum(pieces, name, "size", channels) for pieces in scaled)
        closest = max(closest, math.sqrt(float(best / F(limit) ** 2)))
    require(1 - 1e-12 <= closest <= 1 + 1e-15, f"the tightest limit is met to {closest!r}")


def largest_spin(curve):
    """The largest angular speed over all segments, and over the parts of an ease."""
    best, spin = mpf(0), lambda i, t: q4.norm(curve.at(t, i)[1])
    for i in range(curve.count):
        begin, end = curve.times[i:i + 2]
        f, e = curve.keys[i][3][1], curve.keys[(i + 1) % len(curve.keys)][3][0]
        f, e = (f / (f + e), e / (f + e)) if f + e > 1 else (f, e)
        stops = sorted({mpf(0), f, 1 - e, mpf(1)})
        for a, b in zip(stops, stops[1:]):
            inside = (b - a) * mpf(10) ** -25  # on this side of a stop
            places = [begin + (end - begin) * min(max(a + (b - a) * k / 64, a + inside), b - inside) for k in range(65)]
            speeds = [spin(i, t) for t in places]
            best = max(best, *speeds)
            for k in range(65):  # also beside a stop, where the largest sample may be the stop itself
                near = range(max(k - 1, 0), min(k + 1, 64) + 1)
                if speeds[k] < max(speeds[j] for j in near) or speeds[k] < best * mpf("0.9"):
                    continue
                low, high = places[near[0]], places[near[-1]]
                for _ in range(60):
                    third = (high - low) / 3
                    low, high = (low + third, high) if spin(i, low + third) < spin(i, high - third) else (low, high - third)
                best = max(best, spin(i, (low + high) / 2))
    return best


def spins(rng):
    keys = Keys(rng, "own sparse linear velocities sizes equal groups gaps", ["whole", "short", "double"], "rotations", reach=[1, 3],
                count=rng.choice([2, 3, 4]), rotation_curves=["slerp", "components"], widest=rng.choice([2e-3, 2.8]),
                ends=["half", "one-sided", "mirror", "chord", "zero"])
    text, options = keys.text(), keys.options()
    (entry,), best = report_of(text, options, ["angular_speed"])["limits"], largest_spin(keys.parts()[0].rotations())
    shown, bound, little = mpf(entry["maximum"]), mpf(entry["bound"]), mpf(10) ** -18 * best
    require(shown <= best + little and bound >= best - little and
            bound - shown <= q4.to_mpf(unit(entry["maximum"], entry["bound"])) + little, f"{shown} to {bound}, but {mp.nstr(best, 20)}")
    if keys.closed or keys.ease or best == 0:
        return
    limit = float(best) * rng.uniform(0.1, 2)
    (rows,) = blocks(text, *options, f"--limits=angular_speed={limit!r}", "--retime=fit", "--per-segment", "1")
    first, last = (mpf(float(t)) for t in (keys.times[0], keys.times[-1]))
    met = best * (last - first) / (mpf(float(rows[-1]["t"])) - first) / limit
    require(1 - mpf(10) ** -12 <= met <= 1 + mpf(10) ** -14, f"the limit {limit!r} is met to {mp.nstr(met, 20)}")


check(lambda rng: maxima(rng) if rng.random() < 0.85 else spins(rng), 10, least=2)
