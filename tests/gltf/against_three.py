"""Animations as three.js plays them: against_three.py PROGRAM [SEED].

Exact pieces of every preset, of cycles, of rotations by components, and samples are written as glTF, read by three.js,
and compared with the rows of --count, within 1e-6 of their size: the arrays have single precision. Rotations between
samples of --tolerance are within its angle. Exit 77: there is no three.js or no node.
"""
import csv
import io
import json
import math
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

program = sys.argv[1]
draw = random.Random(int(sys.argv[2]) if len(sys.argv) > 2 else 2)
here = Path(__file__).parent
failures = 0
compared = 0
if shutil.which("node") is None:
    print("skipped: there is no node")
    sys.exit(77)


def run(*arguments, text=None):
    return subprocess.run([program, "-q", *arguments], input=text, capture_output=True, text=True, check=True).stdout


def keys(rotations=False, n=6):
    columns = "t,x,y,z,tension,continuity,bias" + (",qx,qy,qz,qw" if rotations else "")
    rows, t = [columns], 0.0
    for _ in range(n):
        row = [t] + [round(draw.uniform(-5, 5), 3) for _ in range(3)] + [round(draw.uniform(-0.9, 0.9), 2) for _ in range(3)]
        if rotations:
            q = [draw.gauss(0, 1) for _ in range(4)]
            size = sum(x * x for x in q) ** 0.5
            row += [x / size for x in q]
        rows.append(",".join(map(str, row)))
        t += draw.choice([0.25, 0.5, 1, 1.75])
    return "\n".join(rows) + "\n"


def played(gltf, times):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "a.gltf"
        file.write_text(gltf)
        done = subprocess.run(["node", str(here / "evaluate.mjs"), str(file), *times], capture_output=True, text=True)
        if done.returncode == 77:
            print(done.stdout)
            sys.exit(77)
        if done.returncode:
            sys.exit(done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]


def angle_between(a, b):
    """Of two rotations, in degrees, from their quaternions, which need not have the length 1."""
    a, b = ([x / math.hypot(*q) for x in q] for q in (a, b))
    chord = min(math.dist(a, b), math.dist(a, [-x for x in b]))
    return math.degrees(4 * math.asin(chord / 2))


def compare_angles(what, text, degrees):
    """Samples within a distance and an angle: the rotations between them are within that angle."""
    global failures, compared
    gltf = run("--tolerance", f"0.01,{degrees}deg", "-f", "gltf", text=text)
    rows = list(csv.DictReader(io.StringIO(run("--count", "501", text=text))))
    for row, nodes in zip(rows, played(gltf, [row["t"] for row in rows]), strict=True):
        (node,) = nodes.values()
        angle = angle_between(node["quaternion"], [float(row[name]) for name in ("qx", "qy", "qz", "qw")])
        compared += 1
        if angle > degrees + 1e-4:  # quaternions have single precision
            failures += 1
            print(f"{what} at {row['t']}: {angle} degrees\n{text}", file=sys.stderr)


def compare(what, text, to_gltf, to_rows):
    global failures, compared
    gltf = run(*to_gltf, "-f", "gltf", text=text)
    rows = list(csv.DictReader(io.StringIO(run(*to_rows, text=text))))
    for row, nodes in zip(rows, played(gltf, [row["t"] for row in rows]), strict=True):
        (node,) = nodes.values()
        groups = [(("x", "y", "z"), node["position"])]
        if "qx" in row:
            size = sum(x * x for x in node["quaternion"]) ** 0.5  # which older versions of three.js do not make 1
            groups.append((("qx", "qy", "qz", "qw"), [x / size for x in node["quaternion"]]))
        for names, got in groups:
            want = [float(row[name]) for name in names]
            sign = -1 if len(names) == 4 and sum(a * b for a, b in zip(got, want)) < 0 else 1
            compared += len(names)
            if max(abs(sign * a - b) for a, b in zip(got, want)) > 1e-6 * max(5, *map(abs, want)):
                failures += 1
                print(f"{what} at {row['t']}: {got}, expected {want}\n{text}", file=sys.stderr)


presets = [preset["name"] for preset in json.loads(run("--generate", "tables"))["presets"]]
for preset in presets:
    if preset == "nerfstudio":  # its timing is no cubic: samples
        compare(preset, keys(), ["--preset", preset, "-n", "33"], ["--preset", preset, "-n", "33"])
        continue
    compare(preset, keys(), ["--preset", preset], ["--preset", preset, "-n", "23"])
compare("closed", keys(), ["--closed", "--period", "20"], ["--closed", "--period", "20", "-n", "23"])
compare("components", keys(True), ["--rotation-curve", "components"], ["--rotation-curve", "components", "-n", "23"])
compare("samples of rotations", keys(True), ["--count", "19"], ["--count", "19"])
compare_angles("rotations within an angle", keys(True), 0.5)
print(f"{compared} numbers, {failures} rows differ")
sys.exit(1 if failures else 0)
