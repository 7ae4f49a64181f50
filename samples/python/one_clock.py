"""Two data sets on one clock: a recording with times of its own, at the times of another one."""

import numpy as np

import tcbsample

camera = np.array([f"2024-05-01T12:00:00.{ms:03}" for ms in range(0, 200, 40)], dtype="datetime64[ms]")
sensor = {
    "time": ["2024-05-01T11:59:59.99Z", "2024-05-01T12:00:00.06Z", "2024-05-01T12:00:00.13Z", "2024-05-01T12:00:00.2Z"],
    "x": [0.0, 1.0, 4.0, 9.0],
    "y": [1.0, 1.0, 0.0, 2.0],
}
on_frames = tcbsample.resample(sensor, at=camera)
for frame, row in enumerate(on_frames):
    print(frame, row["time"], f"{row['x']:.4f} {row['y']:.4f}")
