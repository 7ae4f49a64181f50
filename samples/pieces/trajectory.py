"""The positions of a quadcopter on its trajectory: trajectory.py TRAJECTORY.csv TIME...

The file has a polynomial of degree 7 for x, y, z and yaw in each row, as the firmware of a quadcopter reads it.
"""
import csv
import sys


def position(pieces, t):
    """x, y, z and yaw at a time; after the end those of the end."""
    for piece in pieces:
        duration = piece[0]
        if t <= duration:
            break
        t -= duration
    result = []
    for channel in range(4):
        value = 0.0
        for coefficient in reversed(piece[1 + 8 * channel : 9 + 8 * channel]):
            value = value * min(t, duration) + coefficient
        result.append(value)
    return result


def read(path):
    with open(path, newline="") as file:
        return [[float(cell) for cell in row] for row in list(csv.reader(file))[1:]]


if __name__ == "__main__":
    pieces = read(sys.argv[1])
    for t in sys.argv[2:]:
        print(t, *(f"{value:.6f}" for value in position(pieces, float(t))))
