// Tests of appearance and handling: gallery, themes, colors, names and keys.

import assert from 'node:assert/strict';
import { drawnPixels, settled, shot, slide, state, untilWhole } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

const DESKTOP = { width: 1200, height: 760 };

const colorOf = (page) => page.evaluate(() => getComputedStyle(document.body).color);

export default function looks(world) {
  pageTest(world, 'the gallery shows all models with thumbnails, and navigation returns to it', DESKTOP, async (page) => {
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    const names = await page.locator('#cards strong').allInnerTexts();
    for (const name of ['nefertiti.stri', 'icosphere.stri', 'spot.striata', 'sub/terrain.stri', 'torus.obj']) {
      assert.ok(names.includes(name), `${name} is listed: ${names}`);
    }
    await page.locator('#cards a[href*="icosphere"]').scrollIntoViewIfNeeded();
    await page.locator('#cards a[href*="icosphere"] img').waitFor();
    assert.ok(await page.evaluate(() => [...document.querySelectorAll('#cards img')].every((image) => image.naturalWidth > 0)));
    const broken = page.locator('#cards a[href*="garbage"]');
    await broken.scrollIntoViewIfNeeded();
    await broken.locator('.fault').waitFor();
    assert.match(await broken.innerText(), /cannot be read[^]*not a \.stri/i, 'the card of a broken file says what is wrong');
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
    assert.equal(await page.evaluate(() => window.striataViewer.model), null);
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
      const { coloring: now } = await page.evaluate(() => ({ coloring: window.striataViewer.model.coloring }));
      assert.equal(now, coloring);
      pictures.add(await page.evaluate(() => {
        const { stage } = window.striataViewer;
        stage.render();
        return stage.renderer.domElement.toDataURL();
      }));
      await shot(page, `colors-${coloring}`);
    }
    assert.equal(pictures.size, 4, 'every coloring looks different');
  });

  pageTest(world, 'z can be up', { width: 900, height: 600 }, async (page) => {
    await openModel(world, page, 'sub/terrain.stri');
    const pixels = await drawnPixels(page);
    await page.locator('#view').press('z');
    await settled(page);
    assert.notEqual(await drawnPixels(page), pixels, 'tilted');
    await shot(page, 'z-up');
  });

  pageTest(world, 'every control has a name and can be reached with Tab', {}, async (page) => {
    for (const model of ['arm.stri', 'spot.striata']) {
      await openModel(world, page, model);
      await page.keyboard.press('b');
      const nameless = await page.evaluate(() => {
        const controls = document.querySelectorAll('button, a[href], select, canvas, progress, input:not([type="file"]), [role]');
        const labelled = (node) => document.getElementById(node.getAttribute('aria-labelledby') ?? '');
        const named = (node) => node.getAttribute('aria-label') || labelled(node) || node.textContent.trim() || node.labels?.[0]?.textContent.trim();
        return [...controls].filter((node) => !named(node) && node.role !== 'status').map((node) => node.outerHTML);
      });
      assert.deepEqual(nameless, []);
    }
    const reached = new Set();
    for (let press = 0; press < 100; press += 1) {
      await page.keyboard.press('Tab');
      const { id, part } = await page.evaluate(() => ({
        id: document.activeElement?.id || document.activeElement?.getAttribute('name') || '', part: document.activeElement?.closest('.part') !== null,
      }));
      reached.add(part ? 'part' : id);
    }
    for (const id of ['view', 'divider', 'open', 'theme', 'show-help', 'fold', 'mode', 'detail', 'compare', 'second', 'coloring', 'wireframe', 'flat', 'background', 'part', 'turn', 'z-up', 'reset', 'picture', 'copy-link', 'pick', 'plots-title', 'download', 'save-level', 'save-stri', 'save-glb', 'to-gallery']) {
      assert.ok(reached.has(id), `${id} is reached by Tab: ${[...reached]}`);
    }
  });
}
