#!/usr/bin/env python3
"""Makes the test vectors of this folder from keys.csv: make_vectors.py [FOLDER], by default this folder.

Needs only tcbsample, in PATH or in ../../build/release. The bytes are the same everywhere.
"""
import csv
import json
import os
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
CURVES = ["even", "uneven", "corner", "inside", "beyond", "pair", "plane", "space", "closed"]
TURNS = ["turns", "turn", "round"]
# Presets whose products have rotations.
PRESETS_OF_ROTATIONS = ["gte", "vtk", "3dsmax", "nel", "cryengine", "lib3ds1", "lib3ds2", "splines"]
# Presets where u is not linear in time, as the vectors have it.
PRESETS_WITH_TIMING = ["nerfstudio"]
VELOCITIES = ["0.5", "-1", "0.25"]  # of the end rule velocity, one per channel
PLACES = ["0.25", "0.625"]  # u of the positions: together with the keys they determine a cubic
LENGTHS = "0.5,1.25,2.75"


class Curve:
    """A curve of keys.csv with its rules, and the rows expected of each quantity."""

    def __init__(self, keys, **settings):
        closed, self.channels, self.keys = KEYS[keys]
        if closed:
            settings.pop("ends", None)
        self.id = "+".join(settings.values()) + "/" + keys
        if settings.get("ends") == "velocity":
            settings["ends"] += "=" + ":".join(VELOCITIES[:self.channels])
        self.settings = {"id": self.id, **settings, "closed": closed}
        self.expected = {}

    def begin(self, **more):
        """The JSON object without what is expected and without its end."""
        return compact({**self.settings, **more})[:-1] + ',"keys":[\n' + ",\n".join(self.keys) + "]"

    def expect(self, quantity, at, values):
        self.expected.setdefault(quantity, []).append((at, values))


def compact(value):
    return json.dumps(value, separators=(",", ":"))


def read_keys():
    """For each curve of keys.csv: whether it is closed, its number of channels, and its keys in JSON."""
    curves = {}
    with open(HERE / "keys.csv", newline="") as file:
        for name, closed, time, *cells in list(csv.reader(file))[1:]:
            ease = f',"ease_in":{cells[3]},"ease_out":{cells[4]}' if name == "ease" else ""
            numbers = cells[5:]
            member = "rotation" if len(numbers) == 4 else "position"
            key = f'{{"time":{time},"{member}":[{",".join(numbers)}],"tcb":[{",".join(cells[:3])}]{ease}}}'
            curves.setdefault(name, (closed == "1", len(numbers), []))[2].append(key)
    return curves


def run(*options, text=""):
    done = subprocess.run(["tcbsample", *options], input=text, text=True, capture_output=True)
    if done.returncode != 0:
        sys.exit(done.stderr)
    return done.stdout


def rows(curves, *options):
    """Rows of curves that have the same number of channels, each number correctly rounded; with the row's curve."""
    by_id = {curve.id: curve for curve in curves}
    text = '{"curves":[' + ",\n".join(curve.begin() + "}" for curve in curves) + "]}"
    for row in csv.DictReader(run("--golden", "-i", "json", *options, text=text).splitlines()):
        yield row, by_id[row["id"]]


def expect_positions(curves, names, *options):
    """Positions inside each segment, and the velocities into and out of its keys."""
    velocity = [name + "_v" for name in names]
    options = ["--per-segment", "8", "--fields", "u,time,position,velocity", *options]
    for row, curve in rows(curves, *options):
        if row["u"] in PLACES:
            curve.expect("position", row["time"], [row[name] for name in names])
        elif row["u"] == "0":
            curve.expect("outgoing", row["time"], [row[name] for name in velocity])
    for row, curve in rows(curves, *options, "--side", "left"):
        if row["u"] == "1":
            curve.expect("incoming", row["time"], [row[name] for name in velocity])


def expect_lengths(curves, names, *options):
    """The arc length at times, and the time and the position at arc lengths."""
    for row, curve in rows(curves, "--per-segment", "2", "--fields", "time,s", *options):
        curve.expect("length", row["time"], [row["s"]])
    for row, curve in rows(curves, "--arc-at", LENGTHS, "--fields", "s,time,position", *options):
        curve.expect("arc_time", row["s"], [row["time"]])
        curve.expect("arc_position", row["s"], [row[name] for name in names])


def expect_rotations(curves, names, *options):
    """Rotations inside each segment with their angular velocities, and those into and out of its keys."""
    velocity = ["angular_velocity_" + axis for axis in "xyz"]
    options = ["--per-segment", "8", "--fields", "u,time,position,angular_velocity", *options]
    for row, curve in rows(curves, *options):
        rates = [row[name] for name in velocity]
        if row["u"] in PLACES:
            curve.expect("rotation", row["time"], [row[name] for name in names])
            curve.expect("angular_velocity", row["time"], rates)
        elif row["u"] == "0":
            curve.expect("outgoing", row["time"], rates)
    for row, curve in rows(curves, *options, "--side", "left"):
        if row["u"] == "1":
            curve.expect("incoming", row["time"], [row[name] for name in velocity])


def expect(how, curves, *options):
    for names in ["x"], ["x", "y"], ["x", "y", "z"], ["qx", "qy", "qz", "qw"]:
        group = [curve for curve in curves if curve.channels == len(names)]
        if group:
            how(group, names, *options)
    return curves


def hexadecimal(value):
    return re.sub(r"\.?0+p", "p", float(value).hex())


def write(path, curves, **settings):
    """The curves as JSON, with settings that are options of the program, and what is expected as CSV."""
    blocks, lines = [], ["id,quantity,at,channel,value,hex"]
    for curve in curves:
        block = curve.begin(**settings)
        for quantity, expected in curve.expected.items():
            block += f',\n"{quantity}":[\n' + ",\n".join(
                f'{{"at":{at},"value":[{",".join(values)}],"hex":{compact([*map(hexadecimal, values)])}}}'
                for at, values in expected) + "]"
            lines += [f"{curve.id},{quantity},{at},{channel},{value},{hexadecimal(value)}"
                      for at, values in expected for channel, value in enumerate(values)]
        blocks.append(block + "}")
    path.parent.mkdir(parents=True, exist_ok=True)
    head = '{"format":"tcb-vectors 1","license":"CC0-1.0","curves":[\n'
    path.with_suffix(".json").write_text(head + ",\n".join(blocks) + "]}\n", newline="\n")
    path.with_suffix(".csv").write_text("\n".join(lines) + "\n", newline="\n")


def names_of_rules():
    """The names of presets, tangent rules and end rules, from the program's own lists: words that begin a line."""
    parts = re.split(r"^(?=PRESET|TANGENTS|ENDS|CURVES)", run("--list-presets"), flags=re.M)[1:4]
    presets, tangents, ends = (re.findall(r"^[a-z0-9-]+(?=\s)", part, flags=re.M) for part in parts)
    return presets, tangents, sorted(ends, key=lambda end: end != "half")  # in the order of the published files


def make(folder):
    presets, tangents, ends = names_of_rules()
    for preset in presets:
        if preset in PRESETS_WITH_TIMING:
            continue
        curves = [Curve(keys, preset=preset) for keys in CURVES]
        write(folder / "presets" / preset, expect(expect_positions, curves))
    for rule in tangents:
        curves = [Curve(keys, tangents=rule, ends=end) for end in ends for keys in ("pair", "plane")]
        if rule == "linear":  # whose ends are chords
            curves = [Curve(keys, tangents=rule) for keys in ("pair", "plane")]
        curves += [Curve(keys, tangents=rule) for keys in ("closed", "ring")]
        write(folder / "tangents" / rule, expect(expect_positions, curves))
    tangents.remove("linear")  # which has one speed on each line, and turns by slerp
    curves = [Curve("ease", preset=preset) for preset in ("3dsmax", "nel", "cryengine")]
    write(folder / "ease", expect(expect_positions, curves))
    curves = [Curve(keys, tangents=rule, ends="half")
              for rule in tangents for keys in ("plane", "closed")]
    write(folder / "equal_speed", expect(expect_positions, curves, "--equal-speed"), equal_speed=True)
    curves = [Curve(keys, preset=preset)
              for preset in ("gte", "vtk") for keys in ("corner", "plane", "space", "closed", "cusp")]
    write(folder / "length", expect(expect_lengths, curves))
    curves = [Curve(keys, preset=preset) for preset in PRESETS_OF_ROTATIONS for keys in TURNS]
    write(folder / "rotations" / "presets", expect(expect_rotations, curves))
    write(folder / "rotations" / "slerp",
          expect(expect_rotations, [Curve(keys, preset="gte") for keys in TURNS], "--rotation-curve", "slerp"),
          rotation_curve="slerp")
    for name in "squad", "casteljau", "components":
        curves = [Curve(keys, tangents="velocity", ends=end)
                  for end in ends if end != "velocity" for keys in ("turns", "turn")]
        curves += [Curve(keys, tangents=rule, ends="half") for rule in tangents for keys in ("turns", "round")
                   if (rule, keys) != ("velocity", "turns")]  # which is among the ends
        write(folder / "rotations" / name, expect(expect_rotations, curves, "--rotation-curve", name),
              rotation_curve=name)


os.environ["PATH"] += os.pathsep + str(HERE / "../../build/release")
KEYS = read_keys()
make(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)
