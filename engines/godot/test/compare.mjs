// Compares the levels of the add-on with those that Godot makes (`ImporterMesh.generate_lods`), inside the engine:
// `MESHES=... STRIATA=... npm run compare [ASSET ...]`. Prints the table of engines/godot/README.md. $SHOTS is a folder for pictures,
// $RAW a file for all measurements, which a later run continues.

import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
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
    // The fewest triangles with a picture at least as close as Godot's, and the closest picture with at most as many triangles.
    const close = [...ours, { drawn: full.drawn, difference: 0, pixels: 0 }].filter((one) => one.difference <= godot.difference);
    const equal = close.reduce((best, one) => (one.drawn < best.drawn ? one : best));
    const small = ours.filter((one) => one.drawn <= 1.01 * godot.drawn);
    const closest = small.length > 0 ? small.reduce((best, one) => (one.difference < best.difference ? one : best)) : undefined;
    return { distance, full: full.drawn, godot, striata: ours.find((one) => one.pixels === 1), equal, closest, ours };
  });
  return { times: results[0].times, rows };
}

const mean = (values) => Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
const count = (number) => number.toLocaleString('en');
const ratio = (value) => value.toFixed(value < 0.1 ? 3 : 2);

const assets = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(ASSETS);
const raw = process.env.RAW;
const measured = raw && existsSync(raw) ? JSON.parse(readFileSync(raw)) : {};
await inFolder(async (folder) => {
  for (const asset of assets.filter((asset) => !(asset in measured))) {
    measured[asset] = await measure(folder, asset);
    console.error(asset, JSON.stringify(measured[asset].times));
    if (raw) writeFileSync(raw, JSON.stringify(measured));
  }
});

const distances = measured[assets[0]].rows.map((row) => row.distance);
console.log(`| asset | triangles | ${distances.map((distance) => `at ${distance}`).join(' | ')} | ratio | difference | equal pictures | equal triangles |`);
console.log(`|${' --- |'.repeat(distances.length + 6)}`);
const columns = { triangles: [], difference: [], 'triangles for equal pictures': [], 'difference at equal triangles': [] };
for (const asset of assets) {
  const { rows } = measured[asset];
  // Distances at which Godot draws the full mesh have no difference to compare.
  const coarse = rows.filter((row) => row.godot.difference > 0);
  const drawn = mean(rows.map((row) => row.striata.drawn / row.godot.drawn));
  const equal = mean(coarse.map((row) => row.equal.drawn / row.godot.drawn));
  const closest = mean(coarse.filter((row) => row.closest?.difference > 0).map((row) => row.closest.difference / row.godot.difference));
  const differences = ['godot', 'striata'].map((which) => Math.sqrt(rows.reduce((sum, row) => sum + row[which].difference ** 2, 0) / rows.length));
  columns.triangles.push(drawn);
  if (coarse.length > 0) columns.difference.push(differences[1] / differences[0]);
  if (coarse.length > 0) columns['triangles for equal pictures'].push(equal);
  if (closest > 0) columns['difference at equal triangles'].push(closest);
  const cells = [count(rows[0].full), ...rows.map((row) => `${count(row.godot.drawn)} / ${count(row.striata.drawn)}`), ratio(drawn), differences.map((value) => value.toFixed(1)).join(' / '), ...[equal, closest].map((value) => (value > 0 ? ratio(value) : '–'))];
  console.log(`| ${asset} | ${cells.join(' | ')} |`);
}
const spread = (values) => `${ratio(mean(values))} (${ratio(Math.min(...values))} to ${ratio(Math.max(...values))})`;
console.log(`\nGeometric means and ranges over ${assets.length} assets: ${Object.entries(columns).map(([name, values]) => `${name} ${spread(values)}`).join('; ')}.`);
const times = assets.map((asset) => measured[asset].times).map(({ parse, generate, import: all }) => Math.max(1, all - parse) / Math.max(1, generate));
console.log(`Time to make levels, compared with Godot's generator: ${spread(times)}.`);
