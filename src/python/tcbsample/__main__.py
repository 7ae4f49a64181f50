"""Runs the program with the arguments of the command line: python -m tcbsample [OPTION]... [FILE]..."""

import os
import subprocess
import sys

from ._program import program

command = [program(), *sys.argv[1:]]
if os.name == "posix":
    os.execv(command[0], command)  # signals and exit codes are those of the program
sys.exit(subprocess.run(command, check=False).returncode)
