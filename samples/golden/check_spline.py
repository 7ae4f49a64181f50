"""A test of a spline in Python: every row of reference.csv against the function below, in place of yours."""
import csv
import unittest


def spline(keys, t):
    """The spline under test: one channel, velocities averaged, the end's neighbour missing (preset gte)."""
    k = max(i for i in range(len(keys) - 1) if i == 0 or keys[i][0] <= t)
    h = keys[k + 1][0] - keys[k][0]
    u = (t - keys[k][0]) / h

    def slope(i):
        if not 0 <= i < len(keys) - 1:
            return 0
        return (keys[i + 1][1] - keys[i][1]) / (keys[i + 1][0] - keys[i][0])

    def tangent(i, side):  # side 1: outgoing, -1: incoming
        _, _, tension, continuity, bias = keys[i]
        return h * (1 - tension) / 2 * ((1 + side * continuity) * (1 + bias) * slope(i - 1)
                                        + (1 - side * continuity) * (1 - bias) * slope(i))

    p0, p1, m0, m1 = keys[k][1], keys[k + 1][1], tangent(k, 1), tangent(k + 1, -1)
    return ((2 * u**3 - 3 * u**2 + 1) * p0 + (3 * u**2 - 2 * u**3) * p1
            + (u**3 - 2 * u**2 + u) * m0 + (u**3 - u**2) * m1)


def rows(path):
    """The rows by name, without lines of provenance."""
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class Reference(unittest.TestCase):
    def test_every_row(self):
        names = ("tension", "continuity", "bias")
        for channel in "xy":
            keys = [[float(key[name]) for name in ("time", channel, *names)] for key in rows("keys.csv")]
            for row in rows("reference.csv"):
                self.assertAlmostEqual(spline(keys, float(row["time"])), float(row[channel]), delta=1e-14, msg=row)


if __name__ == "__main__":
    unittest.main()
