// Tests of the packaged engine of scenes, without three.js: streams cut anywhere, damage, targets for all meshes.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, test } from 'node:test';

const dist = new URL('../../dist/', import.meta.url);
const { initialize, SceneEngine, SceneModel } = await import(new URL('core.js', dist));
const stream = readFileSync(new URL('arm.stri', import.meta.url));

before(() => initialize(readFileSync(new URL('striata.wasm', dist))));

/** Collects an engine's reports on some bytes until it has finished or failed. */
function reportsTo(pieces, error) {
  return new Promise((resolve) => {
    const reports = [];
    const engine = new SceneEngine((report) => {
      reports.push(report);
      if (report.type === 'finished' || report.type === 'failed') resolve({ reports, engine });
    }, 5);
    for (const bytes of pieces) engine.take({ type: 'bytes', bytes });
    engine.take({ type: 'end', ...(error && { error }) });
  });
}

function pieces(bytes, length) {
  return Array.from({ length: Math.ceil(bytes.length / length) }, (_, at) => bytes.subarray(at * length, (at + 1) * length));
}

const target = (change) => ({
  meshes: [{ mesh: 0, scale: 1, instances: 1 }, { mesh: 1, scale: 1, instances: 3 }], tolerance: 0, limit: 0, ...change,
});

/** Shows a target; returns the number of triangles of all instances. */
async function shown(engine, reports, change, ticket) {
  engine.take({ type: 'target', target: target(change), coloring: 'surface', ticket });
  const answer = reports.findLast((report) => report.ticket === ticket);
  for (const update of answer.meshes) counts.set(update.mesh, update.groupCounts.reduce((sum, count) => sum + count, 0));
  return counts.get(0) + 3 * counts.get(1);
}
const counts = new Map();

test('a scene arrives with its document, images and the coarse level of every mesh', async () => {
  const { reports, engine } = await reportsTo(pieces(stream, 700));
  const [first] = reports;
  assert.equal(first.type, 'document');
  assert.deepEqual(first.meshes.map(({ mesh }) => mesh), [0, 1]);
  const names = first.meshes[0].layers.map(({ name }) => name).sort();
  assert.deepEqual(names, ['JOINTS_0', 'NORMAL', 'POSITION', 'TEXCOORD_0', 'WEIGHTS_0']);
  assert.equal(JSON.parse(first.document.json).skins.length, 1);
  assert.equal(reports.at(-1).type, 'finished');
  // Updates continue where the last one ended.
  const next = new Map();
  for (const { meshes = [] } of reports) {
    for (const { mesh, first, layers, vertexCount, indices } of meshes) {
      if (layers.length > 0) assert.equal(first, next.get(mesh) ?? 0);
      next.set(mesh, vertexCount);
      for (const { values, itemSize } of layers) assert.equal(values.length, (vertexCount - first) * itemSize);
      assert.ok(indices?.every((index) => index < vertexCount) ?? true);
    }
  }
  engine.dispose();
});

test('the full level is shown as it arrives', async () => {
  const levels = new Map();
  let end;
  const ended = new Promise((resolve) => (end = resolve));
  const engine = new SceneEngine((report) => {
    if (report.type === 'document') {
      queueMicrotask(() => engine.take({ type: 'target', target: target({ detail: 1 }), coloring: 'surface', ticket: 1 }));
    }
    for (const { mesh, splitCount, stepCount, indices } of report.meshes ?? []) {
      if (indices) levels.set(mesh, [splitCount, stepCount]);
    }
    if (report.type === 'finished' || report.type === 'failed') end(report.type);
  }, 5);
  for (const bytes of pieces(stream, 1500)) {
    engine.take({ type: 'bytes', bytes });
    // Longer than the engine waits between two updates.
    await new Promise((resolve) => setTimeout(resolve, 80));
  }
  engine.take({ type: 'end' });
  assert.equal(await ended, 'finished');
  for (const [mesh, [splitCount, stepCount]] of levels) assert.equal(splitCount, stepCount, `mesh ${mesh}`);
  assert.equal(levels.size, 2);
  engine.dispose();
});

test('targets of a scene are distributed by one priority', async () => {
  const { reports, engine } = await reportsTo([stream]);
  const full = await shown(engine, reports, { tolerance: 0 }, 1);
  assert.equal(full, 21504);
  const base = await shown(engine, reports, { tolerance: Number.MAX_VALUE }, 2);
  assert.ok(base < 200, `${base}`);
  let ticket = 3;
  for (const limit of [base + 50, 1000, 5000, 20_000]) {
    const count = await shown(engine, reports, { limit }, ticket++);
    assert.ok(count <= limit && count >= 0.9 * limit, `${count} of ${limit}`);
  }
  const half = await shown(engine, reports, { detail: 0.5 }, ticket++);
  assert.ok(half > base && half < full);
  // A mesh that covers more pixels gets more triangles.
  engine.take({ type: 'target', target: { ...target({ limit: 3000 }), meshes: [{ mesh: 0, scale: 1000, instances: 1 }, { mesh: 1, scale: 0.001, instances: 3 }] }, coloring: 'surface', ticket: 99 });
  for (const update of reports.at(-1).meshes) counts.set(update.mesh, update.groupCounts.reduce((sum, count) => sum + count, 0));
  assert.ok(counts.get(0) > 5 * counts.get(1), `${counts.get(0)} and ${counts.get(1)}`);
  // A level of its own.
  engine.take({ type: 'indices', mesh: 0, request: { by: 'triangles', value: 500, limit: 0 }, id: 7 });
  const { id, lists } = reports.at(-1);
  assert.ok(id === 7 && lists.length === 1 && lists[0].length <= 1500 && lists[0].length > 1000, `${lists[0].length}`);
  engine.dispose();
});

test('a cut stream gives the part that has arrived', async () => {
  for (const share of [0.5, 0.8, 0.97]) {
    const { reports, engine } = await reportsTo(pieces(stream.subarray(0, share * stream.length), 1000));
    assert.equal(reports[0].type, 'document', `${share}`);
    assert.deepEqual([reports.at(-1).type, reports.at(-1).error.code], ['failed', 'corrupt']);
    engine.dispose();
  }
  const { reports } = await reportsTo([stream.subarray(0, 300)]);
  assert.deepEqual(reports.map(({ type }) => type), ['failed']);
  const lost = { code: 'network', message: 'gone', hint: undefined };
  assert.equal((await reportsTo([stream.subarray(0, stream.length - 1000)], lost)).reports.at(-1).error.code, 'network');
});

test('damage ends with an error and never with a trap', async () => {
  for (let at = 0; at < stream.length; at += 397) {
    const damaged = Uint8Array.from(stream);
    damaged[at] ^= 0x55;
    const { reports, engine } = await reportsTo(pieces(damaged, 3000));
    const last = reports.at(-1);
    assert.equal(last.type, 'failed', `byte ${at}`);
    assert.ok(['format', 'corrupt', 'unsupported', 'too-large'].includes(last.error.code) && last.error.message, last.error.code);
    engine.dispose();
  }
});

test('a scene model names what is missing', () => {
  const scene = new SceneModel();
  scene.push(stream.subarray(0, 100));
  assert.ok(!scene.has_document && !scene.is_drawable && scene.mesh_count === 0);
  assert.throws(() => scene.document(), ({ message }) => /needs at least \d+ bytes/.test(message));
  scene.free();
});
