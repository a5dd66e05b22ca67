/** Materials of a model: whether it has any of its own, and how they are changed for the chosen appearance. */

import { BackSide, type Color, DoubleSide, FrontSide, type Material, Mesh, MeshStandardMaterial, type Object3D, type Side, type Texture } from 'three';

/** Color of models without materials of their own. */
const CLAY = 0xcfc4b4;
const WHITE = 0xffffff;
const CLAY_SURFACE = { metalness: 0, roughness: 0.8 };

/** Colors that mean that a material has none. */
const PLAIN = new Set([CLAY, WHITE]);

type SurfaceMaterial = Material & { flatShading?: boolean; color?: Color; map?: Texture | null };

/** Back faces: as the file says, always drawn, never drawn, or drawn in a color of their own. */
export type Backs = 'file' | 'both' | 'hide' | 'tint';

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

/**
 * Makes the materials of a bare scan clay, with their vertex colors if they have any, or takes the clay away again. The material that
 * glTF gives a mesh without one is metal, which is black under lamps.
 */
export function paintClay(materials: Iterable<SurfaceMaterial>, isClay: boolean): void {
  for (const material of materials) {
    if (!PLAIN.has(material.color?.getHex() ?? WHITE)) continue;
    material.color?.setHex(isClay && !material.vertexColors ? CLAY : WHITE);
    if (!(material instanceof MeshStandardMaterial)) continue;
    const own = (material.userData['ownSurface'] ??= { metalness: material.metalness, roughness: material.roughness }) as typeof CLAY_SURFACE;
    Object.assign(material, isClay ? CLAY_SURFACE : own);
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

/** Sides that are drawn; `file` is what the file says. */
const SIDES: Record<Exclude<Backs, 'file'>, Side> = { both: DoubleSide, hide: FrontSide, tint: DoubleSide };

/**
 * Shows, hides or tints back faces. Those of a bare scan that encloses its inside are hidden unless they are asked for: otherwise pixels
 * of backs behind sharp ridges would appear along silhouettes, lit from the other side.
 */
export function showBacks(materials: Iterable<SurfaceMaterial>, backs: Backs, isSolidScan: boolean): void {
  for (const material of materials) {
    const own = (material.userData['ownSide'] ??= material.side) as Side;
    const preferred = isSolidScan ? FrontSide : own;
    const side = backs === 'file' || own === BackSide ? preferred : SIDES[backs];
    if (material.side === side) continue;
    material.side = side;
    material.needsUpdate = true;
  }
}

/** Whether any material has vertex colors, even if they are not shown. */
export function hasVertexColors(materials: Iterable<SurfaceMaterial>): boolean {
  return [...materials].some((material) => (material.userData['ownVertexColors'] ?? material.vertexColors) as boolean);
}

/** Shows or hides vertex colors. */
export function showVertexColors(materials: Iterable<SurfaceMaterial>, isShown: boolean): void {
  for (const material of materials) {
    const own = (material.userData['ownVertexColors'] ??= material.vertexColors) as boolean;
    if (material.vertexColors === (own && isShown)) continue;
    material.vertexColors = own && isShown;
    material.needsUpdate = true;
  }
}
