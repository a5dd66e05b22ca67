// Tests of batches of levels without a browser: triangles against the rule of levels, one set of vertices, and the choice of levels.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  Box3, BoxGeometry, Group, Matrix4, Mesh, MeshBasicMaterial, OrthographicCamera, PerspectiveCamera, Quaternion, Raycaster, SkinnedMesh, Vector3,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { levelIndices, openGlb } from '../../../examples/ordered-glb/order.mjs';

const dist = new URL('../../dist/', import.meta.url);
const { batchLevels, LevelBatch, StriataLoader } = await import(new URL('striata.js', dist));
const wasm = await WebAssembly.compile(readFileSync(new URL('striata.wasm', dist)));

const ordered = readFileSync(new URL('parts-ordered.glb', import.meta.url));
const HEIGHT = 600;

const loadOrdered = (bytes = ordered) => new GLTFLoader().parseAsync(new Uint8Array(bytes).buffer, '');

async function loadStream() {
  const bytes = readFileSync(new URL('spot.stri', import.meta.url));
  const model = await new StriataLoader(undefined, { worker: false, wasm }).parseAsync(new Uint8Array(bytes).buffer, 'spot.stri');
  await model.finished;
  return model;
}

/** Numbers from 0 to 1, the same in every run. */
function numbers(seed = 1) {
  return () => (seed = (seed * 48271) % 2147483647) / 2147483647;
}

/** The triangles of a list, in an order that depends on nothing but them. */
function sorted(indices) {
  const triangles = [];
  for (let at = 0; at < indices.length; at += 3) {
    const [a, b, c] = indices.slice(at, at + 3);
    triangles.push(String(a < b && a < c ? [a, b, c] : b < c ? [b, c, a] : [c, a, b]));
  }
  return triangles.sort();
}

/** Indices of a level of a batched mesh, as three.js draws them. */
function drawn(mesh, level) {
  const { start, count } = mesh.getGeometryRangeAt(level);
  return Array.from(mesh.geometry.index.array.subarray(start, start + count));
}

/** Places an instance at random. */
function somewhere(random, distance = 40) {
  const turn = new Quaternion(random() - 0.5, random() - 0.5, random() - 0.5, random() - 0.5).normalize();
  const place = new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).multiplyScalar(distance);
  return new Matrix4().compose(place, turn, new Vector3(1, 1, 1).multiplyScalar(0.5 + random()));
}

test('levels of an ordered GLB are those of the rule, over the vertices of the file', async () => {
  const gltf = await loadOrdered();
  const batch = await batchLevels(gltf, { maxInstances: 4 });
  const { json, integers } = openGlb(new Uint8Array(ordered));
  const primitives = json.nodes.filter(({ mesh }) => mesh !== undefined).flatMap(({ mesh }) => json.meshes[mesh].primitives);
  assert.equal(batch.meshes.length, primitives.length);
  let count = 0;
  primitives.forEach((primitive, part) => {
    const { levels, targets } = primitive.extensions.STRIATA_order;
    const full = integers(primitive.indices);
    levels.forEach(([vertices], level) => {
      assert.deepEqual(sorted(drawn(batch.meshes[part], level)), sorted(levelIndices(full, integers(targets), vertices)), `part ${part}, level ${level}`);
      count += 1;
    });
  });
  assert.ok(count > 12, `${count} levels`);
  // The attributes are those that the loader made, once for all parts that share them.
  const sources = [];
  gltf.scene.traverse((object) => object.isMesh && sources.push(object.geometry));
  batch.meshes.forEach((mesh, part) => {
    for (const [name, attribute] of Object.entries(mesh.geometry.attributes)) assert.equal(attribute, sources[part].attributes[name]);
  });
});

test('levels of a stream have the triangles and errors that the scene shows', async () => {
  const model = await loadStream();
  const batch = await batchLevels(model, { maxInstances: 1 });
  const [lod] = model.lods;
  const [mesh] = batch.meshes;
  const seen = [];
  const camera = new PerspectiveCamera(50, 1, 0.01, 1e4);
  const instance = batch.addInstance(new Matrix4());
  assert.equal(batch.triangleCount, drawn(mesh, batch.levelAt(instance)).length / 3);
  // An instance begins at the coarsest level.
  const coarsest = batch.levelAt(instance);
  for (let level = 0; level <= coarsest; level++) {
    const triangles = drawn(mesh, level).length / 3;
    model.triangleBudget = triangles;
    await model.finished;
    await new Promise((go) => setTimeout(go, 30));
    const [list] = await lod.indices({ triangles });
    assert.deepEqual(sorted(drawn(mesh, level)), sorted([...list]));
    assert.equal(model.triangleCount, triangles);
    seen.push({ triangles, error: lod.shownError });
  }
  assert.ok(seen.length > 6 && seen[0].triangles === 5856 && seen.at(-1).triangles < 40, JSON.stringify(seen));
  // Just within the distance at which an error covers a pixel, the level is a finer one; just beyond it, it is this one or a coarser one.
  const { radius, center } = lod.meshes[0].geometry.boundingSphere;
  seen.slice(1).forEach(({ error }, at) => {
    const distance = (error * HEIGHT) / (2 * Math.tan((50 * Math.PI) / 360));
    for (const [factor, isCoarse] of [[0.99, false], [1.01, true]]) {
      camera.position.copy(center).add(new Vector3(0, 0, radius + factor * distance));
      batch.update(camera, HEIGHT, 1);
      assert.equal(batch.levelAt(instance) > at, isCoarse, `level ${at + 1} at ${factor} of its distance: ${batch.levelAt(instance)}`);
    }
  });
  model.dispose();
});

/** The level of a mesh by the formula of the guide, step by step. */
function expectedLevel(levels, sphere, mesh, toWorld, camera, pixels) {
  const world = toWorld.clone().multiply(mesh);
  const scale = world.getMaxScaleOnAxis();
  const ball = sphere.clone().applyMatrix4(world);
  const eye = new Vector3().setFromMatrixPosition(camera.matrixWorld);
  const covered = (error) => {
    if (camera.isOrthographicCamera) return (error * scale * HEIGHT * camera.zoom) / (camera.top - camera.bottom);
    const distance = Math.max(eye.distanceTo(ball.center) - ball.radius, camera.near);
    return (error * scale * HEIGHT * camera.zoom) / (2 * distance * Math.tan((camera.fov * Math.PI) / 360));
  };
  let level = 0;
  levels.forEach(([, , error], row) => { if (covered(error) <= pixels) level = row; });
  return level;
}

test('each instance has the level that its size on the screen needs', async () => {
  const random = numbers();
  const gltf = await loadOrdered();
  const batch = await batchLevels(gltf, { maxInstances: 300 });
  const parent = new Group();
  parent.add(batch);
  parent.position.set(3, -2, 5);
  parent.rotation.set(0.3, 1, -0.4);
  parent.scale.setScalar(1.7);
  const places = Array.from({ length: 300 }, () => somewhere(random));
  places.forEach((place, instance) => assert.equal(batch.addInstance(place), instance));
  const meshes = [];
  gltf.scene.updateMatrixWorld(true);
  gltf.scene.traverse((object) => object.isMesh && meshes.push(object));
  const { json } = openGlb(new Uint8Array(ordered));
  const tables = json.nodes.filter(({ mesh }) => mesh !== undefined).flatMap(({ mesh }) => json.meshes[mesh].primitives).map(({ extensions }) => extensions.STRIATA_order.levels);
  const cameras = [
    new PerspectiveCamera(50, 1.5, 0.1, 1e3), new PerspectiveCamera(5, 1.5, 0.1, 1e3), new PerspectiveCamera(90, 0.7, 4, 1e3),
    new OrthographicCamera(-30, 30, 20, -20, 0.1, 1e3), new OrthographicCamera(-3, 3, 200, -200, 0.1, 1e3),
  ];
  cameras[1].zoom = 0.7;
  cameras[4].zoom = 3;
  const used = new Set();
  for (const camera of cameras) {
    camera.position.set(random() * 30, random() * 30, 20 + random() * 60);
    camera.lookAt(0, 0, 0);
    camera.updateProjectionMatrix();
    for (const pixels of [0.1, 1, 7]) {
      const before = places.map((_, instance) => meshes.map((_, part) => batch.levelAt(instance, part)));
      const changed = batch.update(camera, HEIGHT, pixels);
      let differences = 0;
      let triangles = 0;
      places.forEach((place, instance) => meshes.forEach((mesh, part) => {
        const toWorld = parent.matrixWorld.clone().multiply(place);
        const expected = expectedLevel(tables[part], mesh.geometry.boundingSphere, mesh.matrixWorld, toWorld, camera, pixels);
        assert.equal(batch.levelAt(instance, part), expected, `instance ${instance}, part ${part}`);
        used.add(expected);
        triangles += tables[part][expected][1];
        if (before[instance][part] !== expected) differences += 1;
      }));
      assert.equal(changed, differences);
      assert.equal(batch.triangleCount, triangles);
      assert.equal(batch.update(camera, HEIGHT, pixels), 0);
    }
  }
  assert.ok(used.size > 6, `${used.size} different levels`);
});

test('a group that is stretched refines at least as much as each of its axes needs', async () => {
  const batch = await batchLevels(await loadOrdered(), { maxInstances: 1 });
  const instance = batch.addInstance(new Matrix4());
  const camera = new PerspectiveCamera(50, 1, 0.1, 1e3);
  camera.position.set(0, 0, 30);
  batch.update(camera, HEIGHT, 1);
  const even = batch.levelAt(instance);
  batch.scale.set(4, 1, 1);
  batch.update(camera, HEIGHT, 1);
  assert.ok(batch.levelAt(instance) < even, `${batch.levelAt(instance)} and ${even}`);
});

test('instances are added, moved, hidden and deleted', async () => {
  const batch = await batchLevels(await loadOrdered(), { maxInstances: 3 });
  assert.ok(batch instanceof LevelBatch && batch.isLevelBatch);
  assert.deepEqual([0, 1, 2].map(() => batch.addInstance(new Matrix4())), [0, 1, 2]);
  assert.throws(() => batch.addInstance(new Matrix4()), /Maximum item count/);
  const one = batch.triangleCount / 3;
  batch.deleteInstance(1);
  assert.deepEqual([batch.instanceCount, batch.triangleCount], [2, 2 * one]);
  const camera = new PerspectiveCamera(50, 1, 0.001, 1e6);
  camera.position.set(0, 0, 5);
  assert.equal(batch.update(camera, HEIGHT, 0), 2 * batch.meshes.length);
  assert.deepEqual([batch.levelAt(0), batch.levelAt(2)], [0, 0]);
  assert.equal(batch.addInstance(new Matrix4().makeTranslation(0, 0, -1e5)), 1);
  batch.update(camera, HEIGHT, 1);
  assert.ok(batch.levelAt(1) > batch.levelAt(0));
  batch.setMatrixAt(1, new Matrix4()).setVisibleAt(2, false);
  batch.update(camera, HEIGHT, 1);
  assert.equal(batch.levelAt(1), batch.levelAt(0));
  batch.dispose();
});

test('rays meet the level that is shown', async () => {
  const batch = await batchLevels(await loadOrdered(), { maxInstances: 2 });
  batch.addInstance(new Matrix4().makeTranslation(-1e3, 0, 0));
  const instance = batch.addInstance(new Matrix4());
  const camera = new PerspectiveCamera(50, 1, 0.1, 1e4);
  const box = new Box3().setFromObject(batch.meshes[0]);
  assert.ok(!box.isEmpty());
  camera.position.set(0, 0, 50);
  const hits = [1e-9, 3].map((pixels) => {
    batch.update(camera, HEIGHT, pixels);
    batch.updateMatrixWorld(true);
    return new Raycaster(new Vector3(0.01, 0.02, 50), new Vector3(0, 0, -1)).intersectObject(batch);
  });
  assert.ok(batch.levelAt(instance) > 1);
  for (const seen of hits) assert.ok(seen.length > 0 && seen.every(({ batchId }) => batchId === instance), JSON.stringify(seen.map(({ batchId }) => batchId)));
  assert.ok(hits[0].length <= 8, `${hits[0].length} hits: those of one level`);
});

test('damaged levels are ignored, and models without meshes or with skins are refused', async (context) => {
  const warn = context.mock.method(console, 'warn', () => {});
  const { json } = openGlb(new Uint8Array(ordered));
  const { targets } = json.meshes[0].primitives[0].extensions.STRIATA_order;
  const view = json.bufferViews[json.accessors[targets].bufferView];
  const damaged = Buffer.from(ordered);
  const start = 28 + ordered.readUInt32LE(12) + (view.byteOffset ?? 0) + (json.accessors[targets].byteOffset ?? 0);
  damaged.writeUInt32LE(json.accessors[targets].count, start + 4);
  const batch = await batchLevels(await loadOrdered(damaged), { maxInstances: 1 });
  assert.equal(batch.levelAt(batch.addInstance(new Matrix4())), 0);
  assert.ok(warn.mock.callCount() > 0);
  const empty = { parser: {}, scene: new Group(), userData: {} };
  await assert.rejects(batchLevels(empty, { maxInstances: 1 }), { code: 'unsupported' });
  const posed = new SkinnedMesh(new BoxGeometry(), new MeshBasicMaterial());
  await assert.rejects(batchLevels({ ...empty, scene: new Group().add(posed) }, { maxInstances: 1 }), ({ code, message }) => code === 'unsupported' && /skin/.test(message));
  // Meshes without levels are drawn at full detail.
  const plain = { parser: { json: {}, associations: new Map() }, scene: new Group().add(posed, new Mesh(new BoxGeometry().toNonIndexed())), userData: {} };
  const boxes = await batchLevels(plain, { maxInstances: 1, object: plain.scene.children[1] });
  boxes.addInstance(new Matrix4());
  assert.equal(boxes.triangleCount, 12);
});
