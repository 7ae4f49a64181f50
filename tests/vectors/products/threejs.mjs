// Positions of smooth keyframe tracks of three.js, which are read as curve.hpp has them.
//
// three.js is that of npm, in a folder node_modules around the current one, or Debian's libjs-three. Exit 4: there is none.
import fs from 'node:fs';
import path from 'node:path';
import {createRequire} from 'node:module';
import {pathToFileURL} from 'node:url';

async function load() {
  globalThis.self ??= globalThis;
  const debian = '/usr/share/javascript/three/three.js';
  try {
    const found = createRequire(path.join(process.cwd(), 'any.js')).resolve('three');
    return await import(pathToFileURL(path.join(path.dirname(path.dirname(found)), 'build/three.module.js')));
  } catch {
    if (!fs.existsSync(debian)) process.exit(4);
    return createRequire(import.meta.url)(debian);
  }
}

const three = await load();
const words = fs.readFileSync(0, 'utf8').split(/\s+/).map(Number);
const [count, places, closed] = words;
const keys = Array.from({length: count}, (_, i) => words.slice(3 + 5 * i, 8 + 5 * i));
if (closed || keys.some(([, , ...tcb]) => tcb.some((x) => x !== 0))) process.exit(3);  // it has no such curves
const track = new three.NumberKeyframeTrack('.x', keys.map((k) => k[0]), keys.map((k) => k[1]), three.InterpolateSmooth);
const curve = track.createInterpolant(new Float64Array(1));
for (let i = 0; i < places; ++i) console.log(curve.evaluate(words[3 + 5 * count + i])[0]);
