"""Curves of the Python module against SciPy: scipy_test.py FOLDER

The tangents are computed here, by the formulas of the default preset, and SciPy's CubicHermiteSpline evaluates the curve.
"""

import doctest
import sys
import unittest

sys.path.insert(0, sys.argv.pop())
sys.dont_write_bytecode = True
import numpy as np
from scipy.integrate import quad
from scipy.interpolate import BPoly, CubicHermiteSpline, CubicSpline, PPoly, make_interp_spline
from scipy.spatial.transform import Rotation

import tcbsample


def load_tests(_loader, tests, _pattern):
    examples = doctest.DocTestSuite(sys.modules["tcbsample._curve"])
    tests.addTests(example for example in examples if "ppoly" in example.id())
    return tests


def tangents(keys):
    """Velocities into and out of each key."""
    chords = np.diff(keys["x"]) / np.diff(keys["t"])
    before = np.concatenate([[0], chords[:-1], 2 * chords[-1:]])
    after = np.concatenate([2 * chords[:1], chords[1:], [0]])
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

    def test_curves_are_piecewise_polynomials(self):
        rng = np.random.default_rng(8)
        for closed in (False, True):
            keys = random_keys(rng, 20)
            curve = tcbsample.Curve(keys, period=np.ptp(keys["t"]) + 1 if closed else None)  # which implies closed
            polynomial = curve.to_ppoly()
            times = rng.uniform(keys["t"][0], curve.times[-1], 1000)
            scale = 1 / min(np.diff(keys["t"]))
            for order in range(4):
                np.testing.assert_allclose(polynomial(times, order), curve(times, order), 0, 1e-12 * scale**order)
            again = tcbsample.Curve.from_ppoly(polynomial)
            np.testing.assert_allclose(again(times), curve(times), 0, 1e-13)
            self.assertEqual(polynomial(times.reshape(10, 100)).shape, (10, 100, 1))
            self.assertEqual(polynomial.extrapolate, "periodic" if closed else False)

    def test_curves_of_scipy(self):
        rng = np.random.default_rng(9)
        x, times = np.cumsum(rng.uniform(0.1, 1, 9)), np.linspace(0, 1, 300)
        for shape in ((), (2,), (5,)):
            spline = CubicSpline(x, rng.uniform(-1, 1, (9, *shape)))
            curve = tcbsample.Curve.from_ppoly(spline)
            places = x[0] + times * (x[-1] - x[0])
            np.testing.assert_allclose(curve(places), spline(places).reshape(300, -1), 0, 1e-14)
            self.assertGreater(float(curve.length(x[-1])), 0)
        line = PPoly([[1.0, 2.0], [0.0, 1.0]], [0, 1, 2])
        np.testing.assert_allclose(tcbsample.Curve.from_ppoly(line)([0.5, 1.5])[:, 0], [0.5, 2], 0, 1e-15)
        for wrong, text in ((PPoly(np.ones((6, 1)), [0, 1]), "degree 5"), (PPoly([[1.0, 1.0]], [0, 1, 2]), None),
                            (PPoly([[0.0, 1.0]], [0, 1, 2]), "jumps at 1.0"), (PPoly(np.ones((2, 1, 2, 2)), [0, 1]), "2 dim")):  # fmt: skip
            if text is None:
                tcbsample.Curve.from_ppoly(wrong)
                continue
            with self.assertRaisesRegex(ValueError, text):
                tcbsample.Curve.from_ppoly(wrong)

    def test_what_is_no_spline_of_cubics(self):
        for wrong in (BPoly([[0.0], [2], [1]], [0, 1]), make_interp_spline([0, 1, 2, 3], [1, 2, 0, 1]), np.zeros(3)):
            with self.assertRaisesRegex(TypeError, "expected a PPoly"):
                tcbsample.Curve.from_ppoly(wrong)
        with self.assertRaisesRegex(ValueError, "complex"):
            tcbsample.Curve.from_ppoly(PPoly([[1j], [0]], [0, 1]))

    def test_rotations_are_those_of_scipy(self):
        quaternions = Rotation.random(4, random_state=1).as_quat()
        keys = dict(zip(("t", "qx", "qy", "qz", "qw"), [np.arange(4.0), *quaternions.T]))
        found = Rotation.from_quat(tcbsample.Curve(keys).rotation(np.arange(4.0)))
        self.assertLess((found.inv() * Rotation.from_quat(quaternions)).magnitude().max(), 1e-15)

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
