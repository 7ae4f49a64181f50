"""Building of Python's Curve beside that of SciPy's CubicSpline, on 100,000 keys of three channels in the same run, and
the whole length, which is asked once: scipy_curve.py FOLDER, which make_wheel.py --module made. Exit 1: more than 10
times as long."""

import os
import sys
import time

sys.path.insert(0, sys.argv[1])
import numpy as np
from scipy.interpolate import CubicSpline

import tcbsample

rng = np.random.default_rng(1)
count = 100_000
times, positions = np.cumsum(rng.uniform(0.5, 1.5, count)), rng.standard_normal((count, 3))


def processor_time():
    return sum(os.times()[:4])  # with that of the program


def least(function, runs=7):
    found = []
    for _ in range(runs):
        wall, processor = time.perf_counter(), processor_time()
        function()
        found.append((time.perf_counter() - wall, processor_time() - processor))
    return [min(column) for column in zip(*found)]


theirs = least(lambda: CubicSpline(times, positions, bc_type="natural"))
ours = least(lambda: tcbsample.Curve(times, positions))
print("seconds, and of the processor: SciPy {:.3f} {:.3f}, Curve {:.3f} {:.3f}".format(*theirs, *ours))
print("Curve / SciPy: {:.1f}, {:.1f}".format(*(own / other for own, other in zip(ours, theirs))))
curve = tcbsample.Curve(times, positions)
for call in ("first", "second"):
    print("length, {} call: {:.6f}".format(call, least(curve.length, 1)[0]))
sys.exit(ours[0] > 10 * theirs[0])
