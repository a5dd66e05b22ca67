// How it looks and is held: gallery, dark and light, phones and touch, colors, pictures.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { drawnPixels, settled, shot, slide, state, untilWhole } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

const DESKTOP = { width: 1200, height: 760 };

/** A narrow phone. */
const PHONE = { width: 360, height: 720 };

/** No part of the page may stick out sideways. */
async function assertNoSideScroll(page) {
  const [wide, room] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(wide <= room, `the page is ${wide} wide in ${room}`);
}

/** Fingers that go from one set of places to another. */
async function touch(page, from, to) {
  const wire = await page.context().newCDPSession(page);
  const points = (places) => places.map(([x, y], id) => ({ x, y, id }));
  await wire.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 2 });
  await wire.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(from) });
  for (let step = 1; step <= 5; step += 1) {
    const places = from.map(([x, y], at) => [x + ((to[at][0] - x) * step) / 5, y + ((to[at][1] - y) * step) / 5]);
    await wire.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(places) });
  }
  await wire.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await wire.detach();
}

const eyeOf = (page) => page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
const colorOf = (page) => page.evaluate(() => getComputedStyle(document.body).color);

export default function looks(world) {
  pageTest(world, 'the gallery shows all models with pictures, and goes back to itself', DESKTOP, async (page) => {
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    const names = await page.locator('#cards strong').allInnerTexts();
    for (const name of ['nefertiti.stri', 'icosphere.stri', 'spot.striata', 'sub/terrain.stri', 'torus.obj']) {
      assert.ok(names.includes(name), `${name} among ${names}`);
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

  pageTest(world, 'light, dark, and a switch between them', { scheme: 'dark', ...DESKTOP }, async (page) => {
    await openModel(world, page, 'nefertiti.stri');
    await settled(page);
    await shot(page, 'desktop-dark');
    const dark = await colorOf(page);
    await page.emulateMedia({ colorScheme: 'light' });
    // As the system has it.
    await page.waitForFunction((dark) => getComputedStyle(document.body).color !== dark, dark);
    await settled(page);
    await shot(page, 'desktop-light');
    await page.locator('#theme').click();
    assert.equal(await colorOf(page), dark, 'or as the reader has it');
    await page.reload();
    assert.equal(await colorOf(page), dark, 'which is remembered');
    await page.evaluate(() => localStorage.clear());
  });

  pageTest(world, 'colors by strips, fans and triangles', {}, async (page) => {
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
    assert.equal(pictures.size, 4, 'each looks different');
  });

  pageTest(world, 'a phone: the sheet folds, nothing sticks out, fingers turn and zoom', PHONE, async (page) => {
    await openModel(world, page, 'nefertiti.stri');
    await assertNoSideScroll(page);
    await shot(page, 'phone-folded');
    assert.equal(await page.locator('#controls').isVisible(), false, 'folded at first');
    await page.locator('#handle').click();
    await page.locator('#controls').waitFor();
    await settled(page);
    await assertNoSideScroll(page);
    const stage = await page.locator('#stage').boundingBox();
    const panel = await page.locator('#panel').boundingBox();
    assert.ok(stage.y + stage.height <= panel.y + 1, 'the sheet does not cover the model');
    assert.ok(stage.height > 250 && (await drawnPixels(page)) > 2000, 'the model is seen beside the sheet');
    await shot(page, 'phone');
    const [x, y] = [stage.x + stage.width / 2, stage.y + stage.height / 2];
    const before = await eyeOf(page);
    await touch(page, [[x - 60, y]], [[x + 60, y]]);
    await settled(page);
    const turned = await eyeOf(page);
    assert.ok(Math.hypot(...turned.map((value, axis) => value - before[axis])) > 1e-3 * Math.hypot(...before), 'one finger turns');
    const away = () => page.evaluate(() => window.striataViewer.stage.camera.position.distanceTo(window.striataViewer.stage.controls.target));
    const far = await away();
    await touch(page, [[x - 20, y], [x + 20, y]], [[x - 90, y], [x + 90, y]]);
    await settled(page);
    assert.ok((await away()) < 0.8 * far, 'two fingers zoom');
    await page.locator('#handle').click();
    assert.equal(await page.locator('#controls').isVisible(), false);
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    await assertNoSideScroll(page);
    await shot(page, 'phone-gallery');
  });

  pageTest(world, 'a picture is saved, and z can be up', { width: 900, height: 600 }, async (page) => {
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
    assert.ok(png.length > 5000, 'with something on it');
  });

  pageTest(world, 'every control has a name and can be reached', {}, async (page) => {
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
    for (const id of ['view', 'open', 'theme', 'ask', 'fold', 'mode', 'detail', 'coloring', 'wireframe', 'flat', 'background', 'turn', 'z-up', 'reset', 'picture', 'download', 'to-gallery']) {
      assert.ok(reached.has(id), `${id} is reached by Tab: ${[...reached]}`);
    }
  });
}
