// Tests of the add-on in the web template of Godot: `npm ci && npm test`. Needs Chromium and the command (see models.mjs).

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

import { missing, project, run } from './engine.mjs';
import { ROOT, build, cannotBuild, inFolder, malformed, openGlb, partial, testModels } from './models.mjs';

const reason = missing() ?? cannotBuild();
if (reason) {
  console.log(`skipped: ${reason}`);
  process.exit(0);
}

/** The rule of the guide, which is what every reader must agree with. */
const guide = readFileSync(join(ROOT, 'docs/guide/engines.md'), 'utf8');
const levelIndices = new Function(`${guide.match(/```js\n([\s\S]*?)```/)[1]}; return levelIndices;`)();

const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** Returns the numbers of an accessor with tightly packed or interleaved elements. */
function numbers({ json, binary }, index) {
  const accessor = json.accessors[index];
  const width = WIDTHS[accessor.type];
  const values = new Float64Array(accessor.count * width);
  const kinds = { 5121: [1, 'readUInt8'], 5123: [2, 'readUInt16LE'], 5125: [4, 'readUInt32LE'], 5126: [4, 'readFloatLE'] };
  const read = (viewIndex, byteOffset = 0, componentType, count, components) => {
    const view = json.bufferViews[viewIndex];
    const [bytes, name] = kinds[componentType];
    const stride = view.byteStride ?? bytes * components;
    const start = (view.byteOffset ?? 0) + byteOffset;
    return Array.from({ length: count * components }, (_, i) => binary[name](start + Math.floor(i / components) * stride + (i % components) * bytes));
  };
  if (accessor.bufferView !== undefined) values.set(read(accessor.bufferView, accessor.byteOffset, accessor.componentType, accessor.count, width));
  if (accessor.sparse) {
    const { count, indices, values: changed } = accessor.sparse;
    const places = read(indices.bufferView, indices.byteOffset, indices.componentType, count, 1);
    const rows = read(changed.bufferView, changed.byteOffset, accessor.componentType, count, width);
    places.forEach((place, i) => values.set(rows.slice(i * width, (i + 1) * width), place * width));
  }
  return values;
}

const floats = (text) => new Float32Array(Uint8Array.from(Buffer.from(text, 'base64')).buffer);
const integers = (text) => new Int32Array(Uint8Array.from(Buffer.from(text, 'base64')).buffer);

/**
 * Triangles without regard to the numbers of vertices: each corner is its attributes. Those without area that stand for an
 * empty level are left out.
 */
function soup(indices, arrays) {
  const corner = (v) => arrays.map(([values, width]) => Array.from(values.subarray(v * width, (v + 1) * width), Math.fround).join(' ')).join(' ');
  const triangles = [];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [indices[i], indices[i + 1], indices[i + 2]];
    if (a === b && b === c) continue;
    const [p, q, r] = [corner(a), corner(b), corner(c)];
    triangles.push(p <= q && p <= r ? `${p}|${q}|${r}` : q <= r ? `${q}|${r}|${p}` : `${r}|${p}|${q}`);
  }
  return triangles.sort();
}

const clockwise = (indices) => Array.from(indices, (_, i) => indices[i % 3 === 0 ? i : i % 3 === 1 ? i + 1 : i - 1]);

/** The rows of a table that become levels by the default settings. */
function chosenRows(orders, { most = 16, ratio = 0.75, least = 12 } = {}) {
  const chosen = [];
  const sum = (row) => orders.reduce((total, order) => total + order.levels[row][1], 0);
  let last = sum(0);
  for (let row = 1; row < orders[0].levels.length && chosen.length + 1 < most && sum(row) >= least; row++) {
    if (sum(row) > last * ratio) continue;
    chosen.push(row);
    last = sum(row);
  }
  return chosen;
}

const close = (a, b) => Math.abs(a - b) <= 1e-6 * Math.max(Math.abs(a), Math.abs(b), 1e-12);

/** Compares what the engine has of a model with the rule. Returns the number of levels, and of vertices and triangles that were added. */
function checkModel(name, bytes, result) {
  const file = openGlb(bytes);
  const count = { levels: 0, appended: 0, padded: 0 };
  assert.deepEqual(result.kept, [], name);
  assert.deepEqual(result.scene, result.plain_scene, name);
  const drawn = result.scene.filter(([, kind]) => kind === 'MeshInstance3D');
  assert(drawn.length > 0, name);
  const skins = (file.json.nodes ?? []).filter((node) => node.skin !== undefined).length;
  assert.equal(drawn.filter(([, , , binds]) => binds > 0).length, skins, `${name}: skins`);
  assert.equal(result.scene.filter(([, kind]) => kind === 'AnimationPlayer').length, file.json.animations ? 1 : 0, `${name}: animations`);
  file.json.meshes.forEach((mesh, m) => {
    const orders = mesh.primitives.map((primitive) => primitive.extensions.STRIATA_order);
    const rows = orders[0].ranges ? orders[0].ranges.map((_, row) => row).slice(1) : chosenRows(orders);
    const targets = numbers(file, orders[0].targets);
    // Levels with the same error are one, the coarsest of them.
    const levels = rows.filter((row, i) => i + 1 === rows.length || orders[0].levels[rows[i + 1]][2] !== orders[0].levels[row][2]);
    const sums = [0, ...levels].map((row) => orders.reduce((sum, order) => sum + order.levels[row][1], 0));
    const { surfaces, rows: table, array_rows: arrayTable } = result.meshes[m];
    assert.deepEqual(arrayTable, table, `${name}: the table of the mesh and of its array mesh differ`);
    const isExact = surfaces.every((surface, s) => integers(surface.indices).length === 3 * orders[s].levels[0][1] && orders[s].levels.every((row) => row[1] > 0));
    if (isExact) assert.deepEqual(table.map((row) => row.triangles).slice(0, sums.length), sums.filter((sum, i) => i === 0 || sum !== sums[i - 1]).slice(0, table.length), name);
    mesh.primitives.forEach((primitive, s) => {
      const surface = surfaces[s];
      const own = [[floats(surface.positions), 3]];
      const theirs = [[numbers(file, primitive.attributes.POSITION), 3]];
      const also = (text, attribute, width, read) => {
        if (primitive.attributes[attribute] === undefined) return;
        own.push([read(text), width]);
        theirs.push([numbers(file, primitive.attributes[attribute]), width]);
      };
      also(surface.uvs, 'TEXCOORD_0', 2, floats);
      also(surface.bones, 'JOINTS_0', 4, integers);
      (primitive.targets ?? []).forEach((target, shape) => {
        const moved = numbers(file, target.POSITION);
        own.push([floats(surface.shapes[shape]), 3]);
        theirs.push([moved.map((delta, i) => Math.fround(delta) + Math.fround(theirs[0][0][i])), 3]);
      });
      const full = numbers(file, primitive.indices);
      assert.deepEqual(soup(integers(surface.indices), own), soup(clockwise(full), theirs), `${name}: full mesh`);
      count.appended += own[0][0].length / 3 - new Set(full).size;
      count.padded += integers(surface.indices).length / 3 - orders[s].levels[0][1];
      for (const row of levels) {
        const [n, triangles, error] = orders[s].levels[row];
        const expected = levelIndices(full, targets, n);
        assert.equal(expected.length, 3 * triangles, `${name}: the table of the file`);
        // The engine draws the coarsest list with at most this error.
        const lod = surface.lods.filter((lod) => lod.error <= error || close(lod.error, error)).at(-1);
        const drawn = lod ? integers(lod.indices) : integers(surface.indices);
        assert.deepEqual(soup(drawn, own), soup(clockwise(expected), theirs), `${name}: mesh ${m}, surface ${s}, ${n} vertices`);
        count.levels++;
      }
      surface.lods.forEach((lod, i) => assert(i === 0 || lod.error > surface.lods[i - 1].error, `${name}: errors must rise`));
    });
  });
  return count;
}

await inFolder(async (folder) => {
  const models = testModels(folder);
  const broken = malformed(models.get('spot-ranges.glb'));
  const resources = new Map([['spot.tres', build(folder, join(ROOT, 'assets/spot.obj.zst'), 'spot.tres')]]);

  const files = project(readFileSync(new URL('main.gd', import.meta.url)), [640, 480]);
  const addon = join(ROOT, 'engines/godot/addons/striata');
  readdirSync(addon).forEach((name) => files.set(`addons/striata/${name}`, readFileSync(join(addon, name))));
  for (const [place, set] of [['models', models], ['malformed', new Map([...broken].map(([name, { bytes }]) => [name, bytes]))], ['resources', resources], ['partial', new Map([['speck.glb', partial(models.get('speck.glb'))]])]]) set.forEach((bytes, name) => files.set(`${place}/${name}`, bytes));
  // The classes of the editor do not exist in the template.
  const stub = (name, lines) => readFileSync(join(addon, name), 'utf8').replaceAll(/^extends .*$/gm, lines).replaceAll(/: Editor\w+/g, '').replaceAll('preload("', 'preload("res://addons/striata/');
  files.set('stubs/plugin.gd', stub('plugin.gd', `extends Node
var inspectors: Array = []
func add_inspector_plugin(inspector: RefCounted) -> void: inspectors.append(inspector)
func remove_inspector_plugin(inspector: RefCounted) -> void: inspectors.erase(inspector)`).replace('res://addons/striata/level_inspector.gd', 'res://stubs/level_inspector.gd'));
  files.set('stubs/level_inspector.gd', stub('level_inspector.gd', `extends RefCounted
var controls: Array = []
func add_custom_control(control: Control) -> void: controls.append(control)`));
  const { results, messages } = await run(files, [640, 480]);
  const of = (key) => results.filter((result) => key in result);
  const section = (name) => {
    const start = messages.indexOf(`IMPORT ${name}`);
    return messages.slice(start + 1, messages.findIndex((text, i) => i > start && text.startsWith('IMPORT '))).join('\n');
  };

  assert.equal(of('model').length, models.size);
  const all = { levels: 0, appended: 0, padded: 0 };
  for (const result of of('model')) {
    const counts = checkModel(result.model, models.get(result.model), result);
    assert(counts.levels > 0);
    for (const key in all) all[key] += counts[key];
    console.log(`${result.model}: ${counts.levels} levels of surfaces equal the rule`);
  }
  console.log(`${all.levels} levels of surfaces equal the rule; ${all.appended} vertices of other surfaces and ${all.padded} triangles without area were added`);
  assert(all.appended > 0 && all.padded > 0, 'no model needs what the add-on adds');

  assert.equal(of('malformed').length, broken.size);
  for (const { malformed: name, rows } of of('malformed')) {
    assert.equal(rows, 1, `${name} has levels`);
    const message = section(name).match(/STRIATA_order of mesh 0 \("broken by .*"\) of .* is malformed and was ignored: (.*)/)?.[1];
    assert(message?.includes(broken.get(name).message), `${name}: ${message}`);
  }
  console.log(`${broken.size} malformed files are refused by name`);

  const [first, second] = of('partial')[0].partial;
  assert(first > 0 && second === 0, `${first} and ${second} levels`);
  assert.match(section('partial'), /WARNING: 1 surfaces of mesh 0 .* have no STRIATA_order/);

  assert.equal(of('cut')[0].cut, 1);
  assert.match(messages.slice(messages.indexOf('IMPORT cut')).join('\n'), /levels of mesh 0 .* were left out: the importer changed/);
  console.log('a changed mesh stays at full detail, with a warning');

  const spot = openGlb(models.get('spot.glb')).json.meshes[0].primitives[0].extensions.STRIATA_order;
  const triangles = (rows) => [spot.levels[0][1], ...rows.map((row) => spot.levels[row][1])];
  const bySetting = (name) => of('setting').find((result) => result.setting.endsWith(name)).rows.map((row) => row.triangles);
  assert.deepEqual(bySetting('maximum_level_count'), triangles(chosenRows([spot], { most: 3 })));
  assert.deepEqual(bySetting('maximum_triangle_ratio'), triangles(chosenRows([spot], { ratio: 0.3 })));
  assert.deepEqual(bySetting('minimum_triangle_count'), triangles(chosenRows([spot], { least: 500 })));
  assert.deepEqual(bySetting('use_stored_ranges'), triangles(chosenRows([spot])));
  assert.deepEqual(bySetting('keep_from_generator'), triangles(chosenRows([spot])));
  console.log('the settings choose levels as they say');

  const resource = of('resource')[0].rows;
  assert.deepEqual(resource.map((row) => row.triangles), spot.levels.map((level) => level[1]));
  resource.forEach((row, i) => assert(close(row.error, spot.levels[i][2]), 'errors of spot.tres'));
  console.log(`spot.tres has the ${resource.length} levels of spot.glb`);

  const plugin = of('plugin')[0];
  assert.equal(plugin.plugin, 1 + chosenRows([spot]).length);
  assert.deepEqual(plugin.tables.map((texts) => texts.filter((_, i) => i % 3 === 1)), Array(3).fill(['Triangles', ...triangles(chosenRows([spot])).map(String)]));
  assert.deepEqual([plugin.handles_others, plugin.left, plugin.after, plugin.settings], [[false, false, false, false], 0, 1, true]);
  console.log('the plugin adds the import, its settings and the tables, and takes the import back');

  // The engine measures the distance to the box of the mesh, and pixels of the width of the screen.
  const { json } = openGlb(models.get('spot.glb'));
  const front = json.accessors[json.meshes[0].primitives[0].attributes.POSITION].max[2];
  const widthAtOne = 2 * Math.tan((75 / 2) * (Math.PI / 180)) * (640 / 480);
  const predicted = of('distance').map(({ distance }) => {
    const rows = chosenRows([spot]).filter((row) => (spot.levels[row][2] / ((distance - front) * widthAtOne)) * 640 <= 1);
    return triangles(rows).at(-1);
  });
  assert.deepEqual(of('distance').map((result) => result.drawn), predicted.map((count) => [count, count]));
  assert.equal(new Set(predicted).size, predicted.length);
  const difference = Math.max(...of('distance').map((result) => result.difference.root_mean_squared));
  assert(difference < 1, `spot.tres differs by ${difference}`);
  console.log(`the engine draws ${predicted.join(', ')} triangles of spot at distances of ${of('distance').map((result) => result.distance).join(', ')}; spot.tres differs by ${difference} of 255`);

  const expected = /malformed and was ignored|were left out: the importer changed|have no STRIATA_order/;
  const errors = messages.filter((text) => /^(USER )?(ERROR|WARNING|SCRIPT ERROR)/.test(text) && !expected.test(text));
  const known = /global script cache|Sparse indices buffer view size/;
  assert.deepEqual(errors.filter((text) => !known.test(text)), [], 'other messages of the engine');
});
