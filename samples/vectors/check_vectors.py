"""Tests the spline in tangent() and value() with presets/kb1984.json; put yours in their place. Exit 1: an error is
too large."""
import json
import sys


def tangent(keys, closed, segment, side, c):
    """The derivative at the start (side 1) or the end (side -1) of a segment, per its whole duration."""
    last = len(keys) - 1
    i = segment if side > 0 else segment + 1
    tension, continuity, bias = keys[i]["tcb"]
    before = (1 - tension) * (1 + side * continuity) * (1 + bias) / 2
    after = (1 - tension) * (1 - side * continuity) * (1 - bias) / 2

    def step(i):  # in position and in time
        a, b = keys[i % last], keys[i % last + 1]
        return b["position"][c] - a["position"][c], b["time"] - a["time"]

    if not closed and i in (0, last):
        return step(segment)[0] * (after if side > 0 else before)
    (d0, h0), (d1, h1) = step(i - 1), step(i)
    return (before * d0 + after * d1) * 2 * (h0 if side > 0 else h1) / (h0 + h1)


def value(keys, closed, quantity, t, c):
    """The position at t, or the velocity into or out of the key at t."""
    inside = [k for k in range(len(keys) - 1) if keys[k]["time"] <= t <= keys[k + 1]["time"]]
    k = inside[0 if quantity == "incoming" else -1]
    h, (p, q) = keys[k + 1]["time"] - keys[k]["time"], (keys[k + i]["position"][c] for i in (0, 1))
    u, m, n = (t - keys[k]["time"]) / h, tangent(keys, closed, k, 1, c), tangent(keys, closed, k, -1, c)
    if quantity != "position":
        return (n if quantity == "incoming" else m) / h
    return p + u * (m + u * (3 * (q - p) - 2 * m - n + u * (m + n - 2 * (q - p))))


with open("presets/kb1984.json") as file:
    curves = json.load(file)["curves"]
errors = [abs(value(curve["keys"], curve["closed"], quantity, row["at"], c) - expected)
          for curve in curves for quantity in ("position", "incoming", "outgoing")
          for row in curve[quantity] for c, expected in enumerate(row["value"])]
print(f"{len(errors)} numbers, largest error {max(errors):.1g}")
sys.exit(max(errors) > 1e-13)
