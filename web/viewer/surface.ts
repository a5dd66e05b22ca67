/** Materials of a model: whether it has any of its own, and how they are changed for the chosen appearance. */

import { type Color, type Material, Mesh, type Object3D, type Texture } from 'three';

/** Color of models without materials of their own. */
const CLAY = 0xcfc4b4;
const WHITE = 0xffffff;

/** Colors that mean that a material has none. */
const PLAIN = new Set([CLAY, WHITE]);

type SurfaceMaterial = Material & { flatShading?: boolean; color?: Color; map?: Texture | null };

/** Materials of everything that is drawn, each once. */
export function materialsOf(root: Object3D): Set<SurfaceMaterial> {
  const materials = new Set<SurfaceMaterial>();
  root.traverse((object) => {
    if (object instanceof Mesh) for (const material of [object.material as Material | Material[]].flat()) materials.add(material);
  });
  return materials;
}

/** Whether no material has a name, a texture, or a color other than white: those of a scan without materials of its own. */
export function isBare(materials: Iterable<SurfaceMaterial>): boolean {
  const isOwn = (material: SurfaceMaterial): boolean =>
    material.name !== '' || Boolean(material.map) || !PLAIN.has(material.color?.getHex() ?? WHITE);
  return ![...materials].some(isOwn);
}

/** Gives the materials of a bare scan the color of clay, unless they show vertex colors, or takes it away again. */
export function paintClay(materials: Iterable<SurfaceMaterial>, isClay: boolean): void {
  for (const material of materials) {
    if (material.vertexColors || !PLAIN.has(material.color?.getHex() ?? WHITE)) continue;
    material.color?.setHex(isClay ? CLAY : WHITE);
  }
}

/** Turns flat shading on or off. */
export function shadeFlat(materials: Iterable<SurfaceMaterial>, isFlat: boolean): void {
  for (const material of materials) {
    if (material.flatShading === undefined || material.flatShading === isFlat) continue;
    material.flatShading = isFlat;
    material.needsUpdate = true;
  }
}
