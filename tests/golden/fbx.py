"""FBX scenes against exact fractions: fbx.py PROGRAM [CASES [SEED]].

Random scenes of versions 6.1, 7.1 and 7.4, with TCB, user, automatic, linear and constant keys, are evaluated by the
rules of FBX with exact fractions. Golden rows are exactly those numbers, rounded; others are within 1e-13 of the
size of the values and slopes. The values that MotionBuilder computed for TCB keys are met to its six decimals.
Exit 1: there is a difference.
"""
import csv
import io
import random
import struct
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

program = sys.argv[1]
cases = int(sys.argv[2]) if len(sys.argv) > 2 else 20
draw = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 37)
TICKS = 46186158000
CONSTANT, LINEAR, CUBIC, AUTO, TCB, USER = 2, 4, 8, 0x100, 0x200, 0x400
CLAMP, INDEPENDENT, PROGRESSIVE = 0x1000, 0x2000, 0x4000
THIRDS = struct.unpack("<f", struct.pack("<HH", 3333, 3333))[0]
failures = []


def single(text):
    """The single-precision float nearest to a number."""
    return struct.unpack("<f", struct.pack("<f", float(text)))[0]


class Curve:
    """Keys: ticks, value, flags, three floats."""

    def __init__(self, keys):
        self.keys = keys
        self.t = [Fraction(key[0], TICKS) for key in keys]
        self.v = [Fraction(key[1]) for key in keys]
        self.size = max(1, *(abs(v) for v in self.v), *(abs(float(x)) for key in keys for x in key[3][:2]))

    def slope(self, i):
        return (self.v[i + 1] - self.v[i]) / (self.t[i + 1] - self.t[i])

    def tcb(self, i, sign):
        t, c, b = map(Fraction, self.keys[i][3])
        at_end = i in (0, len(self.keys) - 1)
        into = (1 + b) * (1 - sign * c) * self.slope(i - 1) if i > 0 else 0
        out = (1 - b) * (1 + sign * c) * self.slope(i) if i + 1 < len(self.keys) else 0
        return (1 - t) * (into + out) / (1 if at_end else 2)

    def automatic(self, i, bias):
        flags = self.keys[i][2]
        if i in (0, len(self.keys) - 1):
            return Fraction(0) if flags & PROGRESSIVE else self.slope(min(i, len(self.keys) - 2))
        left, right = self.slope(i - 1), self.slope(i)
        if flags & CLAMP and (left == 0 or right == 0):
            return Fraction(0)
        whole = (self.v[i + 1] - self.v[i - 1]) / (self.t[i + 1] - self.t[i - 1])
        if not flags & INDEPENDENT:
            part = (self.t[i] - self.t[i - 1]) / (self.t[i + 1] - self.t[i - 1])
            whole = (whole + left + (right - left) * part) / 2
            whole += abs(bias) / 100 * ((right if bias > 0 else left) - whole)
        if flags & PROGRESSIVE:
            sign = 1 if whole >= 0 else -1
            whole = sign * min(abs(whole), max(0, 3 * sign * left), max(0, 3 * sign * right))
        return whole

    def outgoing(self, i):
        _, _, flags, numbers = self.keys[i]
        if flags & TCB:
            return self.tcb(i, -1)
        return Fraction(numbers[0]) if flags & USER else self.automatic(i, Fraction(numbers[0]))

    def incoming(self, i):
        flags, before = self.keys[i][2], self.keys[i - 1]
        if flags & CUBIC and flags & TCB:
            return self.tcb(i, 1)
        stored = Fraction(before[3][1])
        if flags & CUBIC and not flags & USER:
            return self.automatic(i, Fraction(0) if before[2] & TCB else -stored)
        return stored

    def at(self, time):
        if len(self.keys) == 1 or time <= self.t[0]:
            return self.v[0]
        if time >= self.t[-1]:
            return self.v[-1]
        i = max(k for k, t in enumerate(self.t) if t <= time)
        flags, h = self.keys[i][2], self.t[i + 1] - self.t[i]
        u = (time - self.t[i]) / h
        if flags & CONSTANT:
            return self.v[i + 1] if flags & 0x100 and u > 0 else self.v[i]
        if flags & LINEAR:
            return self.v[i] + u * (self.v[i + 1] - self.v[i])
        return ((1 + 2 * u) * (1 - u) ** 2 * self.v[i] + u * u * (3 - 2 * u) * self.v[i + 1]
                + h * u * (1 - u) ** 2 * self.outgoing(i) - h * u * u * (1 - u) * self.incoming(i + 1))


def random_curve(ticks, version):
    kinds = draw.choice([[CUBIC | TCB], [CUBIC | USER, LINEAR, CONSTANT],
                         [CUBIC | USER, CUBIC | AUTO, CUBIC | AUTO | CLAMP, CUBIC | AUTO | PROGRESSIVE,
                          CUBIC | AUTO | INDEPENDENT, LINEAR, CONSTANT, CONSTANT | 0x100]])
    if version == 6100:
        kinds = [kind for kind in kinds if not kind & CUBIC or not kind & AUTO]
    keys = []
    for tick in ticks:
        flags = draw.choice(kinds)
        numbers = [single(draw.uniform(-1, 1)) for _ in range(3)]
        if not flags & TCB:
            scale = 60 if flags & CUBIC and flags & AUTO else 5
            numbers = [single(scale * draw.uniform(-1, 1)) for _ in range(2)] + [THIRDS]
        if version == 6100:
            numbers = list(map(repr, numbers))  # the decimals of the file are exact
        keys.append((tick, f"{draw.choice([0, 1, draw.uniform(-9, 9)]):.4f}", flags, numbers))
    return Curve(keys)


def array(name, values):
    return f"{name}: *{len(values)} {{\n\t a: {','.join(map(str, values))}\n }}"


def new_text(version, curves):
    lines = ["; FBX project file", f"FBXHeaderExtension: {{\n FBXHeaderVersion: 1003\n FBXVersion: {version}\n}}", "Objects: {",
             'Model: 1, "Model::Cube", "Mesh" {\n Version: 232\n}', 'AnimationCurveNode: 2, "AnimCurveNode::T", "" {\n Properties70: {',
             *(f' P: "d|{axis}", "Number", "", "A",7' for axis in "XYZ"), " }\n}"]
    for number, curve in enumerate(curves):
        lines += [f'AnimationCurve: {10 + number}, "AnimCurve::", "" {{', array("KeyTime", [key[0] for key in curve.keys]),
                  array("KeyValueFloat", [key[1] for key in curve.keys]), array("KeyAttrFlags", [key[2] for key in curve.keys]),
                  array("KeyAttrDataFloat", [float(f"{x:.9g}") if version < 7200 else struct.unpack("<i", struct.pack("<f", x))[0]
                                             for key in curve.keys for x in (*key[3], 0.0)]),
                  array("KeyAttrRefCount", [1] * len(curve.keys)), "}"]
    lines += ["}", "Connections: {", ' C: "OP",2,1, "Lcl Translation"']
    lines += [f' C: "OP",{10 + number},2, "d|{axis}"' for number, axis in zip(range(len(curves)), "XYZ")]
    return "\n".join(lines + ["}", ""])


def old_text(curves):
    lines = ["; FBX 6.1.0 project file", "FBXHeaderExtension: {\n FBXVersion: 6100\n}",
             'Takes: {\n Take: "Take" {\n Model: "Model::Cube" {\n Channel: "Transform" {\n Channel: "T" {']
    for axis, curve in zip("XYZ", curves):
        lines += [f' Channel: "{axis}" {{\n  Default: 7\n  KeyVer: 4005\n  KeyCount: {len(curve.keys)}', "  Key: "]
        texts = []
        for tick, value, flags, numbers in curve.keys:
            kind = "L" if flags & LINEAR else "C,n" if flags & CONSTANT and flags & 0x100 else "C,s"
            if flags & CUBIC:
                kind = f"U,t,{numbers[0]},{numbers[1]},{numbers[2]}" if flags & TCB else \
                    f"U,s,{numbers[0]},{numbers[1]},{draw.choice(['n', 'a,0.333333343267441,0.333333343267441'])}"
            texts.append(f"{tick},{value},{kind}")
        lines += [f"{draw.choice([chr(10), ''])},".join(texts), " }"]
    return "\n".join(lines + [" }" * 4, "}", ""])


def rows_of(text, options):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "scene.fbx"
        file.write_text(text)
        done = subprocess.run([program, "-q", str(file), *options], capture_output=True, text=True)
    if done.returncode:
        failures.append(f"{done.stderr}\n{text}")
    return list(csv.DictReader(io.StringIO(done.stdout)))


def check():
    version = draw.choice([6100, 7100, 7400])
    ticks = [draw.randrange(TICKS)]
    for _ in range(draw.randint(1, 6)):
        ticks.append(ticks[-1] + draw.randrange(TICKS // 10, 2 * TICKS))
    curves = [random_curve(ticks if draw.random() < 0.6 else ticks[:draw.randint(1, len(ticks))], version)
              for _ in range(draw.choice([2, 3]))]
    if not any(len(curve.keys) > 1 for curve in curves):
        return
    text = old_text(curves) if version == 6100 else new_text(version, curves)
    last = max(curve.t[-1] for curve in curves)
    times = sorted({Fraction(round(draw.uniform(float(ticks[0]), float(last) * TICKS) / TICKS * 64), 64) for _ in range(6)})
    times = [t for t in times if Fraction(ticks[0], TICKS) <= t <= last]
    if not times:
        return
    for options in (["--golden", "--exact-input"], []):
        for row in rows_of(text, ["--at", ",".join(str(float(t)) for t in times), *options]):
            for axis, curve in zip("xyz", curves):
                want, got = float(curve.at(Fraction(row["t"]))), float(row[axis])
                if got != want and (options or abs(got - want) > 1e-13 * curve.size):
                    failures.append(f"{axis} at {row['t']} {options}: {got!r}, expected {want!r}\n{text}")


# Positions at 24 frames per second that MotionBuilder 2023 computed for TCB keys.
FROM_MOTIONBUILDER = """
0 -0.839699 -2.648148 -4.546875 -5.657407 -5.101273 -2 -1.805556 -1.222222 -0.25 1.111111 2.861111 5 6.862268 7.87037
8.15625 7.851851 7.08912 6 4.716435 3.37037 2.09375 1.018518 0.27662 0 2.407407 3.481481 4 4.740741 6.481482 10 7.193704
5.340741 4.29 3.890371 3.990741 4.440001 5.087037 5.780741 6.37 6.703704 6.630741 6 4.702963 2.951704 1.076 -0.59437
-1.729629 -2 -0.186167 2.875667 4 3.947917 2.680556 0.875 -0.791667 -1.642361 -1 -0.069444 2.354167 4""".split()
KEYS_OF_MOTIONBUILDER = [
    # frame, value, tension, continuity, bias
    (0, 0, -0.5, 0.5, 0.75), (6, -2, -1, 1, -1), (12, 5, -1, 0, 1), (24, 0, 0, -1, -1), (30, 10, 0, -4, 0),
    (42, 6, -0.8, -0.2, 0.6), (48, -2, 0.8, 0.2, -0.4), (51, 4, 0.5, 1.5, -0.5), (57, -1, 0.5, 1.5, -0.5),
    (60, 4, 0.5, -0.5, -0.6),
]


def check_motionbuilder():
    curve = Curve([(frame * TICKS // 24, str(value), CUBIC | TCB, tcb) for frame, value, *tcb in KEYS_OF_MOTIONBUILDER])
    rows = rows_of(new_text(7700, [curve]), ["--fps", "24"])
    for row, want in zip(rows, FROM_MOTIONBUILDER, strict=True):
        if abs(float(row["x"]) - float(want)) > 2e-6:
            failures.append(f"MotionBuilder at {row['t']}: {row['x']}, expected {want}")


check_motionbuilder()
for _ in range(cases):
    check()
for failure in failures[:2]:
    print(failure, file=sys.stderr)
print(f"{cases} scenes, {len(failures)} differences")
sys.exit(1 if failures else 0)
