/** Triangles in colors of their own: no two share a vertex, so each can have any color. */

import { BufferAttribute, BufferGeometry, Color, SRGBColorSpace } from 'three';

/** Colors are told by hue alone, this many of them. */
const HUE_COUNT = 1024;
/** What multiplies a number so that neighbors get hues that lie far apart: the golden ratio's share of 2^32. */
const SCATTER = 0x9e3779b1;

const palette = makePalette();

/** A geometry of its own for triangles with a number each. */
export function painted(positions: ArrayLike<number>, indices: ArrayLike<number>, numbers: ArrayLike<number>): BufferGeometry {
  const corner = { positions: new Float32Array(3 * indices.length), colors: new Uint8Array(4 * indices.length) };
  for (let at = 0; at < indices.length; at++) {
    const from = 3 * indices[at]!;
    const hue = 3 * (Math.imul(numbers[(at / 3) | 0]!, SCATTER) >>> 22);
    for (let i = 0; i < 3; i++) {
      corner.positions[3 * at + i] = positions[from + i]!;
      corner.colors[4 * at + i] = palette[hue + i]!;
    }
    corner.colors[4 * at + 3] = 255;
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corner.positions, 3));
  geometry.setAttribute('color', new BufferAttribute(corner.colors, 4, true));
  return geometry;
}

function makePalette(): Uint8Array {
  const bytes = new Uint8Array(3 * HUE_COUNT);
  const color = new Color();
  for (let at = 0; at < HUE_COUNT; at++) {
    // Three lightnesses, so that hues that lie near each other differ too.
    color.setHSL(at / HUE_COUNT, 0.62, 0.5 + 0.1 * (at % 3), SRGBColorSpace);
    [color.r, color.g, color.b].forEach((share, i) => (bytes[3 * at + i] = Math.round(255 * share)));
  }
  return bytes;
}
