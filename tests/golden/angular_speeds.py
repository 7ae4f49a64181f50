"""--limits of angular speeds against curves of rotations by mpmath: angular_speeds.py PROGRAM [CURVES] [SEED].

Random rotations by all rotation curves of which a maximum is proved, open and closed, with ease, T, C and B to 3. Each
segment is sampled, and the largest samples are refined, so that the maximum is known to 20 digits: what is printed is
attained, its bound is not exceeded, and they differ by one unit of the last digit at most. With scaled times the limit
is met within 1e-12. Exit 1: a number is wrong, and its command is printed. Exit 77: there is no mpmath.
"""
import json
import random
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
try:
    from mpmath import mp, mpf
except ImportError:
    print("skipped: there is no python3-mpmath")
    sys.exit(77)
import quaternions as q4

mp.dps = 60
program = sys.argv[1]
curves = int(sys.argv[2]) if len(sys.argv) > 2 else 20
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
rules = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]
end_rules = ["half", "one-sided", "mirror", "chord", "zero"]
proved = ["slerp", "components"]


def speed(curve, i, t):
    return q4.norm(curve.at(t, i)[1])


def largest(curve):
    """The largest speed over all segments, and over the parts of an ease."""
    best = mpf(0)
    for i in range(curve.count):
        begin, end = curve.times[i:i + 2]
        f, e = curve.keys[i][3][1], curve.keys[(i + 1) % len(curve.keys)][3][0]
        if f + e > 1:
            f, e = f / (f + e), e / (f + e)
        stops = sorted({mpf(0), f, 1 - e, mpf(1)})
        for a, b in zip(stops, stops[1:]):
            inside = (b - a) * mpf(10) ** -25  # on this side of a stop
            places = [begin + (end - begin) * min(max(a + (b - a) * k / 64, a + inside), b - inside) for k in range(65)]
            speeds = [speed(curve, i, t) for t in places]
            best = max(best, *speeds)
            for k in range(65):  # also beside a stop, where the largest sample may be the stop itself
                near = range(max(k - 1, 0), min(k + 1, 64) + 1)
                if speeds[k] < max(speeds[j] for j in near) or speeds[k] < best * mpf("0.9"):
                    continue
                low, high = places[near[0]], places[near[-1]]
                for _ in range(60):
                    third = (high - low) / 3
                    if speed(curve, i, low + third) < speed(curve, i, high - third):
                        low += third
                    else:
                        high -= third
                best = max(best, speed(curve, i, (low + high) / 2))
    return best


def unit(*texts):
    """One unit of the last digit of decimals, which may have lost zeros at their ends."""
    def last(text):
        mantissa, _, exponent = text.lower().partition("e")
        return int(exponent or 0) - len(mantissa.partition(".")[2])
    return mpf(10) ** min(map(last, texts))


def run(command, text):
    done = subprocess.run([program, *command], input=text, capture_output=True, text=True, timeout=60)
    if done.returncode:
        sys.exit(f"{' '.join(command)}: {done.stderr}\n{text}")
    return done.stdout


retimed = 0
for number in range(curves):
    how, rule = rng.choice(proved), rng.choice(rules)
    ends = (rng.choice(end_rules), rng.choice(end_rules))
    n, closed, eased = rng.randint(2, 5), rng.random() < 0.3, rng.random() < 0.3
    n += closed and n == 2
    reach = rng.choice([0, 1, 3])
    keys, t, q = [], 0.0, [1.0, 0.0, 0.0, 0.0]
    for _ in range(n):
        ease = [rng.choice([0.0, 0.25, 0.5, 1.0, rng.random()]) for _ in range(2)] if eased else [0.0, 0.0]
        keys.append((t, q, [rng.uniform(-reach, reach) for _ in range(3)], ease))
        axis = [rng.gauss(0, 1) for _ in range(3)]
        half = rng.choice([1e-3, rng.uniform(0, 1.4), rng.uniform(0, 1.4)])
        turn = q4.exp(q4.scaled([mpf(x) for x in axis], half / q4.norm(axis)))
        q = [float(x) for x in q4.product([mpf(x) for x in q], turn)]
        t += rng.uniform(0.05, 2)
    header = "t,qw,qx,qy,qz,tension,continuity,bias" + (",ease_in,ease_out" if eased else "")
    lines = [",".join(map(repr, [key[0], *key[1], *key[2], *(key[3] if eased else [])])) for key in keys]
    text = "\n".join([header, *lines]) + "\n"
    options = ["-q", "--tcb-scale", "none", "--tangents", rule, "--rotation-curve", how]
    options += [f"--period={t!r}"] if closed else ["--ends", ",".join(ends)]
    command = [*options, "--limits=angular_speed", "-f", "json", "-"]
    entry = json.loads(run(command, text), parse_float=str, parse_int=str)["limits"][0]
    of = lambda numbers: [mpf(x) for x in numbers]
    curve = lambda factor: q4.Rotations([(t * factor, of(q), of(tcb), of(ease)) for t, q, tcb, ease in keys], how, rule,
                                        ends, mpf(t) * factor if closed else None)
    best = largest(curve(mpf(1)))
    shown, bound = mpf(entry["maximum"]), mpf(entry["bound"])
    one = mpf(10) ** -18 * best
    if shown > best + one or bound < best - one or bound - shown > unit(entry["maximum"], entry["bound"]) + one:
        sys.exit(f"curve {number}: {entry['maximum']} to {entry['bound']}, but {mp.nstr(best, 20)}\n{' '.join(command)}\n{text}")
    if closed or eased or best == 0:
        continue
    limit = float(best) * rng.uniform(0.1, 2)
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        file.write(text)
        file.flush()
        rows = run([*options, f"--limits=angular_speed={limit!r}", "--retime=fit", "--per-segment", "1", file.name], "")
    factor = mpf(rows.splitlines()[-1].split(",")[0]) / keys[-1][0]
    retimed += 1
    if not 1 - mpf(10) ** -12 <= best / factor / limit <= 1 + mpf(10) ** -15:
        sys.exit(f"curve {number}: the limit {limit!r} is met to {mp.nstr(best / factor / limit, 20)}\n{' '.join(command)}\n{text}")
print(f"{curves} curves, {retimed} with scaled times")
