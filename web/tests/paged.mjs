// Tests of paged files in the viewer: served, in folders, dropped; views, moves of the camera, errors.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { drop } from './files.mjs';
import { drawnPixels, drawnTriangles, run, shot, slide, state } from './harness.mjs';
import { note, pageTest } from './pages.mjs';

const SIDE = 400;
const TRIANGLES = 2 * (SIDE - 1) ** 2;

/** Waits until the level that was asked for is shown. */
async function complete(page) {
  await page.waitForFunction(() => window.striataViewer?.model?.complete === true);
}

/** Number of edges of the shown triangles that have no neighbor, other than those between vertices at the border of the terrain. */
function cracks(page) {
  return page.evaluate(() => {
    let open = 0;
    window.striataViewer.model.traverse(({ geometry }) => {
      if (!geometry?.index) return;
      const positions = geometry.getAttribute('position');
      const { start, count } = geometry.drawRange;
      const sides = new Map();
      const key = (v) => [0, 1, 2].map((i) => positions.getComponent(v, i)).join(' ');
      for (let at = start; at < start + count; at += 3) {
        const corners = [0, 1, 2].map((i) => geometry.index.getX(at + i));
        for (let i = 0; i < 3; i += 1) {
          const [a, b] = [corners[i], corners[(i + 1) % 3]];
          const side = [key(a), key(b)].sort().join(' ');
          sides.set(side, { count: (sides.get(side)?.count ?? 0) + 1, a, b });
        }
      }
      const { min, max } = geometry.boundingBox;
      const isAtBorder = (v, axis) => [min, max].some((box) => Math.abs(positions.getComponent(v, axis) - box.getComponent(axis)) < 1e-6);
      // Of a coarse level, an edge may cut off a corner of the terrain.
      const isOutside = (v) => [0, 1, 2].some((axis) => isAtBorder(v, axis));
      for (const { count, a, b } of sides.values()) if (count === 1 && !(isOutside(a) && isOutside(b))) open += 1;
    });
    return open;
  });
}

export default function paged(world) {
  const make = () => run('build', '-q', `shape:terrain:${SIDE}`, '--paged', '-o', join(world.folder, 'pages.striata'));

  pageTest(world, 'a paged file is refined for the camera, and only what that needs is read', {}, async (page) => {
    make();
    const bytes = readFileSync(join(world.folder, 'pages.striata')).length;
    const ranges = [];
    page.on('response', (response) => response.url().includes('models/pages.striata') && !response.url().includes('?') && ranges.push(response.status()));
    await page.goto(`${world.url}?model=models/pages.striata`);
    await complete(page);
    await page.waitForFunction(() => window.striataViewer.model.triangleCount > 1000);
    await complete(page);
    const first = await state(page);
    assert.equal(first.kind, 'paged');
    assert.equal(first.fullTriangleCount, TRIANGLES);
    assert.equal(first.pixelError, 1, 'views are the default');
    assert.ok(first.triangleCount < TRIANGLES / 2, `${first.triangleCount} triangles`);
    assert.ok(first.bytesReceived < bytes, 'not everything is read');
    assert.ok(ranges.every((status) => status === 206), `answers: ${ranges}`);
    assert.ok((await drawnPixels(page)) > 20_000, 'the terrain is visible');
    assert.equal(await cracks(page), 0);
    await shot(page, 'paged');
    await slide(page, 'pixels', 900);
    await page.waitForFunction((before) => window.striataViewer.model.triangleCount < before / 2, first.triangleCount);
    await slide(page, 'pixels', 0);
    await page.waitForFunction((before) => window.striataViewer.model.triangleCount > before, first.triangleCount);
    await complete(page);
    assert.equal(await cracks(page), 0, 'no crack at a finer level');
    note(`paged: ${first.triangleCount} of ${TRIANGLES} triangles at 1 px, ${first.bytesReceived} of ${bytes} bytes`);
  });

  pageTest(world, 'a paged file shows levels by detail and by number of triangles', {}, async (page) => {
    make();
    await page.goto(`${world.url}?model=models/pages.striata`);
    await complete(page);
    await page.locator('input[name="mode"][value="budget"]').check({ force: true });
    await page.locator('#budget-typed').fill('5000');
    await page.locator('#budget-typed').press('Enter');
    await page.waitForFunction(() => window.striataViewer.model.triangleCount > 4000 && window.striataViewer.model.triangleCount <= 5000);
    await complete(page);
    await page.locator('input[name="mode"][value="level"]').check({ force: true });
    await slide(page, 'detail', 1000);
    await page.waitForFunction((all) => window.striataViewer.model.triangleCount === all, TRIANGLES);
    await complete(page);
    assert.equal(await drawnTriangles(page), TRIANGLES);
    assert.equal(await cracks(page), 0);
  });

  pageTest(world, 'a dropped paged file and a folder of pages open', {}, async (page) => {
    make();
    run('build', '-q', `shape:terrain:${SIDE / 4}`, '--paged', '-o', join(world.folder, 'folder/'));
    await page.goto(world.url);
    await drop(page, 'dropped.striata', readFileSync(join(world.folder, 'pages.striata')));
    await page.waitForFunction(() => window.striataViewer.model?.triangleCount > 1000);
    await complete(page);
    await page.goto(`${world.url}?model=models/folder/head.striata`);
    await page.waitForFunction(() => window.striataViewer?.model?.triangleCount > 100);
    await complete(page);
    assert.equal((await state(page)).kind, 'paged');
  });

  pageTest(world, 'a damaged page is reported, and what was read before stays', {}, async (page) => {
    make();
    const bytes = readFileSync(join(world.folder, 'pages.striata'));
    for (let at = Math.floor(bytes.length * 0.6); at < bytes.length; at += 97) bytes[at] ^= 0x55;
    writeFileSync(join(world.folder, 'bad-pages.striata'), bytes);
    await page.goto(`${world.url}?model=models/bad-pages.striata`);
    await page.waitForFunction(() => window.striataViewer?.model?.triangleCount > 0);
    await slide(page, 'pixels', 0);
    await page.locator('.notice').first().waitFor();
    assert.match(await page.locator('.notice').first().innerText(), /bad-pages\.striata[^]*page of level \d+, cell \d+/i);
    assert.ok((await drawnPixels(page)) > 1_000, 'the coarse level is still shown');
  });
}
