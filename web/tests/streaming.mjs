// A model over a slow line: seen early, refined while it comes, whole in the end; and a line that breaks.

import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import { join } from 'node:path';
import { run, shot, state, untilWhole } from './harness.mjs';
import { note, openModel, pageTest } from './pages.mjs';

/** Bytes a second; the model takes some seconds over it. */
const SLOW = 60_000;

/** Lets so many bytes through a second; 0 is no limit. */
async function line(page, bytesPerSecond, offline = false) {
  page.wire ??= await page.context().newCDPSession(page);
  await page.wire.send('Network.enable');
  const downloadThroughput = bytesPerSecond > 0 ? bytesPerSecond : -1;
  await page.wire.send('Network.emulateNetworkConditions', { offline, latency: 0, downloadThroughput, uploadThroughput: -1 });
}

/** Watches every frame: what has come, and whether anything but background is drawn. */
function watch(page) {
  return page.evaluate(() => {
    const seen = (window.seen = []);
    const look = () => {
      const { mesh, stage } = window.striataViewer;
      requestAnimationFrame(look);
      if (!mesh || seen.at(-1)?.triangles === mesh.triangleCount) return;
      const gl = stage.renderer.getContext();
      stage.renderer.render(stage.scene, stage.camera);
      const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
      const pixels = new Uint32Array(width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(pixels.buffer));
      let drawn = 0;
      for (const pixel of pixels) if (pixel !== pixels[0]) drawn += 1;
      const box = stage.camera.position.toArray();
      seen.push({ triangles: mesh.triangleCount, bytes: mesh.bytesReceived, drawn, share: drawn / pixels.length, camera: box });
    };
    look();
  });
}

/** A page that is ready, on a slow line, and then asked for a model as a click in the gallery would. */
async function openSlowly(world, page, name) {
  await page.goto(world.url);
  await page.locator('#cards a').first().waitFor();
  await line(page, SLOW);
  await watch(page);
  await page.locator(`#cards a[href*="${name}"]`).click();
}

export default function streaming(world) {
  pageTest(world, 'a stream over a slow line is seen before a tenth of its bytes, and refines', {}, async (page) => {
    const file = join(world.folder, 'nefertiti.stri');
    const total = statSync(file).size;
    await openSlowly(world, page, 'nefertiti.stri');
    await page.waitForFunction((half) => window.striataViewer.mesh?.bytesReceived > half, total * 0.4);
    await shot(page, 'loading');
    assert.equal(await page.locator('#progress').isVisible(), true, 'a line shows how far loading has come');
    await untilWhole(page);
    await page.waitForFunction(() => window.seen.at(-1)?.triangles === window.striataViewer.mesh.triangleCount);
    const seen = await page.evaluate(() => window.seen);
    const first = seen.find(({ drawn, triangles }) => drawn > 500 && triangles > 0);
    assert.ok(first, 'something was drawn');
    assert.ok(first.bytes < total / 10, `the first picture came with byte ${first.bytes} of ${total}`);
    assert.ok(seen.length >= 6, `it refined in ${seen.length} pictures`);
    for (const [index, now] of seen.entries()) {
      if (index > 0) assert.ok(now.triangles > seen[index - 1].triangles, 'each picture has more triangles than the last');
    }
    const { triangle_count: expected } = JSON.parse(run('decode', file, '-o', join(world.folder, 'whole.ply'), '--json'));
    const now = await state(page);
    assert.equal(now.triangleCount, expected, 'all triangles in the end');
    assert.equal(now.fullTriangleCount, expected);
    assert.equal(now.bytesReceived, total);
    await page.locator('#progress').waitFor({ state: 'hidden' });
    note(`first picture with ${first.bytes} of ${total} bytes (${((100 * first.bytes) / total).toFixed(1)} %), ${first.triangles} triangles; ${seen.length} pictures on the way`);
  });

  pageTest(world, 'the camera keeps still while a model refines', {}, async (page) => {
    await openSlowly(world, page, 'terrain.stri');
    await page.waitForFunction(() => window.seen.length > 0);
    await line(page, 0);
    await page.locator('#view').press('ArrowRight');
    const before = await page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
    await untilWhole(page);
    const after = await page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
    assert.deepEqual(after, before, 'a camera that was taken hold of stays');
  });

  const expected = [/ERR_INTERNET_DISCONNECTED|Failed to load resource/];
  pageTest(world, 'a line that breaks leaves what came, and can be tried again', { expected }, async (page) => {
    await openSlowly(world, page, 'nefertiti.stri');
    await page.waitForFunction(() => window.striataViewer.mesh?.bytesReceived > 20_000);
    await line(page, SLOW, true);
    const notice = page.locator('.notice');
    await notice.waitFor();
    assert.match(await notice.innerText(), /nefertiti\.stri did not come in whole[^]*What came is kept: [\d,]+ of/);
    const cut = await state(page);
    assert.ok(cut.triangleCount > 0 && !cut.complete, 'what came is there');
    assert.ok(cut.triangleCount < cut.fullTriangleCount);
    await shot(page, 'broken-line');
    await line(page, 0);
    await notice.locator('.retry').click();
    await untilWhole(page);
    assert.equal((await state(page)).triangleCount, cut.fullTriangleCount, 'the second try brings all of it');
    assert.equal(await notice.count(), 0);
  });

  pageTest(world, 'a .striata file streams too', {}, async (page) => {
    await openModel(world, page, 'spot.striata');
    const now = await state(page);
    assert.equal(now.kind, 'striata');
    assert.equal(now.triangleCount, now.fullTriangleCount);
    await shot(page, 'spot');
  });
}
