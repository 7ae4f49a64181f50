"""Rows do not depend on where times begin, nor on how they are written: as frames, timecode, dates, clock times, numbers.

The same keys from 0 and from far away have the same bits. They are those of the exact curve at the time that the text of
a row names. With --time-zero first the bytes are the same, and rows compare with their keys."""
import datetime
import math
from fractions import Fraction

from keys import ENDS, Keys, decimal
from law import blocks, check, near, run, same, write

RATES = ["24", "25", "30", "24000/1001", "30000/1001", "60000/1001"]
ORDERS = {"": 0, "_v": 1}


def timecode(frame, rate, drops):
    """The text of a frame, by counting the minutes whose first numbers are dropped."""
    nominal = math.ceil(rate)
    if drops:
        dropped = nominal // 15
        minute, ten_minutes = nominal * 60 - dropped, nominal * 600 - 9 * dropped
        tens, rest = divmod(frame, ten_minutes)
        frame += dropped * 9 * tens + (dropped * ((rest - dropped) // minute) if rest >= dropped else 0)
    seconds, number = divmod(frame, nominal)
    return f"{clock(seconds)}{';' if drops else ':'}{number:02}"


def decimals(t):
    """Those of a time, without a whole part."""
    digits = f"{int((t - math.floor(t)) * 10 ** 9):09}".rstrip("0")
    return "." + digits if digits else ""


def date(t):
    whole = datetime.datetime(1970, 1, 1) + datetime.timedelta(seconds=math.floor(t))
    return whole.strftime("%Y-%m-%dT%H:%M:%S") + decimals(t) + "Z"


def clock(t):
    s = math.floor(t)
    return f"{s // 3600:02}:{s // 60 % 60:02}:{s % 60:02}" + decimals(t)


def of_date(text):
    whole, _, rest = text.rstrip("Z").partition(".")
    seconds = datetime.datetime.strptime(whole, "%Y-%m-%dT%H:%M:%S") - datetime.datetime(1970, 1, 1)
    return Fraction(seconds.days * 86400 + seconds.seconds) + Fraction("0." + (rest or "0"))


def of_clock(text):
    hours, minutes, seconds = text.split(":")
    return Fraction(int(hours) * 3600 + int(minutes) * 60) + Fraction(seconds)


def of_frames(printed, rate):
    """A double that is the nearest to a frame, or to a thousandth of one, is that."""
    part = Fraction(round(Fraction(printed) * rate * 1000)) / 1000 / rate
    return part if float(part) == float(printed) else Fraction(float(printed))


def notations(rng):
    """Unit of times, shift, writers of near and far times, options, reader of the times of rows, and ways of sampling."""
    text = rng.choice(RATES)
    rate, steps = Fraction(text), rng.choice(["1/10", "1/20", "1/8", "1/100"])
    drops = rate.denominator > 1 and text[0] != "2" and rng.random() < 0.5
    hour = 3600 * math.ceil(rate)
    shift = rng.choice([1, 1, 2, 10, 23]) * hour + rng.randint(0, 3600)
    shift -= shift % (hour // 6 - 9 * (math.ceil(rate) // 15)) if drops else 0
    fps, digits = ["--input-fps", text], rng.choice([0, 1, 3, 6, 9])
    grids = [["--step", steps], ["--count", str(rng.randint(2, 30))], ["--per-segment", str(rng.randint(1, 5))],
             ["--step", steps, "--keys"]]
    frames = lambda t: str(Fraction(t) * rate)
    return rng.choice([
        (1 / rate, shift / rate, "frame", frames, lambda t: timecode(int(Fraction(t) * rate) + shift, rate, drops),
         [*fps, "--time-format", "frames"], lambda t: int(t) / rate, [["--rate", text], ["--rate", text, "--keys"]]),
        (1 / rate, shift / rate, "frame", frames, lambda t: str(Fraction(t) * rate + shift),
         [*fps, "--time-format", "seconds"], lambda t: of_frames(t, rate), [["--count", "20"], ["--per-segment", "3"]]),
        (Fraction(1, 10 ** digits), 1700006400, "t", lambda t: date(Fraction(t)), lambda t: date(Fraction(t) + 1700006400), [],
         of_date, grids),
        (Fraction(1, 10 ** digits), 7200, "t", lambda t: clock(Fraction(t)), lambda t: clock(Fraction(t) + 7200), [],
         of_clock, grids)])


def law(rng):
    unit, shift, column, near_text, far_text, options, read, grids = notations(rng)
    keys = Keys(rng, "equal gaps velocities", [unit], ends=ENDS[:-1], repeats=True)
    grid, left = rng.choice(grids), rng.random() < 0.5
    if (Fraction(keys.end) / Fraction(grid[1]) if grid[0] == "--step" else 0) > 300:
        grid = ["--count", "30"]
    options = [*keys.options(), *options, *grid, "--fields", "time,position,velocity", *["--side", "left"] * left]
    at_0, far_away = keys.text(time=near_text, column=column), keys.text(time=far_text, column=column if column == "frame" and
                                                                         ":" not in far_text("0") else "t")
    tables = [blocks(at_0, *options), blocks(far_away, *options), blocks(far_away, *options, "--golden")]
    for part, *parts in zip(keys.parts(), *tables, strict=True):
        for from_0, row, golden in zip(*parts, strict=True):
            first = len(keys.labels) > 1  # after the label
            (near_time, *close), (far_time, *numbers) = (list(one.values())[first:] for one in (from_0, row))
            t = read(far_time) - shift
            if read(near_time) == t:  # far away, times between decimals may be printed with fewer digits
                same(numbers, close, f"far from 0, at {far_time}")
            for c, name in enumerate(keys.channels):
                state = part.at(c, t, left)
                for suffix, order in ORDERS.items():
                    same(float(golden[name + suffix]), float(state[order]), f"--golden {name}{suffix} at {far_time}")
                near(float(row[name]), state[0], 3 * Fraction(math.ulp(float(part.size(c, t, left)))), f"{name} at {far_time}")


def from_first(rng):
    """The rows of --time-zero first are those of keys that begin at 0, byte for byte, and compare with their keys."""
    if rng.random() < 0.5:
        rate = rng.choice(RATES)
        column, unit, zero, write_time = "frame", Fraction(1), rng.choice([rng.randint(1, 50), rng.randint(1, 100000)]), str
        options, grids = ["--input-fps", rate], [["--fps", rate], ["--fps", "60"], ["-n", "7"], ["--step", "1/7"]]
    else:
        digits = rng.choice([1, 2, 3, 6])
        column, unit, write_time = "t", Fraction(1, 10 ** digits), lambda t: decimal(Fraction(t), digits)
        zero = rng.choice([unit * rng.randint(1, 3000), unit * rng.randint(1, 3000) + 17 * 10 ** 8])
        options, grids = [], [["--step", decimal(10 * unit, digits)], ["-n", "7"], ["--rate", str(1 / unit / 7)], ["--per-segment", "3"]]
    keys = Keys(rng, "gaps", [unit], repeats=True)
    at_0 = keys.text(time=write_time, column=column)
    far_away = keys.text(time=lambda t: write_time(str(Fraction(t) + zero)), column=column)
    options, grid = [*keys.options(), *options], rng.choice(grids)
    more = rng.choice([[], ["--fields", "time,position,velocity"]]) + rng.choice([[], ["--golden"]])
    rows = run(far_away, "-q", *options, *grid, *more, "--time-zero", "first").stdout
    same(rows, run(at_0, "-q", *options, *grid, *more).stdout, "with --time-zero first")
    if "--golden" not in more:
        write("rows", rows)
        run(far_away, "-q", "--check", "rows", *options, *more, "--time-zero", "first")


check(lambda rng: law(rng) if rng.random() < 0.7 else from_first(rng), 25, least=1)
