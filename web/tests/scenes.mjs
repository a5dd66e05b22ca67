<<<<<<< HEAD
// Tests of scenes: materials and light, animation, the parts of the model, and the comparison of two levels.

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

/** Number of pixels that differ between two pictures of the same size, in the columns from `from` to `to` (fractions of the width). */
function differing(one, other, from = 0, to = 1) {
  const [first, last] = [Math.round(from * one.width), Math.round(to * one.width)];
  return one.pixels.filter((pixel, at) => pixel !== other.pixels[at] && at % one.width >= first && at % one.width < last).length;
}

const row = (page, name) => page.locator('.part', { has: page.locator(`.name span:text-is("${name}")`) });

export default function scenes(world) {
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
      const plain = await picture(page);
      const toggle = page.locator('#compare');
      assert.equal(await page.locator('#divider').isVisible(), false);
      await toggle.check();
      await page.waitForFunction(() => window.striataViewer.comparison.triangleCount !== null);
      await settled(page);
      const second = await page.evaluate(() => window.striataViewer.comparison.triangleCount);
      assert.ok(second < full / 4 && second > 0, `${second} of ${full} triangles`);
      const both = await picture(page);
      assert.equal(differing(plain, both, 0, 0.49), 0, 'the left part is as before');
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
=======
// Tests of scenes on pages of their own: materials, skins, clips, levels, the plugin of GLTFLoader, a throttled line.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { run, shot } from './harness.mjs';
import { note, pageTest } from './pages.mjs';
import { staticServer, web } from './static.mjs';

const arm = join(web, '../assets/arm.glb');

export default function scenes(world) {
  let server;
  before(async () => {
    server = await staticServer(world.folder);
    run('encode', '-q', arm, '-o', join(world.folder, 'arm.stri'));
    run('encode', '-q', arm, '-o', join(world.folder, 'arm-lod.glb'));
    writeFileSync(join(world.folder, 'arm.glb'), readFileSync(arm));
  });
  after(() => server?.close());

  const open = async (page) => {
    await page.goto(server.url);
    await page.waitForFunction(() => window.isReady);
  };

  pageTest(world, 'a scene has the materials, skins and clips of its document', {}, async (page) => {
    await open(page);
    const seen = await page.evaluate(async () => {
      const manager = new THREE.LoadingManager();
      const items = [];
      manager.onStart = (url) => items.push(`start ${url}`);
      manager.onLoad = () => items.push('load');
      const model = await new StriataLoader(manager).setPath('/models/').loadAsync('arm.stri');
      scene.add(model);
      const box = look(model);
      const first = { triangles: model.triangleCount, clips: model.animations.map(({ name }) => name) };
      await model.finished;
      await settle(model);
      const still = pixels();
      const reference = await new GLTFLoader().loadAsync('/models/arm.glb');
      scene.remove(model);
      scene.add(reference.scene);
      const difference0 = difference(still, pixels());
      const pose = (root, clip) => {
        const mixer = new THREE.AnimationMixer(root);
        mixer.clipAction(clip).play();
        mixer.setTime(0.7);
        root.updateMatrixWorld(true);
      };
      pose(reference.scene, reference.animations[0]);
      const posed = pixels();
      scene.remove(reference.scene);
      scene.add(model);
      pose(model, model.animations[0]);
      const bounds = new THREE.Box3().setFromObject(model);
      const exact = new THREE.Box3().setFromObject(model, true);
      await settle(model);
      return {
        first, items, box: box.getSize(new THREE.Vector3()).toArray(), stillDifference: difference0, posedDifference: difference(posed, pixels()), moved: difference(still, posed),
        holds: bounds.expandByScalar(1e-4).containsBox(exact), size: bounds.getSize(new THREE.Vector3()).length() / exact.getSize(new THREE.Vector3()).length(),
        lods: model.lods.length, meshes: model.lods.map((lod) => lod.meshes.length), triangles: model.triangleCount, full: model.fullTriangleCount,
      };
    });
    await shot(page, 'scene-arm');
    assert.deepEqual(seen.first.clips, ['wave']);
    assert.ok(seen.items.some((item) => item.startsWith('start')) && seen.items.at(-1) === 'load', String(seen.items));
    assert.deepEqual([seen.lods, seen.meshes], [2, [1, 3]]);
    assert.ok(seen.triangles < seen.full && seen.full === 21504, `${seen.triangles} of ${seen.full}`);
    assert.ok(seen.stillDifference < 4, `a mean difference of ${seen.stillDifference} to three.js' own picture`);
    assert.ok(seen.moved > 8 && seen.posedDifference < 5, `posed: ${seen.posedDifference}; moved: ${seen.moved}`);
    assert.ok(seen.holds && seen.size < 1.5, `bounds of a posed skin: ${seen.holds}, ${seen.size}`);
  });

  pageTest(world, 'levels of a scene and of its meshes', {}, async (page) => {
    await open(page);
    const counts = await page.evaluate(async () => {
      const model = await new StriataLoader().loadAsync('/models/arm.stri');
      scene.add(model);
      look(model);
      await model.finished;
      const counts = {};
      const show = async (name, change) => {
        change();
        await settle(model);
        counts[name] = model.triangleCount;
      };
      await show('pixel', () => (model.pixelError = 1));
      await show('coarser', () => (model.pixelError = 8));
      await show('base', () => (model.detail = 0));
      await show('full', () => (model.detail = 1));
      await show('budget', () => (model.triangleBudget = 3000));
      await show('error', () => (model.maxError = 0.01));
      const [first] = model.lods;
      model.detail = 1;
      await show('own', () => (first.triangles = 500));
      counts.first = first.triangleCount;
      const [list] = await first.indices({ triangles: 100 });
      await settle(model);
      counts.list = list.length / 3;
      counts.after = first.triangleCount;
      model.coloring = 'triangles';
      await settle(model);
      counts.colored = difference(pixels(), new Uint8Array(pixels().length));
      model.coloring = 'surface';
      await settle(model);
      counts.geometry = first.meshes[0].geometry.drawRange.count / 3;
      model.dispose();
      return counts;
    });
    assert.ok(counts.coarser < counts.pixel && counts.pixel < counts.full && counts.base < counts.coarser, JSON.stringify(counts));
    assert.ok(counts.budget <= 3000 && counts.budget > 2700 && counts.error < counts.full, JSON.stringify(counts));
    assert.ok(counts.first <= 500 && counts.list <= 100 && counts.list > 50 && counts.after === counts.first, JSON.stringify(counts));
    assert.equal(counts.geometry, counts.first);
  });

  pageTest(world, 'the plugin of GLTFLoader refines meshes with streams', {}, async (page) => {
    await open(page);
    const seen = await page.evaluate(async () => {
      const gltf = await registerStriata(new GLTFLoader()).loadAsync('/models/arm-lod.glb');
      scene.add(gltf.scene);
      look(gltf.scene);
      const coarse = [];
      gltf.scene.traverse((object) => object.isMesh && coarse.push(object.geometry.index.count / 3));
      draw();
      const controller = gltf.userData.striata;
      await controller.finished;
      await settle(controller);
      const lods = [];
      gltf.scene.traverse((object) => object.isMesh && lods.push(object.lod?.triangleCount ?? 0));
      const opened = await new StriataLoader().open('/models/arm-lod.glb');
      await opened.finished;
      const plain = await new StriataLoader().loadAsync('/models/arm.glb');
      return { coarse, lods, full: controller.fullTriangleCount, opened: [opened.lods.length, opened.animations.length], plain: [plain.lods.length, plain.animations.length] };
    });
    assert.equal(seen.full, 21504);
    assert.ok(seen.lods.every((count, at) => count > 0 && (count > seen.coarse[at] || count > 100)), JSON.stringify(seen));
    assert.deepEqual([seen.opened, seen.plain[1]], [[2, 1], 1]);
  });

  pageTest(world, 'single meshes and other files are scenes too', {}, async (page) => {
    await open(page);
    const seen = await page.evaluate(async () => {
      const results = [];
      for (const name of ['icosphere.stri', 'spot.striata', 'torus.obj']) {
        const model = await new StriataLoader({ pixelError: null }).loadAsync(`/models/${name}`);
        await model.finished;
        results.push([model.kind, model.lods.length, model.triangleCount === model.fullTriangleCount, (await model.lods[0].indices({ detail: 0 }))[0].length > 0]);
        model.dispose();
      }
      const errors = [];
      for (const name of ['garbage.stri', 'missing.stri']) {
        errors.push(await new StriataLoader().loadAsync(`/models/${name}`).then(() => 'loaded', ({ code }) => code));
      }
      return { results, errors };
    });
    assert.deepEqual(seen.results.map(([, ...rest]) => rest), Array(3).fill([1, true, true]));
    assert.deepEqual(seen.results.map(([kind]) => kind), ['stream', 'striata', 'mesh']);
    assert.deepEqual(seen.errors, ['format', 'not-found']);
  });

  pageTest(world, 'a throttled scene is recognizable after a part of its bytes', {}, async (page) => {
    await open(page);
    server.state.rate = 4000;
    const seen = await page.evaluate(async () => {
      const model = await new StriataLoader().open('/models/arm.stri');
      scene.add(model);
      look(model);
      const pictures = [];
      const take = () => pictures.push([model.bytesReceived, pixels()]);
      take();
      model.addEventListener('change', take);
      await model.finished;
      await settle(model);
      const final = pixels();
      const share = pictures.map(([bytes, picture]) => [bytes, difference(picture, final)]);
      return { share, total: model.bytesTotal, blank: difference(new Uint8Array(final.length), final) };
    }).finally(() => (server.state.rate = Infinity));
    const [bytes] = seen.share.find(([, distance]) => distance < 0.15 * seen.blank) ?? [Infinity];
    note(`throttled scene: within 15 % of its final picture after ${bytes} of ${seen.total} bytes, ${seen.share.length} pictures`);
    assert.ok(seen.share.length > 3, 'it is drawn several times while it loads');
    assert.ok(bytes < 0.8 * seen.total, JSON.stringify([bytes, seen.total, seen.share.map(([, distance]) => distance)]));
  });

  pageTest(world, 'the time that choosing levels takes on the page', {}, async (page) => {
    await open(page);
    const ms = await page.evaluate(async () => {
      const model = await new StriataLoader().loadAsync('/models/arm.stri');
      scene.add(model);
      look(model);
      await model.finished;
      await settle(model);
      const meshes = model.lods.flatMap((lod) => lod.meshes);
      const frames = 500;
      const start = performance.now();
      for (let frame = 0; frame < frames; frame++) {
        camera.position.x += 1e-3;
        camera.updateMatrixWorld();
        for (const mesh of meshes) mesh.onBeforeRender(renderer, scene, camera);
        await null;
      }
      return (performance.now() - start) / frames;
    });
    note(`choosing levels of a scene of two meshes takes ${(1000 * ms).toFixed(0)} microseconds a frame`);
    assert.ok(ms < 20, `${ms} ms`);
>>>>>>> origin/drawn-web
  });
}
