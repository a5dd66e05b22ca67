// Tests of the packaged loader and mesh without a browser: late and repeated calls, and unusual servers.

import assert from 'node:assert/strict';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { after, before, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { CubeCamera, Group, Mesh, MeshBasicMaterial, OrthographicCamera, PerspectiveCamera, WebGLCubeRenderTarget } from 'three';

const dist = new URL('../../dist/', import.meta.url);
const { StriataLoader } = await import(new URL('striata.js', dist));
const wasm = await WebAssembly.compile(readFileSync(new URL('striata.wasm', dist)));
const stream = readFileSync(new URL('spot.stri', import.meta.url));
const TRIANGLES = 5856;
const bytes = stream.buffer.slice(stream.byteOffset, stream.byteOffset + stream.length);

/** Runs without a worker, since Node.js has no web workers. */
const loader = StriataLoader({ worker: false, wasm });

async function loadWhole(options) {
  const mesh = await loader.load(bytes, options);
  await mesh.finished;
  return mesh;
}

/** Number of triangles after pending requests were answered. */
async function countAfterUpdate(mesh) {
  await delay(50);
  return mesh.triangleCount;
}

/** Acts as a renderer for several frames, since view-dependent refinement proceeds step by step. */
async function countSeenBy(mesh, camera) {
  const renderer = { getRenderTarget: () => null, getDrawingBufferSize: (size) => size.set(400, 300) };
  camera.updateMatrixWorld();
  mesh.updateWorldMatrix(true, false);
  for (let frame = 0; frame < 20; frame++) {
    mesh.onBeforeRender(renderer, null, camera);
    await delay(10);
  }
  return countAfterUpdate(mesh);
}

test('aborting after loading has finished has no effect', async () => {
  const abort = new AbortController();
  const mesh = await loadWhole({ signal: abort.signal });
  abort.abort();
  mesh.detail = 0.2;
  assert.ok((await countAfterUpdate(mesh)) < TRIANGLES / 2);
  mesh.dispose();
});

test('an aborted mesh can be disposed of twice', async () => {
  const abort = new AbortController();
  const pieces = new ReadableStream({ start: (controller) => controller.enqueue(new Uint8Array(bytes.slice(0, bytes.byteLength / 2))) });
  const mesh = await loader.load(pieces, { signal: abort.signal });
  abort.abort();
  await assert.rejects(mesh.finished, { code: 'aborted' });
  mesh.dispose();
  mesh.dispose();
});

test('damage is reported once and cancels the download', async () => {
  const damaged = new Uint8Array(bytes.slice(0));
  for (let at = damaged.length >> 1; at < damaged.length; at += 7) damaged[at] ^= 0x5a;
  let [at, errorCount, isCanceled] = [0, 0, false];
  const pieces = new ReadableStream({
    pull: async (controller) => {
      await delay(2);
      // The stream never ends by itself.
      controller.enqueue(at < damaged.length ? damaged.slice(at, (at += 2048)) : new Uint8Array(2048));
    },
    cancel: () => (isCanceled = true),
  });
  const mesh = await loader.load(pieces);
  mesh.addEventListener('error', () => (errorCount += 1));
  await assert.rejects(mesh.finished, { code: 'corrupt' });
  await delay(100);
  assert.deepEqual([errorCount, isCanceled], [1, true]);
  mesh.detail = 0;
  assert.ok((await countAfterUpdate(mesh)) < 100, 'the loaded part can still change its level');
  mesh.dispose();
});

test('budgets of any size are respected', async () => {
  const mesh = await loadWhole();
  for (const [budget, most] of [[100, 100], [Infinity, TRIANGLES], [1, 60], [2 ** 32, TRIANGLES]]) {
    mesh.triangleBudget = budget;
    const count = await countAfterUpdate(mesh);
    assert.ok(count > 0 && count <= most && (most < TRIANGLES || count === TRIANGLES), `${budget}: ${count}`);
  }
  mesh.dispose();
});

test('requests for indices are answered in turn, and the shown level stays', async () => {
  const mesh = await loadWhole();
  mesh.triangleBudget = 700;
  const counts = [];
  for (const triangles of [500, 400, 300]) counts.push((await mesh.indicesOf({ by: 'triangles', value: triangles, limit: 0 }))[0].length / 3);
  const together = await Promise.all([200, 100].map((value) => mesh.indicesOf({ by: 'triangles', value, limit: 0 })));
  assert.deepEqual([...counts, ...together.map(([list]) => list.length / 3)], [500, 400, 300, 200, 100]);
  assert.equal(await countAfterUpdate(mesh), 700);
  mesh.dispose();
});

test('cameras that see nothing or upside down are handled', async () => {
  const mesh = await loadWhole();
  mesh.addEventListener('error', ({ error }) => assert.fail(error.message));
  const camera = new PerspectiveCamera(40, 4 / 3);
  camera.position.z = 3 * mesh.diagonal;
  mesh.pixelError = 1;
  const count = await countSeenBy(mesh, camera);
  assert.ok(count > 100 && count < TRIANGLES, `${count}`);
  camera.fov = 180;
  camera.updateProjectionMatrix();
  await countSeenBy(mesh, camera);
  camera.fov = 40;
  camera.updateProjectionMatrix();
  camera.position.z = NaN;
  await countSeenBy(mesh, camera);
  const cube = new CubeCamera(0.01, 100, new WebGLCubeRenderTarget(64));
  cube.position.set(0, 0, 3 * mesh.diagonal);
  cube.updateMatrixWorld();
  const towards = cube.children[5];
  towards.lookAt(0, 0, 0);
  assert.ok((await countSeenBy(mesh, towards)) > 20);
  mesh.pixelError = 0.1;
  camera.position.z = 3 * mesh.diagonal;
  assert.ok((await countSeenBy(mesh, camera)) > count, 'the mesh still follows the camera');
  const flat = new OrthographicCamera(-1, 1, 1, -1);
  assert.ok((await countSeenBy(mesh, flat)) > 0);
  mesh.dispose();
});

test('a distant telephoto camera gives nearly the same triangles', async () => {
  const mesh = await loadWhole();
  mesh.addEventListener('error', ({ error }) => assert.fail(error.message));
  mesh.pixelError = 1;
  const counts = [];
  for (const distance of [1e3, 1e8]) {
    const camera = new PerspectiveCamera((2 * Math.atan(mesh.diagonal / distance) * 180) / Math.PI, 4 / 3, distance / 2, 2 * distance);
    camera.position.z = distance;
    counts.push(await countSeenBy(mesh, camera));
  }
  const [near, far] = counts;
  assert.ok(near > 100 && Math.abs(far - near) <= 0.1 * near, `${near} and ${far}`);
  mesh.dispose();
});

test('material arrays can be assigned later, and clones share the geometry', async () => {
  const mesh = await loadWhole();
  mesh.material = [new MeshBasicMaterial()];
  const count = mesh.geometry.groups.reduce((sum, group) => sum + group.count, 0);
  assert.equal(count, 3 * TRIANGLES);
  mesh.position.x = 5;
  const copy = new Group().add(mesh).clone().children[0];
  assert.ok(copy instanceof Mesh && copy.geometry === mesh.geometry && copy.position.x === 5);
  const geometry = mesh.geometry.clone();
  geometry.boundingSphere = null;
  geometry.computeBoundingSphere();
  assert.ok(Math.abs(geometry.boundingSphere.radius - mesh.geometry.boundingSphere.radius) < 1e-6);
  mesh.dispose();
});

/** Serves the stream; `/parts` answers range requests without a total length. */
const server = createServer((request, response) => {
  const [, first, last] = /bytes=(\d+)-(\d+)/.exec(request.headers.range ?? '') ?? [];
  if (request.url === '/empty.striata') return response.writeHead(416).end();
  if (first === undefined || !request.url.startsWith('/parts')) return response.end(Buffer.from(bytes));
  return response.writeHead(206).end(Buffer.from(bytes.slice(Number(first), Number(last) + 1)));
});
let address;
before(async () => {
  server.listen(0, '127.0.0.1');
  await once(server, 'listening');
  address = `http://127.0.0.1:${server.address().port}`;
});
after(() => {
  server.close();
  server.closeAllConnections();
});

test('unusual URLs are loaded or rejected', async () => {
  for (const path of ['/parts.striata', '/100%.stri', '/%ff.stri', '/a%20b.stri?x=%']) {
    const mesh = await loader.load(address + path);
    await mesh.finished;
    assert.equal(mesh.triangleCount, TRIANGLES, path);
    mesh.dispose();
  }
  await assert.rejects(loader.load('http://['), { code: 'unsupported' });
  await assert.rejects(loader.load(`${address}/empty.striata`), { code: 'format' });
});
