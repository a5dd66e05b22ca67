// Tests of appearance and handling: gallery, themes, phones and touch, colors, images.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { drawnPixels, settled, shot, slide, state, untilWhole } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

const DESKTOP = { width: 1200, height: 760 };

/** A narrow phone. */
const PHONE = { width: 360, height: 720 };

/** Asserts that the page does not scroll sideways. */
async function assertNoSideScroll(page) {
  const [wide, room] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(wide <= room, `the page is ${wide} px wide, but the window only ${room} px`);
}

/** Moves fingers from one set of points to another. */
async function touch(page, from, to) {
  const wire = await page.context().newCDPSession(page);
  const points = (positions) => positions.map(([x, y], id) => ({ x, y, id }));
  await wire.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 2 });
  await wire.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(from) });
  for (let step = 1; step <= 5; step += 1) {
    const positions = from.map(([x, y], at) => [x + ((to[at][0] - x) * step) / 5, y + ((to[at][1] - y) * step) / 5]);
    await wire.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(positions) });
  }
  await wire.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await wire.detach();
}

const eyeOf = (page) => page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
const colorOf = (page) => page.evaluate(() => getComputedStyle(document.body).color);

export default function looks(world) {
  pageTest(world, 'the gallery shows all models with thumbnails, and navigation returns to it', DESKTOP, async (page) => {
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    const names = await page.locator('#cards strong').allInnerTexts();
    for (const name of ['nefertiti.stri', 'icosphere.stri', 'spot.striata', 'sub/terrain.stri', 'torus.obj']) {
      assert.ok(names.includes(name), `${name} is listed: ${names}`);
    }
    const picture = page.locator('#cards a[href*="icosphere"] img');
    await picture.scrollIntoViewIfNeeded();
    await page.waitForFunction(() => [...document.querySelectorAll('#cards img')].every((image) => image.complete && image.naturalWidth > 0));
    await shot(page, 'gallery');
    await page.locator('#cards a[href*="icosphere"]').click();
    await untilWhole(page);
    assert.match(page.url(), /\?model=models\/icosphere\.stri$/);
    assert.equal(await page.locator('#gallery').isVisible(), false);
    await page.goBack();
    await page.locator('#cards a').first().waitFor();
    await page.goForward();
    await untilWhole(page);
    await page.locator('#to-gallery').click();
    await page.locator('#gallery').waitFor();
    assert.equal(await page.evaluate(() => window.striataViewer.mesh), null);
  });

  pageTest(world, 'the theme follows the system until it is switched', { scheme: 'dark', ...DESKTOP }, async (page) => {
    await openModel(world, page, 'nefertiti.stri');
    await settled(page);
    await shot(page, 'desktop-dark');
    const dark = await colorOf(page);
    await page.emulateMedia({ colorScheme: 'light' });
    // The theme follows the system.
    await page.waitForFunction((dark) => getComputedStyle(document.body).color !== dark, dark);
    await settled(page);
    await shot(page, 'desktop-light');
    await page.locator('#theme').click();
    assert.equal(await colorOf(page), dark, 'the button switches the theme');
    await page.reload();
    assert.equal(await colorOf(page), dark, 'the choice is remembered');
    await page.evaluate(() => localStorage.clear());
  });

  pageTest(world, 'coloring by strip, fan and triangle', {}, async (page) => {
    await openModel(world, page, 'spot.striata');
    await slide(page, 'detail', 700);
    await settled(page);
    const pictures = new Set();
    for (const coloring of ['surface', 'strips', 'fans', 'triangles']) {
      await page.locator(`input[name="coloring"][value="${coloring}"]`).check({ force: true });
      await settled(page);
      const { coloring: now } = await page.evaluate(() => ({ coloring: window.striataViewer.mesh.coloring }));
      assert.equal(now, coloring);
      pictures.add(await page.evaluate(() => {
        const { stage } = window.striataViewer;
        stage.renderer.render(stage.scene, stage.camera);
        return stage.renderer.domElement.toDataURL();
      }));
      await shot(page, `colors-${coloring}`);
    }
    assert.equal(pictures.size, 4, 'every coloring looks different');
  });

  pageTest(world, 'on a phone the sheet folds, the page fits, and touch rotates and zooms', PHONE, async (page) => {
    await openModel(world, page, 'nefertiti.stri');
    await assertNoSideScroll(page);
    await shot(page, 'phone-folded');
    assert.equal(await page.locator('#controls').isVisible(), false, 'the controls are hidden at first');
    await page.locator('#handle').click();
    await page.locator('#controls').waitFor();
    await settled(page);
    await assertNoSideScroll(page);
    const stage = await page.locator('#stage').boundingBox();
    const panel = await page.locator('#panel').boundingBox();
    assert.ok(stage.y + stage.height <= panel.y + 1, 'the sheet does not cover the model');
    assert.ok(stage.height > 250 && (await drawnPixels(page)) > 2000, 'the model is visible next to the sheet');
    await shot(page, 'phone');
    const [x, y] = [stage.x + stage.width / 2, stage.y + stage.height / 2];
    const before = await eyeOf(page);
    await touch(page, [[x - 60, y]], [[x + 60, y]]);
    await settled(page);
    const turned = await eyeOf(page);
    assert.ok(Math.hypot(...turned.map((value, axis) => value - before[axis])) > 1e-3 * Math.hypot(...before), 'one finger rotates');
    const distanceToTarget = () => page.evaluate(() => window.striataViewer.stage.camera.position.distanceTo(window.striataViewer.stage.controls.target));
    const far = await distanceToTarget();
    await touch(page, [[x - 20, y], [x + 20, y]], [[x - 90, y], [x + 90, y]]);
    await settled(page);
    assert.ok((await distanceToTarget()) < 0.8 * far, 'two fingers zoom');
    await page.locator('#handle').click();
    assert.equal(await page.locator('#controls').isVisible(), false);
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    await assertNoSideScroll(page);
    await shot(page, 'phone-gallery');
  });

  pageTest(world, 'an image can be saved, and z can be up', { width: 900, height: 600 }, async (page) => {
    await openModel(world, page, 'sub/terrain.stri');
    const pixels = await drawnPixels(page);
    await page.locator('#view').press('z');
    await settled(page);
    assert.notEqual(await drawnPixels(page), pixels, 'tilted');
    await shot(page, 'z-up');
    const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#picture').click()]);
    assert.equal(download.suggestedFilename(), 'terrain.png');
    const png = readFileSync(await download.path());
    assert.equal(png.subarray(1, 4).toString(), 'PNG');
    const { width, height } = await page.evaluate(() => {
      const { width, height } = window.striataViewer.stage.renderer.domElement;
      return { width, height };
    });
    assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [width, height]);
    assert.ok(png.length > 5000, 'the image is not empty');
  });

  pageTest(world, 'every control has a name and can be reached with Tab', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    const nameless = await page.evaluate(() => {
      const controls = document.querySelectorAll('button, a[href], select, canvas, input:not([type="file"])');
      const named = (node) => node.getAttribute('aria-label') || node.textContent.trim() || node.labels?.[0]?.textContent.trim();
      return [...controls].filter((node) => !named(node)).map((node) => node.outerHTML);
    });
    assert.deepEqual(nameless, []);
    const reached = new Set();
    for (let press = 0; press < 60; press += 1) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement?.id || document.activeElement?.getAttribute('name') || ''));
    }
    for (const id of ['view', 'open', 'theme', 'show-help', 'fold', 'mode', 'detail', 'coloring', 'wireframe', 'flat', 'background', 'turn', 'z-up', 'reset', 'picture', 'download', 'to-gallery']) {
      assert.ok(reached.has(id), `${id} is reached by Tab: ${[...reached]}`);
    }
  });
}
