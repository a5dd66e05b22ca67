// What goes wrong is said in words, and the page lives on.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { drop } from './files.mjs';
import { drawnPixels, shot, state, untilWhole } from './harness.mjs';
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
