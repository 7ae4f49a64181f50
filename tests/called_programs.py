#!/usr/bin/env python3
"""Every program that a case or a document calls is installed by .ci/setup test: called_programs.py PROGRAM SOURCES.

Runs them where PATH has only the programs of the packages that .ci/setup test names, of those that they depend on, and
of those that every Debian system has. Exit code 77 without dpkg, or if one of the named packages is not installed.
"""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FOLDERS = ("/bin", "/usr/bin", "/sbin", "/usr/sbin")


def named_packages(setup):
    """What the lists of the program and of its tests name."""
    text = setup.read_text()
    return {name for list_of in ("packages", "tests") for name in re.search(rf'^{list_of}="([^"]*)"$', text, re.M)[1].split()}


def with_dependencies(named):
    """The installed packages that are named, that these depend on, or that every system has."""
    form = "${Package}\t${db:Status-Status}\t${Essential}\t${Priority}\t${Pre-Depends}, ${Depends}\t${Provides}\n"
    rows = [line.split("\t") for line in subprocess.check_output(["dpkg-query", "-W", "-f", form], text=True).splitlines()]
    needs, provided, everywhere = {}, {}, set()
    for name, status, essential, priority, depends, provides in rows:
        if status != "installed":
            continue
        needs[name] = {re.split(r"[ (:]", need.strip())[0] for need in re.split(r"[,|]", depends) if need.strip()}
        for word in provides.split(","):
            provided.setdefault(re.split(r"[ (:]", word.strip())[0], set()).add(name)
        if essential == "yes" or priority == "required":
            everywhere.add(name)
    found, wanted = set(), [*everywhere, *named]
    while wanted:
        name = wanted.pop()
        if name in needs and name not in found:
            found.add(name)
            wanted += needs[name]
        elif name not in needs:
            wanted += provided.get(name, set()) - found
    return found, named - set(needs)


def link_programs(packages, folder):
    """Links to the programs of the packages, and to those that stand for one of them, as awk for mawk."""
    form = "${Package}\t${binary:Package}\t${Architecture}\n"  # a package may be there for several architectures
    rows = [line.split("\t") for line in subprocess.check_output(["dpkg-query", "-W", "-f", form], text=True).splitlines()]
    own = {"all", subprocess.check_output(["dpkg", "--print-architecture"], text=True).strip()}
    names = [exact for name, exact, architecture in rows if name in packages and architecture in own]
    listed = subprocess.run(["dpkg", "-L", *names], stdout=subprocess.PIPE, text=True, check=False).stdout
    files = {path for path in listed.splitlines() if os.path.dirname(path) in FOLDERS and os.access(path, os.X_OK)}
    real = {os.path.realpath(path) for path in files}
    for directory in FOLDERS:
        for path in pathlib.Path(directory).iterdir():
            stands_for = os.readlink(path) if path.is_symlink() else ""
            if str(path) in files or (stands_for.startswith("/etc/alternatives/") and os.path.realpath(path) in real):
                link = pathlib.Path(folder) / path.name
                if not link.exists() and not path.is_dir():
                    link.symlink_to(path)


def main():
    program, sources = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    tests = sources / "tests"
    try:
        packages, missing = with_dependencies(named_packages(sources / ".ci" / "setup"))
    except FileNotFoundError:
        print("skipped: there is no dpkg")
        return 77
    if missing:
        print("skipped: not installed:", *sorted(missing))
        return 77
    cases = sorted(path.parent for path in (tests / "golden").rglob("cmd"))
    documents = [sources / "README.md", sources / "samples" / "README.md"]
    commands = [["sh", tests / "golden.sh", program, case] for case in cases]
    commands += [["sh", tests / "docs.sh", program, document] for document in documents]
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        link_programs(packages, folder)
        environment = {**os.environ, "PATH": folder}

        def result(command):
            return subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace", check=False)

        failed = 0
        for command, done in zip(commands, threads.map(result, commands)):
            if done.returncode not in (0, 77):
                failed += 1
                print(f"{command[-1]}: exit code {done.returncode}", *done.stdout.splitlines()[-12:], sep="\n  ")
    print(f"{len(commands)} cases and documents with the programs of {len(packages)} packages, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
