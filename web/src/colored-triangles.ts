/** Triangles in individual colors: no two share a vertex, so each can have any color. */

import { BufferAttribute, BufferGeometry, Color, SRGBColorSpace } from 'three';

/** Number of colors, distinguished mainly by hue. */
const HUE_COUNT = 1024;
/** Multiplier that gives consecutive numbers distant hues: 2^32 divided by the golden ratio. */
const HUE_MULTIPLIER = 0x9e3779b1;

const palette = createPalette();

/** Builds a separate geometry in which each triangle has the color of its number. */
export function coloredTriangles(positions: ArrayLike<number>, indices: ArrayLike<number>, numbers: ArrayLike<number>): BufferGeometry {
  const corner = { positions: new Float32Array(3 * indices.length), colors: new Uint8Array(4 * indices.length) };
  for (let at = 0; at < indices.length; at++) {
    const from = 3 * indices[at]!;
    const hue = 3 * (Math.imul(numbers[(at / 3) | 0]!, HUE_MULTIPLIER) >>> 22);
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

function createPalette(): Uint8Array {
  const bytes = new Uint8Array(3 * HUE_COUNT);
  const color = new Color();
  for (let at = 0; at < HUE_COUNT; at++) {
    // Three alternating lightnesses, so that similar hues differ, too.
    color.setHSL(at / HUE_COUNT, 0.62, 0.5 + 0.1 * (at % 3), SRGBColorSpace);
    [color.r, color.g, color.b].forEach((channel, i) => (bytes[3 * at + i] = Math.round(255 * channel)));
  }
  return bytes;
}
