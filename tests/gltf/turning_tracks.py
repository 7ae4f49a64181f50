"""Animations of angles: turning_tracks.py PROGRAM [SEED].

Rotations of LightWave and FBX are angles with keys of their own. Each animation of them, exact or sampled, is evaluated as
the specification of glTF says, and compared with the product of the turns at the rows of the same curve, within 0.01
degrees. The order of the turns and the fixed rotations are those of the specifications of the products.
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
    if sampler["interpolation"] == "LINEAR":
        p, q = values[4 * i:4 * i + 4], values[4 * i + 4:4 * i + 8]
        return [(1 - u) * a + u * b for a, b in zip(p, q)]
    p, b = values[12 * i + 4:12 * i + 8], values[12 * i + 8:12 * i + 12]
    a, q = values[12 * i + 12:12 * i + 16], values[12 * i + 16:12 * i + 20]
    v = 1 - u
    return [v * v * (1 + 2 * u) * p[k] + v * v * u * d * b[k] + u * u * (1 + 2 * v) * q[k] - u * u * v * d * a[k]
            for k in range(4)]


def degrees_between(p, q):
    size = math.sqrt(sum(x * x for x in p) * sum(x * x for x in q))
    return math.degrees(2 * math.acos(min(1, abs(sum(a * b for a, b in zip(p, q))) / size)))


def compare(name, text, options, turns, steps=()):
    rows = list(csv.DictReader(io.StringIO(run(text, *options, "--count", "301"))))
    scene = json.loads(run(text, *options, "-f", "gltf"))
    sampled = json.loads(run(text, *options, "-f", "gltf", "--count", "301"))
    for row in rows:
        if any(abs(float(row["t"]) - t) < 1e-5 for t in steps):  # the second keyframe is at the next number
            continue
        q = turns([float(row[c]) for c in "xyz"])
        for kind, animation in (("exact", scene), ("sampled", sampled)):
            off = degrees_between(evaluated(animation, float(row["t"])), q)
            if off > 0.0105:  # the arrays have single precision
                sys.exit(f"{name}, {kind}, {row}: {off} degrees")


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

orders = ["xyz", "xzy", "yzx", "yxz", "zxy", "zyx"]
for case in range(12):
    order, active = draw.randrange(6), draw.random() < 0.8
    fixed = [[round(draw.uniform(-180, 180), 2) for _ in range(3)] for _ in range(2)]
    text = "; FBX 7.4.0 project file\nFBXHeaderExtension: {\n FBXVersion: 7400\n}\nObjects: {\n Model: 1, \"Model::A\", \"\" {\n"
    text += f"  Properties70: {{\n   P: \"RotationOrder\", \"enum\", \"\", \"\",{order}\n   P: \"RotationActive\", \"bool\", \"\", \"\",{int(active)}\n"
    for name, angles in zip(("PreRotation", "PostRotation"), fixed):
        text += f"   P: \"{name}\", \"Vector3D\", \"Vector\", \"\",{','.join(map(str, angles))}\n"
    text += "  }\n }\n AnimationCurveNode: 2, \"AnimCurveNode::R\", \"\" {\n }\n"
    for channel in range(3):
        keys = envelope(200)
        ticks = ",".join(str(round(t * 1000) * 46186158) for _, t, _ in keys)
        text += f" AnimationCurve: {10 + channel}, \"\", \"\" {{\n  KeyTime: *{len(keys)} {{\n   a: {ticks}\n  }}\n"
        text += f"  KeyValueFloat: *{len(keys)} {{\n   a: {','.join(str(v) for v, _, _ in keys)}\n  }}\n"
        text += "  KeyAttrFlags: *1 {\n   a: 8456\n  }\n  KeyAttrDataFloat: *4 {\n   a: 0,0,0,0\n  }\n"
        text += f"  KeyAttrRefCount: *1 {{\n   a: {len(keys)}\n  }}\n }}\n"
    text += "}\nConnections: {\n C: \"OP\",2,1, \"Lcl Rotation\"\n"
    text += "".join(f" C: \"OP\",{10 + i},2, \"d|{'XYZ'[i]}\"\n" for i in range(3)) + "}\n"

    def turns(angles, order=order, active=active, fixed=fixed):
        angles = [math.radians(a) for a in angles]
        names = orders[order] if active else "xyz"
        parts = [turn("xyz".index(c), angles["xyz".index(c)]) for c in reversed(names)]
        pre, post = ([turn(i, math.radians(f[i])) for i in (2, 1, 0)] if active else [] for f in fixed)
        x, y, z, w = product(post)
        return product([*pre, *parts, [-x, -y, -z, w]])

    compare(f"scene {case}", text, ["-i", "fbx", "--only", "A/rotation"], turns)
