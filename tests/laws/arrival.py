"""Output, messages and exit code do not depend on how bytes arrive: as a file, or through a pipe in pieces.

Texts are the inputs of golden cases, samples and fuzzers, and keys of every kind, cut off, and with beginnings of other
formats put in. Of a run that fails, a pipe may have printed rows that a file holds back. A pipe gets them byte by byte, or
in pieces with short pauses. The machine may stop the writer for longer than the program waits, so that only what differs
three times counts."""
import os
import pathlib
import subprocess
import tempfile
import threading
import time

from keys import Keys
from law import check, program, ran, require

here = pathlib.Path(__file__).resolve().parents[1]
ENDINGS = {".csv", ".tsv", ".txt", ".json", ".jsonl", ".tum", ".kitti", ".euroc", ".lws", ".3ds", ".npy", ".gz", ""}
folders = [here / "golden", here / "fuzz" / "corpus" / "delimited", here.parent / "samples"]
files = sorted(path for folder in folders for path in folder.rglob("*")
               if path.is_file() and path.suffix in ENDINGS and 0 < path.stat().st_size < 20_000
               and path.name not in ("cmd", "expected", "errors", "status"))
INSERTED = [b"{curve x", b"P[1]", b"N10 G1", b"</script>", b"\n", b",", b'"', b"#", b"[", b'{"keys":', b"\xef\xbb\xbf",
            b"\x93NUMPY", b"LWSC", b"MM", b";", b"\t", b"x", b"1e999", b"\r\n", b"# t,x,y\n", b"0,1\n", b"\0"]
OPTIONS = [["-n", "3"], ["--step", "0.5"], ["--explain"], ["-n", "2", "-i", "csv"], ["-n", "2", "-i", "json"],
           ["-n", "2", "--missing", "skip-cell"], ["-n", "2", "-f", "jsonl"], ["--limits"]]


def run(options, stream):
    process = subprocess.Popen(["timeout", "30", program, *options, "-"], stdin=stream, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE)
    stdin, process.stdin = process.stdin, None
    return process, stdin


def of_file(options, text):
    with tempfile.TemporaryFile() as file:
        file.write(text)
        file.seek(0)
        process, _ = run(options, file)
        out, errors = process.communicate()
    return process.returncode, out, errors


def of_pieces(rng, options, text, sizes, pauses):
    process, pipe = run(options, subprocess.PIPE)
    result = []
    reader = threading.Thread(target=lambda: result.extend(process.communicate()))
    reader.start()
    at, paused = 0, 0
    try:
        while at < len(text):
            size = rng.randint(*sizes)
            os.write(pipe.fileno(), text[at:at + size])
            at += size
            if pauses and paused < 5 and rng.random() < 0.1:  # in sum far below what the program waits for
                time.sleep(0.005)
                paused += 1
    except BrokenPipeError:
        pass
    pipe.close()
    reader.join()
    return process.returncode, *result


def same(of_pipe, of_file):
    held_back = of_file[0] != 0 and of_pipe[1].startswith(of_file[1])
    return of_pipe[0] == of_file[0] and of_pipe[2] == of_file[2] and (of_pipe[1] == of_file[1] or held_back)


def changed(rng, text):
    if rng.random() < 0.4:
        return text
    if rng.random() < 0.3:
        text = text[:rng.randint(1, len(text))]
    for _ in range(rng.choice([0, 0, 0, 1, 2])):
        at = rng.randint(0, len(text))
        text = text[:at] + rng.choice(INSERTED) + text[at:]
    if rng.random() < 0.2:
        lines = text.split(b"\n")
        at = rng.randrange(len(lines))
        text = b"\n".join(lines[:at] + [rng.choice(lines)] * rng.choice([1, 30]) + lines[at:])
    return text


def law(rng):
    keys, options, file = Keys(rng), rng.choice(OPTIONS), rng.choice(files)
    if rng.random() < 0.2:
        options, text = options + keys.options(), keys.text(rng.choice(["csv", "tsv", "json", "jsonl"])).encode()
    else:
        text = file.read_bytes()
    text = changed(rng, text)
    expected = of_file(options, text)
    ran.append((options, f"{file}: {text!r}"))
    for sizes, pauses in (((1, 1), False), ((1, 60), True), ((50, 5000), True)):
        found = [of_pieces(rng, options, text, sizes, pauses)]
        while not same(found[-1], expected) and len(found) < 3:
            found.append(of_pieces(rng, options, text, sizes, pauses))
        if expected[0] == 0 or not same(found[-1], expected):  # a text that is read counts as a fact
            require(same(found[-1], expected), f"in pieces of {sizes}: {found[-1]}, of the file: {expected}")


check(law, 12, least=0.5)
