"""A joint trajectory at the rate of a controller: positions, velocities and accelerations at 500 Hz."""

from pathlib import Path

import numpy as np

import tcbsample

keys = Path(__file__).parents[1] / "arm.tsv"
curve = tcbsample.Curve(keys)
begin, end = float(curve.times[0]), float(curve.times[-1])
times = np.linspace(begin, end, round(500 * (end - begin)) + 1)
position, velocity, acceleration = (curve(times, order) for order in range(3))

for name, speeds in zip(curve.names, abs(velocity).T):
    print(f"{name}: at most {speeds.max():.2f} per second, at {times[speeds.argmax()]:.3f} s")
