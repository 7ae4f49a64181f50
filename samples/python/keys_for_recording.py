"""Keys for a recording: a small set of keys whose curve stays within a tolerance of every sample."""

from pathlib import Path

import tcbsample

recording = tcbsample.resample(Path(__file__).parents[1] / "loop.txt", count=2000)  # in place of a recording
keys = tcbsample.fit(recording, 0.05)
report = tcbsample.check(keys, recording, abs=0.0501)

print(f"{len(recording)} samples, {len(keys)} keys; every sample within the tolerance: {bool(report)}")
assert report
