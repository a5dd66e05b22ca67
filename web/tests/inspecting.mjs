// Tests of what the page shows about a model: plots, picked triangles, back faces, vertex colors, light.

import assert from 'node:assert/strict';
import { drop } from './files.mjs';
import { settled, shot, slide, state, untilWhole } from './harness.mjs';
import { eyeOf } from './phone.mjs';
import { openModel, pageTest } from './pages.mjs';

/** Mean color of the stage. */
function meanColor(page) {
  return page.evaluate(() => {
    const { stage } = window.striataViewer;
    const gl = stage.renderer.getContext();
    stage.render();
    const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const sum = [0, 0, 0];
    for (let at = 0; at < pixels.length; at += 4) for (let i = 0; i < 3; i += 1) sum[i] += pixels[at + i];
    return sum.map((value) => value / (width * height));
  });
}

const differ = (a, b) => Math.max(...a.map((value, i) => Math.abs(value - b[i])));

/** The facts about the picked triangle by their names. */
const facts = (page) => page.evaluate(() => Object.fromEntries([...document.querySelectorAll('#picked-facts div')].map((row) => [row.children[0].textContent, row.children[1].textContent])));

async function middle(page) {
  const { x, y, width, height } = await page.locator('#screen').boundingBox();
  return [x + width / 2, y + height / 2];
}

/** A PLY file of a triangle whose corners are red, with its front toward the camera or not. */
function redTriangle(isFront) {
  const header = ['ply', 'format ascii 1.0', 'element vertex 3', ...['x', 'y', 'z'].map((name) => `property float ${name}`),
    ...['red', 'green', 'blue'].map((name) => `property uchar ${name}`), 'element face 1', 'property list uchar int vertex_indices', 'end_header'];
  const corners = ['-1 -1 0', '1 -1 0', '0 1 0'].map((corner) => `${corner} 255 0 0`);
  return Buffer.from([...header, ...corners, isFront ? '3 0 1 2' : '3 0 2 1', ''].join('\n'));
}

async function dropped(page, name, bytes) {
  await drop(page, name, bytes);
  await page.waitForFunction((name) => window.striataViewer.model && window.striataViewer.name === name, name);
  await untilWhole(page);
  await settled(page);
}

export default function inspecting(world) {
  pageTest(world, 'a click picks a triangle, whose facts go with it', { width: 1000, height: 700 }, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    const [x, y] = await middle(page);
    await page.mouse.click(x, y);
    assert.equal(await page.locator('#picked').isVisible(), false, 'a plain click picks nothing');
    await page.keyboard.down('Shift');
    await page.mouse.click(x, y);
    await page.keyboard.up('Shift');
    // The worker answers with the step.
    await page.locator('#picked', { hasText: 'Error without it' }).waitFor();
    const found = await facts(page);
    assert.deepEqual(Object.keys(found), ['Mesh', 'Material', 'Triangle', 'Nearest vertex', 'Vertex at', 'Point at', 'Step', 'Error without it']);
    const number = (text) => Number(text.replaceAll(',', '').match(/\d+/)[0]);
    const check = await page.evaluate(({ triangle, vertex }) => {
      let mesh;
      window.striataViewer.model.traverse((object) => (mesh ??= object.isMesh ? object : undefined));
      const { index, attributes } = mesh.geometry;
      const corners = [0, 1, 2].map((i) => index.getX(3 * triangle + i));
      return { corners, position: [0, 1, 2].map((i) => attributes.position.getComponent(vertex, i)) };
    }, { triangle: number(found.Triangle), vertex: number(found['Nearest vertex']) });
    assert.ok(check.corners.includes(number(found['Nearest vertex'])));
    const coordinates = found['Vertex at'].split(', ').map(Number);
    assert.ok(Math.hypot(...coordinates.map((value, i) => value - check.position[i])) < 1e-4, `${coordinates} is at ${check.position}`);
    // The camera looks at the middle of the sphere, so the point is on the line between both.
    const eye = await eyeOf(page);
    const point = found['Point at'].split(', ').map(Number);
    const along = point.reduce((sum, value, i) => sum + value * eye[i], 0) / (Math.hypot(...point) * Math.hypot(...eye));
    assert.ok(along > 0.9999, `the point is under the pointer: ${along}`);
    await shot(page, 'picked');
    await slide(page, 'detail', 100);
    await page.locator('#picked').waitFor({ state: 'hidden' });
    await page.keyboard.press('i');
    await page.mouse.click(x, y);
    await page.locator('#picked').waitFor();
    await page.locator('#coloring input[value="triangles"]').check({ force: true });
    await settled(page);
    await page.mouse.click(x, y);
    await page.locator('#picked').waitFor();
    assert.deepEqual(Object.keys(await facts(page)), ['Mesh', 'Triangle', 'Vertex at', 'Point at'], 'colored triangles have no vertices of the model');
    await page.locator('#unpick').click();
    assert.equal(await page.locator('#picked').isVisible(), false);
  });

  pageTest(world, 'the mark follows a pose, and both halves of a comparison can be picked', {}, async (page) => {
    await openModel(world, page, 'arm.stri');
    await page.keyboard.press('i');
    await page.keyboard.press('b');
    await page.waitForFunction(() => window.striataViewer.comparison.triangleCount !== null);
    await settled(page);
    const hit = await page.evaluate(() => {
      const { stage } = window.striataViewer;
      const { left, top, width, height } = stage.renderer.domElement.getBoundingClientRect();
      const gl = stage.renderer.getContext();
      stage.render();
      const pixel = new Uint8Array(4);
      const colorAt = (x, y) => (gl.readPixels(x, gl.drawingBufferHeight - y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel), pixel.join());
      const background = colorAt(2, 5);
      const found = { left: null, right: null };
      const ratio = gl.drawingBufferWidth / width;
      for (let y = 20; y < height - 20; y += 9) {
        for (let x = 20; x < width - 20; x += 9) {
          const side = x < width / 2 - 40 ? 'left' : x > width / 2 + 40 ? 'right' : null;
          const around = [[0, 0], [6, 0], [-6, 0], [0, 6], [0, -6]].every(([i, j]) => colorAt(ratio * (x + i), ratio * (y + j)) !== background);
          if (side && around) found[side] ??= [left + x, top + y];
        }
      }
      return found;
    });
    for (const side of ['left', 'right']) {
      assert.ok(hit[side], `the arm is at the ${side}`);
      await page.mouse.click(...hit[side]);
      await page.locator('#picked').waitFor();
      await settled(page);
      assert.equal(await page.locator('#picked').isVisible(), true, `picked at the ${side}`);
    }
  });

  pageTest(world, 'back faces are shown, hidden or tinted, and vertex colors can be hidden', {}, async (page) => {
    await page.goto(world.url);
    await dropped(page, 'front.ply', redTriangle(true));
    const front = await meanColor(page);
    assert.equal(await page.locator('#vertex-colors').isVisible(), true);
    assert.ok(front[0] > front[1] && front[0] > front[2], `red: ${front}`);
    await page.locator('#vertex-colors').uncheck();
    const clay = await meanColor(page);
    assert.ok(clay[1] > front[1] + 3, `without colors it is clay: ${clay}`);
    await page.locator('#vertex-colors').check();
    assert.ok(differ(await meanColor(page), front) < 0.5, 'the colors return');
    await dropped(page, 'back.ply', redTriangle(false));
    await page.locator('summary', { hasText: 'Light' }).click();
    const colors = {};
    for (const backs of ['both', 'hide', 'tint', 'file']) {
      await page.locator('#backs').selectOption(backs);
      colors[backs] = await meanColor(page);
    }
    const background = await page.evaluate(() => {
      const { stage, model } = window.striataViewer;
      model.visible = false;
      stage.render();
      return null;
    }).then(() => meanColor(page));
    assert.ok(differ(colors.hide, background) < 0.5, 'a hidden back leaves the background');
    assert.ok(differ(colors.both, background) > 3, 'a back that is shown');
    assert.ok(colors.tint[2] - background[2] > colors.both[2] - background[2] + 3, `a tinted back is blue: ${colors.tint}`);
    await openModel(world, page, 'icosphere.stri');
    assert.equal(await page.locator('#vertex-colors').isVisible(), false, 'a model without colors has no switch for them');
  });

  pageTest(world, 'light turns and brightens, in the studio and under lamps', {}, async (page) => {
    for (const model of ['icosphere.stri', 'arm.stri']) {
      await openModel(world, page, model);
      const [before, eye] = [await meanColor(page), await eyeOf(page)];
      await page.keyboard.down('Alt');
      const [x, y] = await middle(page);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 120, y, { steps: 4 });
      await page.mouse.up();
      await page.keyboard.up('Alt');
      assert.ok((await page.locator('#light').inputValue()) > 30, 'Alt and drag turns the light');
      assert.deepEqual(await eyeOf(page), eye, 'and not the camera');
      assert.ok(differ(await meanColor(page), before) > 0.2, `${model} looks different`);
      await page.locator('#view').focus();
      for (const key of [',', '.']) await page.keyboard.press(key);
      await slide(page, 'light', 0);
      await slide(page, 'exposure', 1.5);
      const bright = await meanColor(page);
      assert.ok(bright.every((value, i) => value >= before[i]) && differ(bright, before) > 2, `${model} is brighter`);
      await slide(page, 'exposure', 0);
      assert.ok(differ(await meanColor(page), before) < 0.5);
    }
  });

  pageTest(world, 'plots show frames, triangles and bytes, and are folded at first', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    assert.equal(await page.locator('#plot').isVisible(), false);
    await page.keyboard.press('g');
    await page.locator('#plot').waitFor();
    await slide(page, 'detail', 500);
    await settled(page);
    const { triangleCount } = await state(page);
    const label = new RegExp(`Frame time [\\d.]+ ms.*Triangles ${triangleCount.toLocaleString('en')}, Loaded \\d`);
    await page.waitForFunction((source) => new RegExp(source).test(document.getElementById('plot').getAttribute('aria-label')), label.source);
    const inked = await page.evaluate(() => {
      const canvas = document.getElementById('plot');
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return data.filter((value, at) => at % 4 === 3 && value > 0).length;
    });
    assert.ok(inked > 500, `${inked} pixels`);
    await shot(page, 'plots');
  });
}
