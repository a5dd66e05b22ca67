// Tests of `.striata` files without a stream, which are read whole.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const dist = new URL('../../dist/', import.meta.url);
const { StriataLoader } = await import(new URL('striata.js', dist));
const [wasm, files] = await Promise.all(['striata', 'striata-files'].map((name) => WebAssembly.compile(readFileSync(new URL(`${name}.wasm`, dist)))));
const loader = new StriataLoader(undefined, { worker: false, wasm, files, pixelError: null });
const bytes = readFileSync(new URL('spot.striata', import.meta.url));
const opened = () => loader.parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), 'spot.striata');

/** Waits until the model has at most so many triangles. */
async function reduced(model, limit) {
  while (model.triangleCount > limit) await new Promise((resolve) => model.addEventListener('change', resolve));
}

test('stored levels are shown without building them', async () => {
  const model = await opened();
  await model.finished;
  assert.equal(model.kind, 'striata');
  assert.equal(model.timings.buildMs, 0);
  const full = model.fullTriangleCount;
  assert.ok(full > 100);
  model.triangleBudget = Math.floor(full / 4);
  await reduced(model, full / 4);
  assert.ok(model.triangleCount > 0);
  model.dispose();
});

test('a damaged file is refused with its place', async () => {
  const cut = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length - 40);
  await assert.rejects(loader.parseAsync(cut, 'cut.striata'), (error) => error.code === 'corrupt' && /bytes/.test(error.message));
});
