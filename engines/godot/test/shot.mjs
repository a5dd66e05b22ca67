// Draws the picture of docs/guide/godot.md: `STRIATA=... node shot.mjs docs/images/godot.jpg`.

import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { missing, project, run } from './engine.mjs';
import { ROOT, build, cannotBuild, inFolder } from './models.mjs';

const SIZE = [1100, 620];
const reason = missing() ?? cannotBuild();
if (reason) {
  console.log(`skipped: ${reason}`);
  process.exit(0);
}

await inFolder(async (folder) => {
  const files = project(readFileSync(new URL('shot.gd', import.meta.url)), SIZE);
  const addon = join(ROOT, 'engines/godot/addons/striata');
  readdirSync(addon).forEach((name) => files.set(`addons/striata/${name}`, readFileSync(join(addon, name))));
  files.set('models/nefertiti.glb', build(folder, join(ROOT, 'crates/striata-cli/assets/nefertiti.ply.zst'), 'nefertiti.glb'));
  const { results } = await run(files, SIZE);
  results.forEach(({ pixels, drawn }) => console.log(`${drawn} triangles at ${pixels} pixels`));
  writeFileSync(process.argv[2], Buffer.from(results.at(-1).picture, 'base64'));
});
