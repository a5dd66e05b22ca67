// Tests of links: the address follows the view, and a page that opens it shows the same.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { drop } from './files.mjs';
import { run, settled, shot, slide, state, untilWhole } from './harness.mjs';
import { eyeOf } from './phone.mjs';
import { openModel, pageTest } from './pages.mjs';

/** Waits until the address matches a pattern. */
const untilAddress = (page, pattern) => page.waitForFunction((source) => new RegExp(source).test(location.href), pattern.source);

/** Clicks the button, and returns the link that was copied. */
async function copiedLink(page) {
  await page.evaluate(() => {
    navigator.clipboard.writeText = async (text) => void (window.copied = text);
  });
  await page.locator('#copy-link').click();
  return (await page.waitForFunction(() => window.copied)).jsonValue();
}

function assertNear(found, expected, what, share = 1e-4) {
  const size = Math.hypot(...expected);
  assert.ok(Math.hypot(...found.map((value, axis) => value - expected[axis])) < share * size, `${what}: ${found} instead of ${expected}`);
}

export default function sharing(world) {
  pageTest(world, 'the address follows the view, and a page that opens it shows the same', {}, async (page) => {
    await openModel(world, page, 'spot.striata');
    await page.waitForTimeout(1500);
    assert.match(page.url(), /\?model=models\/spot\.striata$/, 'an untouched view has the shortest address');
    await slide(page, 'detail', 600);
    await page.locator('#view').focus();
    for (const key of ['ArrowRight', 'ArrowUp', '+', 'w', 'l', 'z', 's']) await page.keyboard.press(key);
    await page.keyboard.press('ArrowRight');
    await page.locator('#background').selectOption('black');
    await page.locator('summary', { hasText: 'Light' }).click();
    await slide(page, 'light', 45);
    await slide(page, 'exposure', 1);
    await page.locator('#backs').selectOption('tint');
    await untilAddress(page, /backs=tint/);
    await settled(page);
    for (const part of ['detail=0.216', 'color=strip', 'wireframe=1', 'flat=1', 'z-up=1', 'background=black', 'light=45', 'exposure=1']) {
      assert.ok(page.url().includes(`&${part}`), `${part} in ${page.url()}`);
    }
    const [eye, { triangleCount }] = [await eyeOf(page), await state(page)];
    const link = await copiedLink(page);
    assert.equal(link, page.url(), 'a still view has one link');
    const length = await page.evaluate(() => history.length);
    await page.goto('about:blank');
    await page.goto(link);
    await untilWhole(page);
    await settled(page);
    assertNear(await eyeOf(page), eye, 'the camera');
    assert.equal((await state(page)).triangleCount, triangleCount);
    const shown = await page.evaluate(() => ({ ...window.striataViewer.look, background: document.getElementById('background').value, exposure: window.striataViewer.stage.renderer.toneMappingExposure }));
    assert.deepEqual(shown, { coloring: 'strips', wireframe: true, flat: true, zUp: true, vertexColors: true, backs: 'tint', background: 'black', exposure: 2 });
    assert.ok(length < 10, `the view adds no entries to the history: ${length}`);
    await shot(page, 'shared');
  });

  pageTest(world, 'terrains lie flat by themselves, until the user or a link decides', {}, async (page) => {
    const heights = [0, 9, 0, 5, 20, 0, 0, 0, 3];
    const rows = heights.map((height, at) => `${at % 3} ${Math.floor(at / 3)} ${height}`);
    const faces = [0, 1, 3, 4].flatMap((at) => [`3 ${at} ${at + 1} ${at + 3}`, `3 ${at + 1} ${at + 4} ${at + 3}`]);
    const head = ['ply', 'format ascii 1.0', 'comment georeference {"epsg":32632}', 'element vertex 9', 'property float x', 'property float y', 'property float z'];
    writeFileSync(join(world.folder, 'hills.ply'), [...head, 'element face 8', 'property list uchar int vertex_indices', 'end_header', ...rows, ...faces, ''].join('\n'));
    run('encode', '-q', join(world.folder, 'hills.ply'), '-o', join(world.folder, 'hills.stri'));
    run('build', '-q', join(world.folder, 'hills.ply'), '--paged', '-o', join(world.folder, 'hills.striata'));
    run('convert', '-q', join(world.folder, 'hills.ply'), join(world.folder, 'hills.glb'));
    const up = () => page.evaluate(() => [window.striataViewer.look.zUp, document.getElementById('z-up').checked, window.striataViewer.stage.pivot.rotation.x < 0]);
    const open = async (name) => {
      await page.goto(`${world.url}?model=models/${name}`);
      await untilWhole(page);
      return up();
    };
    assert.deepEqual(await open('hills.stri'), [true, true, true], 'a stream with a georeference');
    assert.deepEqual(await open('hills.striata'), [true, true, true], 'a paged file with one');
    assert.deepEqual(await open('sub/terrain.stri'), [true, true, true], 'a mesh as flat along z as a terrain');
    assert.deepEqual(await open('nefertiti.stri'), [false, false, false]);
    assert.deepEqual(await open('hills.glb'), [false, false, false], 'glTF is y up');
    const height = await page.evaluate(() => {
      window.striataViewer.model.updateMatrixWorld(true);
      const heights = [];
      window.striataViewer.model.traverse((mesh) => {
        const places = mesh.geometry?.getAttribute('position');
        for (let at = 0; at < (places?.count ?? 0); at += 1) heights.push(mesh.position.clone().fromBufferAttribute(places, at).applyMatrix4(mesh.matrixWorld).y);
      });
      return Math.max(...heights) - Math.min(...heights);
    });
    assert.ok(Math.abs(height - 20) < 0.1, `the heights are along y: ${height}`);
    await open('hills.stri');
    await page.locator('#view').focus();
    await page.keyboard.press('z');
    await untilAddress(page, /z-up=0/);
    await page.reload();
    await untilWhole(page);
    assert.deepEqual(await up(), [false, false, false], 'the link decides');
  });

  pageTest(world, 'the first picture is the one of the link', {}, async (page) => {
    await page.addInitScript(() => {
      window.eyes = [];
      addEventListener('DOMContentLoaded', () => setTimeout(() => {
        const { striataViewer: viewer } = window;
        viewer?.stage.beforeFrame.add(() => {
          if (viewer.model?.triangleCount) window.eyes.push(viewer.stage.camera.position.toArray());
          return false;
        });
      }));
    });
    await page.goto(`${world.url}?model=models/nefertiti.stri&eye=900,100,500&target=0,10,0&error=4`);
    await untilWhole(page);
    await page.waitForFunction(() => window.striataViewer.model.pixelError === 4);
    await settled(page);
    const eyes = await page.evaluate(() => window.eyes);
    assert.ok(eyes.length > 0);
    for (const eye of eyes) assertNear(eye, [900, 100, 500], 'the camera of each frame');
    assert.equal(await page.locator('input[name="mode"][value="pixels"]').isChecked(), true);
  });

  pageTest(world, 'a link has the time of an animation', {}, async (page) => {
    await openModel(world, page, 'arm.stri');
    await page.evaluate(() => window.striataViewer.playback.seek(0.5));
    await untilAddress(page, /time=0\.5&play=0/);
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await page.locator('#play').click();
    await page.waitForFunction(() => !location.search.includes('time'));
    const link = await copiedLink(page);
    assert.match(link, /time=[\d.]+&play=1/);
    await page.goto(`${world.url}?model=models/arm.stri&time=0.7&play=0&triangles=3000`);
    await untilWhole(page);
    await settled(page);
    const { time, isPlaying } = await page.evaluate(() => ({ time: window.striataViewer.playback.time, isPlaying: window.striataViewer.playback.isPlaying }));
    assert.deepEqual([time, isPlaying], [0.7, false]);
    const { triangleCount } = await state(page);
    assert.ok(triangleCount <= 3000 && triangleCount > 2000, `${triangleCount} triangles`);
  });

  pageTest(world, 'values that make no sense are ignored', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    const eye = await eyeOf(page);
    for (const bad of ['eye=1,2&target=0,0,0', 'eye=NaN,1,2&target=0,0,0', 'eye=1,1,1&target=1,1,1', 'detail=7&color=pink&light=x&backs=&time=-1&exposure=1e9', 'error=&triangles=-4&clip=9&__proto__=1', 'color=__proto__']) {
      await page.goto(`${world.url}?model=models/icosphere.stri&${bad}`);
      await untilWhole(page);
      await settled(page);
      // What had arrived when the model was framed differs a little from time to time.
      assertNear(await eyeOf(page), eye, bad, 0.02);
      assert.equal((await state(page)).triangleCount, 20_480, bad);
      assert.equal(await page.locator('.notice').count(), 0);
      await page.waitForFunction(() => location.search === '?model=models/icosphere.stri');
    }
  });

  pageTest(world, 'another model has a view of its own, and a local file no link', {}, async (page) => {
    await page.goto(world.url);
    await page.locator('#cards a[href*="icosphere"]').click();
    await untilWhole(page);
    await page.locator('#view').press('ArrowRight');
    await untilAddress(page, /icosphere.*eye=/);
    const eye = await eyeOf(page);
    await page.locator('#to-gallery').click();
    assert.equal(await page.locator('#copy-link').isDisabled(), true);
    await page.locator('#cards a[href*="terrain"]').click();
    await untilWhole(page);
    await settled(page);
    await page.waitForTimeout(1500);
    assert.match(page.url(), /\?model=models\/sub\/terrain\.stri$/);
    await page.goBack();
    await page.goBack();
    await untilWhole(page);
    await settled(page);
    assertNear(await eyeOf(page), eye, 'the view of the address that the page returned to');
    await drop(page, 'torus.obj', readFileSync(join(world.folder, 'torus.obj')));
    await page.waitForFunction(() => window.striataViewer.name === 'torus.obj');
    await untilWhole(page);
    await page.locator('#view').press('ArrowRight');
    await page.waitForTimeout(1500);
    assert.equal(new URL(page.url()).search, '');
    const button = page.locator('#copy-link');
    assert.equal(await button.isDisabled(), true);
    assert.match(await button.getAttribute('title'), /file on your computer/);
  });
}
