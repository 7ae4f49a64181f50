"""The output of every mode, with any options, checks as equal to its keys: own_output.py PROGRAM [RUNS] [SEED].

Random keys, rules, modes, fields and formats. Commands that the program rejects are counted, not compared; most must
be accepted. Rows placed by length are compared at their lengths, because their times are rounded. Exit 1: a check
failed, and its command is printed.
"""
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

program = os.path.abspath(sys.argv[1])
runs = int(sys.argv[2]) if len(sys.argv) > 2 else 150
seed = int(sys.argv[3]) if len(sys.argv) > 3 else 20260101
rng = random.Random(seed)
pick, chance = rng.choice, lambda p: rng.random() < p

presets = ["tcb", "gte", "fbx", "gte2021", "wildmagic", "lightwave", "vtk", "gamebryo", "idtech4", "lib3ds1", "lib3ds2",
           "splines", "synfig", "kb1984", "wikipedia", "ogre", "3dsmax", "nel", "cryengine"]
tangents = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]
ends = ["half", "one-sided", "mirror", "chord", "zero", "natural", "natural-tension", "cry", "lightwave"]
local = ["velocity", "acceleration", "jerk", "speed", "tangent", "curvature", "torsion", "segment", "u", "key"]


def decimal(value, digits):
    """A rational with that many decimals, as text."""
    scaled = value * 10 ** digits
    whole = str(abs(scaled.numerator // scaled.denominator)).rjust(digits + 1, "0")
    return ("-" if value < 0 else "") + (whole[:-digits] + "." + whole[-digits:] if digits else whole)


def times(count):
    """Increasing times as exact numbers, and their texts."""
    style = pick(["whole", "short", "double", "long", "nanoseconds", "large", "tiny", "negative"])
    t, all_times = {"whole": Fraction(rng.randint(-9, 9)), "short": Fraction(rng.randint(-99, 99), 10),
                    "double": Fraction(rng.uniform(-9, 9)), "long": Fraction(1403637576252524268, 10 ** 9),
                    "nanoseconds": Fraction(1403637576252524268), "large": Fraction(10 ** 28),
                    "tiny": Fraction(rng.randint(0, 9), 10 ** 300), "negative": Fraction(-rng.randint(9, 99))}[style], []
    for _ in range(count):
        all_times.append(t)
        t += {"whole": Fraction(rng.randint(1, 4)), "short": Fraction(rng.randint(1, 30), 10),
              "double": Fraction(rng.uniform(0.01, 3)), "long": Fraction(rng.randint(10 ** 7, 10 ** 10), 10 ** 9),
              "nanoseconds": Fraction(rng.randint(10 ** 7, 10 ** 10)), "large": Fraction(rng.randint(1, 10 ** 28)),
              "tiny": Fraction(rng.randint(1, 99), 10 ** 300), "negative": Fraction(rng.randint(1, 99), 4)}[style]
    if style == "double":
        all_times = [Fraction(float(t)) for t in all_times]
        return all_times, [repr(float(t)) for t in all_times]
    if style == "tiny":
        return all_times, [f"{(t * 10 ** 300).numerator}e-300" for t in all_times]
    digits = {"short": 1, "long": 9, "negative": 2}.get(style, 0)
    return all_times, [decimal(t, digits) for t in all_times]


def have_few_digits(times):
    """Whether doubles hold the times: those of more than 17 digits are rounded by --digits."""
    return all(t.denominator == 1 and abs(t) < 2 ** 53 or Fraction(float(t)) == t or abs(t) < 1000 for t in times)


class Case:
    """Keys, the options of their curve, and those of its samples."""

    def __init__(self):
        self.channels, self.named, self.group = rng.randint(1, 3), chance(0.8), chance(0.2)
        count = pick([1, 2, 2, 3, 4, 5, 7])
        self.times, texts = times(count)
        self.curve, self.samples, self.fields = [], [], []
        self.rules()
        self.columns()
        curves = [pick(["a", "b-c", "7"]) + str(i) for i in range(rng.randint(1, 3))] if self.group else [""]
        rows = [(label, cells) for label in curves for cells in self.keys(texts)]
        if self.group and chance(0.5):  # in any order between curves
            rows.sort(key=lambda row: self.times[0] + texts.index(row[1][0]))
            rows.sort(key=lambda row: texts.index(row[1][0]))
        lines = [self.names] if self.named else []
        lines += [([label] if self.group else []) + cells for label, cells in rows]
        delimiter = pick([",", ",", ";", "\t"])
        self.text = "".join(delimiter.join(line) + "\n" for line in lines)
        self.sampling()

    def rules(self):
        if chance(0.6):
            self.curve += ["--preset", pick(presets)]
        if chance(0.2):
            self.curve += ["--tangents", pick(tangents)]
        self.closed = pick([None] * 4 + ["repeat", "period"])
        if self.closed == "repeat":
            self.curve += ["--closed"]
        elif self.closed == "period":
            self.curve += ["--period", decimal(self.times[-1] - self.times[0] + Fraction(5, 4), 9)]
        elif chance(0.2):
            self.curve += ["--ends", pick(ends) + "," + pick(ends)]
        if chance(0.15):
            self.curve += ["--equal-speed"]
        if chance(0.2):
            self.curve += ["--tcb", ",".join(str(rng.randint(-10, 10) / 10) for _ in range(3))]
        if self.group:
            self.curve += ["--group", "1"]
        self.missing = chance(0.15)
        if self.missing:
            self.curve += ["--missing", "skip-cell"]

    def columns(self):
        self.with_tcb, self.with_ease = self.named and chance(0.5), self.named and chance(0.15)
        self.names = (["joint"] if self.group else []) + [pick(["t", "time", "timestamp"])] + ["x", "y", "z"][:self.channels]
        self.names += ["tension", "continuity", "bias"] if self.with_tcb else []
        self.names += ["ease_in", "ease_out"] if self.with_ease else []

    def keys(self, texts):
        size = pick([1, 1, 10, 1000, 1e150, 1e-150])
        style = pick(["whole", "double", "hold"])
        number = lambda: repr(rng.uniform(-size, size)) if style == "double" else repr(rng.randint(-3, 3) * size)
        rows = []
        for text in texts:
            row = [number() for _ in range(self.channels)]
            if style == "hold" and rows and chance(0.4):
                row = rows[-1][1:1 + self.channels]
            if self.missing and chance(0.2):
                row[rng.randrange(self.channels)] = ""
            row += [pick(["0", "1", "-1", repr(round(rng.uniform(-1, 1), 2))]) for _ in range(3 if self.with_tcb else 0)]
            row += [repr(round(rng.random() / 2, 2)) for _ in range(2 if self.with_ease else 0)]
            rows.append([text, *row])
        if self.closed == "repeat" and len(rows) > 2:
            rows[-1] = [rows[-1][0], *rows[0][1:]]
        return rows

    def place(self, outside=0):
        """A time on the curve, or a little off it, as text."""
        first, length = self.times[0], max(self.times[-1] - self.times[0], Fraction(1, 100))
        place = first + length * Fraction(rng.randint(-int(1000 * outside), int(1000 * (1 + outside))), 1000)
        return f"{place.numerator}/{place.denominator}" if place.denominator > 1 else str(place.numerator)

    def step(self):
        length = max(self.times[-1] - self.times[0], Fraction(1, 10 ** 300)) / rng.randint(1, 40)
        if chance(0.5):
            length = length * rng.randint(10, 99) / 50
        return f"{length.numerator}/{length.denominator}"

    def sampling(self):
        lengths = pick(["0.5", "1", "3/7", "100", "1e-3", "1e149", "1e-151"])
        mode = pick(["step", "count", "per-segment", "at", "arc-step", "arc-count", "arc-at", "tolerance"])
        if mode == "tolerance" and self.channels == 1 and self.with_ease:  # the bound tightens slowly: seconds
            mode = "count"
        self.by_length = mode.startswith("arc")
        value = {"step": self.step, "at": lambda: ",".join(self.place() for _ in range(rng.randint(1, 9))),
                 "arc-step": lambda: lengths, "arc-at": lambda: ",".join(["0", lengths, "0.1"][:rng.randint(1, 3)]),
                 "tolerance": lambda: pick(["0.1", "0.01", "1", "1e148", "1e-152"])}
        if mode == "at" and chance(0.4):
            rules = [pick(["hold", "linear", "repeat", "offset", "oscillate"]) for _ in range(rng.randint(1, 2))]
            self.curve += ["--extrapolate", ",".join(rules)]
            value["at"] = lambda: ",".join(self.place(2) for _ in range(rng.randint(1, 9)))
        self.samples = [f"--{mode}={value.get(mode, lambda: str(rng.randint(1, 30)))()}", "--max-rows", "400"]
        if mode in ("step", "arc-step") and chance(0.6):
            self.samples += ["--end", pick(["drop", "keep", "fit", "fit-down", "fit-up"])]
        if mode in ("step", "count", "arc-step", "arc-count") and chance(0.2):
            self.samples += ["--keys"]
        if mode in ("step", "count") and chance(0.2):
            low, high = sorted([self.place(), self.place()], key=Fraction)
            self.samples += [f"--from={low}", f"--to={high}"]
        self.output()

    def output(self):
        self.format = pick(["csv", "csv", "tsv", "ssv", "json", "jsonl"])
        self.samples += ["-f", self.format]
        short = have_few_digits(self.times)
        self.samples += pick([[], [], ["--hex"] if self.format in ("csv", "tsv", "ssv") else [],
                              ["--digits", "17"] if short else []])
        self.samples += ["--meta"] if chance(0.1) else []
        header = self.format in ("csv", "tsv", "ssv") and self.named and chance(0.15)
        self.samples += ["--no-output-header"] if header else []
        if self.by_length or chance(0.5):
            named = self.named and not header or self.format.startswith("json")
            places = (["s", "time"] if named and chance(0.4) else ["s"]) if self.by_length else ["time"]
            others = rng.sample(local, rng.randint(0, 4)) + (["s"] if not self.by_length and chance(0.2) else [])
            chosen = places + ["position"] + others
            if self.by_length and "--keys" in self.samples:  # the keys of a hold have one length
                chosen = ["s", "position"]
            rng.shuffle(chosen)
            self.fields = chosen
        if self.fields and any(field in local for field in self.fields) and chance(0.2):
            self.curve += ["--side", "left"]

    def run(self, folder):
        """Runs the program and checks its output: whether it was accepted, and the report of a failure."""
        keys, rows = os.path.join(folder, "keys.csv"), os.path.join(folder, "rows." + self.format)
        with open(keys, "w", encoding="ascii") as file:
            file.write(self.text)
        sampled = [program, *self.curve, *self.samples, *(["--fields", ",".join(self.fields)] if self.fields else []), keys]
        with open(rows, "w", encoding="ascii") as file:
            try:
                status = subprocess.run(sampled, stdout=file, stderr=subprocess.PIPE, text=True, timeout=60)
            except subprocess.TimeoutExpired:
                return True, f"{sampled}\n{self.text}\ntakes more than a minute\n"
        if status.returncode not in (0, 1, 2):
            return True, f"{sampled}\n{self.text}\n{status.stderr}exit code {status.returncode}\n"
        if status.returncode != 0:
            return False, ""
        fields = self.fields
        if self.by_length:
            fields = [field for field in fields if field != "time"]
        checked = [program, "--check", rows, *self.curve, *(["--fields", ",".join(fields)] if fields else []), keys]
        report = subprocess.run(checked, capture_output=True, text=True, timeout=60)
        if report.returncode == 0:
            return True, ""
        told = (report.stdout + report.stderr).splitlines()[:9]
        with open(rows, encoding="ascii") as file:
            beginning = file.read(800)
        return True, "\n".join([" ".join(sampled), " ".join(checked), self.text, beginning, *told]) + "\n"


accepted = failed = 0
with tempfile.TemporaryDirectory() as folder:
    for number in range(runs):
        was_accepted, failure = Case().run(folder)
        accepted += was_accepted
        failed += failure != ""
        if failure and failed <= 20:
            print(f"run {number}:\n{failure}")
print(f"{runs} runs, {accepted} accepted, {failed} failed")
sys.exit(1 if failed or 2 * accepted < runs else 0)
