// Measures how many bytes of a scene give a recognizable picture: node tests/first-picture.mjs SCENE.stri [GLB ...]
//
// The page gets only the first bytes and draws what they give, so the result does not depend on the speed of the machine. The picture is
// compared with the final one: the mean difference over the pixels that either shows, as a share of that between the final picture and a
// blank one. The GLBs given are complete only at their ends; several are shown one after the other, like the separate levels of
// gltf-progressive. Also measures the time that choosing levels takes on the page.

import { statSync } from 'node:fs';
import { basename, dirname, resolve } from 'node:path';
import { browser } from './harness.mjs';
import { staticServer } from './static.mjs';

const [, , scene, ...glbs] = process.argv;
if (!scene) throw new Error('usage: node tests/first-picture.mjs SCENE.stri [GLB ...]');

/** Lengths of the prefixes, bytes. */
const PREFIXES = [20, 30, 40, 50, 60, 80, 100, 150, 200, 400, 800, 1600].map((kilobytes) => 1000 * kilobytes);
const server = await staticServer(dirname(resolve(scene)));
const { context, close } = await browser();
try {
  const page = await context.newPage();
  page.on('pageerror', (error) => console.error(error));
  await page.goto(server.url);
  await page.waitForFunction(() => window.isReady);
  const seen = await page.evaluate(async ([name, prefixes]) => {
    const bytes = new Uint8Array(await (await fetch(`/models/${name}`)).arrayBuffer());
    const loader = new StriataLoader();
    const whole = await loader.open(bytes.buffer);
    scene.add(whole);
    look(whole);
    await whole.finished;
    await settle(whole);
    const final = pixels();
    const blank = difference(new Uint8Array(final.length), final);
    const meshes = whole.lods.flatMap((lod) => lod.meshes);
    const frames = 300;
    const start = performance.now();
    for (let frame = 0; frame < frames; frame++) {
      camera.position.x += 1e-4;
      camera.updateMatrixWorld();
      for (const mesh of meshes) mesh.onBeforeRender(renderer, scene, camera);
      await null;
    }
    const ms = (performance.now() - start) / frames;
    look(whole);
    scene.remove(whole);
    const shares = [];
    for (const length of prefixes.filter((length) => length < bytes.length)) {
      // The connection stalls after the prefix.
      const stream = new ReadableStream({ start: (controller) => controller.enqueue(bytes.slice(0, length)) });
      const stalled = new Promise((give) => setTimeout(give, 3000));
      const abort = new AbortController();
      const opened = loader.open(stream, { signal: abort.signal });
      opened.catch(() => {});
      const model = await Promise.race([opened, stalled]);
      if (!model) {
        abort.abort();
        shares.push([length, 1]);
        continue;
      }
      scene.add(model);
      await settle(model);
      await new Promise((go) => setTimeout(go, 500));
      shares.push([length, difference(pixels(), final) / blank]);
      scene.remove(model);
      model.dispose();
    }
    return { shares, total: bytes.length, ms, meshes: meshes.length };
  }, [basename(scene), PREFIXES]);
  for (const limit of [0.5, 0.25, 0.15, 0.05, 0.02]) {
    const [bytes] = seen.shares.find(([, share]) => share <= limit) ?? [seen.total];
    console.log(`${basename(scene)}: within ${100 * limit} % after ${bytes} of ${seen.total} bytes`);
  }
  console.log(seen.shares.map(([bytes, share]) => `${bytes}: ${(100 * share).toFixed(1)} %`).join(', '));
  console.log(`choosing levels of ${seen.meshes} meshes takes ${seen.ms.toFixed(3)} ms a frame`);
  let sum = 0;
  for (const glb of glbs) {
    sum += statSync(glb).size;
    console.log(`${basename(glb)}: complete after ${sum} bytes in all`);
  }
} finally {
  await close();
  server.close();
}
