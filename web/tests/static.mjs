// A server of files for tests of the package: the package itself, three.js, examples, and a folder of models.

import { once } from 'node:events';
import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { dirname, extname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

export const web = resolve(dirname(fileURLToPath(import.meta.url)), '..');

const TYPES = {
  '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.html': 'text/html', '.json': 'application/json', '.glb': 'model/gltf-binary',
};

/** Interval between two pieces of a throttled answer, milliseconds. */
const PIECE_INTERVAL_MS = 20;

/** A page with the package: `window` has `THREE`, the exports, and helpers to draw. */
const PAGE = `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,"><style>body { margin: 0 }</style><canvas width="400" height="300"></canvas>
<script type="importmap">{ "imports": {
  "three": "/node_modules/three/build/three.module.js", "three/addons/": "/node_modules/three/examples/jsm/", "striata": "/dist/striata.js"
} }</script>
<script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import * as striata from 'striata';
const renderer = new THREE.WebGLRenderer({ canvas: document.querySelector('canvas'), preserveDrawingBuffer: true });
const scene = new THREE.Scene();
scene.environment = new THREE.PMREMGenerator(renderer).fromEquirectangular(striata.studioEnvironment()).texture;
const camera = new THREE.PerspectiveCamera(35, 4 / 3, 0.001, 1e5);
const draw = () => { renderer.render(scene, camera); renderer.getContext().finish(); };
/** Looks at an object from a direction. */
const look = (object, direction = [0.5, 0.3, 1]) => {
  const box = new THREE.Box3().setFromObject(object);
  const { center, radius } = box.getBoundingSphere(new THREE.Sphere());
  camera.position.set(...direction).normalize().multiplyScalar(3.4 * radius).add(center);
  camera.lookAt(center);
  camera.updateMatrixWorld();
  return box;
};
const pixels = () => {
  draw();
  const gl = renderer.getContext();
  const bytes = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return bytes;
};
/** Mean difference of two pictures, of 255, over the pixels that either shows. */
const difference = (a, b) => {
  let [sum, count] = [0, 0];
  for (let at = 0; at < a.length; at += 4) {
    if (a[at + 3] === 0 && b[at + 3] === 0) continue;
    count += 4;
    for (let i = 0; i < 4; i++) sum += Math.abs(a[at + i] - b[at + i]);
  }
  return sum / Math.max(1, count);
};
/** Draws until levels no longer change. */
const settle = async (model) => {
  for (let last = -1, same = 0; same < 4; ) {
    draw();
    await new Promise((go) => setTimeout(go, 60));
    same = model.triangleCount === last ? same + 1 : 0;
    last = model.triangleCount;
  }
};
Object.assign(window, { THREE, GLTFLoader, MeshoptDecoder, ...striata, renderer, scene, camera, draw, look, pixels, difference, settle, isReady: true });
</script>`;

/**
 * Starts a server; `models` is served as `/models/`, ranges too, over a line of `rate` bytes per second that all answers share, each after
 * `delay` milliseconds.
 */
export async function staticServer(models) {
  const state = { rate: Infinity, delay: 0, sent: 0, requests: 0, freeAt: 0 };
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    if (path === '/') return response.setHeader('Content-Type', 'text/html').end(PAGE);
    const isModel = path.startsWith('/models/');
    const file = isModel ? join(models, path.slice('/models/'.length)) : join(web, path);
    if (path.includes('..') || !existsSync(file) || !statSync(file).isFile()) return response.writeHead(404).end();
    response.setHeader('Content-Type', TYPES[extname(file)] ?? 'application/octet-stream');
    const { size } = statSync(file);
    const [, first, last] = /^bytes=(\d+)-(\d+)$/.exec(request.headers.range ?? '') ?? [];
    const [start, end] = first === undefined ? [0, size - 1] : [Number(first), Math.min(Number(last), size - 1)];
    if (first !== undefined) response.writeHead(206, { 'Content-Range': `bytes ${start}-${end}/${size}`, 'Content-Length': end + 1 - start });
    else response.setHeader('Content-Length', size);
    const read = (options) => createReadStream(file, { start, end, ...options });
    if (!isModel) return read().pipe(response);
    return void send(read, response, state).catch(() => response.destroy());
  });
  server.listen(0, '127.0.0.1');
  await once(server, 'listening');
  const close = () => {
    server.close();
    server.closeAllConnections();
  };
  return { url: `http://127.0.0.1:${server.address().port}/`, state, close };
}

async function send(read, response, state) {
  state.requests += 1;
  if (state.delay > 0) await new Promise((go) => setTimeout(go, state.delay));
  const highWaterMark = Number.isFinite(state.rate) ? Math.ceil((state.rate * PIECE_INTERVAL_MS) / 1000) : 1 << 16;
  for await (const piece of read({ highWaterMark })) {
    if (response.destroyed) return;
    const due = Math.max(performance.now(), state.freeAt);
    state.freeAt = due + (1000 * piece.length) / state.rate;
    if (due > performance.now()) await new Promise((go) => setTimeout(go, due - performance.now()));
    state.sent += piece.length;
    response.write(piece);
  }
  response.end();
}
