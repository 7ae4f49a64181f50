"""Pictures of the samples in headless Chromium: browser.py PROGRAM SAMPLES.

Measures in the page that no text overlaps another or leaves the picture, that each key's dot is where the key is
according to the numbers on the axes, and the contrast in light and dark. A real parser reads the XML before. Exits with
77 where there is no Chromium.
"""
import csv
import fractions
import html
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

MEASURE = """
const all = [...document.querySelectorAll('svg')].map(svg => {
  const zero = svg.getBoundingClientRect();
  const colour = (element, property) => getComputedStyle(element)[property];
  const number = (element, name) => parseFloat(element.getAttribute(name));
  return {
    width: zero.width, height: zero.height, background: colour(svg.querySelector('.b'), 'fill'),
    texts: [...svg.querySelectorAll('text')].map(t => {
      const box = t.getBoundingClientRect();
      return {left: box.left - zero.left, right: box.right - zero.left, top: box.top - zero.top,
              bottom: box.bottom - zero.top, x: number(t, 'x'), y: number(t, 'y'), text: t.textContent,
              css: t.getAttribute('class'), anchor: t.getAttribute('text-anchor'), colour: colour(t, 'fill')};
    }),
    views: [...svg.querySelectorAll('rect.f')].map(r => [number(r, 'x'), number(r, 'y'), number(r, 'width'),
                                                         number(r, 'height')]),
    dots: [...svg.querySelectorAll('circle')].map(c => [number(c, 'cx'), number(c, 'cy')]),
    colours: [...svg.querySelectorAll('.l,.k,.q,.s,.h,.f')].map(e =>
      e.matches('.k') ? colour(e, 'fill') : colour(e, 'stroke')),
  };
});
const out = document.createElement('pre');
out.id = 'measured';
out.textContent = JSON.stringify(all);
document.body.replaceChildren(out);
"""

failures = []


def expect(holds, message):
    if not holds:
        failures.append(message)


def measured(chromium, pictures, dark):
    """What the page measures of each picture."""
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.html"
        body = "\n".join(pictures)
        page.write_text(f"<!doctype html><meta charset=utf-8><body>{body}<script>{MEASURE}</script>", encoding="utf-8")
        command = [chromium, "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
                   f"--blink-settings=preferredColorScheme={0 if dark else 1}", "--dump-dom", page.as_uri()]
        dom = subprocess.run(command, capture_output=True, text=True, timeout=120).stdout
    return json.loads(html.unescape(re.search(r'<pre id="measured">(.*?)</pre>', dom, re.S)[1]))


def luminance(colour):
    """Source: Web Content Accessibility Guidelines 2.1, relative luminance."""
    parts = [int(part) / 255 for part in re.findall(r"\d+", colour)[:3]]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    high, low = sorted((luminance(a), luminance(b)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def check_contrast(name, picture):
    background = picture["background"]
    for text in picture["texts"]:
        expect(contrast(text["colour"], background) >= 4.5, f"{name}: contrast of {text['text']!r}")
    for colour in set(picture["colours"]):
        expect(contrast(colour, background) >= 3, f"{name}: contrast of {colour} on {background}")


def check_texts(name, picture):
    texts = picture["texts"]
    for i, a in enumerate(texts):
        inside = a["left"] >= 0 and a["top"] >= 0 and a["right"] <= picture["width"] and a["bottom"] <= picture["height"]
        expect(inside, f"{name}: {a['text']!r} leaves the picture")
        for b in texts[:i]:
            apart = (a["right"] <= b["left"] or b["right"] <= a["left"] or a["bottom"] <= b["top"]
                     or b["bottom"] <= a["top"])
            expect(apart, f"{name}: {a['text']!r} overlaps {b['text']!r}")


def base_of(title):
    """What the title of an axis adds to its numbers."""
    after = re.search(r" seconds after (\d+)$", title)
    if after:
        return int(after[1])
    found = re.search(r" ([−+]) ([\d.]+)$", title)
    return 0 if not found else int(found[2]) if found[1] == "−" else -float(found[2])


def line_through(ticks):
    """From places in pixels to numbers, by the first and the last tick."""
    (a, x), (b, y) = ticks[0], ticks[-1]
    return lambda place: x + (place - a) * (y - x) / (b - a)


def axes(picture, view):
    left, top, width, height = view
    numbers = [text for text in picture["texts"] if text["css"] == "v"]
    up = [(t["y"] - 4, float(t["text"])) for t in numbers if t["anchor"] == "end" and abs(t["x"] - left + 5) < 0.02
          and top - 1 <= t["y"] - 4 <= top + height + 1]
    below = [t for t in numbers if t["anchor"] == "middle" and left - 1 <= t["x"] <= left + width + 1
             and t["y"] > top + height]
    lowest = min(t["y"] for t in below)
    right = [(t["x"], float(t["text"])) for t in below if t["y"] == lowest]
    heading = next(t["text"] for t in picture["texts"] if t["css"] == "n" and abs(t["x"] - left) < 0.02
                   and abs(t["y"] - top + 6) < 0.02)
    return line_through(right), line_through(up), heading


def check_dots(name, picture, times, channels, path):
    titles = [t["text"] for t in picture["texts"] if t["css"] == "n" and t["anchor"] == "middle"]
    for number, view in enumerate(picture["views"]):
        left, top, width, height = view
        at_x, at_y, heading = axes(picture, view)
        dots = [dot for dot in picture["dots"] if left - 0.1 <= dot[0] <= left + width + 0.1
                and top - 0.1 <= dot[1] <= top + height + 0.1]
        is_path = path and number == 0
        up = list(channels)[1 if is_path else number - (1 if path else 0)]
        expect(heading.startswith(up), f"{name}: heading {heading!r} for {up!r}")
        across = list(channels.values())[0] if is_path else times
        title = titles[0] if is_path else titles[-1]
        expect(len(dots) == len(times), f"{name}, {heading}: {len(dots)} dots of {len(times)} keys")
        for (x, y), right, value in zip(dots, across, channels[up]):
            pixel_x, pixel_y = abs(at_x(1) - at_x(0)), abs(at_y(1) - at_y(0))
            expect(abs(at_x(x) - (right - base_of(title))) <= 0.05 * pixel_x, f"{name}, {heading}: dot at x {x}")
            expect(abs(at_y(y) - (value - base_of(heading))) <= 0.05 * pixel_y, f"{name}, {heading}: dot at y {y}")


def keys_of(path):
    """Times and channels of a sample, read without the program."""
    text = path.read_text()
    if path.suffix == ".json":
        data = json.loads(text)
        channels = {name: [key["position"][i] for key in data["keys"]] for i, name in enumerate(data["channels"])}
        return [key["time"] for key in data["keys"]], channels
    if path.suffix == ".jsonl":
        rows = [json.loads(line) for line in text.splitlines()]
        seconds = [fractions.Fraction(row["timestamp"], 10**9) for row in rows]
        return seconds, {name: [row[name] for row in rows] for name in ("pan", "tilt", "zoom")}
    if path.suffix == ".txt":
        rows = [line.lstrip("# ").split() for line in text.splitlines()]
    else:
        rows = list(csv.reader(text.splitlines(), delimiter="\t" if path.suffix == ".tsv" else ","))
    names = [name for name in rows[0] if name not in ("tension", "continuity", "bias")]
    columns = {name: [float(row[rows[0].index(name)]) for row in rows[1:]] for name in names}
    times = columns.pop(names[0])
    use_angles(columns)
    return times, columns


def use_angles(columns):
    """A quaternion as its angle in degrees from the first key, with signs that do not jump."""
    numbers = [columns.pop(name) for name in ("qx", "qy", "qz", "qw") if name in columns]
    keys = list(zip(*numbers))
    angles, before = [], keys[0] if keys else None
    for key in keys:
        before = key if dot(before, key) >= 0 else [-x for x in key]
        angles.append(math.degrees(2 * math.acos(max(-1, min(1, dot(keys[0], before))))))
    if keys:
        columns["angle from the first key"] = angles


def dot(p, q):
    return sum(x * y for x, y in zip(p, q)) / math.hypot(*p) / math.hypot(*q)


def main():
    program, samples = sys.argv[1], pathlib.Path(sys.argv[2])
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if chromium is None:
        print("skipped: no Chromium; install the package chromium")
        return 77
    without_names = ("kitti.txt", "tum.txt")
    files = sorted(path for path in samples.iterdir() if path.suffix in (".csv", ".tsv", ".txt", ".json", ".jsonl")
                   and path.name not in without_names)
    shapes = [[], ["--step", "1", "--size", "640x420"], ["--closed"]]
    cases = [(file, shape) for file in files for shape in shapes
             if "--closed" not in shape or file.suffix == ".txt"]
    pictures = []
    for file, shape in cases:
        sampling = ["-f", "svg"] if "--step" in shape else ["--plot"]
        if file.suffix == ".jsonl" and "--step" in shape:
            shape = ["--step", "1e9", "--size", "640x420"]
        command = [program, *sampling, *shape, file]
        svg = subprocess.run(command, capture_output=True, check=True).stdout
        ElementTree.fromstring(svg)  # well-formed
        pictures.append(svg.decode())
    for dark in (False, True):
        for (file, shape), picture in zip(cases, measured(chromium, pictures, dark), strict=True):
            name = f"{file.name} {' '.join(shape)} {'dark' if dark else 'light'}"
            dark_background = luminance(picture["background"]) < 0.2
            expect(dark_background == dark, f"{name}: background {picture['background']}")
            check_contrast(name, picture)
            check_texts(name, picture)
            times, channels = keys_of(file)
            if "--closed" not in shape and len(times) < 100:  # of more keys there are no dots
                check_dots(name, picture, times, channels, path={"x", "y"} <= set(channels))
    print(f"{len(cases)} pictures in light and dark, {len(failures)} failures")
    for failure in failures[:40]:
        print(failure)
    return 1 if failures else 0


sys.exit(main())
