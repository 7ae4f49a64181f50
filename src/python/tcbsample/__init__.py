"""Kochanek-Bartels (TCB) curves through keyframes: samples, fits, comparisons and pictures.

Keys have a time, a position of one or more channels, and optionally tension, continuity and bias. This module runs the
program tcbsample, which its wheel contains.

    resample(keys, step=0.1)     samples of the curve through keys
    fit(samples, 0.01)           few keys whose curve is within 0.01 of all samples
    check(keys, samples)         compares samples that another program made with the curve
    identify(keys, samples)      finds the rules by which another program made samples
    plot(keys)                   a picture, which a Jupyter cell shows
    explain(keys, step=0.1)      what was detected in the keys and would be done
    presets()                    the rules of other products, for preset=

Keys and samples may be

    a 2-D array           a row for each key; the first column is the time, the others are channels
    a structured array    a field for each column, as in numpy.array([(0, 1.5)], dtype=[("t", float), ("x", float)])
    a dict of columns     as in {"t": [0, 1], "x": [1.5, 2.5]}
    a pandas DataFrame    an index with a name is a column too; the result is then a DataFrame
    a path                a str or os.PathLike: a file in any format that the program reads
    bytes                 the contents of such a file

For example, this is a frame of the positions and speeds at 24 frames per second, for each value of the column id:

    resample(frame, fps=24, group="id", fields=["time", "position", "speed"])

Names of columns have a meaning: t, time, frame and the like are times; tension, continuity, bias, ease_in and ease_out
are parameters of keys; every other column of numbers is a channel. columns= gives other columns these roles. NaN and
None are missing cells, for which missing= says what happens. Columns of datetime64 are times in UTC.

Options are those of the command line, with _ for -, as Options lists them; --from is from_. Values are numbers, texts,
dates, timedeltas, True for a flag, lists for values with commas, and dicts for values such as A=B:C. None and False
leave an option out.

A rejected input or a wrong option raises Error, whose members say where and what to do. Notes of the program are
warnings of the class Note.
"""

from __future__ import annotations

import base64
import contextlib
import csv
import datetime
import decimal
import difflib
import fractions
import importlib.metadata
import io
import json
import logging
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import warnings
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, IO, Any, Callable, NamedTuple, Optional, Union

import numpy as np

from ._command_only import COMMAND_ONLY
from ._options import OPTIONS, PRESETS, VERSION, Options, PlotOptions, SamplingOptions, Value

if TYPE_CHECKING:
    import pandas
    from typing_extensions import Unpack

    Keys = Union[np.ndarray, Mapping[str, Any], pandas.DataFrame, str, os.PathLike, bytes]
    Rows = Union[np.ndarray, pandas.DataFrame]

__all__ = ["resample", "fit", "check", "identify", "plot", "explain", "presets", "program", "Options", "Report",
           "Picture", "Preset", "Error", "Note"]  # fmt: skip
__version__ = VERSION


class Note(UserWarning):
    """A note or a warning of the program, such as a column that it ignored."""


class Error(ValueError):
    """The program rejected keys, samples or options.

    message    what is wrong, what was expected, and the remedy
    remedy     what to do, the last part of the message
    file       the file; "keys" or "samples" for what was not a file; None for an option
    line       its line, from 1; None for an array and where the fault is in no line
    column     its column in characters, from 1, or None, as for line
    row        the row of an array, from 0, or None
    exit_code  1: the data was rejected; 2: wrong usage, or a file that cannot be read
    others     what else is wrong with the same input, as Errors

    >>> try:
    ...     resample({"t": [0, 1, 1], "x": [0, 1, 2]}, count=3)
    ... except Error as error:
    ...     print(error.file, error.row)
    ...     print(error.remedy)
    keys 2
    remove one of the keys, or give --duplicates first, last or break
    """

    def __init__(self, message: str, exit_code: int = 2, file: Optional[str] = None, line: Optional[int] = None,
                 column: Optional[int] = None, row: Optional[int] = None) -> None:  # fmt: skip
        place = file or ""
        place += f", row {row}" if row is not None else "".join(f":{n}" for n in (line, column) if n is not None)
        super().__init__(f"{place}: {message}" if place else message)
        self.message, self.exit_code, self.file, self.line, self.column, self.row = (
            message, exit_code, file, line, column, row)  # fmt: skip
        self.remedy = message.rpartition("; ")[2]
        self.others: list[Error] = []


class Preset(NamedTuple):
    """The rules of a product, and which product it is."""

    tangents: str
    ends: str
    product: str


class Report:
    """The result of check() or identify(). It is true if the samples agree with the curve.

    data   the report of the program as a dict: counts, the first and the largest difference, the columns; or the
           ranking. report[name] is report.data[name].
    """

    def __init__(self, data: dict[str, Any], agrees: bool) -> None:
        self.data, self._agrees = data, agrees

    def __bool__(self) -> bool:
        return self._agrees

    def __getitem__(self, name: str) -> Any:
        return self.data[name]

    def __repr__(self) -> str:
        return f"<Report: {'agrees' if self else 'differs'}\n{json.dumps(self.data, indent=1)}>"


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

    def save(self, path: Union[str, os.PathLike]) -> None:
        """Writes the picture to a file."""
        pathlib.Path(path).write_bytes(self.svg.encode())


_ROOM_OF_LINES = 1 << 16  # bytes of JSON Lines; longer results are arrays
_LARGEST_WHOLE = 2**53  # up to here, every whole number is a double


# The inputs.


class _Table(NamedTuple):
    """Columns in memory. `names` is None for a 2-D array."""

    names: Optional[list[str]]
    columns: list[np.ndarray]
    is_frame: bool = False


def _is_frame(keys: Any) -> bool:
    return type(keys).__module__.partition(".")[0] == "pandas" and hasattr(keys, "iloc") and hasattr(keys, "columns")


def _frame_table(frame: Any) -> _Table:
    if frame.index.name is not None or frame.index.nlevels > 1:
        frame = frame.reset_index()
    elif frame.index.dtype.kind in "Mmf":
        raise TypeError("the index has no name, so it is unclear what it means; frame.rename_axis('time') makes it a "
                        "column of times, frame.reset_index(drop=True) leaves it out")  # fmt: skip
    columns = [frame.iloc[:, i] for i in range(frame.shape[1])]
    arrays = [c.to_numpy("datetime64[ns]") if getattr(c.dtype, "tz", None) else c.to_numpy() for c in columns]
    return _Table([str(name) for name in frame.columns], arrays, True)


def _table(keys: Any) -> _Table:
    """Raises TypeError, ValueError for what is not a table."""
    if _is_frame(keys):
        return _frame_table(keys)
    if isinstance(keys, Mapping):
        table = _Table([str(name) for name in keys], [np.asarray(column) for column in keys.values()])
    else:
        array = np.asarray(keys)
        if array.dtype.names:
            table = _Table(list(array.dtype.names), [array[name] for name in array.dtype.names])
        elif array.ndim == 2:
            return _Table(None, list(array.T))
        else:
            raise TypeError(f"an array of {array.ndim} dimensions; expected a 2-D or structured array, a dict of "
                            "columns, a DataFrame, a path, or bytes")  # fmt: skip
    lengths = {name: column.shape for name, column in zip(table.names or (), table.columns)}
    if any(len(shape) != 1 for shape in lengths.values()) or len(set(lengths.values())) > 1:
        raise ValueError(f"shapes of columns: {lengths}; expected 1-D columns of one length, one for each channel")
    return table


def _quoted(text: str) -> str:
    """A cell of CSV."""
    return '"' + text.replace('"', '""') + '"' if re.search(r'[",\r\n#]|^\s|\s$', text) else text


def _cell(value: Any) -> str:
    is_missing = value is None or type(value).__name__ in ("NAType", "NaTType") or value != value  # NaN
    return "" if is_missing else _quoted(_word(value))


def _are_floats(column: np.ndarray) -> bool:
    return column.dtype.kind == "f" and column.dtype.itemsize <= 8


def _cells(column: np.ndarray) -> list[str]:
    """The texts of a column: every number with all its digits."""
    kind = column.dtype.kind
    if _are_floats(column):
        column = column.astype(np.float64)
    if _are_floats(column) or kind in "iu":
        return [repr(number) for number in column.tolist()]
    if kind == "M":
        times = column if np.datetime_data(column.dtype)[0] in ("ms", "us", "ns") else column.astype("M8[s]")
        texts = np.datetime_as_string(times, timezone="UTC").tolist()
        return ["" if text == "NaT" else text for text in texts]
    if kind in "OUSbf":
        return [_cell(value) for value in column.tolist()]
    raise TypeError(f"a column of {column.dtype}; expected numbers, texts or datetime64; "
                    "convert durations with column / numpy.timedelta64(1, 's')")  # fmt: skip


def _encode(table: _Table) -> tuple[list[str], bytes, int]:
    """Words of the command line, the bytes to send, and the number of lines before the first row.

    Text with all digits of each number, as the program does not read arrays.
    """
    if table.columns and all(_are_floats(column) for column in table.columns):
        numbers = np.column_stack(table.columns).astype(np.float64)
        form = ",".join(["%r"] * len(table.columns)) + "\n"  # many rows at once are quicker than row by row
        parts = (numbers[i : i + 10000] for i in range(0, len(numbers), 10000))
        lines = "".join(form * len(part) % tuple(part.ravel().tolist()) for part in parts)
    else:
        lines = "".join(",".join(row) + "\n" for row in zip(*map(_cells, table.columns)))
    words = ["--input-format=csv", "--comment=none"]
    if table.names is None:
        return [*words, "--no-header"], lines.encode(), 0
    head = ",".join(_quoted(name) for name in table.names)
    return [*words, "--header"], f"{head}\n{lines}".encode(), 1


_TEXT_OPTIONS = ["input_format", "delimiter", "header", "no_header", "comment", "decimal", "date_order"]


# The options.


def _decimal_seconds(nanoseconds: Any) -> str:
    return f"{decimal.Decimal(int(nanoseconds.astype(np.int64))).scaleb(-9):f}"


def _word(value: Any) -> str:
    """The text of a single value."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, (datetime.timedelta, np.timedelta64)):
        return _decimal_seconds(np.timedelta64(value, "ns")) + "s"
    if isinstance(value, np.generic) and value.dtype.kind != "M":
        value = value.item()
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, datetime.datetime) and value.tzinfo is not None:
        value = value.astimezone(datetime.timezone.utc).replace(tzinfo=None)
    if isinstance(value, (datetime.date, np.datetime64)):  # seconds since 1970, as the program counts dates
        return _decimal_seconds(np.datetime64(value, "ns"))
    if isinstance(value, (int, decimal.Decimal, fractions.Fraction)):
        return str(value)
    raise TypeError(f"{value!r} is a {type(value).__name__}; expected a number, a text, a list or a dict")


def _text(value: Any) -> str:
    """The text of the value of an option: A,B for a list, A=B:C for a dict."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, Mapping):
        return ",".join(f"{key}={_text(part).replace(',', ':')}" for key, part in value.items())
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes)):
        return ",".join(_text(part) for part in value)
    return _word(value)


def _is_table(value: Any) -> bool:
    return not isinstance(value, (str, os.PathLike, bytes))


def _is_long(value: Any) -> bool:
    return not isinstance(value, (str, bytes, Mapping)) and np.size(value) > 100


class _Source(NamedTuple):
    """An input that was not a file: its name in errors, and for a table the CSV of its rows after `head` records."""

    name: str
    table: Optional[bytes] = None
    head: int = 0

    def row(self, line: Optional[int]) -> Optional[int]:
        """The row of a line of the CSV, where texts in quotes may have several lines."""
        if line is None or self.table is None:
            return None
        records = csv.reader(io.StringIO(self.table.decode(), newline=""))
        return next((i - self.head for i, _ in enumerate(records) if records.line_num >= line), None)


@contextlib.contextmanager
def _ended(process: subprocess.Popen) -> Iterator[subprocess.Popen]:
    """The process, which has ended when the block ends."""
    try:
        yield process
    finally:
        if process.poll() is None:
            process.kill()
        if process.stdout is not None:
            process.stdout.close()
        process.wait()


def _warn(note: str) -> None:
    frame, level = sys._getframe(1), 2  # the caller of this module is to blame
    while frame.f_code.co_filename == __file__ and frame.f_back is not None:
        frame, level = frame.f_back, level + 1
    warnings.warn(note, Note, stacklevel=level)


class _Run:
    """A run of the program: its words, its input, and the files made for it, until it is closed."""

    def __init__(self, keys: Any, name: str = "keys", notes: Callable[[str], None] = _warn) -> None:
        self.notes = notes
        self.table = _table(keys) if _is_table(keys) else None
        words, data, head = ([], b"", 0) if self.table is None else _encode(self.table)
        self.resources = contextlib.ExitStack()
        self.folder: Optional[str] = None  # of files made for options
        self.input = self._temporary()
        self.sources: dict[str, _Source] = {}
        self.words = words
        self.files: list[str] = []
        if isinstance(keys, bytes):
            self.input.write(keys)
            self.sources["standard input"] = _Source(name)
        elif self.table is None:
            self.files = ["--", os.fspath(keys)]
        else:
            self.input.write(data)
            self.sources["standard input"] = _Source(name, data, head)

    def __enter__(self) -> _Run:
        return self

    def __exit__(self, *_: object) -> None:
        self.resources.close()

    def _temporary(self) -> IO[bytes]:
        return self.resources.enter_context(tempfile.TemporaryFile())

    def _add(self, name: str, value: Any, allowed: Iterable[str] = ()) -> None:
        """Adds an option. Raises TypeError."""
        known = name.rstrip("_")
        if known not in OPTIONS:
            near = "".join(f"; did you mean {other}?" for other in difflib.get_close_matches(known, OPTIONS, 1))
            raise TypeError(f"unknown option {name!r}{near}; help(tcbsample.Options) lists all")
        if known in COMMAND_ONLY and known not in allowed:
            raise TypeError(f"{name}: not an option of this function; {COMMAND_ONLY[known]}")
        if isinstance(value, np.bool_):
            value = bool(value)
        if value is None or value is False:
            return
        if self.table is not None and known in _TEXT_OPTIONS:
            raise TypeError(f"{name}: describes text, and the keys are a table; leave it out")
        option = OPTIONS[known]
        if option.kind == "flag" and value is not True:
            raise TypeError(f"{name}: {value!r}; expected True or False")
        if option.kind == "flag" or (option.kind == "attached" and value is True):
            self.words.append(option.name)
        elif option.kind == "file" and (_is_table(value) or isinstance(value, bytes)):
            self.words.append(f"{option.name}={self._file(value)}")
        elif option.kind == "places" and _is_long(value):
            self.words.append(f"{option.name}=@{self._write('numbers', _text(value).replace(',', chr(10)).encode())}")
        else:
            self.words.append(f"{option.name}={_text(value)}")

    def add(self, options: Mapping[str, Any], allowed: Iterable[str] = ()) -> _Run:
        """Adds options; those of the command line alone are allowed here. Raises TypeError for unknown options, others
        of the command line alone, and values without a text."""
        try:
            for name, value in options.items():
                self._add(name, value, allowed)
        except BaseException:
            self.resources.close()
            raise
        return self

    def _write(self, name: str, data: bytes) -> str:
        if self.folder is None:
            self.folder = self.resources.enter_context(tempfile.TemporaryDirectory(prefix="tcbsample"))
        path = pathlib.Path(self.folder, f"{name}{len(os.listdir(self.folder))}")
        path.write_bytes(data)
        return str(path)

    def _file(self, samples: Any) -> str:
        """A file with samples that were not a file."""
        if isinstance(samples, bytes):
            source, data = _Source("samples"), samples
        else:
            _, data, head = _encode(_table(samples))
            source = _Source("samples", data, head)
        path = self._write("samples", data)
        self.sources[path] = source
        return path

    def _start(self, words: Iterable[str], **streams: Any) -> subprocess.Popen:
        self.input.seek(0)
        command = [program(), *self.words, *words, *self.files]
        flags = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # on Windows
        return subprocess.Popen(command, stdin=self.input, creationflags=flags, **streams)

    def result(self, words: Iterable[str], accepts_difference: bool = False) -> IO[bytes]:
        """The output as a file. Raises Error."""
        output, errors = self._temporary(), self._temporary()
        with _ended(self._start(words, stdout=output, stderr=errors)) as process:
            process.wait()
        # Exit code 1 is that of rejected data, which has no output, and of a report of differences.
        self._check(process, errors, accepts_difference and os.fstat(output.fileno()).st_size > 0)
        output.seek(0)
        return output

    def beginning(self, words: Iterable[str], size: int) -> tuple[bytes, bool]:
        """The first bytes of the output, and whether these are all. Raises Error."""
        errors = self._temporary()
        with _ended(self._start(words, stdout=subprocess.PIPE, stderr=errors)) as process:
            assert process.stdout is not None
            text = process.stdout.read(size)
            if len(text) == size:
                return text, False
            process.wait()
        self._check(process, errors)
        return text, True

    def _check(self, process: subprocess.Popen, errors: IO[bytes], accepts_difference: bool = False) -> None:
        """Raises Error by the exit code."""
        errors.seek(0)
        text = errors.read().decode(errors="replace")
        if process.returncode not in ((0, 1) if accepts_difference else (0,)):
            raise self.error(text, process.returncode)
        for line in text.splitlines():
            for path, source in self.sources.items():
                line = line.replace(path, source.name)
            self.notes(line)

    def error(self, text: str, exit_code: int) -> Error:
        """The errors of the program, FILE:LINE:COLUMN: error: MESSAGE each."""
        form = r"^(?P<file>.*?)(?::(?P<line>\d+))?(?::(?P<column>\d+))?: error: (?P<message>.*)$"
        found = [self._one_error(match, exit_code) for match in re.finditer(form, text, re.MULTILINE)]
        if not found:
            return Error(text.strip() or f"the program ended with exit code {exit_code}", exit_code)
        found[0].others = found[1:]
        return found[0]

    def _one_error(self, match: re.Match, exit_code: int) -> Error:
        file, message = match["file"], match["message"]
        line, column = (int(match[name]) if match[name] else None for name in ("line", "column"))
        for path, other in self.sources.items():
            message = message.replace(path, other.name)
        source = self.sources.get(file)
        if source is None:
            return Error(message, exit_code, None if file == "tcbsample" else file, line, column)
        if source.table is None:
            return Error(message, exit_code, source.name, line, column)
        return Error(message, exit_code, source.name, row=source.row(line))


def program() -> str:
    """The path of the program, which the wheel installs as the command tcbsample. Raises FileNotFoundError."""
    global _program
    if _program is None:
        names = ("tcbsample", "tcbsample.exe")
        package = pathlib.Path(__file__).parent
        folders = [package, pathlib.Path(sysconfig.get_path("scripts")), package.parent / "bin"]
        try:
            recorded = [f.locate() for f in importlib.metadata.files("tcbsample") or () if f.name in names]
        except importlib.metadata.PackageNotFoundError:
            recorded = []
        paths = [pathlib.Path(path) for path in recorded] + [folder / name for folder in folders for name in names]
        found = next((path for path in paths if path.is_file()), None)
        if found is None:
            raise FileNotFoundError("the program tcbsample is not installed; install the wheel again")
        _program = str(found.resolve())
    return _program


_program: Optional[str] = None


# The rows.


def _are_doubles(rows: list[Optional[dict]], table: Optional[_Table]) -> bool:
    """Whether an array of doubles can hold the rows."""
    from_doubles = table is not None and all(_are_floats(column) for column in table.columns)

    def is_double(value: Any) -> bool:
        return isinstance(value, float) or (isinstance(value, int) and (from_doubles or abs(value) <= _LARGEST_WHOLE))

    return all(row is not None and all(v is None or is_double(v) for v in row.values()) for row in rows)


def _kept_names(options: Mapping[str, Any]) -> set[str]:
    """The columns whose values are repeated, and not computed."""
    roles = [part.partition("=")[::2] for part in _text(options.get("columns") or "").split(",")]
    names = [names for role, names in roles if role in ("group", "carry")]
    return set(re.split("[,:]", ":".join([_text(options.get("group") or ""), *names])))


def _as_text(value: Any) -> str:
    return "" if value is None else "-0" if value == 0 and isinstance(value, float) else str(value)


def _kept_column(values: list, original: np.ndarray) -> Optional[np.ndarray]:
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
    if kind == "O" and all(isinstance(value, str) or _cell(value) == "" for value in original):
        empty = "" if any(isinstance(value, str) and not value for value in original) else None
        return np.array([_as_text(value) or empty for value in values], dtype=object)
    return None


def _column(values: list, original: Optional[np.ndarray], is_kept: bool) -> np.ndarray:
    """A column of JSON: doubles, unless it is kept, has texts, or has times beyond 2^53."""
    kinds = {type(value) for value in values if value is not None}
    if original is not None and kinds == {str} and original.dtype.kind == "M":
        return np.array([value and value.rstrip("Z") for value in values], dtype="datetime64[ns]")
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


def _returned(names: list[str], columns: list[np.ndarray], table: Optional[_Table]) -> Any:
    if table is not None and table.is_frame:
        import pandas

        return pandas.DataFrame(dict(zip(names, columns)))
    result = np.empty(len(columns[0]) if columns else 0, dtype=[(n, c.dtype) for n, c in zip(names, columns)])
    for name, column in zip(names, columns):
        result[name] = column
    return result


def _lines_to_rows(rows: list[Optional[dict]], run: _Run, options: Mapping[str, Any]) -> Any:
    """Rows of JSON Lines, where null is between curves that no column distinguishes."""
    curves = np.cumsum([row is None for row in rows], dtype=np.int64)[[row is not None for row in rows]]
    breaks = "break" in (options.get("missing"), options.get("duplicates")) or None in rows
    dicts = [row for row in rows if row is not None]
    names = list(dicts[0]) if dicts else []
    sent = {} if run.table is None else dict(zip(run.table.names or names, run.table.columns))
    kept = _kept_names(options)
    columns = [_column([row[name] for row in dicts], sent.get(name), name in kept) for name in names]
    if breaks:
        if "curve" in names:
            raise ValueError("there is a column curve, whose name the number of the curve needs; rename it")
        names, columns = ["curve", *names], [curves, *columns]
    return _returned(names, columns, run.table)


def _array_to_rows(table: np.ndarray, names: list[str], run: _Run) -> Any:
    if run.table is not None and run.table.is_frame:
        import pandas

        return pandas.DataFrame(table, columns=names)
    return table.view([(name, table.dtype) for name in names]).reshape(-1)


def _parsed(text: bytes) -> list[Optional[dict]]:
    """Rows of JSON Lines, whose texts have no line ends."""
    rows = b"[" + text.rstrip().replace(b"\n", b",") + b"]"
    if not re.search(rb":-0[,}]", rows):
        return json.loads(rows)
    return json.loads(rows, parse_int=lambda digits: -0.0 if digits == "-0" else int(digits))


def _rows(run: _Run, options: Mapping[str, Any]) -> Any:
    """Few rows, and rows with texts, are read as JSON Lines, and others as an array."""
    text, complete = run.beginning(["--output-format=jsonl"], _ROOM_OF_LINES)
    if not complete:
        lines = _parsed(text[: text.rfind(b"\n")])
        if _are_doubles(lines, run.table) and "break" not in (options.get("missing"), options.get("duplicates")):
            try:
                table = np.load(run.result(["--output-format=npy"]), allow_pickle=False)
                return _array_to_rows(table, list(lines[0] or ()), run)
            except Error:
                pass  # rows that only text can hold, or an error that reading the text shows
        text = run.result(["--output-format=jsonl"]).read()
    return _lines_to_rows(_parsed(text), run, options)


# The functions.


# The input is positional, as keys= is the option --keys.


def resample(keys: Keys, /, *, step: Value = None, count: Optional[int] = None, arc_step: Value = None,
             at: Value = None, tolerance: Value = None, preset: Optional[str] = None,
             **options: Unpack[Options]) -> Rows:  # fmt: skip
    """Samples of the curve through keys.

    keys       n keys with their columns; see the description of the module
    step       every step of time, from the first key; the text or Fraction 1/24 is exact
    count      this many samples at equal times, both ends included
    arc_step   every arc_step of length along the curve
    at         an array of m times, in any order
    tolerance  few samples whose polyline is within this distance of the curve
    preset     the rules of a product; see presets()
    options    further options of the command line; see Options. One of step, count, arc_step, at, tolerance or another
               option of sampling, such as fps, is needed.

    Times are in the unit of the keys' times, lengths and tolerances in that of the positions.

    Returns a structured array of shape (m,), or a DataFrame of m rows if keys are one. Its fields are the groups, the
    time, the channels, and labels, or what fields= chooses: float64, where undefined values are NaN; whole times from
    2^53 up are int64; times of a datetime64 column are datetime64[ns]; groups and labels have the type that they have
    in keys.
    With missing="break" or duplicates="break", a first field "curve" counts curves from 0.

    Raises Error if keys or options are rejected, and TypeError for what is no option or no table.

    >>> rows = resample({"t": [0, 1, 2], "x": [0, 2, 0], "y": [0, 0, 4]}, step="1/2")
    >>> rows.dtype.names
    ('t', 'x', 'y')
    >>> rows["x"].tolist()
    [0.0, 1.125, 2.0, 1.125, 0.0]
    >>> resample([[0, 0], [1, 2], [2, 0]], at=[0.5], fields=["position", "velocity"]).tolist()
    [(1.125, 2.75)]
    """
    given = dict(options, step=step, count=count, arc_step=arc_step, at=at, tolerance=tolerance, preset=preset)
    with _Run(keys).add(given) as run:
        return _rows(run, given)


def fit(samples: Keys, /, tolerance: Value, **options: Unpack[Options]) -> Rows:
    """Few keys whose curve is within a tolerance of all samples.

    samples    n samples, as keys in the description of the module, without tension, continuity and bias
    tolerance  the largest distance of the curve from a sample, in the unit of the positions; a dict has limits of
               channels, as in {"x": 0.01}
    options    fit_keys ("tcb" or "hermite"), keep_times, corner, metric, group, ...; see Options

    Returns the keys as resample() returns rows, with columns tension_x, bias_x, ... of the channels; resample() takes
    them. The logger "tcbsample" gets a message with their number, the largest distance, and a proved lower bound.

    Raises Error and TypeError as resample().

    >>> samples = resample([[0, 0], [1, 2], [3, 1]], count=100)
    >>> keys = fit(samples, 1e-3)
    >>> len(keys) < 10
    True
    >>> again = resample(keys, at=samples["t"])
    >>> bool(abs(again["x"] - samples["x"]).max() <= 1.001e-3)
    True
    """
    log = logging.getLogger("tcbsample").info
    with _Run(samples, "samples", log).add(dict(options, fit=tolerance), ["fit"]) as run:
        return _rows(run, options)


def _compare(option: str, keys: Any, samples: Any, options: Mapping[str, Any], agrees: str) -> Report:
    with _Run(keys).add({**options, option: samples}, [option]) as run:
        data = json.load(run.result(["--output-format=json"], accepts_difference=True))
        for name in ("file", "keys"):
            source = run.sources.get("standard input" if data[name] == "-" else data[name])
            data[name] = source.name if source else data[name]
        return Report(data, data[agrees])


def check(keys: Keys, samples: Keys, /, *, abs: Value = None, rel: Value = None, ulp: Value = None,
          **options: Unpack[SamplingOptions]) -> Report:  # fmt: skip
    """Compares samples that any program made with the curve through keys.

    keys      n keys; see the description of the module
    samples   m samples, like keys; their times, or their arc lengths in a column s, say where they are on the curve
    abs       the largest accepted difference of two numbers; a dict has limits of columns
    rel       the same as a fraction of the number on the curve
    ulp       the same in units in the last place; 0 if none of the three is given
    options   preset, map, ...; see Options. With a sampling option such as step, a missing or surplus row is a
              difference, too.

    Returns a Report, which is true if no difference is larger than accepted. Raises Error and TypeError as resample().

    >>> keys = [[0, 0], [1, 2], [2, 0]]
    >>> bool(check(keys, {"t": [0.5, 1], "x": [1.125, 2]}))
    True
    >>> report = check(keys, {"t": [0.5, 1], "x": [1, 2]}, abs=0.1)
    >>> bool(report), report["worst"]["row"], report["worst"]["abs"]
    (False, 1, 0.125)
    """
    return _compare("check", keys, samples, dict(options, abs=abs, rel=rel, ulp=ulp), "passed")


def identify(keys: Keys, samples: Keys, /, **options: Unpack[SamplingOptions]) -> Report:
    """Finds the rules by which another program made samples of the curve through keys.

    keys, samples, options   as in check()

    Returns a Report, which is true if some rules reproduce the samples; ["ranking"] is a list of dicts with tangents,
    ends, presets and the largest difference, best first. Raises Error and TypeError as resample().

    >>> keys = [[0, 0], [1, 2], [3, 0], [4, 1]]
    >>> theirs = resample(keys, step=0.25, preset="vtk")
    >>> report = identify(keys, theirs)
    >>> bool(report), "vtk" in report["ranking"][0]["presets"]
    (True, True)
    """
    return _compare("identify", keys, samples, options, "fits")


def plot(keys: Keys, /, **options: Unpack[PlotOptions]) -> Picture:
    """A picture of the curve through keys: its path, and each channel over time, with keys and samples.

    keys      n keys; see the description of the module
    options   those of resample(), and axes, title, size; without a sampling option, it shows 51 samples.
              check=samples and identify=samples show other samples and their differences, fit=tolerance a fit.

    Returns a Picture, which a Jupyter cell shows. Raises Error and TypeError as resample().

    >>> picture = plot([[0, 0, 1], [1, 2, 3], [2, 0, 2]], title="Three keys")
    >>> picture.svg[:4], "Three keys" in picture.svg
    ('<svg', True)
    """
    compares = any(options.get(name) is not None for name in ("check", "identify", "fit"))
    with _Run(keys).add(options, ["check", "identify", "fit"]) as run:
        words = ["--output-format=svg"] if compares else ["--plot"]
        return Picture(run.result(words, accepts_difference=compares).read().decode())


def explain(keys: Keys, /, **options: Unpack[SamplingOptions]) -> str:
    """What was detected in keys, and with a sampling option what resample() would do, as a text of lines NAME: VALUE.

    keys, options   as in resample(); no sampling option is needed

    Raises Error and TypeError as resample().

    >>> print(explain([[0, 0], [1, 2], [2, 0]], step=0.5).splitlines()[-2])
    rows: 5
    """
    with _Run(keys).add(options) as run:
        return run.result(["--explain"]).read().decode()


def presets() -> dict[str, Preset]:
    """The presets: the name of each, its tangent rule, its end rule, and its product.

    >>> presets()["gte"].tangents
    'velocity'
    """
    return {name: Preset(*rules) for name, rules in PRESETS.items()}
