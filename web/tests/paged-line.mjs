// Measures views of a large paged file over a line: node tests/paged-line.mjs FILE.striata [MIB_PER_SECOND DELAY_MS]
//
// For each view, a page that knows nothing about the file refines to 2 pixels, and then to 1. Prints what has been received and how long it
// took, errors that were shown meanwhile, the longest task of the page, and the memory of the process.

import { readFileSync } from 'node:fs';
import { basename, dirname, resolve } from 'node:path';
import { browser } from './harness.mjs';
import { staticServer } from './static.mjs';

const [, , path, mebibytes = '8', delay = '100'] = process.argv;
if (!path) throw new Error('usage: node tests/paged-line.mjs FILE.striata [MIB_PER_SECOND DELAY_MS]');

/** Where the camera is and looks, as shares of the horizontal extent; heights are in the same unit. */
const VIEWS = {
  'the whole': { eye: [0.5, -1.6, 1], target: [0.5, 0.5, 0] },
  'along the ground': { eye: [0.5, -0.25, 0.25], target: [0.5, 0.5, 0] },
  'from within': { eye: [0.5, 0.5, 0.0125], target: [0.525, 0.5, 0] },
};

/** Resident memory of the process with most of it that draws pages, MB. */
async function memory(session) {
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const sizes = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => {
    const [, kilobytes] = /VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`, 'utf8')) ?? [0, 0];
    return Number(kilobytes) / 1000;
  });
  return Math.max(...sizes);
}

async function measure(server, view) {
  // A browser of its own, because the peak of the memory counts.
  const { context, close } = await browser();
  try {
    const page = await context.newPage();
    page.on('pageerror', (error) => console.error(error));
    await page.setViewportSize({ width: 1920, height: 1080 });
    await page.goto(server.url);
    await page.waitForFunction(() => window.isReady);
    Object.assign(server.state, { rate: Number(mebibytes) * 2 ** 20, delay: Number(delay), sent: 0, requests: 0 });
    const seen = await page.evaluate(async ([name, { eye, target }]) => {
      const seen = { steps: [], longest: 0 };
      new PerformanceObserver((list) => list.getEntries().forEach(({ duration }) => (seen.longest = Math.max(seen.longest, duration)))).observe({ type: 'longtask' });
      renderer.setSize(1920, 1080, false);
      camera.aspect = 1920 / 1080;
      camera.up.set(0, 0, 1);
      const start = performance.now();
      const model = await new StriataLoader(undefined, { pixelError: 2 }).loadAsync(`/models/${name}`);
      scene.add(model);
      const { min, max } = new THREE.Box3().setFromObject(model);
      const extent = Math.max(max.x - min.x, max.y - min.y);
      const place = ([x, y, z]) => new THREE.Vector3(min.x + x * extent, min.y + y * extent, max.z + z * extent);
      camera.position.copy(place(eye));
      camera.lookAt(place(target));
      [camera.near, camera.far] = [extent / 1e5, 10 * extent];
      camera.updateProjectionMatrix();
      camera.updateMatrixWorld();
      const note = (what) => seen.steps.push({ what, ms: performance.now() - start, bytes: model.bytesReceived, triangles: model.triangleCount, error: model.error });
      note('first');
      for (const pixels of [2, 1]) {
        model.pixelError = pixels;
        let last = model.triangleCount;
        for (let quiet = 0; quiet < 30; quiet++) {
          // Choosing a level takes no drawing, which would take long without a graphics card.
          scene.traverse((mesh) => mesh.onBeforeRender?.(renderer, scene, camera));
          await new Promise((go) => setTimeout(go, 50));
          if (!model.complete) quiet = 0;
          if (model.triangleCount === last) continue;
          note(`on the way to ${pixels} px`);
          [quiet, last] = [0, model.triangleCount];
        }
        seen.steps.at(-1).what = `${pixels} px`;
      }
      return seen;
    }, [basename(path), view]);
    const session = await context.browser()?.newBrowserCDPSession() ?? await context.newCDPSession(page);
    return { ...seen, requests: server.state.requests, memory: await memory(session).catch(() => NaN) };
  } finally {
    await close();
  }
}

const server = await staticServer(dirname(resolve(path)));
try {
  for (const [name, view] of Object.entries(VIEWS)) {
    const { steps, longest, requests, memory } = await measure(server, view);
    console.log(`${name}: ${requests} requests, longest task ${longest.toFixed(0)} ms, peak memory ${memory.toFixed(0)} MB`);
    for (const { what, ms, bytes, triangles, error } of steps) {
      console.log(`  ${what}: ${(ms / 1000).toFixed(2)} s, ${(bytes / 1e6).toFixed(2)} MB, ${triangles} triangles, error ${error.toFixed(3)}`);
    }
  }
} finally {
  server.close();
}
