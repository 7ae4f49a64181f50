"""The published test vectors against arithmetic of 45 digits: exact.py FOLDER FILE.json...

Every number is computed again by the independent implementation of laws/curves.py, from the decimals of the keys,
and has to be correctly rounded. The decimals are the shortest, the hexadecimal numbers and the CSV file beside the
JSON file say the same, and the keys are those of keys.csv. Exit 77: there is no mpmath.
"""
import csv
import json
import sys
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "laws"))
try:
    from mpmath import mp, mpf
except ImportError:
    print("skipped: there is no python3-mpmath")
    sys.exit(77)
import quaternions  # noqa: E402
from curves import MeasuredCurve  # noqa: E402

mp.dps = 45

RULES = {  # of the presets, by the products
    "tcb": ("velocity", "one-sided"), "gte": ("velocity", "half"), "fbx": ("velocity", "one-sided"),
    "gte2021": ("interval", "one-sided"),
    "wildmagic": ("interval", "one-sided"), "lightwave": ("interval", "lightwave"), "vtk": ("interval", "zero"),
    "gamebryo": ("interval", "mirror"), "idtech4": ("interval", "mirror"),
    "3dsmax": ("interval-c", "natural-tension"), "nel": ("interval-c", "natural-tension"),
    "cryengine": ("interval-c", "cry"), "lib3ds1": ("interval-c", "chord"), "lib3ds2": ("interval-c", "mirror"),
    "splines": ("finite-difference", "natural"), "synfig": ("synfig", "chord"), "kb1984": ("kb1984", "half"),
    "wikipedia": ("uniform", "half"), "ogre": ("uniform", "half"),
    "threejs": ("velocity", "chord"), "godot": ("finite-difference", "zero"),
}
RULES_OF_ROTATIONS = {
    "gte": ("velocity", "half", "squad"), "lib3ds1": ("interval-c", "chord", "squad"),
    "lib3ds2": ("interval-c", "mirror", "squad"), "nel": ("interval-c", "mirror", "squad"),
    "cryengine": ("interval-c", "mirror", "squad"), "3dsmax": ("interval-c", "mirror", "squad"),
    "vtk": ("uniform", "chord", "squad"), "splines": ("finite-difference", "natural", "casteljau"),
}
QUANTITIES = ["outgoing", "position", "rotation", "angular_velocity", "incoming", "length", "arc_time", "arc_position"]
problems = []


def expect(condition, *what):
    if not condition:
        problems.append(" ".join(map(str, what)))


def number(text):
    """A decimal of the keys, which is exactly a double."""
    expect(Fraction(text) == Fraction(float(text)), text, "is not a double")
    return mpf(text)


def keys_of_csv(folder):
    curves = {}
    with open(folder / "keys.csv", newline="") as file:
        for row in csv.DictReader(file):
            position = [row[channel] for channel in "xyzw" if row[channel]]
            ease = [row["ease_in"], row["ease_out"]]
            key = (row["time"], position, [row["tension"], row["continuity"], row["bias"]], ease)
            curves.setdefault(row["curve"], (row["closed"] == "1", []))[1].append(key)
    return curves


def curve_of(given):
    """The curve of an object of JSON."""
    tangents, ends = RULES[given["preset"]] if "preset" in given else (given["tangents"], given.get("ends", "half"))
    ends, _, velocity = ends.partition("=")
    keys = [(number(k["time"]), [*map(number, k["position"])], [*map(number, k["tcb"])],
             [number(k.get("ease_in", "0")), number(k.get("ease_out", "0"))]) for k in given["keys"]]
    period = None
    if given["closed"]:
        expect(keys[0][1:] == keys[-1][1:], given["id"], "does not return to its first key")
        period = keys.pop()[0] - keys[0][0]
    return MeasuredCurve(keys, tangents, (ends, ends), period, [number(v) for v in velocity.split(":") if v],
                         equal=given.get("equal_speed", False))


def rotations_of(given):
    """The curve of rotations of an object of JSON."""
    rule, end, name = RULES_OF_ROTATIONS[given["preset"]] if "preset" in given else (
        given["tangents"], given.get("ends", "half"), None)
    name = given.get("rotation_curve", name)
    keys = []
    for key in given["keys"]:
        x, y, z, w = map(number, key["rotation"])
        keys.append((number(key["time"]), [w, x, y, z], [*map(number, key["tcb"])], (mpf(0), mpf(0))))
    period = keys.pop()[0] - keys[0][0] if given["closed"] else None
    return quaternions.Rotations(keys, name, rule, [end, end], period)


def computed(curve, quantity, at):
    """The exact values of a quantity at a time, or at an arc length."""
    if isinstance(curve, quaternions.Rotations):
        i = curve.segment_at(at)
        (w, x, y, z), velocity = curve.at(at, i - 1 if quantity == "incoming" and at == curve.times[i] else i)
        return [x, y, z, w] if quantity == "rotation" else velocity
    segments = range(len(curve.cubics))
    if quantity.startswith("arc_"):
        i, warped = curve.place_at(at)
        t = curve.times[i] + curve.unwarp(i, warped) * (curve.times[i + 1] - curve.times[i])
        return list(curve.row([quantity.removeprefix("arc_")], i, curve.unwarp(i, warped), t, warped, at))
    if quantity == "incoming":
        i = max(k for k in segments if curve.times[k] < at)
    else:
        i = max(k for k in segments if curve.times[k] <= at)
    u = (at - curve.times[i]) / (curve.times[i + 1] - curve.times[i])
    field = {"position": "position", "length": "s"}.get(quantity, "velocity")
    return list(curve.row([field], i, u, at))


def rounded(value):
    return 0.0 if abs(value) < mpf(10) ** (-mp.dps // 2) else float(value)  # what the digits leave of zero


def check(path, keys):
    """The number of values of a file."""
    lines = []
    for given in json.loads(path.read_text(), parse_float=str, parse_int=str)["curves"]:
        closed, expected = keys[given["id"].split("/")[1]]
        mine = [(k["time"], k["rotation" if "rotation" in k else "position"], k["tcb"],
                 [k.get("ease_in", "0"), k.get("ease_out", "0")]) for k in given["keys"]]
        expect((given["closed"], mine) == (closed, expected), given["id"], "has other keys than keys.csv")
        curve = rotations_of(given) if "rotation" in given["keys"][0] else curve_of(given)
        for quantity in (q for q in QUANTITIES if q in given):
            for row in given[quantity]:
                exact = [*map(rounded, computed(curve, quantity, number(row["at"])))]
                where = (given["id"], quantity, "at", row["at"])
                expect([*map(float, row["value"])] == exact, *where, "is", row["value"], "expected", exact)
                expect([*map(float.fromhex, row["hex"])] == exact, *where, "is", row["hex"], "expected", exact)
                expect(all(Fraction(v) == Fraction(repr(float(v))) for v in row["value"]), *where, "is not shortest")
                lines += [[given["id"], quantity, row["at"], str(c), *cells]
                          for c, cells in enumerate(zip(row["value"], row["hex"], strict=True))]
    with open(path.with_suffix(".csv"), newline="") as file:
        expect(list(csv.reader(file))[1:] == lines, path, "and its CSV file differ")
    return len(lines)


folder, names = Path(sys.argv[1]), sys.argv[2:]
keys = keys_of_csv(folder)
total = sum(check(folder / name, keys) for name in names)
print(f"{total} values, {len(problems)} problems", *problems[:20], sep="\n")
sys.exit(1 if problems or total == 0 else 0)
