// The nodes of a glTF animation by three.js: evaluate.mjs FILE TIME...
//
// Prints a JSON object for each time, with the position, quaternion and scale of each node by its name. three.js is
// that of npm, in a folder node_modules around the current one, or Debian's libjs-three. Exit 77: there is none.
import fs from 'node:fs';
import path from 'node:path';
import vm from 'node:vm';
import {createRequire} from 'node:module';
import {pathToFileURL} from 'node:url';

const debian = '/usr/share/javascript/three';

async function fromNpm() {
  const require = createRequire(path.join(process.cwd(), 'any.js'));
  const folder = path.dirname(path.dirname(require.resolve('three')));
  const three = await import(pathToFileURL(path.join(folder, 'build/three.module.js')));
  const {GLTFLoader} = await import(pathToFileURL(path.join(folder, 'examples/jsm/loaders/GLTFLoader.js')));
  return {three, GLTFLoader};
}

function fromDebian() {
  const read = (name) => fs.readFileSync(path.join(debian, name), 'utf8');
  globalThis.self = globalThis.window = globalThis;
  const sandbox = {exports: {}, module: {exports: {}}};
  vm.runInThisContext(`(function (exports, module) {${read('three.js')}})`)(sandbox.module.exports, sandbox.module);
  globalThis.THREE = sandbox.module.exports;
  vm.runInThisContext(read('examples/js/loaders/GLTFLoader.js'));
  return {three: globalThis.THREE, GLTFLoader: globalThis.THREE.GLTFLoader};
}

async function load() {
  globalThis.self ??= globalThis;
  globalThis.ProgressEvent ??= class extends Event {};  // of browsers
  try {
    return await fromNpm();
  } catch {
    if (!fs.existsSync(path.join(debian, 'three.js'))) {
      console.log('skipped: there is neither the package three of npm nor libjs-three');
      process.exit(77);
    }
    return fromDebian();
  }
}

const {three, GLTFLoader} = await load();
const [file, ...times] = process.argv.slice(2);
const gltf = await new Promise((done, fail) => new GLTFLoader().parse(fs.readFileSync(file, 'utf8'), '', done, fail));
const mixer = new three.AnimationMixer(gltf.scene);
const action = mixer.clipAction(gltf.animations[0]);
action.setLoop(three.LoopOnce);
action.clampWhenFinished = true;
action.play();
for (const time of times) {
  action.reset();
  action.play();
  mixer.setTime ? mixer.setTime(Number(time)) : mixer.update(Number(time) - mixer.time);
  const nodes = {};
  gltf.scene.traverse((node) => {
    if (node !== gltf.scene) {
      nodes[node.userData.name ?? node.name] = {position: node.position.toArray(), quaternion: node.quaternion.toArray(),
                                               scale: node.scale.toArray()};
    }
  });
  console.log(JSON.stringify(nodes));
}
