"""Rows on the standard input hold rotations: unit_rotations.py QX QY QZ QW, the names of the columns.

Each quaternion is unit to 2 units in the last place of 1, by exact fractions, and no sign jumps. Exit 1: one is not so.
"""
import csv
import sys
from fractions import Fraction

ulp, before, count = Fraction(1, 2**52), None, 0
for row in csv.DictReader(sys.stdin):
    q = [Fraction(float(row[name])) for name in sys.argv[1:]]
    square = sum(x * x for x in q)
    if not (1 - 2 * ulp) ** 2 <= square <= (1 + 2 * ulp) ** 2:
        sys.exit(f"the norm differs from 1 by {float(square - 1) / 2:.3g}: {row}")
    if before and sum(x * y for x, y in zip(q, before)) <= 0:
        sys.exit(f"the sign jumps: {row}")
    before, count = q, count + 1
if count < 2:
    sys.exit("there are no rows")
