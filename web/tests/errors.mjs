// What goes wrong is said in words, and the page lives on.

import assert from 'node:assert/strict';
import { EventEmitter, once } from 'node:events';
import { readFileSync } from 'node:fs';
import { createServer, request } from 'node:http';
import { join } from 'node:path';
import { drop } from './files.mjs';
import { drawnPixels, shot, slide, state, untilWhole } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

/** The newest notice's text. */
async function noticeText(page) {
  await page.locator('.notice').first().waitFor();
  return page.locator('.notice').first().innerText();
}

export default function errors(world) {
  pageTest(world, 'a damaged stream is told, and a good one opens after it', {}, async (page) => {
    await page.goto(`${world.url}?model=models/damaged.stri`);
    const text = await noticeText(page);
    assert.match(text, /damaged\.stri/);
    assert.ok(text.length > 40, `a sentence: ${text}`);
    assert.doesNotMatch(text, /undefined|\[object|unreachable|RuntimeError|panicked/);
    await shot(page, 'damaged');
    await drop(page, 'icosphere.stri', readFileSync(join(world.folder, 'icosphere.stri')));
    await page.waitForFunction(() => window.striataViewer.mesh?.complete);
    await untilWhole(page);
    assert.equal((await state(page)).triangleCount, 20_480);
    assert.equal(await page.locator('.notice').count(), 0, 'the message went');
  });

  pageTest(world, 'a file that is no model leaves the one that is shown', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    for (const name of ['garbage.stri', 'notes.xyz']) {
      await drop(page, name, readFileSync(join(world.folder, 'garbage.stri')));
      const text = await noticeText(page);
      assert.match(text, new RegExp(`Cannot open ${name.replace('.', '\\.')}`));
      assert.doesNotMatch(text, /undefined|\[object|unreachable|RuntimeError|panicked/);
      assert.equal((await state(page)).triangleCount, 20_480, 'the model is still there');
      assert.equal(await page.locator('#title').innerText(), 'icosphere.stri');
      if (name === 'garbage.stri') await shot(page, 'error');
      await page.locator('.notice .dismiss').first().click();
      assert.equal(await page.locator('.notice').count(), 0);
    }
    assert.ok((await drawnPixels(page)) > 10_000);
    await slide(page, 'detail', 0);
    await page.waitForFunction(() => window.striataViewer.mesh.triangleCount < 100);
  });

  pageTest(world, 'a small model after a large one is as near', {}, async (page) => {
    const triangle = (size) => Buffer.from(`v 0 0 0\nv ${size} 0 0\nv 0 ${size} 0\nf 1 2 3\n`);
    const pixels = [];
    await page.goto(world.url);
    for (const [name, size] of [['large.obj', 1e6], ['small.obj', 1], ['again.obj', 1e6]]) {
      await drop(page, name, triangle(size));
      await page.waitForFunction((name) => window.striataViewer.mesh && window.striataViewer.name === name, name);
      await untilWhole(page);
      pixels.push(await drawnPixels(page));
    }
    assert.ok(pixels.every((count) => count > 1_000 && Math.abs(count - pixels[0]) < 0.05 * pixels[0]), String(pixels));
  });

  pageTest(world, 'pictures that take long keep no model waiting', {}, async (page) => {
    const held = [];
    const asked = new EventEmitter();
    const heldAtLeast = async (count) => {
      while (held.length < count) await once(asked, 'picture');
    };
    const line = createServer((question, answer) => {
      // More of them than the connections that a browser has to one server.
      if (question.url.startsWith('/pictures/')) {
        held.push(answer);
        return asked.emit('picture');
      }
      const { hostname, port } = new URL(world.url);
      const headers = { ...question.headers, host: `${hostname}:${port}` };
      const onward = request({ hostname, port, path: question.url, headers }, (response) => {
        answer.writeHead(response.statusCode, response.headers);
        response.pipe(answer);
      });
      onward.on('error', () => answer.destroy());
      onward.end();
    }).listen(0, '127.0.0.1');
    try {
      await new Promise((give) => line.once('listening', give));
      await page.goto(`http://127.0.0.1:${line.address().port}/`);
      await page.waitForFunction(() => document.querySelectorAll('#cards img').length > 5);
      await heldAtLeast(6);
      await page.locator('#cards a[href*="icosphere"]').click();
      await untilWhole(page);
      // None is asked for while a model is open; back in the gallery the browser asks at once, maybe before the click returns.
      const before = held.length;
      await page.locator('#to-gallery').click();
      await heldAtLeast(before + 1);
    } finally {
      line.close();
      line.closeAllConnections();
    }
  });

  const missing = [/404|Failed to load resource/];
  pageTest(world, 'a model that is not there is told', { expected: missing }, async (page) => {
    await page.goto(`${world.url}?model=models/nowhere.stri`);
    const text = await noticeText(page);
    assert.match(text, /Cannot open nowhere\.stri/);
    assert.match(text, /404|not (there|found)|no such/i);
    await page.locator('#cards a').first().waitFor();
    await page.locator('#cards a[href*="icosphere"]').click();
    await untilWhole(page);
    assert.equal((await state(page)).triangleCount, 20_480, 'the page lives on');
  });

  const closed = [/CORS|Failed to load resource|ERR_FAILED|Content Security Policy|violates/];
  pageTest(world, 'a server that does not allow it is told', { expected: closed }, async (page) => {
    const other = createServer((_, response) => response.end('x')).listen(0, '127.0.0.1');
    try {
      await new Promise((give) => other.once('listening', give));
      const url = `http://127.0.0.1:${other.address().port}/far.stri`;
      await page.goto(`${world.url}?model=${encodeURIComponent(url)}`);
      assert.match(await noticeText(page), /Cannot open far\.stri[^]*another server/);
    } finally {
      other.close();
      other.closeAllConnections();
    }
  });

  pageTest(world, 'a browser without WebGL is told', { expected: [/WebGL/] }, async (page) => {
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto(world.url);
    assert.match(await noticeText(page), /shows no 3D[^]*WebGL/);
    await shot(page, 'no-webgl');
  });
}
