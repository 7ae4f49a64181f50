"""Resamples poses as one does with SciPy: scipy_rotations.py slerp|spline COUNT RECORDING.

The recording is in the format of TUM: time, position, quaternion, separated by spaces, # before comments. Positions by
cubic splines with the slopes of tcbsample's default; rotations by Slerp or by RotationSpline, which is smoother.
"""

import sys

import numpy
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation, RotationSpline, Slerp

names = ["time", "tx", "ty", "tz", "qx", "qy", "qz", "qw"]
kind, count, path = sys.argv[1], int(sys.argv[2]), sys.argv[3]
keys = numpy.loadtxt(path)
t, points = keys[:, 0] - keys[0, 0], keys[:, 1:4]
chords, zero = numpy.diff(points, axis=0) / numpy.diff(t)[:, None], numpy.zeros((1, 3))
positions = CubicHermiteSpline(t, points, (numpy.vstack([zero, chords]) + numpy.vstack([chords, zero])) / 2)
rotations = {"slerp": Slerp, "spline": RotationSpline}[kind](t, Rotation.from_quat(keys[:, 4:]))
times = numpy.linspace(t[0], t[-1], count)
rows = numpy.column_stack([times + keys[0, 0], positions(times), rotations(times).as_quat()])
sys.stdout.write("\n".join([",".join(names), *(",".join(map(repr, row)) for row in rows.tolist())]) + "\n")
