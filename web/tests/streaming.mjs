// Tests of streaming: a model appears early, refines while it loads, is complete in the end, and survives a broken connection.

import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import { join } from 'node:path';
import { Gate } from './gate.mjs';
import { run, shot, state, untilWhole } from './harness.mjs';
import { note, openModel, pageTest } from './pages.mjs';

/** A small window, since pictures are rendered on the CPU. */
const SMALL = { width: 700, height: 500 };

/** Records in every frame what has loaded, and whether anything but background is drawn. */
function watch(page) {
  return page.evaluate(() => {
    const seen = (window.seen = []);
    const look = () => {
      const { model, stage } = window.striataViewer;
      requestAnimationFrame(look);
      if (!model || seen.at(-1)?.triangles === model.triangleCount) return;
      const gl = stage.renderer.getContext();
      stage.render();
      const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
      const pixels = new Uint32Array(width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(pixels.buffer));
      let drawn = 0;
      for (const pixel of pixels) if (pixel !== pixels[0]) drawn += 1;
      if (drawn === 0) return;
      const hasProgressBar = !document.getElementById('progress').hidden;
      seen.push({ triangles: model.triangleCount, bytes: model.bytesReceived, drawn, hasProgressBar });
    };
    look();
  });
}

/** Runs a test with its own proxy, a page that is watched, and a model opened from the gallery. */
function gatedTest(world, name, model, options, work) {
  pageTest(world, name, { ...SMALL, ...options }, async (page) => {
    const gate = await Gate.to(world.url);
    try {
      await page.goto(gate.url);
      await page.locator('#cards a').first().waitFor();
      await watch(page);
      await page.locator(`#cards a[href*="${model}"]`).click();
      await work(page, gate, statSync(join(world.folder, model)).size);
    } finally {
      gate.close();
    }
  });
}

export default function streaming(world) {
  gatedTest(world, 'a stream appears within a tenth of its bytes and refines as it loads', 'nefertiti.stri', {}, async (page, gate, total) => {
    gate.allow(Math.floor(total / 10) - 1);
    await page.waitForFunction(() => window.seen.some(({ drawn, triangles }) => drawn > 500 && triangles > 0));
    for (const tenths of [2, 3, 4, 6, 8]) {
      const before = await page.evaluate(() => window.seen.length);
      gate.allow(Math.floor((total * tenths) / 10));
      await page.waitForFunction((before) => window.seen.length > before, before);
      if (tenths === 2) await shot(page, 'loading');
    }
    assert.equal((await state(page)).complete, false);
    gate.allow(total);
    await untilWhole(page);
    await page.waitForFunction(() => window.seen.at(-1)?.triangles === window.striataViewer.model.triangleCount);
    const seen = await page.evaluate(() => window.seen);
    assert.ok(seen[0].bytes < total / 10, `the first picture was drawn at byte ${seen[0].bytes} of ${total}`);
    assert.ok(seen.slice(0, -2).every(({ hasProgressBar }) => hasProgressBar), 'a progress bar is shown while loading');
    for (const [index, now] of seen.entries()) {
      if (index > 0) assert.ok(now.triangles > seen[index - 1].triangles, 'each picture has more triangles than the last');
    }
    const file = join(world.folder, 'nefertiti.stri');
    const { triangle_count: expected } = JSON.parse(run('decode', file, '-o', join(world.folder, 'whole.ply'), '--json'));
    const now = await state(page);
    assert.equal(now.triangleCount, expected, 'all triangles are shown in the end');
    assert.equal(now.fullTriangleCount, expected);
    assert.equal(now.bytesReceived, total);
    await page.locator('#progress').waitFor({ state: 'hidden' });
    const steps = seen.map(({ triangles, bytes }) => `${triangles} (${((100 * bytes) / total).toFixed(0)} %)`);
    note(`triangles while ${total} bytes load: ${steps.join(', ')}`);
  });

  gatedTest(world, 'a camera moved by the user stays while the model refines', 'sub/terrain.stri', {}, async (page, gate, total) => {
    gate.allow(total / 10);
    await page.waitForFunction(() => window.seen.length > 0);
    await page.locator('#view').press('ArrowRight');
    const eye = () => page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
    const before = await eye();
    gate.allow(total);
    await untilWhole(page);
    const after = await eye();
    // The controls convert to angles and back, so the last digits may change.
    const moved = Math.hypot(...after.map((x, axis) => x - before[axis]));
    assert.ok(moved < 1e-9 * Math.hypot(...before), `the camera moved by ${moved}`);
  });

  const expected = [/Failed to load resource|ERR_/];
  gatedTest(world, 'a broken connection keeps the loaded part and can be retried', 'nefertiti.stri', { expected }, async (page, gate, total) => {
    gate.allow(total / 4);
    await page.waitForFunction(() => window.seen.length > 0);
    gate.cut();
    const notice = page.locator('.notice');
    await notice.waitFor();
    assert.match(await notice.innerText(), /Could not load all of nefertiti\.stri[^]*The loaded part is still shown: [\d,]+ of/);
    const cut = await state(page);
    assert.ok(cut.triangleCount > 0 && !cut.complete, 'the loaded part is shown');
    assert.ok(cut.triangleCount < cut.fullTriangleCount);
    await shot(page, 'broken-line');
    gate.allow(3 * total);
    await notice.locator('.retry').click();
    await page.waitForFunction(() => window.striataViewer.model.complete);
    await untilWhole(page);
    assert.equal((await state(page)).triangleCount, cut.fullTriangleCount, 'the retry loads everything');
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
