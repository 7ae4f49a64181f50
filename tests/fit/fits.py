"""Fits against an evaluation of their own: fits.py PROGRAM [RECORDINGS] [SEED].

Random recordings: smooth, noisy, with steps, at uneven times, of one to ten channels, with one tolerance or several. The
curve of the printed keys, computed here from the formulas of the manual, is within the tolerance of every sample; the
reported bound holds; smooth recordings have at most 1.6 times as many keys as the bound and 2 more, noisy ones 2.5
times. Positions of piecewise cubics with smooth joints at samples have no more keys than pieces and one. The samples of the printed keys agree with the recording by --at and by --check. Recordings of poses: the same
for angles, by the reference for curves of rotations. Exit 1: a law fails, and its command is printed.
"""
import fractions
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "golden"))
import quaternions as q4  # noqa: E402
from mpmath import mpf  # noqa: E402

program = sys.argv[1]
count = int(sys.argv[2]) if len(sys.argv) > 2 else 40
rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 20260101)
folder = tempfile.TemporaryDirectory()
recording_file, keys_file = (str(pathlib.Path(folder.name) / name) for name in ("recording.csv", "keys.csv"))


def recording(kind):
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


def read(path):
    lines = pathlib.Path(path).read_text().splitlines()
    return lines[0].split(","), [[float(cell) for cell in line.split(",")] for line in lines[1:]]


def slopes_of(names, keys, channel):
    """The velocities before and after each key."""
    column = {name: [row[i] for row in keys] for i, name in enumerate(names)}
    time, position = column["t"], column[channel]
    if channel + "_v" in column:
        return column[channel + "_v"], column[channel + "_v"]
    if channel + "_vin" in column:
        return column[channel + "_vin"], column[channel + "_vout"]
    only = sum(name.startswith("c") and name[1:].isdigit() for name in names) == 1
    nothing = [0] * len(time)
    T, C, B = (column.get(role if only else f"{role}_{channel}", nothing) for role in ("tension", "continuity", "bias"))
    chord = [(position[i + 1] - position[i]) / (time[i + 1] - time[i]) for i in range(len(time) - 1)]
    before, after = [], []
    for i in range(len(time)):
        v0 = 2 * chord[i - 1] if i + 1 == len(time) else chord[i - 1] if i > 0 else 0
        v1 = 2 * chord[i] if i == 0 else chord[i] if i + 1 < len(time) else 0
        loose = (1 - T[i]) / 2
        before.append(loose * ((1 - C[i]) * (1 + B[i]) * v0 + (1 + C[i]) * (1 - B[i]) * v1))
        after.append(loose * ((1 + C[i]) * (1 + B[i]) * v0 + (1 - C[i]) * (1 - B[i]) * v1))
    return before, after


def exactly(path):
    """The cells of a file as the decimals that they are."""
    return [list(map(fractions.Fraction, line.split(","))) for line in pathlib.Path(path).read_text().splitlines()[1:]]


def positions(names, keys, channel, times):
    at, slot = [], 0
    time, position = [row[0] for row in keys], [row[names.index(channel)] for row in keys]
    before, after = slopes_of(names, keys, channel)
    for t in times:
        while slot + 2 < len(time) and time[slot + 1] <= t:
            slot += 1
        h = time[slot + 1] - time[slot]
        u = (t - time[slot]) / h
        at.append((1 + 2 * u) * (1 - u) ** 2 * position[slot] + u * u * (3 - 2 * u) * position[slot + 1]
                  + h * u * (1 - u) ** 2 * after[slot] - h * u * u * (1 - u) * before[slot + 1])
    return at


def run(arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True)


def fail(message, arguments):
    print(message)
    print(" ".join(arguments), f"# {recording_file} holds the recording; --seed is the third argument")
    print(pathlib.Path(recording_file).read_text()[:2000])
    sys.exit(1)


def check(kind):
    times, rows = recording(kind)
    channels = [f"c{i}" for i in range(len(rows[0]))]
    lines = [",".join(["t", *channels])] + [",".join(map(repr, [t, *row])) for t, row in zip(times, rows)]
    pathlib.Path(recording_file).write_text("\n".join(lines) + "\n")
    tolerance = rng.choice([0.5, 0.05, 0.005] if kind != "noisy" else [0.1, 0.03])
    by_channel = rng.random() < 0.25
    limits = ",".join(f"{name}={tolerance}" for name in channels) if by_channel else str(tolerance)
    hermite = kind == "steps" or rng.random() < 0.3
    options = ["--fit", limits, *(["--fit-keys", "hermite"] if hermite else [])]
    options += ["--corner", "60"] if rng.random() < 0.2 else []
    arguments = [*options, "-o", keys_file, recording_file]
    result = run(arguments)
    if result.returncode != 0:
        fail(result.stderr, arguments)
    names, keys = read(keys_file)
    computed = [positions(names, keys, name, times) for name in channels]
    rounding = 1e-9 * (1 + abs(times[0]) * 1e-5)
    for i, row in enumerate(rows):
        gaps = [abs(one[i] - value) for one, value in zip(computed, row)]
        distance = max(gaps) if by_channel else math.hypot(*gaps)
        if distance > tolerance + rounding:
            fail(f"line {i + 2} is {distance} from the curve, more than {tolerance}", arguments)
    least = int(re.search(r"at least (\d+) keys are needed", result.stderr)[1])
    most = (2.5 if kind in ("noisy", "steps") else 1.6) * least + 2
    if len(keys) < least or (len(keys) > most and kind != "steps"):
        fail(f"{len(keys)} keys, at least {least}", arguments)
    sampled = run(["-q", "--at", f"@{recording_file}:t", keys_file])
    compared = run(["--check", recording_file, "--abs", str(tolerance), keys_file])
    if sampled.returncode != 0 or len(sampled.stdout.splitlines()) != len(rows) + 1 or compared.returncode != 0:
        fail(sampled.stderr + compared.stdout + compared.stderr, arguments)
    return len(keys) / least


def check_pieces():
    """Moves with ramps of speed, as robots make them: the joints are at samples."""
    per_piece, pieces, tolerance = rng.randint(8, 60), rng.randint(2, 30), 10 ** rng.uniform(-9, -3)
    step, rows = 1 / 64, [[0.0, 0.0]]
    speeds = [[0.0, 0.0]] + [[rng.randint(-8, 8) / 8 for _ in range(2)] for _ in range(pieces)]
    for before, after in zip(speeds, speeds[1:]):
        start, length = rows[-1], per_piece * step
        for i in range(1, per_piece + 1):
            t = i * step
            rows.append([x + v * t + (w - v) / length * t * t / 2 for x, v, w in zip(start, before, after)])
    lines = ["t,c0,c1"] + [",".join(map(repr, [i * step, *row])) for i, row in enumerate(rows)]
    pathlib.Path(recording_file).write_text("\n".join(lines) + "\n")
    arguments = ["--fit", str(tolerance), "--fit-keys", "hermite", "-o", keys_file, recording_file]
    result = run(arguments)
    if result.returncode != 0 or len(read(keys_file)[1]) > pieces + 1:
        fail(f"{result.stderr}{pieces} pieces", arguments)


def check_decimal_times():
    """At times that are not doubles, the curve is within the tolerance also if they are taken as decimals."""
    tolerance, first = rng.choice([1e-2, 1e-3, 1e-4]), 1305031098 + rng.random()
    times = [round(first + i * 0.01 + rng.uniform(0, 0.004), 4) for i in range(400)]
    wave = [(rng.uniform(0.1, 1), rng.uniform(0.5, 3), rng.uniform(0, 7)) for _ in range(3)]
    rows = [[round(sum(a * math.sin(w * (t - first) + p) for a, w, p in wave), 7)] for t in times]
    lines = ["t,c0"] + [f"{t:.4f},{row[0]!r}" for t, row in zip(times, rows)]
    pathlib.Path(recording_file).write_text("\n".join(lines) + "\n")
    arguments = ["--fit", str(tolerance), "-o", keys_file, recording_file]
    result = run(arguments)
    if result.returncode != 0:
        fail(result.stderr, arguments)
    samples, keys = exactly(recording_file), exactly(keys_file)
    computed = positions(read(keys_file)[0], keys, "c0", [row[0] for row in samples])
    largest = max(abs(one - row[1]) for one, row in zip(computed, samples))
    if largest > fractions.Fraction(str(tolerance)):
        fail(f"{float(largest)} from a sample", arguments)


def pose_at(t, waves):
    """x and a quaternion, w first, of either sign."""
    x, *turns = (sum(a * math.sin(w * t + p) for a, w, p in wave) for wave in waves)
    q = [mpf(1), mpf(0), mpf(0), mpf(0)]
    for axis, turn in enumerate(turns):
        q = q4.turned(q, [mpf(turn) if axis == i else mpf(0) for i in range(3)])
    return x, [float(rng.choice([1, -1]) * number) for number in map(float, q)]


def check_poses():
    waves = [[(rng.uniform(0.05, 0.6), rng.uniform(0.2, 2), rng.uniform(0, 7)) for _ in range(2)] for _ in range(4)]
    poses = [(0.05 * i, *pose_at(0.05 * i, waves)) for i in range(rng.choice([40, 200]))]
    lines = ["t,x,qw,qx,qy,qz"] + [",".join(map(repr, [t, x, *q])) for t, x, q in poses]
    pathlib.Path(recording_file).write_text("\n".join(lines) + "\n")
    degrees, hermite = rng.choice([2, 0.5, 0.1]), rng.random() < 0.5
    arguments = ["--fit", f"0.02,{degrees}deg", *(["--fit-keys", "hermite"] if hermite else []), "-o", keys_file]
    result = run([*arguments, recording_file])
    if result.returncode != 0:
        fail(result.stderr, arguments)
    names, keys = read(keys_file)
    column = {name: [mpf(row[i]) for row in keys] for i, name in enumerate(names)}
    nothing = [mpf(0)] * len(keys)
    quaternions = list(zip(*(column[f"q{c}"] for c in "wxyz")))
    tension, bias = column.get("tension", nothing), column.get("bias", nothing)
    rows = [(column["t"][i], quaternions[i], (tension[i], mpf(0), bias[i]), (mpf(0), mpf(0))) for i in range(len(keys))]
    curve = q4.Rotations(rows, "squad", "velocity", ["one-sided", "one-sided"])
    if hermite:
        curve.give([(v, v) for v in zip(*(column[f"q{c}_v"] for c in "wxyz"))])
    computed = positions(names, keys, "x", [t for t, _, _ in poses])
    for i, (t, x, q) in enumerate(poses):
        turn = q4.log(q4.product(q4.conjugate(curve.at(mpf(t))[0]), q4.nearest(q, curve.at(mpf(t))[0])))
        angle = math.degrees(2 * q4.norm(turn))
        if angle > degrees + 1e-9 or abs(computed[i] - x) > 0.02 + 1e-9:
            fail(f"line {i + 2} is {angle} degrees and {abs(computed[i] - x)} from the curve", arguments)


for _ in range(count // 10 + 1):
    check_poses()
    check_pieces()
    check_decimal_times()
ratios = {}
for number in range(count):
    kind = ("smooth", "noisy", "uneven", "steps")[number % 4]
    ratios.setdefault(kind, []).append(check(kind))
for kind, all_of_kind in ratios.items():
    print(f"{kind}: {len(all_of_kind)} recordings, {sum(all_of_kind) / len(all_of_kind):.2f} times the bound")
