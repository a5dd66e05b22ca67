// Tests of the packaged low-level API: streams in slices, truncated and damaged; the engine's reports; compressed files.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, test } from 'node:test';
import { gzipSync } from 'node:zlib';

const dist = new URL('../../dist/', import.meta.url);
const { Engine, initialize, Model, StreamPlace, StriataError, View, asStriataError } = await import(new URL('core.js', dist));
const asset = (name) => readFileSync(new URL(`../../../assets/${name}`, import.meta.url));
const stream = readFileSync(new URL('spot.stri', import.meta.url));
const TRIANGLES = 5856;

before(() => initialize(readFileSync(new URL('striata.wasm', dist))));

/** Collects an engine's reports on some orders until it has finished or failed. */
function reportsTo(orders) {
  return new Promise((resolve) => {
    const reports = [];
    const engine = new Engine((report) => {
      reports.push(report);
      if (report.type === 'finished' || report.type === 'failed') resolve({ reports, engine });
    }, 5);
    orders.forEach((order) => engine.take(order));
  });
}

function slices(bytes, length) {
  const orders = [];
  for (let at = 0; at < bytes.length; at += length) orders.push({ type: 'bytes', bytes: bytes.subarray(at, at + length) });
  return orders;
}

test('a stream decodes in slices of any length', () => {
  let whole;
  for (const length of [1, 97, 4096, stream.length]) {
    const model = new Model();
    for (let at = 0; at < stream.length; at += length) model.push(stream.subarray(at, at + length));
    assert.equal(model.is_complete, true);
    model.reveal();
    model.show_detail(1);
    assert.equal(model.indices().length, 3 * TRIANGLES);
    const positions = model.vertices(0).take_positions();
    assert.equal(positions.length, 3 * model.vertex_count);
    whole ??= positions;
    assert.deepEqual(positions, whole);
    model.free();
  }
});

test('levels and views of a model', () => {
  const model = new Model();
  model.push(stream);
  model.reveal();
  model.show_triangles(1000);
  assert.ok(model.indices().length <= 3000 && model.shown_error > 0);
  const [low, high] = [model.bounds().slice(0, 3), model.bounds().slice(3)];
  const middle = low.map((x, i) => (x + high[i]) / 2);
  const counts = [2, 20, 200].map((distance) => {
    const eye = [middle[0], middle[1], middle[2] + distance * model.diagonal];
    const view = new View(Float64Array.of(...eye, ...middle, 0, 1, 0, 0.5, 800, 600), 1, 0);
    assert.equal(model.show_view(view), true);
    return model.indices().length / 3;
  });
  assert.ok(counts[0] > counts[1] && counts[1] > counts[2] && counts[0] < TRIANGLES, String(counts));
  model.free();
});

test('an engine reports progress and completion', async () => {
  const { reports, engine } = await reportsTo([...slices(stream, 500), { type: 'end' }]);
  const updates = reports.filter(({ type }) => type === 'update');
  // The mesh is closed.
  assert.deepEqual(reports.slice(-2).map(({ type }) => type), ['finished', 'solid']);
  let vertexCount = 0;
  for (const { vertices, indices, state } of updates) {
    if (vertices) {
      assert.equal(vertices.first, vertexCount);
      vertexCount += vertices.positions.length / 3;
    }
    assert.ok(indices.every((index) => index < vertexCount));
    assert.equal(state.vertexCount, vertexCount);
  }
  const { state } = updates.at(-1);
  assert.deepEqual([state.complete, state.phase, state.triangleCount], [true, 'done', TRIANGLES]);
  // The engine still answers requests.
  const answer = new Promise((resolve) => reports.push = resolve);
  engine.take({ type: 'show', request: { by: 'detail', value: 0.1, limit: 0 }, coloring: 'strips', ticket: 7 });
  const update = await answer;
  assert.equal(update.ticket, 7);
  assert.equal(update.numbers.length, update.indices.length / 3);
  assert.ok(update.indices.length < 0.2 * 3 * TRIANGLES);
});

test('views are answered before all bytes are there', async () => {
  const reports = [];
  const engine = new Engine((report) => reports.push(report), 5);
  for (const order of slices(stream.subarray(0, (stream.length * 2) / 3), 1000)) engine.take(order);
  await new Promise((resolve) => setTimeout(resolve, 300));
  const { bounds, diagonal, fullTriangleCount } = reports.findLast(({ type }) => type === 'update').state;
  const middle = [0, 1, 2].map((i) => (bounds[i] + bounds[i + 3]) / 2);
  const counts = [1, 50].map((distance, at) => {
    const eye = [middle[0], middle[1], middle[2] + distance * diagonal];
    const camera = [...eye, ...middle, 0, 1, 0, 0.5, 800, 600];
    engine.take({ type: 'show', request: { by: 'view', value: 1, limit: 0, camera }, coloring: 'surface', ticket: 5 + at });
    const { ticket, settled, indices, state } = reports.at(-1);
    assert.deepEqual([ticket, settled, state.complete], [5 + at, true, false]);
    return indices.length / 3;
  });
  assert.ok(counts[0] > 2 * counts[1] && counts[0] < fullTriangleCount, String(counts));
  engine.dispose();
});

test('a truncated stream keeps the part that was decoded', async () => {
  const { reports } = await reportsTo([...slices(stream.subarray(0, stream.length >> 1), 1000), { type: 'end' }]);
  const { error } = reports.at(-1);
  assert.equal(error.code, 'corrupt');
  const last = reports.findLast(({ type }) => type === 'update');
  assert.ok(last.indices.length > 300 && !last.state.complete);
  assert.ok(last.state.shownError > 0);
  assert.equal(last.state.fullTriangleCount, TRIANGLES);
});

test('an interrupted connection is reported as a network error', async () => {
  const error = { code: 'network', message: 'gone', hint: undefined };
  const { reports } = await reportsTo([...slices(stream.subarray(0, 6000), 1000), { type: 'end', error }]);
  assert.equal(reports.at(-1).error.code, 'network');
  assert.ok(reports.some(({ type }) => type === 'update'));
});

test('damaged bytes end with an error and never with a trap', async () => {
  for (let at = 5; at < stream.length; at += 479) {
    const damaged = Uint8Array.from(stream);
    damaged[at] ^= 0x55;
    const { reports, engine } = await reportsTo([...slices(damaged, 3000), { type: 'end' }]);
    const last = reports.at(-1);
    assert.equal(last.type, 'failed', `byte ${at}`);
    assert.ok(['format', 'corrupt', 'unsupported', 'too-large'].includes(last.error.code) && last.error.message, last.error.code);
    engine.dispose();
  }
});

test('compressed streams are decompressed', async () => {
  for (const [name, bytes] of [['x.stri.gz', gzipSync(stream)], ['x.stri.gz.gz', gzipSync(gzipSync(stream))]]) {
    const { reports, engine } = await reportsTo([{ type: 'file', bytes: new Uint8Array(bytes), name }]);
    assert.equal(reports.at(-2).type, 'finished', JSON.stringify(reports.at(-1)));
    const update = reports.find(({ type }) => type === 'update');
    assert.equal(update.state.triangleCount, TRIANGLES);
    assert.ok(update.vertices.uvs, 'the asset has texture coordinates');
    engine.dispose();
  }
  const cut = asset('spot.obj.zst').subarray(0, 5000);
  const { reports } = await reportsTo([{ type: 'file', bytes: new Uint8Array(cut), name: 'spot.obj.zst' }]);
  assert.equal(reports.at(-1).error.code, 'corrupt');
});

test('a file that is not a mesh is rejected with a hint', async () => {
  const bytes = new TextEncoder().encode('hello, world');
  const { reports } = await reportsTo([{ type: 'file', bytes, name: 'hello.txt' }]);
  assert.equal(reports.at(-1).error.code, 'format');
  assert.match(reports.at(-1).error.hint, /\.striata/);
  assert.throws(() => StreamPlace.find(new Uint8Array(64)), (thrown) => asStriataError(thrown) instanceof StriataError);
});
