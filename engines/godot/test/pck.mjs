// Writes Godot packs (.pck, version 3): a header, the files, and a directory of their places.

import { createHash } from 'node:crypto';

const HEADER_BYTES = 112;
/** Places of files in the pack are multiples of this. */
const ALIGNMENT = 16;
/** The offsets of the directory count from the beginning of the files. */
const RELATIVE_OFFSETS = 2;

/** Returns the pack of some files, a `Map` from paths without `res://` to strings or bytes. */
export function pack(files) {
  const entries = [...files].map(([path, contents]) => ({ path: Buffer.from(path), bytes: Buffer.from(contents) }));
  const blocks = [];
  let end = 0;
  for (const entry of entries) {
    entry.offset = end;
    const padded = Buffer.alloc(Math.ceil(entry.bytes.length / ALIGNMENT) * ALIGNMENT);
    entry.bytes.copy(padded);
    blocks.push(padded);
    end += padded.length;
  }

  const header = Buffer.alloc(HEADER_BYTES);
  header.write('GDPC');
  [3, 4, 6, 0, RELATIVE_OFFSETS].forEach((number, index) => header.writeUInt32LE(number, 4 + 4 * index));
  header.writeBigUInt64LE(BigInt(HEADER_BYTES), 24);
  header.writeBigUInt64LE(BigInt(HEADER_BYTES + end), 32);
  return Buffer.concat([header, ...blocks, directory(entries)]);
}

function directory(entries) {
  const count = Buffer.alloc(4);
  count.writeUInt32LE(entries.length);
  const rows = entries.map(({ path, bytes, offset }) => {
    const length = Math.ceil(path.length / 4) * 4;
    const row = Buffer.alloc(4 + length + 36);
    row.writeUInt32LE(length);
    path.copy(row, 4);
    row.writeBigUInt64LE(BigInt(offset), 4 + length);
    row.writeBigUInt64LE(BigInt(bytes.length), 12 + length);
    createHash('md5').update(bytes).digest().copy(row, 20 + length);
    return row;
  });
  return Buffer.concat([count, ...rows]);
}
