// Tests of batches of levels in a browser: pictures, shadows, and what a switch of levels uploads.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { run, shot } from './harness.mjs';
import { note, pageTest } from './pages.mjs';
import { staticServer, web } from './static.mjs';

export default function batches(world) {
  let server;
  before(async () => {
    server = await staticServer(world.folder);
    const arm = join(web, '../assets/arm.glb');
    run('encode', '-q', arm, '-o', join(world.folder, 'arm.stri'));
    run('encode', '-q', arm, '-o', join(world.folder, 'arm-lod.glb'));
    run('build', '-q', join(web, '../assets/spot.obj.zst'), '-o', join(world.folder, 'spot-ordered.glb'), '--ranges', '4');
  });
  after(() => server?.close());

  const open = async (page) => {
    await page.goto(server.url);
    await page.waitForFunction(() => window.isReady);
  };

  pageTest(world, 'each level of a batch is the picture of its triangles', {}, async (page) => {
    await open(page);
    const seen = await page.evaluate(async () => {
      const gltf = await new GLTFLoader().loadAsync('/models/spot-ordered.glb');
      const batch = await batchLevels(gltf, { maxInstances: 1 });
      const { levels, targets } = gltf.parser.json.meshes[0].primitives[0].extensions.STRIATA_order;
      const { array } = await gltf.parser.getDependency('accessor', targets);
      const source = gltf.scene.getObjectByProperty('isMesh', true);
      const instance = batch.addInstance(new THREE.Matrix4());
      look(source);
      /** Triangles of a level by the rule of the extension. */
      const indicesOf = (vertices) => {
        const map = [], list = [], full = source.geometry.index.array;
        for (let i = 0; i < array.length; i++) map[i] = i < vertices ? i : map[array[i]];
        for (let i = 0; i < full.length; i += 3) {
          const [a, b, c] = [map[full[i]], map[full[i + 1]], map[full[i + 2]]];
          if (a !== b && b !== c && c !== a) list.push(a, b, c);
        }
        return list;
      };
      return levels.map(([vertices, triangles], level) => {
        // A tolerance between the errors of this level and the next coarser one.
        const distance = camera.position.distanceTo(source.geometry.boundingSphere.center) - source.geometry.boundingSphere.radius;
        const pixelsPerUnit = 300 / (2 * distance * Math.tan((35 * Math.PI) / 360));
        batch.update(camera, 300, levels[level][2] * pixelsPerUnit * (1 + 1e-9));
        scene.add(batch);
        const own = pixels();
        const drawn = renderer.info.render.triangles;
        scene.remove(batch);
        const geometry = new THREE.BufferGeometry();
        geometry.attributes = source.geometry.attributes;
        geometry.setIndex(indicesOf(vertices));
        const plain = new THREE.Mesh(geometry, source.material);
        scene.add(plain);
        const other = pixels();
        scene.remove(plain);
        return { level, shown: batch.levelAt(instance), drawn, triangles, oracle: geometry.index.count / 3, difference: difference(own, other), area: own.filter((x) => x > 0).length };
      });
    });
    for (const { level, shown, drawn, triangles, oracle, difference, area } of seen) {
      assert.deepEqual([shown, drawn, oracle], [level, triangles, triangles]);
      assert.ok(area > 0 && difference < 0.05, `level ${level}: a mean difference of ${difference}`);
    }
    assert.ok(seen.length > 8);
  });

  pageTest(world, 'a switch of levels uploads neither vertices nor indices', {}, async (page) => {
    await open(page);
    const seen = await page.evaluate(async () => {
      const gl = renderer.getContext();
      let uploads = {};
      for (const name of ['bufferData', 'bufferSubData', 'texImage2D', 'texSubImage2D', 'texImage3D', 'texSubImage3D']) {
        const call = gl[name].bind(gl);
        gl[name] = (...words) => {
          const data = words.find(ArrayBuffer.isView);
          (uploads[name] ??= []).push(data?.byteLength ?? 0);
          return call(...words);
        };
      }
      const count = 400;
      const batch = await batchLevels(await new GLTFLoader().loadAsync('/models/spot-ordered.glb'), { maxInstances: count });
      for (let i = 0; i < count; i++) batch.addInstance(new THREE.Matrix4().makeTranslation(3 * (i % 20), 0, -3 * Math.floor(i / 20)));
      scene.add(batch);
      const at = (distance) => {
        camera.position.set(30, 10, distance);
        camera.lookAt(30, 0, -30);
        uploads = {};
        const changed = batch.update(camera, 300, 1);
        draw();
        return { changed, uploads, triangles: batch.triangleCount };
      };
      return { first: at(2000), near: at(20), still: at(20), far: at(300) };
    });
    const sum = (list = []) => list.reduce((total, bytes) => total + bytes, 0);
    assert.ok(sum(seen.first.uploads.bufferData) > 100_000, 'the first frame uploads the vertices and all ranges');
    assert.ok(seen.near.changed > 300 && seen.far.changed > 300 && seen.near.triangles > 10 * seen.far.triangles, JSON.stringify(seen));
    assert.equal(seen.still.changed, 0);
    for (const { uploads } of [seen.near, seen.still, seen.far]) {
      // Which instance each draw of the batch shows: three.js sends this texture whenever it sorts or culls, in frames without a switch too.
      assert.deepEqual(uploads, { texSubImage2D: [4 * 20 * 20] });
    }
    note(`a switch of ${seen.near.changed} of 400 levels uploads 0 bytes of vertices and indices, and ${sum(seen.near.uploads.texSubImage2D)} bytes of the texture of instances`);
  });

  pageTest(world, 'a batch casts the shadows of its levels', {}, async (page) => {
    await open(page);
    const seen = await page.evaluate(async () => {
      renderer.shadowMap.enabled = true;
      scene.environment = null;
      const light = new THREE.DirectionalLight(0xffffff, 3);
      light.position.set(0, 5, 1);
      light.castShadow = true;
      Object.assign(light.shadow.camera, { left: -3, right: 3, top: 3, bottom: -3 });
      const floor = new THREE.Mesh(new THREE.PlaneGeometry(6, 6).rotateX(-Math.PI / 2).translate(0, -1, 0), new THREE.MeshStandardMaterial());
      floor.receiveShadow = true;
      const gltf = await new GLTFLoader().loadAsync('/models/spot-ordered.glb');
      const source = gltf.scene.getObjectByProperty('isMesh', true);
      source.castShadow = true;
      const batch = await batchLevels(gltf, { maxInstances: 1 });
      batch.addInstance(new THREE.Matrix4());
      scene.add(light, floor);
      look(floor);
      batch.update(camera, 300, 0);
      const empty = pixels();
      const shown = (object) => {
        scene.add(object);
        const picture = pixels();
        scene.remove(object);
        return picture;
      };
      const [plain, full] = [shown(gltf.scene), shown(batch)];
      batch.update(camera, 300, 1e6);
      return { casts: batch.meshes[0].castShadow, toPlain: difference(plain, full), toEmpty: difference(empty, full), toCoarse: difference(full, shown(batch)) };
    });
    assert.ok(seen.casts && seen.toPlain < 0.05, `a mean difference of ${seen.toPlain} to the plain mesh`);
    assert.ok(seen.toEmpty > 1 && seen.toCoarse > 0.5, JSON.stringify(seen));
    await shot(page, 'batch-shadow');
  });

  pageTest(world, 'a batch of a mesh of a streamed scene', {}, async (page) => {
    await open(page);
    const seen = await page.evaluate(async () => {
      const gltf = await registerStriata(new GLTFLoader()).loadAsync('/models/arm-lod.glb');
      const streamed = await new StriataLoader().loadAsync('/models/arm.stri');
      const results = [];
      for (const [model, lods] of [[streamed, streamed.lods], [gltf, gltf.userData.striata.lods]]) {
        // Levels that have not arrived yet are waited for.
        const object = await (model.finished ?? gltf.userData.striata.finished).then(() => lods[1].meshes[0]);
        const batch = await batchLevels(model, { maxInstances: 2, object });
        const coarsest = batch.levelAt(batch.addInstance(new THREE.Matrix4()));
        const [mesh] = batch.meshes;
        const counts = [];
        let same = 0;
        for (let level = 0; level <= coarsest; level++) {
          const { start, count } = mesh.getGeometryRangeAt(level);
          const [list] = await lods[1].indices({ triangles: count / 3 });
          counts.push(count / 3);
          same += String(list) === String(mesh.geometry.index.array.subarray(start, start + count)) ? 1 : 0;
        }
        const refusal = await batchLevels(model, { maxInstances: 1 }).catch(({ code }) => code);
        results.push({ counts, same, isShared: mesh.geometry.attributes.position === object.geometry.attributes.position, refusal });
      }
      streamed.dispose();
      return results;
    });
    for (const { counts, same, isShared, refusal } of seen) {
      assert.deepEqual([same, isShared, refusal], [counts.length, true, 'unsupported']);
      assert.ok(counts.length > 6 && counts[0] === 5120 && counts.at(-1) < 50, String(counts));
    }
  });
}
