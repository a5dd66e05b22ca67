// Tests of the multiresolution models that the page draws instead of its own way, and of `striata view`.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';
import { settled, shot, slide, striata, untilWhole } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

const facts = (page, id = 'inspected-facts') => page.evaluate((id) => Object.fromEntries([...document.querySelectorAll(`#${id} div`)].map((row) => [row.children[0].textContent, row.children[1].textContent])), id);
const number = (text) => Number(text.replaceAll(',', '').match(/[\d.]+/)[0]);

/** Chooses a model and waits until it is drawn. */
async function choose(page, model) {
  await page.selectOption('#inspected', model);
  await page.waitForFunction(() => document.querySelectorAll('#inspected-facts div').length > 0 && document.querySelector('#inspected-note').hidden);
  await page.waitForFunction((model) => window.striataViewer.inspection.mesh !== null && window.striataViewer.inspection.shown === model, model);
  await settled(page);
}

export default function models(world) {
  pageTest(world, 'every multiresolution model is drawn, with its statistics', { width: 1000, height: 900 }, async (page) => {
    await openModel(world, page, 'spot.striata');
    await untilWhole(page);
    await slide(page, 'detail', 700);
    await page.waitForFunction(() => window.striataViewer.model.triangleCount < window.striataViewer.model.fullTriangleCount);
    await settled(page);
    const shown = await page.evaluate(() => window.striataViewer.model.triangleCount);
    for (const [model, primitive] of Object.entries({ list: null, lodstrips: 'Strips', 'live-strips': 'Strips', mts: 'Strips', fans: 'Fans', patterns: 'Fragments' })) {
      await choose(page, model);
      const found = await facts(page);
      assert.equal(number(found.Triangles), shown, model);
      if (primitive) assert.ok(number(found[primitive]) > 0 && number(found[primitive]) < shown, `${model}: ${found[primitive]}`);
      assert.ok(number(found.Indices) > shown && number(found['Each instance']) > 0, model);
      assert.equal(model === 'list' || model === 'live-strips', found.Model === undefined, model);
      assert.equal(await page.evaluate(() => window.striataViewer.model.visible), false, 'the scene is hidden');
    }
    await shot(page, 'models-patterns');
    await page.click('#coloring label:has([value="strips"])');
    await choose(page, 'lodstrips');
    assert.ok(await page.evaluate(() => window.striataViewer.inspection.mesh.geometry.index === null), 'strips have colors of their own');
    await shot(page, 'models-strips');
    // The level follows the panel.
    await slide(page, 'detail', 400);
    await page.waitForFunction((before) => window.striataViewer.inspection.triangleCount < before, shown);
    const address = await page.waitForFunction(() => /as=lodstrips/.test(location.search) && location.href);
    await page.goto(await address.jsonValue());
    await page.waitForFunction(() => window.striataViewer.inspection.shown === 'lodstrips');
    await page.selectOption('#inspected', '');
    assert.equal(await page.evaluate(() => window.striataViewer.model.visible && window.striataViewer.inspection.mesh === null), true);
  });

  pageTest(world, 'fans and patterns follow the camera, and vertices glide', { width: 1000, height: 900 }, async (page) => {
    await openModel(world, page, 'nefertiti.stri');
    await untilWhole(page);
    await page.click('#mode label:has([value="pixels"])');
    for (const model of ['fans', 'patterns']) {
      await choose(page, model);
      const near = number((await facts(page)).Triangles);
      await page.evaluate(() => window.striataViewer.framing.zoom(6));
      await page.waitForFunction((near) => window.striataViewer.inspection.triangleCount < near / 2, near);
      await page.evaluate(() => window.striataViewer.framing.reset());
      await page.waitForFunction((near) => window.striataViewer.inspection.triangleCount > near / 2, near);
    }
    await page.click('#mode label:has([value="level"])');
    await slide(page, 'detail', 300);
    await choose(page, 'fans');
    await page.check('#morphs');
    await page.evaluate(() => {
      window.morphs = [];
      const { stage, inspection } = window.striataViewer;
      const before = stage.onFrame;
      stage.onFrame = (ms) => {
        before(ms);
        window.morphs.push([inspection.isMoving, inspection.drawnTriangleCount]);
      };
    });
    const coarse = await page.evaluate(() => window.striataViewer.inspection.triangleCount);
    await slide(page, 'detail', 500);
    await page.waitForFunction((coarse) => window.striataViewer.inspection.triangleCount > coarse, coarse);
    const fine = await page.evaluate(() => window.striataViewer.inspection.triangleCount);
    await slide(page, 'detail', 300);
    await page.waitForFunction((coarse) => window.striataViewer.inspection.triangleCount === coarse && !window.striataViewer.inspection.isMoving && window.morphs.some(([moves]) => moves), coarse);
    const frames = await page.evaluate(() => window.morphs);
    assert.ok(frames.some(([moves, drawn]) => moves && drawn === fine), 'the finer level is drawn while its vertices go');
    assert.equal(await page.evaluate(() => window.striataViewer.inspection.drawnTriangleCount), coarse);
  });

  pageTest(world, 'a picked vertex has a step and an error, in the scene and in a model', { width: 1000, height: 900 }, async (page) => {
    await openModel(world, page, 'spot.striata');
    await untilWhole(page);
    const pick = async () => {
      const { x, y, width, height } = await page.locator('#screen').boundingBox();
      await page.keyboard.down('Shift');
      await page.mouse.click(x + width / 2, y + height / 2);
      await page.keyboard.up('Shift');
      await page.locator('#picked').waitFor();
      await page.waitForFunction(() => [...document.querySelectorAll('#picked-facts dt')].some((name) => name.textContent === 'Step'));
      return facts(page, 'picked-facts');
    };
    const inScene = await pick();
    const steps = await page.evaluate(() => window.striataViewer.model.lods?.[0]?.last?.stepCount ?? Infinity);
    assert.ok(number(inScene.Step) < steps && number(inScene['Error without it']) >= 0, JSON.stringify(inScene));
    await choose(page, 'mts');
    const inModel = await pick();
    assert.ok(number(inModel.Strip) >= 0 && inModel['Nearest vertex'] !== undefined, JSON.stringify(inModel));
    assert.equal(inModel.Step, inScene.Step, 'the same vertex of the same file');
  });

  pageTest(world, 'the command of a page ends with it', { width: 700, height: 600 }, async (page) => {
    const child = spawn(striata, ['view', 'shape.obj', '--no-open', '--detail', '0.5'].map((word) => (word === 'shape.obj' ? `${world.folder}/torus.obj` : word)), { stdio: ['ignore', 'pipe', 'pipe'] });
    const ended = new Promise((resolve) => child.once('exit', resolve));
    const address = await new Promise((resolve) => createInterface({ input: child.stdout }).once('line', resolve));
    await page.goto(address);
    await untilWhole(page);
    assert.equal(child.exitCode, null);
    const { triangleCount, fullTriangleCount } = await page.evaluate(() => ({ triangleCount: window.striataViewer.model.triangleCount, fullTriangleCount: window.striataViewer.model.fullTriangleCount }));
    assert.ok(triangleCount < fullTriangleCount, 'the first settings hold');
    await page.reload();
    await untilWhole(page);
    assert.equal(child.exitCode, null, 'a page may load again');
    await page.goto('about:blank');
    assert.equal(await ended, 0);
  });
}
