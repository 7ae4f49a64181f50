#!/usr/bin/env python3
"""Makes a folder with the programs that cases and documents may call: called_programs.py SOURCES FOLDER.

They are those of the packages that .ci/setup test names, of those that these depend on, and of those that every Debian
system has. Cases and documents run with them alone, so that one that calls another program fails. Without dpkg, or if one
of the named packages is not installed, there is no such folder.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

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


def main(sources, folder):
    shutil.rmtree(folder, ignore_errors=True)
    try:
        packages, missing = with_dependencies(named_packages(pathlib.Path(sources, ".ci", "setup")))
    except FileNotFoundError:
        print("there is no dpkg")
        return
    if missing:
        print("not installed:", *sorted(missing))
        return
    pathlib.Path(folder).mkdir(parents=True)
    link_programs(packages, folder)
    print(f"the programs of {len(packages)} packages")


if __name__ == "__main__":
    main(*sys.argv[1:])
