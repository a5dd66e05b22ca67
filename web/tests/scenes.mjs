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
      const reference = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).loadAsync('/models/arm.glb');
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
    assert.ok(seen.stillDifference < 0.5, `a mean difference of ${seen.stillDifference} to three.js' own picture`);
    assert.ok(seen.moved > 1 && seen.posedDifference < 0.5, `posed: ${seen.posedDifference}; moved: ${seen.moved}`);
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
      await show('pixel', () => (model.pixelError = 0.1));
      await show('coarser', () => (model.pixelError = 50));
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
    assert.ok(counts.coarser < counts.pixel && counts.pixel <= counts.full && counts.base <= counts.coarser, JSON.stringify(counts));
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
    assert.ok(seen.lods.every((count, at) => count > seen.coarse[at]), JSON.stringify(seen));
    assert.deepEqual([seen.opened, seen.plain[1]], [[2, 1], 1]);
  });

  pageTest(world, 'single meshes and other files are scenes too', { expected: [/Failed to load resource.*404/] }, async (page) => {
    await open(page);
    const seen = await page.evaluate(async () => {
      const results = [];
      for (const name of ['icosphere.stri', 'spot.striata', 'torus.obj']) {
        const model = await new StriataLoader({ pixelError: null }).loadAsync(`/models/${name}`);
        await model.finished;
        // The level that the loader asks for may still be on its way.
        for (let wait = 0; wait < 1000 && model.triangleCount !== model.fullTriangleCount; wait++) await new Promise((go) => setTimeout(go, 20));
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
    assert.deepEqual(seen.errors.map((code) => code === 'format' || code === 'corrupt'), [true, false]);
    assert.equal(seen.errors[1], 'not-found');
  });

  pageTest(world, 'a throttled scene is recognizable after a part of its bytes', {}, async (page) => {
    await open(page);
    server.state.rate = 2000;
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
  });
}
