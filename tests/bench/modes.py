#!/usr/bin/env python3
"""Times modes of the program beside each other and prints a table: modes.py PROGRAM [ROWS [ROUNDS]].

There are ten rows per key and four numbers per row, on one thread; the tolerance needs about as many rows. On two threads
--fit reads as many samples as the others write rows, with a tolerance of five standard deviations of their noise, and
the rows of --count are compressed. Each time is the minimum of all rounds. The last columns are those of the largest work: the time of a row, the ratio to
that of --count on as many threads, and the peak of memory.
"""
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

NOISE = 0.002

MODES = (
    ("`--count`", []),
    ("`--golden`", ["--golden"]),
    ("`--golden --digits 17`", ["--golden", "--digits", "17"]),
    ("`--golden --exact-input`", ["--golden", "--exact-input"]),
    ("`--golden`, velocity", ["--golden", "--fields", "time,velocity"]),
    ("`--golden`, curvature, torsion", ["--golden", "--fields", "time,curvature,torsion"]),
    ("`--golden`, s", ["--golden", "--fields", "time,s"]),
    ("`--tolerance`", ["--tolerance", "0.0019"]),
    ("`--count`, two threads", []),
    ("`--fit`, two threads", ["--fit", str(5 * NOISE)]),
    ("`-o rows.csv`, two threads", ["-o", "rows.csv"]),
    ("`-o rows.csv.gz`, two threads", ["-o", "rows.csv.gz"]),
    ("`-o rows.csv.zst`, two threads", ["-o", "rows.csv.zst"]),
)
ON_TWO_THREADS = {name for name, _ in MODES if name.endswith("two threads")}


def write_keys(path, keys):
    """Keys at tenths of a unit of time, with positions that random walks give and any tension, continuity and bias."""
    rng = random.Random(1)
    x = y = z = 0.0
    with open(path, "w") as out:
        out.write("t,x,y,z,tension,continuity,bias\n")
        for i in range(keys):
            x, y, z = x + rng.gauss(0, 1), y + rng.gauss(0, 1), z + rng.gauss(0, 1)
            parameters = ",".join(f"{rng.uniform(-1, 1):.3f}" for _ in range(3))
            out.write(f"{i / 10},{x:.6f},{y:.6f},{z:.6f},{parameters}\n")


def write_samples(path, samples):
    """Samples at hundredths of a unit of time, of sums of sines with noise."""
    rng = random.Random(1)
    sines = [[(rng.gauss(0, 1), rng.uniform(0.01, 0.5) * math.tau, rng.uniform(0, 6)) for _ in range(5)] for _ in "xyz"]
    with open(path, "w") as out:
        out.write("t,x,y,z\n")
        for i in range(samples):
            t = i / 100
            position = [sum(a * math.sin(f * t + p) for a, f, p in channel) + rng.gauss(0, NOISE) for channel in sines]
            out.write(f"{t:.2f}," + ",".join(f"{x:.6f}" for x in position) + "\n")


def run(command, folder):
    """Returns seconds and the peak of memory in MiB."""
    start = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, cwd=folder)
    _, status, usage = os.wait4(process.pid, 0)
    assert status == 0, command
    return time.perf_counter() - start, usage.ru_maxrss / 1024


def arguments(name, options, rows):
    threads = "2" if name in ON_TWO_THREADS else "1"
    sampling = [] if options[:1] in (["--fit"], ["--tolerance"]) else ["--count", str(rows)]
    keys = f"{rows}-samples.csv" if options[:1] == ["--fit"] else f"{rows}-keys.csv"
    return ["-q", "-j", threads, *sampling, *options, keys]


def main(program, rows="1000 10000 100000 1000000", rounds="5"):
    program = pathlib.Path(program).resolve()
    sizes = [int(float(size)) for size in rows.split()]
    times, peaks = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        for size in sizes:
            write_keys(pathlib.Path(folder, f"{size}-keys.csv"), size // 10)
            write_samples(pathlib.Path(folder, f"{size}-samples.csv"), size)
            for _ in range(int(rounds)):
                for name, options in MODES:
                    seconds, peaks[name] = run([program, *arguments(name, options, size)], folder)
                    times[name, size] = min(seconds, times.get((name, size), math.inf))
    print("| mode | " + " | ".join(f"{size:,} rows" for size in sizes) + " | a row | ratio | memory |")
    print("|---|" + "---:|" * (len(sizes) + 3))
    for name, _ in MODES:
        plain = "`--count`, two threads" if name in ON_TWO_THREADS else "`--count`"
        cells = [f"{times[name, size] * 1e3:,.1f} ms" for size in sizes]
        last = times[name, sizes[-1]]
        cells += [f"{last / sizes[-1] * 1e9:,.0f} ns", f"{last / times[plain, sizes[-1]]:.1f}"]
        cells += [f"{peaks[name]:.0f} MiB"]
        print(f"| {name} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main(*sys.argv[1:])
