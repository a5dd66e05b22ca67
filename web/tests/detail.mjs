// Tests of the detail controls: the slider, a typed triangle budget, keys.

import assert from 'node:assert/strict';
import { drawnTriangles, settled, shot, slide, state } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

/** Parses the first number in a text. */
const number = (text) => Number(text.replaceAll(',', '').match(/[\d.]+(e[-+]?\d+)?/)?.[0] ?? Number.NaN);

export default function detail(world) {
  pageTest(world, 'the detail slider selects the level it displays', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    const full = await state(page);
    await slide(page, 'detail', 0);
    await settled(page);
    const { triangleCount: base } = await state(page);
    let last = { triangleCount: -1, error: Number.POSITIVE_INFINITY };
    for (const position of [0, 200, 400, 600, 800, 1000]) {
      await slide(page, 'detail', position);
      await settled(page);
      const now = await state(page);
      const requested = (position / 1000) ** 3;
      // Every vertex split of a sphere adds two triangles, starting from a small base.
      const expected = base + requested * (full.fullTriangleCount - base);
      assert.ok(Math.abs(now.triangleCount - expected) <= 2, `${now.triangleCount} triangles at detail ${requested}`);
      assert.ok(now.triangleCount > last.triangleCount, 'more detail gives more triangles');
      assert.ok(now.error <= last.error, `error ${now.error} after ${last.error}`);
      assert.equal(await drawnTriangles(page), now.triangleCount, 'the displayed count matches the drawn triangles');
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

  pageTest(world, 'a typed triangle budget is respected', {}, async (page) => {
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
    assert.equal((await state(page)).triangleCount, full, 'a budget above the full count shows all triangles');
    await typed.fill('');
    await typed.press('Enter');
    assert.equal(await typed.inputValue(), String(full), 'an empty budget means no limit');
    await slide(page, 'budget', 500);
    await settled(page);
    const requested = Number(await typed.inputValue());
    assert.ok(requested < full && (await state(page)).triangleCount <= requested, 'the slider sets the budget');
  });

  pageTest(world, 'every control has a working shortcut', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    const view = page.locator('#view');
    await view.focus();
    const eye = () => page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
    const distance = (from, to) => Math.hypot(...from.map((x, axis) => x - to[axis]));
    // The initial view frames what had loaded by then; R frames the whole model.
    await page.keyboard.press('r');
    await settled(page);
    const start = await eye();
    await page.keyboard.press('ArrowRight');
    const turned = await eye();
    assert.ok(distance(start, turned) > 0.01, 'an arrow key rotates');
    await page.keyboard.press('+');
    assert.ok(Math.hypot(...(await eye())) < Math.hypot(...turned) * 0.95, '+ zooms in');
    await page.keyboard.press('r');
    await settled(page);
    assert.ok(distance(await eye(), start) < 1e-3, 'R resets the view');
    const full = await state(page);
    await page.keyboard.press('[');
    await settled(page);
    assert.ok((await state(page)).triangleCount < full.triangleCount, '[ reduces detail');
    await page.keyboard.press(']');
    await settled(page);
    assert.equal((await state(page)).triangleCount, full.triangleCount, '] restores it');
    await page.keyboard.press('w');
    assert.equal(await page.evaluate(() => window.striataViewer.stage.showsWireframe), true);
    await page.keyboard.press('w');
    await page.keyboard.press('s');
    assert.equal(await page.evaluate(() => window.striataViewer.model.coloring), 'strips');
    await page.keyboard.press('v');
    await settled(page);
    assert.notEqual((await state(page)).pixelError, null, 'V selects screen error');
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
