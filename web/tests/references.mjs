// three.js' pictures of the shots that the command's tests compare with are those that are stored.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { PATIENCE_MS } from './harness.mjs';
import { stored, takeStored } from './reference.mjs';

/** Mean difference of two PNG files in 255 levels, computed in a page. */
async function meanDifference(page, ...files) {
  return page.evaluate(async (addresses) => {
    const pixels = await Promise.all(addresses.map(async (address) => {
      const bitmap = await createImageBitmap(await (await fetch(address)).blob());
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
    }));
    const [a, b] = pixels;
    if (a.length !== b.length) return Infinity;
    return a.reduce((sum, value, at) => sum + Math.abs(value - b[at]), 0) / a.length;
  }, files.map((file) => `data:image/png;base64,${file.toString('base64')}`));
}

export default function references(world) {
  test("stored pictures are three.js' own", { timeout: 3 * PATIENCE_MS }, async () => {
    const page = await world.context.newPage();
    try {
      for (const { name, picture } of await takeStored(world.context)) {
        const difference = await meanDifference(page, picture, readFileSync(join(stored, name)));
        assert.ok(difference < 0.5, `${name} differs by ${difference}`);
      }
    } finally {
      await page.close();
    }
  });
}
