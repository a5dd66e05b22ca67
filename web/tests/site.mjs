// Tests the built site as plain files on a server that knows nothing else: STRIATA_SITE=FOLDER node --test tests/site.mjs

import assert from 'node:assert/strict';
import { once } from 'node:events';
import { createReadStream, existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { browser as start } from './harness.mjs';

const site = process.env.STRIATA_SITE;
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.json': 'application/json', '.svg': 'image/svg+xml', '.png': 'image/png' };

let server, url, browser, close;

before(async () => {
  server = createServer((request, response) => {
    let file = join(site, decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
    if (existsSync(file) && statSync(file).isDirectory()) file = join(file, 'index.html');
    if (!existsSync(file)) return response.writeHead(404).end();
    response.setHeader('Content-Type', TYPES[extname(file)] ?? 'application/octet-stream');
    createReadStream(file).pipe(response);
  });
  server.listen(0, '127.0.0.1');
  await once(server, 'listening');
  url = `http://127.0.0.1:${server.address().port}/`;
  ({ context: browser, close } = await start());
});

after(async () => {
  await close();
  server.close();
  server.closeAllConnections();
});

/** Opens a page; fails if it asks another site for something, or something is missing. */
async function open(path) {
  const page = await browser.newPage();
  const faults = [];
  page.on('request', (request) => {
    if (/^https?:/.test(request.url()) && !request.url().startsWith(url)) faults.push(`asks for ${request.url()}`);
  });
  page.on('response', (response) => {
    if (response.status() >= 400) faults.push(`${response.status()} for ${response.url()}`);
  });
  page.on('pageerror', (error) => faults.push(String(error)));
  await page.goto(new URL(path, url).href);
  return { page, faults };
}

test('pages have their content and load nothing from elsewhere', async () => {
  for (const [path, words] of [['', 'Continuous'], ['guide/engines/', 'vertex buffer'], ['results/simplification/', 'bunny']]) {
    const { page, faults } = await open(path);
    assert.match(await page.locator('article').innerText(), new RegExp(words));
    const pictures = await page.evaluate(() => [...document.querySelectorAll('article img')].map((image) => [image.src, image.naturalWidth]));
    for (const [source, width] of pictures) assert.ok(width > 0, `${path}: ${source}`);
    assert.deepEqual(faults, [], path);
    await page.close();
  }
});

test('links within the site lead to pages', () => {
  const pages = readdirSync(site, { recursive: true }).filter((name) => name.endsWith('.html') && name !== '404.html' && !name.startsWith('viewer'));
  assert.ok(pages.length > 30, `${pages.length} pages`);
  for (const name of pages) {
    const base = new URL(name, 'http://site/');
    for (const [, link] of readFileSync(join(site, name), 'utf8').matchAll(/(?:href|src)="([^"#?]+)[^"]*"/g)) {
      const target = new URL(link.replaceAll('&amp;', '&'), base);
      // The canonical address of the site itself.
      if (target.host !== 'site') continue;
      const file = join(site, decodeURIComponent(target.pathname));
      assert.ok(existsSync(file), `${name} refers to ${link}`);
    }
  }
});

test('the gallery shows a model, and the viewer lists the others with pictures', async () => {
  const { page, faults } = await open('gallery/');
  await page.locator('iframe').scrollIntoViewIfNeeded();
  const frame = page.frames().find((frame) => frame.url().includes('/viewer/')) ?? (await page.waitForEvent('frameattached'));
  await frame.waitForFunction(() => window.striataViewer?.model?.triangleCount > 1000, undefined, { timeout: 120_000 });
  assert.deepEqual(faults, []);
  await page.close();
  const viewer = await open('viewer/');
  await viewer.page.locator('#cards a img').nth(3).waitFor();
  assert.equal(await viewer.page.locator('#cards a').count(), 4);
  await viewer.page.locator('#cards a', { hasText: 'arm.glb' }).click();
  await viewer.page.waitForFunction(() => window.striataViewer?.model?.triangleCount > 100, undefined, { timeout: 120_000 });
  assert.deepEqual(viewer.faults, []);
  await viewer.page.close();
});
