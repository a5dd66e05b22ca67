// Levels of glTF files with the extension STRIATA_order (docs/STRIATA_order.md), in browsers and Node.js.

/** Opens the bytes of a GLB file: its document, and a function that returns the integers of an accessor. */
export function openGlb(bytes) {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
  const integers = (index) => {
    const accessor = json.accessors[index], view = json.bufferViews[accessor.bufferView];
    const Integers = accessor.componentType === 5125 ? Uint32Array : Uint16Array;
    const start = 28 + length + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    return new Integers(bytes.slice(start, start + accessor.count * Integers.BYTES_PER_ELEMENT).buffer);
  };
  return { json, integers };
}

/** Returns the indices of the level with `n` vertices of a primitive. */
export function levelIndices(indices, targets, n) {
  const map = new Uint32Array(targets.length), out = new indices.constructor(indices.length);
  for (let i = 0; i < map.length; i++) map[i] = i < n ? i : map[targets[i]];
  let count = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const a = map[indices[i]], b = map[indices[i + 1]], c = map[indices[i + 2]];
    if (a === b || b === c || c === a) continue;
    out[count++] = a, out[count++] = b, out[count++] = c;
  }
  return out.slice(0, count);
}

/** Returns the row of the coarsest level whose error is at most `error` mesh units. */
export function rowForError(levels, error) {
  return levels.findLast((row) => row[2] <= error) ?? levels[0];
}
