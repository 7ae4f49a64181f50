"""Rotations are those of the formulas in 50 digits, by every curve, rule and form of keys, also beyond the keys; rows are
unit and their signs do not jump; and what a curve of rotations must not depend on, it does not."""
from fractions import Fraction

import mpmath
import quaternions as q4
from keys import ENDS, Keys, turned, unit
from law import blocks, check, near, require, same
from mpmath import mp, mpf

mp.dps = 50
ULP = Fraction(1, 2 ** 52)
PRESETS = {"gte": ("velocity", "half", "squad"), "nel": ("interval-c", "mirror", "squad"),
           "splines": ("finite-difference", "natural", "casteljau")}
TURNS = ENDS[:-1]


def wxyz(row):
    return [float(row["q" + c]) for c in "wxyz"]


def exact(numbers):
    return list(map(mpf, numbers))


def close(got, want, limit, what):
    """Whether two quaternions are the same rotation, up to a limit."""
    for x, y in zip(got, q4.nearest(want, exact(got)), strict=True):
        near(x, y, mpf(limit), what)


def rounded(value):
    return float(value) if abs(value) > mpf(10) ** -28 else 0.0  # differences leave less of a velocity that is zero


def drawn(rng, without="", **others):
    return Keys(rng, "own sparse linear sizes " + without, ["whole", "short", "double", "negative"], "rotations", reach=[1], ends=TURNS, **others)


def is_smooth(curve):
    """Near half a turn on the sphere of quaternions the weights of a slerp are quotients by a small sine."""
    return max(map(curve.widest, range(curve.count))) <= 3


def at_times(rng):
    keys = drawn(rng)
    places = keys.places(rng, 3)
    options = [*keys.options(), "--fields", "time,position,angular_velocity,angular_speed", "--at", ",".join(places)]
    plain, golden = blocks(keys.text(), *options), blocks(keys.text(), *options, "--golden")
    for part, rows, exactly in zip(keys.parts(), plain, golden, strict=True):
        curve, inside = part.rotations(), [t for t in map(keys.time, places) if part.knots[0] <= keys.time(str(float(t))) <= part.knots[-1]]
        largest = max(1, *(float(row["angular_speed"]) for row in rows))
        for t, row, gold in zip(inside, rows, exactly, strict=True):
            t = q4.to_mpf(t)
            value, velocity = curve.at(t)
            columns = [f"angular_velocity_{c}" for c in "xyz"] + ["angular_speed"]
            spins = [*velocity, q4.norm(velocity)]
            same([*wxyz(gold), *(float(gold[c]) for c in columns)],
                 list(map(rounded, [*q4.nearest(value, exact(wxyz(gold))), *spins])), f"--golden at {row['t']}")
            if curve.widest(curve.segment_at(t)) <= 3:
                close(wxyz(row), value, "2e-15", f"at {row['t']}")
                for column, want in zip(columns if t not in curve.times else [], spins):
                    near(float(row[column]), want, mpf("1e-12") * largest, f"{column} at {row['t']}")
    for rows in blocks(keys.text(), *keys.options(), "--per-segment", "20"):
        are_unit(rows)


def are_unit(rows):
    for row, before in zip(rows, [None, *rows]):
        square = sum(Fraction(x) ** 2 for x in wxyz(row))
        require((1 - 2 * ULP) ** 2 <= square <= (1 + 2 * ULP) ** 2, f"the norm at {row['t']} is no 1 within 2 ulp: {row}")
        require(not before or q4.dot(wxyz(row), wxyz(before)) >= 0, f"the sign jumps at {row['t']}: {row}")


def invariants(rng):
    """Constant rotations on both sides, signs, a repeated first key, reversal, and the keys themselves."""
    keys = drawn(rng, "velocities groups gaps", repeats=False)
    curve, options, places = keys.parts()[0].rotations(), keys.options(), keys.places(rng, 8)
    if not is_smooth(curve):
        return
    rows = lambda options, places: [wxyz(row) for row in blocks(keys.text(), *options, "--at", ",".join(places))[0]]
    base, kept = rows(options, places), [row[4] for row in keys.curves[0]]

    def turn_keys(turned_key):
        for row, q in zip(keys.curves[0], kept):
            row[4] = list(map(repr, turned_key(list(map(float, q)))))

    left, right = exact(unit(rng)), exact(unit(rng))
    turn_keys(lambda q: list(map(float, q4.product(q4.product(left, exact(q)), right))))
    for row, q in zip(rows(options, places), base, strict=True):
        close(row, q4.product(q4.product(left, exact(q)), right), "4e-15", "constant rotations")  # each within 2e-15
    signs = [rng.choice([1, -1]) for _ in kept]
    for row, q, sign in zip(keys.curves[0], kept, signs):
        row[4] = [repr(sign * float(x)) for x in q]
    for row, q in zip(rows(options, places), base, strict=True):
        close(row, exact(q), 0, "signs of keys")
    turn_keys(lambda q: q)
    for row, q in zip(rows(options, keys.times), curve.quaternions):
        close(row, q, "2.5e-16", "a row at a key")
    if keys.closed:
        keys.repeats = True
        for row, q in zip(rows(keys.options(), places), base, strict=True):
            close(row, exact(q), 0, "a repeated first key")
        beyond = ["--extrapolate", "repeat", f"--from={float(keys.times[0]) - 20}", f"--to={float(keys.times[0]) + 40}", "--count", "200"]
        are_unit(blocks(keys.text(), *keys.options(), *beyond)[0])
        return
    keys.times, keys.ends = ["-" + t if t[0] != "-" else t[1:] for t in reversed(keys.times)], keys.ends[::-1]
    for row in keys.curves[0]:
        row[2].reverse()
        row[1][0][2] = row[1][0][2].removeprefix("-") if row[1][0][2][0] == "-" else "-" + row[1][0][2]
    keys.curves[0].reverse()
    opposite = ["-" + t if t[0] != "-" else t[1:] for t in places]
    for row, q in zip(rows(keys.options(), opposite), base, strict=True):
        close(row, exact(q), "4e-15", "reversal")


def one_axis(rng):
    """Turns about one axis by casteljau are the curve of the angle, without natural ends and arcs of half a circle."""
    keys = drawn(rng, "velocities groups gaps closed equal", rotation_curves=["casteljau"], channels=1)
    keys.ends = [end if end != "natural" else "half" for end in keys.ends]
    axis, angle = exact(unit(rng)[1:]), 0.0
    axis = q4.scaled(axis, 1 / q4.norm(axis))
    for row in keys.curves[0]:
        angle += rng.uniform(-2.5, 2.5)
        row[0], row[4] = [repr(angle)], [repr(float(x)) for x in q4.exp(q4.scaled(axis, mpf(angle) / 2))]
    curve = keys.parts()[0].rotations()
    arcs = [v for chord, out, into in zip(curve.chords, curve.outs, curve.ins)
            for v in (out, into, [3 * d - o - m for d, o, m in zip(chord, out, into)])]
    for row in blocks(keys.text(), *keys.options(), "--count", "33")[0] if max(map(q4.norm, arcs)) < 3 * 2.2 else []:
        close(wxyz(row), q4.exp(q4.scaled(axis, mpf(float(row["x"])) / 2)), "8e-15", f"one axis at {row['t']}")


def beyond(rng):
    keys = drawn(rng, "velocities groups gaps closed equal ease")
    curve = keys.parts()[0].rotations()
    first, last = float(curve.times[0]), float(curve.times[-1])
    times = [first - 2.25 * (last - first), first - (last - first) * .375, last + .125, last + 1.8125 * (last - first)]
    before, after = (rng.choice(["hold", "linear", "repeat", "oscillate", "offset"]) for _ in range(2))
    for row in blocks(keys.text(), *keys.options(), f"--extrapolate={before},{after}", "--at", ",".join(map(repr, times)))[0] * is_smooth(curve):
        t = float(row["t"])
        how, limit = before if t < first else after, mpf("4e-15")
        if how == "linear":  # the rounding error of the velocity, of the size of the segment's, grows with time
            i, end = (0, first) if t < first else (-1, last)
            turn = 2 * q4.norm(curve.outs[i]) + 2 * q4.norm(curve.ins[i]) + mpf("2.5")
            limit *= 1 + turn * abs(t - end) / (curve.times[1] - curve.times[0] if i == 0 else curve.times[-1] - curve.times[-2])
        close(wxyz(row), curve.beyond(how, mpf(t)), limit, f"{how} at {row['t']}")


def beside_positions(rng):
    """Rotations and positions do not see each other, also under other names and in another order of columns."""
    keys = drawn(rng, "velocities", channels=3)
    names, options = keys.names(), keys.options()
    table = lambda order, **new: "".join(",".join(row) + "\n" for row in [[new.get(n, n) for n in order], *(
        [dict(zip(names, row))[n] for n in order] for row in keys.rows())])
    usual = blocks(keys.text(), *options, "--per-segment", "3")
    mixed = rng.sample(names, len(names))
    found = blocks(table(mixed, qw="a", qx="b", qy="c", qz="d"), *options, "--per-segment", "3", "--rotation", "quaternion=b:c:d:a")
    for rows, others in zip(usual, found, strict=True):
        same([{**dict(zip(("qw", "qx", "qy", "qz"), (row["a"], row["b"], row["c"], row["d"]))),
               **{n: x for n, x in row.items() if n not in "abcd"}} for row in others], rows, "names and order of columns")
    plain = [option for option in options if option not in ("--rotation-curve", keys.rotation_curve)]
    places = ["--arc-count", "9"] if not keys.gap else ["--per-segment", "3"]
    lengths = blocks(table([n for n in names if n[0] != "q"]), *plain, *places)
    for rows, others in zip(blocks(keys.text(), *options, *places), lengths, strict=True):
        same([{n: x for n, x in row.items() if n[0] != "q"} for row in rows], others, "positions beside rotations")


def quaternion_of(rows):
    """The rotation nearest to a matrix: the orthogonal factor of its singular value decomposition, as axis and angle."""
    u, _, v = mpmath.svd_r(mpmath.matrix(rows))
    r = u * v
    double_sine = [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]]
    half = mpmath.atan2(q4.norm(double_sine), r[0, 0] + r[1, 1] + r[2, 2] - 1) / 2
    return [mpmath.cos(half), *q4.scaled(double_sine, mpmath.sin(half) / q4.norm(double_sine))]


def turn_of(form, numbers, one):
    """The rotation by the definition of its form; numbers and the unit of angles are exact."""
    if form == "matrix":
        return quaternion_of([numbers[:3], numbers[3:6], numbers[6:]])
    if form.startswith("axis-angle"):
        axis, half = numbers[:3], numbers[3] * one / 2
        return [mpmath.cos(half), *q4.scaled(axis, mpmath.sin(half) / q4.norm(axis))]
    q = exact([1, 0, 0, 0])
    for letter, angle in zip(form, numbers):
        turn = q4.exp([angle * one / 2 if x == letter.upper() else mpf(0) for x in "XYZ"])
        q = q4.product(q, turn) if letter.isupper() else q4.product(turn, q)
    return q


def forms(rng):
    """The golden rows of keys in other forms are those of the exact rotations."""
    form = rng.choice(["axis-angle", "axis-angle,relative", "XYZ", "ZYX", "zxz", "yzx", "matrix"])
    degrees, decimal, preset = rng.random() < 0.5, rng.random() < 0.5, rng.choice(list(PRESETS))
    one, is_axis = mpmath.pi / 180 if degrees else mpf(1), form.startswith("axis-angle")
    widest = 2.2 if form == "axis-angle,relative" else 1.1
    names = {"axis-angle": "abcd", "matrix": "abcdefghi"}.get(form.split(",")[0], "abc")
    columns = ("axis-angle=" if is_axis else "matrix=" if form == "matrix" else "euler=") + ":".join(names)
    columns += form[10:] if is_axis else "" if form == "matrix" else f",order={form}"
    lines, keys, before = [",".join("t" + names)], [], exact([1, 0, 0, 0])
    for t in range(rng.randint(2, 6)):
        angles = [rng.uniform(-widest, widest) / (1 if is_axis else 2) / float(one) for _ in range(1 if is_axis else 3)]
        written = [f"{x:.9f}" for x in ([rng.gauss(0, 1) for _ in range(3)] if is_axis else []) + angles]
        if form == "matrix":  # of less than half a turn from key to key
            digits = rng.choice([4, 7, 12])
            written = [f"{float(x):.{digits}f}" for x in q4.matrix(turned(rng, [1, 0, 0, 0], widest))]
        q = turn_of(form, [mpf(x) if decimal else mpf(float(x)) for x in written], one)
        if form.endswith("relative"):
            q = before = q4.product(q, before) if preset == "nel" else q4.product(before, q)
        lines.append(",".join([str(t), *written]))
        keys.append((mpf(t), q, exact([0] * 3), exact([0] * 2)))
    rule, end, name = PRESETS[preset]
    curve = q4.Rotations(keys, name, rule, [end, end])
    options = ["--rotation", columns, "--preset", preset, "--rotation-output", "quaternion", "--golden",
               *["--exact-input"] * decimal, *["--angles", "degrees"] * degrees, "--per-segment", "4"]
    for row in blocks("\n".join(lines) + "\n", *options)[0]:
        got = [float(x) for x in (row["qw"], row["qx"], row["qy"], row["qz"])]
        same(got, list(map(rounded, q4.nearest(curve.at(mpf(float(row["t"])))[0], exact(got)))), f"{form} at {row['t']}")


def law(rng):
    rng.choice([at_times, at_times, at_times, invariants, one_axis, beyond, beside_positions, forms])(rng)


check(law, 12, least=3)
