// Tests on a phone-sized touch screen: the sheet, sizes of what is touched, gestures, and the divider.

import assert from 'node:assert/strict';
import { drawnPixels, settled, shot } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

const PHONE = { width: 390, height: 844 };

/** Smallest side of what a finger touches, CSS pixels. */
const FINGER_PX = 44;

/** Asserts that the page does not scroll sideways. */
export async function assertNoSideScroll(page) {
  const [wide, room] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(wide <= room, `the page is ${wide} px wide, but the window only ${room} px`);
}

/** Moves fingers from one set of points to another. */
export async function touch(page, from, to) {
  const wire = await page.context().newCDPSession(page);
  const points = (positions) => positions.map(([x, y], id) => ({ x, y, id }));
  await wire.send('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 2 });
  await wire.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(from) });
  for (let step = 1; step <= 5; step += 1) {
    const positions = from.map(([x, y], at) => [x + ((to[at][0] - x) * step) / 5, y + ((to[at][1] - y) * step) / 5]);
    await wire.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(positions) });
  }
  await wire.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await wire.detach();
}

export const eyeOf = (page) => page.evaluate(() => window.striataViewer.stage.camera.position.toArray());

/** Visible controls that are smaller than a finger, in any direction. A label counts as part of its control. */
function tooSmall(page) {
  return page.evaluate((least) => {
    const controls = document.querySelectorAll('button, a[href], select, input:not([type="file"]), [role="separator"]');
    const small = [];
    for (const control of controls) {
      if (control.closest('.skip') || control.classList.contains('skip') || !control.checkVisibility()) continue;
      const label = control.closest('label');
      const { width, height } = (label ?? control).getBoundingClientRect();
      if (Math.min(width, height) < least - 0.5) small.push(`${control.id || control.className}: ${width.toFixed(0)} x ${height.toFixed(0)}`);
    }
    return small;
  }, FINGER_PX);
}

export default function phone(world) {
  pageTest(world, 'on a phone the sheet folds, the page fits, and everything can be touched', PHONE, async (page) => {
    await openModel(world, page, 'arm.stri');
    await assertNoSideScroll(page);
    await shot(page, 'phone-folded');
    assert.equal(await page.locator('#controls').isVisible(), false, 'the controls are hidden at first');
    assert.deepEqual(await tooSmall(page), []);
    await page.locator('#handle').click();
    await page.locator('#controls').waitFor();
    await settled(page);
    await assertNoSideScroll(page);
    assert.deepEqual(await tooSmall(page), []);
    const stage = await page.locator('#stage').boundingBox();
    const panel = await page.locator('#panel').boundingBox();
    assert.ok(stage.y + stage.height <= panel.y + 1, 'the sheet does not cover the model');
    assert.ok(stage.height > 250 && (await drawnPixels(page)) > 2000, 'the model is visible next to the sheet');
    await shot(page, 'phone');
    for (const id of ['tree', 'saving-bar', 'save-glb']) {
      await page.locator(`#${id}`).evaluate((node) => node.scrollIntoView({ block: 'start' }));
    }
    await page.locator('#tree').evaluate((node) => node.scrollIntoView({ block: 'start' }));
    await shot(page, 'phone-parts');
    await page.locator('#handle').click();
    assert.equal(await page.locator('#controls').isVisible(), false);
    await page.goto(world.url);
    await page.locator('#cards a').first().waitFor();
    await assertNoSideScroll(page);
    assert.deepEqual(await tooSmall(page), []);
    await shot(page, 'phone-gallery');
  });

  pageTest(world, 'fingers rotate, zoom and pan', PHONE, async (page) => {
    await openModel(world, page, 'nefertiti.stri');
    const stage = await page.locator('#screen').boundingBox();
    const [x, y] = [stage.x + stage.width / 2, stage.y + stage.height / 2];
    const before = await eyeOf(page);
    await touch(page, [[x - 60, y]], [[x + 60, y]]);
    await settled(page);
    const turned = await eyeOf(page);
    assert.ok(Math.hypot(...turned.map((value, axis) => value - before[axis])) > 1e-3 * Math.hypot(...before), 'one finger rotates');
    const distanceToTarget = () => page.evaluate(() => window.striataViewer.stage.camera.position.distanceTo(window.striataViewer.stage.controls.target));
    const far = await distanceToTarget();
    await touch(page, [[x - 20, y], [x + 20, y]], [[x - 90, y], [x + 90, y]]);
    await settled(page);
    const near = await distanceToTarget();
    assert.ok(near < 0.8 * far, 'two fingers zoom');
    const target = () => page.evaluate(() => window.striataViewer.stage.controls.target.toArray());
    const old = await target();
    await touch(page, [[x - 40, y], [x + 40, y]], [[x - 40, y + 80], [x + 40, y + 80]]);
    await settled(page);
    const moved = Math.hypot(...(await target()).map((value, axis) => value - old[axis]));
    assert.ok(moved > 0.02 * near, 'two fingers pan');
  });

  pageTest(world, 'a finger moves the divider, and the model stays', PHONE, async (page) => {
    await openModel(world, page, 'nefertiti.stri');
    await page.keyboard.press('b');
    await page.waitForFunction(() => window.striataViewer.comparison.triangleCount !== null);
    await settled(page);
    const eye = await eyeOf(page);
    const screen = await page.locator('#screen').boundingBox();
    const y = screen.y + screen.height / 2;
    await touch(page, [[screen.x + screen.width / 2, y]], [[screen.x + 0.75 * screen.width, y]]);
    await settled(page);
    const value = Number(await page.locator('#divider').getAttribute('aria-valuenow'));
    assert.ok(Math.abs(value - 75) <= 2, `the divider is at ${value}`);
    assert.deepEqual(await eyeOf(page), eye);
    await assertNoSideScroll(page);
    await shot(page, 'phone-compared');
  });
}
