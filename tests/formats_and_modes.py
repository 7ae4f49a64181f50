"""Every input format with every mode: formats_and_modes.py PROGRAM SAMPLES.

Each file of SAMPLES that is not plain delimited text or JSON is sampled, compared with its own rows, identified, drawn,
fitted, converted in a batch, updated, and made again by the command in its provenance, as a file, compressed, and through a pipe. A
mode that a curve refuses has to say why.
"""
import csv
import gzip
import io
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

program, samples = sys.argv[1], Path(sys.argv[2])
failures = []

# File, options that it needs, and the modes that its curve refuses, with a word of why.
CASES = [
    (samples / "formats/camera_path.json", [], {"--emit": "rotation", "--fit": "quaternions"}),
    (samples / "formats/scene.lws", ["--only", "Ship/position"], {"--fit": "only keys have"}),
    (samples / "formats/door.3ds", ["--only", "Door/position"], {"--fit": "only keys have"}),
    (samples / "formats/door.3ds", ["--only", "Door/rotation"], {"--emit": "rotation", "--fit": "only keys have"}),
    (samples / "tum.txt", ["-i", "tum"], {"--emit": "rotation"}),
    (None, ["--columns", "time=1,position=2:3:4"], {}),
]


def run(*arguments, data=None):
    done = subprocess.run([program, *map(str, arguments)], input=data, capture_output=True)
    return done.returncode, done.stdout, done.stderr.decode()


def expect(what, condition, text=""):
    if not condition:
        failures.append(f"{what}: {text}")


def mode(name, file, options, refused, *arguments):
    """Runs a mode; a refusal has to be expected, and any other failure is reported."""
    status, out, errors = run(file, *options, "-q", *arguments)
    option = str(arguments[0])
    if option in refused:
        expect(f"{name} {option} is refused", status != 0 and refused[option] in errors, errors)
        return None
    expect(f"{name} {option}", status == 0 and out, errors)
    return out


with tempfile.TemporaryDirectory() as folder:
    folder = Path(folder)
    array = folder / "array.npy"
    _, data, _ = run(samples / "camera.csv", "--step", "1", "-f", "npy")
    array.write_bytes(data)
    for file, options, refused in CASES:
        file = file or array
        name = f"{file.name} {' '.join(options)}"
        rows = mode(name, file, options, refused, "--count", "9")
        if rows is None:
            continue
        expect(f"{name} has rows", len(rows.splitlines()) >= 9)
        table = folder / "rows.csv"
        table.write_bytes(rows)
        packed = folder / (file.name + ".gz")
        packed.write_bytes(gzip.compress(file.read_bytes()))
        expect(f"{name} compressed", run(packed, *options, "-q", "--count", "9")[1] == rows)
        form = options if "-i" in options else [*options, "-i", {".json": "nerfstudio"}.get(file.suffix, file.suffix[1:])]
        expect(f"{name} through a pipe", run(*form, "-q", "--count", "9", data=file.read_bytes())[1] == rows)
        golden = mode(name, file, options, refused, "--golden", "--count", "9")
        for plain, exact in zip(csv.reader(io.StringIO(rows.decode())), csv.reader(io.StringIO(golden.decode()))):
            for a, b in zip(plain, exact, strict=True):
                try:
                    expect(f"{name} golden", abs(float(a) - float(b)) <= 1e-12 * max(1, abs(float(b))), f"{a} {b}")
                except ValueError:
                    expect(f"{name} golden", a == b, f"{a} {b}")
        mode(name, file, options, refused, "--check", table)
        mode(name, file, options, refused, "--identify", table)
        mode(name, file, options, refused, "--plot")
        mode(name, file, options, refused, "--explain", "--count", "9")
        limit = "1deg" if "Door/rotation" in options else "0.05,1deg" if "--emit" in refused else "0.05"
        mode(name, file, options, refused, "--tolerance", limit)
        mode(name, file, options, refused, "--emit", "hermite")
        mode(name, file, options, refused, "--fit", limit)
        made = folder / "made"
        status, _, errors = run(file, *options, "-q", "--count", "9", "--output-dir", made)
        (output,) = made.iterdir() if made.exists() else (None,)
        expect(f"{name} in a batch", status == 0 and output and output.read_bytes() == rows, errors)
        before = output.stat().st_mtime_ns
        status, _, errors = run(file, *options, "-q", "--count", "9", "--output-dir", made, "--update")
        expect(f"{name} updated", status == 0 and output.stat().st_mtime_ns == before, errors)
        output.unlink()
        meta = folder / "meta.csv"
        status, _, errors = run(file, *options, "-q", "--count", "9", "--meta", "-o", meta)
        command = re.search("^# command: tcbsample (.*)$", meta.read_text(), re.MULTILINE) if status == 0 else None
        again = run(*shlex.split(command[1])) if command else (1, b"", errors)
        expect(f"{name} by the command in its provenance", again[1] == meta.read_bytes(), again[2])
for failure in failures[:10]:
    print(failure, file=sys.stderr)
print(f"{len(CASES)} inputs, {len(failures)} failures")
sys.exit(1 if failures else 0)
