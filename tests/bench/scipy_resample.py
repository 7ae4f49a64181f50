"""Resamples keys as one does with SciPy and pandas: scipy_resample.py uniform|arc COUNT KEYS.csv.

The curve is tcbsample's default at tension, continuity and bias 0: at a key the mean of the velocities on both sides,
at an end that of the only one. Arc lengths by Gauss-Legendre rules, inverted by Newton's method.
"""

import platform
import sys

import numpy
import pandas
import scipy
from scipy.interpolate import CubicHermiteSpline


def slopes(t, points):
    chords = numpy.diff(points, axis=0) / numpy.diff(t)[:, None]
    return (numpy.vstack([chords[:1], chords]) + numpy.vstack([chords, chords[-1:]])) / 2


def times_at_equal_lengths(curve, count):
    velocity, t = curve.derivative(), curve.x
    rule = list(zip(*numpy.polynomial.legendre.leggauss(8)))

    def speed(time):
        return numpy.linalg.norm(velocity(time), axis=1)

    def length(begin, end):
        middle, half = (begin + end) / 2, (end - begin) / 2
        return half * sum(weight * speed(middle + half * node) for node, weight in rule)

    s = numpy.concatenate([[0], numpy.cumsum(length(t[:-1], t[1:]))])
    wanted = numpy.linspace(0, s[-1], count)
    segment = numpy.clip(numpy.searchsorted(s, wanted, side="right") - 1, 0, len(t) - 2)
    begin, end, before = t[segment], t[segment + 1], s[segment]
    time = begin + (end - begin) * (wanted - before) / (s[segment + 1] - before)
    for _ in range(3):
        time = numpy.clip(time - (before + length(begin, time) - wanted) / speed(time), begin, end)
    return time


def main():
    if sys.argv[1] == "--versions":
        print(f"SciPy {scipy.__version__}, NumPy {numpy.__version__}, pandas {pandas.__version__}, "
              f"Python {platform.python_version()}")
        return
    mode, count, path = sys.argv[1], int(sys.argv[2]), sys.argv[3]
    keys = pandas.read_csv(path)
    t, points = keys["time"].to_numpy(), keys[["x", "y", "z"]].to_numpy()
    curve = CubicHermiteSpline(t, points, slopes(t, points))
    time = numpy.linspace(t[0], t[-1], count) if mode == "uniform" else times_at_equal_lengths(curve, count)
    rows = pandas.DataFrame(curve(time), columns=["x", "y", "z"])
    rows.insert(0, "time", time)
    rows.to_csv(sys.stdout, index=False)


main()
