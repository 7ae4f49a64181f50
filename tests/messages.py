"""Makes the page of error messages from the sources: messages.py [SOURCES] [PAGE].

SOURCES is the folder of the project. The page goes to standard output, or to the file PAGE: each message with its place,
and with the expression of each placeholder in braces. "never reached" means that no expected error of tests/golden, no
document and no text in a unit test has the message. Exit 1: the text of a message is not where its fault is found.

A message is the text of data_error(…), usage_error(…), Error(Exit::…, …) or {Exit::…, …}, of a call of a function or
lambda of the source that returns such an error, or of a row of a table of BuildErrorCode.
"""
import collections
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
src = root / "src"

Token = collections.namedtuple("Token", "kind text line at end")
Message = collections.namedtuple("Message", "file line exit parts")  # parts: ("text", …) or ("value", expression)
lexer = re.compile(
    r'''(?P<space>\s+|//[^\n]*|/\*.*?\*/|^\#[^\n]*)|(?P<raw>R"(?P<mark>[^(]*)\(.*?\)(?P=mark)")'''
    r"""|(?P<string>"(?:\\.|[^"\\])*")|(?P<char>'(?:\\.|[^'\\])')|(?P<name>[A-Za-z_]\w*)|(?P<number>\d[\w.']*)"""
    r"|(?P<mark_>::|->|.)", re.S | re.M)
closing = {"(": ")", "{": "}", "[": "]"}


def tokens_of(text):
    found, line = [], 1
    for match in lexer.finditer(text):
        if match.lastgroup != "space":
            kind = "string" if match.group("raw") else match.lastgroup.rstrip("_")
            found.append(Token(kind, match.group(), line, match.start(), match.end()))
        line += match.group().count("\n")
    return found


def string_value(literal):
    if literal.startswith("R"):
        return re.fullmatch(r'R"([^(]*)\((.*)\)\1"', literal, re.S)[2]
    escapes = {"n": "\n", "t": "\t", "r": "\r", "0": "\0"}
    return re.sub(r"\\(.)", lambda match: escapes.get(match[1], match[1]), literal[1:-1])


class File:
    def __init__(self, path):
        self.name = path.relative_to(root).as_posix()
        self.text = path.read_text(encoding="utf-8")
        self.tokens = tokens_of(self.text)

    def closing(self, open_):
        """The index of the bracket that closes the one at `open_`."""
        depth = 0
        for i in range(open_, len(self.tokens)):
            depth += (self.tokens[i].text in "([{") - (self.tokens[i].text in ")]}")
            if depth == 0:
                return i
        return len(self.tokens) - 1

    def split(self, begin, end, separators=","):
        """Ranges of tokens between the separators that are in no bracket."""
        ranges, i, first = [], begin, begin
        while i < end:
            if self.tokens[i].text in closing:
                i = self.closing(i)
            elif self.tokens[i].text in separators:
                ranges.append((first, i))
                first = i + 1
            i += 1
        return ranges + [(first, end)] if first < end else ranges

    def source(self, begin, end):
        return re.sub(r"\s+", " ", self.text[self.tokens[begin].at:self.tokens[end - 1].end])


files = [File(path) for path in sorted(src.rglob("*")) if path.suffix in (".hpp", ".cpp", ".in")]

# Constants: their texts.
constants = {}
for file in files:
    for match in re.finditer(r'constexpr (?:const )?(?:char\s*\*|std::string_view|auto|char) (?:const )?(\w+)(?:\[\])?'
                             r'(?: = |\{)((?:\s*"(?:\\.|[^"\\])*")+)\}?;', file.text):
        value = "".join(map(string_value, re.findall(r'"(?:\\.|[^"\\])*"', match[2])))
        constants.setdefault((file.name, match[1]), value)


def constant(file, expression):
    return constants.get((file.name, expression)) if re.fullmatch(r"\w+", expression) else None


def value_parts(file, begin, end):
    """What a placeholder shows."""
    expression = file.source(begin, end)
    known = constant(file, expression)
    if known is not None:
        return [("text", known)]
    quoted = re.fullmatch(r"in_quotes\((.*)\)", expression)
    return [("text", '"'), ("value", quoted[1]), ("text", '"')] if quoted else [("value", expression)]


def format_parts(file, text, arguments):
    """The parts of a format with its arguments."""
    parts, following = [], 0
    for piece in re.split(r"(\{\{|\}\}|\{[^{}]*\})", text):
        if piece in ("{{", "}}"):
            parts.append(("text", piece[0]))
        elif piece.startswith("{"):
            number = re.match(r"\{(\d*)", piece)[1]
            following, index = (following, int(number)) if number else (following + 1, following)
            parts += value_parts(file, *arguments[index]) if index < len(arguments) else [("value", piece[1:-1])]
        elif piece:
            parts.append(("text", piece))
    return parts


def text_parts(file, begin, end):
    """The parts of an expression that is a text: literals, fmt::format(…), sums of these, values."""
    parts = []
    for first, last in file.split(begin, end, "+"):
        tokens = file.tokens[first:last]
        while len(tokens) > 4 and [t.text for t in tokens[:3]] == ["std", "::", "string"] and tokens[3].text in "({":
            first, last = first + 4, last - 1  # std::string("…")
            tokens = file.tokens[first:last]
        if tokens and all(token.kind == "string" for token in tokens):
            parts.append(("text", "".join(string_value(token.text) for token in tokens)))
        elif [token.text for token in tokens[:4]] == ["fmt", "::", "format", "("]:
            arguments = file.split(first + 4, file.closing(first + 3))
            parts += formatted(file, arguments) or [("value", file.source(first, last))]
        elif tokens:
            parts += value_parts(file, first, last)
    return parts


def formatted(file, arguments):
    """The parts of a format and its arguments; None if the format is no text in this place."""
    begin, end = arguments[0]
    if all(token.kind == "string" for token in file.tokens[begin:end]):
        text = "".join(string_value(token.text) for token in file.tokens[begin:end])
    else:
        text = constant(file, file.source(begin, end))
    return format_parts(file, text, arguments[1:]) if text is not None else None


def makers_of(file):
    """Functions and lambdas of the file that return an error made from texts of their callers."""
    names = {"data_error", "usage_error"}
    for i in range(1, len(file.tokens) - 2):
        name, after = file.tokens[i], file.tokens[i + 1].text
        if name.kind != "name":
            continue
        if file.tokens[i - 1].text == "Error" and after == "(":
            names.add(name.text)
        if file.tokens[i - 1].text == "auto" and after == "=" and file.tokens[i + 2].text == "[":
            body = next((j for j in range(file.closing(i + 2), len(file.tokens)) if file.tokens[j].text == "{"), i)
            if any(token.text in ("data_error", "usage_error") for token in file.tokens[body:file.closing(body)]):
                names.add(name.text)
    return names


def messages_of(file):
    makers, found, unclear = makers_of(file), [], []
    for i in range(1, len(file.tokens) - 2):
        token, before, after = file.tokens[i], file.tokens[i - 1], file.tokens[i + 1]
        if token.text == "Exit" and before.text in "({" and after.text == "::" and file.tokens[i + 3].text == ",":
            parts = text_parts(file, i + 4, file.closing(i - 1))
            found.append(Message(file.name, token.line, file.tokens[i + 2].text, parts))
        elif token.text == "BuildErrorCode" and after.text == "::" and [t.kind for t in file.tokens[i + 3:i + 5]] == [
                "mark", "string"]:
            end = next(j for j in range(i, len(file.tokens)) if file.tokens[j].text in ")}")
            last = next((j for j in range(i + 4, end) if file.tokens[j].kind != "string"), end)
            text = "".join(string_value(t.text) for t in file.tokens[i + 4:last])
            found.append(Message(file.name, token.line, file.tokens[i + 2].text, format_parts(file, text, [])))
        elif token.text in makers and after.text == "(" and file.name != "src/error.hpp":
            arguments = file.split(i + 2, file.closing(i + 1))
            if before.text in ("Error", "std", ".", "->") or not arguments:
                continue  # a declaration, or another function of this name
            parts = formatted(file, arguments)
            if token.text not in ("data_error", "usage_error"):
                # The words of the caller: the argument with a text, and what it is formatted with.
                texts = [j for j, (first, _) in enumerate(arguments) if file.tokens[first].kind == "string"
                         or file.source(first, first + 1) == "fmt" or "+" in
                         [t.text for t in file.tokens[first:arguments[j][1]]]]
                parts = None
                if texts:
                    parts = formatted(file, arguments[texts[0]:]) or text_parts(file, *arguments[texts[0]])
                if not parts or not any(kind == "text" for kind, _ in parts):
                    continue
                found.append(Message(file.name, token.line, token.text, parts))
            elif parts:
                found.append(Message(file.name, token.line, token.text[:-6], parts))
            else:
                unclear.append(f"{file.name}:{token.line}: {file.source(i, file.closing(i + 1) + 1)}")
    return found, unclear


messages, unclear = [], []
for file in files:
    found, not_found = messages_of(file)
    messages += found
    unclear += not_found

# What tests expect.
expected = [path.read_text(encoding="utf-8", errors="replace") for path in (root / "tests" / "golden").rglob("*")
            if path.is_file() and path.name != "cmd" and path.suffix != ".py"]
expected += [path.read_text(encoding="utf-8") for path in (root / "samples").rglob("*.md")]
expected = {line for text in expected for line in text.splitlines() if "; " in line or "error" in line}
code = "".join(path.read_text(encoding="utf-8") for path in (root / "tests" / "spline").rglob("*_test.cpp"))
units = "\n".join("".join(map(string_value, re.findall(r'"(?:\\.|[^"\\])*"', run[0])))
                  for path in (root / "tests").rglob("*_test.cpp")
                  for run in re.finditer(r'"(?:\\.|[^"\\])*"(?:\s*"(?:\\.|[^"\\])*")*', path.read_text(encoding="utf-8")))
units += "".join(path.read_text(encoding="utf-8") for end in ("*.py", "*.sh") for path in (root / "tests").rglob(end)
                 if path.name != "messages.py")


def is_reached(message):
    """Golden errors have the message whole, unit tests its beginning, or its code in the library."""
    if message.file.endswith("build_error.hpp") and re.search(rf"\b{message.exit}\b", code):
        return True
    pattern = "".join(re.escape(text) if kind == "text" else ".*?" for kind, text in message.parts)
    if len("".join(text for kind, text in message.parts if kind == "text").strip()) < 8:
        return True  # made of the texts of others, which are on the page themselves
    longest = max((text for kind, text in message.parts if kind == "text"), key=len)
    if any(longest in line and re.search(pattern, line) for line in expected):
        return True
    beginning = next((text for kind, text in message.parts if kind == "text" and len(text) >= 10), None)
    return beginning is not None and beginning[:28] in units


lines, never, last = [], 0, None
for message in sorted(messages, key=lambda message: (message.file, message.line)):
    if message.file != last:
        lines += ["", f"== {message.file}"]
        last = message.file
    reached = is_reached(message)
    never += not reached
    text = "".join(text if kind == "text" else "{" + text + "}" for kind, text in message.parts)
    lines += ["", f"{message.line}, {message.exit}" + ("" if reached else ", never reached"), "    " + repr(text)[1:-1]
              if "\n" in text else "    " + text]
lines += ["", f"{len(messages)} messages, {never} never reached"]
page = "\n".join(lines[1:]) + "\n"
if len(sys.argv) > 2:
    pathlib.Path(sys.argv[2]).write_text(page, encoding="utf-8")
    print(lines[-1])
else:
    sys.stdout.write(page)
for call in unclear:
    print("no text in", call, file=sys.stderr)
sys.exit(1 if unclear else 0)
