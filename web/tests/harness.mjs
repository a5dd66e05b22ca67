// Shared by the browser tests: models made by the command, `striata serve`, one Chromium with WebGL 2, pages.

import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { front } from './front.mjs';

export const workspace = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const striata = process.env.STRIATA_BIN ?? join(workspace, 'target/debug/striata');

/** Timeout that allows for machines under heavy load. */
export const PATIENCE_MS = 600_000;

/** The viewer to test: the one that is embedded in the command, or one that STRIATA_VIEWER names and that is not embedded yet. */
export const viewerFolder = process.env.STRIATA_VIEWER ?? join(workspace, 'crates/striata-viewer/viewer');

/** Flags that render WebGL 2 without a graphics card. */
const CHROMIUM_FLAGS = [
  '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
  '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
];

/** Runs the command and returns its output. */
export function run(...words) {
  const ended = spawnSync(striata, words, { encoding: 'utf8', maxBuffer: 1 << 26 });
  if (ended.error) throw new Error(`cannot start ${striata}: ${ended.error.message}`);
  if (ended.status !== 0) throw new Error(`striata ${words.join(' ')} exited with ${ended.status}: ${ended.stderr}`);
  return ended.stdout;
}

/** Makes the models for the tests with the command. */
export function makeModels(folder) {
  const bust = join(workspace, 'crates/striata-cli/assets/nefertiti.ply.zst');
  const at = (...parts) => join(folder, ...parts);
  mkdirSync(at('sub'), { recursive: true });
  run('encode', '-q', bust, '-o', at('nefertiti.stri'), '--bits', '18');
  run('encode', '-q', 'shape:icosphere', '-o', at('icosphere.stri'));
  run('encode', '-q', 'shape:terrain', '-o', at('sub', 'terrain.stri'));
  run('build', '-q', join(workspace, 'assets/spot.obj.zst'), '--stream', '-o', at('spot.striata'));
  const arm = join(workspace, 'assets/arm.glb');
  run('encode', '-q', arm, '-o', at('arm.stri'));
  run('build', '-q', arm, '-o', at('arm.striata'));
  // Without compression, as most exporters write it.
  run('convert', '-q', arm, at('plain-arm.glb'));
  run('convert', '-q', 'shape:torus', at('torus.obj'));
  run('convert', '-q', 'shape:tetrahedron', at('tetrahedron.obj'));
  const whole = readFileSync(at('icosphere.stri'));
  const damaged = Buffer.from(whole);
  for (let index = whole.length >> 1; index < whole.length; index += 7) damaged[index] ^= 0x5a;
  writeFileSync(at('damaged.stri'), damaged);
  writeFileSync(at('garbage.stri'), Buffer.from('this is no model, whatever its name says\n'.repeat(40)));
}

/** Creates a temporary folder. */
export function temporaryFolder(name) {
  return mkdtempSync(join(tmpdir(), `striata-${name}-`));
}

/** Starts `striata serve` on a free port; call `stop` to end it. */
export async function serve(folder) {
  const child = spawn(striata, ['serve', folder, '--port', '0', '--json'], { stdio: ['ignore', 'pipe', 'pipe'] });
  let log = '';
  child.stderr.on('data', (text) => (log += text));
  const ended = new Promise((_, reject) => {
    child.once('error', (error) => reject(new Error(`cannot start ${striata}: ${error.message}`)));
    child.once('exit', (code) => reject(new Error(`striata serve exited with ${code}: ${log}`)));
  });
  ended.catch(() => {});
  const lines = createInterface({ input: child.stdout });
  const first = new Promise((resolve) => lines.once('line', resolve));
  const { url } = JSON.parse(await Promise.race([first, ended]));
  if (!process.env.STRIATA_VIEWER) return { url: url.endsWith('/') ? url : `${url}/`, stop: () => stop(child) };
  const page = await front(viewerFolder, url);
  const stopBoth = () => {
    page.stop();
    return stop(child);
  };
  return { url: page.url, stop: stopBoth };
}

async function stop(child) {
  if (child.exitCode !== null) return;
  const gone = new Promise((resolve) => child.once('exit', resolve));
  child.kill('SIGTERM');
  const timer = setTimeout(() => child.kill('SIGKILL'), 5_000);
  await gone;
  clearTimeout(timer);
}

/** Starts the browser with a temporary profile. */
export async function browser() {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  if (!existsSync(executablePath)) throw new Error(`${executablePath} does not exist; run apt-get install chromium, or set CHROMIUM`);
  const profile = temporaryFolder('chromium');
  const context = await chromium.launchPersistentContext(profile, {
    executablePath, args: CHROMIUM_FLAGS, headless: true, viewport: { width: 1200, height: 760 }, timeout: PATIENCE_MS,
    acceptDownloads: true,
  });
  context.setDefaultTimeout(PATIENCE_MS);
  const close = async () => {
    await context.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  };
  return { context, close };
}

/** Everything the tests share: `world.page()` opens a page, `world.url` is the server's address. */
export async function world() {
  const folder = temporaryFolder('models');
  const { context, close } = await browser().catch((error) => {
    rmSync(folder, { recursive: true, force: true });
    throw error;
  });
  let server;
  const end = async () => {
    await close();
    await server?.stop();
    rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  };
  try {
    makeModels(folder);
    server = await serve(folder);
  } catch (error) {
    await end();
    throw error;
  }
  return { folder, url: server.url, context, page: (options) => newPage(context, options), end };
}

/** Opens a page that records uncaught and logged errors, except those that the test expects. */
export async function newPage(context, { expected = [], width = 900, height = 600, scheme = 'light', still = true } = {}) {
  const page = await context.newPage();
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ colorScheme: scheme, reducedMotion: still ? 'reduce' : 'no-preference' });
  await page.addInitScript(countRequests);
  page.faults = [];
  const fault = (text) => {
    if (!expected.some((pattern) => pattern.test(text))) page.faults.push(text);
  };
  page.on('pageerror', (error) => fault(`thrown: ${error.stack ?? error.message}`));
  page.on('console', (message) => {
    if (message.type() === 'error') fault(`logged: ${message.text()}`);
  });
  return page;
}

/** Runs in the page: `pendingRequests()` returns how many workers have not answered their last request for a level yet. */
function countRequests() {
  const workers = new Map();
  window.pendingRequests = () => [...workers.values()].filter(({ requested, answered }) => requested > answered).length;
  const { postMessage, terminate } = Worker.prototype;
  Worker.prototype.postMessage = function (order, ...rest) {
    if (order?.type === 'show') {
      let worker = workers.get(this);
      if (!worker) {
        workers.set(this, (worker = { requested: 0, answered: 0 }));
        this.addEventListener('message', ({ data }) => {
          // Updates without a ticket answer no request.
          if (data.type === 'update' || data.type === 'accepted') worker.answered = Math.max(worker.answered, data.ticket);
        });
      }
      worker.requested = order.ticket;
    }
    return postMessage.call(this, order, ...rest);
  };
  Worker.prototype.terminate = function () {
    workers.delete(this);
    return terminate.call(this);
  };
}

/** Saves a screenshot if STRIATA_SHOTS names a folder. */
export async function shot(page, name) {
  const folder = process.env.STRIATA_SHOTS;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`) });
}

/** Waits until the shown model has loaded completely. */
export async function untilWhole(page) {
  await page.waitForFunction(() => window.striataViewer?.model?.complete === true);
  await page.evaluate(() => window.striataViewer.model.finished);
}

/** Waits until the worker has answered all requests, and neither the triangles nor the camera change between frames. */
export async function settled(page) {
  await page.evaluate(async (patience) => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(() => resolve()));
    const { stage, model } = window.striataViewer;
    const started = performance.now();
    let frames = 0;
    const note = () => (frames = 0);
    model.addEventListener('change', note);
    let last = '';
    while (frames < 12 || window.pendingRequests() > 0) {
      stage.invalidate();
      await frame();
      frames += 1;
      const now = `${model.triangleCount} ${stage.camera.position.toArray()}`;
      if (now !== last) note();
      last = now;
      if (performance.now() - started > patience) throw new Error('the model keeps changing');
    }
    model.removeEventListener('change', note);
  }, PATIENCE_MS);
}

/** Returns the properties of the model. */
export function state(page) {
  return page.evaluate(() => {
    const { model } = window.striataViewer;
    const { triangleCount, fullTriangleCount, vertexCount, error, bytesReceived, bytesTotal, complete, detail, pixelError, triangleBudget, diagonal, frozen, kind } = model;
    return { triangleCount, fullTriangleCount, vertexCount, error, bytesReceived, bytesTotal, complete, detail, pixelError, triangleBudget, diagonal, frozen, kind, timings: { ...model.timings } };
  });
}

/** Returns the number of triangles that the meshes of the model draw, from their index buffers. */
export function drawnTriangles(page) {
  return page.evaluate(() => {
    let count = 0;
    window.striataViewer.model.traverseVisible((object) => {
      if (!object.isMesh) return;
      const { drawRange, index, attributes } = object.geometry;
      count += Math.min(drawRange.count, (index ?? attributes.position).count - drawRange.start) / 3;
    });
    return count;
  });
}

/** Counts the pixels of the stage that are not background. */
export function drawnPixels(page) {
  return page.evaluate(() => {
    const { stage } = window.striataViewer;
    const gl = stage.renderer.getContext();
    stage.render();
    const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const pixels = new Uint32Array(width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(pixels.buffer));
    const background = pixels[0];
    return pixels.reduce((count, pixel) => count + (pixel === background ? 0 : 1), 0);
  });
}

/** Moves a slider as a user does. */
export async function slide(page, id, value) {
  await page.locator(`#${id}`).evaluate((slider, value) => {
    slider.value = String(value);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    slider.dispatchEvent(new Event('change', { bubbles: true }));
  }, value);
}
