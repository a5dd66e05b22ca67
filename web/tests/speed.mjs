// Measures how fast a stream is decoded in the browser; reported only, since machines differ.

import assert from 'node:assert/strict';
import { state, untilWhole } from './harness.mjs';
import { note, pageTest } from './pages.mjs';

/** The best of this many attempts counts; the first one also compiles. */
const TRIES = 3;

export default function speed(world) {
  pageTest(world, 'decoding speed', {}, async (page) => {
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    // Rendering runs on the CPU here and would slow down the decoder.
    await page.evaluate(() => (window.striataViewer.stage.invalidate = () => {}));
    let best;
    for (let attempt = 0; attempt < TRIES; attempt += 1) {
      const url = new URL('models/nefertiti.stri', world.url).href;
      await page.evaluate((url) => window.striataViewer.open({ data: url, name: 'nefertiti.stri', url }), url);
      await untilWhole(page);
      const now = await state(page);
      if (!best || now.timings.decodeMs < best.timings.decodeMs) best = now;
    }
    const { timings, fullTriangleCount } = best;
    const perSecond = fullTriangleCount / (timings.decodeMs / 1000);
    note(`decoded ${fullTriangleCount} triangles in ${timings.decodeMs.toFixed(0)} ms: ${(perSecond / 1e6).toFixed(2)} M triangles/s; views prepared in ${timings.buildMs.toFixed(0)} ms`);
    assert.equal(fullTriangleCount, 99_938);
  });
}
