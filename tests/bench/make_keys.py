"""Makes the keys of a moving camera: make_keys.py COUNT. The same COUNT gives the same keys.

Writes keys.csv (time,x,y,z with a header), and the same numbers separated by tabs without a header: keys.txt,
xyz.txt (no time) and xyzt.txt (time last). Every number has 17 significant digits. Prints the first time, the last
time, and the length of the polyline through the keys in x and y.
"""

import math
import random
import sys

count = max(int(sys.argv[1]), 2)
generator = random.Random(1984)
time, place, velocity = 0.0, [0.0, -12.0, 1.7], [1.0, 0.0, 0.0]
first, plane_length = time, 0.0

with (open("keys.csv", "w") as csv, open("keys.txt", "w") as keys, open("xyz.txt", "w") as xyz,
      open("xyzt.txt", "w") as xyzt):
    csv.write("time,x,y,z\n")
    for key in range(count):
        t, *position = [format(value, ".17g") for value in [time, *place]]
        csv.write(",".join([t, *position]) + "\n")
        keys.write("\t".join([t, *position]) + "\n")
        xyz.write("\t".join(position) + "\n")
        xyzt.write("\t".join([*position, t]) + "\n")
        if key + 1 == count:
            break
        # The velocity of the camera is an autoregressive random walk, and a weak force keeps it near the scene.
        step = generator.uniform(0.15, 0.6)
        velocity = [0.8 * v - 0.02 * p + generator.gauss(0, 1) for v, p in zip(velocity, place)]
        moved = [p + v * step for p, v in zip(place, velocity)]
        plane_length += math.hypot(moved[0] - place[0], moved[1] - place[1])
        time, place = time + step, moved

print(*(format(value, ".17g") for value in [first, time, plane_length]))
