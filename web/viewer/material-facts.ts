/** What a material looks like, in a few words. */

import { Color, DoubleSide, type Material, type Texture } from 'three';

export interface MaterialFacts {
  name: string;
  /** Base color as a CSS color. */
  color: string;
  /** Textures and properties that change how it is drawn. */
  details: string[];
}

/** Texture slots of a three.js standard material, as people call them. */
const SLOTS = [
  ['map', 'base color'], ['normalMap', 'normals'], ['roughnessMap', 'roughness'], ['emissiveMap', 'emission'], ['aoMap', 'occlusion'],
] as const;

/** Describes a material. */
export function describeMaterial(material: Material): MaterialFacts {
  const slots = material as Material & Partial<Record<string, Texture | null>>;
  const color = (material as { color?: Color }).color ?? new Color(1, 1, 1);
  const details = SLOTS.flatMap(([slot, name]) => {
    const texture = slots[slot];
    return texture ? [slot === 'map' ? textureName(texture) : name] : [];
  });
  if (material.vertexColors) details.push('vertex colors');
  if (material.transparent) details.push('blended');
  else if (material.alphaTest > 0) details.push('cut out');
  if (material.side === DoubleSide) details.push('double-sided');
  return { name: material.name || 'Material', color: `#${color.getHexString()}`, details };
}

/** Name of a texture, or its size. */
function textureName(texture: Texture): string {
  if (texture.name) return texture.name;
  const { width, height } = (texture.image ?? {}) as { width?: number; height?: number };
  return width && height ? `texture ${width} × ${height}` : 'texture';
}
