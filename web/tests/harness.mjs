// What the browser tests share: models made by the command, `striata serve` over them, one Chromium with WebGL 2, pages.

import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const workspace = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const striata = process.env.STRIATA_BIN ?? join(workspace, 'target/debug/striata');

/** Machines under load are slow: what takes longer than this is stuck. */
export const PATIENCE_MS = 600_000;

/** The viewer as it is built into the command. */
export const viewerFolder = join(workspace, 'crates/striata-viewer/viewer');

/** Draws WebGL 2 without a graphics card. */
const CHROMIUM_FLAGS = [
  '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
  '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
];

/** Runs the command and gives what it printed. */
export function run(...words) {
  const ended = spawnSync(striata, words, { encoding: 'utf8', maxBuffer: 1 << 26 });
  if (ended.error) throw new Error(`cannot start ${striata}: ${ended.error.message}`);
  if (ended.status !== 0) throw new Error(`striata ${words.join(' ')} ended with ${ended.status}: ${ended.stderr}`);
  return ended.stdout;
}

/** Models that the tests look at, all made by the command. */
export function makeModels(folder) {
  const bust = join(workspace, 'crates/striata-cli/assets/nefertiti.ply.zst');
  const at = (...parts) => join(folder, ...parts);
  mkdirSync(at('sub'), { recursive: true });
  run('encode', '-q', bust, '-o', at('nefertiti.stri'), '--bits', '18');
  run('encode', '-q', 'shape:icosphere', '-o', at('icosphere.stri'));
  run('encode', '-q', 'shape:terrain', '-o', at('sub', 'terrain.stri'));
  run('build', '-q', join(workspace, 'assets/spot.obj.zst'), '-o', at('spot.striata'));
  run('convert', '-q', 'shape:torus', at('torus.obj'));
  run('convert', '-q', 'shape:tetrahedron', at('tetrahedron.obj'));
  const whole = readFileSync(at('icosphere.stri'));
  const damaged = Buffer.from(whole);
  for (let index = whole.length >> 1; index < whole.length; index += 7) damaged[index] ^= 0x5a;
  writeFileSync(at('damaged.stri'), damaged);
  writeFileSync(at('garbage.stri'), Buffer.from('this is no model, whatever its name says\n'.repeat(40)));
}

/** A temporary folder that goes when the tests end. */
export function temporaryFolder(name) {
  return mkdtempSync(join(tmpdir(), `striata-${name}-`));
}

/** `striata serve` on a free port; give it back with `stop`. */
export async function serve(folder) {
  const child = spawn(striata, ['serve', folder, '--port', '0', '--json'], { stdio: ['ignore', 'pipe', 'pipe'] });
  let talk = '';
  child.stderr.on('data', (text) => (talk += text));
  const ended = new Promise((_, reject) => {
    child.once('error', (error) => reject(new Error(`cannot start ${striata}: ${error.message}`)));
    child.once('exit', (code) => reject(new Error(`striata serve ended with ${code}: ${talk}`)));
  });
  ended.catch(() => {});
  const lines = createInterface({ input: child.stdout });
  const first = new Promise((give) => lines.once('line', give));
  const { url } = JSON.parse(await Promise.race([first, ended]));
  return { url: url.endsWith('/') ? url : `${url}/`, stop: () => stopped(child) };
}

async function stopped(child) {
  if (child.exitCode !== null) return;
  const gone = new Promise((give) => child.once('exit', give));
  child.kill('SIGTERM');
  const timer = setTimeout(() => child.kill('SIGKILL'), 5_000);
  await gone;
  clearTimeout(timer);
}

/** The browser, with a profile that is thrown away. */
export async function browser() {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  if (!existsSync(executablePath)) throw new Error(`there is no ${executablePath}; apt-get install chromium, or set CHROMIUM`);
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

/** Everything the tests need: `world.page()` gives a page, `world.url` is the server's. */
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

/** A page whose errors fail the test: nothing may be thrown or logged as an error that the test did not expect. */
async function newPage(context, { expected = [], width = 900, height = 600, scheme = 'light', still = true } = {}) {
  const page = await context.newPage();
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ colorScheme: scheme, reducedMotion: still ? 'reduce' : 'no-preference' });
  await page.addInitScript(countQuestions);
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

/** In the page: `openQuestions()` tells how many workers have been asked for a level and have not answered yet. */
function countQuestions() {
  const workers = new Map();
  window.openQuestions = () => [...workers.values()].filter(({ asked, answered }) => asked > answered).length;
  const { postMessage, terminate } = Worker.prototype;
  Worker.prototype.postMessage = function (order, ...rest) {
    if (order?.type === 'show') {
      let known = workers.get(this);
      if (!known) {
        workers.set(this, (known = { asked: 0, answered: 0 }));
        this.addEventListener('message', ({ data }) => {
          // What comes by itself, as bytes arrive, answers nothing.
          if (data.type === 'update') known.answered = Math.max(known.answered, data.ticket);
        });
      }
      known.asked = order.ticket;
    }
    return postMessage.call(this, order, ...rest);
  };
  Worker.prototype.terminate = function () {
    workers.delete(this);
    return terminate.call(this);
  };
}

/** Keeps a picture for people to look at, where STRIATA_SHOTS names a folder. */
export async function shot(page, name) {
  const folder = process.env.STRIATA_SHOTS;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`) });
}

/** Waits until the model that is shown is all there. */
export async function untilWhole(page) {
  await page.waitForFunction(() => window.striataViewer?.mesh?.complete === true);
  await page.evaluate(() => window.striataViewer.mesh.finished);
}

/** Waits until the worker has answered all that it was asked, and neither triangles nor the eye change from frame to frame. */
export async function settled(page) {
  await page.evaluate(async (patience) => {
    const frame = () => new Promise((give) => requestAnimationFrame(() => give()));
    const { stage, mesh } = window.striataViewer;
    const started = performance.now();
    let frames = 0;
    const note = () => (frames = 0);
    mesh.addEventListener('change', note);
    let last = '';
    while (frames < 12 || window.openQuestions() > 0) {
      stage.invalidate();
      await frame();
      frames += 1;
      const now = `${mesh.triangleCount} ${stage.camera.position.toArray()}`;
      if (now !== last) note();
      last = now;
      if (performance.now() - started > patience) throw new Error('the model never comes to rest');
    }
    mesh.removeEventListener('change', note);
  }, PATIENCE_MS);
}

/** What the mesh says of itself. */
export function state(page) {
  return page.evaluate(() => {
    const { mesh } = window.striataViewer;
    const { triangleCount, fullTriangleCount, vertexCount, splitCount, stepCount, error, bytesReceived, bytesTotal, complete, detail, pixelError, triangleBudget, diagonal, frozen, kind } = mesh;
    return { triangleCount, fullTriangleCount, vertexCount, splitCount, stepCount, error, bytesReceived, bytesTotal, complete, detail, pixelError, triangleBudget, diagonal, frozen, kind, timings: { ...mesh.timings } };
  });
}

/** Pixels of the stage that are not background. */
export function drawnPixels(page) {
  return page.evaluate(() => {
    const { stage } = window.striataViewer;
    const gl = stage.renderer.getContext();
    stage.renderer.render(stage.scene, stage.camera);
    const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const pixels = new Uint32Array(width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(pixels.buffer));
    const background = pixels[0];
    return pixels.reduce((count, pixel) => count + (pixel === background ? 0 : 1), 0);
  });
}

/** Moves a slider as a hand does. */
export async function slide(page, id, value) {
  await page.locator(`#${id}`).evaluate((slider, value) => {
    slider.value = String(value);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    slider.dispatchEvent(new Event('change', { bubbles: true }));
  }, value);
}
