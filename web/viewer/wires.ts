/** A wireframe over the surface, not instead of it: what lies behind stays hidden, so that triangles can be read. */

import { type BufferGeometry, type Material, Mesh, MeshBasicMaterial } from 'three';

/** Pushes the surface back a little, so that lines win where both have the same depth. */
const BEHIND = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };

export class Wires {
  readonly #lines = new Mesh<BufferGeometry, MeshBasicMaterial>(
    undefined,
    new MeshBasicMaterial({ color: 0x17130f, wireframe: true, transparent: true, opacity: 0.28, depthWrite: false }),
  );

  constructor() {
    // The model itself is culled where it is out of sight.
    this.#lines.frustumCulled = false;
    this.#lines.visible = false;
  }

  get isShown(): boolean {
    return this.#lines.visible;
  }

  /** Draws the lines of what the model draws now; call it again when that has changed. */
  show(model: Mesh<BufferGeometry, Material | Material[]>, isShown: boolean): void {
    this.#lines.visible = isShown;
    this.#lines.geometry = model.geometry;
    if (this.#lines.parent !== model) model.add(this.#lines);
    for (const material of [model.material].flat()) {
      if (isShown && !material.polygonOffset) Object.assign(material, BEHIND);
    }
  }
}
