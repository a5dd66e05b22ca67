// Measures the example of a crowd with and without levels: `node tests/crowd.mjs MODEL.glb [INSTANCES] [ROUNDS]` prints the row of a table.
//
// Each round draws one place of the camera's path in both ways and waits for the picture. The first round only warms up. Without levels means
// the same batch with every instance at full detail.

import { basename, dirname, resolve } from 'node:path';
import { browser, newPage, PATIENCE_MS } from './harness.mjs';
import { staticServer } from './static.mjs';

const [model, instances = '10000', rounds = '3'] = process.argv.slice(2);
if (!model) throw new Error('usage: node tests/crowd.mjs MODEL.glb [INSTANCES] [ROUNDS]');
const server = await staticServer(resolve(dirname(model)));
const { context, close } = await browser();
const page = await newPage(context, { width: 1200, height: 760 });
await page.goto(`${server.url}examples/crowd/index.html?still&model=/models/${basename(model)}&count=${instances}`);
await page.waitForFunction(() => window.crowd, null, { timeout: PATIENCE_MS });

/** Draws from a place with an error of that many pixels. */
const drawn = (place, pixels) => page.evaluate(([place, pixels]) => {
  const { draw, frame, renderer } = window.crowd;
  const gl = renderer.getContext();
  const started = performance.now();
  draw(place, pixels);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return { ms: performance.now() - started, updateMs: frame.updateMs, triangles: frame.triangles };
}, [place, pixels]);

const pairs = [];
for (let round = 0; round <= Number(rounds); round++) {
  const place = (0.05 + 0.137 * round) % 1;
  const pair = { levels: await drawn(place, 1), full: await drawn(place, 0) };
  if (round > 0) pairs.push(pair);
}
await close();
server.close();

/** Mean and standard deviation. */
function spread(values, digits) {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const deviation = Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / Math.max(1, values.length - 1));
  return [mean, deviation].map((value) => value.toLocaleString('en-US', { minimumFractionDigits: digits, maximumFractionDigits: digits })).join(' ± ');
}
const millions = (values) => spread(values.map((value) => value / 1e6), 2);
const cells = [
  basename(model, '.glb'), Number(instances).toLocaleString('en-US'),
  millions(pairs.map(({ levels }) => levels.triangles)), millions(pairs.map(({ full }) => full.triangles)),
  spread(pairs.map(({ levels }) => levels.ms), 0), spread(pairs.map(({ full }) => full.ms), 0),
  spread(pairs.map(({ levels, full }) => full.ms / levels.ms), 1),
];
console.log(`| ${cells.join(' | ')} |`);
console.log(`choosing the levels took ${spread(pairs.map(({ levels }) => levels.updateMs), 1)} ms`);
if (page.faults.length > 0) throw new Error(page.faults.join('\n'));
