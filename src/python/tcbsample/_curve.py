"""Curves that NumPy evaluates in this process, from the exact pieces that the program prints."""

from __future__ import annotations

import contextlib
import decimal
import functools
import itertools
import os
import re
from bisect import bisect_right
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from ._options import Options
from ._program import Error, HasMessages, run_of, source_of
from ._rows import dates_of, durations_of, rows_of
from ._tables import Table, array_of, decimal_seconds, is_missing, shown

if TYPE_CHECKING:
    from typing_extensions import Unpack

    Array = np.ndarray[Any, np.dtype[np.float64]]

_BLOCK = 1 << 13  # places that are evaluated together, which fit into the cache of a processor
_RUN = 1 << 10  # so many places on a piece are faster together than with those of other pieces
_OF_ROWS = {"step", "rate", "fps", "count", "segments", "per_segment", "at", "arc_step", "arc_count", "arc_at", "tolerance",
            "pace", "emit", "fit_keys", "keep_times", "corner", "from_", "to", "end", "keys", "fields", "digits", "fixed",
            "time_format", "time_zero", "file_column"}  # fmt: skip
_TIME = re.compile(r"-?\d+(:\d\d|-\d\d-\d\dT)")
_DERIVATIVES = ("position", "velocity", "acceleration", "jerk")


def _parts(left: Any, middle: Any, right: Any) -> Any:
    """Of each part of pieces, in turn."""
    return np.stack([left, middle, right], axis=1).reshape(3 * len(left), *left.shape[1:])


class _Pieces:
    """Cubics one after another, each by its ends and its middle, so that a place is evaluated from the nearest.

    starts, ends  (n,) the times of n pieces: doubles, or whole numbers, of which the differences are exact
    durations     (n,) the unit by which derivatives are; that of doubles
    bezier        (n, 4, c) control points of c channels
    """

    def __init__(self, starts: Any, ends: Any, durations: Any, bezier: Any) -> None:
        self.starts, self.ends, self.durations = starts, ends, durations
        self.bezier = bezier
        # Of part p of piece i at 3 i + p: where it begins, the time that distances count from, the length that they are
        # divided by, and the duration (both negative from the right end).
        is_float = starts.dtype.kind == "f"
        lengths = durations if is_float else (ends - starts).astype(np.float64)
        quarters = np.maximum(lengths / 4, abs(np.spacing(starts)) if is_float else 1).astype(starts.dtype)
        middles = starts + (lengths / 2).astype(starts.dtype)
        self._middles = ((middles - starts.astype(np.longdouble)) / lengths)[:, None]
        self._breaks = _parts(starts, starts + quarters, np.maximum(starts + quarters, ends - quarters))
        self._bases = _parts(starts, middles, ends)
        self._lengths = _parts(lengths, lengths, -lengths)
        self._scales = _parts(durations, durations, -durations)
        self._columns: dict[int, list[Array]] = {}  # by the order of the derivative: coefficients of the powers of u
        self._numbers: dict[tuple[int, int], tuple[float, float, list[list[float]]]] = {}  # by the order and the part
        self._asked = 0  # times, until now
        self.first, self.last = starts[0].item(), ends[-1].item()

    @functools.cached_property
    def _break_list(self) -> list[float]:
        return self._breaks.tolist()  # type: ignore[no-any-return]

    def powers(self, pieces: slice = slice(None)) -> list[Array]:
        """Of each part of some pieces, the coefficients of powers of the quotient, (3 n, c) for each power."""
        points = self.bezier[pieces].astype(np.longdouble).swapaxes(0, 1)

        def at_end(b0: Any, b1: Any, b2: Any, b3: Any) -> list[Any]:
            return [b0, 3 * (b1 - b0), 3 * ((b2 - b1) - (b1 - b0)), (b3 - b0) - 3 * (b2 - b1)]

        u = self._middles[pieces]
        a, b, c, d = left = at_end(*points)
        middle = [a + u * (b + u * (c + u * d)), b + u * (2 * c + u * (3 * d)), c + u * (3 * d), d]
        return [_parts(*three).astype(np.float64) for three in zip(left, middle, at_end(*points[::-1]))]

    def _coefficients(self, order: int, pieces: slice = slice(None)) -> list[Array]:
        """Those of u^3 down to u^0 of a derivative by u, (c, 3 n) each, which is contiguous for a channel."""
        factors = ((1.0, 1.0, 1.0, 1.0), (1.0, 2.0, 3.0), (2.0, 6.0), (6.0,))[order]
        columns: list[Array] = [np.ascontiguousarray(p.T) * f for f, p in zip(factors, self.powers(pieces)[order:])]
        columns += [np.zeros_like(columns[0])] * order
        return columns[::-1]

    def _all_coefficients(self, order: int) -> list[Array]:
        if order not in self._columns:
            self._columns[order] = self._coefficients(order)
        return self._columns[order]

    def at(self, time: float, order: int) -> Array:
        """A derivative of order 0 to 3 at one time, (channels,). Requires: times are doubles, first <= time <= last."""
        part = bisect_right(self._break_list, time) - 1
        found = self._numbers.get((order, part))
        if found is None:
            columns = self._coefficients(order, slice(part // 3, part // 3 + 1))
            channels = np.stack([column[:, part % 3] for column in columns], axis=1).tolist()
            found = float(self._bases[part]), float(self._scales[part]), channels
            self._numbers[order, part] = found
        base, scale, channels = found
        u = (time - base) / scale
        values = [((a * u + b) * u + c) * u + d for a, b, c, d in channels]
        for _ in range(order):
            values = [value / scale for value in values]
        return np.array(values)

    def _runs(self, times: Array) -> Iterator[tuple[slice, Any]]:
        """Runs of times, and the part, or the parts, on which they are."""
        count = len(self._breaks)
        if len(times) < count or (times[1:] < times[:-1]).any():
            parts = self._breaks.searchsorted(times, "right") - 1
        else:
            begins = np.concatenate([[0], times.searchsorted(self._breaks[1:]), [len(times)]])
            if len(times) >= _RUN * count:
                for part, (begin, end) in enumerate(zip(begins.tolist(), begins[1:].tolist())):
                    for first in range(begin, end, _BLOCK):
                        yield slice(first, min(first + _BLOCK, end)), part
                return
            parts = np.repeat(np.arange(count), np.diff(begins))
        for first in range(0, len(times), _BLOCK):
            run = slice(first, first + _BLOCK)
            yield run, parts[run]

    def evaluate(self, times: Array, order: int) -> Array:
        """A derivative of order 0 to 3 at each time, (times, channels). Requires: first <= times <= last."""
        self._asked += len(times)
        if 0 < len(times) <= self._asked < len(self.starts) / 4 and order not in self._columns:  # some pieces are enough
            some = np.unique(self.starts.searchsorted(times, "right") - 1)
            pieces = _Pieces(self.starts[some], self.ends[some], self.durations[some], self.bezier[some])
            return pieces.evaluate(times, order)
        result = np.empty((len(times), self.bezier.shape[2]))
        first, *others = self._all_coefficients(order)[order:]
        for run, part in self._runs(times):
            u = (times[run] - self._bases.take(part)) / self._lengths.take(part)
            scale = self._scales.take(part) if order > 0 else None
            for channel in range(result.shape[1]):
                value = first[channel].take(part)
                for column in others:
                    value *= u
                    value += column[channel].take(part)
                for _ in range(order):
                    value /= scale
                result[run, channel] = value
        return result


def _times(times: Any) -> Any:
    """Times that the program printed: dates, whole numbers beyond 2^53, or doubles."""
    return dates_of(times.tolist()) if times.dtype.kind == "U" else times


def _are_missing(places: Any) -> Any:
    return np.isnat(places) if places.dtype.kind == "M" else np.isnan(places)


class Curve:
    """A curve through keys, to evaluate at any times.

    keys      keys of one curve, as for resample(); or their n times, followed by their positions, as in Curve(t, y)
    preset    the rules of a product; see presets()
    options   options of the curve and of its keys, such as closed=True, extrapolate="hold", ends="natural" or
              columns={"time": "stamp"}; see Options

    times     (n + 1,) the times where the n pieces of the curve begin and end: those of the keys
    names     the names of the c channels

    Times are numbers in the unit of the keys, or dates or durations where those of the keys are; derivatives are per
    unit of time, or per second. Positions and derivatives are computed in this process, by NumPy; positions are within
    4 units in the last place of what resample() returns, counted at the largest control value of the piece. What is no
    cubic in time (rotations, ease), times in files with more digits than doubles, lengths, places outside the keys and
    golden=True, here or in a call, take a run of the program, which reads a file again. Derivatives of the channels of
    a rotation are NaN; resample() has the field angular_velocity.

    Raises Error if keys or options are rejected, and TypeError for an unknown option or what is not a table.

    >>> import tcbsample
    >>> curve = tcbsample.Curve([[0, 0, 5], [1, 2, 6], [2, 0, 7]])
    >>> curve(0.5).tolist()
    [1.25, 5.5]
    >>> curve([0.5, 1.5], 1).shape
    (2, 2)
    """

    def __init__(self, keys: Any, positions: Any = None, /, *, preset: Optional[str] = None,
                 **options: Unpack[Options]) -> None:  # fmt: skip
        if positions is not None:
            keys = keys, positions
        given = {name: value for name, value in options.items() if value is not None and value is not False}
        if "group" in given:
            raise TypeError("group: a Curve is one curve; make one for each group, as in {name: Curve(rows) for name, "
                            "rows in frame.groupby('id')}")  # fmt: skip
        for name in _OF_ROWS.intersection(given):
            raise TypeError(f"{name}: an option of rows, which a Curve does not have; leave it out")
        self._keys = keys if isinstance(keys, (str, os.PathLike)) else source_of(keys, "keys")
        self._options: dict[str, Any] = dict(given, preset=preset)
        self._extrapolate = self._options.pop("extrapolate", None)
        self._metric = given.get("metric")
        self._is_golden = "golden" in given
        if "equal_speed" not in given and "parameter" not in given:
            self._options.pop("metric", None)  # only lengths depend on it
        self._pieces: Optional[_Pieces] = None
        self._length: Optional[Array] = None
        self.names: list[str] = []
        rows = None
        if "rotation_curve" not in given:  # components of rotations are cubics that are divided by their norm
            with contextlib.suppress(Error):  # no cubics in time, or rejected keys, for which the other rows raise it
                rows, table = self._rows(emit="bezier")
        if rows is not None:
            times = self._set_pieces(rows)
            self._are_plain = np.full(len(self.names), True)  # of each channel, whether it belongs to no rotation
        else:
            rows, table = self._rows(per_segment=1, fields="time,position")
            time, *self.names = rows.dtype.names
            times = _times(rows[time])
            moving = self._rows(count=2, fields="time,velocity", quiet=True)[0].dtype.names
            self._are_plain = np.array([f"{name}_v" in moving for name in self.names])
        has_durations = table is not None and any(column.dtype.kind == "m" for column in table.columns)
        self.times: np.ndarray[Any, np.dtype[Any]] = durations_of(times) if has_durations else times

    def _printed(self, options: dict[str, Any]) -> tuple[Any, Optional[Table]]:
        """Rows that the program prints, and the table of the keys, which are sent as an array unless the program has
        messages about it. Raises Error."""
        with run_of(self._keys, {**self._options, **options}, as_array=True) as run:
            table, run.table = run.table, None  # no row has the types of the keys
            with contextlib.suppress(HasMessages):
                return rows_of(run, {}), table
        with run_of(self._keys, {**self._options, **options}) as run:
            run.table = None
            return rows_of(run, {}), table

    def _rows(self, **sampling: Any) -> tuple[Any, Optional[Table]]:
        """Rows of numbers, and the table of the keys. Raises Error, and TypeError for several curves."""
        rows, table = self._printed(sampling)
        first = dict(zip(rows.dtype.names, rows[0]))
        is_label = {name: isinstance(value, str) and not _TIME.match(value) for name, value in first.items()}
        labels = list(itertools.takewhile(is_label.get, first))  # such as the object and its track
        if "curve" in first and rows["curve"].dtype.kind == "i" or any(len(set(rows[name])) > 1 for name in labels):
            raise TypeError("the keys are several curves; expected one; make a Curve for each, or choose a track of a file "
                            "with only")  # fmt: skip
        rows = rows[[name for name in first if name not in labels]]
        time = rows[rows.dtype.names[0]][0]
        if isinstance(time, str) and "T" not in time:  # timecode, or minutes and seconds
            return self._rows(**{**sampling, "time_format": "seconds"})
        return rows, table

    def _set_pieces(self, rows: Any) -> Any:
        """The times where pieces begin and end."""
        self.names = [name[: -len("_b0")] for name in rows.dtype.names if name.endswith("_b0")]
        starts, durations = _times(rows["start"]), rows["duration"].astype(np.float64)
        if starts.dtype.kind == "f":
            end = starts[-1] + durations[-1]
            if end - starts[-1] != durations[-1] or durations[-1] > abs(end):  # the duration may be rounded
                end = self._rows(per_segment=1, fields="time")[0][-1].item()[0]
            ticks = times = np.append(starts, end)
        else:
            duration = round(durations[-1] * (1e9 if starts.dtype.kind == "M" else 1))
            ticks = np.append(starts.view(np.int64), starts[-1:].view(np.int64) + duration)
            times = ticks.view(starts.dtype)
        bezier = np.empty((len(rows), 4, len(self.names)))
        for (i, channel), _ in np.ndenumerate(bezier[0]):
            bezier[:, i, channel] = rows[f"{self.names[channel]}_b{i}"]
        has_all_digits = ticks.dtype.kind == "i" or (
            np.abs(np.diff(ticks.astype(np.longdouble)) - durations) <= 2 * np.spacing(durations)
        ).all()  # else times in a file have more than doubles
        # Derivatives may be (6 / duration)^3 times as large.
        if has_all_digits and np.abs(bezier).max() < 1e306 * (min(1.0, durations.min().item()) / 6) ** 3:
            self._pieces = _Pieces(ticks[:-1], ticks[1:], durations, bezier)
        return times

    def _places(self, t: Any) -> Any:
        """Times as an array of dates, whole numbers or doubles, with NaT or NaN for missing ones. Raises TypeError."""
        array = array_of(t)
        if array.dtype.kind == "O":
            numbers = [np.nan if is_missing(one) else one for one in array.ravel().tolist()]
            array = np.array(numbers, dtype=np.float64).reshape(array.shape)
        kind, keys = array.dtype.kind, self.times.dtype.kind
        expected = {"M": "dates", "i": "whole numbers, as those of the keys are beyond 2^53"}.get(keys, "numbers")
        if kind not in {"M": "Mbiuf", "i": "iu"}.get(keys, "mbiuf"):
            raise TypeError(f"times of the type {array.dtype}; expected {expected}")
        if kind == "m":
            return array / np.timedelta64(1, "s")
        if keys == "M" and kind != "M":  # seconds since 1970, as the program counts dates
            seconds = [decimal.Decimal(repr(one)) for one in array.astype(np.float64).ravel().tolist()]
            nanoseconds = ["NaT" if one.is_nan() else int(one.scaleb(9)) for one in seconds]
            return np.array(nanoseconds, dtype="M8[ns]").reshape(array.shape)
        return array.astype({"M": "M8[ns]", "i": "i8"}.get(keys, "f8"), copy=False)

    def _ask(self, option: str, places: Any, fields: str, columns: int, **more: Any) -> Array:
        """The columns of some fields that the program prints at places of any shape; NaN at NaN."""
        flat = places.ravel()
        asked = ~_are_missing(flat)
        result: Array = np.full((flat.size, columns), np.nan)
        if asked.any():
            words = decimal_seconds(flat[asked]) if flat.dtype.kind == "M" else list(map(repr, flat[asked].tolist()))
            rows, _ = self._printed({"quiet": True, "fields": fields, **more, option: words})
            result[asked] = np.stack([rows[name] for name in rows.dtype.names[-columns:]], axis=1)
        return result.reshape((*places.shape, columns))

    def __call__(self, t: Any, nu: int = 0, *, golden: bool = False) -> Array:
        """Positions, or derivatives, at times.

        t       a time, or an array of times of any shape, in any order; NaN gives NaN
        nu      the order of the derivative; at a key, it is that of the piece that begins there
        golden  every number is exact, rounded once

        Returns an array of shape t.shape + (c,). Raises Error for times outside the keys, unless extrapolate says what
        is there, and ValueError for an order that is not a whole number from 0 on.

        >>> import tcbsample
        >>> curve = tcbsample.Curve({"t": [0, 1], "x": [0, 2]}, ends="chord")
        >>> curve([[0.25], [0.5]]).tolist()
        [[[0.5]], [[1.0]]]
        >>> float(curve(0.3, 1)[0])
        2.0
        """
        golden = golden or self._is_golden
        pieces = None if golden else self._pieces
        if isinstance(t, (float, int)) and type(nu) is int and 0 <= nu <= 3 and pieces is not None:
            if isinstance(pieces.first, float) and pieces.first <= t <= pieces.last:  # without the cost of arrays
                return pieces.at(float(t), nu)
        if nu != int(nu) or nu < 0:
            raise ValueError(f"nu: {shown(nu)}; expected the order of a derivative: 0, 1, 2, ...")
        nu = int(nu)
        places = self._places(t)
        shape, places = (*places.shape, len(self.names)), places.ravel()
        ticks = places.view(np.int64) if places.dtype.kind == "M" else places
        inside = np.zeros(ticks.size, dtype=bool)
        if pieces is not None:
            inside = (ticks >= pieces.first) & (ticks <= pieces.last)
            if nu <= 3 and inside.all():
                return pieces.evaluate(ticks, nu).reshape(shape)
        result: Array = np.full((ticks.size, len(self.names)), np.nan)
        if pieces is not None:
            result[inside] = pieces.evaluate(ticks[inside], nu) if nu <= 3 else 0.0
        outside = ~(inside | _are_missing(places))
        if outside.any():
            if nu > 3:
                raise ValueError(f"nu: {nu}; expected at most 3 outside the keys, for rotations, with ease and golden=True")
            known = self._are_plain if nu > 0 else np.full(len(self.names), True)
            result[np.ix_(outside, known)] = self._ask("at", places[outside], _DERIVATIVES[nu], known.sum(),
                                                       golden=golden, extrapolate=self._extrapolate)  # fmt: skip
        return result.reshape(shape)

    def length(self, t: Any = None) -> Array:
        """Arc lengths from the start of the curve to times, in an array of the shape of t; without t, the whole length.
        Raises Error as a call.

        >>> import tcbsample
        >>> curve = tcbsample.Curve([[0, 0, 0], [1, 3, 4]])
        >>> float(curve.length()), float(curve.length(0))
        (5.0, 0.0)
        """
        if t is None:
            if self._length is None:
                self._length = self.length(self.times[-1])
            return self._length
        more = {"metric": self._metric, "extrapolate": self._extrapolate}
        return self._ask("at", self._places(t), "s", 1, **more)[..., 0]

    def at_length(self, s: Any) -> Array:
        """Positions at arc lengths from the start, shape s.shape + (c,). Raises Error for lengths beyond the end.

        >>> import tcbsample
        >>> tcbsample.Curve([[0, 0, 0], [1, 3, 4]]).at_length([0, 2.5]).tolist()
        [[0.0, 0.0], [1.5, 2.0]]
        """
        lengths = np.asarray(s, dtype=np.float64)
        return self._ask("arc_at", lengths, "position", len(self.names), metric=self._metric)

    def time_at_length(self, s: Any) -> Array:
        """The times at which arc lengths from the start are reached, in an array of the shape of s; for dates, seconds
        since 1970. Raises Error for lengths beyond the end.

        >>> import tcbsample
        >>> float(tcbsample.Curve([[0, 0, 0], [1, 3, 4]]).time_at_length(2.5))
        0.5
        """
        lengths = np.asarray(s, dtype=np.float64)
        return self._ask("arc_at", lengths, "time", 1, metric=self._metric, time_format="seconds")[..., 0]

    def rotation(self, t: Any) -> Array:
        """Rotations at times, as quaternions x, y, z, w, which scipy.spatial.transform.Rotation.from_quat() takes.

        Returns an array of shape t.shape + (4,), or t.shape + (r, 4) for r > 1 rotations. Raises Error as a call, and
        ValueError if the keys have no rotation.

        >>> import tcbsample
        >>> keys = {"t": [0, 1], "qx": [0, 0], "qy": [0, 0], "qz": [0, 0.6], "qw": [1, 0.8]}
        >>> tcbsample.Curve(keys).rotation(1).tolist()
        [0.0, 0.0, 0.6, 0.8]
        """
        form = {"rotation_output": "quaternion"}
        names = self._rows(count=2, fields="position", quiet=True, **form)[0].dtype.names
        plain = {name for name, is_plain in zip(self.names, self._are_plain) if is_plain}
        rows = self._ask("at", self._places(t), "position", len(names), extrapolate=self._extrapolate, **form)
        found = rows[..., [name not in plain for name in names]].reshape((*rows.shape[:-1], -1, 4))
        return found[..., 0, :] if found.shape[-2] == 1 else found

    def to_ppoly(self) -> Any:
        """The curve as a scipy.interpolate.PPoly, whose values have the shape t.shape + (c,). Where times are dates, it
        takes seconds since the first key.

        Raises ValueError for a curve that is not a cubic in time, and ImportError without SciPy.

        >>> import tcbsample
        >>> tcbsample.Curve([[0, 0], [1, 2], [2, 0]]).to_ppoly()(0.5).tolist()
        [1.25]
        """
        if self._pieces is None:
            raise ValueError("the curve is not a cubic in time, as it has rotations or ease, or numbers near the limits "
                             "of doubles, or times with more digits; sample it instead")  # fmt: skip
        from scipy.interpolate import PPoly

        h = self._pieces.durations[:, None]
        p = [power[::3] for power in self._pieces.powers()]  # of the distance from the start
        coefficients = np.stack([p[3] / h / h / h, p[2] / h / h, p[1] / h, p[0]])
        x = np.append(self._pieces.starts, self._pieces.ends[-1])
        if x.dtype.kind == "i":  # from the first key
            x = (x - x[0]) / (1e9 if self.times.dtype.kind == "M" else 1)
        is_closed = self._options.get("period") is not None or self._options.get("closed") not in (None, False, "no")
        return PPoly(coefficients, x, extrapolate="periodic" if is_closed else False)

    @classmethod
    def from_ppoly(cls, ppoly: Any) -> Curve:
        """The curve of a scipy.interpolate.PPoly of cubics, such as a CubicSpline: a key with velocities at each break.

        Raises TypeError for what is no PPoly, and ValueError for polynomials of a higher degree or of complex numbers,
        for values of more than one dimension, and for a curve that jumps.

        >>> import tcbsample
        >>> from scipy.interpolate import CubicSpline
        >>> tcbsample.Curve.from_ppoly(CubicSpline([0, 1, 3], [0, 1, 9])).at_length([0, 1]).tolist()
        [[0.0], [1.0]]
        """
        from scipy.interpolate import PPoly

        if not isinstance(ppoly, PPoly):
            raise TypeError(f"a {type(ppoly).__name__}; expected a PPoly; make one by PPoly.from_spline() or "
                            "PPoly.from_bernstein_basis()")  # fmt: skip
        if np.iscomplexobj(ppoly.c):
            raise ValueError("the polynomials are complex; expected real numbers")
        c, x = np.asarray(ppoly.c, dtype=np.float64), np.asarray(ppoly.x, dtype=np.float64)
        if c.ndim not in (2, 3):
            raise ValueError(f"values of {c.ndim - 2} dimensions; expected numbers or vectors of channels")
        c = c.reshape(c.shape[0], c.shape[1], -1)
        if len(c) > 4 and c[:-4].any():
            raise ValueError(f"polynomials of degree {len(c) - 1}; expected cubics")
        c = c[-4:] if len(c) >= 4 else np.concatenate([np.zeros((4 - len(c), *c.shape[1:])), c])
        h = np.diff(x)[:, None]
        end = c[3] + h * (c[2] + h * (c[1] + h * c[0]))
        size = np.abs(c[3]) + np.abs(h * c[2]) + np.abs(h * h * c[1]) + np.abs(h * h * h * c[0])
        jumps = np.abs(end[:-1] - c[3][1:]) > 1e-12 * (size[:-1] + size[1:])
        if jumps.any():
            raise ValueError(f"the curve jumps at {x[1:-1][jumps.any(axis=1)][0]}; expected one without jumps")
        final = c[2] + h * (2 * c[1] + h * (3 * c[0]))
        positions = np.concatenate([c[3], end[-1:]])
        into, out = np.concatenate([final[:1], final]), np.concatenate([c[2], final[-1:]])
        channels = c.shape[2]
        names = ["x", "y", "z"][:channels] if channels <= 3 else [f"p{i + 1}" for i in range(channels)]
        keys = {"t": x}
        for i, name in enumerate(names):
            keys |= {name: positions[:, i], f"{name}_vin": into[:, i], f"{name}_vout": out[:, i]}
        return cls(keys)

    def __repr__(self) -> str:
        return f"<Curve of {', '.join(self.names)} from {self.times[0]} to {self.times[-1]}>"
