"""The published test vectors against the running code of products: products.py VECTORS.

Runs a small program for each product that is installed, or unpacked below the folder TCB_PRODUCTS, such as

    apt-get download libwildmagic-dev libwildmagic5 && for p in *.deb; do dpkg -x $p "$TCB_PRODUCTS"; done

and prints, for each curve that the product can have, the largest difference of its positions from those of the
vectors. Exit 77: there is no product.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = os.environ.get("TCB_PRODUCTS", "")
INCLUDE, LIBRARY = ROOT + "/usr/include/", ROOT + "/usr/lib/x86_64-linux-gnu/"
GLIB = [INCLUDE + "synfig-1.0", INCLUDE + "ETL"] + [
    folder for name in ("glibmm-2.4", "giomm-2.4", "sigc++-2.0", "glib-2.0", "libxml++-2.6")
    for folder in (INCLUDE + name, LIBRARY + name + "/include")]
PRODUCTS = [  # name, Debian packages, folders of headers, libraries, vectors, tolerance
    ("wildmagic", "libwildmagic-dev libwildmagic5", [INCLUDE + "libwildmagic"], ["Wm5Mathematics", "Wm5Core"],
     ["presets/wildmagic"], 1e-14),
    ("vtk", "libvtk9-dev libvtk9.1", [INCLUDE + "vtk-9.1"],
     ["vtkCommonComputationalGeometry-9.1", "vtkCommonDataModel-9.1", "vtkCommonCore-9.1", "vtksys-9.1"],
     ["presets/vtk", "tangents/interval"], 1e-14),
    ("lib3ds1", "lib3ds-dev lib3ds-1-3", [], ["3ds"], ["presets/lib3ds1"], 1e-6),
    ("lib3ds2", "libopenscenegraph161 libopenthreads21", [], ["dl"], ["presets/lib3ds2"], 1e-6),
    ("synfig", "libsynfig-dev libsynfig0a and what they depend on", GLIB, ["synfig", "glibmm-2.4", "sigc-2.0", "glib-2.0"],
     ["presets/synfig"], 1e-14),
    ("threejs", "nodejs libjs-three", [], [], ["presets/threejs"], 1e-14),
    ("godot", "", [], [], ["presets/godot"], 1e-14),
]
vectors = Path(sys.argv[1])


def command_of(name, headers, libraries, target):
    """The command that runs a program, or None where it cannot be run."""
    source = Path(__file__).with_name(name + ".cpp")
    if not source.exists():
        return ["node", source.with_suffix(".mjs")] if shutil.which("node") else None
    compiled = subprocess.run(
        ["c++", "-std=c++17", "-w", source, "-o", target, f'-DLIBRARY="{LIBRARY}"', "-I" + INCLUDE,
         *("-I" + folder for folder in headers), "-L" + LIBRARY, *("-l" + library for library in libraries),
         "-Wl,--allow-shlib-undefined", "-Wl,--disable-new-dtags,-rpath," + LIBRARY], capture_output=True)
    return [target] if compiled.returncode == 0 else None


def differences(command, curve):
    """Of one curve's positions, channel by channel; none where the product has no such curve."""
    rows = curve["position"]
    for c in range(len(curve["keys"][0]["position"])):
        words = [len(curve["keys"]), len(rows), int(curve["closed"])]
        for key in curve["keys"]:
            words += [key["time"], key["position"][c], *key["tcb"]]
        text = " ".join(map(repr, words + [row["at"] for row in rows]))
        done = subprocess.run(command, input=text, text=True, capture_output=True)
        if done.returncode:
            return
        for row, printed in zip(rows, done.stdout.split(), strict=True):
            yield abs(float(printed) - row["value"][c])


compared = failed = 0
with tempfile.TemporaryDirectory() as scratch:
    for name, packages, headers, libraries, files, tolerance in PRODUCTS:
        command = command_of(name, headers, libraries, Path(scratch) / name)
        found = {}
        for file in files if command else ():
            for curve in json.loads((vectors / (file + ".json")).read_text())["curves"]:
                found[curve["id"]] = list(differences(command, curve))
        found = {curve: values for curve, values in found.items() if values}
        compared += sum(map(len, found.values()))
        failed += sum(max(values) > tolerance for values in found.values())
        print(f"{name}:", ", ".join(f"{curve} {max(values):.1g}" for curve, values in found.items())
              or f"skipped: needs {packages}")
print(f"{compared} positions compared, {failed} curves differ")
sys.exit(1 if failed else 0 if compared else 77)
