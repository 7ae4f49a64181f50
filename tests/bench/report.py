"""Makes the tables and the plot data of a comparison from its measurements: report.py DIR, where compare wrote them.

table.md has every number: the minimum time of all runs, the standard deviation of their times, time per row, processor
time, peak memory. Other work on the machine makes times longer, never shorter, so minimum times compare best.
summary.md has one line per contender, for a README. uniform.dat and arc.dat are the data for plot.gnuplot, one block
per contender.
"""

import json
import math
import pathlib
import statistics
import sys

folder = pathlib.Path(sys.argv[1])
titles = {"uniform": "Uniform in time: `tcbsample -n N`", "arc": "Uniform in arc length: `tcbsample --arc-count N`"}


class Run:
    """One contender at one number of rows, from its result in each round. Units: seconds, MiB."""

    def __init__(self, results, memory, rows):
        self.name = results[0]["command"]
        self.rows = rows
        times = [time for result in results for time in result["times"]]
        self.time, self.mean, self.deviation = min(times), statistics.mean(times), statistics.pstdev(times)
        self.processor = statistics.mean(result["user"] + result["system"] for result in results)
        self.memory = int(memory[self.name]) / 1024


def read(mode):
    """The runs of a mode, by number of rows."""
    runs = {}
    for path in folder.glob(mode + "-*.memory"):
        rows = int(path.stem.split("-")[1])
        memory = dict(line.split("\t")[:2] for line in path.read_text().splitlines())
        rounds = [json.loads(each.read_text())["results"] for each in sorted(folder.glob(path.stem + "-*.json"))]
        runs[rows] = [Run(results, memory, rows) for results in zip(*rounds)]
    return dict(sorted(runs.items()))


def digits(value):
    """Three significant digits, without an exponent."""
    return f"{value:,.{max(0, 2 - math.floor(math.log10(value)))}f}" if value > 0 else "0"


def duration(seconds):
    for factor, unit in ((1, "s"), (1e3, "ms")):
        if seconds * factor >= 1:
            return f"{digits(seconds * factor)} {unit}"
    return f"{seconds * 1e6:.0f} µs"


def per_row(run):
    return f"{run.time / run.rows * 1e9:,.0f} ns"


def markdown(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|---|" + "---:|" * (len(header) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def full_table(runs):
    header = ["contender", "rows", "least time", "deviation", "time a row", "processor time", "peak memory", "time / tcbsample"]
    rows = []
    for name in names(runs):
        for size in runs.values():
            for run in (run for run in size if run.name == name):
                rows.append([name, f"{run.rows:,}", duration(run.time), duration(run.deviation), per_row(run),
                             duration(run.processor), f"{digits(run.memory)} MiB", digits(run.time / size[0].time)])
    return markdown(header, rows)


def summary_table(runs):
    """A line a contender: its time at every number of rows; at the largest also time a row and peak memory."""
    header = ["", *(f"{rows:,} rows" for rows in runs), "a row", "peak memory"]
    rows = []
    for name in names(runs):
        found = [next((run for run in size if run.name == name), None) for size in runs.values()]
        last = found[-1]
        rows.append([name, *(duration(run.time) if run else "" for run in found),
                     *([per_row(last), f"{digits(last.memory)} MiB"] if last else ["", ""])])
    return markdown(header, rows)


def names(runs):
    return list(dict.fromkeys(run.name for size in runs.values() for run in size))


def ratios(runs):
    """The least time of tcbsample with one thread over that of the bare loop."""
    parts = []
    for rows, size in runs.items():
        bare = next((run for run in size if run.name == "bare loop"), None)
        if bare and size[0].name.startswith("tcbsample"):
            parts.append(f"{size[0].time / bare.time:.2f} at {rows:,} rows")
    if not parts:
        return ""
    what = "Time of tcbsample with one thread over that of the bare loop: "
    return what + ", ".join(parts) + ".\n"


def plot_data(runs):
    blocks = []
    for name in names(runs):
        points = [run for size in runs.values() for run in size if run.name == name]
        blocks.append(f'"{name}"\n' + "".join(f"{run.rows} {run.time} {run.memory}\n" for run in points))
    return "\n\n".join(blocks)


def busy(runs):
    """A warning where programs waited for the processor: their times then say little."""
    waits = [run.mean / run.processor for size in runs.values() for run in size if run.time > 0.1]
    if not waits or max(waits) < 1.25:
        return ""
    return f"**Other work ran on the machine: up to {max(waits):.1f} times as much time went by as was used.**\n"


machine, *versions = (folder / "machine.txt").read_text().splitlines()
head = f"On {machine} Versions: {'; '.join(versions)}.\n"
table, summary = [head], [head]
for mode, title in titles.items():
    runs = read(mode)
    if runs:
        table += [f"**{title}**\n", full_table(runs), ratios(runs), busy(runs)]
        summary += [f"**{title}**\n", summary_table(runs), ratios(runs), busy(runs)]
        (folder / f"{mode}.dat").write_text(plot_data(runs) + "\n")
(folder / "table.md").write_text("\n".join(part for part in table if part))
(folder / "summary.md").write_text("\n".join(part for part in summary if part))
