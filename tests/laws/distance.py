"""Distance of rows from those of --golden, field by field and class by class: distance.py PROGRAM MANUAL [CURVES] [SEED].

The distance is in units in the last place of the exact number, or of a thousandth of the largest number of its column
on that curve, whichever is more. With the curves and the seed of the manual no distance may exceed its table; with
others the table of that draw is printed. A class is a way to draw six keys in three channels.
"""
import math
import random
import re
import sys

from keys import RULES
from law import numbers

manual = sys.argv[2]
own_draw = len(sys.argv) > 3
curves = int(sys.argv[3]) if own_draw else 20
seed = int(sys.argv[4]) if len(sys.argv) > 4 else 7
fields = ["position", "s", "velocity", "acceleration", "jerk", "speed", "tangent", "curvature", "torsion", "u"]
by_length = ["time", "position", "velocity", "speed", "u"]
per_channel = ["position", "velocity", "acceleration", "jerk", "tangent"]

even = lambda rng: rng.uniform(0.5, 1.5)
none = lambda rng: [0.0] * 3
usual = lambda rng: [rng.uniform(-1, 1) for _ in range(3)]
tight = lambda rng: [1 - 10 ** rng.uniform(-6, -1), rng.uniform(-1, 1), rng.uniform(-1, 1)]
# By class: the steps in time; tension, continuity and bias of a key; the offset of positions, which are within 10 of it.
classes = {"plain": (even, none, 0), "tcb": (even, usual, 0),
           "uneven": (lambda rng: 10 ** rng.uniform(-3, 3), usual, 0), "cusps": (even, tight, 0),
           "offset": (even, usual, 1e6)}


def keys(rng, kind):
    step, tcb, offset = classes[kind]
    t, lines = rng.uniform(-9, 9), ["t,x,y,z,tension,continuity,bias"]
    for _ in range(6):
        cells = [t] + [offset + rng.uniform(-10, 10) for _ in range(3)] + tcb(rng)
        lines.append(",".join(map(repr, cells)))
        t += step(rng)
    return "\n".join(lines) + "\n"


def rounded_up(value):
    """To two digits."""
    if value == 0:
        return "0"
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return f"{math.ceil(value / unit - 1e-9) * unit:.7g}"


largest_of = {}
for kind in classes:
    rng = random.Random(f"{seed} {kind}")
    for _ in range(curves):
        text = keys(rng, kind)
        rule = rng.choice(RULES)
        for group, names, mode in (("", fields, ["--count", "41"]), ("by length: ", by_length, ["--arc-count", "11"])):
            options = ["--tangents", rule, *mode, "--fields", ",".join(names)]
            columns = [name for name in names for _ in range(3 if name in per_channel else 1)]
            fast, exact = numbers(text, *options), numbers(text, *options, "--golden")
            for column, name in enumerate(columns):
                pairs = [(f[column], e[column]) for f, e in zip(fast, exact, strict=True)]
                pairs = [(f, e) for f, e in pairs if f is not None and e is not None]
                largest = max((abs(e) for _, e in pairs), default=0)
                far = [abs(f - e) / math.ulp(max(abs(e), largest / 1000)) for f, e in pairs]
                row = largest_of.setdefault(group + name, dict.fromkeys(classes, 0.0))
                row[kind] = max([row[kind], *far])

head = f"{'field':21}" + "".join(f"{kind:>10}" for kind in classes)
print(head)
for name, row in largest_of.items():
    print(f"{name:21}" + "".join(f"{rounded_up(far):>10}" for far in row.values()))
if own_draw:
    sys.exit(0)

promised = {}
lines = [line.strip() for line in open(manual, encoding="utf-8").read().replace("\\-", "-").splitlines()]
for line in lines[lines.index(head) + 1:]:
    row = re.fullmatch(r"(.*?\S) {2,}" + " +".join([r"([\d.e+]+)"] * len(classes)), line)
    if not row:
        break
    promised[row[1]] = dict(zip(classes, map(float, row.groups()[1:]), strict=True))
failed = set(largest_of) != set(promised)
for name, row in largest_of.items():
    failed |= name in promised and any(far > promised[name][kind] * (1 + 1e-6) for kind, far in row.items())
sys.exit(1 if failed else 0)
