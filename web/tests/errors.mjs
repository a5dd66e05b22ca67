// Tests of error reporting: every failure is explained, and the page keeps working.

import assert from 'node:assert/strict';
import { EventEmitter, once } from 'node:events';
import { readFileSync } from 'node:fs';
import { createServer, request } from 'node:http';
import { join } from 'node:path';
import { drop } from './files.mjs';
import { drawnPixels, shot, slide, state, untilWhole } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

/** Text of the newest notice. */
async function noticeText(page) {
  await page.locator('.notice').first().waitFor();
  return page.locator('.notice').first().innerText();
}

export default function errors(world) {
  pageTest(world, 'a damaged stream is reported, and another model opens afterwards', {}, async (page) => {
    await page.goto(`${world.url}?model=models/damaged.stri`);
    const text = await noticeText(page);
    assert.match(text, /damaged\.stri/);
    assert.ok(text.length > 40, `a sentence: ${text}`);
    assert.doesNotMatch(text, /undefined|\[object|unreachable|RuntimeError|panicked/);
    await shot(page, 'damaged');
    await drop(page, 'icosphere.stri', readFileSync(join(world.folder, 'icosphere.stri')));
    await page.waitForFunction(() => window.striataViewer.model?.complete);
    await untilWhole(page);
    assert.equal((await state(page)).triangleCount, 20_480);
    assert.equal(await page.locator('.notice').count(), 0, 'the notice is gone');
  });

  pageTest(world, 'a file that is not a model leaves the current one in place', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    for (const name of ['garbage.stri', 'notes.xyz']) {
      await drop(page, name, readFileSync(join(world.folder, 'garbage.stri')));
      const text = await noticeText(page);
      assert.match(text, new RegExp(`Cannot open ${name.replace('.', '\\.')}`));
      assert.doesNotMatch(text, /undefined|\[object|unreachable|RuntimeError|panicked/);
      assert.equal((await state(page)).triangleCount, 20_480, 'the model is still shown');
      assert.equal(await page.locator('#title').innerText(), 'icosphere.stri');
      if (name === 'garbage.stri') await shot(page, 'error');
      await page.locator('.notice .dismiss').first().click();
      assert.equal(await page.locator('.notice').count(), 0);
    }
    assert.ok((await drawnPixels(page)) > 10_000);
    await slide(page, 'detail', 0);
    await page.waitForFunction(() => window.striataViewer.model.triangleCount < 100);
  });

  pageTest(world, 'models of very different sizes fill the view equally', {}, async (page) => {
    const triangle = (size) => Buffer.from(`v 0 0 0\nv ${size} 0 0\nv 0 ${size} 0\nf 1 2 3\n`);
    const pixels = [];
    await page.goto(world.url);
    for (const [name, size] of [['large.obj', 1e6], ['small.obj', 1], ['again.obj', 1e6]]) {
      await drop(page, name, triangle(size));
      await page.waitForFunction((name) => window.striataViewer.model && window.striataViewer.name === name, name);
      await untilWhole(page);
      pixels.push(await drawnPixels(page));
    }
    assert.ok(pixels.every((count) => count > 1_000 && Math.abs(count - pixels[0]) < 0.05 * pixels[0]), String(pixels));
  });

  pageTest(world, 'slow thumbnails do not delay opening a model', {}, async (page) => {
    const pending = [];
    const requests = new EventEmitter();
    const untilPending = async (count) => {
      while (pending.length < count) await once(requests, 'picture');
    };
    const proxy = createServer((incoming, outgoing) => {
      // There are more thumbnails than connections that a browser opens to one server.
      if (incoming.url.startsWith('/pictures/')) {
        pending.push(outgoing);
        return requests.emit('picture');
      }
      const { hostname, port } = new URL(world.url);
      const headers = { ...incoming.headers, host: `${hostname}:${port}` };
      const onward = request({ hostname, port, path: incoming.url, headers }, (response) => {
        outgoing.writeHead(response.statusCode, response.headers);
        response.pipe(outgoing);
      });
      onward.on('error', () => outgoing.destroy());
      onward.end();
    }).listen(0, '127.0.0.1');
    try {
      await new Promise((resolve) => proxy.once('listening', resolve));
      await page.goto(`http://127.0.0.1:${proxy.address().port}/`);
      await page.waitForFunction(() => document.querySelectorAll('#cards .waiting').length > 5);
      await untilPending(6);
      await page.locator('#cards a[href*="icosphere"]').click();
      await untilWhole(page);
      // No thumbnail is requested while a model is open; back in the gallery requests resume immediately, perhaps before the click returns.
      const before = pending.length;
      await page.locator('#to-gallery').click();
      await untilPending(before + 1);
    } finally {
      proxy.close();
      proxy.closeAllConnections();
    }
  });

  const missing = [/404|Failed to load resource/];
  pageTest(world, 'a missing model is reported', { expected: missing }, async (page) => {
    await page.goto(`${world.url}?model=models/nowhere.stri`);
    const text = await noticeText(page);
    assert.match(text, /Cannot open nowhere\.stri/);
    assert.match(text, /404|not (there|found)|no such/i);
    await page.locator('#cards a').first().waitFor();
    await page.locator('#cards a[href*="icosphere"]').click();
    await untilWhole(page);
    assert.equal((await state(page)).triangleCount, 20_480, 'the page still works');
  });

  const closed = [/CORS|Failed to load resource|ERR_FAILED|Content Security Policy|violates/];
  pageTest(world, 'a server without CORS is reported', { expected: closed }, async (page) => {
    const other = createServer((_, response) => response.end('x')).listen(0, '127.0.0.1');
    try {
      await new Promise((resolve) => other.once('listening', resolve));
      const url = `http://127.0.0.1:${other.address().port}/far.stri`;
      await page.goto(`${world.url}?model=${encodeURIComponent(url)}`);
      assert.match(await noticeText(page), /Cannot open far\.stri[^]*another server/);
    } finally {
      other.close();
      other.closeAllConnections();
    }
  });

  pageTest(world, 'a browser without WebGL is reported', { expected: [/WebGL/] }, async (page) => {
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto(world.url);
    assert.match(await noticeText(page), /cannot show 3D graphics[^]*WebGL/);
    await shot(page, 'no-webgl');
  });
}
