// Takes three.js' own picture of a glTF file, with the light of `striata render`, in headless Chromium.
//
//   node tests/reference.mjs MODEL OUT.png '{ "eye": [x, y, z], "lookAt": [x, y, z], "fov": degrees, "width": 256, "height": 256 }'
//
// Optional: "up", "background" (a number, 0xrrggbb), "animation" and "time" (seconds). Without arguments, it takes the stored pictures again, with
// which the tests of the command compare its own.

import { createReadStream, existsSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { basename, dirname, extname, join, normalize, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { browser } from './harness.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.png': 'image/png', '.jpg': 'image/jpeg', '.webp': 'image/webp' };

/** Serves three.js, the page and the folder of a model on a free port. */
function serveFolders(folders) {
  const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://x').pathname));
    const [, first, ...rest] = path.split('/');
    const file = folders[first] && join(folders[first], ...rest);
    if (!file || path.includes('..') || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { 'Content-Type': TYPES[extname(file)] ?? 'application/octet-stream' });
    createReadStream(file).pipe(response);
  });
  return new Promise((done) => server.listen(0, '127.0.0.1', () => done(server)));
}

/** Returns three.js' pictures of a model as PNG files, one for each shot. */
export async function referencePictures(context, model, shots) {
  return withPage(context, model, async (page, url) => {
    const pictures = [];
    for (const shot of shots) {
      const whole = { up: [0, 1, 0], background: 0, animation: 0, time: null, ...shot, url };
      const address = await page.evaluate((what) => window.draw(what), whole);
      pictures.push(Buffer.from(address.split(',')[1], 'base64'));
    }
    return pictures;
  });
}

/** Shots of a whole model from several directions. */
export async function framedShots(context, model, directions, size = 512, fov = 30) {
  const { middle, radius } = await withPage(context, model, (page, url) => page.evaluate((from) => window.extent(from), url));
  const distance = radius / Math.sin((fov / 2) * (Math.PI / 180));
  return directions.map((direction) => {
    const scale = distance / Math.hypot(...direction);
    return { eye: middle.map((x, k) => x + scale * direction[k]), lookAt: middle, fov, width: size, height: size };
  });
}

/** Calls `use` with the page that draws, and the address of a model. */
async function withPage(context, model, use) {
  const folders = { three: join(here, '../node_modules/three'), page: join(here, 'reference'), model: dirname(resolve(model)) };
  const server = await serveFolders(folders);
  const page = await context.newPage();
  try {
    const origin = `http://127.0.0.1:${server.address().port}`;
    await page.goto(`${origin}/page/page.html`);
    await page.waitForFunction(() => window.isReady === true);
    return await use(page, `${origin}/model/${encodeURIComponent(basename(model))}`);
  } finally {
    await page.close();
    server.close();
    server.closeAllConnections();
  }
}

/** Shots whose pictures are stored, as references of the command's pictures. */
export const stored = join(here, '../../crates/striata-cli/tests/reference');

/** Takes the stored pictures again; returns each with its name. */
export async function takeStored(context) {
  const taken = [];
  for (const shot of JSON.parse(readFileSync(join(stored, 'shots.json'), 'utf8'))) {
    const [picture] = await referencePictures(context, join(here, '../..', shot.model), [shot]);
    taken.push({ name: shot.picture, picture });
  }
  return taken;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [model, out, shot] = process.argv.slice(2);
  const { context, close } = await browser();
  try {
    if (!model) {
      for (const { name, picture } of await takeStored(context)) writeFileSync(join(stored, name), picture);
    } else {
      if (!shot) throw new Error('usage: node tests/reference.mjs [MODEL OUT.png SHOT]');
      const [picture] = await referencePictures(context, model, [JSON.parse(shot)]);
      writeFileSync(out, picture);
    }
  } finally {
    await close();
  }
}
