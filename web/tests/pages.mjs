// A page for one test: opened, given to the test, checked for faults and closed, whatever happens.

import assert from 'node:assert/strict';
import { appendFileSync } from 'node:fs';
import { test } from 'node:test';
import { PATIENCE_MS, settled, shot, untilWhole } from './harness.mjs';

/** A test with a page; a page that threw or logged an error fails it. */
export function pageTest(world, name, options, work) {
  test(name, { timeout: 3 * PATIENCE_MS }, async (context) => {
    const page = await world.page(options);
    try {
      await work(page, context);
      assert.deepEqual(page.faults, [], 'the page threw or logged errors');
    } catch (error) {
      await shot(page, `failed-${name.replace(/\W+/g, '-')}`).catch(() => {});
      if (page.faults.length > 0) error.message += `\nthe page also said: ${page.faults.join('\n')}`;
      throw error;
    } finally {
      await page.close();
    }
  });
}

/** Opens a model of the server and waits until it is all there and the camera, which follows its bounds, stands still. */
export async function openModel(world, page, name) {
  await page.goto(`${world.url}?model=models/${name}`);
  await untilWhole(page);
  await settled(page);
}

/** A line for the summary of the run. */
export function note(line) {
  if (process.env.STRIATA_NOTES) appendFileSync(process.env.STRIATA_NOTES, `  ${line}\n`);
}
