// Models of the tests: ordered GLB files that `striata build` makes of assets, generated OBJ files, and broken variants.
//
// The command is $STRIATA, or `striata` on the path. If $MESHES is set, the folder with the meshes of the results, more models
// are made of it.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
export const MESHES = process.env.MESHES;
const STRIATA = process.env.STRIATA ?? 'striata';

/** Runs a function with an empty folder, which is removed afterwards. */
export async function inFolder(work) {
  const folder = mkdtempSync(join(tmpdir(), 'striata-godot-'));
  try {
    return await work(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Returns what `striata build` makes of a file. */
export function build(folder, input, output, ...options) {
  const path = join(folder, output);
  execFileSync(STRIATA, ['build', input, '-o', path, '--quiet', '--force', ...options], { stdio: ['ignore', 'ignore', 'pipe'] });
  return readFileSync(path);
}

/** Returns why models cannot be built, or undefined. */
export function cannotBuild() {
  try {
    execFileSync(STRIATA, ['--version'], { stdio: 'ignore' });
  } catch {
    return `${STRIATA} does not run; build the command and set STRIATA`;
  }
  if (MESHES && !existsSync(MESHES)) return `MESHES is ${MESHES}, which does not exist`;
  return undefined;
}

/**
 * A grid with hills in two materials. The border has corners: levels collapse vertices of one material to those of the other.
 * If the second material has a single triangle, levels move its vertices long before it vanishes.
 */
function twoMaterials(isBlue, library) {
  const n = 40;
  const lines = [`mtllib ${library}`];
  for (let y = 0; y <= n; y++) for (let x = 0; x <= n; x++) lines.push(`v ${x / n} ${0.1 * Math.sin((9 * x) / n) * Math.cos((7 * y) / n)} ${y / n}`);
  const rows = { red: [], blue: [] };
  for (let y = 0; y < n; y++) {
    for (let x = 0; x < n; x++) {
      const a = y * (n + 1) + x + 1;
      rows[isBlue(x, y) ? 'blue' : 'red'].push(`f ${a} ${a + n + 1} ${a + n + 2}`);
      rows[isBlue(x, y) && library === 'two.mtl' ? 'blue' : 'red'].push(`f ${a} ${a + n + 2} ${a + 1}`);
    }
  }
  return [...lines, 'usemtl red', ...rows.red, 'usemtl blue', ...rows.blue, ''].join('\n');
}

/** A crown of leaves, each a quad with texture coordinates. */
function leaves() {
  const lines = ['mtllib leaves.mtl', 'vt 0 0', 'vt 1 0', 'vt 1 1', 'vt 0 1', 'usemtl leaf'];
  for (let i = 0; i < 400; i++) {
    const height = 1 - (2 * (i + 0.5)) / 400;
    const turn = i * 2.399963;
    const radius = Math.sqrt(1 - height * height);
    const [x, y, z] = [radius * Math.cos(turn), height, radius * Math.sin(turn)];
    const [u, v] = [[-Math.sin(turn), 0, Math.cos(turn)], [-height * Math.cos(turn), radius, -height * Math.sin(turn)]];
    for (const [s, t] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
      lines.push(`v ${[x, y, z].map((at, axis) => (at + 0.06 * (s * u[axis] + t * v[axis])).toFixed(6)).join(' ')}`);
    }
    const a = 4 * i + 1;
    lines.push(`f ${a}/1 ${a + 1}/2 ${a + 2}/3 ${a + 3}/4`);
  }
  return [...lines, ''].join('\n');
}

/** Returns the models of the tests, a `Map` from names to bytes. */
export function testModels(folder) {
  const write = (name, text) => writeFileSync(join(folder, name), text);
  const colors = 'newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n';
  write('two.obj', twoMaterials((x, y) => (x + 2 * Math.round(2 * Math.sin(y / 3))) % 16 >= 8, 'two.mtl'));
  write('two.mtl', colors);
  write('speck.obj', twoMaterials((x, y) => x === 20 && y === 20, 'speck.mtl'));
  write('speck.mtl', colors);
  write('leaves.obj', leaves());
  write('leaves.mtl', 'newmtl leaf\nKd 0.2 0.6 0.1\nd 0.9\n');
  const sources = { arm: join(ROOT, 'assets/arm.glb'), spot: join(ROOT, 'assets/spot.obj.zst'), two: join(folder, 'two.obj'), speck: join(folder, 'speck.obj'), leaves: join(folder, 'leaves.obj') };
  if (MESHES) {
    sources.fox = join(MESHES, 'animated/Fox.glb');
    sources.morph = join(MESHES, 'animated/MorphStressTest.gltf');
    sources.helmet = join(MESHES, 'FlightHelmet/FlightHelmet.gltf');
    sources.brain = join(MESHES, 'assets/BrainStem.glb');
    sources.teapot = join(MESHES, 'teapot.obj');
  }
  const models = new Map();
  for (const [name, source] of Object.entries(sources)) {
    models.set(`${name}.glb`, build(folder, source, `${name}.glb`));
    models.set(`${name}-ranges.glb`, build(folder, source, `${name}-ranges.glb`, '--ranges', '6'));
  }
  return models;
}

/** Returns the JSON and the binary part of a GLB file. */
export function openGlb(bytes) {
  const length = bytes.readUInt32LE(12);
  return { json: JSON.parse(bytes.toString('utf8', 20, 20 + length)), binary: bytes.subarray(28 + length) };
}

function writeGlb({ json, binary }) {
  let text = Buffer.from(JSON.stringify(json));
  text = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const words = (...numbers) => Buffer.from(Uint32Array.from(numbers).buffer);
  const total = 12 + 8 + text.length + 8 + binary.length;
  return Buffer.concat([words(0x46546c67, 2, total), words(text.length, 0x4e4f534a), text, words(binary.length, 0x004e4942), binary]);
}

/** Returns a file whose second primitive lacks the extension. */
export function partial(bytes) {
  const glb = openGlb(bytes);
  delete glb.json.meshes[0].primitives[1].extensions;
  return writeGlb(glb);
}

/** Returns malformed variants of a file with ranges, a `Map` from names to `{ bytes, message }`: what the add-on must say. */
export function malformed(bytes) {
  const variants = {
    'no object': ['it has no targets', ({ primitive }) => (primitive.extensions.STRIATA_order = 7)],
    'no targets': ['it has no targets', ({ order }) => delete order.targets],
    'targets of no accessor': ['its targets are no unsigned', ({ order }) => (order.targets = 1000)],
    'targets of a wrong accessor': ['its targets are no unsigned', ({ order, primitive }) => (order.targets = primitive.attributes.POSITION)],
    'targets of 16 bits': ['its targets are no unsigned', ({ json, order }) => (json.accessors[order.targets].componentType = 5123)],
    'too few targets': ['targets for 32', ({ json, order }) => json.accessors[order.targets].count--],
    'targets outside of the file': ['does not fit into the file', ({ json, order }) => (json.accessors[order.targets].byteOffset = 1e9)],
    'a target above its vertex': ['the target of vertex 400 is 500', ({ view, order }) => view(order.targets).writeUInt32LE(500, 4 * 400)],
    'a vertex without a target': ['vertex 400 is not in its coarsest level', ({ view, order }) => view(order.targets).writeUInt32LE(400, 4 * 400)],
    'another tree of targets': ['triangles instead of', ({ view, order }) => view(order.targets).writeUInt32LE(0, 4 * 2900)],
    'no levels': ['its levels are no rows', ({ order }) => delete order.levels],
    'levels that are no rows': ['its levels are no rows', ({ order }) => (order.levels[1] = 5)],
    'levels with text': ['its levels are no rows', ({ order }) => (order.levels[1][0] = 'many')],
    'vertices that rise': ['the vertices of its levels do not fall', ({ order }) => (order.levels[2][0] = order.levels[1][0] + 1)],
    'errors that fall': ['the errors of its levels fall', ({ order }) => (order.levels[3][2] = 0)],
    'a full level of other vertices': ['its first level has', ({ order }) => (order.levels[0][0] += 1)],
    'a wrong number of triangles': ['triangles instead of', ({ order }) => (order.levels[2][1] -= 1)],
    'ranges without indices': ['its ranges have no indices', ({ order }) => delete order.indices],
    'a range past the end': ['triangles instead of', ({ order }) => (order.ranges.at(-1)[0] = 1e7)],
    'ranges of other levels': ['its ranges are not the first levels', ({ order }) => order.ranges.splice(1, 1)],
    'a range with a vertex of a finer level': ['uses vertex 3000', ({ order, view }) => view(order.indices).writeUInt16LE(3000, 2 * order.ranges[2][0])],
  };
  return new Map(Object.entries(variants).map(([name, [message, change]]) => {
    const { json, binary } = openGlb(bytes);
    const copy = Buffer.from(binary);
    const primitive = json.meshes[0].primitives[0];
    const order = primitive.extensions.STRIATA_order;
    const needs = ['ranges', 'range'].some((word) => name.split(' ').includes(word));
    if (!needs) ['ranges', 'indices'].forEach((key) => delete order[key]);
    const view = (index) => {
      const accessor = json.accessors[index];
      return copy.subarray((json.bufferViews[accessor.bufferView].byteOffset ?? 0) + (accessor.byteOffset ?? 0));
    };
    json.meshes[0].name = `broken by ${name}`;
    change({ json, primitive, order, view });
    return [`${name.replaceAll(' ', '_')}.glb`, { bytes: writeGlb({ json, binary: copy }), message }];
  }));
}
