"""Keys and samples in memory, as columns and as the text that the program reads.

A column of times is sent as text without loss: dates in UTC, durations as decimal seconds.
"""

from __future__ import annotations

import array
import datetime
import decimal
import fractions
import io
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple, Optional

import numpy as np


class Table(NamedTuple):
    """Columns of one length.

    names       the text of each name; None for an array without names
    columns     1-D arrays
    labels      the names as they are in the keys, such as the number 0 of a DataFrame
    originals   the columns as they are in the keys: arrays, or the Series of a DataFrame
    time_index  the name of the index of a DataFrame or Series that is the time, the first column; None without one
    frame       the DataFrame or Series
    has_spare_index  whether its index has no name and has whole numbers other than 0, 1, 2, ...; these are the times if
                no column is the time
    """

    names: Optional[list[str]]
    columns: list[np.ndarray[Any, Any]]
    labels: list[Any]
    originals: list[Any]
    time_index: Optional[tuple[Any]] = None
    frame: Any = None
    has_spare_index: bool = False

    def original(self, name: str) -> Optional[int]:
        """The number of the column with this name."""
        return self.names.index(name) if self.names and name in self.names else None

    def row_text(self, row: int) -> str:
        """A row as its user knows it: by its label where labels are not the numbers of rows."""
        if self.frame is None or not 0 <= row < len(self.frame) or not self.frame.index.is_unique:
            return f"row {row}"
        label = self.frame.index[row]
        return f"row {row}" if is_missing(label) or label == row else f"row {label!s}"


def is_pandas(value: Any) -> bool:
    return type(value).__module__.partition(".")[0] == "pandas" and hasattr(value, "iloc")


def is_xarray(value: Any) -> bool:
    return type(value).__module__.partition(".")[0] == "xarray" and hasattr(value, "coords")


def is_table(value: Any) -> bool:
    """Whether a value is keys in memory, not a path, a file or the contents of one."""
    return not isinstance(value, (str, os.PathLike, bytes)) and not hasattr(value, "read")


# From what users have to columns.


_DATES = (datetime.date, np.datetime64)  # a pandas.Timestamp is a date, too
_DURATIONS = (datetime.timedelta, np.timedelta64)


def in_nanoseconds(times: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Dates or durations of any unit. Raises ValueError."""
    result = times.astype(f"{times.dtype.kind}8[ns]")
    if (result.astype(times.dtype) != times)[~np.isnat(times)].any():
        raise ValueError("dates or durations that 64 bits of nanoseconds do not hold; expected dates from 1678 to 2261")
    return result


def array_of(values: Any) -> np.ndarray[Any, Any]:
    """Values as an array: dates, in UTC, and durations in nanoseconds, masked values as None. Raises ValueError."""
    if getattr(getattr(values, "dtype", None), "tz", None) is not None:
        return np.asarray(values, dtype="datetime64[ns]")
    found = np.asarray(values)
    if isinstance(values, np.ma.MaskedArray) and values.mask.any():
        found = np.where(values.mask, None, found.astype(object))  # type: ignore[call-overload]
    if found.dtype.kind in "mM":
        return in_nanoseconds(found)
    if found.dtype.kind != "O":
        return found
    objects = found.ravel().tolist()
    objects = [one.to_timestamp() if hasattr(one, "to_timestamp") else one for one in objects]  # of periods
    known = [one for one in objects if not is_missing(one)]
    for types, unit in ((_DATES, "datetime64[ns]"), (_DURATIONS, "timedelta64[ns]")):
        if known and all(isinstance(one, types) for one in known):
            counts = [np.iinfo(np.int64).min if is_missing(one) else nanoseconds(one) for one in objects]
            return np.array(counts, dtype=np.int64).view(unit).reshape(found.shape)
    return found


def _frame_of_xarray(keys: Any) -> Any:
    """A DataArray or Dataset as a Series or DataFrame with the coordinate of its first dimension as the index."""
    kind, dimensions = type(keys).__name__, list(keys.dims)
    if kind == "Dataset" and len(dimensions) != 1 or not 1 <= len(dimensions) <= 2:
        raise TypeError(f"a {kind} with the dimensions {dimensions}; expected one, whose coordinate is the time, and for a "
                        "DataArray at most one more, the channels")  # fmt: skip
    time = dimensions[0]
    if time not in keys.coords:
        raise TypeError(f"the dimension {time!r} has no coordinate, so there are no times; assign them, as in "
                        f"data.assign_coords({{{time!r}: times}})")  # fmt: skip
    keys = keys.reset_coords(drop=True)
    return keys.to_dataframe() if kind == "Dataset" else keys.to_pandas()


def _frame_table(keys: Any, index_is_time: bool = False) -> Table:
    import pandas

    index, frame = keys.index, keys
    is_time = index_is_time or index.nlevels == 1 and (index.dtype.kind in "mM" or str(index.dtype).startswith(("period", "datetime64")))
    if not hasattr(keys, "columns"):  # a Series
        counts_rows = index.name is None and index.dtype.kind in "iu" and index.equals(pandas.RangeIndex(len(index)))
        if index.nlevels > 1 or counts_rows:
            raise TypeError("the index of the Series has several levels, or only counts its rows; expected the times as "
                            "its index; set it, as in series.set_axis(times)")  # fmt: skip
        is_time, frame = True, keys.to_frame("x" if keys.name is None else keys.name)
    elif frame.columns.nlevels > 1:
        raise TypeError("the columns have names of several levels; expected one name for each column; join them, as in "
                        "frame.columns = ['_'.join(map(str, name)) for name in frame.columns]")  # fmt: skip
    labels = list(frame.columns)
    series = [frame.iloc[:, i].infer_objects() for i in range(frame.shape[1])]
    if is_time:
        time = str(index.name or "time")
        while time in map(str, labels):
            time = "index_" + time
        labels.insert(0, time)
        series.insert(0, index.to_series())
    elif None not in index.names:
        labels[:0] = index.names
        series[:0] = [pandas.Series(index.get_level_values(i)) for i in range(index.nlevels)]
    elif index.nlevels > 1 or index.dtype.kind == "f":
        raise TypeError("the index has no name, or a level of it has none, so it is unclear what it means; "
                        "frame.rename_axis('time'), or a list of names, makes it columns, and "
                        "frame.reset_index(drop=True) leaves it out")  # fmt: skip
    time_index = (index.name,) if is_time else None
    names = [str(label) for label in labels]
    is_spare = time_index is None and index.names == [None] and not index.equals(pandas.RangeIndex(len(index)))
    columns = [array_of(one) for one in series]
    return Table(names, columns, labels, series, time_index, frame, is_spare and index.dtype.kind in "iu")


def with_index_as_time(table: Table) -> Table:
    """The table of a DataFrame whose index is the time."""
    return _frame_table(table.frame, index_is_time=True)


def _named(columns: Mapping[Any, Any]) -> Table:
    arrays = [array_of(column) for column in columns.values()]
    shapes = {str(name): column.shape for name, column in zip(columns, arrays)}
    if any(len(shape) != 1 for shape in shapes.values()) or len(set(shapes.values())) > 1:
        raise ValueError(f"shapes of columns: {shapes}; expected 1-D columns of one length, one for each channel")
    return Table([str(name) for name in columns], arrays, list(columns), arrays)


def _is_column(values: Any) -> bool:
    is_sequence = isinstance(values, (Sequence, array.array, memoryview)) and not isinstance(values, (str, bytes))
    return is_sequence or hasattr(values, "__array__")


def _pair_table(keys: Any) -> Table:
    """Times and positions, each an array or a sequence, as interpolators of SciPy take them."""
    times, positions = map(array_of, keys)
    if times.ndim != 1 or positions.ndim not in (1, 2) or len(times) != len(positions):
        raise ValueError(f"times of shape {times.shape} with positions of shape {positions.shape}; expected n times "
                         "with n positions, or with an array of n rows, one column for each channel")  # fmt: skip
    return Table(None, [times, *np.atleast_2d(positions.T)], [], [])


def table(keys: Any) -> Table:
    """The columns of keys or samples in memory. Raises TypeError or ValueError for what is not a table."""
    kind = type(keys).__name__
    if is_pandas(keys):
        return _frame_table(keys)
    if is_xarray(keys):
        return _frame_table(_frame_of_xarray(keys), index_is_time=True)
    if hasattr(keys, "__dataframe__"):  # as an array, it would lose its names
        raise TypeError(f"a {kind} of {type(keys).__module__.partition('.')[0]}; expected a DataFrame of pandas, which its "
                        "method to_pandas() returns")  # fmt: skip
    if isinstance(keys, Mapping):
        return _named(keys)
    if isinstance(keys, tuple) and len(keys) == 2 and all(map(_is_column, keys)):
        return _pair_table(keys)
    rows: list[Any] = []
    if isinstance(keys, Iterable) and not hasattr(keys, "__array__"):
        keys = rows = list(keys)
    if rows and all(isinstance(row, Mapping) for row in rows):
        names = dict.fromkeys(name for row in rows for name in row)
        return _named({name: [row.get(name) for row in rows] for name in names})
    try:
        found = keys if isinstance(keys, np.ma.MaskedArray) else np.asarray(keys)
    except ValueError:
        found = np.empty(0)  # rows of several lengths
    if found.dtype.names:
        return _named({name: found[name] for name in found.dtype.names})
    if found.ndim == 2:
        columns: Any = map(list, zip(*rows)) if rows else found.T  # columns of a list have types of their own
        return Table(None, [array_of(column) for column in columns], [], [])
    raise TypeError(f"{kind} is no table of keys; expected a 2-D or structured array, a pair of times "
                    "and positions, a dict of columns, a list of dicts, a DataFrame, a Series, a DataArray, a path, an open file, "
                    "or bytes")  # fmt: skip


# From columns to text.


_PLAIN_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


def are_floats(column: np.ndarray[Any, Any]) -> bool:
    return bool(column.dtype.kind == "f" and column.dtype.itemsize <= 8)


def quoted(text: str) -> str:
    """A cell of CSV."""
    return '"' + text.replace('"', '""') + '"' if re.search(r'[",\r\n#]|^\s|\s$', text) else text


def is_missing(value: Any) -> bool:
    return value is None or type(value).__name__ in ("NAType", "NaTType") or bool(value != value)  # the last: NaN


def _cell(value: Any) -> str:
    return "" if is_missing(value) else quoted(word(value))


def cells(column: np.ndarray[Any, Any]) -> list[str]:
    """The texts of a column: every number with all its digits, and nothing for a missing one."""
    kind = column.dtype.kind
    if are_floats(column):
        return ["" if number != number else repr(number) for number in column.astype(np.float64).tolist()]
    if kind in "iu":
        return [repr(number) for number in column.tolist()]
    if kind == "M":
        return ["" if text == "NaT" else text for text in np.datetime_as_string(column, timezone="UTC").tolist()]
    if kind == "m":
        return decimal_seconds(column)
    if kind in "OUSbf":
        return [_cell(value) for value in column.tolist()]
    raise TypeError(f"a column of {column.dtype}; expected numbers, texts, dates or durations")


def encode(table: Table) -> bytes:
    """The table as CSV, with a line of names above the rows if it has names."""
    columns = [cells(column) for column in table.columns]
    if len(columns) == 1:  # an empty line would be no row
        columns[0] = [cell or '""' for cell in columns[0]]
    lines = "".join(",".join(row) + "\n" for row in zip(*columns))
    head = "" if table.names is None else ",".join(map(quoted, table.names)) + "\n"
    return (head + lines).encode()


def encode_as_array(table: Table) -> Optional[bytes]:
    """The table as a file of NumPy, from which the program reads the numbers that the text has; None for a table with
    other cells than numbers, or with names or numbers that may mean something else in the text."""
    columns = [column.astype(np.float64) if are_floats(column) else column for column in table.columns]
    for column in columns:
        if column.dtype.kind not in "fiu" or not (np.abs(column.astype(np.float64)) < 1e15).all():
            return None
    if not columns:
        return None
    if table.names is None:
        array = np.column_stack(columns)  # numbers below 1e15 are doubles
    elif len(set(table.names)) < len(columns) or not all(_PLAIN_NAME.fullmatch(name) for name in table.names):
        return None
    else:
        array = np.empty(len(columns[0]), [(name, column.dtype) for name, column in zip(table.names, columns)])
        for name, column in zip(table.names, columns):
            array[name] = column
    file = io.BytesIO()
    np.save(file, array)
    return file.getvalue()


# Values of options.


def shown(value: Any) -> str:
    """A value in a message: a number of NumPy as that of Python."""
    return repr(value.item() if isinstance(value, np.generic) else value)


def nanoseconds(value: Any) -> int:
    """A duration, or a date since 1970."""
    count = getattr(value, "value", None)  # of pandas, whose nanoseconds NumPy would drop
    if isinstance(count, int):
        return count
    if isinstance(value, datetime.datetime) and value.tzinfo is not None:
        value = value.astimezone(datetime.timezone.utc).replace(tzinfo=None)
    kind = "m8" if isinstance(value, _DURATIONS) else "M8"
    return int(in_nanoseconds(np.asarray(value, dtype=kind)).astype(np.int64))


def decimal_seconds(times: np.ndarray[Any, Any]) -> list[str]:
    """Durations in seconds, or dates in seconds since 1970, exactly; an empty text for a missing one."""
    counts = zip(times.ravel().view(np.int64).tolist(), np.isnat(times.ravel()).tolist())
    return ["" if missing else f"{decimal.Decimal(count).scaleb(-9):f}" for count, missing in counts]


def date_text(seconds: str) -> str:
    """The date of decimal seconds since 1970."""
    return str(np.datetime64(int(decimal.Decimal(seconds).scaleb(9)), "ns")).rstrip("0").rstrip(".") + "Z"


def word(value: Any) -> str:
    """The text of a single value. Raises TypeError."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, (*_DATES, *_DURATIONS)):
        times = array_of(value)
        if times.dtype.kind in "mM":
            return _times_text(times)
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, (int, np.longdouble, decimal.Decimal, fractions.Fraction)):
        return str(value)
    raise TypeError(f"{shown(value)} is a {type(value).__name__}; expected a number, a text or a date")


def _times_text(times: np.ndarray[Any, Any]) -> str:
    texts = decimal_seconds(times)
    if "" in texts:
        raise TypeError("NaT is no time; expected a date or a duration")
    return ",".join(text + "s" if times.dtype.kind == "m" else text for text in texts)


def text(value: Any) -> str:
    """The text of the value of an option: A,B for a list, A=B:C for a dict. Raises TypeError."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, Mapping):
        return ",".join(f"{key}={text(part).replace(',', ':')}" for key, part in value.items())
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes)):
        if hasattr(value, "dtype") and (times := array_of(value)).dtype.kind in "mM":
            return _times_text(times)
        return ",".join(text(part) for part in value)
    return word(value)
