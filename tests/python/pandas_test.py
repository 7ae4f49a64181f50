"""The Python module with pandas: pandas_test.py FOLDER"""

import sys
import unittest

sys.path.insert(0, sys.argv.pop())
sys.dont_write_bytecode = True
import numpy as np
import pandas as pd

import tcbsample

FRAME = pd.DataFrame({"t": [0, 1, 2], "x": [0.1, 2.5, -1], "y": [1.0, 0.0, 1e-9]})


class Frames(unittest.TestCase):
    def test_a_frame_gives_a_frame_with_the_numbers_of_an_array(self):
        for count in (5, 50000):
            frame = tcbsample.resample(FRAME, count=count)
            array = tcbsample.resample(FRAME.to_numpy(), count=count)
            self.assertIsInstance(frame, pd.DataFrame)
            self.assertEqual(list(frame.columns), ["t", "x", "y"])
            np.testing.assert_array_equal(frame.to_numpy(), array.view(float).reshape(count, 3))
            self.assertTrue((frame.dtypes == np.float64).all())

    def test_numbers_as_names(self):
        frame = tcbsample.resample(FRAME.set_axis([0, 1, 2], axis=1), count=3, columns={"time": "0"})
        self.assertEqual(list(frame.columns), ["0", "1", "2"])

    def test_index(self):
        same = tcbsample.resample(FRAME, count=7)
        pd.testing.assert_frame_equal(tcbsample.resample(FRAME.set_index("t"), count=7), same)
        pd.testing.assert_frame_equal(tcbsample.resample(FRAME.set_index(np.array([5, 9, 2])), count=7), same)
        with self.assertRaisesRegex(TypeError, "rename_axis"):
            tcbsample.resample(FRAME.set_index(pd.date_range("2024", periods=3)), count=7)

    def test_groups_and_text(self):
        frame = pd.concat([FRAME.assign(id="a", name=pd.Series(["u", None, "w"])), FRAME.assign(id="b", name="v")])
        rows = tcbsample.resample(frame, per_segment=2, group="id", columns={"carry": "name"})
        self.assertEqual(rows["id"].tolist(), ["a"] * 5 + ["b"] * 5)
        self.assertEqual(rows["name"].tolist(), ["u", "u", None, None, "w"] + ["v"] * 5)
        grouped = rows.groupby("id")["x"].last()
        self.assertEqual(grouped.tolist(), [-1, -1])

    def test_categories_and_missing_whole_numbers(self):
        frame = FRAME.assign(id=pd.Categorical(["p", "p", "p"]), x=pd.array([0, None, 4], dtype="Int64"))
        rows = tcbsample.resample(frame, count=3, group="id", missing="skip-cell")
        self.assertEqual(rows["x"].tolist(), [0.0, 2.0, 4.0])
        with self.assertRaises(tcbsample.Error) as caught:
            tcbsample.resample(frame, count=3, group="id")
        self.assertEqual(caught.exception.row, 1)

    def test_dates(self):
        times = pd.date_range("2024-03-31T00:30", periods=3, freq="h", tz="Europe/Berlin")
        rows = tcbsample.resample(FRAME.assign(t=times), step=1800, at=None)
        self.assertEqual(rows["t"].dtype, np.dtype("M8[ns]"))
        self.assertEqual(rows["t"].tolist(), pd.date_range("2024-03-30T23:30", periods=5, freq="30min").tolist())
        same = tcbsample.resample(FRAME.assign(t=times), step=pd.Timedelta("30min"), from_=times[0], to=times[2])
        pd.testing.assert_frame_equal(same, rows)
        at = tcbsample.resample(FRAME.assign(t=times), at=times)
        self.assertEqual(at["x"].tolist(), FRAME["x"].tolist())

    def test_fit_and_check(self):
        samples = tcbsample.resample(FRAME, count=100)
        keys = tcbsample.fit(samples, 1e-3)
        self.assertIsInstance(keys, pd.DataFrame)
        self.assertLess(len(keys), 20)
        self.assertTrue(tcbsample.check(keys, samples, abs=1.01e-3))
        self.assertTrue(tcbsample.check(FRAME, samples))
        self.assertFalse(tcbsample.check(FRAME, samples + 1e-6))


unittest.main()
