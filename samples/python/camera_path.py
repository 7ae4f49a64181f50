"""A camera path at constant speed: one frame for each 1/24 of a second, the same distance between all frames."""

from pathlib import Path

import numpy as np

import tcbsample

keys = Path(__file__).parents[1] / "camera.csv"
curve = tcbsample.Curve(keys, metric="x,y,z", ends="one-sided")  # not fov, which is not a length
end = curve.times[-1]
frames = round(24 * (end - curve.times[0])) + 1
lengths = np.linspace(0, float(curve.length(end)), frames)
cameras = curve.at_length(lengths)

steps = np.linalg.norm(np.diff(cameras[:, :3], axis=0), axis=1)
print(f"{frames} frames of {', '.join(curve.names)}; steps from {steps.min():.3f} to {steps.max():.3f}")
