// Compares the pictures of `striata render` with those of three.js from the same cameras in the same light.
//
//   node tests/against-three.mjs MODEL... [--time SECONDS]
//
// Prints the mean difference of 255 levels over the pixels that either picture covers, the mean over all pixels, and the largest of the former
// over the directions; in the software rasterizer and on the default adapter. The command is that of STRIATA_COMMAND, or `striata`.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { parseArgs } from 'node:util';
import { browser } from './harness.mjs';
import { framedShots, referencePictures } from './reference.mjs';

const DIRECTIONS = [[0.5, 0.35, 1], [1, 0.2, -0.4], [-0.8, 0.9, 0.5]];

/** Differences of two PNG files, computed in a page: the mean over covered pixels, and over all. */
function differences(page, ...files) {
  return page.evaluate(async (addresses) => {
    const [a, b] = await Promise.all(addresses.map(async (address) => {
      const bitmap = await createImageBitmap(await (await fetch(address)).blob());
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      return context.getImageData(0, 0, bitmap.width, bitmap.height).data;
    }));
    let sum = 0, covered = 0;
    for (let at = 0; at < a.length; at += 4) {
      for (let k = 0; k < 3; k++) sum += Math.abs(a[at + k] - b[at + k]) / 3;
      if ([0, 1, 2].some((k) => Math.max(a[at + k], b[at + k]) > 8)) covered++;
    }
    return [sum / covered, sum / (a.length / 4)];
  }, files.map((file) => `data:image/png;base64,${file.toString('base64')}`));
}

/** The picture that the command draws of a shot. */
function drawn(model, shot, flags) {
  const folder = mkdtempSync(join(tmpdir(), 'striata-against-three-'));
  try {
    const out = join(folder, 'out.png');
    const size = `${shot.width}x${shot.height}`;
    const camera = [`--from=${shot.eye}`, `--look-at=${shot.lookAt}`, '--fov', `${shot.fov}`];
    const time = shot.time === undefined ? [] : ['--time', `${shot.time}`];
    const options = ['--background', '#000000', '--size', size, ...camera, ...time, ...flags, '-q'];
    execFileSync(process.env['STRIATA_COMMAND'] ?? 'striata', ['render', model, '-o', out, ...options]);
    return readFileSync(out);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const { values, positionals } = parseArgs({ options: { time: { type: 'string' } }, allowPositionals: true });
if (positionals.length === 0) throw new Error('usage: node tests/against-three.mjs MODEL... [--time SECONDS]');
const { context, close } = await browser();
try {
  const page = await context.newPage();
  for (const model of positionals) {
    const time = values.time === undefined ? {} : { time: Number(values.time) };
    const shots = (await framedShots(context, model, DIRECTIONS)).map((shot) => ({ ...shot, ...time }));
    const references = await referencePictures(context, model, shots);
    for (const flags of [['--software'], []]) {
      const found = [];
      for (const [at, shot] of shots.entries()) found.push(await differences(page, drawn(model, shot, flags), references[at]));
      const mean = (k) => found.reduce((sum, pair) => sum + pair[k], 0) / found.length;
      const largest = Math.max(...found.map(([covered]) => covered));
      const renderer = flags[0] ?? 'default';
      console.log(`${basename(model)} ${renderer}: covered ${mean(0).toFixed(2)} (at most ${largest.toFixed(2)}), all ${mean(1).toFixed(2)}`);
    }
  }
} finally {
  await close();
}
