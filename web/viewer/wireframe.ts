/** A wireframe over the surface rather than instead of it: hidden lines stay hidden, so that triangles are easy to see. */

import { type BufferGeometry, type Material, Mesh, MeshBasicMaterial } from 'three';

/** Pushes the surface back a little, so that lines win at equal depth. */
const SURFACE_OFFSET = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };

export class Wireframe {
  readonly #lines = new Mesh<BufferGeometry, MeshBasicMaterial>(
    undefined,
    new MeshBasicMaterial({ color: 0x17130f, wireframe: true, transparent: true, opacity: 0.28, depthWrite: false }),
  );

  constructor() {
    // three.js already culls the model itself.
    this.#lines.frustumCulled = false;
    this.#lines.visible = false;
  }

  get isShown(): boolean {
    return this.#lines.visible;
  }

  /** Shows or hides the lines of what the model currently draws; call it again when that changes. */
  show(model: Mesh<BufferGeometry, Material | Material[]>, isShown: boolean): void {
    this.#lines.visible = isShown;
    this.#lines.geometry = model.geometry;
    if (this.#lines.parent !== model) model.add(this.#lines);
    for (const material of [model.material].flat()) {
      if (isShown && !material.polygonOffset) Object.assign(material, SURFACE_OFFSET);
    }
  }
}
