/** Shows the triangles of a scene in colors of their strips, fans or numbers instead of its materials. */

import { BufferAttribute, DoubleSide, MeshStandardMaterial, type BufferGeometry, type Material, type Mesh } from 'three';
import { coloredTriangles } from '../colored-triangles.ts';
import type { SceneLod } from './lod.ts';
import type { MeshUpdate } from './protocol.ts';

/** What a mesh shows with its own material. */
interface Surface {
  geometry: BufferGeometry;
  material: Material | Material[];
}

/** Attributes that skins need. */
const SKIN = [['JOINTS_0', 'skinIndex'], ['WEIGHTS_0', 'skinWeight']] as const;

/** Colored triangles of all meshes of a scene. */
export class ColoredMeshes {
  readonly #lods: readonly SceneLod[];
  readonly #surfaces = new Map<Mesh, Surface>();
  #material: MeshStandardMaterial | undefined;
  #isWireframe = false;

  constructor(lods: readonly SceneLod[]) {
    this.#lods = lods;
  }

  set wireframe(wireframe: boolean) {
    this.#isWireframe = wireframe;
    if (this.#material) this.#material.wireframe = wireframe;
  }

  /** Colors the triangles of an update; without one, shows the surface. */
  show(lod: SceneLod, update: MeshUpdate | undefined): void {
    if (!update) return this.#restore(lod);
    const { numbers, indices, groupCounts } = update;
    if (!numbers || !indices) return;
    this.#material ??= new MeshStandardMaterial({ vertexColors: true, flatShading: true, side: DoubleSide, roughness: 0.9 });
    this.#material.wireframe = this.#isWireframe;
    const positions = lod.geometry.attribute('POSITION')?.array ?? [];
    let first = 0;
    const colored = [...groupCounts].map((count) => {
      const own = indices.subarray(3 * first, 3 * (first + count));
      const geometry = coloredTriangles(positions, own, numbers.subarray(first, first + count));
      for (const [name, attribute] of SKIN) this.#copySkin(lod, geometry, own, name, attribute);
      first += count;
      return geometry;
    });
    for (const mesh of lod.meshes) {
      const surface = this.#surfaces.get(mesh) ?? { geometry: mesh.geometry, material: mesh.material };
      this.#surfaces.set(mesh, surface);
      const primitive = lod.geometry.primitives.indexOf(surface.geometry as never);
      if (mesh.geometry !== surface.geometry) mesh.geometry.dispose();
      mesh.geometry = colored[primitive] ?? surface.geometry;
      mesh.geometry.boundingBox = surface.geometry.boundingBox;
      mesh.geometry.boundingSphere = surface.geometry.boundingSphere;
      mesh.material = this.#material;
    }
  }

  dispose(): void {
    for (const lod of this.#lods) this.#restore(lod);
    this.#material?.dispose();
  }

  #copySkin(lod: SceneLod, geometry: BufferGeometry, indices: Uint32Array, name: string, attribute: string): void {
    const from = lod.geometry.attribute(name);
    if (!from) return;
    const values = new Float32Array(4 * indices.length);
    indices.forEach((vertex, at) => {
      for (let i = 0; i < Math.min(4, from.itemSize); i++) values[4 * at + i] = from.getComponent(vertex, i);
    });
    geometry.setAttribute(attribute, new BufferAttribute(values, 4));
  }

  #restore(lod: SceneLod): void {
    for (const mesh of lod.meshes) {
      const surface = this.#surfaces.get(mesh);
      if (!surface) continue;
      if (mesh.geometry !== surface.geometry) mesh.geometry.dispose();
      mesh.geometry = surface.geometry;
      mesh.material = surface.material;
      this.#surfaces.delete(mesh);
    }
  }
}
