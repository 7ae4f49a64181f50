"""SciPy's splines of the curve through keys: scipy_spline.py KEYS TIME...

The positions at these times, by PPoly from the coefficients and by CubicHermiteSpline from the velocities.
"""
import io
import subprocess
import sys

import numpy
from scipy.interpolate import CubicHermiteSpline, PPoly


def pieces(form, path, *options):
    """The start of each piece and the end of the last one, and its numbers: piece, channel, number."""
    words = ["tcbsample", "--emit", form, "-f", "npy", *options, path]
    table = numpy.load(io.BytesIO(subprocess.run(words, check=True, capture_output=True).stdout))
    knots = numpy.append(table[:, 0], table[-1, 0] + table[-1, 1])
    return knots, table[:, 2:].reshape(len(table), -1, 4)


def polynomial(path, *options):
    """The curve as a PPoly, whose coefficients are in descending order."""
    knots, numbers = pieces("poly", path, *options)
    return PPoly(numbers[:, :, ::-1].transpose(2, 0, 1), knots)


def hermite(path, *options):
    """The curve as a CubicHermiteSpline, where no key has a corner."""
    knots, numbers = pieces("hermite", path, *options)
    at_knots = numpy.append(numbers[:, :, :2], numbers[-1:, :, 2:], axis=0)
    return CubicHermiteSpline(knots, at_knots[:, :, 0], at_knots[:, :, 1])


if __name__ == "__main__":
    times = [float(text) for text in sys.argv[2:]]
    for spline in (polynomial(sys.argv[1]), hermite(sys.argv[1])):
        print(type(spline).__name__)
        for t, position in zip(times, spline(times)):
            print(t, *(f"{value:.6f}" for value in position))
