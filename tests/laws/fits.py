"""Fits keep their promises, of recordings that are smooth, noisy, with steps or at uneven times, with one tolerance or more.

The curve of the printed keys, by curves.py, is within the tolerance of every sample; the reported bound holds; smooth
recordings have at most 1.6 times as many keys as the bound and 2 more, noisy ones 2.5 times. Positions of piecewise
cubics with smooth joints at samples have no more keys than pieces and one. The samples of the printed keys agree with the
recording by --at and by --check. Recordings of poses: the same for angles, by quaternions.py."""
import fractions
import math
import os
import re

import quaternions as q4
from curves import Curve
from law import check, folder, require, run, write
from mpmath import mpf


def recording(rng, kind):
    """Times and samples."""
    size, channels = rng.choice([30, 300, 2000]), rng.choice([1, 2, 3, 3, 10])
    noise = 0.01 if kind == "noisy" else 0
    waves = [[(rng.uniform(0.1, 2), rng.uniform(0.2, 3), rng.uniform(0, 7)) for _ in range(3)] for _ in range(channels)]
    times, t = [], rng.choice([0.0, -5.0, 1.3e9])
    for _ in range(size):
        times.append(round(t, 6))
        t += rng.uniform(0.005, 0.06) if kind == "uneven" else 0.02
    rows = []
    for t in times:
        values = [sum(a * math.sin(w * (t - times[0]) + p) for a, w, p in wave) for wave in waves]
        if kind == "steps":
            values = [float(round(value)) for value in values]
        rows.append([round(value + rng.gauss(0, noise), 6) for value in values])
    return times, rows


def fit(table, *options):
    """The notes, the names of columns, and the keys, as texts."""
    write("recording", table)
    done = run(table, *options, "-o", "keys.csv", "recording")
    with open(os.path.join(folder.name, "keys.csv")) as file:
        names, *keys = [line.split(",") for line in file.read().splitlines()]
    return done.stderr, names, keys


def floats(rows):
    return [list(map(float, row)) for row in rows]


def positions(names, keys, channel, times):
    """Those of the keys at increasing times."""
    column = {name: [row[i] for row in keys] for i, name in enumerate(names)}
    only = sum(name[:1] == "c" and name[1:].isdigit() for name in names) == 1
    tcb = zip(*(column.get(role if only else f"{role}_{channel}", [0] * len(keys)) for role in ("tension", "continuity", "bias")))
    sides = [column.get(channel + side, column.get(channel + "_v")) for side in ("_vin", "_vout")]
    given = [([before], [after]) for before, after in zip(*sides)] if sides[0] else [None] * len(keys)
    curve = Curve([(t, [x], one, (0, 0), v) for t, x, one, v in zip(column["t"], column[channel], tcb, given)],
                  "velocity", ("one-sided", "one-sided"))
    slot = 0
    for t in times:
        while slot + 1 < len(curve.cubics) and curve.times[slot + 1] <= t:
            slot += 1
        u, ((p, b, c, d),) = curve.part_of(slot, t), curve.cubics[slot]
        yield p + u * (b + u * (c + u * d))


def table(names, rows):
    return "\n".join([",".join(names), *(",".join(map(repr, row)) for row in rows)]) + "\n"


def channels_within(rng):
    kind = rng.choice(["smooth", "noisy", "uneven", "steps"])
    times, rows = recording(rng, kind)
    channels = [f"c{i}" for i in range(len(rows[0]))]
    tolerance = rng.choice([0.5, 0.05, 0.005] if kind != "noisy" else [0.1, 0.03])
    by_channel = rng.random() < 0.25
    limits = ",".join(f"{name}={tolerance}" for name in channels) if by_channel else str(tolerance)
    options = ["--fit", limits, *["--fit-keys", "hermite"] * (kind == "steps" or rng.random() < 0.3),
               *["--corner", "60"] * (rng.random() < 0.2)]
    notes, names, keys = fit(table(["t", *channels], [[t, *row] for t, row in zip(times, rows)]), *options)
    computed = [list(positions(names, floats(keys), name, times)) for name in channels]
    for i, row in enumerate(rows):
        gaps = [abs(one[i] - value) for one, value in zip(computed, row)]
        distance = max(gaps) if by_channel else math.hypot(*gaps)
        require(distance <= tolerance + 1e-9 * (1 + abs(times[0]) * 1e-5), f"line {i + 2} is {distance} from the curve")
    least = int(re.search(r"at least (\d+) keys are needed", notes)[1])
    most = (2.5 if kind == "noisy" else 1.6) * least + 2
    require(least <= len(keys) and (len(keys) <= most or kind == "steps"), f"{len(keys)} keys, at least {least}")
    sampled = run("", "-q", "--at", "@recording:t", "keys.csv").stdout
    require(sampled.count("\n") == len(rows) + 1, "rows at the times of samples")
    run("", "--check", "recording", "--abs", str(tolerance), "keys.csv")


def pieces_within(rng):
    """Moves with ramps of speed, as robots make them: the joints are at samples."""
    per_piece, pieces, tolerance = rng.randint(8, 60), rng.randint(2, 30), 10 ** rng.uniform(-9, -3)
    step, rows = 1 / 64, [[0.0, 0.0]]
    speeds = [[0.0, 0.0]] + [[rng.randint(-8, 8) / 8 for _ in range(2)] for _ in range(pieces)]
    for before, after in zip(speeds, speeds[1:]):
        start, length = rows[-1], per_piece * step
        for i in range(1, per_piece + 1):
            t = i * step
            rows.append([x + v * t + (w - v) / length * t * t / 2 for x, v, w in zip(start, before, after)])
    moves = table(["t", "c0", "c1"], [[i * step, *row] for i, row in enumerate(rows)])
    _, _, keys = fit(moves, "--fit", str(tolerance), "--fit-keys", "hermite")
    require(len(keys) <= pieces + 1, f"{len(keys)} keys for {pieces} pieces")


def at_decimal_times(rng):
    """At times that are not doubles, the curve is within the tolerance also if they are taken as decimals."""
    tolerance, first = rng.choice([1e-2, 1e-3, 1e-4]), 1305031098 + rng.random()
    times = [round(first + i * 0.01 + rng.uniform(0, 0.004), 4) for i in range(400)]
    wave = [(rng.uniform(0.1, 1), rng.uniform(0.5, 3), rng.uniform(0, 7)) for _ in range(3)]
    samples = [[f"{t:.4f}", repr(round(sum(a * math.sin(w * (t - first) + p) for a, w, p in wave), 7))] for t in times]
    _, names, keys = fit("".join(",".join(row) + "\n" for row in [["t", "c0"], *samples]), "--fit", str(tolerance))
    exactly = lambda rows: [list(map(fractions.Fraction, row)) for row in rows]
    computed = positions(names, exactly(keys), "c0", [row[0] for row in exactly(samples)])
    largest = max(abs(one - row[1]) for one, row in zip(computed, exactly(samples)))
    require(largest <= fractions.Fraction(str(tolerance)), f"{float(largest)} from a sample")


def pose_at(rng, t, waves):
    """x and a quaternion, w first, of either sign."""
    x, *turns = (sum(a * math.sin(w * t + p) for a, w, p in wave) for wave in waves)
    q = [mpf(1), mpf(0), mpf(0), mpf(0)]
    for axis, turn in enumerate(turns):
        q = q4.turned(q, [mpf(turn) if axis == i else mpf(0) for i in range(3)])
    return x, [float(rng.choice([1, -1]) * number) for number in map(float, q)]


def poses_within(rng):
    waves = [[(rng.uniform(0.05, 0.6), rng.uniform(0.2, 2), rng.uniform(0, 7)) for _ in range(2)] for _ in range(4)]
    poses = [(0.05 * i, *pose_at(rng, 0.05 * i, waves)) for i in range(rng.choice([40, 200]))]
    degrees, hermite = rng.choice([2, 0.5, 0.1]), rng.random() < 0.5
    _, names, keys = fit(table(["t", "x", "qw", "qx", "qy", "qz"], [[t, x, *q] for t, x, q in poses]),
                         "--fit", f"0.02,{degrees}deg", *["--fit-keys", "hermite"] * hermite)
    column = {name: [mpf(row[i]) for row in keys] for i, name in enumerate(names)}
    nothing = [mpf(0)] * len(keys)
    quaternions = list(zip(*(column[f"q{c}"] for c in "wxyz")))
    tension, bias = column.get("tension", nothing), column.get("bias", nothing)
    rows = [(column["t"][i], quaternions[i], (tension[i], mpf(0), bias[i]), (mpf(0), mpf(0))) for i in range(len(keys))]
    curve = q4.Rotations(rows, "squad", "velocity", ["one-sided", "one-sided"])
    if hermite:
        curve.give([(v, v) for v in zip(*(column[f"q{c}_v"] for c in "wxyz"))])
    computed = list(positions(names, floats(keys), "x", [t for t, _, _ in poses]))
    for i, (t, x, q) in enumerate(poses):
        found = curve.at(mpf(t))[0]
        angle = math.degrees(2 * q4.norm(q4.log(q4.product(q4.conjugate(found), q4.nearest(q, found)))))
        require(angle <= degrees + 1e-9 and abs(computed[i] - x) <= 0.02 + 1e-9,
                f"line {i + 2} is {angle} degrees and {abs(computed[i] - x)} from the curve")


check(lambda rng: rng.choice([channels_within] * 7 + [pieces_within, at_decimal_times, poses_within])(rng), 12, least=1)
