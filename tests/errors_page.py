#!/usr/bin/env python3
"""Writes a program that prints one page with the message of every error.

The program calls each function of each src/**/errors.hpp with samples of its parameters: a text is the name of the
parameter in capitals. Its output is compared with errors.txt, so that each message is read when it is new or changes.

    errors_page.py SRC > errors_page.cpp
"""
import itertools
import pathlib
import re
import sys

DECLARATION = re.compile(r"^Error (\w+)\(([^;]*)\);", re.M)


def samples(type_, name, enums):
    """Expressions of C++ for a parameter. `enums`: the values of each enumeration that the header declares."""
    shown = name.upper()
    if type_ in ("std::string_view", "const char*", "const std::string&"):
        return [f'"{shown}"']
    if type_ in ("const std::vector<std::string>&", "std::span<const std::string>"):
        return [f'std::vector<std::string>{{"{shown}_1", "{shown}_2"}}']
    if type_ == "std::span<const std::string_view>":
        return [f'std::vector<std::string_view>{{"{shown}_1", "{shown}_2"}}']
    others = {
        "bool": ["false", "true"],
        "char": ["'\\xff'" if name == "byte" else "';'"],
        "double": ["1.5"],
        "std::size_t": ["3"],
        "int": ["5"],
        "std::int64_t": ["6"],
        "std::uint32_t": ["0x40"],
        "std::uint64_t": ["7"],
        "const SettingOrigin&": [f'SettingOrigin{{"--{name}"}}'],
        "const ShownKey&": ['ShownKey{"1.5", 7}', 'ShownKey{"1.5", 7, "keys[3]"}'],
        "const Error&": ['Error(Exit::data, "MESSAGE")'],
    }
    if type_ in enums:
        return enums[type_]
    if type_ not in others:
        sys.exit(f"errors_page.py: no sample of {type_} {name}; add one")
    return others[type_]


def parameters(text):
    """The type and the name of each parameter."""
    text = " ".join(text.split())
    return [tuple(one.rsplit(" ", 1)) for one in re.split(r", (?![^<]*>)", text)] if text else []


def calls(header):
    text = header.read_text()
    space = re.search(r"^namespace (\S+) {", text, re.M).group(1)
    enums = {
        name: [f"{space}::{name}::{value.strip()}" for value in values.split(",")]
        for name, values in re.findall(r"^enum class (\w+) {([^}]*)};", text, re.M)
    }
    found = DECLARATION.findall(text)
    if len(found) != len(re.findall(r"^Error ", text, re.M)):
        sys.exit(f"errors_page.py: {header}: a declaration that this script does not read")
    for function, declared in found:
        choices = [samples(*one, enums) for one in parameters(declared)]
        # Parameters of one type change together: two keys are both in a list, or both are not.
        for i in range(max(map(len, choices), default=1)):
            yield f"{space}::{function}", ", ".join(choice[min(i, len(choice) - 1)] for choice in choices)


def main():
    source = pathlib.Path(sys.argv[1])
    headers = sorted(source.rglob("errors.hpp"))
    print("#include <cstdio>\n#include <string>\n#include <string_view>\n#include <vector>\n")
    for header in headers:
        print(f'#include "{header.relative_to(source).as_posix()}"')
    print("\nusing namespace tcb;\n\nint main() {")
    print('  const auto show = [](const char* name, const Error& error) {')
    print('    std::printf("\\n%s\\n    %s\\n", name, error.message().c_str());\n  };')
    for header, group in itertools.groupby(((h, c) for h in headers for c in calls(h)), lambda pair: pair[0]):
        print(f'  std::puts("\\n\\n== src/{header.relative_to(source).as_posix()}");')
        for _, (function, arguments) in group:
            print(f'  show("{function.split("::")[-1]}", {function}({arguments}));')
    print("}")


main()
