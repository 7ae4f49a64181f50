"""Curves that NumPy evaluates in this process, from the exact pieces that the program prints."""

from __future__ import annotations

import copy
import json
import os
from bisect import bisect_right
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from ._options import Options
from ._program import Error, Run
from ._rows import rows_of
from ._tables import contents, decimal_seconds, is_missing, is_pandas, is_table

if TYPE_CHECKING:
    from typing_extensions import Unpack

    Array = np.ndarray[Any, np.dtype[np.float64]]

_BLOCK = 1 << 13  # places that are evaluated together, which fit into the cache of a processor
_RUN = 1 << 10  # so many places on a piece are faster together than with those of other pieces
_LARGEST_WHOLE = 2**53  # up to here, every whole number is a double
_SAMPLING = {"step", "rate", "fps", "count", "segments", "per_segment", "at", "arc_step", "arc_count", "arc_at",
             "tolerance", "emit", "fit_keys", "keep_times", "corner", "from_", "to", "end", "keys", "fields"}  # fmt: skip
_DERIVATIVES = ("position", "velocity", "acceleration", "jerk")


class _Pieces:
    """Cubics one after another, each by its two ends, so that a place is evaluated from the nearer one.

    starts, ends  (n,) the times of n pieces
    durations     (n,) seconds, or units of time
    bezier        (n, 4, c) control points of c channels
    """

    def __init__(self, starts: Any, ends: Any, durations: Any, bezier: Any) -> None:
        self.starts, self.ends, self.durations = starts, ends, durations
        self.bezier = bezier
        b = bezier.astype(np.longdouble)

        def halves(left: Any, right: Any) -> Any:
            return np.stack([left, right], axis=1).reshape(2 * len(left), *left.shape[1:])

        def powers(b0: Any, b1: Any, b2: Any, b3: Any) -> list[Any]:
            return [b0, 3 * (b1 - b0), 3 * ((b2 - b1) - (b1 - b0)), (b3 - b0) - 3 * (b2 - b1)]

        # Of half h of piece i at 2 i + h: where it begins, the end of the piece beside it, the duration, which is
        # negative from the right end, and the coefficients of the powers of the distance from that end.
        self._breaks = halves(starts, starts + durations / 2)
        self._bases = halves(starts, ends)
        self._scales = halves(durations, -durations)
        both = zip(powers(*b.transpose(1, 0, 2)), powers(*b[:, ::-1].transpose(1, 0, 2)))
        self._powers = [halves(left, right).astype(np.float64) for left, right in both]
        self._columns: dict[int, list[Array]] = {}  # by the order of the derivative: coefficients of the powers of u
        self._numbers: dict[tuple[int, int], tuple[float, float, list[list[float]]]] = {}  # by the order and the half
        self._break_list: list[float] = self._breaks.tolist()
        self.first, self.last = float(starts[0]), float(ends[-1])

    def powers(self) -> list[Array]:
        """The coefficients of u^0, u^1, u^2, u^3 of each piece, (n, c) each, for u from 0 to 1."""
        return [power[::2] for power in self._powers]

    def _coefficients(self, order: int) -> list[Array]:
        """Those of u^3 down to u^0 of a derivative by u, (c, 2 n) each, which is contiguous for a channel."""
        if order not in self._columns:
            factors = ((1.0, 1.0, 1.0, 1.0), (1.0, 2.0, 3.0), (2.0, 6.0), (6.0,))[order]
            columns: list[Array] = [np.ascontiguousarray(p.T) * f for f, p in zip(factors, self._powers[order:])]
            columns += [np.zeros_like(columns[0])] * order
            self._columns[order] = columns[::-1]
        return self._columns[order]

    def at(self, time: float, order: int) -> Array:
        """A derivative of order 0 to 3 at one time, (channels,). Requires: first <= time <= last."""
        half = bisect_right(self._break_list, time) - 1
        found = self._numbers.get((order, half))
        if found is None:
            channels = np.stack([column[:, half] for column in self._coefficients(order)], axis=1).tolist()
            found = float(self._bases[half]), float(self._scales[half]), channels
            self._numbers[order, half] = found
        base, scale, channels = found
        u = (time - base) / scale
        values = [((a * u + b) * u + c) * u + d for a, b, c, d in channels]
        for _ in range(order):
            values = [value / scale for value in values]
        return np.array(values)

    def _parts(self, times: Array) -> Iterator[tuple[slice, Any]]:
        """Parts of times, and the half, or the halves, on which they are."""
        if len(times) >= _RUN * len(self._breaks) and (times[1:] >= times[:-1]).all():
            begins = [0, *times.searchsorted(self._breaks[1:]).tolist(), len(times)]
            for half, (begin, end) in enumerate(zip(begins, begins[1:])):
                for first in range(begin, end, _BLOCK):
                    yield slice(first, min(first + _BLOCK, end)), half
            return
        for first in range(0, len(times), _BLOCK):
            part = slice(first, first + _BLOCK)
            yield part, self._breaks.searchsorted(times[part], "right") - 1

    def evaluate(self, times: Array, order: int) -> Array:
        """A derivative of order 0 to 3 at each time, (times, channels). Requires: first <= times <= last."""
        result = np.empty((len(times), self.bezier.shape[2]))
        first, *others = self._coefficients(order)[order:]
        for part, half in self._parts(times):
            scale = self._scales.take(half)
            u = (times[part] - self._bases.take(half)) / scale
            for channel in range(result.shape[1]):
                value = first[channel].take(half)
                for column in others:
                    value = value * u
                    value += column[channel].take(half)
                for _ in range(order):
                    value = value / scale
                result[part, channel] = value
        return result


def _nanoseconds(dates: Any) -> Any:
    return np.asarray(dates, dtype="datetime64[ns]").astype(np.int64)


class Curve:
    """A curve through keys, to evaluate at any times.

    keys      keys of one curve, as for resample()
    preset    the rules of a product; see presets()
    options   options of the curve and of its keys, such as closed=True, extrapolate="hold", ends="natural" or
              columns={"time": "stamp"}; see Options

    times     (n + 1,) the times where the n pieces of the curve begin and end: those of the keys
    names     the names of the c channels

    Times are numbers in the unit of the keys, or dates or durations where those of the keys are; derivatives are per
    unit of time, or per second. Positions and derivatives are computed in this process, by NumPy; they are within 4
    units in the last place of what resample() returns, counted at the largest control value of the piece. What is no
    cubic in time (rotations, ease), lengths, places outside the keys and golden=True take a run of the program.

    Raises Error if keys or options are rejected, and TypeError for an unknown option or what is not a table.

    >>> import tcbsample
    >>> curve = tcbsample.Curve([[0, 0, 5], [1, 2, 6], [2, 0, 7]])
    >>> curve(0.5).tolist()
    [1.125, 5.4375]
    >>> curve([0.5, 1.5], 1).shape
    (2, 2)
    """

    def __init__(self, keys: Any, /, *, preset: Optional[str] = None, **options: Unpack[Options]) -> None:
        if options.get("group") is not None:
            raise TypeError("group: a Curve is one curve; make one for each group, as in {name: Curve(rows) for name, "
                            "rows in frame.groupby('id')}")  # fmt: skip
        samples = _SAMPLING.intersection(name for name, value in options.items() if value is not None)
        if samples:
            raise TypeError(f"{samples.pop()}: a Curve has no samples until it is called with times; leave it out")
        in_memory = is_table(keys)
        self._keys = keys.copy() if is_pandas(keys) else copy.deepcopy(keys) if in_memory else (
            keys if isinstance(keys, (str, os.PathLike, bytes)) else contents(keys))  # fmt: skip
        self._options: dict[str, Any] = dict(options, preset=preset)
        self._extrapolate = self._options.pop("extrapolate", None)
        self._metric = options.get("metric")
        if not options.get("equal_speed") and options.get("parameter") is None:
            self._options.pop("metric", None)  # only lengths depend on it
        self._pieces: Optional[_Pieces] = None
        self._origin: Optional[int] = None  # of dates, in nanoseconds, and of large whole numbers; None for others
        self._is_whole = False  # times are whole numbers, some of them beyond those that are doubles
        self.times: np.ndarray[Any, np.dtype[Any]]
        try:
            with Run(self._keys).add({**self._options, "emit": "bezier"}) as run:
                rows = [json.loads(line) for line in run.result(["--output-format=jsonl"])]
        except Error:
            self._set_from_keys()
        else:
            self._set_pieces(rows)

    def _set_pieces(self, rows: list[dict[str, Any]]) -> None:
        if None in rows:
            raise TypeError("the keys are several curves; expected one; make a Curve for each")
        self.names = [name[: -len("_b0")] for name in rows[0] if name.endswith("_b0")]
        durations = np.array([row["duration"] for row in rows], dtype=np.float64)
        bezier = np.array([[[row[f"{name}_b{i}"] for name in self.names] for i in range(4)] for row in rows], dtype=float)
        starts = [row["start"] for row in rows]
        if isinstance(starts[0], str):
            dates = _nanoseconds([start.rstrip("Z") for start in starts])
            end = dates[-1] + round(durations[-1] * 1e9)
            self._origin = int(dates[0])
            self.times = np.append(dates, end).astype("datetime64[ns]")
            edges = (np.append(dates, end) - self._origin) / 1e9
        elif self._has_large(starts) and self._origin is not None:
            self.times = np.append(np.array(starts, dtype=np.int64), starts[-1] + round(durations[-1]))
            edges = (self.times - self._origin).astype(np.float64)
        else:
            edges = np.array(starts, dtype=np.float64)
            edges = np.append(edges, edges[-1] + durations[-1])
            self.times = edges
        self._pieces = _Pieces(edges[:-1], edges[1:], durations, bezier)

    def _set_from_keys(self) -> None:
        """For curves without cubics in time. Raises Error."""
        with Run(self._keys).add({**self._options, "per_segment": 1, "fields": "time,position"}) as run:
            rows = [json.loads(line) for line in run.result(["--output-format=jsonl"])]
        time, *self.names = rows[0]
        times = [row[time] for row in rows]
        if isinstance(times[0], str):
            dates = _nanoseconds([date.rstrip("Z") for date in times])
            self._origin = int(dates[0])
            self.times = dates.astype("datetime64[ns]")
        else:
            self.times = np.array(times, dtype=np.int64 if self._has_large(times) else np.float64)

    def _has_large(self, times: list[Any]) -> bool:
        """Whether times are whole numbers beyond those that are doubles; then they count from the first one."""
        if all(isinstance(time, int) for time in times) and max(abs(time) for time in times) > _LARGEST_WHOLE:
            self._origin, self._is_whole = times[0], True
        return self._is_whole

    def _flat(self, t: Any) -> tuple[Any, tuple[int, ...]]:
        """Times as the pieces have them, in one dimension, and their shape."""
        array = np.asarray(t)
        if self._is_whole and self._origin is not None:
            if array.dtype.kind not in "iu":
                raise TypeError(f"times of {array.dtype}, but those of the keys are whole numbers beyond 2^53; expected "
                                "whole numbers")  # fmt: skip
            return (array.ravel().astype(np.int64) - self._origin).astype(np.float64), array.shape
        if array.dtype.kind == "O":
            numbers = [np.nan if is_missing(v) else float(decimal_seconds(v)) if hasattr(v, "isoformat") else v
                       for v in array.ravel().tolist()]  # fmt: skip
            dates = any(hasattr(value, "year") for value in array.ravel().tolist())
            if dates and self._origin is not None:
                counts = [decimal_seconds(v).replace(".", "") for v in array.ravel().tolist()]
                return (np.array(counts, dtype=object).astype(np.int64) - self._origin) / 1e9, array.shape
            return np.array(numbers, dtype=np.float64), array.shape
        if array.dtype.kind == "M":
            if self._origin is None:
                raise TypeError("dates, but the times of the keys are numbers; expected times in the unit of the keys")
            nanoseconds = _nanoseconds(array.ravel()) - self._origin
            return np.where(np.isnat(array.ravel()), np.nan, nanoseconds / 1e9), array.shape
        if array.dtype.kind == "m":
            if self._origin is not None:
                raise TypeError("durations, but the times of the keys are dates; expected dates")
            seconds = array.ravel().astype("m8[ns]").astype(np.int64) / 1e9
            return np.where(np.isnat(array.ravel()), np.nan, seconds), array.shape
        if self._origin is not None:  # seconds since 1970, as the program counts dates
            return array.ravel().astype(np.float64) - self._origin / 1e9, array.shape
        return array.ravel().astype(np.float64, copy=False), array.shape

    def _words(self, flat: Any, given: Any) -> list[str]:
        """The texts of times for the program."""
        if self._is_whole:
            return [str(time) for time in np.asarray(given).ravel().tolist()]
        if self._origin is None:
            return [repr(time) for time in flat.tolist()]
        array = np.asarray(given).ravel()
        if array.dtype.kind in "MO":
            return [decimal_seconds(value) for value in array.tolist()] if array.dtype.kind == "O" else [
                decimal_seconds(value) for value in array]  # fmt: skip
        return [repr(value) for value in array.astype(np.float64).tolist()]

    def _ask(self, places: Mapping[str, Any], fields: str, **more: Any) -> Array:
        """The numbers of some fields that the program prints at places, which more may extend: a row for each."""
        if not any(places.values()):
            return np.empty((0, 1 if fields in ("s", "time") else len(self.names)))
        options = {**self._options, "quiet": True, "fields": fields, **more, **places}
        with Run(self._keys).add(options) as run:
            run.table = None  # no row has the types of the keys
            rows = rows_of(run, {})
        numbers: Array = np.stack([rows[name] for name in rows.dtype.names or ()], axis=1).astype(np.float64)
        return numbers

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
        pieces = self._pieces
        if isinstance(t, (float, int)) and type(nu) is int and 0 <= nu <= 3 and not golden and self._origin is None:
            if pieces is not None and pieces.first <= t <= pieces.last:  # a number, without the cost of arrays
                return pieces.at(float(t), nu)
        if nu != int(nu) or nu < 0:
            raise ValueError(f"nu: {nu!r}; expected the order of a derivative: 0, 1, 2, ...")
        flat, shape = self._flat(t)
        if pieces is not None and not golden and nu <= 3 and flat.size > 0:
            if pieces.first <= flat.min() and flat.max() <= pieces.last:
                return pieces.evaluate(flat, nu).reshape((*shape, len(self.names)))
        result: Array = np.full((flat.size, len(self.names)), np.nan)
        is_number = ~np.isnan(flat)
        inside = is_number & (pieces is not None and not golden)
        if pieces is not None:
            inside &= (flat >= pieces.first) & (flat <= pieces.last)
            if inside.any():
                result[inside] = pieces.evaluate(flat[inside], nu) if nu <= 3 else 0.0
        others = is_number & ~inside
        if others.any():
            if nu > 3:
                raise ValueError(f"nu: {nu}; expected at most 3 outside the keys, for rotations and with ease")
            words = np.array(self._words(flat, t))[others]
            result[others] = self._ask({"at": words.tolist()}, _DERIVATIVES[nu], golden=golden,
                                       extrapolate=self._extrapolate)  # fmt: skip
        return result.reshape((*shape, len(self.names)))

    def length(self, t: Any) -> Array:
        """Arc lengths from the start of the curve to times, in an array of the shape of t. Raises Error as a call.

        >>> import tcbsample
        >>> float(tcbsample.Curve([[0, 0, 0], [1, 3, 4]]).length(1))
        5.0
        """
        flat, shape = self._flat(t)
        return self._ask({"at": self._words(flat, t)}, "s", metric=self._metric,
                         extrapolate=self._extrapolate)[:, 0].reshape(shape)  # fmt: skip

    def at_length(self, s: Any) -> Array:
        """Positions at arc lengths from the start, shape s.shape + (c,). Raises Error for lengths beyond the end.

        >>> import tcbsample
        >>> tcbsample.Curve([[0, 0, 0], [1, 3, 4]]).at_length([0, 2.5]).tolist()
        [[0.0, 0.0], [1.5, 2.0]]
        """
        array = np.asarray(s, dtype=np.float64)
        rows = self._ask({"arc_at": [repr(value) for value in array.ravel().tolist()]}, "position", metric=self._metric)
        return rows.reshape((*array.shape, len(self.names)))

    def time_at_length(self, s: Any) -> Array:
        """The times at which arc lengths from the start are reached, in an array of the shape of s; for dates, seconds
        since 1970. Raises Error for lengths beyond the end.

        >>> import tcbsample
        >>> float(tcbsample.Curve([[0, 0, 0], [1, 3, 4]]).time_at_length(2.5))
        0.5
        """
        array = np.asarray(s, dtype=np.float64)
        words = [repr(value) for value in array.ravel().tolist()]
        return self._ask({"arc_at": words}, "time", metric=self._metric, time_format="seconds")[:, 0].reshape(array.shape)

    def rotation(self, t: Any) -> Array:
        """Rotations at times, as quaternions x, y, z, w, which scipy.spatial.transform.Rotation.from_quat() takes.

        Returns an array of shape t.shape + (4,), or t.shape + (r, 4) for r > 1 rotations. Raises Error as a call, and
        ValueError if the keys have no rotation.

        >>> import tcbsample
        >>> keys = {"t": [0, 1], "qx": [0, 0], "qy": [0, 0], "qz": [0, 0.6], "qw": [1, 0.8]}
        >>> tcbsample.Curve(keys).rotation(1).tolist()
        [0.0, 0.0, 0.6, 0.8]
        """
        with Run(self._keys).add(self._options) as run:
            lines = run.result(["--explain"]).read().decode().splitlines()
        forms = [line.partition(": ")[2].split() for line in lines if line.startswith("rotation: ")]
        if not forms:
            raise ValueError("the keys have no rotation; expected columns such as qx, qy, qz, qw; name them, as in "
                             'rotation="quaternion=a:b:c:d"')  # fmt: skip
        flat, shape = self._flat(t)
        places = {"at": self._words(flat, t)}
        rows = self._ask(places, "position", rotation_output="quaternion", extrapolate=self._extrapolate)
        others = len(self.names) - sum(len(columns) for _, *columns in forms)
        found = rows[:, others:].reshape((*shape, -1, 4))
        return found[..., 0, :] if found.shape[-2] == 1 else found

    def to_ppoly(self) -> Any:
        """The curve as a scipy.interpolate.PPoly, whose values have the shape t.shape + (c,).

        Raises ValueError for a curve that is not a cubic in time, and ImportError without SciPy.
        """
        from scipy.interpolate import PPoly

        if self._pieces is None:
            raise ValueError("the curve is not a cubic in time, as it has rotations or ease; sample it instead")
        h = self._pieces.durations[:, None]
        p = self._pieces.powers()
        coefficients = np.stack([p[3] / h / h / h, p[2] / h / h, p[1] / h, p[0]])
        x = np.append(self._pieces.starts, self._pieces.ends[-1])
        return PPoly(coefficients, x, extrapolate="periodic" if self._options.get("closed") else False)

    @classmethod
    def from_ppoly(cls, ppoly: Any) -> Curve:
        """The curve of a scipy.interpolate.PPoly of cubics, such as a CubicSpline: a key with velocities at each break.

        Raises ValueError for polynomials of a higher degree, for values of more than one dimension, and for a curve
        that jumps.
        """
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
            raise ValueError(f"the curve jumps at {x[1:-1][jumps.any(axis=1)][0]!r}; expected one without jumps")
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
