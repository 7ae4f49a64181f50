"""Runs of the program: its words, its inputs, its output, and its messages as Python has them."""

from __future__ import annotations

import contextlib
import csv
import difflib
import functools
import importlib.metadata
import io
import logging
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import IO, Any, NamedTuple, Optional

import numpy as np

from ._command_only import COMMAND_ONLY, PRODUCTS
from ._options import OPTIONS, REMOVED
from ._tables import Table, date_text, encode, encode_as_array, is_table, shown, table, text, with_index_as_time


class Note(UserWarning):
    """A note or a warning of the program, such as a column that it ignored."""


class Error(ValueError):
    """The program rejected keys, samples or options.

    message    what is wrong, what was expected, and the remedy
    remedy     what to do, the last part of the message
    file       the file; "keys", "samples" or the keyword for what was not a file; None for other options
    line       its line, from 1; None for keys in memory, and where the fault is in no line
    column     its column in characters, from 1, or None, as for line
    row        the row of keys in memory, from 0; None where the fault is in no row
    exit_code  1: the data was rejected; 2: wrong usage, or a file that cannot be read
    others     what else is wrong with the same input, as Errors

    >>> import tcbsample
    >>> try:
    ...     tcbsample.resample({"t": [0, 1, 1], "x": [0, 1, 2]}, count=3)
    ... except tcbsample.Error as error:
    ...     print(error.file, error.row)
    ...     print(error.remedy)
    keys 2
    remove one of the keys, or give group="NAME" if a column tells curves apart, or duplicates="first", "last" or "break"
    """

    def __init__(self, message: str, exit_code: int = 2, file: Optional[str] = None, line: Optional[int] = None,
                 column: Optional[int] = None, row: Optional[int] = None, place: Optional[str] = None) -> None:  # fmt: skip
        if place is None:
            place = "".join(str(part) for part in [file or "", *(f":{n}" for n in (line, column) if n is not None)])
        super().__init__(f"{place}: {message}" if place else message)
        self.message, self.exit_code, self.file, self.line, self.column, self.row = (
            message, exit_code, file, line, column, row)  # fmt: skip
        self.remedy = re.sub(r" \((at least )?\d+ errors of this kind.*\)$", "", message.rpartition("; ")[2])
        self.others: list[Error] = []


def program() -> str:
    """The path of the program, which the wheel installs as the command tcbsample. Raises FileNotFoundError.

    >>> import tcbsample
    >>> "tcbsample" in tcbsample.program()
    True
    """
    return _program()


@functools.cache
def _program() -> str:
    names = ("tcbsample", "tcbsample.exe")
    package = pathlib.Path(__file__).parent
    paths = [folder / name for folder in (package, package.parent / "bin") for name in names]
    with contextlib.suppress(importlib.metadata.PackageNotFoundError):
        files = importlib.metadata.files("tcbsample") or ()
        paths += [pathlib.Path(str(file.locate())) for file in files if file.name in names]
    for path in paths:
        if path.is_file():
            return str(path.resolve())
    raise FileNotFoundError("the program tcbsample is not installed; install the wheel again")


# Messages.

# A text in quotes, which stays; or an option; what follows it and may be its value, and what then follows a value; and
# the alternatives to the value.
_OPTION = re.compile(r"""
    "[^"]*" |
    --(?P<name>[a-z][a-z-]*[a-z])
    (?P<rest>
        [ =](?P<value>'[^']*'|"[^"]*"|(?!(?:instead|and|or|needs|with)\b|--)(?:[^\s,;]|,(?=\S))*[^\s,;.:])
        (?P<end>(?=[ ](?:if|for|to|leaves|measures|--)|,|$))?
        (?P<others>(?:(?:,?[ ]or|,)[ ]\w[\w-]*)*)
    )?""", re.VERBOSE)  # fmt: skip


def _option_in_python(match: re.Match[str]) -> str:
    keyword = (match["name"] or "").replace("-", "_")
    value, rest = match["value"] or "", match["rest"] or ""
    if keyword in REMOVED:
        return keyword + rest
    option = OPTIONS.get(keyword)
    if option is None:
        return match[0]
    name = option.keyword
    if name in PRODUCTS:
        return PRODUCTS[name] + rest
    if name in COMMAND_ONLY:
        return f"tcbsample {option.name}{rest}"
    if option.kind == "flag":
        return f"{name}=True{rest}"
    if not value or not (match["end"] is not None or value in option.known or re.search(r"[\d=*'\"]", value)):
        return name + rest
    others = re.sub(r"[\w-]+", lambda word: f'"{word[0]}"' if word[0] in option.known else word[0], match["others"])
    return "{}=\"{}\"{}".format(name, value.strip("'\""), others)


def in_python(message: str) -> str:
    """A message with keywords of Python in place of options: missing="skip-row" for --missing skip-row."""
    message = _OPTION.sub(_option_in_python, re.sub(r"\btcbsample (--.*) keys\.csv$", r"\1", message))
    return re.sub(r'(="[^"]*") (?=\w+=["T])', r"\1, ", message)


class HasMessages(Exception):
    """A run of an array that has messages, which speak of its cells as the text has them."""


class Source:
    """What is sent to the program of an input that is not a path: its name in messages, and for a table CSV, or a file of
    NumPy if it may be one."""

    def __init__(self, name: str, text: Optional[bytes], table: Optional[Table] = None) -> None:
        self.name, self._text, self.table = name, text, table

    @property
    def text(self) -> bytes:
        if self._text is None:
            assert self.table is not None
            self._text = encode(self.table)
        return self._text

    @functools.cached_property
    def array(self) -> Optional[bytes]:
        return None if self.table is None else encode_as_array(self.table)

    def row(self, line: Optional[int]) -> Optional[int]:
        """The row of a line of the CSV, where texts in quotes may have several lines; None for the line of names."""
        if line is None or self.table is None:
            return None
        records = csv.reader(io.StringIO(self.text.decode(), newline=""))
        head = 0 if self.table.names is None else 1
        row = next((i - head for i, _ in enumerate(records) if records.line_num >= line), -1)
        return row if row >= 0 else None

    def in_rows(self, message: str) -> str:
        """A message with rows in place of lines, and dates in place of seconds since 1970."""
        if self.table is None:
            return message

        def row(match: re.Match[str]) -> str:
            if match[1] is None:
                return match[0]
            number = self.row(int(match[1]))
            return "the names of the columns" if number is None else self.table.row_text(number)  # type: ignore[union-attr]

        if any(column.dtype.kind == "M" for column in self.table.columns):
            seconds = r"\b(time|at|from|to|is) (\d{9,10}(?:\.\d+)?)\b"
            message = re.sub(seconds, lambda match: f"{match[1]} {date_text(match[2])}", message)
        return re.sub(r'"[^"]*"|\bline (\d+)\b', row, message)


def source_of(value: Any, name: str) -> Source:
    """The source of a table, bytes or an open file. Raises TypeError, ValueError for what is not a table."""
    if isinstance(value, bytes):
        return Source(name, value)
    if is_table(value):
        rows = table(value)
        return Source(name, None, rows)
    data, file = value.read(), getattr(value, "name", None)
    return Source(file if isinstance(file, str) else name, data.encode() if isinstance(data, str) else bytes(data))


def _with_times(source: Source, options: Mapping[str, Any]) -> Source:
    """The source, where a spare index is the time if neither a column nor an option is."""
    if source.table is None or not source.table.has_spare_index or options.get("parameter") is not None:
        return source
    if _names_time(text(options.get("columns") or "")):
        return source
    words = ["--explain", "--quiet", "--input-format=csv", "--comment=none", "--header"]
    head = source.text[: source.text.find(b"\n", 1 << 16) + 1] if len(source.text) > 1 << 16 else source.text
    explained = subprocess.run([program(), *words], input=head, capture_output=True, check=False).stdout
    if b"\ntimes: none" not in explained:
        return source
    rows = with_index_as_time(source.table)
    return Source(source.name, None, rows)


def _names_time(columns: str) -> bool:
    """Whether the value of the option columns says which column is the time."""
    return any(role.partition("=")[0].strip() == "time" for role in columns.split(","))


_FORM = re.compile(r"^(?P<file>.*?)(?::(?P<line>\d+))?(?::(?P<column>\d+))?: (?P<kind>error|warning|note): (?P<message>.*)$")
_FIT_REPORT = re.compile(r"[\d,]+ samples?, ")
_FIRST_IS_TIME = re.compile(r"the first column is taken as the time; ")


def _warn(note: str) -> None:
    frame, level = sys._getframe(1), 2  # the caller of this module is to blame
    while os.path.dirname(frame.f_code.co_filename) == os.path.dirname(__file__) and frame.f_back is not None:
        frame, level = frame.f_back, level + 1
    warnings.warn(note, Note, stacklevel=level)


# Runs.

_SEPARATORS = {"axes": ":", "size": "x"}  # in lists; in others a comma
_TEXT_OPTIONS = ["input_format", "delimiter", "header", "no_header", "comment", "decimal", "date_order"]


class Run:
    """A run of the program: its words, its input, and the files made for it, which resources own.

    as_array   sends the keys as a file of NumPy where they may be one, and raises HasMessages for a run that has any
    """

    def __init__(self, keys: Any, resources: contextlib.ExitStack, as_array: bool = False) -> None:
        self.sources: dict[str, Source] = {}
        self.words: list[str] = []
        self.files: list[str] = []
        if isinstance(keys, (str, os.PathLike)):
            if "\n" in os.fspath(keys):
                raise TypeError("a text is the path of a file, and this one has several lines; io.StringIO(text) makes a "
                                "file of its contents")  # fmt: skip
            source = Source("", b"")
            self.files = ["--", os.fspath(keys)]
        else:
            source = keys
            self.sources["standard input"] = source
        self.table = source.table
        array = source.array if as_array else None
        self.is_array = array is not None
        if self.is_array:
            self.words = ["--input-format=npy"]
        elif self.table is not None:
            self.words = ["--input-format=csv", "--comment=none"]
            self.words.append("--no-header" if self.table.names is None else "--header")
        self.resources = resources
        self.folder: Optional[str] = None  # of files made for options
        self.input = self._temporary()
        self.input.write(source.text if array is None else array)

    def _temporary(self) -> IO[bytes]:
        return self.resources.enter_context(tempfile.TemporaryFile())

    def _file(self, source: Source) -> str:
        """A file of a source that the program reads for an option."""
        if self.folder is None:
            self.folder = self.resources.enter_context(tempfile.TemporaryDirectory(prefix="tcbsample"))
        path = os.path.join(self.folder, str(len(self.sources)))
        pathlib.Path(path).write_bytes(source.text)
        self.sources[path] = source
        return path

    def _add(self, name: str, value: Any, allowed: Collection[str]) -> None:
        known = name.rstrip("_")
        if known in ("tension", "continuity", "bias"):
            raise TypeError(f"unknown option {name!r}; tcb=(T, C, B) gives the parameters of all keys, and a column with "
                            "this name those of each")  # fmt: skip
        if known not in OPTIONS:
            near = difflib.get_close_matches(known, [*OPTIONS, *REMOVED], 1)
            if near and near[0] in REMOVED:  # the program tells what to do instead
                option = "--" + known.replace("_", "-")
                self.words.append(option if value is None or isinstance(value, bool) else f"{option}={text(value)}")
                return
            meant = "".join(f"; did you mean {other}?" for other in near)
            raise TypeError(f"unknown option {name!r}{meant}; help(tcbsample.Options) lists all")
        if known in COMMAND_ONLY and known not in allowed:
            raise TypeError(f"{name}: not an option of this function; {COMMAND_ONLY[known]}")
        if isinstance(value, np.bool_):
            value = bool(value)
        if value is None or value is False:
            return
        if self.table is not None and known in _TEXT_OPTIONS:
            raise TypeError(f"{name}: describes text, and the keys are a table; leave it out")
        if is_table(value) and np.size(value) == 0:
            raise ValueError(f"{name}: nothing is in it; expected at least one value")
        option = OPTIONS[known]
        if option.kind == "flag" and value is not True:
            raise TypeError(f"{name}: {shown(value)}; expected True or False")
        if option.kind in ("flag", "attached") and value is True:
            self.words.append(option.name)
        elif option.kind == "file" and not isinstance(value, (str, os.PathLike)):
            self.words.append(f"{option.name}={self._file(source_of(value, 'samples'))}")
        elif option.kind == "places" and not isinstance(value, (str, bytes, Mapping)) and np.size(value) > 100:
            numbers = text(value).split(",")
            places = Source(name, "\n".join(numbers).encode(), Table(None, [np.array(numbers)], [], []))
            self.words.append(f"{option.name}=@{self._file(places)}")
        else:
            self.words.append(f"{option.name}={text(value).replace(',', _SEPARATORS.get(known, ','))}")

    def add(self, options: Mapping[str, Any], allowed: Collection[str]) -> None:
        """Adds options, which are those of functions, and those of the command line alone that are allowed here."""
        options = dict(options)
        columns = text(options.get("columns") or "")
        if self.table is not None and self.table.time_index is not None and not _names_time(columns):
            options["columns"] = ",".join(filter(None, ["time=1", columns]))  # the index
            if self.table.columns[0].dtype.kind == "m" and options.get("time_unit") is None:
                options["time_unit"] = "s"
        for name, value in options.items():
            self._add(name, value, allowed)

    def _start(self, words: Iterable[str], **streams: Any) -> subprocess.Popen[bytes]:
        """The started program, which has ended when the resources are closed."""
        self.input.seek(0)
        command = [program(), *self.words, *words, *self.files]
        flags = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # on Windows
        process = subprocess.Popen(command, stdin=self.input, creationflags=flags, **streams)
        self.resources.enter_context(process)
        self.resources.callback(process.kill)
        return process

    def result(self, words: Iterable[str], accepts_difference: bool = False) -> IO[bytes]:
        """The output as a file. Raises Error."""
        output, errors = self._temporary(), self._temporary()
        process = self._start(words, stdout=output, stderr=errors)
        process.wait()
        # Exit code 1 is that of rejected data, which has no output, and of a report of differences.
        self._check(process, errors, accepts_difference and os.fstat(output.fileno()).st_size > 0)
        output.seek(0)
        return output

    def beginning(self, words: Iterable[str], size: int) -> tuple[bytes, bool]:
        """The first bytes of the output, and whether these are all. Raises Error."""
        errors = self._temporary()
        process = self._start(words, stdout=subprocess.PIPE, stderr=errors)
        assert process.stdout is not None
        output = process.stdout.read(size)
        if len(output) == size:
            process.kill()
            return output, False
        process.wait()
        self._check(process, errors)
        return output, True

    def _check(self, process: subprocess.Popen[bytes], errors: IO[bytes], accepts_difference: bool = False) -> None:
        """Raises Error by the exit code; notes are warnings."""
        errors.seek(0)
        messages = errors.read().decode(errors="replace")
        if self.is_array and (messages or process.returncode != 0):
            raise HasMessages
        if process.returncode not in ((0, 1) if accepts_difference else (0,)):
            raise self._error(messages, process.returncode)
        for line in messages.splitlines():
            self._note(line)

    def _message(self, match: re.Match[str]) -> tuple[Optional[Source], str]:
        """The source of a message, and the message in the terms of Python."""
        source = self.sources.get(match["file"])
        message = match["message"]
        for path, other in self.sources.items():
            message = message.replace(path, other.name)
        message = in_python(message)
        return source, source.in_rows(message) if source else message

    def _note(self, line: str) -> None:
        match = _FORM.match(line)
        if match is None:
            _warn(line)
            return
        source, message = self._message(match)
        name = source.name if source else match["file"]
        if source and source.table is not None and _FIRST_IS_TIME.match(message):
            return  # by what an array of keys is
        if _FIT_REPORT.match(message):
            logging.getLogger("tcbsample").info("%s: %s", name, message)
        else:
            _warn(f"{name}: {match['kind']}: {message}")

    def _error(self, messages: str, exit_code: int) -> Error:
        """The errors of the program, FILE:LINE:COLUMN: error: MESSAGE each."""
        matches = filter(None, map(_FORM.match, messages.splitlines()))
        found = [self._one_error(match, exit_code) for match in matches if match["kind"] == "error"]
        if not found:
            return Error(messages.strip() or f"the program ended with exit code {exit_code}", exit_code)
        found[0].others = found[1:]
        return found[0]

    def _one_error(self, match: re.Match[str], exit_code: int) -> Error:
        line, column = (int(match[name]) if match[name] else None for name in ("line", "column"))
        source, message = self._message(match)
        file = source.name if source else None if match["file"] == "tcbsample" else match["file"]
        if source is None or source.table is None:
            return Error(message, exit_code, file, line, column)
        row = source.row(line)
        place = file if row is None else f"{file}, {source.table.row_text(row)}"
        return Error(message, exit_code, file, row=row, place=place)


@contextlib.contextmanager
def run_of(keys: Any, options: Mapping[str, Any], allowed: Collection[str] = (), name: str = "keys",
           as_array: bool = False) -> Iterator[Run]:  # fmt: skip
    """A run with options, whose files are removed when the block ends. Raises TypeError and ValueError."""
    with contextlib.ExitStack() as resources:
        if not isinstance(keys, (str, os.PathLike)):
            keys = _with_times(keys if isinstance(keys, Source) else source_of(keys, name), options)
        run = Run(keys, resources, as_array)
        run.add(options, allowed)
        yield run
