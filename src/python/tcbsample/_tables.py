"""Keys and samples in memory, as columns and as the text that the program reads.

A column of times is sent as text without loss: dates in UTC, durations as decimal seconds.
"""

from __future__ import annotations

import datetime
import decimal
import fractions
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
    types       the pandas type of each column; None for an array
    time_index  the name of the index of a DataFrame or Series that is the time, the first column; None without one
    frame       the DataFrame or Series
    """

    names: Optional[list[str]]
    columns: list[np.ndarray[Any, Any]]
    labels: list[Any]
    types: list[Any]
    time_index: Optional[tuple[Any]] = None
    frame: Any = None

    def original(self, name: str) -> Optional[int]:
        """The number of the column with this name."""
        return self.names.index(name) if self.names and name in self.names else None

    def row_text(self, row: int) -> str:
        """A row as its user knows it: by its label where labels are not the numbers of rows."""
        if self.frame is None or not 0 <= row < len(self.frame):
            return f"row {row}"
        label = self.frame.index[row]
        return f"row {row}" if label is row or label == row else f"row {label!s}"


def is_pandas(value: Any) -> bool:
    return type(value).__module__.partition(".")[0] == "pandas" and hasattr(value, "iloc")


def is_table(value: Any) -> bool:
    """Whether a value is keys in memory, not a path, a file or the contents of one."""
    return not isinstance(value, (str, os.PathLike, bytes)) and not hasattr(value, "read")


def contents(value: Any) -> bytes:
    """The bytes of an open file, of text or of bytes, from its position on."""
    data = value.read()
    return data.encode() if isinstance(data, str) else bytes(data)


# From what users have to columns.


def _series_array(series: Any) -> np.ndarray[Any, Any]:
    kind = str(series.dtype)
    if kind.startswith("period"):
        series = series.dt.to_timestamp()
    if getattr(series.dtype, "tz", None) is not None:
        return series.dt.tz_convert("UTC").dt.tz_localize(None).to_numpy("datetime64[ns]")  # type: ignore[no-any-return]
    return series.to_numpy()  # type: ignore[no-any-return]


def _unused(name: str, names: Sequence[Any]) -> str:
    while name in map(str, names):
        name = "index_" + name
    return name


def _is_time_index(index: Any) -> bool:
    return bool(index.nlevels == 1 and (index.dtype.kind in "mM" or str(index.dtype).startswith(("period", "datetime64"))))


def _frame_table(frame: Any) -> Table:
    import pandas

    labels = list(frame.columns)
    if frame.columns.nlevels > 1:
        raise TypeError("the columns have names of several levels; expected one name for each column; join them, as in "
                        "frame.columns = ['_'.join(map(str, name)) for name in frame.columns]")  # fmt: skip
    series = [frame.iloc[:, i] for i in range(frame.shape[1])]
    index = None
    if _is_time_index(frame.index):
        index = (frame.index.name,)
        labels.insert(0, _unused(str(frame.index.name or "time"), labels))
        series.insert(0, frame.index.to_series())
    elif frame.index.nlevels > 1 or frame.index.name is not None:
        levels = range(frame.index.nlevels)
        labels[:0] = [frame.index.names[i] if frame.index.names[i] is not None else f"level_{i}" for i in levels]
        series[:0] = [pandas.Series(frame.index.get_level_values(i)) for i in levels]
    elif frame.index.dtype.kind == "f":
        raise TypeError("the index has no name, so it is unclear what it means; frame.rename_axis('time') makes it a "
                        "column of times, frame.reset_index(drop=True) leaves it out")  # fmt: skip
    types = [one.dtype for one in series]
    return Table([str(label) for label in labels], [_series_array(one) for one in series], labels, types, index, frame)


def _series_table(series: Any) -> Table:
    index = series.index
    if index.nlevels > 1 or (index.dtype.kind in "iu" and index.name is None and list(index) == list(range(len(index)))):
        raise TypeError("the index of the Series only counts its rows; expected the times as its index; set it, as in "
                        "series.set_axis(times)")  # fmt: skip
    label = series.name if series.name is not None else "x"
    time = _unused(str(index.name or "time"), [label])
    times = index.to_series()
    return Table([time, str(label)], [_series_array(times), _series_array(series)], [time, label],
                 [times.dtype, series.dtype], (index.name,), series)  # fmt: skip


def _named(columns: Mapping[Any, Any]) -> Table:
    arrays = [_series_array(c) if is_pandas(c) else np.asarray(c) for c in columns.values()]
    shapes = {str(name): array.shape for name, array in zip(columns, arrays)}
    if any(len(shape) != 1 for shape in shapes.values()) or len(set(shapes.values())) > 1:
        raise ValueError(f"shapes of columns: {shapes}; expected 1-D columns of one length, one for each channel")
    return Table([str(name) for name in columns], arrays, list(columns), [None] * len(arrays))


def _rows_of_dicts(rows: Sequence[Mapping[Any, Any]]) -> Table:
    names = list(dict.fromkeys(name for row in rows for name in row))
    columns = {}
    for name in names:
        values = [row.get(name) for row in rows]
        column = np.asarray(values)
        columns[name] = column if column.ndim == 1 else np.array([*values, None], dtype=object)[:-1]
    return _named(columns)


def _is_pair(keys: tuple[Any, ...]) -> bool:
    """Whether keys are times and positions, each an array or a list, as interpolators of SciPy take them."""
    are_columns = [isinstance(part, (list, np.ndarray)) or is_pandas(part) for part in keys]
    return are_columns == [True, True]


def _pair_table(keys: Any) -> Table:
    times, positions = (np.asarray(part) for part in keys)
    if times.ndim != 1 or positions.ndim not in (1, 2) or len(times) != len(positions):
        raise ValueError(f"times of shape {times.shape} with positions of shape {positions.shape}; expected n times "
                         "with n positions, or with an array of n rows, one column for each channel")  # fmt: skip
    return Table(None, [times, *positions.reshape(len(times), -1).T], [], [])


def table(keys: Any) -> Table:
    """The columns of keys or samples in memory. Raises TypeError, ValueError for what is not a table."""
    if is_pandas(keys):
        return _frame_table(keys) if hasattr(keys, "columns") else _series_table(keys)
    if isinstance(keys, Mapping):
        return _named(keys)
    if isinstance(keys, tuple) and _is_pair(keys):
        return _pair_table(keys)
    if isinstance(keys, Iterable) and not isinstance(keys, np.ndarray):
        keys = list(keys)
        if keys and all(isinstance(row, Mapping) for row in keys):
            return _rows_of_dicts(keys)
    array = np.asarray(keys)
    if array.dtype.names:
        return _named({name: array[name] for name in array.dtype.names})
    if array.ndim == 2:
        return Table(None, list(array.T), [], [])
    raise TypeError(f"an array of {array.ndim} dimensions; expected a 2-D or structured array, a pair of times and "
                    "positions, a dict of columns, a list of dicts, a DataFrame, a Series, a path, an open file, or "
                    "bytes")  # fmt: skip


# From columns to text.


def are_floats(column: np.ndarray[Any, Any]) -> bool:
    return bool(column.dtype.kind == "f" and column.dtype.itemsize <= 8)


def quoted(text: str) -> str:
    """A cell of CSV."""
    return '"' + text.replace('"', '""') + '"' if re.search(r'[",\r\n#]|^\s|\s$', text) else text


def is_missing(value: Any) -> bool:
    return value is None or type(value).__name__ in ("NAType", "NaTType") or bool(value != value)  # the last: NaN


def _cell(value: Any) -> str:
    return "" if is_missing(value) else quoted(word(value))


_DATES = (datetime.date, np.datetime64)  # a pandas.Timestamp is a date, too
_DURATIONS = (datetime.timedelta, np.timedelta64)


def _as_dates(column: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """A column of objects that are all dates, or all durations, as an array of these."""
    values = [value for value in column.tolist() if not is_missing(value)]
    if values and all(isinstance(value, _DATES) for value in values):
        utc = [None if is_missing(v) else decimal_seconds(v) for v in column.tolist()]
        counts = ["NaT" if text is None else int(decimal.Decimal(text).scaleb(9)) for text in utc]
        return np.array(counts, dtype="datetime64[ns]")
    if values and all(isinstance(value, _DURATIONS) for value in values):
        return np.array([np.timedelta64("NaT") if is_missing(v) else v for v in column.tolist()], "timedelta64[ns]")
    return column


def cells(column: np.ndarray[Any, Any]) -> list[str]:
    """The texts of a column: every number with all its digits."""
    if column.dtype.kind == "O":
        column = _as_dates(column)
    kind = column.dtype.kind
    if are_floats(column):
        column = column.astype(np.float64)
    if are_floats(column) or kind in "iu":
        return [repr(number) for number in column.tolist()]
    if kind == "M":
        times = column if np.datetime_data(column.dtype)[0] in ("ms", "us", "ns") else column.astype("M8[s]")
        texts = np.datetime_as_string(times, timezone="UTC").tolist()
        return ["" if text == "NaT" else text for text in texts]
    if kind == "m":
        durations = column.astype("m8[ns]").astype(np.int64).tolist()
        missing = np.isnat(column).tolist()
        return ["" if m else f"{decimal.Decimal(d).scaleb(-9):f}" for d, m in zip(durations, missing)]
    if kind in "OUSbf":
        return [_cell(value) for value in column.tolist()]
    raise TypeError(f"a column of {column.dtype}; expected numbers, texts, dates or durations")


def encode(table: Table) -> bytes:
    """The table as CSV, with a line of names above the rows if it has names."""
    if table.columns and all(are_floats(column) for column in table.columns):
        numbers = np.column_stack(table.columns).astype(np.float64)
        form = ",".join(["%r"] * len(table.columns)) + "\n"  # many rows at once are quicker than row by row
        parts = (numbers[i : i + 10000] for i in range(0, len(numbers), 10000))
        lines = "".join(form * len(part) % tuple(part.ravel().tolist()) for part in parts)
    else:
        lines = "".join(",".join(row) + "\n" for row in zip(*map(cells, table.columns)))
    head = "" if table.names is None else ",".join(map(quoted, table.names)) + "\n"
    return (head + lines).encode()


# Values of options.


def decimal_seconds(value: Any) -> str:
    """A duration in seconds, or a date in seconds since 1970, exactly."""
    count = getattr(value, "value", None)  # of pandas, whose nanoseconds NumPy would drop
    if not isinstance(count, int):
        if isinstance(value, datetime.datetime) and value.tzinfo is not None:
            value = value.astimezone(datetime.timezone.utc).replace(tzinfo=None)
        count = int((np.timedelta64 if isinstance(value, _DURATIONS) else np.datetime64)(value, "ns").astype(np.int64))
    return f"{decimal.Decimal(count).scaleb(-9):f}"


def word(value: Any) -> str:
    """The text of a single value."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, _DURATIONS):
        return decimal_seconds(value) + "s"
    if isinstance(value, np.generic) and value.dtype.kind != "M":
        value = value.item()
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, _DATES):
        return decimal_seconds(value)
    if isinstance(value, (int, decimal.Decimal, fractions.Fraction)):
        return str(value)
    raise TypeError(f"{value!r} is a {type(value).__name__}; expected a number, a text, a list or a dict")


def text(value: Any) -> str:
    """The text of the value of an option: A,B for a list, A=B:C for a dict."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, Mapping):
        return ",".join(f"{key}={text(part).replace(',', ':')}" for key, part in value.items())
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes)):
        return ",".join(text(part) for part in value)
    return word(value)
