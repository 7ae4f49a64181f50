"""The pieces of rotations by components against their rows: rotation_pieces.py PROGRAM [CURVES] [SEED].

Random quaternions in every pattern of signs, open and closed, with missing cells, equal speed and given velocities, with
and without --golden. Each piece is evaluated by Hermite's formula and normalized; it is the rotation of the row at that
time, with the same sign. A piece begins where the last one ends. Exit 1: a number differs, and its command is printed.
"""
import math
import random
import subprocess
import sys

program = sys.argv[1]
curves = int(sys.argv[2]) if len(sys.argv) > 2 else 60
seed = int(sys.argv[3]) if len(sys.argv) > 3 else 20260101
rng = random.Random(seed)
rules = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]
presets = ["gte", "fbx", "nel", "splines", "lib3ds1", "vtk"]
end_rules = ["half", "one-sided", "mirror", "chord", "zero", "natural"]
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
    return [[float(cell) for cell in line.split(",")] for line in done.stdout.splitlines()[1:]]


def quaternion():
    q = [rng.gauss(0, 1) for _ in range(4)]
    size = math.sqrt(sum(x * x for x in q))
    digits = rng.choice([6, 17])
    return [float(f"{x / size:.{digits}g}") for x in q]


def hermite(piece, channel, t):
    start, h = piece[0], piece[1]
    p, v, q, w = piece[2 + 4 * channel:6 + 4 * channel]
    u = (t - start) / h
    return (p * (1 + 2 * u) * (1 - u) ** 2 + h * v * u * (1 - u) ** 2 + q * u * u * (3 - 2 * u) + h * w * u * u * (u - 1))


for number in range(curves):
    count = rng.choice([2, 3, 4, 5, 7])
    closed = rng.random() < 0.6
    sparse = count > 3 and rng.random() < 0.3
    times = [0.0]
    for _ in range(count):
        times.append(times[-1] + rng.choice([1.0, 0.5, rng.uniform(0.1, 3)]))
    keys = [[str(x) for x in quaternion()] for _ in range(count)]
    holes = set()
    if sparse:
        holes = set(rng.sample(range(count), count - 3))
        for key in holes:
            keys[key] = [""] * 4
    given = not sparse and rng.random() < 0.25
    names = "t,x,qx,qy,qz,qw,tension" + (",qx_v,qy_v,qz_v,qw_v" if given else "")
    lines = [names]
    for t, q in zip(times, keys):
        velocities = [repr(round(rng.uniform(-1, 1), 3)) for _ in range(4)] if given else []
        lines.append(",".join([repr(t), repr(rng.uniform(-5, 5)), *q, rng.choice(["0", "0.5", "-1"]), *velocities]))
    text = "\n".join(lines) + "\n"
    options = ["--rotation-curve", "components"]
    options += ["--preset", rng.choice(presets)] if rng.random() < 0.5 else ["--tangents", rng.choice(rules)]
    options += ["--no-ease"] if rng.random() < 0.5 else []
    if closed:
        options += ["--period", repr(times[-1])]
    elif "--preset" not in options:
        options += ["--ends", rng.choice(end_rules)]
    options += ["--equal-speed"] if not given and not sparse and rng.random() < 0.3 else []
    options += ["--missing", "skip-cell"] if sparse else []
    options += ["--golden"] if rng.random() < 0.3 else []
    what = f"seed {seed} curve {number}: {' '.join(options)}\n{text}"
    pieces = run(text, options + ["--emit", "hermite"])
    rows = run(text, options + ["--per-segment", "5"])
    require(len(pieces) == (count if closed else count - 1), f"{len(pieces)} pieces: {what}")
    before = None
    for piece in pieces:
        for row in rows:
            if not piece[0] <= row[0] <= piece[0] + piece[1]:
                continue
            if row[0] == piece[0] + piece[1] and piece is not pieces[-1]:
                continue
            q = [hermite(piece, 1 + i, row[0]) for i in range(4)]
            size = math.sqrt(sum(x * x for x in q))
            error = max(abs(x / size - y) for x, y in zip(q, row[2:6]))
            require(error <= 4e-15 / min(size, 1), f"at {row[0]} {row[2:6]}, expected {[x / size for x in q]}: {what}")
        start = [piece[2 + 4 * (1 + i)] for i in range(4)]
        require(before is None or before == start, f"a piece begins at {start}, the last one ends at {before}: {what}")
        before = [piece[4 + 4 * (1 + i)] for i in range(4)]

print(f"{curves} curves, {compared} comparisons, {failures} differ")
sys.exit(1 if failures else 0)
