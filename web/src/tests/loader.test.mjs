// Loader and mesh as they are shipped, without a browser: what they are asked for late, twice, or by servers of other habits.

import assert from 'node:assert/strict';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { after, before, test } from 'node:test';
import { setTimeout as passed } from 'node:timers/promises';
import { CubeCamera, Group, Mesh, MeshBasicMaterial, OrthographicCamera, PerspectiveCamera, WebGLCubeRenderTarget } from 'three';

const dist = new URL('../../dist/', import.meta.url);
const { StriataLoader } = await import(new URL('striata.js', dist));
const wasm = await WebAssembly.compile(readFileSync(new URL('striata.wasm', dist)));
const stream = readFileSync(new URL('spot.stri', import.meta.url));
const TRIANGLES = 5856;
const bytes = stream.buffer.slice(stream.byteOffset, stream.byteOffset + stream.length);

/** Without a worker: Node.js has none of these. */
const loader = StriataLoader({ worker: false, wasm });

async function whole(options) {
  const mesh = await loader.load(bytes, options);
  await mesh.finished;
  return mesh;
}

/** The triangles after what was asked for is shown. */
async function shown(mesh) {
  await passed(50);
  return mesh.triangleCount;
}

/** As a renderer does before it draws the mesh, some frames long: triangles for a view come little by little. */
async function seenBy(mesh, camera) {
  const renderer = { getRenderTarget: () => null, getDrawingBufferSize: (size) => size.set(400, 300) };
  camera.updateMatrixWorld();
  mesh.updateWorldMatrix(true, false);
  for (let frame = 0; frame < 20; frame++) {
    mesh.onBeforeRender(renderer, null, camera);
    await passed(10);
  }
  return shown(mesh);
}

test('a signal has no say in what has been loaded', async () => {
  const abort = new AbortController();
  const mesh = await whole({ signal: abort.signal });
  abort.abort();
  mesh.detail = 0.2;
  assert.ok((await shown(mesh)) < TRIANGLES / 2);
  mesh.dispose();
});

test('a mesh that was aborted can be disposed of, also twice', async () => {
  const abort = new AbortController();
  const pieces = new ReadableStream({ start: (controller) => controller.enqueue(new Uint8Array(bytes.slice(0, bytes.byteLength / 2))) });
  const mesh = await loader.load(pieces, { signal: abort.signal });
  abort.abort();
  await assert.rejects(mesh.finished, { code: 'aborted' });
  mesh.dispose();
  mesh.dispose();
});

test('damage is told once, and ends the download', async () => {
  const damaged = new Uint8Array(bytes.slice(0));
  for (let at = damaged.length >> 1; at < damaged.length; at += 7) damaged[at] ^= 0x5a;
  let [at, told, isCancelled] = [0, 0, false];
  const pieces = new ReadableStream({
    pull: async (controller) => {
      await passed(2);
      // Never ends by itself.
      controller.enqueue(at < damaged.length ? damaged.slice(at, (at += 2048)) : new Uint8Array(2048));
    },
    cancel: () => (isCancelled = true),
  });
  const mesh = await loader.load(pieces);
  mesh.addEventListener('error', () => (told += 1));
  await assert.rejects(mesh.finished, { code: 'corrupt' });
  await passed(100);
  assert.deepEqual([told, isCancelled], [1, true]);
  mesh.detail = 0;
  assert.ok((await shown(mesh)) < 100, 'what came still changes');
  mesh.dispose();
});

test('budgets of any size', async () => {
  const mesh = await whole();
  for (const [budget, most] of [[100, 100], [Infinity, TRIANGLES], [1, 60], [2 ** 32, TRIANGLES]]) {
    mesh.triangleBudget = budget;
    const count = await shown(mesh);
    assert.ok(count > 0 && count <= most && (most < TRIANGLES || count === TRIANGLES), `${budget}: ${count}`);
  }
  mesh.dispose();
});

test('cameras that see nothing, and those that see upside down', async () => {
  const mesh = await whole();
  mesh.addEventListener('error', ({ error }) => assert.fail(error.message));
  const camera = new PerspectiveCamera(40, 4 / 3);
  camera.position.z = 3 * mesh.diagonal;
  mesh.pixelError = 1;
  const count = await seenBy(mesh, camera);
  assert.ok(count > 100 && count < TRIANGLES, `${count}`);
  camera.fov = 180;
  camera.updateProjectionMatrix();
  await seenBy(mesh, camera);
  camera.fov = 40;
  camera.updateProjectionMatrix();
  camera.position.z = NaN;
  await seenBy(mesh, camera);
  const cube = new CubeCamera(0.01, 100, new WebGLCubeRenderTarget(64));
  cube.position.set(0, 0, 3 * mesh.diagonal);
  cube.updateMatrixWorld();
  const towards = cube.children[5];
  towards.lookAt(0, 0, 0);
  assert.ok((await seenBy(mesh, towards)) > 20);
  mesh.pixelError = 0.1;
  camera.position.z = 3 * mesh.diagonal;
  assert.ok((await seenBy(mesh, camera)) > count, 'it still follows');
  const flat = new OrthographicCamera(-1, 1, 1, -1);
  assert.ok((await seenBy(mesh, flat)) > 0);
  mesh.dispose();
});

test('from afar through a long lens a view is nearly the same', async () => {
  const mesh = await whole();
  mesh.addEventListener('error', ({ error }) => assert.fail(error.message));
  mesh.pixelError = 1;
  const counts = [];
  for (const away of [1e3, 1e8]) {
    const camera = new PerspectiveCamera((2 * Math.atan(mesh.diagonal / away) * 180) / Math.PI, 4 / 3, away / 2, 2 * away);
    camera.position.z = away;
    counts.push(await seenBy(mesh, camera));
  }
  const [near, far] = counts;
  assert.ok(near > 100 && Math.abs(far - near) <= 0.1 * near, `${near} and ${far}`);
  mesh.dispose();
});

test('several materials can come later, and copies share what is shown', async () => {
  const mesh = await whole();
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

/** Sends what is asked for; for `/parts` a part, without telling of how much. */
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

test('addresses of any kind', async () => {
  for (const path of ['/parts.striata', '/100%.stri', '/%ff.stri', '/a%20b.stri?x=%']) {
    const mesh = await loader.load(address + path);
    await mesh.finished;
    assert.equal(mesh.triangleCount, TRIANGLES, path);
    mesh.dispose();
  }
  await assert.rejects(loader.load('http://['), { code: 'unsupported' });
  await assert.rejects(loader.load(`${address}/empty.striata`), { code: 'format' });
});
