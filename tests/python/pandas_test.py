"""The Python module with pandas: pandas_test.py FOLDER"""

import importlib.util
import sys
import unittest
import warnings

sys.path.insert(0, sys.argv.pop())
sys.dont_write_bytecode = True
import numpy as np
import pandas as pd

import tcbsample

FRAME = pd.DataFrame({"t": [0, 1, 2], "x": [0.1, 2.5, -1], "y": [1.0, 0.0, 1e-9]})


class Frames(unittest.TestCase):
    def test_curves(self):
        dates = pd.date_range("2024-03-31T00:30", periods=3, freq="s", tz="Europe/Berlin")
        curve = tcbsample.Curve(FRAME.drop(columns="t").set_index(dates))
        same = tcbsample.Curve(FRAME)
        for when in (dates, list(dates), dates.to_series(), dates.tz_localize(None).to_period("s").shift(-3600)):
            np.testing.assert_array_equal(curve(when), same([0, 1, 2]))
        self.assertEqual(curve(dates[1]).shape, (2,))
        np.testing.assert_array_equal(curve(dates[0] + pd.Timedelta("250ms")), same(0.25))

    def test_an_index_of_other_whole_numbers_is_the_time_where_no_column_is(self):
        frame = pd.DataFrame({"x": [1.0, 2.0, 4.0]}, index=[0, 10, 30])
        self.assertEqual(tcbsample.resample(frame, at=[10, 30])["x"].tolist(), [2, 4])
        self.assertEqual(tcbsample.Curve(frame).times.tolist(), [0, 10, 30])
        filtered = FRAME.set_axis([3, 7, 9])  # rows of a larger frame
        np.testing.assert_array_equal(tcbsample.resample(filtered, count=3), tcbsample.resample(FRAME, count=3))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", tcbsample.Note)
            uniform = tcbsample.resample(frame, count=3, parameter="uniform")
        self.assertEqual(uniform["t"].tolist(), [0, 1, 2])

    @unittest.skipIf(importlib.util.find_spec("xarray") is None, "there is no xarray")
    def test_data_of_xarray_have_their_coordinate(self):
        import xarray

        times, x = [0, 10, 30], [1.0, 2.0, 4.0]
        one = xarray.DataArray(x, dims=["time"], coords={"time": times})
        self.assertEqual(tcbsample.resample(one, at=[10, 30])["x"].tolist(), [2, 4])
        two = xarray.DataArray(list(zip(x, x)), dims=["n", "c"], coords={"n": times, "c": ["a", "b"]})
        rows = tcbsample.resample(two, at=[30])
        self.assertEqual((list(rows.columns), rows.index.tolist(), rows["b"].tolist()), (["a", "b"], [30], [4]))
        several = xarray.Dataset({"a": ("time", x), "b": ("time", x)}, coords={"time": times, "place": "lab"})
        self.assertEqual(tcbsample.Curve(several)(10).tolist(), [2, 2])
        with self.assertRaisesRegex(TypeError, "'time' has no coordinate"):
            tcbsample.resample(xarray.DataArray(x, dims=["time"]), count=3)
        with self.assertRaisesRegex(TypeError, "expected one, whose coordinate is the time"):
            tcbsample.resample(xarray.DataArray(np.zeros((2, 2, 2))), count=3)

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
        self.assertEqual(list(frame.columns), [0, 1, 2])
        frame = tcbsample.resample(FRAME.set_axis([0, 1, 2], axis=1), count=3)  # nothing says that a column is the time
        self.assertEqual(list(frame.columns), ["t", 0, 1, 2])

    def test_index(self):
        same = tcbsample.resample(FRAME, count=7)
        pd.testing.assert_frame_equal(tcbsample.resample(FRAME.set_index("t"), count=7), same)
        pd.testing.assert_frame_equal(tcbsample.resample(FRAME.set_index(np.array([5, 9, 2])), count=7), same)
        with self.assertRaisesRegex(TypeError, "rename_axis"):
            tcbsample.resample(FRAME.set_index(np.array([0, 0.5, 1])), count=7)
        levels = pd.MultiIndex.from_product([["a"], [0, 1, 2]], names=["id", None])
        with self.assertRaisesRegex(TypeError, "a level of it has none"):
            tcbsample.resample(FRAME.set_index(levels), count=7)
        aware = list(pd.date_range("2024-01-01", periods=3, tz="Asia/Tokyo"))
        rows = tcbsample.resample(FRAME.assign(t=pd.Series(aware, dtype=object)), count=3)
        self.assertEqual((rows["t"].tolist(), rows["t"].dtype), (aware, pd.DatetimeTZDtype(tz="Asia/Tokyo")))
        with self.assertRaisesRegex(TypeError, "'_'.join"):
            tcbsample.resample(pd.concat({"a": FRAME}, axis=1), count=7)

    def test_an_index_of_times_comes_back(self):
        dates = pd.date_range("2024-03-31T00:30", periods=3, freq="h")
        expected = tcbsample.resample(FRAME, count=5)
        for index in (dates, dates.tz_localize("UTC").tz_convert("Europe/Berlin"), dates - dates[0],
                      dates.rename("when"), dates.to_period("h")):  # fmt: skip
            rows = tcbsample.resample(FRAME.drop(columns="t").set_index(index), count=5)
            self.assertEqual(list(rows.columns), ["x", "y"])
            self.assertEqual(rows.index.name, index.name)
            np.testing.assert_array_equal(rows.to_numpy(), expected[["x", "y"]].to_numpy())
            index = index.to_timestamp() if isinstance(index, pd.PeriodIndex) else index
            self.assertEqual(rows.index.dtype, index.dtype)
            self.assertEqual(rows.index[[0, -1]].tolist(), index[[0, -1]].tolist())
        times = FRAME.rename(columns={"t": "time"}).set_index(dates)
        with self.assertWarnsRegex(tcbsample.Note, "ignored: time"):
            tcbsample.resample(times, count=5)
        rows = tcbsample.resample(times, count=5, columns={"time": "time", "ignore": "index_time"})
        self.assertEqual(rows["time"].tolist(), [0, 0.5, 1, 1.5, 2])

    def test_series(self):
        x = FRAME.set_index("t")["x"]
        expected = tcbsample.resample(FRAME[["t", "x"]], count=5)
        for series in (x, x.rename(None), x.set_axis(pd.to_timedelta([0, 1, 2], "s")), x.set_axis([0.0, 1.0, 2.0])):
            rows = tcbsample.resample(series, count=5)
            self.assertIsInstance(rows, pd.DataFrame)
            self.assertEqual(list(rows.columns), ["x"])
            np.testing.assert_array_equal(rows["x"], expected["x"])
            self.assertEqual(rows.index.name, series.index.name)
        for series in (FRAME["x"], FRAME.assign(id="a").set_index(["id", "t"])["x"]):
            with self.assertRaisesRegex(TypeError, "several levels, or only counts its rows"):
                tcbsample.resample(series, count=5)
        self.assertEqual(list(tcbsample.resample(x.rename(("a", "b")), count=5, quiet=True).columns), [("a", "b")])
        dates = pd.DatetimeIndex(["2024-01-01", None, "2024-01-02"])
        with self.assertRaisesRegex(tcbsample.Error, "^keys, row 1: "):
            tcbsample.resample(x.set_axis(dates), count=5)

    def test_durations(self):
        rows = tcbsample.resample(FRAME.assign(t=pd.to_timedelta([0, 1, 2], "ms")), count=5)
        self.assertEqual(rows["t"].tolist(), pd.to_timedelta([0, 0.5, 1, 1.5, 2], "ms").tolist())

    def test_types_of_columns_come_back(self):
        frame = FRAME.assign(id=pd.Categorical(["p", "p", "p"], ["q", "p"]), n=pd.array([1, None, 3], "Int64"),
                             b=pd.array([True, None, False], "boolean"), s=pd.array(["u", None, "w"], "string"),
                             x=pd.array([0, 1, 4], "Int64"), y=pd.array([0.5, 1, 2], "Float64"))  # fmt: skip
        rows = tcbsample.resample(frame, per_segment=1, group="id", columns={"carry": ["n", "b", "s"]})
        for name in ("id", "n", "b", "s"):
            pd.testing.assert_series_equal(rows[name], frame[name], check_names=False)
        dates = pd.to_datetime(["2024-01-02T00:00:00.0", "2024-01-01T00:00:00.5"])
        for values in ([0.5, 2], [True, False], dates, ["a,", "b"]):
            groups = pd.concat([FRAME, FRAME]).assign(id=pd.Categorical(pd.Index(values).repeat(3)))
            again = tcbsample.resample(groups, per_segment=1, group="id")
            pd.testing.assert_series_equal(again["id"], groups["id"], check_index=False)
        self.assertEqual([str(rows[name].dtype) for name in ("t", "x", "y")], ["float64", "Float64", "Float64"])

    def test_errors_name_rows_by_label(self):
        frame = FRAME.assign(x=[0, np.nan, 1]).set_index(pd.Index(["a", "b", "c"], name="key"))
        with self.assertRaises(tcbsample.Error) as caught:
            tcbsample.resample(frame.drop(columns="y"), count=3, columns={"ignore": "key"})
        self.assertEqual(caught.exception.row, 1)
        self.assertIn("keys, row b: ", str(caught.exception))
        with self.assertRaisesRegex(tcbsample.Error, "keys, row 3: .* on row 2;"):
            tcbsample.resample(pd.concat([FRAME, FRAME.iloc[[2]]]), count=3)

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
        self.assertEqual(rows["t"].dtype, times.dtype)
        self.assertEqual(rows["t"].tolist(), pd.date_range(times[0], periods=5, freq="30min").tolist())
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
