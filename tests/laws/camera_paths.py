"""Camera paths of nerfstudio, in 50 digits.

Positions, fields of view and rotations are Kochanek-Bartels curves at whole parameters; the time maps to the parameter
by the monotone cubic of F. N. Fritsch and J. Butland with the ends of SciPy's PchipInterpolator, through the sums of the
transitions; in a cycle, the transitions on both sides of the first keyframe are neighbours. Golden rows are exactly
those numbers, rounded; others are within 1e-12."""
import json

import mpmath
import quaternions as q4
from curves import Curve
from keys import unit
from law import check, near, require, run, same, write
from mpmath import mp, mpf

mp.dps = 50


def quaternion(m):
    """The rotation nearest to a matrix: the orthogonal factor of its singular value decomposition."""
    u, _, v = mpmath.svd_r(mpmath.matrix([m[0:3], m[3:6], m[6:9]]))
    m = list(u * v)
    trace = [1 + m[0] - m[4] - m[8], 1 - m[0] + m[4] - m[8], 1 - m[0] - m[4] + m[8], 1 + m[0] + m[4] + m[8]]
    largest = max(range(4), key=lambda i: trace[i])
    return q4.normalized([[m[7] - m[5], trace[0], m[3] + m[1], m[2] + m[6]],
                          [m[2] - m[6], m[3] + m[1], trace[1], m[7] + m[5]],
                          [m[3] - m[1], m[2] + m[6], m[7] + m[5], trace[2]],
                          [trace[3], m[7] - m[5], m[2] - m[6], m[3] - m[1]]][largest])


def random_path(draw):
    count = draw.randint(2, 6)
    frames = []
    for i in range(count):
        matrix, rotation = [], q4.matrix([mpf(x) for x in unit(draw)])
        for row in (rotation[:3], rotation[3:6], rotation[6:]):
            matrix += [float(x) for x in row] + [draw.uniform(-3, 3)]
        own = draw.random() < 0.6
        frames.append({"matrix": matrix + [0, 0, 0, 1], "fov": round(draw.uniform(20, 90), 3), "aspect": 1.5,
                       "override_transition_enabled": own,
                       "override_transition_sec": round(draw.uniform(0.05, 9), 2) if own or draw.random() < 0.5 else None})
    return {"default_fov": 60, "default_transition_sec": draw.choice([2, 0.7]), "keyframes": frames, "fps": 24,
            "seconds": 4, "is_cycle": count > 2 and draw.random() < 0.5, "smoothness_value": draw.choice([0, 0.25, 0.8])}


def decimal(x):
    return mpf(repr(x))


def slope(before, after):
    return 3 * (before + after) / (before ** 2 + 4 * before * after + after ** 2)


def end_slope(own, other):
    return max(mpf(0), ((2 * own + other) / own - own / other) / (own + other))


class Path50:
    def __init__(self, path):
        frames, cycle = path["keyframes"], path["is_cycle"]
        own = [f["override_transition_sec"] if f["override_transition_enabled"] and f["override_transition_sec"] is not None
               else path["default_transition_sec"] for f in frames]
        h = [decimal(x) for x in (own[1:] + own[:1] if cycle else own[1:])]
        self.h, self.times = h, [sum(h[:i], mpf(0)) for i in range(len(h) + 1)]
        if cycle:
            self.slopes = [slope(h[i - 1], h[i]) for i in range(len(h))] + [slope(h[-1], h[0])]
        elif len(h) == 1:
            self.slopes = [1 / h[0]] * 2
        else:
            self.slopes = ([end_slope(h[0], h[1])] + [slope(a, b) for a, b in zip(h, h[1:])] + [end_slope(h[-1], h[-2])])
        tcb = (decimal(path["smoothness_value"]), mpf(0), mpf(0))
        places = [mpf(i) for i in range(len(frames))]
        closed = mpf(len(frames)) if cycle else None
        numbers = [[decimal(f["matrix"][k]) for k in (3, 7, 11)] + [decimal(f["fov"])] for f in frames]
        self.cubics = Curve([(t, x, tcb) for t, x in zip(places, numbers)], "uniform", ("natural", "natural"), closed).cubics
        turns = [quaternion([decimal(f["matrix"][k]) for k in (0, 1, 2, 4, 5, 6, 8, 9, 10)]) for f in frames]
        self.rotations = q4.Rotations([(t, q, tcb, (mpf(0), mpf(0))) for t, q in zip(places, turns)], "casteljau", "uniform",
                                      ("natural", "natural"), closed)

    def row(self, t):
        i = max(k for k in range(len(self.h)) if k == 0 or self.times[k] <= t)
        h, (a, b) = self.h[i], self.slopes[i:i + 2]
        a, b, v = a * h, b * h, (t - self.times[i]) / h
        c, d = 3 - 2 * a - b, a + b - 2
        w, w1, w2, w3 = v * (a + v * (c + v * d)), (a + v * (2 * c + 3 * v * d)) / h, (2 * c + 6 * v * d) / h ** 2, 6 * d / h ** 3
        row = {}
        for name, (p, m, q, r) in zip(("x", "y", "z", "fov"), self.cubics[i]):
            d1, d2, d3 = m + w * (2 * q + 3 * w * r), 2 * q + 6 * w * r, 6 * r
            row[name] = p + w * (m + w * (q + w * r))
            row[name + "_v"] = d1 * w1
            row[name + "_a"] = d2 * w1 ** 2 + d1 * w2
            row[name + "_j"] = d3 * w1 ** 3 + 3 * d2 * w1 * w2 + d1 * w3
        row.update(zip((f"r{i}{k}" for i in "123" for k in "123"), q4.matrix(self.rotations.value(i, w))))
        return row


def law(rng):
    path = random_path(rng)
    reference = Path50(path)
    end = float(reference.times[-1])
    times = [0.0, *sorted({t for t in (round(rng.uniform(0, end) * 64) / 64 for _ in range(6)) if 0 < t < end})]
    write("path.json", json.dumps(path))
    options = ["path.json", "--at", ",".join(map(repr, times)), "--fields", "time,position,velocity,acceleration,jerk"]
    plain, golden = (run(json.dumps(path), "-q", *options, *more).stdout.splitlines() for more in ([], ["--golden", "--exact-input"]))
    require(len(plain) == len(golden) == len(times) + 1, f"{len(plain)} rows")
    for row, gold in zip(plain[1:], golden[1:]):
        row, gold = (dict(zip(golden[0].split(","), map(float, one.split(",")))) for one in (row, gold))
        for name, want in reference.row(mpf(row["t"])).items():
            want = mpf(0) if abs(want) < mpf(10) ** -40 else want  # in exact arithmetic
            same(gold[name], float(want), f"{name} at {row['t']}")
            near(row[name], want, (1e-9 if name[-2:] in ("_a", "_j") else 1e-12) * max(1, abs(want)), f"{name} at {row['t']}")


check(law, 8, least=10)
