// Tests of plain files: three.js' loaders read them, and the package builds their levels.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

const dist = new URL('../../dist/', import.meta.url);
const { StriataLoader } = await import(new URL('striata.js', dist));
const [wasm, builder] = await Promise.all(['striata', 'striata-builder'].map((name) => WebAssembly.compile(readFileSync(new URL(`${name}.wasm`, dist)))));

/** Runs without a worker, since Node.js has no web workers. */
const loader = new StriataLoader(undefined, { worker: false, wasm, builder, pixelError: null });
const SIDE = 24;
const TRIANGLES = 2 * SIDE * SIDE;

/** A bumpy square of quads. */
function grid() {
  const [positions, corners] = [[], []];
  for (let y = 0; y <= SIDE; y++) {
    for (let x = 0; x <= SIDE; x++) positions.push(x / SIDE, y / SIDE, 0.1 * Math.sin(x * 0.7) * Math.cos(y * 0.5));
  }
  for (let y = 0; y < SIDE; y++) {
    for (let x = 0; x < SIDE; x++) {
      const [a, b] = [y * (SIDE + 1) + x, (y + 1) * (SIDE + 1) + x];
      corners.push(a, a + 1, b, a + 1, b + 1, b);
    }
  }
  return { positions, corners };
}

const { positions, corners } = grid();
const triples = (numbers) => Array.from({ length: numbers.length / 3 }, (_, at) => numbers.slice(3 * at, 3 * at + 3));
const bytesOf = (text) => new TextEncoder().encode(text).buffer;

const texts = {
  'grid.obj': `${triples(positions).map((p) => `v ${p.join(' ')}`).join('\n')}\n${triples(corners).map((t) => `f ${t.map((c) => c + 1).join(' ')}`).join('\n')}\n`,
  'grid.off': `OFF\n${positions.length / 3} ${TRIANGLES} 0\n${triples(positions).map((p) => p.join(' ')).join('\n')}\n${triples(corners).map((t) => `3 ${t.join(' ')}`).join('\n')}\n`,
  'grid.ply': `ply\nformat ascii 1.0\nelement vertex ${positions.length / 3}\nproperty float x\nproperty float y\nproperty float z\nelement face ${TRIANGLES}\n`
    + `property list uchar int vertex_indices\nend_header\n${triples(positions).map((p) => p.join(' ')).join('\n')}\n${triples(corners).map((t) => `3 ${t.join(' ')}`).join('\n')}\n`,
  'grid.stl': `solid grid\n${triples(corners).map((t) => `facet normal 0 0 1\nouter loop\n${t.map((c) => `vertex ${positions.slice(3 * c, 3 * c + 3).join(' ')}`).join('\n')}\nendloop\nendfacet`).join('\n')}\nendsolid grid\n`,
};

/** A GLB file with one mesh of two primitives, whose node moves. */
function glb() {
  const half = corners.length / 2;
  const parts = [Float32Array.from(positions), Uint32Array.from(corners.slice(0, half)), Uint32Array.from(corners.slice(half)), Float32Array.of(0, 1), Float32Array.of(0, 0, 0, 1, 0, 0)];
  const bufferViews = [];
  let length = 0;
  for (const { byteLength } of parts) {
    bufferViews.push({ buffer: 0, byteOffset: length, byteLength });
    length += byteLength;
  }
  const scalars = (bufferView, count, componentType) => ({ bufferView, componentType, count, type: 'SCALAR' });
  const json = {
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0, 1] }], nodes: [{ mesh: 0 }, { mesh: 0, translation: [2, 0, 0], scale: [2, 2, 2] }],
    materials: [{ name: 'red', pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] } }, { name: 'blue' }],
    meshes: [{ primitives: [0, 1].map((at) => ({ attributes: { POSITION: 0 }, indices: 1 + at, material: at })) }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: positions.length / 3, type: 'VEC3', min: [0, 0, -0.1], max: [1, 1, 0.1] },
      scalars(1, half, 5125), scalars(2, half, 5125), { ...scalars(3, 2, 5126), min: [0], max: [1] }, { bufferView: 4, componentType: 5126, count: 2, type: 'VEC3' },
    ],
    animations: [{ channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }], samplers: [{ input: 3, output: 4 }] }],
    bufferViews, buffers: [{ byteLength: length }],
  };
  let text = JSON.stringify(json);
  text += ' '.repeat((4 - (text.length % 4)) % 4);
  const file = Buffer.alloc(28 + text.length + length);
  [0x46546c67, 2, file.length, text.length, 0x4e4f534a].forEach((word, at) => file.writeUInt32LE(word, 4 * at));
  file.write(text, 20);
  file.writeUInt32LE(length, 20 + text.length);
  file.writeUInt32LE(0x004e4942, 24 + text.length);
  let at = 28 + text.length;
  for (const part of parts) at += Buffer.from(part.buffer).copy(file, at);
  return file.buffer.slice(file.byteOffset, file.byteOffset + file.length);
}

/** Checks that the scene shows coarser levels, and returns to the full mesh. */
async function checkLevels(scene, full) {
  await delay(60);
  assert.deepEqual([scene.fullTriangleCount, scene.triangleCount, scene.complete], [full, full, true]);
  scene.triangleBudget = full / 4;
  await delay(60);
  assert.ok(scene.triangleCount > 0 && scene.triangleCount <= full / 4, `${scene.triangleCount}`);
  scene.detail = 1;
  await delay(60);
  assert.equal(scene.triangleCount, full);
}

test('every plain format becomes a scene with levels and normals', async () => {
  for (const [name, text] of Object.entries(texts)) {
    const shares = [];
    const scene = await loader.open(bytesOf(text), { name, onProgress: ({ share }) => share !== undefined && shares.push(share) });
    await checkLevels(scene, TRIANGLES);
    assert.ok(scene.lods[0].meshes[0].geometry.getAttribute('normal'), name);
    assert.ok(shares.at(-1) === 1, `${name}: ${shares}`);
    assert.equal(scene.lods[0].meshes[0].geometry.getAttribute('position').count >= (SIDE + 1) ** 2, true);
    scene.dispose();
  }
});

test('compressed files are decompressed', async () => {
  const asset = readFileSync(new URL('../../../assets/spot.obj.zst', import.meta.url));
  const scene = await loader.open(asset.buffer.slice(asset.byteOffset, asset.byteOffset + asset.length), { name: 'spot.obj.zst' });
  assert.equal(scene.fullTriangleCount, 5856);
  assert.ok(scene.lods[0].meshes[0].geometry.getAttribute('uv'), 'the asset has texture coordinates');
  scene.dispose();
});

test('a GLB file keeps its nodes, materials and animations', async () => {
  const scene = await loader.open(glb(), { name: 'grid.glb' });
  await checkLevels(scene, 2 * TRIANGLES);
  assert.deepEqual([scene.lods.length, scene.lods[0].meshes.length, scene.animations.length], [1, 4, 1]);
  assert.deepEqual(scene.lods[0].meshes.map(({ material }) => material.name), ['red', 'blue', 'red', 'blue']);
  assert.ok(Math.abs(scene.diagonal - Math.hypot(4, 2, 0.4)) < 0.1, `${scene.diagonal}`);
  const lists = await scene.lods[0].indices({ triangles: 200 });
  assert.equal(lists.length, 2);
  assert.ok(lists[0].length + lists[1].length <= 600);
  scene.dispose();
});

test('the deprecated call loads plain files as a single mesh', async () => {
  for (const [name, source, full] of [['grid.glb', glb(), 2 * TRIANGLES], ['grid.obj', bytesOf(texts['grid.obj']), TRIANGLES]]) {
    const mesh = await loader.load(source, { name });
    await mesh.finished;
    assert.deepEqual([mesh.fullTriangleCount, mesh.kind], [full, 'mesh'], name);
    mesh.detail = 0.2;
    await delay(60);
    assert.ok(mesh.triangleCount < full / 2, name);
    mesh.dispose();
  }
});

test('files that are damaged or no models are rejected', async () => {
  const cases = [
    ['garbage.stri', 'no model, whatever its name says', 'format'],
    ['cut.off', texts['grid.off'].slice(0, 900), 'corrupt'],
    ['bad.off', texts['grid.off'].replace(/\n3 0 1 /, '\n3 0 999999 '), 'corrupt'],
    ['points.ply', texts['grid.ply'].replace(/element face[^]*?end_header/, 'end_header'), 'unsupported'],
    ['cut.glb', undefined, 'corrupt'],
  ];
  for (const [name, text, code] of cases) {
    const source = text === undefined ? glb().slice(0, 3000) : bytesOf(text);
    await assert.rejects(loader.open(source, { name }), (error) => error.code === code || assert.fail(`${name}: ${error.code}: ${error.message}`));
  }
});
