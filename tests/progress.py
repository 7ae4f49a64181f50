# Progress at a terminal: truthful, within the width of the terminal, erased at the end and on Ctrl-C.
import fcntl
import math
import os
import pty
import random
import re
import select
import struct
import subprocess
import sys
import tempfile
import termios
import time

program = os.path.abspath(sys.argv[1])


def run(arguments, columns, interrupt=False):
    """What the program shows on a terminal of so many columns, and its exit code. Its rows go to a file."""
    pid, terminal = pty.fork()
    if pid == 0:
        fcntl.ioctl(2, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        os.execvp(program, [program] + arguments)
    shown, end = "", time.monotonic() + 300
    while time.monotonic() < end:
        if not select.select([terminal], [], [], 0.1)[0]:
            continue
        try:
            part = os.read(terminal, 65536)
        except OSError:
            break
        if not part:
            break
        shown += part.decode()
        if interrupt and "rows" in shown:
            os.write(terminal, b"\x03")
            interrupt = False
    return shown, os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])


def screen(shown):
    """The last line of the terminal, after all that was shown."""
    line, at = [], 0
    for character in shown:
        if character == "\r":
            at = 0
        elif character == "\n":
            line, at = [], 0
        else:
            line[at:at + 1] = character
            at += 1
    return "".join(line).rstrip()


def require(holds, what, shown):
    if not holds:
        sys.exit(f"{what}: {shown[-2000:]!r}")


def without_notes(shown):
    """What the terminal showed without lines that count the numbers of golden rows."""
    return re.sub(r"[^\r\n]* numbers rounded [^\r\n]*\r\n", "", shown)


def check_lines(shown, columns):
    """The lines that the terminal showed: each fits, and no fraction is less than the one before."""
    lines = [line.rstrip() for line in shown.split("\r") if line.strip() and "\n" not in line]
    require(lines, "no progress", shown)
    require(all(len(line) < columns for line in lines), "a line is too long", shown)
    percents = [int(found.group(1)) for found in (re.search(r"(\d+) %", line) for line in lines) if found]
    require(percents, "no percent", shown)
    require(percents == sorted(percents), "the fraction decreases", shown)
    require(percents[0] < 100, "it begins with all of the work", shown)
    return lines


def rows_for_a_while(arguments):
    """So many rows that the program takes 1.5 seconds at least; it has written them to out.csv."""
    rows, seconds = 10000, 0.0
    while seconds < 1.5:
        rows *= max(2, min(10, int(2 / max(seconds, 0.01))))
        start = time.monotonic()
        subprocess.run([program, *arguments, "-n", str(rows), "-o", "out.csv", "keys.csv"], check=True)
        seconds = time.monotonic() - start
    return rows


def fit_for_a_while():
    """What a terminal shows of a fit that takes two seconds at least, and its exit code."""
    noise = random.Random(1)
    with open("recording.csv", "w", encoding="ascii") as file:
        file.write("t,x,y\n")
    samples, seconds, shown, code = 0, 0.0, "", 0
    while seconds < 2 and code == 0:
        with open("recording.csv", "a", encoding="ascii") as file:
            for i in range(samples, max(2 * samples, 500000)):
                file.write(f"{i / 100},{math.sin(i / 300) + noise.gauss(0, 0.01):.4f},{noise.gauss(0, 0.01):.4f}\n")
        samples = max(2 * samples, 500000)
        start = time.monotonic()
        shown, code = run(["--fit", "0.05", "-o", "fit.csv", "recording.csv"], 80)
        seconds = time.monotonic() - start
    return shown, code


def main():
    with open("keys.csv", "w", encoding="ascii") as file:
        file.write("t,x,y\n0,0,1\n1,2,3\n3,4,-1\n4,0,0\n")
    rows = rows_for_a_while(["--golden"])
    golden = ["--golden", "-n", str(rows)]
    shown, code = run([*golden, "-o", "out.csv", "keys.csv"], 80)
    shown = without_notes(shown)
    require(code == 0, f"exit code {code}", shown)
    lines = check_lines(shown, 80)
    require(any("left" in line for line in lines), "no time left", shown)
    require(any(re.search(r"rows/s", line) for line in lines), "no rate", shown)
    require(any("[#" in line for line in lines), "no bar", shown)
    require(screen(shown) == "", "the progress is not erased", shown)

    shown, code = run(["--golden", "-s", f"4/{rows}", "-o", "out.csv", "keys.csv"], 30)
    check_lines(without_notes(shown), 30)

    shown, code = run([*golden, "-o", "other.csv", "keys.csv"], 80, interrupt=True)
    require(code == 130, f"exit code {code}", shown)
    require(screen(shown) == "", "the progress is not erased by Ctrl-C", shown)
    require(sorted(os.listdir(".")) == ["keys.csv", "out.csv"], "files are left: " + " ".join(os.listdir(".")), shown)

    shown, code = run([*golden, "--quiet", "-o", "out.csv", "keys.csv"], 80)
    require(code == 0 and shown == "", "not quiet", shown)

    os.mkdir("keys")
    for name in ("a.csv", "b.csv", "c.csv"):
        os.link("keys.csv", "keys/" + name)
    shown, code = run([*golden, "-j", "1", "--recursive", "--output-dir", "out", "keys"], 100)
    lines = check_lines(without_notes(shown), 100)
    require(any(re.search(r" of 3 files, keys/[abc]\.csv", line) for line in lines), "no file is named", shown)

    rows_for_a_while([])
    shown, code = run(["--check", "out.csv", "--output", "report.txt", "keys.csv"], 80)
    require(screen(shown) == "" and code == 0, "a check: not erased, or it failed", shown)
    check_lines(shown, 80)

    shown, code = fit_for_a_while()
    require(code == 0 and " samples" in shown, "a fit without its note", shown)
    check_lines(shown[:shown.rindex("recording.csv")], 80)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    main()
