// Compares the levels of the add-on with those that Godot makes (`ImporterMesh.generate_lods`), inside the engine:
// `MESHES=... STRIATA=... npm run compare [ASSET ...]`. Prints the tables of docs/results/godot.md; $SHOTS is a folder for pictures.

import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { missing, project, run } from './engine.mjs';
import { MESHES, ROOT, build, cannotBuild, inFolder } from './models.mjs';

const SIZE = [1024, 1024];
const ASSETS = {
  bunny: 'bunny.ply',
  dragon: 'dragon.ply.gz',
  nefertiti: 'nefertiti.ply',
  spot: 'spot.obj',
  fandisk: 'fandisk.obj',
  teapot: 'teapot.obj',
  helmet: 'FlightHelmet/FlightHelmet.gltf',
  voyager: 'assets/sw_voyager.gltf',
  saw: 'assets/ReciprocatingSaw.glb',
  brainstem: 'assets/BrainStem.glb',
  monastery: 'assets/samurai_monastry.obj.zst',
  fox: 'animated/Fox.glb',
};

const reason = missing() ?? cannotBuild() ?? (MESHES ? undefined : 'MESHES is not set');
if (reason) {
  console.log(`skipped: ${reason}`);
  process.exit(0);
}

/** Root mean square of the differences of channels, in steps of 255, over the pixels that either picture covers. */
function difference(a, b) {
  const background = a.subarray(0, 3);
  let sum = 0;
  let count = 0;
  for (let i = 0; i < a.length; i += 3) {
    const covers = (picture) => picture[i] !== background[0] || picture[i + 1] !== background[1] || picture[i + 2] !== background[2];
    if (!covers(a) && !covers(b)) continue;
    for (let channel = i; channel < i + 3; channel++) sum += (a[channel] - b[channel]) ** 2;
    count += 3;
  }
  return Math.sqrt(sum / count);
}

/** Draws one asset. Returns times and rows by distance. */
async function measure(folder, asset) {
  const files = project(readFileSync(new URL('compare.gd', import.meta.url)), SIZE);
  const addon = join(ROOT, 'engines/godot/addons/striata');
  readdirSync(addon).forEach((name) => files.set(`addons/striata/${name}`, readFileSync(join(addon, name))));
  files.set(`models/${asset}.glb`, build(folder, join(MESHES, ASSETS[asset]), `${asset}.glb`));
  const { results, messages } = await run(files, SIZE, 600);
  if (messages.some((text) => /malformed|were left out/.test(text))) throw new Error(messages.join('\n'));
  const pictures = results.filter((result) => 'image' in result);
  if (process.env.SHOTS) {
    mkdirSync(process.env.SHOTS, { recursive: true });
    pictures.forEach(({ which, distance, pixels, png }) => writeFileSync(join(process.env.SHOTS, `${asset}-${distance}-${which}-${pixels}.png`), Buffer.from(png, 'base64')));
  }
  const distances = [...new Set(pictures.map((picture) => picture.distance))];
  const rows = distances.map((distance) => {
    const own = pictures.filter((picture) => picture.distance === distance);
    const bytes = (picture) => Buffer.from(picture.image, 'base64');
    const full = own.find((picture) => picture.pixels === 0);
    const cases = own.filter((picture) => picture !== full).map((picture) => ({ ...picture, image: undefined, png: undefined, difference: difference(bytes(full), bytes(picture)) }));
    const godot = cases.find((one) => one.which === 'godot');
    const ours = cases.filter((one) => one.which === 'striata');
    // The coarsest of the measured choices whose picture is at least as close as that of Godot; the full mesh if there is none.
    const equal = ours.find((one) => one.difference <= godot.difference) ?? { drawn: full.drawn, difference: 0, pixels: 0 };
    return { distance, full: full.drawn, godot, striata: ours[0], equal };
  });
  return { times: results[0].times, rows };
}

const mean = (values) => Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
const count = (number) => number.toLocaleString('en');
const ratio = (value) => value.toFixed(value < 0.1 ? 3 : 2);

const assets = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(ASSETS);
const measured = {};
await inFolder(async (folder) => {
  for (const asset of assets) {
    measured[asset] = await measure(folder, asset);
    console.error(asset, JSON.stringify(measured[asset].times));
    if (process.env.RAW) writeFileSync(process.env.RAW, JSON.stringify(measured));
  }
});

const distances = measured[assets[0]].rows.map((row) => row.distance);
console.log(`| asset | triangles | ${distances.map((distance) => `at ${distance}`).join(' | ')} | ratio | difference | at equal difference |`);
console.log(`|${' --- |'.repeat(distances.length + 5)}`);
const sums = { ratios: [], differences: [], equal: [] };
for (const [asset, { rows }] of Object.entries(measured)) {
  const drawn = mean(rows.map((row) => row.striata.drawn / row.godot.drawn));
  const equal = mean(rows.map((row) => row.equal.drawn / row.godot.drawn));
  const differences = ['godot', 'striata'].map((which) => Math.sqrt(rows.reduce((sum, row) => sum + row[which].difference ** 2, 0) / rows.length));
  sums.ratios.push(drawn);
  sums.equal.push(equal);
  // If Godot makes no levels, its picture is that of the full mesh.
  if (differences[0] > 0) sums.differences.push(differences[1] / differences[0]);
  console.log(`| ${asset} | ${count(rows[0].full)} | ${rows.map((row) => `${count(row.godot.drawn)} / ${count(row.striata.drawn)}`).join(' | ')} | ${ratio(drawn)} | ${differences.map((value) => value.toFixed(1)).join(' / ')} | ${ratio(equal)} |`);
}
const spread = (values) => `${ratio(mean(values))} (${ratio(Math.min(...values))} to ${ratio(Math.max(...values))})`;
console.log(`\nGeometric means and ranges over ${assets.length} assets: triangles ${spread(sums.ratios)}, difference ${spread(sums.differences)}, triangles at equal difference ${spread(sums.equal)}.`);
const times = Object.values(measured).map(({ times }) => Math.max(1, times.import - times.parse) / Math.max(1, times.generate));
console.log(`Time to make levels compared with Godot's generator: ${spread(times)}.`);
