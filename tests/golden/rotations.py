"""Curves of rotations against 50 digits: rotations.py PROGRAM [CASES [SEED]].

The numbers of the table in NUMBERS; random keys through every curve, tangent rule and end rule; laws. Every difference
is reported; exit 1: there is one. Exit 77: there is no mpmath.
"""
import math
import random
import subprocess
import sys
from fractions import Fraction

sys.dont_write_bytecode = True
try:
    import mpmath
    from mpmath import mp, mpf
except ImportError:
    print("skipped: there is no python3-mpmath")
    sys.exit(77)
import quaternions as q4

mp.dps = 50
program = sys.argv[1]
cases = int(sys.argv[2]) if len(sys.argv) > 2 else 8
draw = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 24)
failures, largest, compared = 0, {}, {}
header = "t,qx,qy,qz,qw,tension,continuity,bias,ease_in,ease_out"
tangent_rules = ["velocity", "uniform", "interval", "interval-c", "finite-difference", "kb1984", "synfig"]
end_rules = ["half", "one-sided", "mirror", "chord", "zero", "natural", "natural-tension", "cry", "lightwave"]
curves = ["squad", "casteljau", "components", "slerp"]
# The rules that presets give to rotations, by the products' sources.
presets = {"gte": ("velocity", "half", "squad"), "lib3ds1": ("interval-c", "chord", "squad"),
           "lib3ds2": ("interval-c", "mirror", "squad"), "nel": ("interval-c", "mirror", "squad"),
           "cryengine": ("interval-c", "mirror", "squad"), "3dsmax": ("interval-c", "mirror", "squad"),
           "vtk": ("uniform", "chord", "squad"), "splines": ("finite-difference", "natural", "casteljau")}

# rule, curve, ends, time, (w, x, y, z): the keys of numbers_keys() through running programs, or by their sources.
NUMBERS = [
    ("interval", "squad", "half", 2, ".779176692337 .540451134321 .314552826549 -.043043847883"),
    ("interval", "squad", "half", 3.5, ".687872486392 .131877994085 .673875620837 .235226029133"),
    ("finite-difference", "casteljau", "natural", .5, ".940820154506 .337589624763 -.029844298071 0"),
    ("finite-difference", "casteljau", "natural", 2, ".718135420408 .595129990211 .351580872026 -.080577311520"),
    ("interval-c", "squad", "mirror", .5, ".953175406424 .291688986113 -.079838461709 0"),
    ("interval-c", "squad", "mirror", 2, ".783629966631 .533543549069 .315578343863 -.040812565826"),
]


def report(what, got, want, keys_text=None):
    global failures
    failures += 1
    if failures <= 10:
        print(f"{what}\n  got      {got}\n  expected {want}" + (f"\n{keys_text}" if keys_text else ""), file=sys.stderr)


def keep(kind, error):
    largest[kind], compared[kind] = max(largest.get(kind, mpf(0)), error), compared.get(kind, 0) + 1


def within(what, got, want, limit, *context):
    """Whether numbers are equal within a limit; the largest difference of each kind is kept."""
    error = max(abs(mpf(g) - w) for g, w in zip(got, want, strict=True))
    keep(what.split(":")[0], error)
    if error > limit:
        report(f"{what}: differs by {mpmath.nstr(error, 3)}", list(got), [mpmath.nstr(w, 20) for w in want], *context)
    return error <= limit


def text(x):
    return repr(float(x))


def csv_of(keys):
    lines = [header]
    for t, (w, x, y, z), tcb, ease in keys:
        lines.append(",".join(map(text, [t, x, y, z, w, *tcb, *ease])))
    return "\n".join(lines) + "\n"


def rows(keys_text, *options):
    done = subprocess.run([program, "-q", *options], input=keys_text, text=True, capture_output=True)
    if done.returncode != 0:
        report(" ".join(options), done.stderr, "rows", keys_text)
        return []
    return [list(map(float, line.split(","))) for line in done.stdout.splitlines()[1:]]


def at(times):
    return ["--at", ",".join(map(text, times))]


def wxyz(row, first=1):
    x, y, z, w = row[first:first + 4]
    return [w, x, y, z]


def exact(keys):
    return [(mpf(t), list(map(mpf, q)), tuple(map(mpf, tcb)), tuple(map(mpf, ease))) for t, q, tcb, ease in keys]


def is_unit(row):
    """The norm is 1 within 2 units in the last place of 1, by exact arithmetic."""
    square = sum(Fraction(x) ** 2 for x in row)
    ulp = Fraction(1, 2 ** 52)
    keep("norm in units of 1", mpf(float(abs(square - 1) / 2 / ulp)))
    return (1 - 2 * ulp) ** 2 <= square <= (1 + 2 * ulp) ** 2


def check_rows(what, got, keys_text):
    """Rows are unit, and their signs do not jump."""
    for row in got:
        if not is_unit(wxyz(row)):
            report(f"{what}: the norm at t = {row[0]}", row, "1 within 2 ulp", keys_text)
    for row, after in zip(got, got[1:]):
        if q4.dot(wxyz(row), wxyz(after)) < 0:
            report(f"{what}: the sign jumps", row, after, keys_text)


def numbers_keys():
    keys = []
    tcb = [(.2, -.3, .4), (0, .5, -.25), (-.5, .25, .5), (.3, -.6, -.2), (.1, .4, .3)]
    turns = [((1, 0, 0), 0), ((1, 0, 0), 60), ((1, 2, 0), 100), ((0, 1, 1), 80), ((1, 1, 1), 150)]
    for t, one, (axis, degrees) in zip((0, 1, 3, 4, 6), tcb, turns):
        half = mpf(degrees) * mpmath.pi / 360
        direction = [x / mpmath.sqrt(sum(y * y for y in axis)) for x in map(mpf, axis)]
        keys.append((t, list(map(float, q4.exp(q4.scaled(direction, half)))), one, (0, 0)))
    return keys


def check_numbers():
    keys = numbers_keys()
    for rule, curve, ends, t, digits in NUMBERS:
        want = list(map(mpf, digits.split()))
        decimal = [(t, q, tuple(mpf(str(x)) for x in tcb), ease) for t, q, tcb, ease in keys]
        reference = q4.Rotations(exact(decimal), curve, rule, [ends, ends]).at(mpf(t))[0]
        within("the reference and the table", reference, want, mpf("1e-12"))
        got = rows(csv_of(keys), "--tangents", rule, "--ends", ends, "--rotation-curve", curve, *at([t]))
        for row in got:
            within("the table", wxyz(row), want, mpf("1e-11"), csv_of(keys))
            within(f"the table's reference: {rule} {curve} at {t}", wxyz(row), reference, 16 * mpf("1e-16"), csv_of(keys))


def random_rotation():
    q = [draw.gauss(0, 1) for _ in range(4)]
    size = math.sqrt(sum(x * x for x in q))
    return [x / size for x in q]


def random_turn(q, widest):
    axis = random_rotation()[:3]
    size, half = math.sqrt(sum(x * x for x in axis)), draw.uniform(0, widest) / 2
    r = q4.product(list(map(mpf, q)), q4.exp([mpf(x) / size * half for x in axis]))
    return [float(draw.choice([1, 1, -1]) * x) for x in r]  # a sign means nothing


def random_keys(eased, widest=2.5):
    keys, t, q = [], draw.randint(-40, 40) / 8, random_rotation()
    for _ in range(draw.randint(2, 8)):
        tcb = [draw.choice([0, draw.randint(-32, 32) / 32]) for _ in range(3)]
        ease = [draw.choice([0, draw.randint(0, 28) / 32]) for _ in range(2)] if eased else [0, 0]
        keys.append((t, q, tcb, ease))
        t, q = t + draw.randint(1, 24) / 8, random_turn(q, widest)
    return keys


def random_curve():
    """Keys, options, and the reference."""
    curve, rule = draw.choice(curves), draw.choice(tangent_rules)
    ends = [draw.choice(end_rules), draw.choice(end_rules)]
    keys = random_keys(draw.random() < 0.4)
    closed, equal = len(keys) > 2 and draw.random() < 0.3, draw.random() < 0.15
    if draw.random() < 0.25:
        name = draw.choice(list(presets))
        rule, end, curve = presets[name]
        ends, options = [end, end], ["--preset", name]
    else:
        options = ["--tangents", rule, "--rotation-curve", curve] + ([] if closed else ["--ends", ",".join(ends)])
    period = None
    if equal:
        options.append("--equal-speed")
    if closed:
        period = keys[-1][0] - keys[0][0] + draw.randint(4, 24) / 8
        options += ["--closed", "--period", text(period)]
    return keys, options, q4.Rotations(exact(keys), curve, rule, ends, period and mpf(period), equal)


def check_random(number):
    keys, options, reference = random_curve()
    first, last = float(reference.times[0]), float(reference.times[-1])
    times = sorted({first + (last - first) * draw.randint(1, 4095) / 4096 for _ in range(10)} | {keys[0][0], keys[-1][0]})
    keys_text = csv_of(keys)
    fields = ["--fields", "time,position,angular_velocity,angular_speed"]
    got = rows(keys_text, *options, *fields, *at(times))
    scale = max([mpf(1)] + [abs(x) for row in got for x in row[5:8]])
    for row in got:
        i = reference.segment_at(mpf(row[0]))
        # Near half a turn on the sphere of quaternions the weights of a slerp are quotients by a small sine.
        if reference.widest(i) > 3:
            continue
        value, velocity = reference.at(mpf(row[0]), i)
        value = q4.nearest(value, list(map(mpf, wxyz(row))))
        good = within(f"rows: {options} at {row[0]}", wxyz(row), value, mpf("2e-15"), keys_text)
        if good and row[0] not in [key[0] for key in keys]:
            within(f"angular_velocity over its largest: {options} at {row[0]}", [x / scale for x in map(mpf, row[5:8])],
                   q4.scaled(velocity, 1 / scale), mpf("1e-12"), keys_text)
            within(f"angular_speed over its largest: {options} at {row[0]}", [mpf(row[8]) / scale],
                   [q4.norm(velocity) / scale], mpf("1e-12"), keys_text)
    many = rows(keys_text, *options, "--count", "200")
    check_rows(f"{options}", many, keys_text)
    if many and max(abs(a - b) for a, b in zip(wxyz(many[0]), keys[0][1])) > 4e-16:
        report(f"{options}: the first row has the first key's sign", many[0], keys[0][1], keys_text)
    return keys, options, reference


def same(what, one, other, limit, keys_text):
    """Two lists of quaternions are the same rotations."""
    for p, q in zip(one, other, strict=True):
        p, q = list(map(mpf, p)), list(map(mpf, q))
        within(what, q4.nearest(p, q), q, limit, keys_text)


def check_laws(keys, options, reference):
    first, last = float(reference.times[0]), float(reference.times[-1])
    times = [first + (last - first) * k / 16 for k in range(16)]
    if max(reference.widest(i) for i in range(reference.count)) > 3:
        return
    keys_text = csv_of(keys)
    base = list(map(wxyz, rows(keys_text, *options, *at(times))))
    if not base:
        return
    limit = mpf("4e-15")  # two rows, each within 2e-15
    left, right = random_rotation(), random_rotation()
    moved = [(t, list(map(float, q4.product(q4.product(left, q), right))), *rest) for t, q, *rest in keys]
    got = list(map(wxyz, rows(csv_of(moved), *options, *at(times))))
    same(f"law of constant rotations: {options}", got,
         [q4.product(q4.product(list(map(mpf, left)), q), right) for q in base], limit, keys_text)
    signs = [draw.choice([1, -1]) for _ in keys]
    flipped = [(t, [sign * x for x in q], *rest) for (t, q, *rest), sign in zip(keys, signs)]
    same(f"law of signs: {options}", list(map(wxyz, rows(csv_of(flipped), *options, *at(times)))), base, mpf(0), keys_text)
    if reference.closed:
        place, sign = options.index("--period"), draw.choice([1, -1])
        t, q, *rest = keys[0]
        repeated = keys + [(t + float(options[place + 1]), [sign * x for x in q], *rest)]
        got = list(map(wxyz, rows(csv_of(repeated), *options[:place], *options[place + 2:], *at(times))))
        same(f"law of a repeated first key: {options}", got, base, mpf(0), csv_of(repeated))
        check_rows(f"{options} repeated", rows(keys_text, *options, "--extrapolate", "repeat", "--from", text(first - 20),
                                               "--to", text(last + 20), "--count", "400"), keys_text)
    if not reference.closed:
        back = [(-t, q, (a, b, -c), ease[::-1]) for t, q, (a, b, c), ease in reversed(keys)]
        mirrored = [",".join(reversed(x.split(","))) if y == "--ends" else x for y, x in zip([""] + options, options)]
        got = list(map(wxyz, rows(csv_of(back), *mirrored, *at([-t for t in reversed(times)]))))
        same(f"law of reversal: {options}", got, base[::-1], limit, keys_text)
    at_keys = list(map(wxyz, rows(keys_text, *options, *at([key[0] for key in keys]))))
    same(f"law of keys: {options}", at_keys, reference.quaternions[:len(keys)], mpf("2.5e-16"), keys_text)


def check_one_axis():
    """Turns about one axis by casteljau are the curve of the angle, without natural ends and arcs of half a circle."""
    keys = random_keys(True)
    angles, axis = [draw.uniform(-2, 2)], random_rotation()[:3]
    axis = q4.scaled(list(map(mpf, axis)), 1 / q4.norm(list(map(mpf, axis))))
    for _ in keys[1:]:
        angles.append(angles[-1] + draw.uniform(-2.5, 2.5))
    turns = [(t, list(map(float, q4.exp(q4.scaled(axis, mpf(a) / 2)))), *rest) for (t, _, *rest), a in zip(keys, angles)]
    plain = "t,a,tension,continuity,bias,ease_in,ease_out\n" + "".join(
        ",".join(map(text, [t, a, *tcb, *ease])) + "\n" for (t, _, tcb, ease), a in zip(keys, angles))
    ends, rule = draw.choice([rule for rule in end_rules if rule != "natural"]), draw.choice(tangent_rules)
    options = ["--tangents", rule, "--ends", ends, "--count", "33"]
    reference = q4.Rotations(exact(turns), "casteljau", rule, [ends, ends])
    for chord, out, into in zip(reference.chords, reference.outs, reference.ins):
        if max(q4.norm(v) for v in (out, into, [3 * d - o - m for d, o, m in zip(chord, out, into)])) > 3 * 2.2:
            return
    got = list(map(wxyz, rows(csv_of(turns), *options, "--rotation-curve", "casteljau")))
    want = [q4.exp(q4.scaled(axis, mpf(row[1]) / 2)) for row in rows(plain, *options)]
    same(f"law of one axis: {options}", got, want, mpf("8e-15"), csv_of(turns))


def check_velocities():
    """Given velocities of the four numbers, with keys that are nearly unit and of any sign."""
    keys = [(t, q4.scaled(q, 1 + draw.uniform(-1, 1) * 1e-4), tcb, ease) for t, q, tcb, ease in random_keys(True)]
    curve = draw.choice(["squad", "casteljau", "components"])
    velocities = [[[draw.gauss(0, 0.3) for _ in range(4)] for _ in range(2)] for _ in keys]
    reference = q4.Rotations(exact(keys), curve, "velocity", ["half", "half"])
    reference.give([[list(map(mpf, v)) for v in both] for both in velocities])
    if max(reference.widest(i) for i in range(reference.count)) > 3:
        return
    lines = ["t,qw,qx,qy,qz,ease_in,ease_out," + ",".join(f"q{c}_v{side}" for side in ("in", "out") for c in "wxyz")]
    for (t, q, _, ease), (before, after) in zip(keys, velocities):
        lines.append(",".join(map(text, [t, *q, *ease, *before, *after])))
    keys_text, options = "\n".join(lines) + "\n", ["--rotation-curve", curve]
    times = sorted(keys[0][0] + (keys[-1][0] - keys[0][0]) * draw.randint(1, 4095) / 4096 for _ in range(8))
    for row in rows(keys_text, *options, *at(times)):
        want = q4.nearest(reference.at(mpf(row[0]))[0], row[1:])
        within(f"given velocities: {options} at {row[0]}", row[1:], want, mpf("2e-15"), keys_text)
    for row in rows(keys_text, *options, "--golden", *at(times[:2])):
        want = list(map(float, q4.nearest(reference.at(mpf(row[0]))[0], row[1:])))
        if want != row[1:]:
            report(f"golden with given velocities: {options} at {row[0]}", row[1:], want, keys_text)


def check_extrapolation():
    keys = random_keys(False)
    ends, curve = draw.choice(end_rules), draw.choice(curves)
    reference = q4.Rotations(exact(keys), curve, "velocity", [ends, ends])
    if max(reference.widest(i) for i in range(reference.count)) > 3:
        return
    first, last = keys[0][0], keys[-1][0]
    times = [first - 2.25 * (last - first), first - (last - first) * .375, last + .125, last + 1.8125 * (last - first)]
    kinds = ["hold", "linear", "repeat", "oscillate", "offset"]
    for before, after in [*zip(kinds, kinds), draw.sample(kinds, 2)]:
        options = ["--extrapolate", f"{before},{after}", "--ends", ends, "--rotation-curve", curve]
        for row in rows(csv_of(keys), *options, *at(times)):
            how = before if row[0] < first else after
            want = q4.nearest(reference.beyond(how, mpf(row[0])), list(map(mpf, wxyz(row))))
            limit = mpf("4e-15")
            if how == "linear":  # the rounding error of the velocity, of the size of the segment's, grows with time
                end, other, i = (first, keys[1][0], 0) if row[0] < first else (last, keys[-2][0], -1)
                turn = 2 * q4.norm(reference.outs[i]) + 2 * q4.norm(reference.ins[i]) + mpf("2.5")
                limit *= 1 + turn * abs((row[0] - end) / (other - end))
            within(f"extrapolation {how}: {options} at {row[0]}", wxyz(row), want, limit, csv_of(keys))


def check_positions(keys, options):
    """Rotations and positions do not see each other, also under other names and in another order of columns."""
    places = [[draw.uniform(-9, 9) for _ in range(3)] for _ in keys]

    def table(names, cells):
        lines = [f"t,{names},tension,continuity,bias,ease_in,ease_out"]
        for (t, q, tcb, ease), place in zip(keys, places):
            lines.append(",".join(map(text, [t, *cells(place, q), *tcb, *ease])))
        return "\n".join(lines) + "\n"

    rotations = rows(csv_of(keys), *options, "--count", "9")
    plain = rows(table("x,y,z", lambda p, q: p), *options, "--count", "9")
    both = rows(table("x,y,z,a,b,c,d", lambda p, q: p + q), *options, "--count", "9", "--rotation", "quaternion=b:c:d:a")
    if [row[:4] for row in both] != plain:
        report(f"positions with rotations: {options}", both, plain, csv_of(keys))
    if [row[4:8] for row in both] != [wxyz(row) for row in rotations]:
        report(f"names and order of columns: {options}", both, rotations, csv_of(keys))
    mixed = table("x,qw,qx,y,qy,qz,z", lambda p, q: [p[0], q[0], q[1], p[1], q[2], q[3], p[2]])
    lengths = rows(table("x,y,z", lambda p, q: p), *options, "--arc-count", "9")
    got = rows(mixed, *options, "--arc-count", "9")
    if [[row[0], row[1], row[4], row[7]] for row in got] != lengths:
        report(f"lengths with rotations: {options}", got, lengths, mixed)


def check_golden(keys, options, reference):
    first, last = float(reference.times[0]), float(reference.times[-1])
    times = [first + (last - first) * (k + .125) / 8 for k in range(8)]
    fields = ["--fields", "time,position,angular_velocity,angular_speed"]
    for row in rows(csv_of(keys), *options, "--golden", *fields, *at(times)):
        value, velocity = reference.at(mpf(row[0]))
        value = q4.nearest(value, list(map(mpf, wxyz(row))))
        # Differences leave less than 1e-28 of a velocity that is zero.
        want = [float(x) if abs(x) > mpf(10) ** -28 else 0.0 for x in [*value, *velocity, q4.norm(velocity)]]
        if want != wxyz(row) + row[5:]:
            report(f"golden {options} at {row[0]}", wxyz(row) + row[5:], want, csv_of(keys))
        compared["golden"] = compared.get("golden", 0) + 1


def quaternion_of(rows):
    """The rotation nearest to a matrix: the orthogonal factor of its singular value decomposition, as axis and angle."""
    u, _, v = mpmath.svd_r(mpmath.matrix(rows))
    r = u * v
    double_sine = [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]]
    half = mpmath.atan2(q4.norm(double_sine), r[0, 0] + r[1, 1] + r[2, 2] - 1) / 2
    return [mpmath.cos(half), *q4.scaled(double_sine, mpmath.sin(half) / q4.norm(double_sine))]


def matrix_text(q, digits):
    """The matrix of a quaternion, rounded."""
    w, x, y, z = q
    rows = [[w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z]]
    return [f"{float(number):.{digits}f}" for row in rows for number in row]


def turn_of(form, numbers, unit):
    """The rotation by the definition of its form; numbers and unit are exact."""
    if form == "matrix":
        return quaternion_of([numbers[:3], numbers[3:6], numbers[6:]])
    if form.startswith("axis-angle"):
        axis, half = numbers[:3], numbers[3] * unit / 2
        return [mpmath.cos(half), *q4.scaled(axis, mpmath.sin(half) / q4.norm(axis))]
    q = [mpf(1), mpf(0), mpf(0), mpf(0)]
    for letter, angle in zip(form, numbers):
        turn = q4.exp([angle * unit / 2 if x == letter.upper() else mpf(0) for x in "XYZ"])
        q = q4.product(q, turn) if letter.isupper() else q4.product(turn, q)
    return q


def check_forms():
    """The golden rows of keys in other forms are those of the exact rotations."""
    form = draw.choice(["axis-angle", "axis-angle,relative", "XYZ", "ZYX", "zxz", "yzx", "matrix"])
    degrees, decimal, preset = draw.random() < 0.5, draw.random() < 0.5, draw.choice(["gte", "nel", "splines"])
    unit = mpmath.pi / 180 if degrees else mpf(1)
    widest = 2.2 if form == "axis-angle,relative" else 1.1
    is_axis = form.startswith("axis-angle")
    names = {"axis-angle": "abcd", "matrix": "abcdefghi"}.get(form.split(",")[0], "abc")
    columns = ("axis-angle=" if is_axis else "matrix=" if form == "matrix" else "euler=") + ":".join(names)
    columns += form[10:] if is_axis else "" if form == "matrix" else f",order={form}"
    lines, keys, before = [",".join("t" + names)], [], [mpf(1), mpf(0), mpf(0), mpf(0)]
    for t in range(draw.randint(2, 6)):
        angles = [draw.uniform(-widest, widest) / (1 if is_axis else 2) / float(unit) for _ in range(1 if is_axis else 3)]
        written = [f"{x:.9f}" for x in ([draw.gauss(0, 1) for _ in range(3)] if is_axis else []) + angles]
        if form == "matrix":
            axis = [draw.gauss(0, 1) for _ in range(3)]
            half = draw.uniform(.1, widest) / 2  # of less than half a turn from key to key
            turn = [math.cos(half), *(math.sin(half) * x / math.hypot(*axis) for x in axis)]
            written = matrix_text(turn, draw.choice([4, 7, 12]))
        numbers = [mpf(x) if decimal else mpf(float(x)) for x in written]
        q = turn_of(form, numbers, unit)
        if form.endswith("relative"):
            q = before = q4.product(q, before) if preset == "nel" else q4.product(before, q)
        lines.append(",".join([str(t), *written]))
        keys.append((mpf(t), q, (mpf(0),) * 3, (mpf(0),) * 2))
    options = ["--rotation", columns, "--preset", preset, "--rotation-output", "quaternion",
               "--golden", *["--exact-input"] * decimal, *["--angles", "degrees"] * degrees]
    rule, end, curve = presets[preset]
    reference = q4.Rotations(keys, curve, rule, [end, end])
    times = [k / 4 for k in range(4 * len(keys) - 3)]
    for row in rows("\n".join(lines) + "\n", *options, *at(times)):
        value = q4.nearest(reference.at(mpf(row[0]))[0], list(map(mpf, wxyz(row))))
        want = [float(x) if abs(x) > mpf(10) ** -40 else 0.0 for x in value]
        if want != wxyz(row):
            report(f"golden of other forms: {options} at {row[0]}", wxyz(row), want, "\n".join(lines))
        compared["golden of other forms"] = compared.get("golden of other forms", 0) + 1


check_numbers()
probe = subprocess.run([program, "-q", "--golden", "--count", "3"], input=csv_of(numbers_keys()), text=True,
                       capture_output=True)
if probe.returncode != 0:
    print("skipped: --golden of rotations:", probe.stderr.splitlines()[0])
for number in range(cases):
    curve = check_random(number)
    if number % 4 == 0:
        check_laws(*curve)
        check_one_axis()
    if number % 4 == 1:
        check_extrapolation()
        check_velocities()
    if number % 4 == 3:
        check_positions(curve[0], curve[1])
    if number % 4 == 2 and probe.returncode == 0:
        check_golden(*curve)
        check_forms()
for kind, error in sorted(largest.items()):
    print(f"{kind}: {compared[kind]} compared, largest difference {mpmath.nstr(error, 3)}")
for kind in ("golden", "golden of other forms"):
    print(f"{kind}: {compared.get(kind, 0)} rows compared")
print(f"{failures} failures")
sys.exit(1 if failures else 0)
