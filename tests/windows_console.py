#!/usr/bin/env python3
"""Tests what only Windows has with a program for it, by wine: windows_console.py PROGRAM.EXE FOLDER.

The device nul, a path that is longer than 260 characters, and Ctrl-C in a console, here a pseudo-terminal. FOLDER is
empty.
"""
import os
import pathlib
import pty
import subprocess
import sys
import time

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
os.chdir(folder)
KEYS = "t,x\n0,1\n1,2\n"


def run(*arguments):
    return subprocess.run(["wine", program, *arguments], capture_output=True, text=True, check=True).stdout


pathlib.Path("keys.csv").write_text(KEYS)
assert run("--count", "3", "keys.csv", "-o", "nul") == ""
assert os.listdir(".") == ["keys.csv"], "nul is not a file"

long_folder = pathlib.Path(*["f" * 60] * 6)
long_folder.mkdir(parents=True)
(long_folder / "keys.csv").write_text(KEYS)
run("--count", "3", str(long_folder / "keys.csv"), "-o", str(long_folder / "rows.csv"))
assert (long_folder / "rows.csv").read_bytes() == b"t,x\n0,1\n0.5,1.5\n1,2\n"

process, console = pty.fork()
if process == 0:
    many = ["--count", "4000000000", "--max-rows", "4000000000"]
    os.execvp("wine", ["wine", program, *many, "keys.csv", "-o", "rows.csv"])
incomplete = ".rows.csv."
deadline = time.monotonic() + 60
while not any(name.startswith(incomplete) for name in os.listdir(".")):
    assert time.monotonic() < deadline, "no output was begun"
    time.sleep(0.1)
os.write(console, b"\x03")
try:
    while os.read(console, 4096):
        pass
except OSError:  # the end
    pass
status = os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
assert status == 130, f"exit code {status} after Ctrl-C"
assert sorted(os.listdir(".")) == sorted(["keys.csv", "f" * 60]), "Ctrl-C removes the incomplete output"
print("nul, long paths and Ctrl-C: as on Linux")
