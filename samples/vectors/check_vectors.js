// Tests the spline in tangent() and value() with presets/vtk.json; put yours in their place. Exit 1: an error is too
// large.
"use strict";
const fs = require("fs");

// The derivative at the start (side 1) or the end (side -1) of a segment, per its whole duration.
function tangent(keys, closed, segment, side, c) {
  const last = keys.length - 1, i = side > 0 ? segment : segment + 1;
  if (!closed && (i === 0 || i === last)) return 0;
  const k = ((i - 1 + last) % last), n = i % last;
  const [tension, continuity, bias] = keys[i].tcb;
  const before = keys[k + 1].position[c] - keys[k].position[c], after = keys[n + 1].position[c] - keys[n].position[c];
  const h0 = keys[k + 1].time - keys[k].time, h1 = keys[n + 1].time - keys[n].time;
  return (1 - tension) * ((1 + side * continuity) * (1 + bias) * before + (1 - side * continuity) * (1 - bias) * after)
    * (side > 0 ? h1 : h0) / (h0 + h1);
}

// The position at t, or the velocity into or out of the key at t.
function value(keys, closed, quantity, t, c) {
  let k = 0;
  while (k + 2 < keys.length && (quantity === "incoming" ? keys[k + 1].time < t : keys[k + 1].time <= t)) ++k;
  const h = keys[k + 1].time - keys[k].time, p = keys[k].position[c], step = keys[k + 1].position[c] - p;
  const u = (t - keys[k].time) / h, m = tangent(keys, closed, k, 1, c), n = tangent(keys, closed, k, -1, c);
  if (quantity !== "position") return (quantity === "incoming" ? n : m) / h;
  return p + u * (m + u * (3 * step - 2 * m - n + u * (m + n - 2 * step)));
}

let numbers = 0, largest = 0;
for (const curve of JSON.parse(fs.readFileSync("presets/vtk.json", "utf8")).curves)
  for (const quantity of ["position", "incoming", "outgoing"])
    for (const row of curve[quantity])
      row.value.forEach((expected, c) => {
        largest = Math.max(largest, Math.abs(value(curve.keys, curve.closed, quantity, row.at, c) - expected));
        ++numbers;
      });
console.log(`${numbers} numbers, largest error ${largest.toPrecision(1)}`);
process.exit(numbers && largest < 1e-13 ? 0 : 1);
