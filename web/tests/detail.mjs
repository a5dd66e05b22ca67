// Detail by hand: the slider, a typed number of triangles, keys.

import assert from 'node:assert/strict';
import { settled, shot, slide, state } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

/** Digits of a text, as a number. */
const number = (text) => Number(text.replaceAll(',', '').match(/[\d.]+(e[-+]?\d+)?/)?.[0] ?? Number.NaN);

export default function detail(world) {
  pageTest(world, 'the slider shows the detail it says', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    const full = await state(page);
    let last = { triangleCount: -1, error: Number.POSITIVE_INFINITY };
    for (const position of [0, 200, 400, 600, 800, 1000]) {
      await slide(page, 'detail', position);
      await settled(page);
      const now = await state(page);
      const asked = (position / 1000) ** 3;
      assert.ok(Math.abs(now.splitCount - asked * full.stepCount) <= 1, `${now.splitCount} splits at detail ${asked}`);
      assert.ok(now.triangleCount > last.triangleCount, 'more detail, more triangles');
      assert.ok(now.error <= last.error, `error ${now.error} after ${last.error}`);
      const shown = await page.evaluate(() => {
        const { geometry } = window.striataViewer.mesh;
        return Math.min(geometry.drawRange.count, geometry.index.count) / 3;
      });
      assert.equal(shown, now.triangleCount, 'what is drawn is what is said');
      assert.equal(number(await page.locator('#triangles').innerText()), now.triangleCount);
      last = now;
    }
    assert.equal(last.triangleCount, full.fullTriangleCount);
    assert.equal(last.error <= full.error, true);
    await slide(page, 'detail', 430);
    await settled(page);
    await page.locator('#wireframe').check();
    await shot(page, 'wireframe');
  });

  pageTest(world, 'a typed number of triangles is kept as a limit', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    const { fullTriangleCount: full } = await state(page);
    await page.locator('input[name="mode"][value="budget"]').check({ force: true });
    const typed = page.locator('#budget-typed');
    for (const limit of [5000, 777, 60]) {
      await typed.fill(String(limit));
      await typed.press('Enter');
      await settled(page);
      const { triangleCount } = await state(page);
      assert.ok(triangleCount <= limit && triangleCount > limit * 0.9 - 8, `${triangleCount} triangles of at most ${limit}`);
      assert.equal(number(await page.locator('#triangles').innerText()), triangleCount);
    }
    await typed.fill('999999999');
    await typed.press('Enter');
    await settled(page);
    assert.equal((await state(page)).triangleCount, full, 'more than there are is all of them');
    await typed.fill('');
    await typed.press('Enter');
    assert.equal(await typed.inputValue(), String(full), 'nothing typed is no limit');
    await slide(page, 'budget', 500);
    await settled(page);
    const asked = Number(await typed.inputValue());
    assert.ok(asked < full && (await state(page)).triangleCount <= asked, 'the slider sets the number');
  });

  pageTest(world, 'everything is done by keys too', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    const view = page.locator('#view');
    await view.focus();
    const eye = () => page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
    const distance = (from, to) => Math.hypot(...from.map((x, axis) => x - to[axis]));
    // The first look frames what had come by then, R frames all of it.
    await page.keyboard.press('r');
    await settled(page);
    const start = await eye();
    await page.keyboard.press('ArrowRight');
    const turned = await eye();
    assert.ok(distance(start, turned) > 0.01, 'an arrow turns');
    await page.keyboard.press('+');
    assert.ok(Math.hypot(...(await eye())) < Math.hypot(...turned) * 0.95, '+ goes nearer');
    await page.keyboard.press('r');
    await settled(page);
    assert.ok(distance(await eye(), start) < 1e-3, 'R goes back');
    const full = await state(page);
    await page.keyboard.press('[');
    await settled(page);
    assert.ok((await state(page)).triangleCount < full.triangleCount, '[ takes detail away');
    await page.keyboard.press(']');
    await settled(page);
    assert.equal((await state(page)).triangleCount, full.triangleCount, '] brings it back');
    await page.keyboard.press('w');
    assert.equal(await page.evaluate(() => window.striataViewer.mesh.children.some((child) => child.visible && child.material.wireframe)), true);
    await page.keyboard.press('w');
    await page.keyboard.press('s');
    assert.equal(await page.evaluate(() => window.striataViewer.mesh.coloring), 'strips');
    await page.keyboard.press('v');
    await settled(page);
    assert.notEqual((await state(page)).pixelError, null, 'V chooses pixels');
    await page.keyboard.press('f');
    assert.equal((await state(page)).frozen, true);
    await page.keyboard.press('f');
    await page.keyboard.press('v');
    assert.equal((await state(page)).pixelError, null);
    await page.keyboard.press('?');
    await page.locator('#help[open]').waitFor();
    await shot(page, 'help');
    await page.keyboard.press('Escape');
    assert.equal(await page.locator('#help[open]').count(), 0);
  });
}
