#!/usr/bin/env python3
"""Times modes of the program on the same keys, on one thread, and prints a table: modes.py PROGRAM [ROWS [ROUNDS]].

Ten rows per key, four numbers per row, written to /dev/null; a tolerance that needs about as many.
Each time is the minimum of all rounds; the last column is
the ratio of the largest work to that of --count.
"""
import pathlib
import random
import subprocess
import sys
import tempfile
import time

MODES = (
    ("`--count`", []),
    ("`--golden`", ["--golden"]),
    ("`--golden --digits 17`", ["--golden", "--digits", "17"]),
    ("`--golden --exact-input`", ["--golden", "--exact-input"]),
    ("`--tolerance`", ["--tolerance"]),
    ("`--golden`, velocity", ["--golden", "--fields", "time,velocity"]),
    ("`--golden`, curvature, torsion", ["--golden", "--fields", "time,curvature,torsion"]),
    ("`--golden`, s", ["--golden", "--fields", "time,s"]),
)


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


def seconds(command):
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def main(program, rows="1000 10000 100000 1000000", rounds="5"):
    sizes = [int(float(size)) for size in rows.split()]
    times = {}
    with tempfile.TemporaryDirectory() as folder:
        for size in sizes:
            path = pathlib.Path(folder, f"{size}.csv")
            write_keys(path, size // 10)
            for _ in range(int(rounds)):
                for name, options in MODES:
                    sampling = ["--tolerance", "0.0019"] if options == ["--tolerance"] else ["--count", str(size), *options]
                    command = [program, "-q", "-j", "1", *sampling, str(path)]
                    times[name, size] = min(seconds(command), times.get((name, size), float("inf")))
    print("| mode | " + " | ".join(f"{size:,} rows" for size in sizes) + " | a row | ratio |")
    print("|---|" + "---:|" * (len(sizes) + 2))
    for name, _ in MODES:
        cells = [f"{times[name, size] * 1e3:,.1f} ms" for size in sizes]
        last = times[name, sizes[-1]]
        cells += [f"{last / sizes[-1] * 1e9:,.0f} ns", f"{last / times[MODES[0][0], sizes[-1]]:.1f}"]
        print(f"| {name} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main(*sys.argv[1:])
