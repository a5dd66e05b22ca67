// Tests of saving: a dropped model is encoded in the browser, and the command reads the result.

import assert from 'node:assert/strict';
import { copyFileSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { drop } from './files.mjs';
import { run, shot, slide, state, untilWhole } from './harness.mjs';
import { note, openModel, pageTest } from './pages.mjs';

/** Clicks a button that saves, and returns the file and what the command says about it. */
async function save(world, page, format) {
  const started = Date.now();
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator(`#save-${format}`).click()]);
  const name = download.suggestedFilename();
  const path = join(world.folder, `saved-${name}`);
  copyFileSync(await download.path(), path);
  const facts = JSON.parse(run('info', path, '--json'));
  note(`saved ${name}: ${readFileSync(path).length} bytes in ${Date.now() - started} ms`);
  return { name, path, facts };
}

/** Notes what a text of the page says over time. */
function watchText(page, id) {
  return page.evaluate((id) => {
    window.said = [];
    new MutationObserver(() => window.said.push(document.getElementById(id).textContent))
      .observe(document.getElementById(id), { childList: true, characterData: true, subtree: true });
  }, id);
}

export default function saving(world) {
  pageTest(world, 'a dropped OBJ is saved as .stri and .glb', {}, async (page) => {
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    const obj = readFileSync(join(world.folder, 'torus.obj'));
    const triangles = obj.toString().match(/^f /gm).length;
    await drop(page, 'torus.obj', obj);
    await untilWhole(page);
    await watchText(page, 'saving-text');
    await page.locator('#save-level').waitFor();
    const whole = await save(world, page, 'level');
    assert.deepEqual([whole.name, whole.facts.triangle_count], [`torus-${triangles}.glb`, triangles]);
    for (const format of ['stri', 'glb']) {
      const { name, path, facts } = await save(world, page, format);
      assert.equal(name, `torus.${format}`);
      assert.equal(facts.triangle_count, triangles, JSON.stringify(facts).slice(0, 400));
      assert.equal(await page.locator('#saving').isVisible(), false);
      await drop(page, name, readFileSync(path));
      await page.waitForFunction((name) => window.striataViewer.name === name, name);
      await untilWhole(page);
      assert.equal((await state(page)).fullTriangleCount, triangles, 'the page shows what it saved');
      assert.equal(await page.locator('#save-stri').isVisible(), format !== 'stri', 'a stream is not encoded again');
      await drop(page, 'torus.obj', obj);
      await page.waitForFunction(() => window.striataViewer.name === 'torus.obj');
      await untilWhole(page);
    }
    const said = await page.evaluate(() => window.said);
    assert.ok(said.some((text) => /torus\.(stri|glb): \w.* \d+%/.test(text)), `the progress is shown: ${said.slice(0, 5)}`);
  });

  pageTest(world, 'a scene keeps materials, skin and animation when it is saved', {}, async (page) => {
    await openModel(world, page, 'plain-arm.glb');
    const { path, facts } = await save(world, page, 'stri');
    assert.equal(facts.triangle_count, 21_504);
    await drop(page, 'arm.stri', readFileSync(path));
    await page.waitForFunction(() => window.striataViewer.name === 'arm.stri');
    await untilWhole(page);
    assert.equal((await state(page)).fullTriangleCount, 21_504);
    assert.equal(await page.locator('#playback').isVisible(), true);
    await shot(page, 'saved');
    const saved = await save(world, page, 'glb');
    assert.equal(saved.facts.triangle_count, 21_504);
    // A level is for other programs: no stream, and as many triangles as the page shows.
    await slide(page, 'detail', 500);
    await page.waitForFunction(() => window.striataViewer.model.triangleCount < 15_000);
    const shown = (await state(page)).triangleCount;
    const level = await save(world, page, 'level');
    assert.ok(Math.abs(level.facts.triangle_count - shown) <= 0.02 * shown, `${level.facts.triangle_count} of ${shown}`);
    assert.ok(!readFileSync(level.path).includes('STRIATA_lod'));
  });

  pageTest(world, 'saving can be canceled', {}, async (page) => {
    // Large enough that it is not saved before it is canceled.
    await openModel(world, page, 'nefertiti.stri');
    await page.evaluate(() => document.getElementById('save-glb').click());
    await page.locator('#cancel-saving').click();
    await page.locator('#saving').waitFor({ state: 'hidden' });
    assert.equal(await page.locator('.notice').count(), 0);
    await save(world, page, 'glb');
  });

  pageTest(world, 'the percentage of building and loading is shown', {}, async (page) => {
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    await page.evaluate(() => {
      window.percents = [];
      const bar = document.getElementById('progress');
      new MutationObserver(() => {
        const now = bar.getAttribute('aria-valuenow');
        if (bar.getAttribute('aria-valuetext')?.startsWith('building') && now !== null) window.percents.push(Number(now));
      }).observe(bar, { attributes: true });
    });
    run('convert', '-q', join(world.folder, 'nefertiti.stri'), join(world.folder, 'bust.ply'));
    await drop(page, 'bust.ply', readFileSync(join(world.folder, 'bust.ply')));
    await page.waitForFunction(() => document.getElementById('subtitle').textContent.match(/building levels of detail, \d+%/));
    await untilWhole(page);
    const percents = await page.evaluate(() => window.percents);
    assert.ok(new Set(percents).size > 5, `${percents}`);
    assert.ok(Math.min(...percents) < 30 && Math.max(...percents) > 70, `from start to end: ${percents}`);
    await page.locator('#progress').waitFor({ state: 'hidden' });
  });
}
