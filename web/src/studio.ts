/**
 * A neutral light for materials: an environment that is the same for everybody who shows striata's models.
 *
 * Linear radiance by direction: a smooth step from the ground to the sky, and three soft lights.
 */

import { DataTexture, EquirectangularReflectionMapping, FloatType, LinearFilter, LinearSRGBColorSpace, RGBAFormat } from 'three';

const GROUND = [0.32, 0.29, 0.26];
const SKY = [0.8, 0.88, 1];

/** Soft lights: direction, radiance at the center, and how narrow it is. */
const LOBES = [
  { axis: [-0.55, 0.65, 0.75], radiance: [5, 4.7, 4.3], narrowness: 24 },
  { axis: [0.9, 0.25, 0.45], radiance: [1.1, 1.2, 1.4], narrowness: 8 },
  { axis: [0.3, 0.5, -0.85], radiance: [2.2, 2.2, 2.3], narrowness: 16 },
].map(({ axis, ...lobe }) => ({ ...lobe, axis: axis.map((x) => x / Math.hypot(...axis)) }));

const HEIGHT = 256;

/** Radiance from a unit direction, y being up. */
export function studioRadiance(x: number, y: number, z: number): number[] {
  const t = Math.min(1, Math.max(0, (0.5 + 0.5 * y - 0.35) / 0.3));
  const share = t * t * (3 - 2 * t);
  const color = GROUND.map((ground, i) => ground + (SKY[i]! - ground) * share);
  for (const { axis, radiance, narrowness } of LOBES) {
    const strength = Math.exp(narrowness * (x * axis[0]! + y * axis[1]! + z * axis[2]! - 1));
    radiance.forEach((channel, i) => (color[i]! += channel * strength));
  }
  return color;
}

/** Returns the environment as an equirectangular texture; set it as `scene.environment`, or pass it to a `PMREMGenerator`. */
export function studioEnvironment(): DataTexture {
  const [width, height] = [2 * HEIGHT, HEIGHT];
  const data = new Float32Array(4 * width * height);
  for (let row = 0; row < height; row++) {
    // Row 0 is at v = 0, where three.js looks straight down.
    const latitude = Math.PI * ((row + 0.5) / height - 0.5);
    for (let column = 0; column < width; column++) {
      const longitude = 2 * Math.PI * ((column + 0.5) / width - 0.5);
      const [x, y, z] = [Math.cos(latitude) * Math.cos(longitude), Math.sin(latitude), Math.cos(latitude) * Math.sin(longitude)];
      data.set([...studioRadiance(x, y, z), 1], 4 * (row * width + column));
    }
  }
  const texture = new DataTexture(data, width, height, RGBAFormat, FloatType);
  texture.mapping = EquirectangularReflectionMapping;
  texture.colorSpace = LinearSRGBColorSpace;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
