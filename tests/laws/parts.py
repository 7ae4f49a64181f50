"""Curves of one file, of groups and between gaps, are those of files of their own.

Rows of the same grid, at the same times and of the same segments are as each part alone has them, and so are the note on
gaps, a comparison with rows in gaps, and the refusal of a time in one."""
from fractions import Fraction

from keys import Keys
from law import check, lines, require, run, same, write


def law(rng):
    unit = Fraction(1, 8)
    keys = Keys(rng, "closed", [unit], rng.choice(["gaps", "gaps", "gaps groups", "groups"]), shortest=rng.choice([1, 2]))
    keys.times = [repr(float(Fraction(t))) for t in keys.times]
    times = list(map(Fraction, keys.times))
    gaps = [(times[cut - 1], times[cut]) for cut in keys.cuts[1:-1]]
    if gaps:  # the longest step that is no gap, or the longest that is shorter than all gaps
        steps = [b - a for a, b in zip(times, times[1:]) if (a, b) not in gaps]
        keys.gap = rng.choice([max(steps, default=unit), min(b - a for a, b in gaps) - unit])
    text, options, spans = keys.text(), keys.options(), list(zip(keys.cuts, keys.cuts[1:]))
    alone = [(keys.alone(c, part), times[first], times[last - 1]) for c in range(len(keys.labels))
             for part, (first, last) in enumerate(spans)]
    without_labels = lambda rows: [row[len(keys.labels) > 1:] for row in rows]

    def of_parts(places):
        """The rows of the parts at some of the times."""
        found = [[t for t in places if first <= t <= last] for _, first, last in alone]
        return [row for (part, _, _), inside in zip(alone, found) if inside for row in
                lines(part.text(), *part.options(), "--at", ",".join(str(float(t)) for t in inside))]

    step = Fraction(rng.randint(1, 24), 8) * (1 + int((times[-1] - times[0]) / 40))
    grid = [times[0] + j * step for j in range(int((times[-1] - times[0]) / step) + 1)]
    done, expected = run(text, *options, "--step", str(float(step))), of_parts(grid)
    same(without_labels(row.split(",") for row in done.stdout.splitlines()[1:] if row), expected, "rows at steps")
    sizes = [sum(first <= t <= last for t in grid) for _, first, last in alone]
    if len(keys.labels) == 1:
        same([block.count("\n") + 1 for block in done.stdout.strip().split("\n", 1)[1].split("\n\n")], [n for n in sizes if n],
             "rows of a part together")
    count, largest = len(gaps) * len(keys.labels), max((b - a for a, b in gaps), default=0)
    said = f"{count} gap{'s'[:count > 1]} between keys begin{'s'[:count == 1]} a new curve; the largest is {float(largest):g}\n"
    require(said in done.stderr if gaps else "the largest is" not in done.stderr, f"the note {said}: {done.stderr}")

    inside = sorted(rng.choice([t for t in grid if first <= t <= last] or [first]) for _, first, last in alone[:len(spans)])
    same(without_labels(lines(text, *options, "--at", ",".join(str(float(t)) for t in inside))), of_parts(inside), "rows at times")
    if all(last - first > 1 for first, last in spans):
        pieces = keys.rotations and keys.rotation_curve != "components" or keys.ease
        for form in (["--per-segment", str(rng.randint(1, 4))], ["--emit", "hermite"])[:1 if pieces else 2]:
            rows = [row for part, _, _ in alone for row in lines(part.text(), *part.options(), *form)]
            same(without_labels(lines(text, *options, *form)), rows, f"rows of {form[0]}")

    outside = [(2 * a + b) / 3 for a, b in gaps]
    if outside:
        a, b = gaps[0]
        words = run(text, *options, f"--at={float(outside[0])}", codes=(1, 2)).stderr
        require(f"is in the gap from {float(a):g} to {float(b):g};" in words, f"the gap of a time: {words}")
    if outside and len(keys.labels) == 1 and not keys.rotations:
        rows = [",".join(["t", *keys.channels]), *map(",".join, expected)]
        write("rows", "\n".join([*rows, *(",".join([str(float(t)), *"0" * len(keys.channels)]) for t in outside)]) + "\n")
        report = run(text, *options, "--check", "rows", codes=(1,)).stdout
        counts = [int(line.split(": ")[2].split(";")[0]) for line in report.splitlines() if "rows outside" in line]
        require(sum(counts) == len(outside) and f"\nrows: {len(expected)}\n" in report and "\nmismatches: 0\n" in report,
                f"a comparison with {len(outside)} rows in gaps: {report}")


check(law, 15, least=3)
