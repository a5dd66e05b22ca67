// Tests of scenes in the viewer: materials and light, animation, the parts of the model, and the comparison of two levels.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { drop } from './files.mjs';
import { drawnPixels, drawnTriangles, settled, shot, slide, state, untilWhole } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

const DESKTOP = { width: 1200, height: 760 };

/** Draws the stage and returns its pixels, from the bottom row up, with width and height. */
export function picture(page) {
  return page.evaluate(() => {
    const { stage } = window.striataViewer;
    const gl = stage.renderer.getContext();
    stage.render();
    const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return { width, height, pixels: Array.from(new Uint32Array(pixels.buffer)) };
  });
}

/** The picture when it no longer changes: textures are decoded after the model has loaded. */
async function steadyPicture(page) {
  for (let last = await picture(page); ;) {
    await page.waitForTimeout(500);
    const next = await picture(page);
    if (differing(last, next) === 0) return next;
    last = next;
  }
}

/** Number of pixels that differ between two pictures of the same size, in the columns from `from` to `to` (fractions of the width). */
function differing(one, other, from = 0, to = 1) {
  const [first, last] = [Math.round(from * one.width), Math.round(to * one.width)];
  return one.pixels.filter((pixel, at) => pixel !== other.pixels[at] && at % one.width >= first && at % one.width < last).length;
}

const row = (page, name) => page.locator('.part', { has: page.locator(`.name span:text-is("${name}")`) });

export default function sceneViewer(world) {
  pageTest(world, 'a scene is shown with its materials in the studio, and a scan as clay', DESKTOP, async (page) => {
    await openModel(world, page, 'arm.stri');
    const lighting = () => page.evaluate(() => window.striataViewer.stage.lighting.name);
    assert.equal(await lighting(), 'studio');
    const seen = await picture(page);
    // The balls are red, and the arm has stripes of other colors.
    const channels = seen.pixels.map((pixel) => [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255]);
    const reds = channels.filter(([red, green, blue]) => red > 90 && green < 0.6 * red && blue < 0.6 * red).length;
    assert.ok(reds > 2000, `${reds} red pixels`);
    const textures = await page.evaluate(() => {
      const maps = [];
      window.striataViewer.model.traverse(({ material }) => {
        for (const one of [material ?? []].flat()) if (one.map) maps.push(one.map.image.width);
      });
      return maps;
    });
    assert.deepEqual([...new Set(textures)], [256], 'the texture has its full size in the end');
    await shot(page, 'scene');
    await openModel(world, page, 'icosphere.stri');
    assert.equal(await lighting(), 'lamps');
    await page.evaluate(() => history.back());
    await untilWhole(page);
    assert.equal(await lighting(), 'studio', 'the light follows the model');
  });

  pageTest(world, 'levels of a scene keep to a triangle budget', {}, async (page) => {
    await openModel(world, page, 'arm.stri');
    const full = await state(page);
    assert.equal(full.triangleCount, 21_504, 'instances count each time they are drawn');
    assert.equal(await drawnTriangles(page), 21_504);
    await page.locator('input[name="mode"][value="budget"]').check({ force: true });
    const typed = page.locator('#budget-typed');
    for (const limit of [5000, 700]) {
      await typed.fill(String(limit));
      await typed.press('Enter');
      await settled(page);
      const { triangleCount } = await state(page);
      assert.ok(triangleCount <= limit && triangleCount > 0.8 * limit, `${triangleCount} of at most ${limit}`);
      assert.equal(await drawnTriangles(page), triangleCount);
    }
    await page.keyboard.press('v');
    await slide(page, 'pixels', 900);
    await settled(page);
    assert.ok((await state(page)).triangleCount < 21_504, 'a screen error of many pixels needs fewer triangles');
  });

  pageTest(world, 'an animation plays, pauses, and shows any time', { ...DESKTOP, still: false }, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    assert.equal(await page.locator('#playback').isVisible(), false, 'a scan has no animation');
    await page.goto(`${world.url}?model=models/arm.stri`);
    await untilWhole(page);
    const time = () => page.evaluate(() => window.striataViewer.playback.time);
    await page.locator('#play[aria-label="Pause"]').waitFor();
    const before = await time();
    await page.waitForFunction((before) => Math.abs(window.striataViewer.playback.time - before) > 0.05, before);
    await page.locator('#play').click();
    await page.locator('#play[aria-label="Play"]').waitFor();
    const paused = await time();
    await settled(page);
    assert.equal(await time(), paused, 'a paused animation stays');
    await slide(page, 'time', 0);
    const rest = await picture(page);
    await slide(page, 'time', 300);
    const { duration } = await page.evaluate(() => ({ duration: window.striataViewer.playback.duration }));
    assert.ok(Math.abs((await time()) - 0.3 * duration) < 1e-6, 'the slider sets the time');
    const bent = await picture(page);
    assert.ok(differing(rest, bent) > 1000, 'the arm has moved');
    assert.match(await page.locator('#time').getAttribute('aria-valuetext'), /^\d+\.\d\d of \d+\.\d\d seconds$/);
    await shot(page, 'animation');
    await page.locator('#view').focus();
    await page.keyboard.press(' ');
    await page.locator('#play[aria-label="Pause"]').waitFor();
    await page.keyboard.press(' ');
    await page.locator('#play[aria-label="Play"]').waitFor();
    await slide(page, 'time', 300);
    assert.equal(differing(bent, await picture(page)), 0, 'the same time gives the same picture');
    assert.equal(await page.locator('#clip option').count(), 1);
  });

  pageTest(world, 'users who prefer reduced motion start the animation themselves', {}, async (page) => {
    await openModel(world, page, 'arm.stri');
    assert.equal(await page.locator('#play').getAttribute('aria-label'), 'Play');
    assert.equal(await page.evaluate(() => window.striataViewer.playback.time), 0);
  });

  pageTest(world, 'parts are listed with triangles and materials, hidden, and framed', DESKTOP, async (page) => {
    await openModel(world, page, 'arm.stri');
    for (const name of ['arm', 'left', 'right', 'small']) await row(page, name).first().waitFor();
    assert.match(await row(page, 'arm').first().innerText(), /6,144/);
    assert.match(await row(page, 'left').first().innerText(), /5,120/);
    const materials = await page.locator('#tree .material').allInnerTexts();
    assert.ok(materials.some((text) => /striped/.test(text) && /stripes/.test(text)), `with the name of the texture: ${materials}`);
    const swatches = await page.locator('#tree .swatch').evaluateAll((nodes) => nodes.map((node) => node.style.background));
    assert.ok(swatches.some((color) => /rgb\(2\d\d, 1[0-3]\d, /.test(color)), `a red swatch: ${swatches}`);
    await shot(page, 'parts');
    const all = await drawnPixels(page);
    const eye = row(page, 'arm').first().locator('.eye');
    assert.equal(await eye.getAttribute('aria-pressed'), 'true');
    await eye.click();
    assert.equal(await eye.getAttribute('aria-pressed'), 'false');
    assert.ok((await drawnPixels(page)) < 0.8 * all, 'the arm is hidden');
    await shot(page, 'part-hidden');
    await page.locator('#show-all').click();
    assert.equal(await drawnPixels(page), all, 'all parts are shown again');
    assert.equal(await page.locator('#show-all').isVisible(), false);
    const distance = () => page.evaluate(() => window.striataViewer.stage.camera.position.distanceTo(window.striataViewer.stage.controls.target));
    const far = await distance();
    await row(page, 'small').first().locator('.name').click();
    await settled(page);
    assert.ok((await distance()) < far / 2, 'the camera is near the small ball');
    await shot(page, 'part-framed');
    // Keys move between the rows.
    await row(page, 'arm').first().locator('.name').focus();
    const focused = () => page.evaluate(() => document.activeElement.closest('.part')?.querySelector('.name span')?.textContent);
    const visited = [await focused()];
    for (let press = 0; press < 3; press += 1) {
      await page.keyboard.press('ArrowDown');
      visited.push(await focused());
    }
    assert.equal(new Set(visited).size >= 3, true, `rows: ${visited}`);
    await page.keyboard.press('Home');
    assert.equal(await focused(), 'arm');
    await page.keyboard.press('ArrowLeft');
    assert.equal(await row(page, 'arm').first().locator('.fold').getAttribute('aria-expanded'), 'false', 'the left arrow folds');
    await page.keyboard.press('ArrowRight');
    assert.equal(await row(page, 'arm').first().locator('.fold').getAttribute('aria-expanded'), 'true', 'the right arrow unfolds');
  });

  pageTest(world, 'two levels are compared on both sides of a divider', DESKTOP, async (page) => {
    for (const model of ['arm.stri', 'nefertiti.stri']) {
      await openModel(world, page, model);
      const { fullTriangleCount: full } = await state(page);
      const plain = await steadyPicture(page);
      const toggle = page.locator('#compare');
      assert.equal(await page.locator('#divider').isVisible(), false);
      await toggle.check();
      await page.waitForFunction(() => window.striataViewer.comparison.triangleCount !== null);
      await settled(page);
      const second = await page.evaluate(() => window.striataViewer.comparison.triangleCount);
      assert.ok(second < full / 4 && second > 0, `${second} of ${full} triangles`);
      const both = await picture(page);
      assert.equal(differing(plain, both, 0, 0.49), 0, `${model}: the left part is as before`);
      assert.ok(differing(plain, both, 0.5, 1) > 500, 'the right part shows another level');
      assert.match((await page.locator('#right-side').innerText()).replaceAll(',', ''), new RegExp(`^${second} triangles`));
      await shot(page, `compared-${model}`);
      // The other level follows its slider.
      await slide(page, 'second', 1000);
      await page.waitForFunction((full) => window.striataViewer.comparison.triangleCount === full, full);
      assert.ok(differing(plain, await picture(page), 0.5, 1) < 500, 'at full detail both parts agree');
      await slide(page, 'second', 300);
      await page.waitForFunction((second) => window.striataViewer.comparison.triangleCount < second, second);
      // Keys move the divider.
      const divider = page.locator('#divider');
      const value = async () => Number(await divider.getAttribute('aria-valuenow'));
      await divider.focus();
      const { left } = await page.locator('#screen').evaluate((node) => node.getBoundingClientRect().toJSON());
      assert.equal(await value(), 50);
      await page.keyboard.press('ArrowRight');
      assert.equal(await value(), 52);
      await page.keyboard.press('Shift+ArrowLeft');
      assert.equal(await value(), 42);
      await page.keyboard.press('Home');
      assert.equal(await value(), 0);
      await page.keyboard.press('End');
      assert.equal(await value(), 100);
      await settled(page);
      assert.equal(differing(plain, await picture(page)), 0, 'the left level fills the picture');
      // So does the mouse.
      const box = await page.locator('#screen').boundingBox();
      const middle = box.y + box.height / 2;
      await page.mouse.move(box.x + box.width - 10, middle);
      await page.mouse.down();
      await page.mouse.move(left + box.width * 0.25, middle, { steps: 4 });
      await page.mouse.up();
      assert.ok(Math.abs((await value()) - 25) <= 1, `the divider is at ${await value()}`);
      await page.keyboard.press('b');
      assert.equal(await toggle.isChecked(), false);
      await settled(page);
      assert.equal(differing(plain, await picture(page)), 0, 'the picture is whole again');
    }
  });

  pageTest(world, 'a model is compared with another file, which has levels of its own', DESKTOP, async (page) => {
    await openModel(world, page, 'spot.striata');
    const plain = await steadyPicture(page);
    await page.locator('#compare').check();
    await page.waitForFunction(() => window.striataViewer.comparison.triangleCount !== null);
    await slide(page, 'second', 1000);
    await page.locator('#compared').setInputFiles(join(world.folder, 'torus.obj'));
    await page.locator('#right-side', { hasText: 'torus.obj: ' }).waitFor();
    await settled(page);
    const torus = await page.evaluate(() => window.striataViewer.comparison.triangleCount);
    assert.equal(torus, readFileSync(join(world.folder, 'torus.obj')).toString().match(/^f /gm).length);
    const both = await picture(page);
    assert.equal(differing(plain, both, 0, 0.49), 0, 'the left part is as before');
    assert.ok(differing(plain, both, 0.5, 1) > 500, 'the right part shows the other file');
    await shot(page, 'compared-files');
    await slide(page, 'second', 300);
    await page.waitForFunction((torus) => window.striataViewer.comparison.triangleCount < torus, torus);
    // A file that cannot be opened changes nothing.
    await page.locator('#compared').setInputFiles(join(world.folder, 'garbage.stri'));
    await page.locator('.notice strong', { hasText: 'Cannot open garbage.stri' }).waitFor();
    assert.match(await page.locator('#right-side').innerText(), /^torus\.obj/);
    await page.locator('.notice button').first().click();
    await page.locator('#compare-file').click();
    await slide(page, 'second', 1000);
    await page.waitForFunction(() => window.striataViewer.comparison.triangleCount === window.striataViewer.model.fullTriangleCount);
    await page.locator('#compare').uncheck();
    await settled(page);
    assert.equal(differing(plain, await picture(page)), 0, 'only the model is shown');
  });

  pageTest(world, 'a comparison shows surfaces, and ends with the model', {}, async (page) => {
    await openModel(world, page, 'spot.striata');
    await page.locator('input[name="coloring"][value="strips"]').check({ force: true });
    await page.keyboard.press('b');
    await page.waitForFunction(() => window.striataViewer.comparison.triangleCount !== null);
    assert.equal(await page.evaluate(() => window.striataViewer.model.coloring), 'surface');
    assert.equal(await page.locator('input[name="coloring"][value="fans"]').isDisabled(), true);
    await page.keyboard.press('w');
    await settled(page);
    await shot(page, 'compared-wireframe');
    await drop(page, 'torus.obj', readFileSync(join(world.folder, 'torus.obj')));
    await page.waitForFunction(() => window.striataViewer.name === 'torus.obj');
    await untilWhole(page);
    assert.equal(await page.locator('#compare').isChecked(), false);
    assert.equal(await page.locator('#divider').isVisible(), false);
    assert.equal(await page.locator('input[name="coloring"][value="fans"]').isDisabled(), false);
  });
}
