"""Curves of the Python module against SciPy: scipy_test.py FOLDER

The tangents are computed here, by the formulas of the preset gte, and SciPy's CubicHermiteSpline evaluates the curve.
"""

import sys
import unittest

sys.path.insert(0, sys.argv.pop())
sys.dont_write_bytecode = True
import numpy as np
from scipy.integrate import quad
from scipy.interpolate import BPoly, CubicHermiteSpline

import tcbsample


def tangents(keys):
    """Velocities into and out of each key."""
    chords = np.diff(keys["x"]) / np.diff(keys["t"])
    before = np.concatenate([[0], chords])
    after = np.concatenate([chords, [0]])
    tension, continuity, bias = (keys[name] for name in ("tension", "continuity", "bias"))

    def mean(sign):
        less, more = 1 - sign * continuity, 1 + sign * continuity
        return (1 - tension) * (less * (1 + bias) * before + more * (1 - bias) * after) / 2

    return mean(1), mean(-1)


def random_keys(rng, count):
    keys = np.zeros(count, [(name, float) for name in ("t", "x", "tension", "continuity", "bias")])
    keys["t"] = np.cumsum(rng.uniform(0.1, 3, count)) - 5
    for name in keys.dtype.names[1:]:
        keys[name] = rng.uniform(-1, 1, count)
    return keys


class Curves(unittest.TestCase):
    def test_positions_and_derivatives(self):
        rng = np.random.default_rng(42)
        for count in (2, 3, 10, 100):
            keys = random_keys(rng, count)
            into, out = tangents(keys)
            fields = ["time", "position", "velocity", "acceleration", "segment"]
            rows = tcbsample.resample(keys, per_segment=9, fields=fields)
            for i in range(count - 1):
                piece = CubicHermiteSpline(keys["t"][i : i + 2], keys["x"][i : i + 2], [out[i], into[i + 1]])
                own = rows[rows["segment"] == i]
                self.assertGreaterEqual(len(own), 9)
                scale = 1 / min(np.diff(keys["t"]))
                np.testing.assert_allclose(own["x"], piece(own["t"]), rtol=0, atol=1e-13)
                np.testing.assert_allclose(own["x_v"], piece(own["t"], 1), rtol=0, atol=1e-13 * scale)
                np.testing.assert_allclose(own["x_a"], piece(own["t"], 2), rtol=0, atol=1e-12 * scale**2)

    def test_exact_pieces_are_splines_of_scipy(self):
        keys = random_keys(np.random.default_rng(7), 50)
        rows = tcbsample.resample(keys, at=np.linspace(keys["t"][0], keys["t"][-1], 1000))
        pieces = tcbsample.resample(keys, emit="bezier")
        ends = np.append(pieces["start"], keys["t"][-1])
        spline = BPoly(np.array([pieces[f"x_b{i}"] for i in range(4)]), ends)
        np.testing.assert_allclose(spline(rows["t"]), rows["x"], rtol=0, atol=1e-13)

    def test_lengths(self):
        keys = random_keys(np.random.default_rng(3), 6)
        into, out = tangents(keys)
        length = 0
        for i in range(len(keys) - 1):
            begin, end = keys["t"][i : i + 2]
            speed = CubicHermiteSpline([begin, end], keys["x"][i : i + 2], [out[i], into[i + 1]]).derivative()
            turns = speed.roots(extrapolate=False).tolist()
            length += quad(lambda t: abs(speed(t)), begin, end, points=turns or None, epsabs=1e-13)[0]
        rows = tcbsample.resample(keys, arc_count=11, fields="position,s")
        np.testing.assert_allclose(rows["s"], np.linspace(0, length, 11), rtol=1e-12)


unittest.main()
