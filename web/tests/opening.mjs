// Tests of opening files of all kinds: framing, normals, late animations, formats that the command reads, messages, numbers of parts.

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { drop } from './files.mjs';
import { drawnPixels, run, settled, slide, state, untilWhole, workspace } from './harness.mjs';
import { openModel, pageTest } from './pages.mjs';

/** Largest coordinate of any vertex of the model in the picture; 1 is at its edge, or at the near or far plane. */
function farthest(page) {
  return page.evaluate(() => {
    const { stage, model } = window.striataViewer;
    stage.render();
    const point = stage.camera.position.clone();
    let most = 0;
    model.traverse((mesh) => {
      const positions = mesh.geometry?.getAttribute('position');
      for (let vertex = 0; vertex < (positions?.count ?? 0); vertex += 1) {
        point.fromBufferAttribute(positions, vertex).applyMatrix4(mesh.matrixWorld).project(stage.camera);
        most = Math.max(most, Math.abs(point.x), Math.abs(point.y), Math.abs(point.z));
      }
    });
    return most;
  });
}

/** Lines of an OBJ file of waves: `side` squares a side, two triangles each. */
function waves(side) {
  const [vertices, faces] = [[], []];
  for (let y = 0; y <= side; y += 1) {
    for (let x = 0; x <= side; x += 1) {
      vertices.push(`v ${x} ${y} ${(8 * Math.sin(x / 9) * Math.cos(y / 11)).toFixed(3)}`);
      const [a, b] = [y * (side + 1) + x + 1, (y + 1) * (side + 1) + x + 1];
      if (x < side && y < side) faces.push(`f ${a} ${a + 1} ${b + 1}`, `f ${a} ${b + 1} ${b}`);
    }
  }
  return { vertices, faces };
}

/** Number of positions of the model whose vertices have one normal, and of those that have several. */
function normals(page) {
  return page.evaluate(() => {
    const found = new Map();
    window.striataViewer.model.traverse(({ geometry }) => {
      const [positions, normals] = ['position', 'normal'].map((name) => geometry?.getAttribute(name));
      for (let vertex = 0; vertex < (normals?.count ?? 0); vertex += 1) {
        const key = [0, 1, 2].map((i) => positions.getComponent(vertex, i).toFixed(5)).join(' ');
        const normal = [0, 1, 2].map((i) => normals.getComponent(vertex, i).toFixed(2) * 1).join(' ');
        found.set(key, (found.get(key) ?? new Set()).add(normal));
      }
    });
    const sizes = [...found.values()].map(({ size }) => size);
    return { smooth: sizes.filter((size) => size === 1).length, sharp: sizes.filter((size) => size > 1).length };
  });
}

/** A GLB file with one more clip, whose keyframes are many: a stream sends them late. */
function withLongClip(glb) {
  const length = glb.readUInt32LE(12);
  const json = JSON.parse(glb.subarray(20, 20 + length));
  const data = glb.subarray(28 + length);
  const count = 20_000;
  const times = Float32Array.from({ length: count }, (_, at) => at / 100);
  const places = Float32Array.from({ length: 3 * count }, (_, at) => 0.1 * Math.sin(at * at));
  const parts = [times, places].map(({ buffer }) => Buffer.from(buffer));
  const views = parts.map(({ length: byteLength }, at) => ({ buffer: 0, byteOffset: data.length + at * parts[0].length, byteLength }));
  const first = json.bufferViews.push(...views) - 2;
  const accessors = [
    { bufferView: first, componentType: 5126, count, type: 'SCALAR', min: [0], max: [times[count - 1]] },
    { bufferView: first + 1, componentType: 5126, count, type: 'VEC3' },
  ];
  const input = json.accessors.push(...accessors) - 2;
  const node = json.nodes.findIndex(({ mesh }) => mesh !== undefined);
  json.animations.push({ name: 'long', channels: [{ sampler: 0, target: { node, path: 'translation' } }], samplers: [{ input, output: input + 1 }] });
  const all = Buffer.concat([data, ...parts]);
  json.buffers = [{ byteLength: all.length }];
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const head = Buffer.alloc(20);
  [0x46546c67, 2, 28 + padded.length + all.length, padded.length, 0x4e4f534a].forEach((word, at) => head.writeUInt32LE(word, 4 * at));
  const chunk = Buffer.alloc(8);
  [all.length, 0x004e4942].forEach((word, at) => chunk.writeUInt32LE(word, 4 * at));
  return Buffer.concat([head, padded, chunk, all]);
}

async function opened(page, name) {
  await page.waitForFunction((name) => window.striataViewer.model && window.striataViewer.name === name, name);
  await untilWhole(page);
  await settled(page);
}

export default function opening(world) {
  const at = (name) => join(world.folder, name);

  pageTest(world, 'a model that the page simplifies is inside the picture, at any level and after "Reset view"', {}, async (page) => {
    await page.goto(world.url);
    for (const shape of ['icosphere', 'torus']) {
      run('convert', '-q', `shape:${shape}`, at('framed.glb'));
      await drop(page, 'framed.glb', readFileSync(at('framed.glb')));
      await opened(page, 'framed.glb');
      assert.ok((await farthest(page)) < 1.001, `${shape} is cut off: ${await farthest(page)}`);
      assert.ok((await farthest(page)) > 0.6, `${shape} is tiny`);
      await slide(page, 'detail', 0);
      await settled(page);
      await page.locator('#reset').click();
      await slide(page, 'detail', 1000);
      await settled(page);
      assert.ok((await farthest(page)) < 1.001, `${shape} is cut off after the view was reset at a coarse level`);
      await page.evaluate(() => window.striataViewer.close());
    }
  });

  pageTest(world, 'animations that arrive after the first picture play', {}, async (page) => {
    writeFileSync(at('late.glb'), withLongClip(readFileSync(at('plain-arm.glb'))));
    run('encode', '-q', at('late.glb'), '-o', at('late.stri'));
    await page.goto(world.url);
    await page.evaluate(async () => {
      const { striataViewer: viewer } = window;
      const { onShown } = viewer;
      viewer.onShown = () => {
        window.earlyClips = viewer.model.animations.length;
        onShown();
      };
      const bytes = new Uint8Array(await (await fetch('models/late.stri')).arrayBuffer());
      const step = Math.ceil(bytes.length / 40);
      let at = 0;
      const data = new ReadableStream({
        async pull(controller) {
          await new Promise((resolve) => setTimeout(resolve, 30));
          controller.enqueue(bytes.slice(at, (at += step)));
          if (at >= bytes.length) controller.close();
        },
      });
      await viewer.open({ data, name: 'late.stri', url: null });
    });
    await opened(page, 'late.stri');
    assert.equal(await page.evaluate(() => window.earlyClips), 0, 'the clips arrive after the model is shown');
    await page.locator('#playback').waitFor();
    assert.ok(await page.evaluate(() => window.striataViewer.playback.duration > 0));
    assert.ok((await farthest(page)) < 1.001, 'the model is framed in all poses');
  });

  pageTest(world, 'formats that only the command reads open, too: Draco, 3MF, VTK', {}, async (page) => {
    const spot = at('spot.striata');
    run('convert', '-q', at('torus.obj'), at('draco.glb'), '--draco');
    run('extract', '-q', spot, '--ratio', '1', '-o', at('spot.3mf'));
    run('extract', '-q', spot, '--ratio', '1', '-o', at('spot.vtp'));
    const torus = readFileSync(at('torus.obj')).toString().match(/^f /gm).length;
    await page.goto(world.url);
    for (const [name, triangles] of [['draco.glb', torus], ['spot.3mf', 5856], ['spot.vtp', 5856]]) {
      await drop(page, name, readFileSync(at(name)));
      await opened(page, name);
      assert.equal((await state(page)).fullTriangleCount, triangles, name);
      assert.equal(await page.locator('#title').innerText(), name);
      assert.ok((await drawnPixels(page)) > 10_000, `${name} is visible`);
      assert.equal(await page.locator('.notice').count(), 0);
    }
    const { smooth, sharp } = await normals(page);
    assert.ok(smooth > 9 * sharp, `spot is smooth: ${smooth} and ${sharp}`);
  });

  pageTest(world, 'levels of .striata files are shown as they are stored, whatever the models', {}, async (page) => {
    const spot = join(workspace, 'assets/spot.obj.zst');
    run('build', '-q', spot, '-o', at('lists.striata'));
    run('build', '-q', spot, '-o', at('patterns.striata'), '--models', 'patterns');
    run('build', '-q', 'shape:torus', '-o', at('removed.striata'), '--order', 'hausdorff', '--models', 'fans');
    await page.goto(world.url);
    const names = ['lists.striata', 'patterns.striata', 'removed.striata', 'arm.striata'];
    for (const name of names) {
      await drop(page, name, readFileSync(at(name)));
      await opened(page, name);
      // The slider stays where it was for the last model.
      await slide(page, 'detail', 1000);
      await settled(page);
      const whole = await state(page);
      assert.ok(whole.complete && whole.triangleCount === whole.fullTriangleCount, name);
      assert.equal(await page.evaluate(() => window.striataViewer.model.timings.buildMs), 0, `${name} is not built again`);
      assert.match(await page.locator('#subtitle').innerText(), /\.striata file/);
      assert.ok((await drawnPixels(page)) > 10_000, `${name} is visible`);
      const flat = await page.evaluate(() => {
        const found = [];
        window.striataViewer.model.traverse(({ material }) => material && found.push(material.flatShading));
        return found;
      });
      assert.ok(flat.every((isFlat) => !isFlat), `${name} has smooth normals`);
      await slide(page, 'detail', 500);
      await settled(page);
      const coarse = (await state(page)).triangleCount;
      assert.ok(coarse > 0 && coarse < whole.triangleCount, name);
    }
    assert.ok(await page.evaluate(() => window.striataViewer.playback.duration > 0), 'the arm moves');
    const views = await page.evaluate(async () => {
      const { model } = window.striataViewer;
      const counts = [];
      for (const pixels of [30, 0.5]) {
        model.pixelError = pixels;
        await new Promise((resolve) => setTimeout(resolve, 500));
        counts.push(model.triangleCount);
      }
      return counts;
    });
    assert.ok(views[0] < views[1], `the view refines a stored scene: ${views}`);
    await drop(page, 'cut.striata', readFileSync(at('arm.striata')).subarray(0, 20_000));
    await page.locator('.notice strong', { hasText: 'Cannot open cut.striata' }).waitFor();
    assert.match(await page.locator('.notice').first().innerText(), /bytes/);
  });

  pageTest(world, 'the first levels of a large .striata file are shown before the others', {}, async (page) => {
    const { vertices, faces } = waves(330);
    writeFileSync(at('waves.obj'), [...vertices, ...faces].join('\n'));
    run('build', '-q', at('waves.obj'), '-o', at('waves.striata'));
    await page.goto(world.url);
    await page.evaluate(() => {
      window.states = [];
      const watch = () => {
        const model = window.striataViewer.model;
        if (model) window.states.push([model.complete, model.triangleCount, model.fullTriangleCount]);
        if (!model?.complete) requestAnimationFrame(watch);
      };
      watch();
    });
    await drop(page, 'waves.striata', readFileSync(at('waves.striata')));
    await opened(page, 'waves.striata');
    await untilWhole(page);
    await page.waitForFunction(() => window.states.at(-1)?.[0]);
    const states = await page.evaluate(() => window.states);
    const [complete, shown, full] = states[0];
    assert.ok(!complete && shown > 0 && shown <= 50_000 && full === faces.length, `${states[0]}`);
    await slide(page, 'detail', 1000);
    await settled(page);
    assert.equal((await state(page)).triangleCount, faces.length);
    assert.equal((await normals(page)).sharp, 0);
  });

  pageTest(world, 'a large plain file is shown before its levels are built', {}, async (page) => {
    const { vertices, faces } = waves(330);
    await page.goto(world.url);
    await drop(page, 'grid.obj', Buffer.from([...vertices, ...faces].join('\n')));
    await page.waitForFunction(() => window.striataViewer.model);
    await page.locator('#subtitle', { hasText: /triangles, building levels of detail/ }).waitFor();
    const before = await state(page);
    assert.equal(before.complete, false);
    assert.deepEqual([before.triangleCount, before.fullTriangleCount], [faces.length, faces.length]);
    assert.ok((await drawnPixels(page)) > 10_000, 'it is visible');
    await opened(page, 'grid.obj');
    assert.match(await page.locator('#subtitle').innerText(), /simplified in the browser/);
    await slide(page, 'detail', 500);
    await settled(page);
    const { triangleCount } = await state(page);
    assert.ok(triangleCount > 0 && triangleCount < faces.length, `${triangleCount} triangles`);
  });

  pageTest(world, 'backs of triangles are hidden only if they cannot be seen', {}, async (page) => {
    const sides = () => page.evaluate(() => {
      const found = new Set();
      window.striataViewer.model.traverse(({ material }) => material && found.add(material.side));
      return [...found];
    });
    const lines = readFileSync(at('torus.obj')).toString().split('\n');
    const faces = lines.filter((line) => line.startsWith('f '));
    const inverted = faces.map((face) => `f ${face.slice(2).split(' ').reverse().join(' ')}`);
    const vertices = lines.filter((line) => line.startsWith('v '));
    await page.goto(world.url);
    for (const [name, shown, isSolid] of [['solid.obj', faces, true], ['open.obj', faces.slice(9), false], ['inverted.obj', inverted, false]]) {
      await drop(page, name, Buffer.from([...vertices, ...shown].join('\n')));
      await opened(page, name);
      await page.waitForFunction((isSolid) => window.striataViewer.model.isSolid === isSolid, isSolid);
      const [front, both] = [0, 2];
      assert.deepEqual(await sides(), [isSolid ? front : both], name);
    }
    run('build', '-q', at('torus.obj'), '-o', at('solid.striata'));
    for (const name of ['nefertiti.stri', 'icosphere.stri', 'solid.striata']) {
      await drop(page, name, readFileSync(at(name)));
      await opened(page, name);
      await page.waitForFunction(() => window.striataViewer.model.isSolid);
    }
  });

  pageTest(world, 'an OBJ without normals is smooth up to creases', {}, async (page) => {
    await page.goto(world.url);
    await drop(page, 'torus.obj', readFileSync(at('torus.obj')));
    await opened(page, 'torus.obj');
    assert.equal((await normals(page)).sharp, 0);
    const corners = Array.from({ length: 8 }, (_, i) => `v ${i & 1} ${(i >> 1) & 1} ${i >> 2}`).join('\n');
    const faces = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'].map((face) => `f ${face}`).join('\n');
    await drop(page, 'cube.obj', Buffer.from(`${corners}\n${faces}\n`));
    await opened(page, 'cube.obj');
    assert.deepEqual(await normals(page), { smooth: 0, sharp: 8 });
  });

  pageTest(world, 'each part of a mesh counts its own triangles', {}, async (page) => {
    const lines = readFileSync(at('torus.obj')).toString().split('\n');
    const faces = lines.filter((line) => line.startsWith('f '));
    const few = Math.floor(faces.length / 4);
    const text = [...lines.filter((line) => !line.startsWith('f ')), 'usemtl few', ...faces.slice(0, few), 'usemtl many', ...faces.slice(few)];
    await page.goto(world.url);
    await drop(page, 'parts.obj', Buffer.from(text.join('\n')));
    await opened(page, 'parts.obj');
    const numbers = async () => (await page.locator('#tree .name small').allInnerTexts()).map((text) => text.replaceAll(',', ''));
    assert.deepEqual(await numbers(), [few, faces.length - few].map(String));
    await slide(page, 'detail', 700);
    await settled(page);
    const shown = (await numbers()).map((text) => text.split(' of ').map(Number));
    assert.deepEqual(shown.map(([, full]) => full), [few, faces.length - few]);
    assert.equal(shown[0][0] + shown[1][0], (await state(page)).triangleCount);
  });

  pageTest(world, 'messages are those of the command, and keep the names of files', {}, async (page) => {
    await openModel(world, page, 'icosphere.stri');
    const glb = readFileSync(at('plain-arm.glb'));
    const cases = [
      ['cut.glb', glb.subarray(0, 3000), /Cannot open cut\.glb[^]*the header declares \d+ bytes, found 3000/i],
      ['cut.obj', Buffer.from('v 0 0 0\nv 1 0\n'), /Cannot open cut\.obj[^]*The file has 2 points \(1 [^]*line 2: expected/],
      ['points.ply', Buffer.from('ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n'), /points/],
      ['start.glb', Buffer.from('<!DOCTYPE html><html><body>home</body></html>'), /Cannot open start\.glb[^]*start\.glb is a web page/],
    ];
    for (const [name, bytes, expected] of cases) {
      await drop(page, name, bytes);
      await page.locator('.notice strong', { hasText: name }).waitFor();
      const text = await page.locator('.notice').first().innerText();
      assert.match(text, expected);
      assert.doesNotMatch(text, /typed array|undefined|THREE|RangeError|Start\.glb|Cut\./);
    }
    assert.equal((await state(page)).triangleCount, 20_480, 'the model is still shown');
  });

  pageTest(world, 'the size of a glTF document includes its files', {}, async (page) => {
    mkdirSync(at('gltf'), { recursive: true });
    run('convert', '-q', join(world.folder, 'plain-arm.glb'), at('gltf/arm.gltf'));
    const document = JSON.parse(readFileSync(at('gltf/arm.gltf')));
    const [buffer] = document.buffers;
    if (buffer.uri === undefined || buffer.uri.startsWith('data:')) {
      writeFileSync(at('gltf/arm data.bin'), Buffer.from(buffer.uri.split(',')[1], 'base64'));
      buffer.uri = 'arm%20data.bin';
      writeFileSync(at('gltf/arm.gltf'), JSON.stringify(document));
    }
    await page.waitForTimeout(1100);
    const { models } = await (await page.request.get(`${world.url}models.json`)).json();
    const listed = models.find(({ path }) => path === 'gltf/arm.gltf').bytes;
    const text = readFileSync(at('gltf/arm.gltf')).length;
    assert.ok(listed >= text + buffer.byteLength, `${listed} bytes`);
    await openModel(world, page, 'gltf/arm.gltf');
    const { bytesReceived } = await state(page);
    assert.ok(bytesReceived >= text + buffer.byteLength, `${bytesReceived} bytes`);
  });
}
