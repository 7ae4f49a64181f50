"""Times poses: rotations.py PROGRAM RECORDING [ROWS [ROUNDS]]. A recording in the format of TUM.

Each contender first runs once, and its rows are counted; those of slerp must be SciPy's rotations to 1e-6: doubles
of times since 1970 leave no more. Then all run in turn; the minimum time of each is shown, and the ratio to the first.
"""

import pathlib
import subprocess
import sys
import time

program, recording = sys.argv[1], sys.argv[2]
count = sys.argv[3] if len(sys.argv) > 3 else "200000"
rounds = int(sys.argv[4]) if len(sys.argv) > 4 else 7
script = str(pathlib.Path(__file__).with_name("scipy_rotations.py"))
work = [program, "-q", "-j", "1", "--count", count]
contenders = {
    "positions and a quaternion, squad": [*work, recording],
    "casteljau": [*work, "--rotation-curve", "casteljau", recording],
    "components": [*work, "--rotation-curve", "components", recording],
    "slerp": [*work, "--rotation-curve", "slerp", recording],
    "seven plain channels": [*work, "--rotation", "none", recording],
}
for python in ("python3", "/usr/bin/python3"):
    if subprocess.run([python, "-c", "import scipy"], capture_output=True).returncode == 0:
        contenders["SciPy, Slerp"] = [python, script, "slerp", count, recording]
        contenders["SciPy, RotationSpline"] = [python, script, "spline", count, recording]
        break
else:
    print("left out: SciPy (not installed)", file=sys.stderr)


def rows(command):
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()[1:]
    if len(lines) != int(count):
        sys.exit(f"{command}: {len(lines)} rows")
    return [list(map(float, line.split(","))) for line in lines]


made = {name: rows(command) for name, command in contenders.items()}
if "SciPy, Slerp" in made:
    worst = 0
    for row, other in zip(made["slerp"], made["SciPy, Slerp"]):
        sign = 1 if sum(a * b for a, b in zip(row[4:], other[4:])) > 0 else -1
        worst = max(worst, *(abs(a - sign * b) for a, b in zip(row[4:], other[4:])))
    print(f"slerp and SciPy's Slerp differ by {worst:.2g}")
    if worst > 1e-6:
        sys.exit("they draw different curves")
best = dict.fromkeys(contenders, float("inf"))
for _ in range(rounds):
    for name, command in contenders.items():
        begin = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        best[name] = min(best[name], time.perf_counter() - begin)
first = next(iter(best.values()))
for name, seconds in best.items():
    print(f"{name:36} {seconds * 1e3:9.1f} ms {seconds / int(count) * 1e9:9.0f} ns a row {seconds / first:8.2f}")
