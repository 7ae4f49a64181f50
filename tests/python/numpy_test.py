"""The Python module with NumPy: its examples, inputs, outputs, options and errors. numpy_test.py FOLDER"""

import array
import datetime
import decimal
import doctest
import fractions
import inspect
import io
import json
import os
import pathlib
import pydoc
import re
import runpy
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings

sys.path.insert(0, sys.argv.pop())
sys.dont_write_bytecode = True
import numpy as np

import tcbsample
from tcbsample._command_only import COMMAND_ONLY
from tcbsample._options import OPTIONS, PlotOptions
from tcbsample._program import _TEXT_OPTIONS, in_python, run_of
from tcbsample._tables import text

SAMPLES = pathlib.Path(__file__).parents[2] / "samples"
KEYS = np.array([[0, 0.1, -3.25], [1, 2 / 3, 1e-5], [2.5, -7.7, 3], [4, 0.5, 123456.789]])


def load_tests(_loader, tests, _pattern):
    for name in ("_curve", "_functions", "_program"):
        examples = doctest.DocTestSuite(sys.modules[f"tcbsample.{name}"])
        tests.addTests(example for example in examples if "ppoly" not in example.id())  # which need SciPy
    return tests


def command(*words, data=b""):
    return subprocess.run([tcbsample.program(), *words], input=data, capture_output=True, check=True).stdout


def command_rows(*words, data):
    """What the command line prints, with the bits of each number."""
    lines = command(*words, "--hex", data=data).decode().split()
    return [tuple(float.fromhex(cell) for cell in line.split(",")) for line in lines if not line.startswith("t")]



class Inputs(unittest.TestCase):
    """Each kind of input gives the same bits as the command line."""

    def setUp(self):
        # Reading is tested with hexadecimal numbers elsewhere; here, decimals with all digits.
        self.data = "".join(",".join(map(repr, row)) + "\n" for row in KEYS.tolist()).encode()
        self.expected = command_rows("--step", "0.01", data=self.data)

    def same(self, rows):
        self.assertEqual(rows.dtype.names, ("t", "x", "y"))
        self.assertEqual(rows.tolist(), self.expected)

    def test_arrays(self):
        self.same(tcbsample.resample(KEYS, step=0.01))
        self.same(tcbsample.resample(KEYS.tolist(), step=0.01))
        self.same(tcbsample.resample(np.asfortranarray(KEYS)[:, ::1], step="0.01"))
        fields = np.rec.fromarrays(KEYS.T, names="t,x,y")
        self.same(tcbsample.resample(fields, step=fractions.Fraction(1, 100)))
        self.same(tcbsample.resample({"t": KEYS[:, 0], "x": KEYS[:, 1], "y": list(KEYS[:, 2])}, step=0.01))

    def test_texts(self):
        self.same(tcbsample.resample(self.data, step=0.01))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "-keys.csv")
            path.write_bytes(self.data)
            self.same(tcbsample.resample(path, step=0.01))
            self.same(tcbsample.resample(str(path), step=0.01))

    def test_open_files(self):
        self.same(tcbsample.resample(io.BytesIO(self.data), step=0.01))
        self.same(tcbsample.resample(io.StringIO(self.data.decode()), step=0.01))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "keys.csv")
            path.write_bytes(self.data)
            for mode in ("r", "rb"):
                with open(path, mode) as file:
                    self.same(tcbsample.resample(file, step=0.01))
            with open(path) as file, self.assertRaises(tcbsample.Error) as caught:
                tcbsample.resample(file, count=0, columns="tension=9")
            self.assertTrue(tcbsample.check(KEYS, io.BytesIO(self.data)))
            path.write_text("t,x\n0,1\n1,o.5\n")
            with open(path) as file, self.assertRaises(tcbsample.Error) as caught:
                tcbsample.resample(file, count=3)
            self.assertEqual((caught.exception.file, caught.exception.line), (str(path), 3))

    def test_pairs_and_rows(self):
        self.same(tcbsample.resample((KEYS[:, 0], KEYS[:, 1:]), step=0.01))
        self.same(tcbsample.resample((KEYS[:, 0].tolist(), KEYS[:, 1:].tolist()), step=0.01))
        self.same(tcbsample.resample([tuple(row) for row in KEYS.tolist()], step=0.01))
        self.same(tcbsample.resample([dict(zip("txy", row)) for row in KEYS.tolist()], step=0.01))
        self.same(tcbsample.resample((dict(zip("txy", row)) for row in KEYS.tolist()), step=0.01))
        rows = [{"t": 0, "x": 1}, {"t": 1, "x": 2, "y": 1}, {"t": 2, "y": 3, "x": 0}, {"t": 3, "y": 2, "x": 0}]
        sparse = tcbsample.resample(rows, at=[2], missing="skip-cell", ends="chord")
        self.assertEqual(sparse.dtype.names, ("t", "x", "y"))
        with self.assertRaisesRegex(ValueError, "expected n times"):
            tcbsample.resample(([0, 1, 2], [0, 1]), count=3)

    def test_single_precision_and_whole_numbers(self):
        single = KEYS.astype(np.float32)
        double = single.astype(float)
        np.testing.assert_array_equal(tcbsample.resample(single, count=9), tcbsample.resample(double, count=9))
        np.testing.assert_array_equal(
            tcbsample.resample(np.array([[0, 1], [1, 3], [2, 2]]), count=9),
            tcbsample.resample(np.array([[0, 1], [1, 3], [2, 2.0]]), count=9),
        )

    def test_every_bit_of_random_numbers_comes_back(self):
        rng = np.random.default_rng(5)
        for count in (20, 5000):  # as lines and as an array
            numbers = rng.uniform(-1, 1, (count, 3)) * 2.0 ** rng.integers(-1074, 400, (count, 3))
            numbers[::4, 1] = -0.0
            numbers[:, 0] = np.cumsum(rng.uniform(0, 1, count)) / 3
            rows = tcbsample.resample(numbers, per_segment=1)  # a row at each key is the key
            np.testing.assert_array_equal(rows.view(np.uint64).reshape(count, 3), numbers.view(np.uint64))

    def test_names_of_columns(self):
        names = ["t", "a,b", 'c"d', "#e", " f", "7", "ü", "g\nh"]
        rows = tcbsample.resample({name: [i, i + 1] for i, name in enumerate(names)}, at=[names.index("t")])
        self.assertEqual(list(rows.dtype.names), names)
        self.assertEqual(list(rows[0]), list(range(len(names))))

    def test_parameters_of_keys(self):
        rows = tcbsample.resample({"t": [0, 1, 2], "x": [0, 2, 0], "tension": [1, 1, 1]}, at=[0.5])
        self.assertEqual(rows.tolist(), [(0.5, 1.0)])  # without tangents, half way
        same = tcbsample.resample([[0, 0, 1], [1, 2, 1], [2, 0, 1]], columns={"tension": 3}, at=0.5)
        self.assertEqual(same.tolist(), rows.tolist())

    def test_missing_cells_are_told(self):
        for values in ([1.5, np.nan, 2], [1.5, None, 2], np.ma.array([1.5, 9, 2], mask=[0, 1, 0])):
            for keys, options in (({"x": values}, {"parameter": "uniform"}), ({"t": range(3), "x": values}, {}),
                                  ({"t": range(3), "x": range(3), "id": values}, {"group": "id"})):  # fmt: skip
                with self.assertRaisesRegex(tcbsample.Error, "keys, row 1: .*found an empty cell"):
                    tcbsample.resample(keys, count=3, **options)

    def test_columns_of_lists_have_their_own_types(self):
        begin = 1_700_000_000_000_000_001
        rows = tcbsample.resample([[begin, 0.5], [begin + 100, 2**60]], per_segment=1, quiet=True)
        self.assertEqual(rows.tolist(), [(begin, 0.5), (begin + 100, 2.0**60)])

    def test_frames_of_other_libraries_keep_their_names(self):
        frame = type("DataFrame", (list,), {"__dataframe__": None, "__module__": "polars.dataframe"})([[0, 1], [1, 2]])
        with self.assertRaisesRegex(TypeError, r"DataFrame of polars; .* to_pandas\(\)"):
            tcbsample.resample(frame, count=3)

    def test_what_is_no_table(self):
        for keys in ([0, 1, 2], np.zeros((2, 2, 2)), {"t": [0, 1], "x": [1]}, {"t": [0, 1], "xy": [[1, 2], [3, 4]]}, 7,
                     [[0, 1], [1]], ([], []), {"t": np.array(["1500-01-01"], "M8[D]"), "x": [1]}):  # fmt: skip
            with self.assertRaises((TypeError, ValueError)):
                tcbsample.resample(keys, count=3)
        with self.assertRaisesRegex(TypeError, "delimiter: describes text"):
            tcbsample.resample(KEYS, count=3, delimiter=";")


class Outputs(unittest.TestCase):
    def test_few_and_many_rows_have_the_same_bits(self):
        many = tcbsample.resample(KEYS, step="1/20000")
        few = tcbsample.resample(KEYS, step="1/1000")
        self.assertEqual(len(many), 80001)
        self.assertEqual(many[::20].tolist(), few.tolist())
        self.assertEqual(many.dtype, few.dtype)

    def test_undefined_values_are_nan(self):
        for count in (3, 30000):
            rows = tcbsample.resample([[0, 0], [1, 1]], count=count, tangents="uniform", fields="time,key,torsion")
            self.assertEqual(rows["key"][[0, -1]].tolist(), [0, 1])
            self.assertTrue(np.isnan(rows["key"][1:-1]).all())
            self.assertEqual(rows.dtype["torsion"], np.float64)

    def test_groups_and_labels(self):
        keys = {"id": [7, 7, 8, 8], "t": [0, 1, 0, 1], "x": [0, 1, 2, 3], "name": ["a", "b", "c", 'd,"']}
        for count, columns in ((3, {"carry": "name"}), (3000, "carry=name")):
            rows = tcbsample.resample(keys, count=count, group="id", columns=columns)
            self.assertEqual(rows.dtype.names, ("id", "t", "x", "name"))
            self.assertEqual((rows["id"].dtype, rows["x"].dtype), (np.int64, np.float64))
            self.assertEqual(rows[-1].item(), (8, 1.0, 3.0, 'd,"'))
            self.assertEqual(len(rows), 2 * count)

    def test_groups_and_labels_keep_their_type(self):
        for values in (np.array([3, 4], np.uint8), np.array([0.5, 1e300]), np.array(["1", "007"]),
                       np.array([True, False]), np.array(["2024-01-01T00:00:00.5", "2024-01-02"], "M8[ns]"),
                       np.array(["a\nb", 'c,"']), np.array(["x", "1", "-0"], object)):  # fmt: skip
            size = 2 * len(values)
            keys = {"id": values.repeat(2), "t": np.arange(size) % 2, "x": range(size)}
            rows = tcbsample.resample(keys, count=3, group="id")
            self.assertEqual(rows["id"].dtype, values.dtype)
            self.assertEqual(rows["id"].tolist(), values.repeat(3).tolist())
            rows = tcbsample.resample(dict(keys, t=range(size)), count=size, columns={"carry": ["id"]})
            self.assertEqual(rows["id"].dtype, values.dtype)
            self.assertEqual(rows["id"].tolist(), values.repeat(2).tolist())

    def test_missing_labels(self):
        keys = {"t": [0, 1, 2], "x": [0, 1, 2], "n": [1.5, np.nan, 2]}
        rows = tcbsample.resample(keys, count=3, columns={"carry": "n"})
        self.assertEqual((rows["n"][[0, 2]].tolist(), np.isnan(rows["n"][1])), ([1.5, 2], True))
        rows = tcbsample.resample(dict(keys, n=["a", "", "b"]), count=3, columns={"carry": "n"})
        self.assertEqual(rows["n"].tolist(), ["a", "", "b"])

    def test_curves_after_breaks_are_counted(self):
        keys = [[0, 0], [1, 1], [2, np.nan], [3, 3], [4, 4]]
        rows = tcbsample.resample(keys, per_segment=1, missing="break")
        self.assertEqual(rows.tolist(), [(0, 0, 0), (0, 1, 1), (1, 3, 3), (1, 4, 4)])
        self.assertEqual(rows.dtype.names[0], "curve")
        self.assertEqual(tcbsample.resample(keys[:2], count=2, missing="break")["curve"].tolist(), [0, 0])

    def test_whole_times_beyond_doubles(self):
        begin = 1_700_000_000_000_000_001
        for step in (10**5, 10**2):
            rows = tcbsample.resample({"t": [begin, begin + 10**6], "x": [0, 1]}, step=step, quiet=True)
            self.assertEqual(rows["t"].tolist(), list(range(begin, begin + 10**6 + 1, step)))

    def test_masked_numbers_are_missing(self):
        keys = np.ma.array([[0, 0], [1, 5], [2, 4], [3, 3]], mask=[[0, 0], [0, 1], [0, 0], [0, 0]], dtype=float)
        rows = tcbsample.resample(keys, count=4, missing="skip-row")
        np.testing.assert_array_equal(rows, tcbsample.resample(keys.data[[0, 2, 3]], count=4))
        with self.assertRaises(tcbsample.Error) as caught:
            tcbsample.resample({"t": keys[:, 0], "x": keys[:, 1]}, count=4)
        self.assertEqual(caught.exception.row, 1)

    def test_large_positions(self):
        for count in (3, 30000):
            for numbers in ([1e19, -1e300], [2.0**60, 2.0**60]):
                rows = tcbsample.resample(np.column_stack([[0, 1], numbers]), count=count)
                self.assertEqual(rows["x"][[0, -1]].tolist(), numbers)
                self.assertEqual(rows.dtype["x"], np.float64)

    def test_dates(self):
        times = np.array(["2024-02-28T23:00", "2024-02-29T01:00"], "M8[m]")
        rows = tcbsample.resample({"time": times, "x": [0, 1]}, count=3)
        self.assertEqual(rows["time"].dtype, np.dtype("M8[ns]"))
        self.assertEqual(rows["time"][1], np.datetime64("2024-02-29T00:00"))
        self.assertEqual(tcbsample.resample({"time": times, "x": [0, 1]}, at=times[:1])["x"].tolist(), [0])

    def test_durations(self):
        times = np.array([0, 1500, 4000], "m8[ms]")
        for count in (9, 40001):
            rows = tcbsample.resample({"t": times, "x": [0, 1, 2]}, count=count)
            self.assertEqual(rows["t"].dtype, np.dtype("m8[ns]"))
            self.assertEqual(rows["t"][[0, -1]].tolist(), [0, 4 * 10**9])
        self.assertEqual(tcbsample.resample({"t": times, "x": [0, 1, 2]}, at=[1.5])["x"].tolist(), [1])
        rows = tcbsample.resample((times, [0, 1, 2]), at=1.5, fields="position,time,speed")
        self.assertEqual([rows.dtype[name].kind for name in ("x", "t", "speed")], ["f", "m", "f"])
        dates = [datetime.datetime(2024, 1, 1, hour, tzinfo=datetime.timezone.utc) for hour in (0, 2)]
        rows = tcbsample.resample(list(zip(dates, [0.0, 1.0])), count=3)
        self.assertEqual(rows["t"][1], np.datetime64("2024-01-01T01:00"))

    def test_pictures(self):
        picture = tcbsample.plot(KEYS, check=tcbsample.resample(KEYS, count=7))
        self.assertIn("check passed", picture._repr_svg_())
        lists = tcbsample.plot(KEYS, axes=("y", "x"), size=[640, 480])
        self.assertEqual(lists.svg, tcbsample.plot(KEYS, axes="y:x", size="640x480").svg)
        self.assertTrue(picture._repr_html_().startswith('<img src="data:image/svg+xml;base64,'))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "a.svg")
            picture.save(path)
            self.assertEqual(path.read_bytes().decode(), picture.svg)
            path = pathlib.Path(folder, "a.png")
            try:
                picture.save(path)
                self.assertEqual(path.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
            except RuntimeError as error:
                self.assertRegex(str(error), "cairosvg.*rsvg-convert")
            with self.assertRaisesRegex(ValueError, "svg or .png"):
                picture.save(pathlib.Path(folder, "a.jpg"))

    def test_comparisons(self):
        samples = tcbsample.resample(KEYS, step="1/8", preset="vtk")
        self.assertFalse(tcbsample.check(KEYS, samples))
        report = tcbsample.check(KEYS, samples, preset="vtk", step="1/8")
        self.assertTrue(report)
        self.assertEqual((report["file"], report["keys"], report["rows"]), ("samples", "keys", len(samples)))
        self.assertFalse(tcbsample.check(KEYS, samples[1:], preset="vtk", step="1/8"))
        self.assertTrue(tcbsample.check(KEYS, samples, abs={"x": 1e9, "y": 1e9}, rel=None))
        other = samples.copy()
        other["y"][5] = 7
        report = tcbsample.check(KEYS, other, preset="vtk")
        self.assertEqual((report["worst"]["row"], report["worst"]["line"]), (5, None))
        self.assertRegex(repr(report), r"^<Report: differs, passed=False, .*mismatches=1>$")
        self.assertIn("the first, in row 1,", tcbsample.check(KEYS, [[0, 0.1, -3.25], [5, 0, 0]])["problems"][0])
        self.assertTrue(tcbsample.identify(KEYS, samples))

    def test_nothing_is_left_behind(self):
        before = set(os.listdir(tempfile.gettempdir()))
        tcbsample.check(KEYS, KEYS)
        tcbsample.resample(KEYS, at=np.linspace(0, 4, 1000))
        with self.assertRaises(tcbsample.Error):
            tcbsample.check(KEYS, {"x": [9]})
        left = [name for name in set(os.listdir(tempfile.gettempdir())) - before if name.startswith("tcbsample")]
        self.assertEqual(left, [])


class PairsTest(unittest.TestCase):
    def test_pairs_of_any_sequences(self):
        times, x = [0.0, 1.0, 3.0], [1.0, 2.0, 5.0]
        expected = tcbsample.resample((times, x), at=[3])
        for kind in (tuple, np.array, lambda v: array.array("d", v), lambda v: memoryview(array.array("d", v))):
            self.assertEqual(tcbsample.resample((kind(times), kind(x)), at=[3]), expected)
        self.assertEqual(expected.tolist(), [(3.0, 5.0)])
        self.assertEqual(tcbsample.Curve(times, x)(3).tolist(), [5])
        self.assertEqual(tcbsample.Curve(times, np.zeros((3, 2)))(3).tolist(), [0, 0])


class ProductsTest(unittest.TestCase):
    def test_the_whole_length(self):
        curve = tcbsample.Curve([[0, 0, 0], [1, 3, 4]])
        with unittest.mock.patch("subprocess.Popen", wraps=subprocess.Popen) as runs:
            self.assertEqual([float(curve.length()), float(curve.length())], [5, 5])
        self.assertEqual(runs.call_count, 1)

    def test_limits(self):
        keys = [[0, 0], [1, 3]]  # at a constant speed of 3 with the ends of chords
        report = tcbsample.limits(keys, {"speed": 2}, ends="chord")
        self.assertEqual((bool(report), report["keys"], report["limits"][0]["maximum"]), (False, "keys", 3))
        self.assertTrue(tcbsample.limits(keys, {"speed": 3}, ends="chord"))
        self.assertGreater(len(tcbsample.limits(keys)["limits"]), 3)

    def test_the_module_runs_the_program(self):
        folder = pathlib.Path(tcbsample.__file__).parent.parent
        command = [sys.executable, "-m", "tcbsample", "--version"]
        done = subprocess.run(command, capture_output=True, text=True, cwd=folder, check=True)
        self.assertEqual(done.stdout, f"tcbsample {tcbsample.__version__}\n")

    def test_explain_speaks_of_arrays(self):
        text = tcbsample.explain([[0, 1], [1, 2]])
        self.assertTrue(text.startswith("data: 2 rows of 2 columns\ntime: t\n"), text)

    def test_signatures_show_the_usual_options(self):
        for function in (tcbsample.resample, tcbsample.check, tcbsample.plot, tcbsample.explain):
            names = set(inspect.signature(function).parameters)
            self.assertLessEqual({"fps", "group", "columns", "tcb"}, names)


class OptionsTest(unittest.TestCase):
    def test_what_is_meant(self):
        keys = [[0, 1], [1, 2]]
        for call, message in (
            (lambda: tcbsample.Curve(keys, tension=0.5), r"tcb=\(T, C, B\)"),
            (lambda: tcbsample.resample("t,x\n0,1\n1,2\n", count=3), "io.StringIO"),
            (lambda: tcbsample.resample(keys, count=3, sort=np.float64(3)), "sort: 3.0; expected True or False"),
        ):
            with self.assertRaisesRegex(TypeError, message):
                call()
        with self.assertRaisesRegex(tcbsample.Error, 'extrapolate="hold"'):
            tcbsample.Curve(keys)(np.nextafter(1, 2))

    def test_every_option_of_the_command_line_is_known(self):
        help_text = command("--help").decode()
        names = re.findall(r"--[a-z-]+", "\n".join(re.findall(r"^  (-.*)$", help_text, re.MULTILINE)))
        self.assertGreater(len(names), 90)
        self.assertEqual(sorted(names), sorted(option.name for option in OPTIONS.values()))
        taken = {name.rstrip("_") for name in PlotOptions.__annotations__} - {"check", "identify", "fit"}
        self.assertEqual(taken | set(COMMAND_ONLY), set(OPTIONS))
        self.assertFalse(taken & set(COMMAND_ONLY))
        self.assertLessEqual(set(_TEXT_OPTIONS), taken)
        for name in taken:
            self.assertRegex(tcbsample.Options.__doc__, rf"\n +(\w+, )?{name}_?[ ,\n]")

    def test_options_reach_the_program(self):
        flags = ("flag", "attached")
        values = {name: True if option.kind in flags else "1" for name, option in OPTIONS.items()}
        with run_of(b"", values, COMMAND_ONLY) as run:
            expected = [o.name if o.kind in flags else o.name + "=1" for o in OPTIONS.values()]
            self.assertEqual(run.words, expected)

    def test_values(self):
        for value, expected in [
            (0.1, "0.1"), (np.float64(1e-7), "1e-07"), (np.float32(0.5), "0.5"), (fractions.Fraction(1, 24), "1/24"),
            ([1, 2.5], "1,2.5"), (np.arange(3), "0,1,2"), ({"a": "b", "c": ["d", "e"]}, "a=b,c=d:e"),
            (np.array(2.5), "2.5"), (np.timedelta64(1500, "us"), "0.001500000s"),
            (datetime.timedelta(days=1), "86400.000000000s"), (datetime.datetime(1970, 1, 1, 0, 1), "60.000000000"),
            ("1:2:0.5", "1:2:0.5"),
            (np.datetime64("1970-01-02T00:00:00.000000001"), "86400.000000001"), (np.longdouble(0.5), "0.5"),
            (datetime.datetime(3000, 1, 1), None), (np.datetime64("NaT"), None), (object(), None),
        ]:  # fmt: skip
            if expected is None:
                self.assertRaises((TypeError, ValueError), text, value)
            else:
                self.assertEqual(text(value), expected)

    def test_what_is_no_option(self):
        with self.assertRaisesRegex(TypeError, "unknown option 'tensoin'"):
            tcbsample.resample(KEYS, count=3, tensoin=1)
        with self.assertRaisesRegex(TypeError, "did you mean preset"):
            tcbsample.resample(KEYS, count=3, presett="vtk")
        for name in ("fail_fast", "failfast"):  # of an earlier version
            with self.assertRaisesRegex(tcbsample.Error, "fail_fast is gone in this version; the exit code"):
                tcbsample.resample(KEYS, count=3, **{name: True})
        with self.assertRaisesRegex(tcbsample.Error, 'segments is gone in this version; give count="6", or count="5"'):
            tcbsample.resample(KEYS, segments=5)
        with self.assertRaisesRegex(TypeError, "output: .*returned"):
            tcbsample.resample(KEYS, count=3, output="a.csv")
        with self.assertRaisesRegex(TypeError, "sort: 7; expected True or False"):
            tcbsample.resample(KEYS, count=3, sort=7)
        self.assertEqual(len(tcbsample.resample(KEYS, count=3, closed=np.bool_(False), sort=None, keys=False)), 3)

    def test_options_with_names_of_python(self):
        self.assertEqual(tcbsample.resample(KEYS, step=3, keys=True)["t"].tolist(), [0, 1, 2.5, 3, 4])

    def test_part_of_the_curve(self):
        self.assertEqual(tcbsample.resample(KEYS, step=1, from_=1, to=3)["t"].tolist(), [1, 2, 3])

    def test_many_times(self):
        times = np.random.default_rng(1).uniform(0, 4, 5000)
        self.assertEqual(tcbsample.resample(KEYS, at=times)["t"].tolist(), times.tolist())

    def test_presets(self):
        for name in tcbsample.presets():
            tcbsample.resample(KEYS, count=3, preset=name)


class Errors(unittest.TestCase):
    def error(self, *arguments, function=tcbsample.resample, **options):
        with self.assertRaises(tcbsample.Error) as caught:
            function(*arguments, **options)
        return caught.exception

    def test_places_in_text(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a: b.csv")
            pathlib.Path(path).write_text("t,x\n0,1\n1,o.5\nz,2\n")
            error = self.error(path, count=3)
            self.assertEqual((error.file, error.line, error.column, error.row, error.exit_code), (path, 3, 3, None, 1))
            self.assertEqual(error.remedy, "correct the cell")
            self.assertIn('"o.5" is not a number', error.message)
            self.assertEqual([other.line for other in error.others], [4])
            self.assertEqual(str(error), f"{path}:3:3: {error.message}")
        error = self.error(b"t,x\n0,1\n1,o.5\n", count=3)
        self.assertEqual((error.file, error.line, error.column), ("keys", 3, 3))

    def test_places_in_arrays(self):
        error = self.error([[0, 1], [1, np.nan], [2, 3]], count=3)
        self.assertEqual((error.file, error.line, error.row), ("keys", None, 1))
        error = self.error({"t": [0, 1, 2], "x": [0, 1, np.inf]}, count=3)
        self.assertEqual((error.file, error.row), ("keys", 2))
        keys = {"n\nm": ["a\nb\nc", "d", "e\r\nf"], "t": [0, 1, 2], "x": [0, 1, np.inf]}
        self.assertEqual(self.error(keys, count=3, columns={"carry": "n\nm"}).row, 2)
        samples = {"t": [0.5, 0.25, np.inf], "x": [1, 2, 3], "y": [1, 2, 3]}
        error = self.error(KEYS, samples, function=tcbsample.check)
        self.assertEqual((error.file, error.row), ("samples", 2))

    def test_options(self):
        error = self.error(KEYS, count=0)
        self.assertEqual((error.file, error.line, error.exit_code), (None, None, 2))
        self.assertTrue(error.message.startswith("count: "))
        error = self.error(KEYS, at=[0.0] * 200 + [np.nan])
        self.assertEqual((error.file, error.row), ("at", 200))
        self.error(KEYS)
        self.assertEqual(self.error("/does/not/exist.csv", count=3).exit_code, 2)

    def test_late_errors_of_many_rows(self):
        keys = np.array([[i, i] for i in range(20000)], float)
        keys[-1, 1] = np.nan
        self.assertEqual(self.error(keys, per_segment=1).row, 19999)

    def test_notes_are_warnings(self):
        with self.assertWarnsRegex(tcbsample.Note, "^keys: note: ignored: n") as caught:
            tcbsample.resample({"t": [0, 1], "x": [1, 2], "n": ["a", "b"]}, count=3)
        self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            tcbsample.resample({"t": [0, 1], "x": [1, 2], "n": ["a", "b"]}, count=3, quiet=True)


    def test_messages_speak_python(self):
        for message, expected in [
            ("give --missing skip-cell, skip-row or break", 'give missing="skip-cell", "skip-row" or "break"'),
            ("expected one of --step, --rate or --from", "expected one of step, rate or from_"),
            ('"--sort" is a text; or give --sort', '"--sort" is a text; or give sort=True'),
            ("give --columns time=2; see --help", 'give columns="time=2"; see help(tcbsample.Options)'),
            ("--only reads them", "only reads them"),
            ("give --group 'my id' if it tells curves apart", 'give group="my id" if it tells curves apart'),
            ("or --rotation none for plain channels", 'or rotation="none" for plain channels'),
            ("--from, --to and --step instead", "from_, to and step instead"),
            ("give --recursive", "give tcbsample --recursive"),
            ("give one, as in tcbsample --step 0.1 keys.csv", 'give one, as in step="0.1"'),
            ("in seconds, give --time-unit s.", 'in seconds, give time_unit="s".'),
            ("--check and --unknown-option stay apart", "check() and --unknown-option stay apart"),
            ("--columns time=a.sec,nanoseconds=a.nsec or", 'columns="time=a.sec,nanoseconds=a.nsec" or'),
            ("give --metric LAT,LON to measure", 'give metric="LAT,LON" to measure'),
            ("--rotation none leaves out", 'rotation="none" leaves out'),
            ("--metric all measures all", 'metric="all" measures all'),
            ("give --na -9999 --missing skip-cell", 'give na="-9999", missing="skip-cell"'),
            ("give --records frames --parameter uniform", 'give records="frames", parameter="uniform"'),
            ("--columns and --rotation, or", "columns and rotation, or"),
        ]:
            self.assertEqual(in_python(message), expected)
        error = self.error([[0, 1], [2, 3], [1, 5]], count=3)
        self.assertEqual(error.row, 2)
        self.assertRegex(str(error), r"keys, row 2: .*row 1.*sort=True")
        self.assertRegex(str(self.error({"t": [0, 1], "x": [0, "line 2"]}, count=3)), '^keys, row 1: x: "line 2"')
        self.assertIsNone(self.error({"a": [0, 1], "b": [1, 2]}, count=3, columns={"time": "c"}).row)
        dates = np.array(["2024-01-01T00:00:00", "2024-01-01T00:00:00.5"], "M8[ms]")
        message = str(self.error({"t": dates, "x": [0, 1]}, at="2025-01-01"))
        self.assertIn("time 2025-01-01T00:00:00Z is after the last key, at 2024-01-01T00:00:00.5Z", message)

    def test_no_message_of_random_faults_names_the_command_line(self):
        rng = np.random.default_rng(11)
        for _ in range(40):
            keys = {"t": rng.permutation(4), "x": rng.choice([0, 1, np.nan], 4), "tension": rng.choice([0, 1, np.nan], 4)}
            try:
                tcbsample.resample(keys, count=int(rng.integers(0, 4)), quiet=True)
            except tcbsample.Error as error:
                for one in (error, *error.others):
                    self.assertNotRegex(str(one), r"--[a-z]|\bline \d")


class Curves(unittest.TestCase):
    """Curves that NumPy evaluates against rows of the program."""

    def keys(self, rng):
        count = int(rng.integers(2, 12))
        names = ["x", "y", "z"][: int(rng.integers(1, 4))]
        keys = {"t": np.cumsum(rng.uniform(0.01, 3, count)) + rng.choice([0, -5, 1e6])}
        keys.update({name: rng.uniform(-1, 1, count) + rng.choice([0, 100]) for name in names})
        endings = [""] if rng.integers(2) else [f"_{name}" for name in names]  # of parameters of each channel
        keys.update({name + end: rng.uniform(-1, 1, count) for name in ("tension", "continuity", "bias") for end in endings})
        return keys, names

    def test_numbers_and_arrays_in_any_order_agree(self):
        curve = tcbsample.Curve({"t": [0, 1, 3, 4.5], "x": [0, 2, -1, 0.1], "y": [1e9, 1, 2, 1e-9]})
        in_order = np.linspace(0, 4.5, 10_001)
        mixed = np.random.default_rng(1).permutation(len(in_order))
        for order in range(5):
            rows = curve(in_order, order)
            np.testing.assert_array_equal(curve(in_order[mixed], order), rows[mixed])
            for i in [0, 1, 2222, 4444, 9999, 10_000]:
                for time in (float(in_order[i]), in_order[i], np.array(in_order[i])):
                    np.testing.assert_array_equal(curve(time, order), rows[i])
            np.testing.assert_array_equal(curve(3, order), curve([3], order)[0])
        self.assertEqual(curve(True).tolist(), [2, 1])
        self.assertTrue(np.isnan(curve(float("nan"))).all())
        for time in (-1e-9, 5, 10**400):
            self.assertRaises((tcbsample.Error, OverflowError), curve, time)

    def test_keys_in_memory_are_those_of_their_text(self):
        rng = np.random.default_rng(7)
        for _ in range(30):
            keys, _ = self.keys(rng)
            if rng.integers(2):
                keys["x"] = np.round(keys["x"])
            if rng.integers(2):
                keys["t"] = np.cumsum(rng.integers(1, 9, len(keys["t"])))
            text = ",".join(keys) + "\n" + "".join(",".join(map(repr, row)) + "\n" for row in zip(*(v.tolist() for v in keys.values())))
            with unittest.mock.patch("tcbsample._program.encode", side_effect=AssertionError):  # the text is not made
                own = tcbsample.Curve(keys, ends="one-sided")
            read = tcbsample.Curve(text.encode(), ends="one-sided")
            places = rng.uniform(own.times[0], own.times[-1], 50)
            self.assertEqual((own.names, own.times.tolist()), (read.names, read.times.tolist()))
            self.assertEqual(own(places).tobytes(), read(places).tobytes())
            self.assertEqual(own.length(places).tobytes(), read.length(places).tobytes())

    def test_messages_about_keys_in_memory_are_those_of_their_text(self):
        def messages(function, keys):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                try:
                    function(keys)
                except tcbsample.Error as error:
                    caught.append(error)
            return [(type(one), str(getattr(one, "message", one)), getattr(one, "row", None)) for one in caught]

        index, one = np.arange(3.0), np.ones(3)
        for keys in ({"index": index, "t": index, "x": one}, {"t": index, "x": one, "skew": index, "n": one},
                     {"t": one, "x": index}, np.column_stack([one, index])):  # fmt: skip
            made = messages(tcbsample.Curve, keys)
            self.assertEqual(made, messages(lambda keys: tcbsample.resample(keys, emit="bezier"), keys))
        self.assertEqual(made[-1][2], 1)  # the row of the repeated time

    def test_few_and_many_times_have_the_same_bits(self):
        rng = np.random.default_rng(3)
        keys = np.column_stack([np.arange(1000.0), rng.uniform(-1, 1, (1000, 2))])
        few, many = tcbsample.Curve(keys), tcbsample.Curve(keys)
        times = np.sort(rng.uniform(0, 999, 5000))
        rows = many(times)
        for i in range(0, 5000, 100):  # more and more of all times
            self.assertEqual(few(times[i : i + 7]).tobytes(), rows[i : i + 7].tobytes())
        self.assertEqual(few(times[5].item()).tobytes(), rows[5].tobytes())

    def test_positions_are_those_of_the_program(self):
        rng = np.random.default_rng(6)
        presets = [name for name in tcbsample.presets() if name != "nerfstudio"]
        for _ in range(25):
            keys, names = self.keys(rng)
            options = {"preset": str(rng.choice(presets)), "equal_speed": bool(rng.integers(2))}
            if rng.integers(3) == 0:
                options.update(closed=True, period=float(np.ptp(keys["t"]) + 1))
            curve = tcbsample.Curve(keys, **options)
            self.assertEqual(curve.names, names)
            np.testing.assert_array_equal(curve.times[: len(keys["t"])], keys["t"])
            times = rng.uniform(keys["t"][0], curve.times[-1], 500)
            times = np.concatenate([times, keys["t"], np.nextafter(keys["t"][1:], -np.inf)])
            rows = tcbsample.resample(keys, at=times, fields="position,velocity,acceleration,jerk", **options)
            pieces = curve._pieces
            piece = np.clip(pieces.starts.searchsorted(times, "right") - 1, 0, None)
            sizes = np.abs(pieces.bezier[piece]).max(axis=1)
            for i, name in enumerate(names):
                distance = np.abs(curve(times)[:, i] - rows[name]) / np.spacing(sizes[:, i])
                self.assertLessEqual(distance.max(), 4)
                for order, ending in enumerate(("_v", "_a", "_j"), 1):
                    scale = (6 / pieces.durations[piece]) ** order * sizes[:, i]
                    distance = np.abs(curve(times, order)[:, i] - rows[name + ending]) / scale
                    self.assertLess(distance.max(), 1e-14)

    def test_keys_are_reproduced(self):
        curve = tcbsample.Curve(KEYS)
        np.testing.assert_array_equal(curve(KEYS[:, 0]), KEYS[:, 1:])
        self.assertEqual(curve(1).tolist(), KEYS[1, 1:].tolist())
        rng = np.random.default_rng(5)
        for _ in range(9):  # times on both sides of 0
            keys = np.array([[-rng.uniform(0.5, 3), rng.normal()], [rng.uniform(0.01, 0.4), rng.normal()]])
            curve = tcbsample.Curve(keys)
            self.assertEqual((curve.times.tolist(), curve(curve.times)[:, 0].tolist()), (keys[:, 0].tolist(), keys[:, 1].tolist()))
            self.assertGreater(float(curve.length(curve.times[-1])), 0)

    def test_shapes(self):
        curve = tcbsample.Curve(KEYS)
        for shape in ((), (0,), (5,), (2, 3), (1, 1, 4)):
            times = np.linspace(0, 4, int(np.prod(shape))).reshape(shape)
            for order in range(5):
                self.assertEqual(curve(times, order).shape, (*shape, 2))
            self.assertEqual(curve.length(times).shape, shape)
            self.assertEqual(curve.at_length(times).shape, (*shape, 2))
        self.assertTrue(np.isnan(curve([0, np.nan])[1]).all())
        self.assertEqual(np.abs(curve([1, 2], 7)).max(), 0)
        for order in (-1, 0.5):
            with self.assertRaisesRegex(ValueError, "nu"):
                curve(1, order)
        self.assertEqual(curve(1, 2.0).tolist(), curve(1, 2).tolist())
        self.assertEqual(np.isnan(curve.length([np.nan, 1])).tolist(), [True, False])
        self.assertTrue(np.isnan(curve.at_length(np.nan)).all())
        self.assertTrue(np.isnan(curve(np.ma.array([1.0, 2], mask=[1, 0]))[0]).all())
        for times in ("1", [1j], [np.datetime64("2024-01-01")], datetime.datetime(1970, 1, 1)):
            with self.assertRaisesRegex(TypeError, "expected numbers"):
                curve(times)
        with self.assertRaisesRegex(ValueError, "at: nothing"):
            tcbsample.resample(KEYS, at=[])

    def test_outside_the_keys(self):
        curve = tcbsample.Curve(KEYS)
        with self.assertRaises(tcbsample.Error):
            curve(4.5)
        for rule in ("hold", "linear", "repeat", "offset", "oscillate"):
            curve = tcbsample.Curve(KEYS, extrapolate=rule)
            rows = tcbsample.resample(KEYS, at=[-1, 2, 9], extrapolate=rule)
            found = curve([-1, 2, 9])
            np.testing.assert_array_equal(found[[0, 2]], np.stack([rows["x"], rows["y"]], 1)[[0, 2]])

    def test_numbers_near_the_limits_of_doubles(self):
        curve = tcbsample.Curve([[0, 0], [1e-310, 1]], ends="chord", group=False)
        self.assertAlmostEqual(float(curve(5e-311)[0]), 0.5)
        with self.assertRaisesRegex(tcbsample.Error, "beyond the range"):
            curve(5e-311, 1)

    def test_times_of_more_digits_than_doubles(self):
        keys = b"t,x\n1403637576.252524268,0\n1403637578.952524268,27\n"
        curve = tcbsample.Curve(keys, ends="chord", quiet=True)
        times = np.array([1403637576.5, 1403637577.6025])
        exact = [10 * (decimal.Decimal(repr(time)) - decimal.Decimal("1403637576.252524268")) for time in times.tolist()]
        np.testing.assert_allclose(curve(times)[:, 0], np.array(exact, dtype=float), rtol=1e-15)

    def test_what_is_no_cubic(self):
        keys = {"t": [0, 1, 2], "x": [0, 1, 0], "ease_in": [0.5, 0.5, 0.5], "ease_out": [0.1, 0.2, 0.3]}
        curve = tcbsample.Curve(keys, preset="3dsmax")
        times = np.linspace(0, 2, 9)
        rows = tcbsample.resample(keys, at=times, preset="3dsmax", fields="position,velocity")
        np.testing.assert_array_equal(curve(times)[:, 0], rows["x"])
        np.testing.assert_array_equal(curve(times, 1)[:, 0], rows["x_v"])
        with self.assertRaisesRegex(ValueError, "not a cubic"):
            curve.to_ppoly()
        poses = tcbsample.Curve(str(SAMPLES / "poses.csv"))
        found = poses.rotation(np.array([[0, 3.5]]))
        self.assertEqual(found.shape, (1, 2, 4))
        np.testing.assert_allclose(np.linalg.norm(found, axis=-1), 1, atol=1e-15)
        self.assertEqual(poses(1.0).shape, (len(poses.names),))
        with self.assertRaisesRegex(ValueError, "no rotation"):
            tcbsample.Curve(KEYS).rotation(1)

    def test_rotations_anywhere_among_the_channels(self):
        keys = {"t": [0, 1, 2], "x": [0, 1, 4], "a b": [0, 0, 0], "c": [0, 10, 20], "d": [0, 20, 30], "y": [1, 1, 3]}
        form = {"rotation": "euler=a b:c:d,order=XYZ", "angles": "degrees"}
        curve, times = tcbsample.Curve(keys, **form), [0.5, 2]
        rows = tcbsample.resample(keys, at=times, fields="position,velocity", **form)
        self.assertEqual(curve.names, ["x", "a b", "c", "d", "y"])
        found = curve(times, 1)
        np.testing.assert_array_equal(found[:, [0, 4]], np.stack([rows["x_v"], rows["y_v"]], 1))
        self.assertTrue(np.isnan(found[:, 1:4]).all())
        rows = tcbsample.resample(keys, at=times, rotation_output="quaternion", **form)
        np.testing.assert_array_equal(curve.rotation(times), np.stack([rows["q" + axis] for axis in "xyzw"], 1))
        only = tcbsample.Curve({name: keys[name] for name in ("t", "a b", "c", "d")}, **form)
        np.testing.assert_array_equal(only.rotation(times), curve.rotation(times))
        norms = np.linalg.norm(tcbsample.Curve(keys, rotation_curve="components", **form).rotation(times), axis=1)
        np.testing.assert_allclose(norms, 1, atol=1e-15)
        with self.assertRaisesRegex(tcbsample.Error, "there are only rotations"):
            only(times, 1)

    def test_dates_and_golden(self):
        dates = np.array(["2024-01-01T00:00:00", "2024-01-01T00:00:01", "2024-01-01T00:00:03"], "M8[s]")
        curve = tcbsample.Curve({"time": dates, "x": [0, 1, 5]})
        same = tcbsample.Curve({"time": [0, 1, 3], "x": [0, 1, 5]})
        times = np.array([0, 250, 1500, 2999, 3000])
        np.testing.assert_array_equal(curve(dates[0] + times.astype("m8[ms]")), same(times / 1000))
        self.assertEqual(curve.times.dtype, np.dtype("M8[ns]"))
        np.testing.assert_array_equal(curve(dates, 1), same([0, 1, 3], 1))
        self.assertEqual(same(0.7, golden=True).tolist(), tcbsample.resample(
            {"time": [0, 1, 3], "x": [0, 1, 5]}, at=0.7, golden=True)["x"].tolist())  # fmt: skip
        golden, time = tcbsample.Curve(KEYS, golden=True), np.linspace(0, float(KEYS[-1, 0]), 99)
        np.testing.assert_array_equal(golden(time), tcbsample.Curve(KEYS)(time, golden=True))
        durations = tcbsample.Curve({"t": np.array([0, 1, 3], "m8[s]"), "x": [0, 1, 5]})
        np.testing.assert_array_equal(durations(np.array([250, 1500], "m8[ms]")), same([0.25, 1.5]))
        np.testing.assert_array_equal(durations(datetime.timedelta(seconds=1.5)), same(1.5))
        self.assertEqual(durations.times.tolist(), np.array([0, 1, 3], "m8[s]").astype("m8[ns]").tolist())
        np.testing.assert_array_equal(curve([datetime.datetime(2024, 1, 1), None])[0], same(0))
        with self.assertRaisesRegex(TypeError, "expected dates"):
            curve(datetime.timedelta(seconds=1))

    def test_dates_far_from_the_first_one(self):
        rng = np.random.default_rng(13)
        nanoseconds = 1_700_000_000_000_000_000 + 1000 * np.cumsum(rng.integers(1, 10**6, 3000))
        keys = {"time": nanoseconds.astype("M8[ns]"), "x": rng.uniform(-1, 1, 3000)}
        curve = tcbsample.Curve(keys)
        np.testing.assert_array_equal(curve(keys["time"])[:, 0], keys["x"])
        rows = tcbsample.resample(keys, at=rng.integers(nanoseconds[0], nanoseconds[-1], 500).astype("M8[ns]"))
        piece = np.clip(keys["time"].searchsorted(rows["time"], "right") - 1, 0, 2998)
        sizes = np.abs(curve._pieces.bezier[piece, :, 0]).max(axis=1)
        self.assertLessEqual((np.abs(curve(rows["time"])[:, 0] - rows["x"]) / np.spacing(sizes)).max(), 4)
        seconds = [count / 10**9 for count in rows["time"][:9].astype(np.int64).tolist()]
        np.testing.assert_array_equal(curve(seconds), curve(rows["time"][:9]))

    def test_a_track_of_a_file(self):
        scene = SAMPLES / "formats" / "scene.lws"
        curves = [{"id": name, "keys": [{"t": 0, "x": 1}, {"t": 1, "x": 2}]} for name in ("1-2", "1:3")]
        for keys in (scene, SAMPLES / "vectors" / "ease.json", json.dumps({"curves": curves}).encode()):
            with self.assertRaisesRegex(TypeError, "several curves; .* with only"):
                tcbsample.Curve(keys, quiet=True)
        curve, times = tcbsample.Curve(scene, only="Ship/position"), np.linspace(0, 2.9, 9)
        rows = tcbsample.resample(scene, at=times, only="Ship/position", fields="position,velocity,s")
        np.testing.assert_array_equal(curve(times, golden=True)[:, 1], rows["y"])
        np.testing.assert_allclose(curve(times, 1)[:, 0], rows["x_v"], rtol=1e-14)
        np.testing.assert_array_equal(curve.length(times), rows["s"])
        named = tcbsample.Curve({"t": [0, 1], "curve": [0, 2]}, columns="position=curve")
        self.assertEqual((named.names, named(1).tolist(), named.at_length([2]).tolist()), (["curve"], [2], [[2]]))

    def test_other_notations_of_time(self):
        for keys, options in ((b"time,x\n00:00:01:00,0\n00:00:03:12,2\n", {"input_fps": 24}),
                              (b"time,x\n00:01,0\n00:03.5,2\n", {"quiet": True})):  # fmt: skip
            curve = tcbsample.Curve(keys, ends="chord", **options)
            self.assertEqual((curve.times.tolist(), curve(2.25).tolist()), ([1, 3.5], [1]))
        curve = tcbsample.Curve((row for row in KEYS.tolist()))
        self.assertEqual(float(curve.length(0)), 0)

    def test_whole_times_beyond_doubles(self):
        begin = 1_700_000_000_000_000_001
        curve = tcbsample.Curve({"t": [begin, begin + 10**6], "x": [0, 1]}, ends="chord", time_unit="ns")
        self.assertEqual(curve([begin, begin + 1, begin + 500_000, begin + 10**6])[:, 0].tolist(), [0, 1e-6, 0.5, 1])
        self.assertEqual(curve.times.tolist(), [begin, begin + 10**6])
        self.assertEqual(float(curve.length(begin + 500_000)), 0.5)
        with self.assertRaisesRegex(TypeError, "whole numbers"):
            curve(1.7e18)

    def test_what_is_not_one_curve(self):
        for option in ("step", "digits", "time_zero"):
            with self.assertRaisesRegex(TypeError, f"{option}: an option of rows"):
                tcbsample.Curve(KEYS, **{option: 1})
        with self.assertRaisesRegex(TypeError, "each group"):
            tcbsample.Curve({"id": [1, 1], "t": [0, 1], "x": [0, 1]}, group="id")
        with self.assertRaises(tcbsample.Error):
            tcbsample.Curve([[0, 1], [0, 2]])
        with self.assertRaisesRegex(TypeError, "unknown option"):
            tcbsample.Curve(KEYS, presett="vtk")


class Scripts(unittest.TestCase):
    def test_scripts_of_the_samples_print_what_their_page_shows(self):
        page = (SAMPLES / "python/README.md").read_text()
        scripts = sorted((SAMPLES / "python").glob("*.py"))
        self.assertEqual(len(scripts), 5)
        for script in scripts:
            run = subprocess.run([sys.executable, "-W", "error", "-B", script], capture_output=True, text=True,
                                 env=dict(os.environ, PYTHONPATH=sys.path[0]))  # fmt: skip
            self.assertEqual(run.stderr, "")
            self.assertIn(f"[{script.name}]({script.name}) prints:\n\n```\n{run.stdout}```", page)

    def test_help_fits_on_two_screens(self):
        text = pydoc.render_doc(tcbsample, renderer=pydoc.plaintext)
        self.assertLessEqual(len(text.splitlines()), 100)
        for name in ("Curve", "resample", "fit", "check", "identify", "plot", "explain", "presets"):
            self.assertIn(f"{name}(", text)
            self.assertIn(">>>", getattr(tcbsample, name).__doc__)


class Wheels(unittest.TestCase):
    """The names of wheels: on which systems a program runs."""

    def tags(self, data):
        script = pathlib.Path(__file__).parents[2] / "src/python/make_wheel.py"
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "program")
            path.write_bytes(data)
            return runpy.run_path(str(script))["platforms"](path)

    def elf(self, machine, *segments):
        numbers = 3, machine, 1, 0, 64, 0, 0, 64, 56, len(segments), 0, 0, 0
        head = b"\x7fELF\x02\x01\x01".ljust(16, b"\0") + struct.pack("<HHIQQQIHHHHHH", *numbers)
        return head + b"".join(struct.pack("<I", kind).ljust(56, b"\0") for kind in segments)

    def test_tags(self):
        load, dynamic, interpreter = 1, 2, 3
        self.assertEqual(self.tags(self.elf(0x3E, load, dynamic)), ["manylinux_2_17_x86_64", "musllinux_1_1_x86_64"])
        self.assertEqual(self.tags(self.elf(0xB7, load)), ["manylinux_2_17_aarch64", "musllinux_1_1_aarch64"])
        self.assertEqual(self.tags(self.elf(0xB7, interpreter, load)), ["linux_aarch64"])
        windows = b"MZ".ljust(60, b"\0") + struct.pack("<I", 64) + b"PE\0\0" + struct.pack("<H", 0x8664)
        self.assertEqual(self.tags(windows.ljust(200, b"\0")), ["win_amd64"])
        for data in (self.elf(0x28, load), b"#!/bin/sh\n".ljust(100)):
            with self.assertRaisesRegex(SystemExit, "unknown kind of program"):
                self.tags(data)


unittest.main()
