// Checks files with STRIATA_order that have index ranges: `node check.mjs FILE.glb ...`. Each range must have the same
// triangles as the level of its vertices by the rule of the extension; Rust tests compare both with the library.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { levelIndices, openGlb, rowForError } from './order.mjs';

/** The triangles of a list, in an order that depends on nothing but them. */
function sorted(indices) {
  const triangles = [];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = indices.subarray(i, i + 3);
    triangles.push(String(a < b && a < c ? [a, b, c] : b < c ? [b, c, a] : [c, a, b]));
  }
  return triangles.sort();
}

for (const file of process.argv.slice(2)) {
  const { json, integers } = openGlb(new Uint8Array(readFileSync(file)));
  let count = 0;
  for (const primitive of json.meshes.flatMap((mesh) => mesh.primitives)) {
    const order = primitive.extensions?.STRIATA_order;
    for (const [first, length, n, error] of order?.ranges ?? []) {
      const level = levelIndices(integers(primitive.indices), integers(order.targets), n);
      const range = integers(order.indices).subarray(first, first + length);
      assert.deepEqual(sorted(level), sorted(range), `${file}: ${n} vertices`);
      assert(rowForError(order.levels, error)[0] <= n);
      count++;
    }
  }
  assert(count > 0, `${file} has no ranges`);
  console.log(`${file}: ${count} levels are equal`);
}
