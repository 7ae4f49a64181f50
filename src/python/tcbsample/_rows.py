"""Rows that the program prints, as arrays and frames with the types of the keys."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any, Optional

import numpy as np

from ._program import Error, Run
from ._tables import Table, are_floats, array_of, cells, in_nanoseconds, is_missing, text

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
    return set(re.split("[,:]", ":".join([text(options.get("group") or ""), *names])))


def _as_text(value: Any) -> str:
    return "" if value is None else "-0" if value == 0 and isinstance(value, float) else str(value)


def _kept_column(values: list[Any], original: np.ndarray[Any, Any]) -> Optional[np.ndarray[Any, Any]]:
    """A repeated column with the type of the keys; None for objects of several types."""
    kind = original.dtype.kind
    if kind in "iu":
        return np.array(values, dtype=original.dtype)
    if kind == "f":
        return np.array([float(value or "nan") for value in map(_as_text, values)], original.dtype)
    if kind == "b":
        return np.array([value == "True" for value in values])
    if kind in "US":
        return np.array([_as_text(value) for value in values])
    if kind == "O" and all(isinstance(value, str) or is_missing(value) for value in original):
        empty = "" if any(isinstance(value, str) and not value for value in original) else None
        return np.array([_as_text(value) or empty for value in values], dtype=object)
    return None


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
    if original is not None and is_kept and (column := _kept_column(values, original)) is not None:
        return column
    if kinds == {int} and None not in values:
        largest = max(abs(value) for value in values)
        may_be_whole = original is None or original.dtype.kind != "f"
        if is_kept or (may_be_whole and _LARGEST_WHOLE < largest < 2**63):
            return np.array(values, dtype=np.int64)
    if kinds <= {int, float}:
        return np.array(values, dtype=np.float64)  # None is NaN
    return np.array([_as_text(value) for value in values])


# Frames.


def _frame_column(column: np.ndarray[Any, Any], kind: Any, is_kept: bool) -> Any:
    """A column with the pandas type of the keys."""
    import pandas

    name = str(kind)
    if isinstance(kind, pandas.CategoricalDtype) and is_kept:
        known = dict(zip(cells(array_of(kind.categories)), kind.categories))
        return pandas.Categorical([known.get(cell) for cell in cells(column)], dtype=kind)
    if getattr(kind, "tz", None) is not None and column.dtype.kind == "M":
        return pandas.DatetimeIndex(column).tz_localize("UTC").tz_convert(kind.tz)
    if isinstance(kind, pandas.api.extensions.ExtensionDtype) and name in _NULLABLE:
        if is_kept:
            values = [None if is_missing(v) or (name != "string" and v == "") else v for v in column.tolist()]
            if name == "boolean":
                values = [None if value is None else _as_text(value) == "True" for value in values]
            elif name != "string":
                values = [None if value is None else float(value) for value in values]
            return pandas.array(values, dtype=kind)
        if column.dtype.kind == "f":
            return pandas.array(column, dtype="Float64")
    return column


_NULLABLE = {"boolean", "string", "Float32", "Float64", *(f"{sign}Int{bits}" for sign in ("", "U") for bits in (8, 16, 32, 64))}


def _frame(names: list[str], columns: list[np.ndarray[Any, Any]], table: Table, kept: set[str]) -> Any:
    import pandas

    labels: list[Any] = []
    data: list[Any] = []
    for name, column in zip(names, columns):
        at = table.original(name)
        labels.append(name if at is None else table.labels[at])
        data.append(column if at is None else _frame_column(column, table.types[at], name in kept))
    frame = pandas.DataFrame(dict(enumerate(data)))
    frame.columns = pandas.Index(labels) if labels else frame.columns
    if table.time_index is not None and table.labels[0] in labels:
        frame = frame.set_index(table.labels[0])
        frame.index.name = table.time_index[0]
    return frame


def _returned(names: list[str], columns: list[np.ndarray[Any, Any]], table: Optional[Table], kept: set[str]) -> Any:
    if table is not None and table.frame is not None:
        return _frame(names, columns, table, kept)
    result = np.empty(len(columns[0]) if columns else 0, dtype=[(n, c.dtype) for n, c in zip(names, columns)])
    for name, column in zip(names, columns):
        result[name] = column
    return result


def _lines_to_rows(rows: list[Optional[dict[str, Any]]], table: Optional[Table], options: Mapping[str, Any]) -> Any:
    """Rows of JSON Lines, where null is between curves that no column distinguishes."""
    curves = np.cumsum([row is None for row in rows], dtype=np.int64)[[row is not None for row in rows]]
    breaks = "break" in (options.get("missing"), options.get("duplicates")) or None in rows
    dicts = [row for row in rows if row is not None]
    names = list(dicts[0]) if dicts else []
    sent = {} if table is None else dict(zip(table.names or names, table.columns))
    kept = _kept_names(options)
    columns = [_column([row[name] for row in dicts], sent.get(name), name in kept) for name in names]
    if breaks:
        if "curve" in names:
            raise ValueError("there is a column curve, whose name the number of the curve needs; rename it")
        names, columns = ["curve", *names], [curves, *columns]
    return _returned(names, columns, table, kept)


def _array_to_rows(array: np.ndarray[Any, Any], names: list[str], table: Optional[Table], kept: set[str]) -> Any:
    if table is not None and any(column.dtype.kind == "m" for column in table.columns):
        sent = dict(zip(table.names or names, table.columns))
        columns = [durations_of(column) if name in sent and sent[name].dtype.kind == "m" else column
                   for name, column in zip(names, array.T)]  # fmt: skip
        return _returned(names, columns, table, kept)
    if table is not None and table.frame is not None:
        return _frame(names, list(array.T), table, kept)
    return array.view([(name, array.dtype) for name in names]).reshape(-1)


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
        if _are_doubles(first, run.table) and "break" not in (options.get("missing"), options.get("duplicates")):
            try:
                array = np.load(run.result(["--output-format=npy"]), allow_pickle=False)
                return _array_to_rows(array, list(first[0] or ()), run.table, _kept_names(options))
            except Error:
                pass  # rows that only text can hold, or an error that reading the text shows
        lines = run.result(["--output-format=jsonl"]).read()
    return _lines_to_rows(_parsed(lines), run.table, options)
