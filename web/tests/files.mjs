// Tests of local files: dropped, chosen, and embedded in the page.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { assemble } from './assemble.mjs';
import { drawnPixels, settled, shot, slide, state, untilWhole } from './harness.mjs';
import { note, openModel, pageTest } from './pages.mjs';

/** Drops a file on the page, as from a file manager. */
export async function drop(page, name, content) {
  const transfer = await page.evaluateHandle(([name, base64]) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const transfer = new DataTransfer();
    transfer.items.add(new File([bytes], name));
    return transfer;
  }, [name, content.toString('base64')]);
  await page.dispatchEvent('#stage', 'dragenter', { dataTransfer: transfer });
  await page.dispatchEvent('#stage', 'dragover', { dataTransfer: transfer });
  await page.locator('#drop').waitFor({ state: 'visible' });
  await page.dispatchEvent('#stage', 'drop', { dataTransfer: transfer });
  await page.locator('#drop').waitFor({ state: 'hidden' });
}

export default function files(world) {
  pageTest(world, 'a dropped OBJ is simplified in the browser', {}, async (page) => {
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    const obj = readFileSync(join(world.folder, 'torus.obj'));
    const triangles = obj.toString().match(/^f /gm).length;
    await drop(page, 'torus.obj', obj);
    await untilWhole(page);
    const now = await state(page);
    assert.equal(now.kind, 'mesh');
    assert.equal(now.triangleCount, triangles, 'all triangles are shown');
    assert.equal(await page.locator('#title').innerText(), 'torus.obj');
    assert.ok((await drawnPixels(page)) > 10_000, 'the model is visible');
    await slide(page, 'detail', 500);
    await settled(page);
    const less = await state(page);
    assert.ok(less.triangleCount < triangles / 4 && less.triangleCount > triangles / 16, 'its detail can be changed');
    note(`built in the browser: ${triangles} triangles in ${now.timings.buildMs.toFixed(0)} ms`);
  });

  pageTest(world, 'files can be opened one after the other', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    await page.locator('#file').setInputFiles(join(world.folder, 'tetrahedron.obj'));
    await page.waitForFunction(() => window.striataViewer.model?.fullTriangleCount === 4);
    await untilWhole(page);
    assert.equal(await page.locator('#title').innerText(), 'tetrahedron.obj');
    assert.equal(new URL(page.url()).search, '', 'the address no longer names a model');
    await page.locator('#file').setInputFiles(join(world.folder, 'spot.striata'));
    await page.waitForFunction(() => window.striataViewer.model?.fullTriangleCount > 4);
    await untilWhole(page);
    assert.equal((await state(page)).kind, 'striata');
  });

  pageTest(world, 'a file of a scene, which has no stream, is encoded in the browser', {}, async (page) => {
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    await drop(page, 'arm.striata', readFileSync(join(world.folder, 'arm.striata')));
    await untilWhole(page);
    await page.waitForFunction(() => window.striataViewer.playback.isAvailable);
    assert.equal(await page.locator('#title').innerText(), 'arm.striata');
    assert.ok((await drawnPixels(page)) > 10_000, 'the model is visible');
  });

  pageTest(world, 'a self-contained page works without a server', {}, async (page) => {
    const out = join(world.folder, 'viewer.html');
    writeFileSync(out, assemble(readFileSync(join(world.folder, 'icosphere.stri')), 'icosphere.stri'));
    const requestedUrls = [];
    page.on('request', (request) => requestedUrls.push(request.url()));
    await page.goto(pathToFileURL(out).href);
    await untilWhole(page);
    assert.equal((await state(page)).triangleCount, 20_480);
    assert.ok((await drawnPixels(page)) > 10_000, 'the model is visible');
    await page.keyboard.press('v');
    await slide(page, 'pixels', 800);
    await settled(page);
    assert.ok((await state(page)).triangleCount < 20_480, 'view-dependent refinement works');
    const outside = requestedUrls.filter((url) => !/^(data|blob):/.test(url) && url !== pathToFileURL(out).href);
    assert.deepEqual(outside, [], 'nothing else is requested');
    await shot(page, 'one-file');
  });
}
