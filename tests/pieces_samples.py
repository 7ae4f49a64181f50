"""The programs in samples/pieces against the program's own samples: pieces_samples.py random|scipy PROGRAM FOLDER.

A quadcopter's trajectory and the data of an SVG path; or SciPy's splines. Exit 1: a number differs.
"""
import csv
import io
import os
import subprocess
import sys

sys.dont_write_bytecode = True
module, program, folder = sys.argv[1], os.path.abspath(sys.argv[2]), os.path.abspath(sys.argv[3])
os.environ["PATH"] = os.path.dirname(program) + os.pathsep + os.environ["PATH"]
sys.path.insert(0, folder)
os.chdir(folder)
keys = "flight.csv"


def output(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def samples(*options):
    rows = list(csv.reader(io.StringIO(output("tcbsample", "-q", *options, keys))))[1:]
    return [[float(cell) for cell in row] for row in rows]


def compare(what, got, want, bound):
    largest = max(abs(g - w) for g, w in zip(got, want, strict=True))
    print(f"{what}: {len(got)} numbers, largest difference {largest:.1e}")
    if not largest <= bound:
        sys.exit(f"{what} differs")


def flat(rows):
    return [number for row in rows for number in row]


def de_casteljau(points, u):
    while len(points) > 1:
        points = [[p + u * (q - p) for p, q in zip(a, b)] for a, b in zip(points, points[1:])]
    return points[0]


if module == "scipy":
    import scipy_spline

    rows = samples("--step", "1/64", "--columns", "position=x:y:z:yaw", "--fields", "time,position,velocity,acceleration")
    times = [row[0] for row in rows]
    for spline in (scipy_spline.polynomial(keys), scipy_spline.hermite(keys)):
        name = type(spline).__name__
        compare(name, flat(spline(times)), flat(row[1:5] for row in rows), 1e-14)
        compare(f"{name}, velocity", flat(spline(times, 1)), flat(row[5:9] for row in rows), 1e-13)
        compare(f"{name}, acceleration", flat(spline(times, 2)), flat(row[9:] for row in rows), 1e-12)
else:
    import trajectory

    pieces = [[row[1], *flat([*row[first:first + 4], 0, 0, 0, 0] for first in range(2, len(row), 4))]
              for row in samples("--emit", "poly", "--columns", "position=x:y:z:yaw")]
    rows = samples("--step", "1/64", "--columns", "position=x:y:z:yaw")
    compare("trajectory", flat(trajectory.position(pieces, row[0]) for row in rows), flat(row[1:] for row in rows), 1e-14)

    words = output("sh", "svg_path.sh", keys, "x", "y").replace("M", " ").replace("C", " ").replace(",", " ").split()
    numbers = [float(word) for word in words]
    points = list(zip(numbers[::2], numbers[1::2]))
    on_path = [de_casteljau(points[first:first + 4], step / 8)
               for first in range(0, len(points) - 1, 3) for step in range(8)] + [points[-1]]
    rows = samples("--per-segment", "8", "--columns", "position=x:y")
    compare("SVG path", flat(on_path), flat(row[1:] for row in rows), 1e-14)
