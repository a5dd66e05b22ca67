// Tests that the viewer shows every kind of file in Firefox, which is driven by WebDriver BiDi: node --test tests/firefox.mjs
//
//   STRIATA_BIN  the command, default target/debug/striata
//   FIREFOX      the browser, default /usr/bin/firefox-esr
//
// Firefox has no WebGL without a display, so it gets one of Xvfb.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import puppeteer from 'puppeteer-core';
import { drawnPixels, makeModels, PATIENCE_MS, run, serve, state, temporaryFolder, untilWhole } from './harness.mjs';

const folder = temporaryFolder('firefox');
const at = (name) => join(folder, name);
let server;
let firefox;
let display;

/** Starts a display, and returns its name. */
async function startDisplay() {
  // The server writes the number of the display to a pipe.
  display = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1280x960x24', '+extension', 'GLX', '-nolisten', 'tcp'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  const failed = once(display, 'error').then(([error]) => Promise.reject(error));
  const [number] = await Promise.race([once(display.stdio[3], 'data'), failed]);
  return `:${String(number).trim()}`;
}

before(async () => {
  makeModels(folder);
  run('convert', '-q', at('torus.obj'), at('draco.glb'), '--draco');
  run('build', '-q', '--paged', 'shape:terrain:120', '-o', at('paged.striata'));
  writeFileSync(at('cut.striata'), readFileSync(at('arm.striata')).subarray(0, 20_000));
  server = await serve(folder);
  const DISPLAY = await startDisplay();
  firefox = await puppeteer.launch({
    browser: 'firefox', executablePath: process.env.FIREFOX ?? '/usr/bin/firefox-esr', headless: false, timeout: PATIENCE_MS, protocolTimeout: PATIENCE_MS,
    // Without a graphics card.
    extraPrefsFirefox: { 'webgl.force-enabled': true }, env: { ...process.env, DISPLAY, LIBGL_ALWAYS_SOFTWARE: '1' },
  });
}, { timeout: 2 * PATIENCE_MS });

after(async () => {
  await firefox?.close();
  display?.kill();
  await server?.stop();
  rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
});

/** Opens an address, and passes the page to a function; fails if the page throws or logs errors. */
async function withPage(address, work) {
  const page = await firefox.newPage();
  const faults = [];
  page.setDefaultTimeout(PATIENCE_MS);
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
  try {
    await page.setViewport({ width: 1000, height: 700 });
    await page.goto(`${server.url}${address}`);
    await work(page);
    assert.deepEqual(faults, []);
  } finally {
    await page.close();
  }
}

const KINDS = { 'nefertiti.stri': 'stream', 'spot.striata': 'striata', 'arm.stri': 'stream', 'arm.striata': 'striata', 'paged.striata': 'paged', 'plain-arm.glb': 'mesh', 'torus.obj': 'mesh', 'draco.glb': 'mesh' };

for (const [name, kind] of Object.entries(KINDS)) {
  test(`${name} is shown`, { timeout: 3 * PATIENCE_MS }, async () => {
    await withPage(`?model=models/${name}`, async (page) => {
      await untilWhole(page);
      const { triangleCount, fullTriangleCount, kind: found } = await state(page);
      assert.equal(found, kind);
      assert.ok(triangleCount > 0 && fullTriangleCount >= triangleCount, `${triangleCount} of ${fullTriangleCount} triangles`);
      assert.ok((await drawnPixels(page)) > 5_000, 'it is visible');
      if (name.includes('arm')) await page.waitForFunction(() => window.striataViewer.playback.duration > 0);
    });
  });
}

test('the gallery lists the models, and damaged files say why they do not open', { timeout: 3 * PATIENCE_MS }, async () => {
  await withPage('', async (page) => {
    await page.waitForFunction(() => document.querySelectorAll('#cards a').length > 5);
  });
  await withPage('?model=models/cut.striata', async (page) => {
    await page.waitForFunction(() => document.querySelector('.notice')?.innerText.includes('Cannot open cut.striata'));
  });
});
