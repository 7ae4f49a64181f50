"""Rows whose times are dates and clock times against exact fractions: times_in_words.py PROGRAM [CURVES] [SEED].

Random keys at decimal times, from 1970 and 1.7e9 seconds later. Positions and velocities are those at the exact time
that a row's text names: the same to the last bit, however far from 1970 they are; with --golden the fractions of
cubics.py, rounded once. Times in ms, us and ns as numbers, where the shift is exact, have the same positions, too.
Exit 1: a number differs, and its command is printed.
"""
import datetime
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
shift = 1700006400  # a midnight
compared = failures = 0


def require(condition, what):
    global compared, failures
    compared += 1
    if not condition:
        failures += 1
        if failures <= 10:
            print(what, file=sys.stderr)


def run(text, options):
    done = subprocess.run([program, "-q", *options], input=text, text=True, capture_output=True)
    if done.returncode != 0:
        sys.exit(f"{options}: {done.stderr}\n{text}")
    return [line.split(",") for line in done.stdout.splitlines()][1:]


def fraction_text(t):
    """The decimals of a time, without a whole part."""
    digits = f"{int((t - math.floor(t)) * 10 ** 9):09}".rstrip("0")
    return "." + digits if digits else ""


def date(t):
    whole = datetime.datetime(1970, 1, 1) + datetime.timedelta(seconds=math.floor(t))
    return whole.strftime("%Y-%m-%dT%H:%M:%S") + fraction_text(t) + "Z"


def clock(t):
    s = math.floor(t)
    return f"{s // 3600:02}:{s // 60 % 60:02}:{s % 60:02}" + fraction_text(t)


def time_of_date(text):
    whole, _, decimals = text.rstrip("Z").partition(".")
    seconds = datetime.datetime.strptime(whole, "%Y-%m-%dT%H:%M:%S") - datetime.datetime(1970, 1, 1)
    return Fraction(seconds.days * 86400 + seconds.seconds) + Fraction("0." + (decimals or "0"))


def time_of_clock(text):
    hours, minutes, seconds = text.split(":")
    return Fraction(int(hours) * 3600 + int(minutes) * 60) + Fraction(seconds)


def at(curve, channel, t):
    """(position, velocity, largest term) at a time; at a key, of the segment before it."""
    i = max([k for k in range(len(curve.cubics)) if curve.times[k] < t], default=0)
    h = curve.times[i + 1] - curve.times[i]
    p, b, c, d = curve.cubics[i][channel]
    u = (t - curve.times[i]) / h
    size = max(abs(x) for x in (p, p + b + c + d, b, b + 2 * c + 3 * d))
    return p + u * (b + u * (c + u * d)), (b + u * (2 * c + 3 * u * d)) / h, size


for number in range(curves):
    decimals = rng.choice([0, 1, 3, 6, 9])
    unit = Fraction(1, 10 ** decimals)
    times = [rng.randint(0, 10 ** min(decimals, 3)) * unit]
    for _ in range(rng.choice([1, 2, 4, 8])):
        times.append(times[-1] + max(unit * rng.randint(1, 3 * 10 ** decimals), unit))
    positions = [[repr(round(rng.uniform(-20, 20), 5)) for _ in range(2)] for _ in times]
    tcbs = [[rng.choice(["0", "0", repr(round(rng.uniform(-1, 1), 2))]) for _ in range(3)] for _ in times]
    rule = rng.choice(rules)

    def text(name, offset=0):
        rows = [",".join([name(t + offset), *p, *tcb]) for t, p, tcb in zip(times, positions, tcbs)]
        return "\n".join(["t,x,y,tension,continuity,bias", *rows]) + "\n"

    exact = Cubics(list(times), [(None, [Fraction(float(x)) for x in p], [Fraction(float(x)) for x in tcb])
                                 for p, tcb in zip(positions, tcbs)], rule, ["half", "half"])
    options = ["--tangents", rule, "--ends", "half", "--side", "left", "--fields", "time,position,velocity"]
    step = Fraction(1, rng.choice([10, 20, 50, 8, 100]))
    if (times[-1] - times[0]) / step > 200:
        step = Fraction(1, 5)
    sampling = rng.choice([["--step", str(step)], ["--count", str(rng.randint(2, 30))],
                           ["--per-segment", str(rng.randint(1, 5))], ["--step", str(step), "--keys"]])
    what = f"seed {seed} curve {number}: {' '.join(options + sampling)}\n{text(date, shift)}"
    near, far = (run(text(date, offset), options + sampling) for offset in (0, shift))
    golden = run(text(date, shift), options + sampling + ["--golden"])
    clocks = run(text(clock), options + sampling)
    require(len(near) == len(far) == len(golden) == len(clocks), f"{len(near)}, {len(far)} rows: {what}")
    for a, b, c, d in zip(near, far, golden, clocks):
        t = time_of_date(b[0]) - shift
        if time_of_date(a[0]) == t:  # rows between decimals are printed with fewer digits far from 1970
            require(a[1:] == b[1:], f"{b}, expected {a}: {what}")
        require(time_of_clock(d[0]) != time_of_date(a[0]) or d[1:] == a[1:], f"{d}, expected {a}: {what}")
        require(b[0] == c[0], f"--golden {c}, expected {b}: {what}")
        for channel in range(2):
            x, v, size = at(exact, channel, t)
            require(float(c[1 + channel]) == float(x), f"--golden {c}, expected {float(x)}: {what}")
            require(float(c[3 + channel]) == float(v), f"--golden {c}, expected {float(v)}: {what}")
            error = abs(Fraction(float(b[1 + channel])) - x)
            require(error <= 3 * Fraction(math.ulp(float(size))), f"{b}, expected {float(x)}: {what}")

    # Numbers in a unit in which keys and rows are whole: the same bits at both places.
    for name, units in (("ms", 10 ** 3), ("us", 10 ** 6), ("ns", 10 ** 9)):
        if units * unit < 1 or (units * step).denominator != 1:
            continue
        rows = [run(text(lambda t: str(t * units), offset),
                    options + ["--time-unit", name, "--step", str(step * units)]) for offset in (0, shift)]
        require([row[1:] for row in rows[0]] == [row[1:] for row in rows[1]], f"{name}: {what}")

print(f"{curves} curves, {compared} comparisons, {failures} differ")
sys.exit(1 if failures else 0)
