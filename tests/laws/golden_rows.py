"""Golden rows do not depend on each other, also with numbers from 1e-300 to 1e300; and numbers within a few units of
powers of ten are printed with 1 to 40 digits, exactly, as bounded numbers and as what lies at a length."""
import decimal
from decimal import Decimal

from keys import Keys
from law import Failure, check, lines, require, same

decimal.getcontext().prec = 400


def hostile(rng):
    return rng.choice([0, 1, -1, rng.uniform(-9, 9)]) * 10.0 ** rng.choice([0, 0, 0, 1, -1, rng.randint(-300, 299)])


def alone_and_together(rng):
    """Each list of places is printed in one run, in reverse, shuffled, and row by row."""
    keys = Keys(rng, "equal gaps groups sparse given" + " closed" * (rng.random() < 0.5), ["whole", "double"], count=rng.choice([2, 3, 5]))
    if rng.random() < 0.5 and not keys.closed:
        for row in keys.curves[0]:
            row[0] = [repr(hostile(rng)) for _ in row[0]]
        keys.times = list(map(repr, sorted({hostile(rng) if rng.random() < 0.4 else float(t) for t in keys.times})))
        keys.curves[0] = keys.curves[0][:len(keys.times)]
    if len(keys.times) < 2:
        return
    keys.cuts = [0, len(keys.times)]
    fields = ["time", "position", "velocity", "acceleration", *["speed", "tangent", "curvature", "torsion", "s"] * (
        len(keys.names()) < 12), *["angular_velocity"] * keys.rotations]
    fields = rng.sample(fields[:-1] if "s" in fields and rng.random() < 0.8 else fields, 2)
    options = ["--golden", *keys.options(), "--fields", ",".join(fields)]
    places = [repr(float(t)) for t in keys.times] + [
        repr(float(a) + rng.random() * (float(b) - float(a))) for a, b in zip(keys.times, keys.times[1:])]
    try:
        alone = {place: lines(keys.text(), *options, f"--at={place}") for place in places}
    except Failure as failure:  # a number beyond the range of doubles
        require(str(failure).startswith(("exit code 1: standard input", "exit code 2: tcbsample: error")), failure)
        return
    for order in (places, places[::-1], rng.sample(places, len(places))):
        same(lines(keys.text(), *options, f"--at={','.join(order)}"), sum((alone[place] for place in order), []), "rows together")


def in_digits(value, count):
    with decimal.localcontext() as context:
        context.prec = count
        return +value


def digits(rng):
    count, near_ten = rng.randint(1, 40), []
    for exponent in (0, 1, -1, rng.randint(-30, 30)):
        for unit in (count, count + 1, rng.choice([16, 17, 31])):
            off = Decimal(rng.choice([-6, -5, -4, -2, -1, 1, 4, 5, 6])).scaleb(exponent - unit)
            near_ten.append(Decimal(10) ** exponent + off)
    # Between two keys with one position and no tangents the curve is constant.
    text = "t,x,tension\n" + "".join(f"{2 * i},{x},1\n{2 * i + 1},{x},1\n" for i, x in enumerate(near_ten))
    middles, golden = ",".join(f"{2 * i}.5" for i in range(len(near_ten))), ["--golden", "--digits", str(count)]
    for options in ([], ["--exact-input"]):
        rows = lines(text, *golden, f"--at={middles}", "--fields", "position", "--ends", "zero", *options)
        exact = [x if options else Decimal(float(x)) for x in near_ten]
        same([Decimal(row[0]) for row in rows], [in_digits(x, count) for x in exact], f"numbers with {count} digits")
    # A tangent of a line is the root of a rational; what lies at a length is found by floats.
    slope = float(near_ten[0])
    tangent = Decimal(slope) / (1 + Decimal(slope) ** 2).sqrt()
    for place in ("--at=0.5", "--arc-at=0.25"):
        ((_, y),) = lines(f"t,x,y\n0,0,0\n1,1,{slope!r}\n", *golden, "--ends", "chord", place, "--fields", "tangent")
        same(Decimal(y), in_digits(tangent, count), f"a tangent with {count} digits, {place}")


check(lambda rng: alone_and_together(rng) if rng.random() < 0.6 else digits(rng), 12, least=1)
