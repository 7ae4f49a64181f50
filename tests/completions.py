# Completions at a terminal: bash, zsh and fish complete options, values and files. 77: no shell is installed.
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time

program = os.path.abspath(sys.argv[1])
failures = 0


class Shell:
    """An interactive shell on a terminal of its own."""

    prompt = "ready>"

    def __init__(self, command, start, environment):
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.execvpe(command[0], command, environment)
        self.read_until(lambda text: "%" in text or "#" in text or "$" in text or self.prompt in text)
        self.send(start + "\n")
        self.read_until(lambda text: re.sub(r"\x1b[=>]|\x1b\[[^a-zA-Z]*[a-zA-Z]|\s", "", text).endswith(self.prompt))

    def send(self, text):
        os.write(self.terminal, text.encode())

    def read_until(self, found, limit=20):
        text, end = "", time.monotonic() + limit
        while time.monotonic() < end and not found(text):
            if select.select([self.terminal], [], [], 0.1)[0]:
                text += os.read(self.terminal, 65536).decode(errors="replace")
        return text

    def completed(self, typed):
        """The line after a tab, with what Ctrl-A and "echo" make of it: the words that the shell would run."""
        self.send(typed + "\t\x01print_words \x05\n")
        text = self.read_until(lambda text: re.search(r"<begin>.*<end>.*" + self.prompt, text, re.DOTALL), limit=5)
        found = re.search(r"<begin>(.*?)<end>", text, re.DOTALL)
        return found.group(1).replace("\r", "") if found else text

    def close(self):
        os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)
        os.close(self.terminal)


def check(shell, typed, expected, printed):
    global failures
    if printed == expected:
        return
    failures += 1
    print(f"{shell}: {typed!r}: expected {expected!r}, but {printed!r}")


# What is typed, and the words after the command once a tab has completed them.
cases = [
    ("--arc-c", "--arc-count"),
    ("--preset gamebr", "--preset|gamebryo"),
    ("--preset=gamebr", "--preset=gamebryo"),
    ("--delimiter semi", "--delimiter|semicolon"),
    ("--tangents finite", "--tangents|finite-difference"),
    ("--ends zero,mirr", "--ends|zero,mirror"),
    ("--end fit-d", "--end|fit-down"),
    ("--missing skip-c", "--missing|skip-cell"),
    ("-f jsonl", "-f|jsonl"),
    ("--fields vel", "--fields|velocity"),
    ("--fields time,curv", "--fields|time,curvature"),
    ("--fields=time,curv", "--fields=time,curvature"),
    ("keys.csv --columns tens", "keys.csv|--columns|tension="),
    ("keys.csv --columns time=seen,carr", "keys.csv|--columns|time=seen,carry="),
    ("keys.csv --columns time=see", "keys.csv|--columns|time=see"),
    ("--at @tim", "--at|@times.txt"),
    ("--at=@tim", "--at=@times.txt"),
    ("--output-dir fol", "--output-dir|folder/"),
    ("-o tim", "-o|times.txt"),
    ("tim", "times.txt"),
]


def words_of(printed):
    """What print_words printed, without the bar at the end."""
    return printed.rstrip("|")


def check_at_terminal(name, command, start, environment):
    shell = Shell(command, start, environment)
    for typed, expected in cases:
        check(name, typed, expected, words_of(shell.completed("tcbsample " + typed)))
    shell.close()


def check_fish(fish, script, environment):
    for typed, expected in cases:
        line = "source %s; complete -C 'tcbsample %s'" % (script, typed)
        printed = subprocess.run([fish, "-c", line], env=environment, capture_output=True, text=True, check=False).stdout
        found = [offer.split("\t")[0] for offer in printed.splitlines()]
        last = expected.split("|")[-1]
        check("fish", typed, [last], found or [last] * typed.endswith(last))


def prepare():
    """Files to complete, and the scripts of the program."""
    with open("times.txt", "w", encoding="ascii") as file:
        file.write("0\n")
    os.mkdir("folder")
    os.mkdir("scripts")
    for shell, name in (("bash", "bash"), ("zsh", "_tcbsample"), ("fish", "fish")):
        text = subprocess.run([program, "--generate", shell], capture_output=True, check=True).stdout
        with open("scripts/" + name, "wb") as file:
            file.write(text)


def main():
    prepare()
    environment = dict(os.environ, PATH=os.path.dirname(program) + ":" + os.environ["PATH"], TERM="xterm",
                       HOME=os.getcwd(), PS1="$ ")
    here = os.getcwd()
    print_words = 'print_words() { shift; printf "<%s>" begin; printf "%s|" "$@"; printf "<%s>" end; }; '
    shells = {name: shutil.which(name) for name in ("bash", "zsh", "fish")}
    for name in [name for name in shells if shells[name] is None]:
        print(f"skipped: there is no {name}")
    if shells["bash"]:
        start = print_words + f"source {here}/scripts/bash; bind 'set enable-bracketed-paste off'; PS1=ready'>'"
        check_at_terminal("bash", [shells["bash"], "--norc", "--noprofile", "-i"], start, environment)
    if shells["zsh"]:
        start = (print_words + f"fpath=({here}/scripts $fpath); autoload -U compinit; compinit -u -D; bindkey -e; "
                 "unsetopt automenu autoremoveslash; PS1=ready'>'")
        check_at_terminal("zsh", [shells["zsh"], "-f", "-i"], start, environment)
    if shells["fish"]:
        check_fish(shells["fish"], f"{here}/scripts/fish", environment)
    if not any(shells.values()):
        sys.exit(77)
    sys.exit(1 if failures else 0)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    main()
