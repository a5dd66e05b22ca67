// Tests of paged files without a browser: in memory, and by ranges from a server. terrain.striata is `shape:terrain:60`.

import assert from 'node:assert/strict';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

const dist = new URL('../../dist/', import.meta.url);
const { StriataLoader } = await import(new URL('striata.js', dist));
const [wasm, files] = await Promise.all(['striata', 'striata-files'].map((name) => WebAssembly.compile(readFileSync(new URL(`${name}.wasm`, dist)))));
const file = readFileSync(new URL('terrain.striata', import.meta.url));
const TRIANGLES = 6962;

const loader = new StriataLoader(undefined, { worker: false, wasm, files });

/** Waits until a condition holds. */
async function until(condition) {
  for (let tries = 0; !condition(); tries += 1) {
    assert.ok(tries < 1000, 'nothing happens');
    await delay(10);
  }
}

async function checkLevels(scene) {
  assert.equal(scene.kind, 'paged');
  assert.equal(scene.fullTriangleCount, TRIANGLES);
  scene.triangleBudget = 1000;
  await until(() => scene.complete && scene.triangleCount > 800 && scene.triangleCount <= 1000);
  const { index, drawRange } = scene.lods[0].meshes[0].geometry;
  assert.equal(drawRange.count, 3 * scene.triangleCount);
  assert.ok(index.count >= drawRange.count);
  scene.detail = 1;
  await until(() => scene.complete && scene.triangleCount === TRIANGLES);
  assert.equal(scene.error, 0);
  scene.maxError = 5;
  await until(() => scene.complete && scene.triangleCount < TRIANGLES / 2);
  assert.ok(scene.error > 0 && scene.error <= 5, `${scene.error}`);
  const allowed = scene.triangleCount;
  let updates = 0;
  scene.addEventListener('change', () => (updates += 1));
  scene.triangleBudget = allowed + 1000;
  await until(() => scene.complete && updates > 0);
  await delay(200);
  assert.equal(scene.triangleCount, allowed, 'a limit that is not reached changes nothing');
  scene.triangleBudget = Math.floor(allowed / 2);
  await until(() => scene.complete && scene.triangleCount <= allowed / 2);
  await assert.rejects(scene.lods[0].indices({ detail: 0.5 }), { code: 'unsupported' });
  scene.dispose();
}

test('a paged file in memory shows any level', async () => {
  await checkLevels(await loader.open(file.buffer.slice(file.byteOffset, file.byteOffset + file.length), { name: 'terrain.striata' }));
});

/** Serves the file; `answersRanges` as most servers do. */
async function serve(answersRanges) {
  const requests = [];
  const server = createServer((request, response) => {
    const range = /bytes=(\d+)-(\d+)/.exec(request.headers.range ?? '');
    requests.push(request.headers.range ?? 'all');
    if (!range || !answersRanges) return response.end(file);
    const [from, to] = [Number(range[1]), Math.min(Number(range[2]) + 1, file.length)];
    response.writeHead(206, { 'Content-Range': `bytes ${from}-${to - 1}/${file.length}` });
    return response.end(file.subarray(from, to));
  }).listen(0, '127.0.0.1');
  await once(server, 'listening');
  return { url: `http://127.0.0.1:${server.address().port}/terrain.striata`, requests, stop: () => server.close() };
}

test('a paged file on a server is read in ranges', async () => {
  const { url, requests, stop } = await serve(true);
  try {
    await checkLevels(await loader.open(url));
    assert.ok(requests.every((range) => range.startsWith('bytes=')), String(requests));
  } finally {
    stop();
  }
});

test('a damaged page is reported, and the mesh stays coarse there', async () => {
  const damaged = Uint8Array.from(file);
  for (let at = file.length - 5000; at < file.length; at += 100) damaged[at] ^= 0x55;
  const scene = await loader.open(damaged.buffer, { name: 'damaged.striata' });
  const errors = [];
  scene.addEventListener('error', ({ error }) => errors.push(error));
  scene.detail = 1;
  await until(() => errors.length > 0);
  assert.match(errors[0].message, /page of level 0, cell 0: the checksum does not match/);
  assert.equal(errors[0].code, 'corrupt');
  // Other levels are still shown.
  await until(() => scene.complete);
  assert.ok(scene.triangleCount > 0 && scene.triangleCount < scene.fullTriangleCount);
  let isAnswered = false;
  scene.addEventListener('change', () => (isAnswered = true));
  scene.detail = 0;
  await until(() => isAnswered && scene.complete);
  scene.dispose();
  await assert.rejects(loader.open(file.buffer.slice(file.byteOffset, file.byteOffset + 100), { name: 'cut.striata' }), { code: 'corrupt' });
});
