"""Files of 3D Studio against lib3ds: against_lib3ds.py PROGRAM EVALUATE [CASES [SEED]].

Random objects with keys of positions, rotations and scales, with tension, continuity and bias, are evaluated by lib3ds
(EVALUATE) and by the program, and have to agree within single precision at every frame.
"""
import csv
import io
import math
import random
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

program, evaluate = sys.argv[1:3]
cases = int(sys.argv[3]) if len(sys.argv) > 3 else 10
draw = random.Random(int(sys.argv[4]) if len(sys.argv) > 4 else 3)
failures = []


def chunk(number, content):
    return struct.pack("<HI", number, len(content) + 6) + content


def key(frame, numbers):
    tcb = [round(draw.uniform(-1, 1), 2) if draw.random() < 0.5 else None for _ in range(3)]
    flags = sum(1 << i for i, x in enumerate(tcb) if x is not None)
    given = [x for x in tcb if x is not None]
    return struct.pack("<IH", frame, flags) + struct.pack(f"<{len(given + numbers)}f", *given, *numbers)


def track(number, frames, numbers):
    keys = b"".join(key(frame, numbers(i)) for i, frame in enumerate(frames))
    return chunk(number, struct.pack("<HIII", 0, 0, 0, len(frames)) + keys)


def rotation(first):
    axis = [draw.gauss(0, 1) for _ in range(3)]
    size = math.hypot(*axis)
    return [draw.uniform(-1.2, 1.2) if not first else draw.uniform(-2, 2), *(x / size for x in axis)]


def frames_of():
    frames = [0]
    for _ in range(draw.randint(1, 5)):
        frames.append(frames[-1] + draw.randint(2, 20))
    return frames


def file_of(name, frames):
    vector = lambda i: [draw.uniform(-9, 9) for _ in range(3)]
    node = (chunk(0xB030, struct.pack("<H", 0)) + chunk(0xB010, name.encode() + b"\0" + struct.pack("<HHh", 0, 0, -1))
            + chunk(0xB013, struct.pack("<3f", 0, 0, 0)) + track(0xB020, frames["position"], vector)
            + track(0xB021, frames["rotation"], lambda i: rotation(i == 0)) + track(0xB022, frames["scale"], vector))
    header = chunk(0xB00A, struct.pack("<H", 5) + b"test\0" + struct.pack("<I", 100)) + chunk(0xB008, struct.pack("<II", 0, 100))
    return chunk(0x4D4D, chunk(0x0002, struct.pack("<I", 3)) + chunk(0x3D3D, chunk(0x3D3E, struct.pack("<I", 3)))
                 + chunk(0xB000, header + chunk(0xB002, node)))


def near(got, want, what):
    size = max(1, *map(abs, want))
    if max(abs(a - b) for a, b in zip(got, want, strict=True)) > 4e-6 * size:
        failures.append(f"{what}: {got}, lib3ds has {want}")


with tempfile.TemporaryDirectory() as folder:
    file = Path(folder) / "a.3ds"
    for case in range(cases):
        frames = {name: frames_of() for name in ("position", "rotation", "scale")}
        file.write_bytes(file_of("Box", frames))
        last = max(f[-1] for f in frames.values())
        all_frames = [str(i) for i in range(last + 1)]
        theirs = {}
        for row in csv.reader(io.StringIO(subprocess.run([evaluate, str(file), *all_frames], capture_output=True, text=True,
                                                         check=True).stdout)):
            theirs[row[1], int(row[2])] = [float(x) for x in row[3:]]
        for name in frames:
            done = subprocess.run([program, "-q", str(file), "--only", f"Box/{name}", "--step", "1", "--rotation-output",
                                   "quaternion"] if name == "rotation" else
                                  [program, "-q", str(file), "--only", f"Box/{name}", "--step", "1"],
                                  capture_output=True, text=True)
            if done.returncode:
                failures.append(done.stderr)
                continue
            for row in csv.DictReader(io.StringIO(done.stdout)):
                columns = [c for c in row if c not in ("object", "track", "frame")]
                got, want = [float(row[c]) for c in columns], theirs[name, int(row["frame"])]
                if name == "rotation" and sum(a * b for a, b in zip(got, want)) < 0:
                    want = [-x for x in want]
                near(got, want, f"case {case}: {name} at {row['frame']}, keys at {frames[name]}")
for failure in failures[:6]:
    print(failure, file=sys.stderr)
print(f"{cases} files, {len(failures)} differences")
sys.exit(1 if failures else 0)
