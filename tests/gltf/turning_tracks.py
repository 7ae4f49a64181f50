"""Animations of angles: turning_tracks.py PROGRAM [SEED].

Rotations of LightWave are angles with keys of their own. Each animation of their samples is evaluated as the specification
of glTF says, and compared with the product of the turns at the rows of the same curve.
"""
import base64
import csv
import io
import json
import math
import random
import struct
import subprocess
import sys

program = sys.argv[1]
draw = random.Random(int(sys.argv[2]) if len(sys.argv) > 2 else 3)


def run(text, *arguments):
    return subprocess.run([program, "-q", *arguments], input=text, capture_output=True, text=True, check=True).stdout


def turn(axis, angle):
    q = [0.0, 0.0, 0.0, math.cos(angle / 2)]
    q[axis] = math.sin(angle / 2)
    return q


def times(p, q):
    px, py, pz, pw = p
    qx, qy, qz, qw = q
    return [pw * qx + px * qw + py * qz - pz * qy, pw * qy + py * qw + pz * qx - px * qz,
            pw * qz + pz * qw + px * qy - py * qx, pw * qw - px * qx - py * qy - pz * qz]


def product(turns):
    q = [0.0, 0.0, 0.0, 1.0]
    for one in turns:
        q = times(q, one)
    return q


def accessor(scene, number):
    view = scene["bufferViews"][scene["accessors"][number]["bufferView"]]
    data = base64.b64decode(scene["buffers"][0]["uri"].split(",")[1])[view["byteOffset"]:][:view["byteLength"]]
    return struct.unpack(f"<{len(data) // 4}f", data)


def evaluated(scene, t):
    animation = scene["animations"][0]
    channel = next(c for c in animation["channels"] if c["target"]["path"] == "rotation")
    sampler = animation["samplers"][channel["sampler"]]
    keys, values = accessor(scene, sampler["input"]), accessor(scene, sampler["output"])
    i = max(k for k in range(len(keys) - 1) if keys[k] <= t or k == 0)
    d = keys[i + 1] - keys[i]
    u = min(max((t - keys[i]) / d, 0), 1)
    p, q = values[4 * i:4 * i + 4], values[4 * i + 4:4 * i + 8]
    return [(1 - u) * a + u * b for a, b in zip(p, q)]


def degrees_between(p, q):
    size = math.sqrt(sum(x * x for x in p) * sum(x * x for x in q))
    return math.degrees(2 * math.acos(min(1, abs(sum(a * b for a, b in zip(p, q))) / size)))


def compare(name, text, options, turns, steps=()):
    rows = list(csv.DictReader(io.StringIO(run(text, *options, "--count", "301"))))
    scene = json.loads(run(text, *options, "-f", "gltf", "--count", "301"))
    for row in rows:
        if any(abs(float(row["t"]) - t) < 1e-5 for t in steps):  # the second keyframe is at the next number
            continue
        q = turns([float(row[c]) for c in "xyz"])
        off = degrees_between(evaluated(scene, float(row["t"])), q)
        if off > 0.0105:  # the arrays have single precision
            sys.exit(f"{name}, {row}: {off} degrees")


def envelope(size):
    keys = []
    t = 0.0
    for _ in range(draw.randint(2, 6)):
        keys.append((round(draw.uniform(-size, size), 3), round(t, 3), draw.choice([0, 0, 3, 4])))
        t += draw.uniform(0.2, 0.9)
    keys[-1] = (keys[-1][0], 5, keys[-1][2])
    return keys


for case in range(12):
    size = draw.choice([0.5, 3, 40])
    text = "LWMO\n3\nNumChannels 6\n"
    steps = []
    for channel in range(6):
        keys = envelope(size)
        steps += [t for _, t, span in keys if span == 4]
        text += f"Channel {channel}\n{{ Envelope\n{len(keys)}\n"
        text += "".join(f"Key {v} {t} {s} 0 0 0 0 0 0\n" for v, t, s in keys) + "Behaviors 1 1\n}\n"
    compare(f"motion {case}", text, ["-i", "lws", "--only", "motion/rotation", "--to", "5"],
            lambda a: product([turn(1, a[0]), turn(0, a[1]), turn(2, a[2])]), steps)
