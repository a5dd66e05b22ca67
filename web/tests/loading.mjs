// Measures how long a stream takes to load in Chromium at a given bandwidth: node tests/loading.mjs STREAM [MB/s] [tries]
//
// Reports the time from the request to the first picture and to the last triangle, and how long requests for views waited meanwhile.
// The page uses the package as it is published; only the first picture is drawn, since rendering runs on the CPU here.

import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { browser } from './harness.mjs';

const [, , stream, megabytes = '10', tries = '3'] = process.argv;
if (!stream) throw new Error('usage: node tests/loading.mjs STREAM [MB/s] [tries]');
const web = resolve(fileURLToPath(import.meta.url), '../..');
const bytesPerSecond = 1e6 * Number(megabytes);

/** Interval between two chunks of the stream, milliseconds. */
const CHUNK_INTERVAL_MS = 5;

const types = { '.js': 'text/javascript', '.wasm': 'application/wasm', '.html': 'text/html' };

const PAGE = `<!doctype html><meta charset="utf-8"><canvas width="800" height="600"></canvas>
<script type="importmap">{ "imports": { "three": "/node_modules/three/build/three.module.js", "striata": "/dist/striata.js" } }</script>
<script type="module">
import * as THREE from 'three';
import { StriataLoader } from 'striata';
const renderer = new THREE.WebGLRenderer({ canvas: document.querySelector('canvas') });
const scene = new THREE.Scene().add(new THREE.HemisphereLight(0xffffff, 0x444455, 3));
const camera = new THREE.PerspectiveCamera(45, 4 / 3, 0.001, 1e4);
const draw = () => { renderer.render(scene, camera); renderer.getContext().finish(); };
draw();
window.load = async (pixelError) => {
  const start = performance.now();
  const since = () => performance.now() - start;
  const mesh = await StriataLoader().load('/stream');
  mesh.geometry.computeBoundingSphere();
  const { center, radius } = mesh.geometry.boundingSphere;
  camera.position.set(0, 0.4 * radius, 2.6 * radius).add(center);
  camera.lookAt(center);
  scene.add(mesh);
  draw();
  const seen = { first: since(), firstTriangles: mesh.triangleCount, updates: 0, longest: 0 };
  mesh.addEventListener('change', () => { seen.updates += 1; });
  if (pixelError) {
    mesh.pixelError = pixelError;
    let isFinished = false;
    mesh.finished.finally(() => { isFinished = true; });
    // A camera that keeps moving sends the next request as soon as it has a response.
    for (let at = 0; !isFinished; at += 1) {
      const requested = performance.now();
      const answered = new Promise((give) => mesh.addEventListener('change', give, { once: true }));
      camera.position.x = center.x + 0.2 * radius * Math.sin(at);
      camera.updateMatrixWorld();
      mesh.onBeforeRender(renderer, scene, camera, mesh.geometry, mesh.material, null);
      await Promise.race([answered, mesh.finished]);
      seen.longest = Math.max(seen.longest, performance.now() - requested);
    }
  }
  await mesh.finished;
  Object.assign(seen, { all: since(), triangles: mesh.triangleCount, full: mesh.fullTriangleCount, ...mesh.timings });
  scene.remove(mesh);
  mesh.dispose();
  return seen;
};
</script>`;

const server = createServer((incoming, response) => {
  const { pathname } = new URL(incoming.url, 'http://localhost');
  if (pathname === '/stream') return void send(response).catch(() => response.destroy());
  response.setHeader('Content-Type', types[extname(pathname)] ?? 'text/html');
  if (pathname === '/') return response.end(PAGE);
  createReadStream(join(web, pathname)).on('error', () => response.writeHead(404).end()).pipe(response);
});

async function send(response) {
  response.setHeader('Content-Type', 'application/octet-stream');
  response.setHeader('Content-Length', statSync(stream).size);
  const start = performance.now();
  let sent = 0;
  for await (const piece of createReadStream(stream, { highWaterMark: Math.ceil((bytesPerSecond * CHUNK_INTERVAL_MS) / 1000) })) {
    const due = start + (1000 * sent) / bytesPerSecond;
    await new Promise((go) => setTimeout(go, Math.max(0, due - performance.now())));
    sent += piece.length;
    response.write(piece);
  }
  response.end();
}

await new Promise((go) => server.listen(0, '127.0.0.1', go));
const { context, close } = await browser();
try {
  const page = await context.newPage();
  page.on('pageerror', (error) => console.error(error));
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForFunction(() => window.load);
  for (const pixelError of [null, 1]) {
    for (let attempt = 0; attempt < Number(tries); attempt += 1) {
      const seen = await page.evaluate((pixelError) => window.load(pixelError), pixelError);
      const ms = (time) => `${time.toFixed(0)} ms`;
      console.log(
        `${pixelError ? 'view' : 'all'}: first picture ${ms(seen.first)} (${seen.firstTriangles} triangles), all ${ms(seen.all)} (${seen.triangles} of ${seen.full}), ` +
        `decoding ${ms(seen.decodeMs)}, hierarchy ${ms(seen.buildMs)}, ${seen.updates} updates, longest response ${ms(seen.longest)}`,
      );
    }
  }
} finally {
  await close();
  server.close();
}
