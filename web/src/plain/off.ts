/** Reads OFF files: text, with colors and normals of vertices, and faces of any number of corners. */

import { BufferAttribute, BufferGeometry } from 'three';
import { StriataError } from '../error.ts';

/** Whether a file is in this format. */
export function isOff(text: string): boolean {
  return /^\s*(?:#[^\n]*\n\s*)*(?:ST)?C?N?OFF\b/.test(text);
}

/** Parses a file; faces are cut into fans of triangles. */
export function parseOff(text: string): BufferGeometry {
  const lines = text.split('\n').map((line) => line.replace(/#.*/, '').trim()).filter((line) => line !== '');
  const header = /^((?:ST)?C?N?)OFF\b(.*)/.exec(lines[0] ?? '');
  if (!header) throw new StriataError('format', 'the file does not start with OFF');
  if (/\bBINARY\b/.test(header[2]!)) throw new StriataError('unsupported', 'binary OFF files cannot be read', 'convert it with `striata convert`');
  let at = 1;
  const counts = (header[2]!.trim() || lines[at++] || '').split(/\s+/).map(Number);
  const [vertexCount = NaN, faceCount = NaN] = counts;
  if (!(vertexCount >= 0 && faceCount >= 0 && vertexCount + faceCount <= lines.length)) {
    throw new StriataError('corrupt', `the file has ${lines.length} lines, too few for ${counts.slice(0, 2).join(' + ')} vertices and faces`);
  }
  const hasNormals = header[1]!.includes('N');
  const [positions, normals, colors] = [new Float32Array(3 * vertexCount), new Float32Array(3 * vertexCount), new Float32Array(4 * vertexCount)];
  let hasColors = header[1]!.includes('C');
  for (let vertex = 0; vertex < vertexCount; vertex++) {
    const numbers = lines[at++]!.split(/\s+/).map(Number);
    if (numbers.length < 3 || numbers.some(Number.isNaN)) throw new StriataError('corrupt', `vertex ${vertex} is not three numbers`);
    positions.set(numbers.slice(0, 3), 3 * vertex);
    if (hasNormals) normals.set(numbers.slice(3, 6), 3 * vertex);
    const color = numbers.slice(hasNormals ? 6 : 3);
    if (color.length < 3) hasColors = false;
    // Whole numbers go up to 255, others up to 1.
    else if (hasColors) colors.set([0, 1, 2, 3].map((i) => (color[i] ?? Infinity)).map((x, _, all) => (x === Infinity ? 1 : all.some((y) => y > 1 && y < Infinity) ? x / 255 : x)), 4 * vertex);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  if (hasNormals) geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  if (hasColors) geometry.setAttribute('color', new BufferAttribute(colors, 4));
  geometry.setIndex(new BufferAttribute(facesOf(lines.slice(at, at + faceCount), vertexCount), 1));
  return geometry;
}

function facesOf(lines: string[], vertexCount: number): Uint32Array {
  const corners: number[] = [];
  lines.forEach((line, face) => {
    const [count = NaN, ...rest] = line.split(/\s+/).map(Number);
    const own = rest.slice(0, count);
    if (own.length !== count || own.some((corner) => !(corner >= 0 && corner < vertexCount))) {
      throw new StriataError('corrupt', `face ${face} has corners that are not vertices`);
    }
    for (let i = 2; i < count; i++) corners.push(own[0]!, own[i - 1]!, own[i]!);
  });
  return Uint32Array.from(corners);
}
