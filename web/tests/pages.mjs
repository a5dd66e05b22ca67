// A page for one test: opened, passed to the test, checked for errors, and always closed.

import assert from 'node:assert/strict';
import { appendFileSync } from 'node:fs';
import { test } from 'node:test';
import { PATIENCE_MS, settled, shot, untilWhole } from './harness.mjs';

/** Runs a test with a page; it fails if the page throws or logs an error. */
export function pageTest(world, name, options, work) {
  test(name, { timeout: 3 * PATIENCE_MS }, async (context) => {
    const page = await world.page(options);
    try {
      await work(page, context);
      assert.deepEqual(page.faults, [], 'the page threw or logged errors');
    } catch (error) {
      await shot(page, `failed-${name.replace(/\W+/g, '-')}`).catch(() => {});
      if (page.faults.length > 0) error.message += `\nerrors in the page: ${page.faults.join('\n')}`;
      throw error;
    } finally {
      await page.close();
    }
  });
}

/** Opens a model on the server and waits until it has loaded completely and the camera, which follows its bounds, has stopped. */
export async function openModel(world, page, name) {
  await page.goto(`${world.url}?model=models/${name}`);
  await untilWhole(page);
  await settled(page);
}

/** Adds a line to the summary of the run. */
export function note(line) {
  if (process.env.STRIATA_NOTES) appendFileSync(process.env.STRIATA_NOTES, `  ${line}\n`);
}
