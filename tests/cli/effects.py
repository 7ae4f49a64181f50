"""No option is without effect in silence: effects.py PROGRAM.

Each option is given beside each product, way of sampling and format, on keys of many kinds. For some of these keys it is
refused, or changes a byte. What only the keys decide is no fault, as --no-ease beside keys without ease. Exit 1: an option
changes no byte of a product, whatever the keys are, and is not refused.
"""
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext
from functools import cache
from itertools import product as product_of

program = os.path.abspath(sys.argv[1])
scene = open(os.path.dirname(__file__) + "/../../samples/formats/scene.lws").read()
folder = tempfile.TemporaryDirectory()
os.chdir(folder.name)


def output(*words):
    return subprocess.run([program, *words], capture_output=True, stdin=subprocess.DEVNULL, timeout=300).stdout.decode()


@cache
def run(*words):
    """The exit code, whether rows were printed without an error, a hash of what was printed and written, and whether the
    command was refused before its keys were read."""
    with tempfile.TemporaryDirectory(dir=".") if any("MADE" in word for word in words) else nullcontext() as made:
        words = [word.replace("MADE", made or "") for word in words]
        done = subprocess.run([program, *words], capture_output=True, stdin=subprocess.DEVNULL, timeout=300, close_fds=False)
        written = [(name, open(f"{made}/{name}", "rb").read()) for name in sorted(os.listdir(made))] if made else []
    is_done = bool(done.stdout) and b": error: " not in done.stderr
    is_refused = done.returncode == 2 and done.stderr.startswith(b"tcbsample: error: ")
    return done.returncode, is_done, hash((done.stdout, done.stderr, tuple(written))), is_refused


def write(name, *lines):
    with open(name, "w") as file:
        file.write("\n".join(lines) + "\n")


# Keys, whose times are unequal: with everything that shapes a curve, in groups, with rotations, and odd texts.
times = [0, 1, 1.5, 3, 3.25, 5, 6, 6.5, 8]
xyz = [f"{t},{i * i * 7 % 11 / 10},{i * 5 % 7},{i * 3 % 5}" for i, t in enumerate(times)]
xy = [row.split(",", 1)[1] for row in xyz]
write("keys.csv", "t,x,y,z,a", *(f"{row},{i * 150 % 360}" for i, row in enumerate(xyz)))
write("tcb.csv", "t,x,y,z,tension,continuity,bias", *(f"{row},0.{i},0.{i},0.{8 - i}" for i, row in enumerate(xyz)))
write("eased.csv", "t,x,y,z,ease_in,ease_out", *(f"{row},0.2,0.{i % 5}" for i, row in enumerate(xyz)))
write("groups.csv", "id,t,x,y,z", *(f"{name},{row}" for name in "ab" for row in xyz))
write("poses.csv", "t,x,y,z,qx,qy,qz,qw,tension,continuity,bias,ease_in,ease_out",
      *(f"{row},{'0,0,0,1' if i % 2 else '0,0.6,0,0.8'},0.5,0.2,-0.{i},0.3,0.2" for i, row in enumerate(xyz[:5])))
write("turns.csv", "t,x,y,z,qx,qy,qz,qw", *(f"{row},{i % 3},{i % 2},1,{1 + i % 4}" for i, row in enumerate(xyz)))
write("euler.csv", "t,x,y,z,ex,ey,ez", *(f"{row},{i * 0.2},0.{i},1" for i, row in enumerate(xyz)))
write("beyond.csv", "t,x,y,z", *xyz[:5])
write("dates.csv", "date,x,y,z", *(f"05.02.2024 00:00:0{i},{row}" for i, row in enumerate(xy)))
write("minutes.csv", "t,x,y,z", *(f"00:0{i},{row}" for i, row in enumerate(xy)))
write("marks.csv", "t;x;y", *(f"{i},5;{i * i * 7 % 11}'000;{i * 5 % 7}" for i in range(9)))
write("missing.csv", "t,x,y,z", *(f"{i},{'gone,1,1' if i == 4 else row}" for i, row in enumerate(xy)))
write("twice.csv", "t,x,y,z", *xyz[:4], *xyz[3:])
write("unsorted.csv", "t,x,y,z", *xyz[::-1])
write("numbers.csv", *(row.replace(".", "") for row in xyz))
write("named.csv", "x,y,z", *xy)
write("above.csv", "% text", "t,x,y,z", *xyz)
with open("lists.json", "w") as file:
    lists = [[dict(t=t, x=t * t % 7, y=1) for t in times[:n]] for n in (9, 5)]
    json.dump({"a": {"b": lists[0]}, "c": {"d": lists[1]}}, file)
usual = ["keys.csv", "poses.csv", "tcb.csv", "eased.csv", "groups.csv"]

# Options with a value, after a + what they need besides; and the keys for options of which the usual ones show nothing.
texts = """--step 0.3; --rate 3; --fps 3; --count 7; --per-segment 2; --at 1; --arc-step 0.7; --arc-count 5; --arc-at 1;
--tolerance 0.3; --emit poly; --fit 0.5; --abs 1e-3; --rel 1e-3; --ulp 1e12; --map x=q; --columns position=x:y;
--tcb 0.5,0.2,0.1; --tcb-scale 3dsmax; --scale x=2; --scale y=2; --scale z=2; --angle a=degrees; --preset kb1984;
--tangents uniform; --ends natural; --period 20; --metric y,z; --rotation-curve slerp; --parameter chordal;
--extrapolate hold; --extrapolate hold + --to 99; --fit-keys hermite; --keep-times 1.5; --corner 20; --from 6.2;
--to 2; --end keep; --max-rows 1; --pace constant; --side left; --side left + --fields time,velocity;
--fields time,position,speed; --fields s,length; --digits 3; --fixed 1; --output-delimiter tab; --output-decimal ,;
--output-decimal , + --output-delimiter pipe; --time-format clock; --time-zero 0.5; --rename x=px; --axes y:z;
--title T; --size 900x700; --rotation-output matrix; --exact-input + --golden; --input-format tsv; --delimiter ,;
--comment %; --skip-lines 1; --decimal ,; --thousands apostrophe; --group id; --only Ship/position; --records a.b;
--missing skip-row + --na gone; --na gone + --missing skip-row; --time-unit min; --input-fps 24;
--time-start 2 + --input-fps 24; --date-order dmy; --rotation euler=ex:ey:ez,order=XYZ;
--angles degrees + --rotation euler=ex:ey:ez,order=XYZ; --duplicates last; --max-gap 1.2; --null + --files nul;
--suffix=-a + --output-dir MADE; --recursive + --output-dir MADE tree; --recursive + tree; --output-dir MADE;
--files list; --output MADE/a.json; --output-format json; --output-format svg; --check rows;
--identify rows; --limits; --retime + --limits=speed=1"""
special_keys = {
    "--extrapolate": ["beyond.csv", "keys.csv"], "--comment": ["above.csv"], "--skip-lines": ["above.csv"],
    "--header": ["numbers.csv"], "--no-header": ["numbers.csv", "keys.csv"], "--delimiter": ["marks.csv", "keys.csv"],
    "--decimal": ["marks.csv"], "--thousands": ["marks.csv"], "--group": ["groups.csv"], "--records": ["lists.json"],
    "--missing": ["missing.csv"], "--na": ["missing.csv"], "--time-unit": ["minutes.csv"], "--input-fps": ["named.csv"],
    "--time-start": ["named.csv"], "--date-order": ["dates.csv"], "--rotation": ["euler.csv"],
    "--angles": ["euler.csv"],
    "--only": ["scene.lws"], "--duplicates": ["twice.csv"], "--sort": ["unsorted.csv"], "--normalize": ["turns.csv"]}
# They change no byte of an output.
of_the_run = "--update --jobs --max-memory --quiet --color --generate --list-presets --version --help".split()

samplers = ["--step 0.3", "--count 7", "--per-segment 2", "--at 1,2.2", "--arc-step 0.7", "--arc-count 5",
            "--arc-at 1,2", "--tolerance 9", "--count 5 --pace ease"]
products = ["", *samplers, "--emit poly", "--fit 0.5", "--check ROWS", "--check ROWS --step 0.3", "--identify ROWS",
            "--limits", "--plot", "--plot --step 0.3", "--explain", "--explain --step 0.3", "--explain --arc-step 0.7",
            "--explain --emit poly", "--explain --plot", "--limits=speed=3 --retime --per-segment 2",
            "--limits=speed=3 --retime --plot", "--step 0.3 --golden", "--limits -f svg", "--limits -f json",
            "--check ROWS -f svg", "--check ROWS -f json", "--identify ROWS -f svg", "--fit 0.5 -f svg",
            "--emit poly -f json", "--emit hermite -f gltf", "--fit 0.5 -f jsonl", "--explain --step 0.3 -f npy",
            *(f"--step 0.3 -f {form}" for form in "tsv ssv json jsonl tum euroc kitti nerfstudio gltf npy".split())]
# What is decided by the file with rows, which may have a speed, by numbers, of which an animation holds floats, by the
# way of sampling, as an explanation tells lengths, and by the tolerance, which may be one of rotations.
explained = [product for product in products if "--explain" in product]
fitted = [product for product in products if "--fit" in product]
by_case = {"--metric": ["--check ROWS -f svg"], "--golden": ["--emit hermite -f gltf"],
           "--exact-input": ["--emit hermite -f gltf"], "--scale": explained, "--tcb-scale": explained,
           "--normalize": fitted, "--angles": fitted}


def effects(given, besides, product):
    """What the option does to the product: what is found for each of its keys, until there is an effect."""
    found = set()
    for keys, rows in product_of(special_keys.get(given[0], usual), ["rows", "same"] if "ROWS" in product else [""]):
        rows = f"{keys}.{rows}" if os.path.exists(f"{keys}.{rows}") else rows
        words = product.replace("ROWS", rows).split() + besides
        before, after = run(*words, keys), run(*given, *words, keys)
        if after[3]:
            return found | {"refused"}
        if after[0] == 2:
            found.add("refused")
        elif after != before:
            return {"effect"}
        elif after[1]:
            found.add("none")
    return found


write("scene.lws", scene)
write("other.csv", "t,x,y,z", *xyz)
write("list", "other.csv")
os.mkdir("tree")
write("tree/k.csv", "t,x,y,z", *xyz)
with open("nul", "w") as file:
    file.write("keys.csv\0")
# The rows that are compared differ a little from those of the curves, or are theirs.
write("same", output("--step", "0.25", "keys.csv"))
write("rows", output(*"--step 0.3 --fields time,position,velocity,speed,s --scale x=1.00001 keys.csv".split()))
for given in ("poses.csv", "scene.lws", "euler.csv --rotation euler=ex:ey:ez,order=XYZ"):
    write(given.split()[0] + ".rows", output("--step", "0.3", "--scale", "x=1.00001", *given.split()))
cases = {}
for option in json.loads(output("--generate", "tables"))["options"]:
    name = option["name"]
    if name in of_the_run:
        continue
    given = [line.split() for line in texts.replace("\n", " ").split("; ") if line.split()[0].split("=")[0] == name]
    for product in products:
        is_elsewhere = product in samplers[1:] and option["group"] != "Sampling"  # as with --step
        if not is_elsewhere and name not in product and not (name == "--plot" and "-f" in product):
            cases[name, product] = [(words, product) for words in given or [[name]]]


def is_refused(product):
    """Whether a product is refused for all keys, so that nothing is found about it."""
    return all(run(*product.replace("ROWS", "rows").split(), keys)[0] == 2 for keys in usual)


def result(case):
    found = set()
    for words, product in case:
        mark = words.index("+") if "+" in words else len(words)
        found |= effects(words[:mark], words[mark + 1:], product)
    return found


with ThreadPoolExecutor(2) as pool:
    results = dict(zip(cases, pool.map(result, cases.values())))
silent = [case for case, found in results.items() if "none" in found and "effect" not in found
         and case[1] not in by_case.get(case[0], [])]
assert not any(map(is_refused, products[1:])), list(filter(is_refused, products[1:]))
for name, product in silent:
    print(f"{name} changes no byte with {product}")
useless = {name for name, _ in results} - {name for (name, _), found in results.items() if "effect" in found}
print(f"{len(results)} pairs, {len(silent)} without effect; no effect at all: {' '.join(sorted(useless)) or 'none'}")
sys.exit(bool(silent or useless))
