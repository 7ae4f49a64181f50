"""Prints the tables of a comparison from its measurements: report.py DIR, where compare wrote them.

A line a contender: the minimum time of all runs at every number of rows, and at the largest also the time of a row and
the peak memory. Other work on the machine makes times longer, never shorter, so minimum times compare best.
"""
import json
import pathlib
import statistics
import sys

folder = pathlib.Path(sys.argv[1])
titles = {"uniform": "at equal steps of time", "arc": "at equal arc lengths"}


class Run:
    """One contender at one number of rows, from its result in each round. Units: seconds, MiB."""

    def __init__(self, results, memory):
        times = [time for result in results for time in result["times"]]
        self.time, self.mean = min(times), statistics.mean(times)
        self.processor = statistics.mean(result["user"] + result["system"] for result in results)
        self.memory = int(memory[results[0]["command"]]) / 1024


def runs_of(mode):
    """The runs of a mode, by number of rows and by contender."""
    runs = {}
    for path in folder.glob(mode + "-*.memory"):
        memory = dict(line.split("\t") for line in path.read_text().splitlines())
        rounds = [json.loads(each.read_text())["results"] for each in sorted(folder.glob(path.stem + "-*.json"))]
        of_all = [Run(results, memory) for results in zip(*rounds)]
        runs[int(path.stem.split("-")[1])] = dict(zip(memory, of_all, strict=True))
    return dict(sorted(runs.items()))


def digits(value):
    """Three digits."""
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def duration(seconds):
    return f"{digits(seconds)} s" if seconds >= 1 else f"{digits(seconds * 1e3)} ms"


def table(title, runs):
    print(f"| {title} | " + " | ".join(f"{rows:,} rows" for rows in runs) + " | a row | peak memory |")
    print("|---|" + "---:|" * (len(runs) + 2))
    for name in dict.fromkeys(name for size in runs.values() for name in size):
        cells = [duration(size[name].time) if name in size else "" for size in runs.values()]
        rows, last = list(runs.items())[-1]
        if name in last:
            cells += [f"{last[name].time / rows * 1e9:,.0f} ns", f"{digits(last[name].memory)} MiB"]
        print(f"| {name} | " + " | ".join(cells) + " |")
    print()


print((folder / "machine.txt").read_text())
for mode, title in titles.items():
    runs = runs_of(mode)
    table(title, runs)
    waits = [run.mean / run.processor for size in runs.values() for run in size.values() if run.time > 0.1]
    if waits and max(waits) > 1.25:  # the times then say little
        print(f"Other work ran on the machine: up to {max(waits):.1f} times as much time went by as was used.\n")
