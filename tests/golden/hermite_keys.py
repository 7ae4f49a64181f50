"""Keys with given velocities against exact fractions: hermite_keys.py PROGRAM [ROUNDS [SEED]].

Random keys in decimals, open and closed, with and without corners, in CSV and JSON. Golden rows are the exact
fractions, rounded once; other rows are near them; the segments that the program writes are read back as the same curve.
Exit 1: a number differs.
"""
import json
import random
import subprocess
import sys
from fractions import Fraction

program = sys.argv[1]
rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 20
draw = random.Random(sys.argv[3] if len(sys.argv) > 3 else "23")


def rows(text, *options):
    out = subprocess.run([program, "-q", *options], input=text, check=True, capture_output=True, text=True).stdout
    return [line.split(",") for line in out.splitlines()[1:]]


def number():
    return f"{draw.uniform(-10, 10):.{draw.randint(0, 4)}f}"


def random_keys(corners, closed):
    time, keys = Fraction(draw.randint(-50, 50), 4), []
    for _ in range(draw.randint(2, 7)):
        incoming = [number(), number()]
        keys.append([time, [number(), number()], incoming, [number(), number()] if corners else incoming])
        time += Fraction(draw.randint(1, 40), 8)
    if closed:
        keys.append([time, keys[0][1], keys[0][2], keys[0][3]])
    return keys


def csv_of(keys, corners):
    lines = ["t,x,y,x_vin,x_vout,y_vin,y_vout" if corners else "t,x,y,x_v,y_v"]
    for time, place, incoming, outgoing in keys:
        sides = [incoming[0], outgoing[0], incoming[1], outgoing[1]] if corners else incoming
        lines.append(",".join([str(float(time)), *place, *sides]))
    return "\n".join(lines) + "\n"


def json_of(keys, corners):
    def floats(texts):
        return [float(text) for text in texts]

    return json.dumps([{"t": float(time), "position": floats(place),
                        **({"velocity_in": floats(incoming), "velocity_out": floats(outgoing)} if corners
                           else {"velocity": floats(incoming)})} for time, place, incoming, outgoing in keys])


def exact(keys, time):
    for (t0, p0, _, out), (t1, p1, into, _) in zip(keys, keys[1:]):
        if not t0 <= time <= t1:
            continue
        h, u = t1 - t0, (time - t0) / (t1 - t0)
        weights = (2 * u**3 - 3 * u**2 + 1, 3 * u**2 - 2 * u**3, h * (u**3 - 2 * u**2 + u), h * (u**3 - u**2))
        return [sum(w * Fraction(c) for w, c in zip(weights, four)) for four in zip(p0, p1, out, into)]
    raise ValueError(time)


def require(good, *what):
    if not good:
        sys.exit(" ".join(str(one) for one in what))


for turn in range(rounds):
    corners, closed = draw.random() < 0.6, draw.random() < 0.3
    keys = random_keys(corners, closed)
    text, loop = csv_of(keys, corners), ["--closed"] if closed else []
    times = [keys[0][0] + (keys[-1][0] - keys[0][0]) * Fraction(k, 64) for k in range(64)]
    places = ["--at", ",".join(str(float(time)) for time in times), *loop]
    plain = rows(text, *places)
    size = max(abs(float(value)) for key in keys for four in key[1:] for value in four) * 8
    golden = rows(text, *places, "--golden", "--exact-input")
    for time, row, near in zip(times, golden, plain, strict=True):
        values = [float(value) for value in exact(keys, time)]
        require([float(cell) for cell in row[1:]] == values, text, row)
        require(max(abs(float(p) - q) for p, q in zip(near[1:], values)) <= 1e-13 * size, text, near)
    require(rows(json_of(keys, corners), *places, "-f", "csv") == plain, "JSON", text)
print(f"{rounds} rounds")
