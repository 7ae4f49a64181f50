"""Makes the Python wheel: make_wheel.py --program P --tables T --folder F (--license L [--strip S] | --module)

The folder F, which is made anew, gets the wheel, whose name tells on which systems the program runs, and its contents
in a folder: the program P without symbols, which becomes the command tcbsample, and the module of the folder beside
this script, with the options and presets of T, which `tcbsample --generate tables` prints.

With --module, F gets only the module, and the program in it, for tests.
"""

import argparse
import json
import keyword
import os
import pathlib
import re
import runpy
import shutil
import struct
import subprocess
import sys

SOURCE = pathlib.Path(__file__).parent / "tcbsample"
MACHINES = {0x3E: "x86_64", 0xB7: "aarch64"}  # of ELF
WINDOWS_MACHINES = {0x8664: "win_amd64", 0xAA64: "win_arm64"}
PT_INTERP = 3

# Options that are parameters of functions; a type checker wants them in other classes than those of **options.
PARAMETERS = dict.fromkeys(["step", "count", "arc_step", "at", "tolerance", "preset"], "sampling")
PARAMETERS.update(dict.fromkeys(["abs", "rel", "ulp"], "plot"))

METADATA = """\
Metadata-Version: 2.1
Name: tcbsample
Version: {version}
Summary: Kochanek-Bartels (TCB) curves through keyframes
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy>=1.20
Provides-Extra: pandas
Requires-Dist: pandas; extra == "pandas"
Description-Content-Type: text/plain

{description}"""

WHEEL = """\
Wheel-Version: 1.0
Generator: tcbsample make_wheel.py
Root-Is-Purelib: false
{tags}
"""

OPTIONS = '''\
"""The options and presets of tcbsample {version}, made by make_wheel.py from the program's own tables."""

from __future__ import annotations

from typing import Any, NamedTuple, TypedDict

Value = Any  # a number, a text, a list, or a dict; see the description of the module
__version__ = {version!r}


class Option(NamedTuple):
    """An option of the command line."""

    name: str
    keyword: str
    kind: str
    known: tuple[str, ...]  # the values that it has names for


class Options(TypedDict, total=False):
    """The options of all functions, with the values that the command line takes; see the module for those of Python.

{docs}
    """

{fields}


class SamplingOptions(Options, total=False):
    """The options that resample() has as parameters, and the others."""

{sampling}


class PlotOptions(SamplingOptions, total=False):
    """The options that other functions have as parameters, and the others."""

{plot}


OPTIONS = {{
{options}
}}

# Those of earlier versions.
REMOVED = {removed!r}

PRESETS = {{
{presets}
}}
'''


def platforms(program):
    """The platform tags of a program. Ends with a message for a program of another kind."""
    head = program.read_bytes()[:4096]
    if head[:2] == b"MZ":
        (at,) = struct.unpack_from("<I", head, 0x3C)
        (machine,) = struct.unpack_from("<H", head, at + 4)
        if machine in WINDOWS_MACHINES:
            return [WINDOWS_MACHINES[machine]]
    if head[:6] == b"\x7fELF\x02\x01":
        (machine,) = struct.unpack_from("<H", head, 18)
        (table,) = struct.unpack_from("<Q", head, 32)
        size, count = struct.unpack_from("<HH", head, 54)
        kinds = [struct.unpack_from("<I", head, table + i * size)[0] for i in range(count)]
        if machine in MACHINES:
            name = MACHINES[machine]
            if PT_INTERP in kinds:  # it loads shared libraries of this system
                return ["linux_" + name]
            return ["manylinux_2_17_" + name, "musllinux_1_1_" + name]  # static: it runs on any Linux
    sys.exit(f"make_wheel: {program}: unknown kind of program; expected ELF or PE for x86-64 or aarch64")


def python_name(option):
    name = option.lstrip("-").replace("-", "_")
    return name + "_" if keyword.iskeyword(name) else name


def wrapped(text, indent, width=116):
    lines, line = [], ""
    for word in text.split(" "):
        if line and len(indent) + len(line) + 1 + len(word) > width:
            lines.append(indent + line)
            line = word
        else:
            line += (" " if line else "") + word
    return "\n".join([*lines, indent + line])


def options_module(tables):
    """The source of tcbsample/_options.py."""
    docs, options, group = [], [], None
    fields = {"fields": [], "sampling": [], "plot": []}
    command_only = runpy.run_path(str(SOURCE / "_command_only.py"))["COMMAND_ONLY"]
    for row in tables["options"]:
        names = [name for name in (row["name"], row["other_name"]) if name.startswith("--")]
        for name in names:
            option = name, python_name(name), row["kind"], tuple(row["known"])
            options.append(f"    {python_name(name).rstrip('_')!r}: Option{option!r},")
        if python_name(row["name"]) in command_only:
            continue
        if row["group"] != group:
            group = row["group"]
            docs.append(f"    {group}:")
        text = re.sub(r"--([a-z][a-z-]*)", lambda match: python_name(match[0]), row["text"]).replace("\\", "\\\\")
        title = ", ".join(python_name(name) for name in names)
        docs.append(f"      {title}{' ' + row['value'] if row['value'] else ''}\n" + wrapped(text, " " * 10))
        for name in names:
            kind = "bool" if row["kind"] == "flag" else "Value"
            place = PARAMETERS.get(python_name(name), "fields")
            fields[place].append(f"    {python_name(name)}: {kind}")
    rules = ("tangents", "ends", "product")
    presets = [f"    {row['name']!r}: {tuple(row[name] for name in rules)!r}," for row in tables["presets"]]
    fields["plot"] += [f"    {name}: Value" for name in ("check", "identify", "fit")]
    parts = {**fields, "docs": docs, "options": options, "presets": presets}
    removed = [python_name(name) for name in tables["removed"]]
    return OPTIONS.format(version=tables["version"], removed=removed, **{name: "\n".join(lines) for name, lines in parts.items()})


def make_module(folder, tables):
    package = folder / "tcbsample"
    package.mkdir(parents=True)
    for file in sorted(SOURCE.iterdir()):
        if file.is_file():
            shutil.copyfile(file, package / file.name)
    (package / "_options.py").write_text(options_module(tables), encoding="utf-8")
    return package


def make_wheel(arguments, tables):
    version, folder = tables["version"], arguments.folder / "contents"
    package = make_module(folder, tables)
    scripts = folder / f"tcbsample-{version}.data" / "scripts"
    scripts.mkdir(parents=True)
    program = scripts / ("tcbsample" + arguments.program.suffix)
    shutil.copyfile(arguments.program, program)
    if arguments.strip:
        subprocess.run([arguments.strip, program], check=True)
    program.chmod(0o755)
    about = folder / f"tcbsample-{version}.dist-info"
    about.mkdir()
    shutil.copyfile(arguments.license, about / "LICENSE")
    description = (package / "__init__.py").read_text(encoding="utf-8").split('"""')[1]
    (about / "METADATA").write_text(METADATA.format(version=version, description=description), encoding="utf-8")
    tags = "\n".join(f"Tag: py3-none-{platform}" for platform in platforms(program))
    (about / "WHEEL").write_text(WHEEL.format(tags=tags), encoding="utf-8")
    os.environ.setdefault("SOURCE_DATE_EPOCH", "1795392000")  # the same bytes from each build
    command = [sys.executable, "-m", "wheel", "pack", folder, "--dest-dir", arguments.folder]
    if subprocess.run(command, stdout=subprocess.DEVNULL).returncode != 0:
        sys.exit("make_wheel: packing failed; it needs the Python module wheel, Debian's python3-wheel")
    print(next(arguments.folder.glob("*.whl")))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--tables", type=pathlib.Path, required=True)
    parser.add_argument("--folder", type=pathlib.Path, required=True)
    parser.add_argument("--license", type=pathlib.Path)
    parser.add_argument("--strip")
    parser.add_argument("--module", action="store_true")
    arguments = parser.parse_args()
    tables = json.loads(arguments.tables.read_text(encoding="utf-8"))
    shutil.rmtree(arguments.folder, ignore_errors=True)
    if arguments.module:
        package = make_module(arguments.folder, tables)
        (package / ("tcbsample" + arguments.program.suffix)).symlink_to(arguments.program.resolve())
    else:
        make_wheel(arguments, tables)


if __name__ == "__main__":
    main()
