// Tests of the examples: each is installed and built as its reader would do it, and run.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { PATIENCE_MS, run, shot } from './harness.mjs';
import { pageTest } from './pages.mjs';
import { staticServer, web } from './static.mjs';

/** Runs a program in a folder of the package. */
function inFolder(folder, program, ...words) {
  const { status, stdout, stderr } = spawnSync(program, words, { cwd: join(web, folder), encoding: 'utf8' });
  assert.equal(status, 0, `${program} ${words.join(' ')} in ${folder}: ${stdout}${stderr}`);
}

export default function examples(world) {
  let server;
  before(async () => {
    server = await staticServer(world.folder);
    const arm = join(web, '../assets/arm.glb');
    run('encode', '-q', arm, '-o', join(world.folder, 'arm.stri'));
    run('encode', '-q', arm, '-o', join(world.folder, 'arm-lod.glb'));
    run('build', '-q', join(web, '../assets/spot.obj.zst'), '-o', join(world.folder, 'spot-ordered.glb'), '--ranges', '4');
  });
  after(() => server?.close());

  pageTest(world, 'the example for plain three.js', {}, async (page) => {
    await page.goto(`${server.url}examples/minimal.html?model=/models/arm.stri`);
    await page.waitForFunction(() => window.model?.complete);
    await page.waitForFunction(() => window.model.triangleCount > 500);
    await shot(page, 'example-minimal');
  });

  pageTest(world, 'the example for react-three-fiber', {}, async (page) => {
    inFolder('examples/react', 'npm', 'ci', '--no-audit', '--no-fund', '--install-links=false');
    inFolder('examples/react', 'npx', 'vite', 'build');
    await page.goto(`${server.url}examples/react/dist/index.html?model=/models/arm.stri`);
    await page.waitForFunction(() => window.model?.complete);
    await page.waitForFunction(() => window.model.triangleCount > 500);
    assert.equal(await page.evaluate(() => window.model.isStriataScene && window.model.animations.length), 1);
    await shot(page, 'example-react');
  });

  pageTest(world, 'the example for model-viewer', { expected: [/Failed to load resource.*404/] }, async (page) => {
    inFolder('examples/model-viewer', 'npm', 'ci', '--no-audit', '--no-fund');
    await page.goto(`${server.url}examples/model-viewer/index.html?model=/models/arm-lod.glb`);
    await page.waitForFunction(() => document.getElementById('viewer').loaded);
    assert.deepEqual(await page.evaluate(() => document.getElementById('viewer').availableAnimations), ['wave']);
    await shot(page, 'example-model-viewer');
  });

  pageTest(world, 'the example of a crowd', {}, async (page) => {
    await page.goto(`${server.url}examples/crowd/index.html?model=/models/spot-ordered.glb&count=900`);
    await page.waitForFunction(() => window.crowd?.frame.ms > 0);
    const drawn = () => page.evaluate(() => window.crowd.frame.triangles);
    const withLevels = await drawn();
    await shot(page, 'example-crowd');
    await page.locator('[name=levels]').uncheck();
    await page.waitForFunction((before) => window.crowd.frame.triangles > before * 10, withLevels);
    assert.ok(withLevels > 900, `${withLevels} triangles`);
  });

  test('a project that uses the package passes tsc --strict', { timeout: PATIENCE_MS }, () => {
    inFolder('.', 'npx', 'tsc', '--project', 'tests/consumer/tsconfig.json');
  });
}
