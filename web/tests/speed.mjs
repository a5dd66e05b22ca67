// How fast a stream is decoded in the browser: reported, and only told apart from hopeless.

import assert from 'node:assert/strict';
import { state } from './harness.mjs';
import { note, openModel, pageTest } from './pages.mjs';

/** Far below what the slowest machine that may run this reaches. */
const HOPELESS_TRIANGLES_PER_SECOND = 20_000;

export default function speed(world) {
  pageTest(world, 'decoding speed', {}, async (page) => {
    await openModel(world, page, 'nefertiti.stri');
    const { timings, fullTriangleCount } = await state(page);
    const perSecond = fullTriangleCount / (timings.decodeMs / 1000);
    note(`decoded ${fullTriangleCount} triangles in ${timings.decodeMs.toFixed(0)} ms: ${(perSecond / 1e6).toFixed(2)} M triangles/s; levels and views built in ${timings.buildMs.toFixed(0)} ms`);
    assert.ok(perSecond > HOPELESS_TRIANGLES_PER_SECOND, `${perSecond} triangles a second`);
  });
}
