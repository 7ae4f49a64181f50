"""Golden data for a test: exact values, rounded once, against an implementation of your own."""

import numpy as np

import tcbsample

keys = np.array([(0, 0.0, 0.2), (1, 2.0, 0.0), (3, -1.0, -0.5), (4, 3.0, 0.3)],
                dtype=[("t", float), ("x", float), ("tension", float)])  # fmt: skip
expected = tcbsample.resample(keys, step="1/16", preset="wikipedia", golden=True)


def yours(t: float) -> float:
    """Replace this by a call of your code."""
    return float(tcbsample.Curve(keys, preset="wikipedia")(t)[0])


for row in expected:
    assert abs(yours(row["t"]) - row["x"]) <= 4 * np.spacing(4.0), row
print(f"{len(expected)} values agree")
