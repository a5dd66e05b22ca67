// Tests of view-dependent detail: the promised error is measured from the drawn triangles and the camera.

import assert from 'node:assert/strict';
import { settled, shot, slide, state } from './harness.mjs';
import { distancesTo, pixelsAt } from './measure.mjs';
import { note, openModel, pageTest } from './pages.mjs';

/**
 * Tolerance on the promised bound on the distance of vertices from the drawn surface, as seen by the camera; the model's errors are
 * stored as `f32` and compared with margins.
 */
const TOLERANCE_FACTOR = 1.01;

/** Positions and triangles drawn now, in world space. */
async function drawn(page) {
  const { positions, triangles } = await page.evaluate(() => {
    const { model } = window.striataViewer;
    // These models have a single mesh.
    const [mesh] = model.lods[0].meshes;
    const { geometry } = mesh;
    mesh.updateWorldMatrix(true, false);
    const points = geometry.getAttribute('position').clone().applyMatrix4(mesh.matrixWorld);
    const { start, count } = geometry.drawRange;
    const indices = geometry.index.array.slice(start, Math.min(start + count, geometry.index.count));
    return { positions: Array.from(points.array.slice(0, 3 * model.vertexCount)), triangles: Array.from(indices) };
  });
  return { positions: Float32Array.from(positions), triangles };
}

function camera(page) {
  return page.evaluate(() => {
    const { stage } = window.striataViewer;
    stage.camera.updateMatrixWorld();
    const view = stage.camera.matrixWorldInverse.elements;
    const { fov, aspect } = stage.camera;
    return { view: [...view], fov, aspect, height: stage.renderer.domElement.height };
  });
}

/** Largest distance in pixels of visible vertices of the full mesh from the drawn surface. */
function worst(full, level, look) {
  const distances = distancesTo(full.positions, level);
  let largest = 0;
  for (let vertex = 0; vertex < distances.length; vertex += 1) {
    const pixels = pixelsAt(full.positions.subarray(3 * vertex, 3 * vertex + 3), look);
    if (pixels !== null) largest = Math.max(largest, distances[vertex] * pixels);
  }
  return largest;
}

export default function views(world) {
  pageTest(world, 'the screen error is respected, and distant views need fewer triangles', {}, async (page) => {
    await openModel(world, page, 'sub/terrain.stri');
    const full = await drawn(page);
    await page.keyboard.press('v');
    const counts = [];
    for (const position of [316, 632]) {
      await slide(page, 'pixels', position);
      await settled(page);
      const now = await state(page);
      const requested = now.pixelError;
      const level = await drawn(page);
      assert.equal(level.triangles.length, 3 * now.triangleCount);
      const measured = worst(full, level, await camera(page));
      assert.ok(measured <= requested * TOLERANCE_FACTOR, `${measured} pixels, but ${requested} were requested`);
      assert.ok(now.triangleCount < now.fullTriangleCount, 'fewer triangles than the full mesh');
      counts.push(now.triangleCount);
      note(`requested ${requested.toFixed(2)} px: measured ${measured.toFixed(2)} px, ${now.triangleCount} of ${now.fullTriangleCount} triangles`);
    }
    assert.ok(counts[1] < counts[0], 'a larger screen error gives fewer triangles');
    await page.evaluate(() => window.striataViewer.framing.zoom(4));
    await settled(page);
    const far = await state(page);
    assert.ok(far.triangleCount < counts[1], `${far.triangleCount} triangles from far away, ${counts[1]} from nearby`);
    const measured = worst(full, await drawn(page), await camera(page));
    assert.ok(measured <= far.pixelError * TOLERANCE_FACTOR, `${measured} pixels from far away`);
  });

  pageTest(world, 'what is seen while a view is frozen does not count afterward', {}, async (page) => {
    await openModel(world, page, 'arm.stri');
    const counts = await page.evaluate(async () => {
      const { model, stage, framing } = window.striataViewer;
      const seen = async (factor) => {
        const { eye, target } = framing.pose();
        stage.camera.position.copy(eye.sub(target).multiplyScalar(factor).add(target));
        for (let frame = 0; frame < 10; frame += 1) {
          stage.camera.updateMatrixWorld();
          stage.render();
          await new Promise((resolve) => setTimeout(resolve, 60));
        }
        return model.triangleCount;
      };
      model.pixelError = 2;
      const before = await seen(1);
      model.frozen = true;
      await seen(0.2);
      model.frozen = false;
      return [before, await seen(50)];
    });
    assert.ok(counts[1] < counts[0], `${counts}`);
  });

  pageTest(world, 'a frozen view keeps its triangles while it is seen from outside', {}, async (page) => {
    await openModel(world, page, 'sub/terrain.stri');
    await page.keyboard.press('z');
    await page.evaluate(() => window.striataViewer.framing.zoom(0.4));
    await page.keyboard.press('v');
    await slide(page, 'pixels', 550);
    await settled(page);
    const before = await drawn(page);
    const eye = await page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
    await page.locator('#freeze').check();
    await settled(page);
    const outside = await page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
    assert.notDeepEqual(outside, eye, 'the camera moves outside');
    assert.equal(await page.locator('#frozen-note').isVisible(), true);
    await page.evaluate(() => window.striataViewer.framing.orbit(0.3, 0.1));
    await settled(page);
    assert.equal(String((await drawn(page)).triangles) === String(before.triangles), true, 'the triangles are unchanged');
    assert.equal(await page.evaluate(() => window.striataViewer.stage.scene.children.some((child) => child.isLineSegments)), true);
    await page.locator('#wireframe').check();
    await shot(page, 'frozen');
    await page.locator('#wireframe').uncheck();
    await page.locator('#freeze').uncheck();
    await settled(page);
    const back = await page.evaluate(() => window.striataViewer.stage.camera.position.toArray());
    assert.deepEqual(back.map((x) => x.toFixed(3)), eye.map((x) => x.toFixed(3)), 'the camera returns to the frozen view');
    await page.evaluate(() => window.striataViewer.framing.orbit(1, 0.1));
    await settled(page);
    assert.equal(String((await drawn(page)).triangles) === String(before.triangles), false, 'an unfrozen view follows the camera');
  });
}
