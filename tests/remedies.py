#!/usr/bin/env python3
"""Law: a remedy that can be copied from a message works. Every command of the cases in golden/ whose run fails is run
again with each remedy of its message, such as "give --decimal ,": the error must be gone, or be another one that does
not refuse the remedy. A remedy that is a command for the data, such as "bzcat FILE | tcbsample", is run on a file that
has the message: all keys of it must be there, also equal ones.

    remedies.py PROGRAM GOLDEN_FOLDER
"""
import bz2
import concurrent.futures
import io
import json
import lzma
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile

OPTION = re.compile(r"""(?<![\w-])(--[a-z][a-z-]*|-0)(?:[ ]("[^"]*"|'[^']*'|[^\s;]+))?""")
PLACEHOLDER = re.compile(r"\b[A-Z]{2,}\b|\bHZ\b")
WORDS = {"and", "or", "if", "to", "for", "as", "with", "has", "is", "are", "needs", "in", "first", "from", "includes",
         "instead", "keeps", "says", "gives", "resamples", "leaves", "makes", "chooses", "once"}


def remedies(message, valued):
    """The lists of words that a message offers to add."""
    found = []
    if " is gone in this version; " in message:  # the case instead-of-removed runs these
        return found
    for clause in message.split("; ")[1:]:
        if not re.search(r"\bgive\b|\bor\b --", clause) or re.search(r"^did you mean|^(remove it|write .*), and|remove \S+ or --", clause):
            continue
        end = None
        for match in OPTION.finditer(clause):
            option, value = match.group(1), match.group(2) or ""
            if re.search(r"\b(remove|without|needs|instead of) $", clause[: match.start()]):
                continue
            words = [option]
            if option in valued:
                value = value if value in (",", ".") else value.rstrip(",.")
                value = value[1:-1] if value[:1] in "\"'" else value
                if not value or value in WORDS or PLACEHOLDER.search(value):
                    continue
                words.append(value)
            if end is not None and clause[end : match.start()] == " ":
                found[-1] += words
            else:
                found.append(words)
            end = match.start() + len(option) + (1 + len(match.group(2)) if option in valued else 0)
    return found


def replaced(arguments, words, other_names):
    """The arguments with further words, which replace earlier values of the same options."""
    kept, skip = [], False
    for argument in arguments:
        name = argument.split("=")[0]
        if not skip and other_names.get(name, name) in words:
            skip = name == argument and len(words) > 1
            continue
        if not skip:
            kept.append(argument)
        skip = False
    return [*words, *kept]


def errors(text):
    return [line for line in text.splitlines() if ": error: " in line]


def run(command, folder, data):
    done = subprocess.run(command, cwd=folder, input=data, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=20)
    return done.returncode, done.stderr.decode(errors="replace")


def replay(program, kept, valued, other_names):
    """Runs a command that failed again with each remedy of its errors, in a copy of its folder. `kept`: the folder in
    which WRAPPER keeps it."""
    arguments = (kept / "arguments").read_bytes().decode(errors="surrogateescape").split("\0")[:-1]
    data = (kept / "input").read_bytes()
    tried = []
    if {"--output-dir", "--recursive"} & set(arguments):
        return tried
    before = errors((kept / "messages").read_text(errors="replace"))
    for line in before[:3]:
        message = re.sub(r" \(\d+ errors of this kind.*", "", line.split(": error: ", 1)[1])
        for words in remedies(message, valued):
            with tempfile.TemporaryDirectory() as folder:
                shutil.copytree(kept / "folder", folder, dirs_exist_ok=True, symlinks=True)
                after_status, after = run([program, *replaced(arguments, words, other_names)], folder, data)
            same = after_status != 0 and line in errors(after)
            refused = after_status == 2 and any(f"error: {words[0]}" in one for one in errors(after))
            tried.append({"arguments": arguments, "error": line, "remedy": words, "after": errors(after)[:2],
                          "fails": same or refused})
    return tried


# Runs the program as a case does; where it fails with a message that may offer an option, keeps what runs it again.
WRAPPER = """#!/bin/sh
kept=$(mktemp -d "$REMEDY_KEPT/XXXXXX")
cat >"$kept/input"
"$REMEDY_PROGRAM" "$@" <"$kept/input" 2>"$kept/messages"
status=$?
cat "$kept/messages" >&2
if grep -q ': error: .*; .* -' "$kept/messages"; then
  printf '%s\\0' "$@" >"$kept/arguments"
  cp -RP . "$kept/folder"
else
  rm -r "$kept"
fi
exit $status
"""


# Keys without times, with equal ones.
ROWS = [("x", "y"), ("1", "5"), ("1", "5"), ("-2.5", "7"), ("1", "5"), ("3", "5")]
KEYS = "".join(f"{x},{y}\n" for x, y in ROWS).encode()
COMMAND = re.compile(r"as in ([a-z0-9]+ .*\| tcbsample)")


def archive_of(keys, kind):
    out = io.BytesIO()
    if kind == "tar":
        with tarfile.open(fileobj=out, mode="w") as tar:
            member = tarfile.TarInfo("keys.csv")
            member.size = len(keys)
            tar.addfile(member, io.BytesIO(keys))
    else:
        with zipfile.ZipFile(out, "w") as archive:
            archive.writestr("keys.csv", keys)
            archive.writestr("empty.npy" if kind == "npz" else "empty.txt", b"")
    return out.getvalue()


def data_remedies():
    """Files, by the first word of the command that their message has; and the options of the run."""
    uniform = ["--parameter", "uniform"]
    return [
        ("bzcat", bz2.compress(KEYS), uniform),
        ("xzcat", lzma.compress(KEYS), uniform),
        ("tar", archive_of(KEYS, "tar"), uniform),
        ("unzip", archive_of(KEYS, "zip"), uniform),
        ("unzip", archive_of(KEYS, "npz"), uniform),
        ("iconv", KEYS.decode().encode("utf-16-le"), uniform),
        ("iconv", KEYS.decode().encode("utf-16-be"), uniform),
        ("iconv", KEYS.replace(b"\n", b",\xe9\n").replace(b"y,\xe9", b"y,name"), [*uniform, "--group", "name"]),
        ("sed", b"Run 3\nof two\n" + KEYS + b"the end\n", uniform),
    ]


def run_data_remedies(program, folder):
    """The messages about commands that fail or lose keys."""
    def rows(command, data=b"", **more):
        done = subprocess.run(command, cwd=folder, input=data, capture_output=True, timeout=20, **more)
        return done.returncode, done.stdout.decode().splitlines(), done.stderr.decode(errors="replace")

    failures, expected = [], [f"{x},{y}" for x, y in ROWS]
    for tool, data, options in data_remedies():
        pathlib.Path(folder, "FILE").write_bytes(data)
        words = ["--per-segment", "1", *options]
        status, _, text = rows([program, *words, "FILE"])
        command = COMMAND.search(text)
        if status != 1 or not command or command[1].split()[0] != tool:
            failures.append(f"no command with {tool} in: {text}")
            continue
        if shutil.which(tool):
            shell = command[1].replace(" NAME ", " keys.csv ") + " " + shlex.join(["--fields", "position", *words])
            path = f"{os.path.dirname(program)}:{os.environ['PATH']}"
            status, found, text = rows(["sh", "-c", shell], env={**os.environ, "PATH": path})
            if status or [",".join(line.split(",")[-2:]) for line in found] != expected:
                failures.append(f"{shell}: {found} {text}")
    return failures


def has_remedy(case):
    """Whether the program is run again for a golden case. The folders left out change what they find."""
    file = case / "errors"
    return (case.parent.name not in ("batch", "output") and case.name != "large-texts" and file.exists()
            and re.search(": error: .*; .* -", file.read_text(errors="replace")))


def main(program, golden):
    program = os.path.abspath(program)
    tables = json.loads(subprocess.run([program, "--generate", "tables"], capture_output=True, check=True).stdout)
    valued = {option["name"] for option in tables["options"] if option["value"]}
    names = {option["other_name"]: option["name"] for option in tables["options"] if option["other_name"]}
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        tools, kept = pathlib.Path(folder, "bin"), pathlib.Path(folder, "kept")
        tools.mkdir()
        kept.mkdir()
        wrapper = tools / "tcbsample"
        wrapper.write_text(WRAPPER)
        wrapper.chmod(0o755)
        environment = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}", "REMEDY_PROGRAM": program,
                       "REMEDY_KEPT": str(kept)}

        def run_case(case):
            work = pathlib.Path(folder, "cases", *case.parts[-2:])
            shutil.copytree(case, work, symlinks=True)
            subprocess.run(["sh", "./cmd"], cwd=work, env=environment, stdin=subprocess.DEVNULL,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600)
            shutil.rmtree(work)

        cases = sorted(path.parent for path in pathlib.Path(golden).glob("*/*/cmd"))
        list(pool.map(run_case, filter(has_remedy, cases)))
        entries = sum(pool.map(lambda one: replay(program, one, valued, names), sorted(kept.iterdir())), [])
        losses = run_data_remedies(program, folder)
    print(*losses, sep="\n")
    failures = [entry for entry in entries if entry["fails"]]
    for entry in failures:
        print(" ".join(entry["arguments"]), entry["error"], "-> " + " ".join(entry["remedy"]), *entry["after"], sep="\n  ")
    print(f"{len(entries)} remedies, {len(failures)} do not work")
    return 1 if losses or failures or len(entries) < 50 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
