"""Rows that the program prints, as arrays and frames with the types of the keys."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any, Optional

import numpy as np

from ._program import Error, Run
from ._tables import Table, are_floats, cells, in_nanoseconds, quoted, text

_ROOM_OF_LINES = 1 << 16  # bytes of JSON Lines; longer results are arrays
_LARGEST_WHOLE = 2**53  # up to here, every whole number is a double


def _are_doubles(rows: list[Optional[dict[str, Any]]], table: Optional[Table]) -> bool:
    """Whether an array of doubles can hold the rows."""
    from_doubles = table is not None and all(are_floats(column) for column in table.columns)

    def is_double(value: Any) -> bool:
        return isinstance(value, float) or (isinstance(value, int) and (from_doubles or abs(value) <= _LARGEST_WHOLE))

    return all(row is not None and all(v is None or is_double(v) for v in row.values()) for row in rows)


def _kept_names(options: Mapping[str, Any]) -> set[str]:
    """The columns whose values are repeated, and not computed."""
    roles = [part.partition("=")[::2] for part in text(options.get("columns") or "").split(",")]
    names = [names for role, names in roles if role in ("group", "carry")]
    return {*re.split("[,:]", ":".join([text(options.get("group") or ""), *names]))} - {""}


def _breaks(options: Mapping[str, Any]) -> bool:
    """Whether rows count curves, which have no other name."""
    return "break" in (options.get("missing"), options.get("duplicates"))


def _kept_column(values: list[Any], table: Table, at: int) -> Any:
    """The values of the keys that a column repeats, with their type; None if it has others."""
    rows = {cell: row for row, cell in enumerate(cells(table.columns[at]))}
    row_of = {value: rows.get(quoted(str(value))) for value in set(values)}
    if None in row_of:  # a missing value
        row_of[None] = rows.get("")
    if None in row_of.values():
        return None
    places = np.array([row_of[value] for value in values], dtype=np.intp)
    original = table.originals[at]
    return original[places] if table.frame is None else original.take(places).array


def dates_of(texts: Iterable[Optional[str]]) -> np.ndarray[Any, Any]:
    return in_nanoseconds(np.array([text and text.rstrip("Z") for text in texts], dtype="datetime64"))


def durations_of(seconds: Any) -> np.ndarray[Any, Any]:
    numbers = np.asarray([np.nan if value is None else value for value in seconds], dtype=np.float64)
    whole = np.floor(numbers)
    with np.errstate(invalid="ignore"):
        counts = whole * 1e9 + np.round((numbers - whole) * 1e9)
        return np.where(np.isnan(numbers), np.timedelta64("NaT", "ns"), counts.astype("m8[ns]"))


def _column(values: list[Any], original: Optional[np.ndarray[Any, Any]], is_kept: bool) -> np.ndarray[Any, Any]:
    """A column of JSON: doubles, unless it is kept, has texts, dates or durations, or times beyond 2^53."""
    kinds = {type(value) for value in values if value is not None}
    if original is not None and kinds == {str} and original.dtype.kind == "M":
        return dates_of(values)
    if original is not None and original.dtype.kind == "m" and kinds <= {int, float}:
        return durations_of(values)
    if kinds == {int} and None not in values:
        largest = max(abs(value) for value in values)
        may_be_whole = original is None or original.dtype.kind != "f"
        if is_kept or (may_be_whole and _LARGEST_WHOLE < largest < 2**63):
            return np.array(values, dtype=np.int64)
    if kinds <= {int, float}:
        return np.array(values, dtype=np.float64)  # None is NaN
    return np.array(["" if value is None else str(value) for value in values])


# Frames.


def _frame_column(column: np.ndarray[Any, Any], kind: Any) -> Any:
    """A computed column with the pandas type of the keys."""
    import pandas

    if getattr(kind, "tz", None) is not None and column.dtype.kind == "M":
        return pandas.DatetimeIndex(column).tz_localize("UTC").tz_convert(kind.tz)
    if column.dtype.kind == "f" and re.fullmatch(r"U?Int\d+|Float\d+", str(kind)):
        return pandas.array(column, dtype="Float64")
    return column


def _frame(names: list[str], columns: list[Any], table: Table) -> Any:
    import pandas

    labels: list[Any] = []
    data: list[Any] = []
    for name, column in zip(names, columns):
        at = table.original(name)
        labels.append(name if at is None else table.labels[at])
        is_array = isinstance(column, np.ndarray)
        data.append(column if at is None or not is_array else _frame_column(column, table.originals[at].dtype))
    frame = pandas.DataFrame(dict(enumerate(data)))
    frame.columns = pandas.Index(labels) if labels else frame.columns
    if table.time_index is not None and table.labels[0] in labels:
        frame = frame.set_index(table.labels[0])
        frame.index.name = table.time_index[0]
    return frame


def _returned(names: list[str], columns: list[Any], table: Optional[Table]) -> Any:
    if table is not None and table.frame is not None:
        return _frame(names, columns, table)
    result = np.empty(len(columns[0]) if columns else 0, dtype=[(n, c.dtype) for n, c in zip(names, columns)])
    for name, column in zip(names, columns):
        result[name] = column
    return result


def _sent(names: list[str], table: Optional[Table]) -> dict[str, np.ndarray[Any, Any]]:
    """The column of the keys whose type a column of rows with this name has."""
    if table is None:
        return {}
    if table.names is not None:
        return dict(zip(table.names, table.columns))
    time_first = sorted(table.columns, key=lambda column: column.dtype.kind not in "mM")
    return {**dict.fromkeys(names, time_first[-1]), "t": time_first[0]}


def _lines_to_rows(rows: list[Optional[dict[str, Any]]], table: Optional[Table], options: Mapping[str, Any]) -> Any:
    """Rows of JSON Lines, where null is between curves that no column distinguishes."""
    curves = np.cumsum([row is None for row in rows], dtype=np.int64)[[row is not None for row in rows]]
    dicts = [row for row in rows if row is not None]
    names = list(dicts[0]) if dicts else []
    sent = _sent(names, table)
    kept = _kept_names(options)
    columns = []
    for name in names:
        values = [row[name] for row in dicts]
        at = table.original(name) if table is not None and name in kept else None
        column = None if table is None or at is None else _kept_column(values, table, at)
        columns.append(_column(values, sent.get(name), name in kept) if column is None else column)
    if _breaks(options) or None in rows:
        if "curve" in names:
            raise ValueError("there is a column curve, whose name the number of the curve needs; rename it")
        names, columns = ["curve", *names], [curves, *columns]
    return _returned(names, columns, table)


def _array_to_rows(array: np.ndarray[Any, Any], names: list[str], table: Optional[Table]) -> Any:
    durations = {name for name, column in _sent(names, table).items() if column.dtype.kind == "m"}
    if durations.isdisjoint(names) and (table is None or table.frame is None):
        return array.view([(name, array.dtype) for name in names]).reshape(-1)
    columns = [durations_of(column) if name in durations else column for name, column in zip(names, array.T)]
    return _returned(names, columns, table)


def _parsed(lines: bytes) -> list[Optional[dict[str, Any]]]:
    """Rows of JSON Lines, whose texts have no line ends."""
    rows = b"[" + lines.rstrip().replace(b"\n", b",") + b"]"
    if not re.search(rb":-0[,}]", rows):
        return json.loads(rows)  # type: ignore[no-any-return]
    return json.loads(rows, parse_int=lambda digits: -0.0 if digits == "-0" else int(digits))  # type: ignore[no-any-return]


def rows_of(run: Run, options: Mapping[str, Any]) -> Any:
    """Few rows, and rows with texts, are read as JSON Lines, and others as an array. Raises Error."""
    lines, complete = run.beginning(["--output-format=jsonl"], _ROOM_OF_LINES)
    if not complete:
        first = _parsed(lines[: lines.rfind(b"\n")])
        if not _kept_names(options) and not _breaks(options) and _are_doubles(first, run.table):
            try:
                array = np.load(run.result(["--output-format=npy"]), allow_pickle=False)
                return _array_to_rows(array, list(first[0] or ()), run.table)
            except Error:
                pass  # rows that only text can hold, or an error that reading the text shows
        lines = run.result(["--output-format=jsonl"]).read()
    return _lines_to_rows(_parsed(lines), run.table, options)
