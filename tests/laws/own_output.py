"""The output of every mode, with any options, checks as equal to its keys.

Commands that the program refuses are counted, not compared; most must be accepted. Rows placed by length are compared at
their lengths, because their times are rounded."""
from fractions import Fraction

from keys import FINE_TIMES, TIMES, Keys, is_exact
from law import check, require, run, write

PRESETS = ["tcb", "gte", "fbx", "gte2021", "wildmagic", "lightwave", "vtk", "gamebryo", "idtech4", "lib3ds1", "lib3ds2",
           "splines", "synfig", "kb1984", "wikipedia", "ogre", "3dsmax", "nel", "cryengine"]
LOCAL = ["velocity", "acceleration", "jerk", "speed", "tangent", "curvature", "torsion", "segment", "u", "key"]


def have_few_digits(times):
    """Whether doubles hold the times: those of more digits are rounded by --digits."""
    return all(not is_exact(t) or abs(Fraction(t)) < 2 ** 53 and "." not in t for t in times)


def law(rng):
    chance = lambda p: rng.random() < p
    keys = Keys(rng, "", TIMES + FINE_TIMES, shortest=rng.choice([1, 2]))
    options = keys.options()
    if chance(0.4):
        options = ["--preset", rng.choice(PRESETS), *options[4 if "--ends" in options else 2:]]
    if not keys.tcb and chance(0.2):
        options += ["--tcb", ",".join(str(rng.randint(-10, 10) / 10) for _ in range(3))]
    times, place = list(map(Fraction, keys.times)), lambda: rng.choice(keys.places(rng, 3, True))
    span = times[-1] - times[0]
    mode = rng.choice(["step", "count", "per-segment", "at", "arc-step", "arc-count", "arc-at", "tolerance"])
    if mode == "tolerance" and len(keys.channels) == 1 and keys.ease:  # the bound tightens slowly: seconds
        mode = "count"
    length = repr(rng.choice([0.5, 1, 100, 1e-3]) * keys.size)
    value = {"step": str(span / rng.randint(1, 40) * rng.choice([1, Fraction(rng.randint(10, 99), 50)])),
             "at": ",".join(place() for _ in range(rng.randint(1, 9))), "arc-step": length,
             "arc-at": ",".join(["0", length, "0.1"][:rng.randint(1, 3)]),
             "tolerance": repr(rng.choice([0.1, 0.01, 1]) * keys.size)}.get(mode, str(rng.randint(1, 30)))
    if mode == "at" and chance(0.4) and not keys.gap:
        options += ["--extrapolate", ",".join(rng.choices(["hold", "linear", "repeat", "offset", "oscillate"], k=rng.randint(1, 2)))]
        value = ",".join(str(times[0] + span * Fraction(rng.randint(-2000, 3000), 1000)) for _ in range(5))
    by_length, samples, fields = mode.startswith("arc"), [f"--{mode}={value}", "--max-rows", "400"], []
    if mode in ("step", "arc-step") and chance(0.6):
        samples += ["--end", rng.choice(["drop", "keep", "fit", "fit-down", "fit-up"])]
    if mode in ("step", "count", *["arc-step", "arc-count"] * (not keys.rotations)) and chance(0.2):
        samples += ["--keys"]
    if mode in ("step", "count") and chance(0.2):
        low, high = sorted([place(), place()], key=Fraction)
        samples += [f"--from={low}", f"--to={high}"]
    form = rng.choice(["csv", "csv", "tsv", "ssv", "json", "jsonl"])
    is_table = form in ("csv", "tsv", "ssv")
    samples += rng.choice([[], [], ["--hex"] * is_table, ["--digits", "17"] * (have_few_digits(keys.times) and not keys.gap)]) + ["--meta"] * chance(0.1)
    headless = is_table and chance(0.15) and len(keys.labels) == 1
    samples += ["--no-output-header"] * headless
    if by_length or chance(0.5):
        places = ["s", *["time"] * (not headless and chance(0.4))] if by_length else ["time"]
        fields = places + ["position", *rng.sample(LOCAL, rng.randint(0, 4)), *["s"] * (not by_length and chance(0.2))]
        if by_length and "--keys" in samples:  # the keys of a hold have one length
            fields = ["s", "position"]
        rng.shuffle(fields)
    if set(fields) & set(LOCAL) and chance(0.2):
        options += ["--side", "left"]
    text = keys.text(rng.choice(["csv", "semicolons", "tsv", "json"]))
    of_fields = lambda fields: ["--fields", ",".join(fields)] if fields else []
    rows = run(text, *options, *samples, "-f", form, *of_fields(fields), codes=(0, 1, 2))
    if rows.returncode == 0:
        write(f"rows.{form}", rows.stdout)
        done = run(text, "--check", f"rows.{form}", *options, *of_fields([field for field in fields if not by_length or field != "time"]),
                   codes=(0, 1, 2))
        require(done.returncode == 0, f"a check of {samples} -f {form} {fields}: {(done.stdout + done.stderr)[:900]}\n{rows.stdout[:500]}")


check(law, 60, least=0.5)
