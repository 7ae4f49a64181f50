"""Rows of keys at frames against exact fractions: frames.py PROGRAM [CURVES] [SEED].

Random keys at frames, as numbers of frames from 0 and as timecode at an hour. The positions and velocities at frames are
the same to the last bit, however far from 0 the frames are. With --golden no bit differs from the fractions of
cubics.py, rounded once; without it, positions are within the bound of tcbsample-numerics(7). Exit 1: a number differs,
and its command is printed.
"""
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
rates = ["24", "25", "30", "24000/1001", "30000/1001", "60000/1001"]
rules = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]
compared = failures = 0


def require(condition, what):
    global compared, failures
    compared += 1
    if not condition:
        failures += 1
        if failures <= 10:
            print(what, file=sys.stderr)


def run(text, options):
    done = subprocess.run([program, *options], input=text, text=True, capture_output=True)
    if done.returncode != 0:
        sys.exit(f"{options}: {done.stderr}\n{text}")
    return [line.split(",") for line in done.stdout.splitlines()][1:]


def timecode(frame, rate, drops):
    """The text of a frame, by counting the minutes whose first numbers are dropped."""
    nominal = math.ceil(rate)
    if drops:
        dropped = nominal // 15
        minute, ten_minutes = nominal * 60 - dropped, nominal * 600 - 9 * dropped
        tens, rest = divmod(frame, ten_minutes)
        frame += dropped * 9 * tens + (dropped * ((rest - dropped) // minute) if rest >= dropped else 0)
    seconds, number = divmod(frame, nominal)
    return f"{seconds // 3600:02}:{seconds // 60 % 60:02}:{seconds % 60:02}{';' if drops else ':'}{number:02}"


def exact_time(printed, rate):
    """A double that is the nearest to a frame, or to a thousandth of one, is that."""
    part = Fraction(round(Fraction(printed) * rate * 1000)) / 1000 / rate
    return part if float(part) == printed else Fraction(printed)


def at(curve, channel, t):
    """(position, velocity, largest term) at a time; at a key, of the segment before it."""
    i = max([k for k in range(len(curve.cubics)) if curve.times[k] < t], default=0)
    h = curve.times[i + 1] - curve.times[i]
    p, b, c, d = curve.cubics[i][channel]
    u = (t - curve.times[i]) / h
    size = max(abs(x) for x in (p, p + b + c + d, b, b + 2 * c + 3 * d))
    return p + u * (b + u * (c + u * d)), (b + u * (2 * c + 3 * u * d)) / h, size


for number in range(curves):
    text_of_rate = rng.choice(rates)
    rate = Fraction(text_of_rate)
    drops = text_of_rate in ("30000/1001", "60000/1001") and rng.random() < 0.5
    nominal = math.ceil(rate)
    frames = [0]
    for _ in range(rng.choice([1, 2, 4, 8])):
        frames.append(frames[-1] + rng.choice([1, 2, 5, rng.randint(1, 100)]))
    shift = rng.choice([1, 1, 2, 10, 23]) * 3600 * nominal + rng.randint(0, 3600)
    if drops:
        shift -= shift % (nominal * 600 - 9 * (nominal // 15))
    channels = ["x", "y"]
    positions = [[repr(round(rng.uniform(-20, 20), 5)) for _ in channels] for _ in frames]
    for i in range(1, len(frames)):
        if rng.random() < 0.3:
            positions[i] = positions[i - 1]
    tcbs = [[rng.choice(["0", "0", repr(round(rng.uniform(-1, 1), 2))]) for _ in range(3)] for _ in frames]
    rows_of = lambda texts: [",".join([t, *p, *tcb]) for t, p, tcb in zip(texts, positions, tcbs)]
    names = "x,y,tension,continuity,bias"
    from_0 = "\n".join(["frame," + names, *rows_of(map(str, frames))]) + "\n"
    at_hour = "\n".join(["t," + names, *rows_of(timecode(f + shift, rate, drops) for f in frames)]) + "\n"
    rule = rng.choice(rules)
    options = ["--input-fps", text_of_rate, "--tangents", rule, "--ends", "half", "--side", "left"]
    fields = ["--fields", "time,position,velocity"]
    frame_mode = rng.choice([["--rate", text_of_rate], ["--rate", text_of_rate, "--keys"], ["--at"]])
    exact = Cubics([Fraction(f + shift) / rate for f in frames],
                   [(None, [Fraction(float(x)) for x in p], [Fraction(float(x)) for x in tcb])
                    for p, tcb in zip(positions, tcbs)], rule, ["half", "half"])

    # Rows at frames: the same bits from 0 and from the hour.
    def sampling(first):
        if frame_mode != ["--at"]:
            return frame_mode
        return ["--at", ",".join(str(Fraction(f + first) / rate) for f in range(frames[-1] + 1))]
    near = run(from_0, options + fields + sampling(0) + ["--time-format", "frames"])
    far = run(at_hour, options + fields + sampling(shift) + ["--time-format", "frames"])
    golden = run(at_hour, options + fields + sampling(shift) + ["--time-format", "frames", "--golden"])
    what = f"seed {seed} curve {number}: {' '.join(options + fields + sampling(shift))}\n{at_hour}"
    require(len(near) == len(far) == len(golden) == frames[-1] + 1, f"{len(near)}, {len(far)} rows: {what}")
    for a, b, c in zip(near, far, golden):
        require(a[1:] == b[1:] and int(a[0]) + shift == int(b[0]), f"{b}, expected {a}: {what}")
        for channel in range(2):
            x, v, size = at(exact, channel, Fraction(int(b[0])) / rate)
            require(float(c[1 + channel]) == float(x), f"--golden {c[1 + channel]}, expected {float(x)}: {what}")
            require(float(c[3 + channel]) == float(v), f"--golden {c[3 + channel]}, expected {float(v)}: {what}")
            error = abs(Fraction(float(b[1 + channel])) - x)
            require(error <= 3 * Fraction(math.ulp(float(size))), f"{b[1 + channel]}, expected {float(x)}: {what}")

    # Rows between frames are where they are printed.
    between = ["--count", str(rng.randint(2, 40)), "--time-format", "seconds"]
    for mode in ([], ["--golden"]):
        for row in run(at_hour, options + fields + between + mode):
            t = exact_time(float(row[0]), rate)
            for channel in range(2):
                x, v, size = at(exact, channel, t)
                bound = Fraction(0) if mode else 3 * Fraction(math.ulp(float(size)))
                want = Fraction(float(x)) if mode else x
                error = abs(Fraction(float(row[1 + channel])) - want)
                require(error <= bound, f"{row}, expected {float(x)}: {what}\n{between + mode}")

print(f"{curves} curves, {compared} comparisons, {failures} differ")
sys.exit(1 if failures else 0)
