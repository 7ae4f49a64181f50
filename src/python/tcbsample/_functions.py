"""The functions of the module: one for each product of the program."""

from __future__ import annotations

import base64
import importlib
import inspect
import json
import os
import pathlib
import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from typing import IO, TYPE_CHECKING, Any, Callable, NamedTuple, Optional, Protocol, TypeVar, Union, overload

import numpy as np

from ._options import PRESETS, Options, PlotOptions, SamplingOptions, Value
from ._program import Run, in_python, run_of
from ._rows import rows_of

if TYPE_CHECKING:
    import pandas
    from typing_extensions import Unpack

    class Frame(Protocol):
        """A DataFrame or a Series, also where pandas has no stubs."""

        @property
        def iloc(self) -> Any: ...

    Array = np.ndarray[Any, np.dtype[Any]]
    # What gives a structured array: arrays, lists, dicts of columns, and what has text or bytes.
    Other = Union[Array, Mapping[Any, Any], Sequence[Any], str, os.PathLike[str], bytes, IO[str], IO[bytes]]
    Keys = Union[Frame, Other]


class Preset(NamedTuple):
    """The rules of a product, and which product it is."""

    tangents: str
    ends: str
    product: str


class Report:
    """The result of check() or identify(). It is true if the samples agree with the curve.

    data   the report of the program as a dict: counts, the first and the largest difference with its row from 0, the
           columns; or the ranking. report[name] is report.data[name].
    """

    def __init__(self, data: dict[str, Any], agrees: bool) -> None:
        self.data, self._agrees = data, agrees

    def __bool__(self) -> bool:
        return self._agrees

    def __getitem__(self, name: str) -> Any:
        return self.data[name]

    def __repr__(self) -> str:
        short = [f"{name}={value!r}" for name, value in self.data.items() if not isinstance(value, (dict, list))]
        return f"<Report: {'agrees' if self else 'differs'}, {', '.join(short)}>"


class Picture:
    """An SVG picture, which a Jupyter cell shows. svg is its text."""

    def __init__(self, svg: str) -> None:
        self.svg = svg

    def _repr_svg_(self) -> str:
        return self.svg

    def _repr_html_(self) -> str:
        # As an image, its styles apply to nothing else on the page.
        data = base64.b64encode(self.svg.encode()).decode()
        return f'<img src="data:image/svg+xml;base64,{data}" alt="The curve">'

    def __repr__(self) -> str:
        return f"<Picture: SVG, {len(self.svg)} characters>"

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the picture to a file: SVG, or PNG where the name ends in .png.

        Raises RuntimeError for PNG where neither the module cairosvg nor the program rsvg-convert is installed, and
        ValueError for another ending.

        >>> import os, tempfile, tcbsample
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     tcbsample.plot([[0, 1], [1, 2]]).save(os.path.join(folder, "p.svg"))
        ...     os.listdir(folder)
        ['p.svg']
        """
        file = pathlib.Path(path)
        ending = file.suffix.lower()
        if ending not in (".svg", ".png"):
            raise ValueError(f"{file.name!r}: expected a name that ends in .svg or .png")
        file.write_bytes(self.svg.encode() if ending == ".svg" else self._png())

    def _png(self) -> bytes:
        try:
            return importlib.import_module("cairosvg").svg2png(self.svg.encode())  # type: ignore[no-any-return]
        except ImportError:
            pass
        converter = shutil.which("rsvg-convert")
        if converter is None:
            raise RuntimeError("PNG needs the Python module cairosvg or the program rsvg-convert (Debian's "
                               "librsvg2-bin), and neither is installed; install one, or save .svg")  # fmt: skip
        command = [converter, "--format=png", "--background-color=white"]
        return subprocess.run(command, input=self.svg.encode(), stdout=subprocess.PIPE, check=True).stdout


# What the signatures of help() show of the options, which type checkers see in **options.

_USUAL = ("step", "count", "fps", "columns", "group", "tcb", "tangents", "ends", "closed", "fields")
_Function = TypeVar("_Function", bound=Callable[..., Any])


def _shows(*names: str) -> Callable[[_Function], _Function]:
    """The function with these options in its signature, before the others."""

    def decorate(function: _Function) -> _Function:
        signature = inspect.signature(function)
        *parameters, others = signature.parameters.values()
        known = [parameter.name for parameter in parameters]
        shown = [inspect.Parameter(n, inspect.Parameter.KEYWORD_ONLY, default=None) for n in names if n not in known]
        function.__signature__ = signature.replace(parameters=[*parameters, *shown, others])  # type: ignore[attr-defined]
        return function

    return decorate


# The input is positional, and not called keys, as that is the option --keys, which type checkers see in **options.


@overload
def resample(data: Frame, /, *, step: Value = None, count: Optional[int] = None, arc_step: Value = None,
             at: Value = None, tolerance: Value = None, preset: Optional[str] = None,
             **options: Unpack[Options]) -> pandas.DataFrame: ...  # fmt: skip
@overload
def resample(data: Other, /, *, step: Value = None, count: Optional[int] = None, arc_step: Value = None,
             at: Value = None, tolerance: Value = None, preset: Optional[str] = None,
             **options: Unpack[Options]) -> Array: ...  # fmt: skip
@_shows(*_USUAL)
def resample(data: Any, /, *, step: Value = None, count: Optional[int] = None, arc_step: Value = None,
             at: Value = None, tolerance: Value = None, preset: Optional[str] = None,
             **options: Unpack[Options]) -> Any:  # fmt: skip
    """Samples of the curve through keys.

    data       n keys with their columns; see the description of the module
    step       every step of time, from the first key; the text or Fraction 1/24 is exact
    count      this many samples at equal times, both ends included
    arc_step   every arc_step of length along the curve
    at         an array of m times, in any order
    tolerance  few samples whose polyline is within this distance of the curve
    preset     the rules of a product; see presets()
    options    further options of the command line; see Options. One of step, count, arc_step, at, tolerance or another
               option of sampling, such as fps, is needed.

    Times are in the unit of the keys' times, lengths and tolerances in that of the positions.

    Returns a structured array of shape (m,), or a DataFrame of m rows if data is a DataFrame or a Series. Its fields
    are the groups, the time, the channels, and labels, or what fields= chooses: float64, where undefined values are
    NaN; whole times from 2^53 up are int64; dates are datetime64[ns], durations timedelta64[ns]; groups and labels
    have the type that they have in data. A time zone, and an index of times, are those of the keys. Dates are doubles
    of seconds since 1970, which are rounded to some 0.2 microseconds, unless a key has a date with more digits.
    With missing="break" or duplicates="break", a first field "curve" counts curves from 0.

    Raises Error if keys or options are rejected, and TypeError for an unknown option or what is not a table.

    >>> import tcbsample
    >>> rows = tcbsample.resample({"t": [0, 1, 2], "x": [0, 2, 0], "y": [0, 0, 4]}, step="1/2")
    >>> rows.dtype.names
    ('t', 'x', 'y')
    >>> rows["x"].tolist()
    [0.0, 1.25, 2.0, 1.25, 0.0]
    >>> tcbsample.resample([[0, 0], [1, 2], [2, 0]], at=[0.5], fields=["position", "velocity"]).tolist()
    [(1.25, 2.5)]
    """
    given = dict(options, step=step, count=count, arc_step=arc_step, at=at, tolerance=tolerance, preset=preset)
    with run_of(data, given) as run:
        return rows_of(run, given)


@overload
def fit(samples: Frame, /, tolerance: Value, **options: Unpack[Options]) -> pandas.DataFrame: ...
@overload
def fit(samples: Other, /, tolerance: Value, **options: Unpack[Options]) -> Array: ...
@_shows("columns", "group", "fit_keys", "metric", "corner")
def fit(samples: Any, /, tolerance: Value, **options: Unpack[Options]) -> Any:
    """Few keys whose curve is within a tolerance of all samples.

    samples    n samples, as keys in the description of the module, without tension, continuity and bias
    tolerance  the largest distance of the curve from a sample, in the unit of the positions; a dict has limits of
               channels, as in {"x": 0.01}
    options    fit_keys ("tcb" or "hermite"), keep_times, corner, metric, group, ...; see Options

    Returns the keys as resample() returns rows, with columns tension_x, bias_x, ... of the channels; resample() takes
    them. The logger "tcbsample" gets a message with their number, the largest distance, and a proved lower bound.

    Raises Error and TypeError as resample().

    >>> import tcbsample
    >>> samples = tcbsample.resample([[0, 0], [1, 2], [3, 1]], count=100)
    >>> keys = tcbsample.fit(samples, 1e-3)
    >>> len(keys) < 10
    True
    >>> again = tcbsample.resample(keys, at=samples["t"])
    >>> bool(abs(again["x"] - samples["x"]).max() <= 1.001e-3)
    True
    """
    with run_of(samples, dict(options, fit=tolerance), ["fit"], "samples") as run:
        return rows_of(run, options)


def _report(run: Run) -> dict[str, Any]:
    """The report that a run prints, with the names that Python has for its inputs."""
    data: dict[str, Any] = json.load(run.result(["--output-format=json"], accepts_difference=True))
    source = run.sources.get("standard input")
    if source is not None:
        data["keys"] = source.name
    return data


def _compare(option: str, keys: Any, samples: Any, options: Mapping[str, Any], agrees: str) -> Report:
    with run_of(keys, {**options, option: samples}, [option]) as run:
        data = _report(run)
        file = run.sources.get(data["file"])
        for name in ("first", "worst"):
            if data[name]:
                data[name]["row"] -= 1  # from 0, as in Python
                if file and file.table:
                    data[name]["line"] = None
        for name in ("problems", "not_compared"):
            texts = map(in_python, data[name])
            data[name] = [file.in_rows(text) if file else text for text in texts]
        data["file"] = file.name if file else data["file"]
        return Report(data, data[agrees])


@_shows(*_USUAL)
def check(data: Keys, samples: Keys, /, *, abs: Value = None, rel: Value = None, ulp: Value = None,
          **options: Unpack[SamplingOptions]) -> Report:  # fmt: skip
    """Compares samples that any program made with the curve through keys.

    data      n keys; see the description of the module
    samples   m samples, like the keys; their times, or their arc lengths in a column s, say where they are on the curve
    abs       the largest accepted difference of two numbers; a dict has limits of columns
    rel       the same as a fraction of the number on the curve
    ulp       the same in units in the last place; 0 if none of the three is given
    options   preset, map, ...; see Options. With a sampling option such as step, a missing or surplus row is a
              difference, too.

    Returns a Report, which is true if no difference is larger than accepted. Raises Error and TypeError as resample().

    >>> import tcbsample
    >>> keys = [[0, 0], [1, 2], [2, 0]]
    >>> bool(tcbsample.check(keys, {"t": [0.5, 1], "x": [1.25, 2]}))
    True
    >>> report = tcbsample.check(keys, {"t": [0.5, 1], "x": [1, 2]}, abs=0.1)
    >>> bool(report), report["worst"]["row"], report["worst"]["abs"]
    (False, 0, 0.25)
    """
    return _compare("check", data, samples, dict(options, abs=abs, rel=rel, ulp=ulp), "passed")


@_shows("columns", "group", "map", "metric")
def identify(data: Keys, samples: Keys, /, **options: Unpack[SamplingOptions]) -> Report:
    """Finds the rules by which another program made samples of the curve through keys.

    data, samples, options   as in check()

    Returns a Report, which is true if some rules reproduce the samples; ["ranking"] is a list of dicts with tangents,
    ends, presets and the largest difference, best first. Raises Error and TypeError as resample().

    >>> import tcbsample
    >>> keys = [[0, 0], [1, 2], [3, 0], [4, 1]]
    >>> theirs = tcbsample.resample(keys, step=0.25, preset="vtk")
    >>> report = tcbsample.identify(keys, theirs)
    >>> bool(report), "vtk" in report["ranking"][0]["presets"]
    (True, True)
    """
    return _compare("identify", data, samples, options, "fits")


@_shows("columns", "group", "tcb", "tangents", "ends", "closed", "metric")
def limits(data: Keys, /, limits: Value = None, **options: Unpack[Options]) -> Report:
    """The largest speed, acceleration and the like on the curve through keys, certified, against limits.

    data      n keys; see the description of the module
    limits    a dict of limits, as in {"speed": 2, "velocity_x": "-1:2"}; None for all largest values
    options   preset, from_, to, group, metric, ...; see Options

    Returns a Report, which is true if no limit is exceeded; ["limits"] is a list of dicts with name, maximum, time, side,
    limit and factor. Raises Error and TypeError as resample().

    >>> import tcbsample
    >>> report = tcbsample.limits([[0, 0], [1, 2], [2, 0]], {"speed": 100})
    >>> bool(report), report["limits"][0]["name"]
    (True, 'speed')
    """
    with run_of(data, {**options, "limits": True if limits is None else limits}, ["limits"]) as run:
        report = _report(run)
        return Report(report, report["passed"])


@_shows(*_USUAL)
def plot(data: Keys, /, **options: Unpack[PlotOptions]) -> Picture:
    """A picture of the curve through keys: its path, and each channel over time, with keys and samples.

    data      n keys; see the description of the module
    options   those of resample(), and axes, title, size; without a sampling option, it shows 51 samples.
              check=samples and identify=samples show other samples and their differences, fit=tolerance a fit.

    Returns a Picture, which a Jupyter cell shows. Raises Error and TypeError as resample().

    >>> import tcbsample
    >>> picture = tcbsample.plot([[0, 0, 1], [1, 2, 3], [2, 0, 2]], title="Three keys")
    >>> picture.svg[:4], "Three keys" in picture.svg
    ('<svg', True)
    """
    compares = any(options.get(name) is not None for name in ("check", "identify", "fit"))
    with run_of(data, options, ["check", "identify", "fit"]) as run:
        words = ["--output-format=svg"] if compares else ["--plot"]
        return Picture(run.result(words, accepts_difference=compares).read().decode())


@_shows(*_USUAL)
def explain(data: Keys, /, **options: Unpack[SamplingOptions]) -> str:
    """What was detected in keys, and with a sampling option what resample() would do, as a text of lines NAME: VALUE.

    data, options   as in resample(); no sampling option is needed

    Raises Error and TypeError as resample().

    >>> import tcbsample
    >>> print(tcbsample.explain([[0, 0], [1, 2], [2, 0]], step=0.5).splitlines()[-2])
    rows: 5
    """
    with run_of(data, options) as run:
        text = run.result(["--explain"]).read().decode()
        source = run.sources.get("standard input")
        if source is None or source.table is None:
            return text
        columns = source.table.columns
        text = text.replace("file: standard input", f"data: {len(columns[0])} rows of {len(columns)} columns", 1)
        return source.in_rows(re.sub(r"^(format|delimiter|comment|decimal|header|output): .*\n", "", text, flags=re.M))


def presets() -> dict[str, Preset]:
    """The presets: the name of each, its tangent rule, its end rule, and its product.

    >>> import tcbsample
    >>> tcbsample.presets()["gte"].tangents
    'velocity'
    """
    return {name: Preset(*rules) for name, rules in PRESETS.items()}
