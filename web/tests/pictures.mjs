// Tests of pictures and videos of what is shown.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { settled, slide, state } from './harness.mjs';
import { eyeOf } from './phone.mjs';
import { openModel, pageTest } from './pages.mjs';

/** Name and bytes of the file that a click saves. */
async function saved(page, id) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator(`#${id}`).click()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** Seconds that a video takes, and the share of its first picture that is different later. */
async function watch(page, bytes) {
  // The policy of the server allows no videos in its pages.
  const player = await page.context().newPage();
  const seen = await player.evaluate(async (base64) => {
    const video = document.createElement('video');
    video.muted = true;
    video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], { type: 'video/webm' }));
    await new Promise((resolve, reject) => {
      video.onloadeddata = resolve;
      video.onerror = () => reject(new Error(`the video does not play: ${video.error?.message}`));
    });
    // A recorded video has no duration until its end has been found.
    video.currentTime = 1e6;
    await new Promise((resolve) => (video.onseeked = resolve));
    const seconds = video.currentTime;
    const canvas = Object.assign(document.createElement('canvas'), { width: 64, height: 64 });
    const pictureAt = async (time) => {
      video.currentTime = time;
      await new Promise((resolve) => (video.onseeked = resolve));
      const pen = canvas.getContext('2d');
      pen.drawImage(video, 0, 0, 64, 64);
      return pen.getImageData(0, 0, 64, 64).data;
    };
    const [first, middle] = [await pictureAt(0), await pictureAt(0.6 * seconds)];
    const change = first.filter((value, at) => Math.abs(value - middle[at]) > 16).length / first.length;
    return { seconds, change, width: video.videoWidth };
  }, bytes.toString('base64'));
  await player.close();
  return seen;
}

export default function pictures(world) {
  pageTest(world, 'a picture is twice as large as the view, and shows the same', {}, async (page) => {
    await openModel(world, page, 'spot.striata');
    await page.keyboard.press('v');
    await slide(page, 'pixels', 800);
    await settled(page);
    const before = await state(page);
    const size = await page.evaluate(() => {
      const { width, height } = window.striataViewer.stage.renderer.domElement;
      return { width, height };
    });
    const { name, bytes } = await saved(page, 'picture');
    assert.equal(name, 'spot.png');
    assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [2 * size.width, 2 * size.height]);
    const difference = await page.evaluate(async (base64) => {
      const { stage } = window.striataViewer;
      const picture = new Image();
      picture.src = `data:image/png;base64,${base64}`;
      await picture.decode();
      const pixels = (source) => {
        const canvas = Object.assign(document.createElement('canvas'), { width: 90, height: 60 });
        const pen = canvas.getContext('2d');
        pen.imageSmoothingQuality = 'high';
        pen.drawImage(source, 0, 0, 90, 60);
        return pen.getImageData(0, 0, 90, 60).data;
      };
      stage.render();
      const [shown, saved] = [pixels(stage.renderer.domElement), pixels(picture)];
      return shown.reduce((sum, value, at) => sum + Math.abs(value - saved[at]), 0) / shown.length;
    }, bytes.toString('base64'));
    assert.ok(difference < 2, `the picture differs by ${difference}`);
    await settled(page);
    assert.equal((await state(page)).triangleCount, before.triangleCount, 'the larger picture does not change the level');
    assert.deepEqual(await page.evaluate(() => {
      const { width, height } = window.striataViewer.stage.renderer.domElement;
      return { width, height };
    }), size);
  });

  pageTest(world, 'a turn and the levels are saved as videos, and a recording can be canceled', { width: 480, height: 360 }, async (page) => {
    await openModel(world, page, 'spot.striata');
    await page.locator('#handle').click();
    await slide(page, 'detail', 800);
    await settled(page);
    const [eye, { triangleCount }] = [await eyeOf(page), await state(page)];
    await page.locator('summary', { hasText: 'video' }).click();
    for (const motion of ['turn', 'detail']) {
      await page.locator('#motion').selectOption(motion);
      const { name, bytes } = await saved(page, 'record');
      assert.equal(name, `spot-${motion}.webm`);
      const { seconds, change, width } = await watch(page, bytes);
      assert.ok(seconds > 3 && seconds < 8, `${seconds} seconds`);
      assert.ok(change > 0.01, `the ${motion} moves: ${change}`);
      assert.ok(width > 100);
      await settled(page);
      assert.ok(Math.hypot(...(await eyeOf(page)).map((value, axis) => value - eye[axis])) < 1e-6, 'the camera returns');
      assert.equal((await state(page)).triangleCount, triangleCount, 'the level returns');
    }
    await page.locator('#record').click();
    await page.waitForFunction(() => /Cancel \(\d+%\)/.test(document.getElementById('record').textContent));
    await page.locator('#record').click();
    await page.waitForFunction(() => document.getElementById('record').textContent === 'Save video');
    await page.evaluate(() => delete window.MediaRecorder);
    await page.locator('#record').click();
    assert.match(await page.locator('.notice').innerText(), /cannot record videos/);
  });
}
