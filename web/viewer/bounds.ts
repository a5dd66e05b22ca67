/** Bounds of what is drawn, in world space, with skins and morph targets in their current pose. */

import { Box3, Mesh, type Object3D, SkinnedMesh, Sphere, Vector3 } from 'three';

/** Vertices of a mesh that are measured; of larger meshes an even sample is. Posing a vertex takes about a microsecond. */
const MAX_SAMPLES = 60_000;
const MAX_POSED_SAMPLES = 8_000;

/** Collects points and their bounding sphere. */
export class Bounds {
  readonly #box = new Box3();
  readonly #points: number[] = [];

  /** Adds the drawn vertices of a subtree, hidden objects left out. */
  add(root: Object3D): this {
    root.updateWorldMatrix(true, true);
    root.traverseVisible((object) => {
      if (object instanceof Mesh) this.#addMesh(object);
    });
    return this;
  }

  /** The bounding sphere, centered in the bounding box; null if nothing is drawn. */
  sphere(): Sphere | null {
    if (this.#box.isEmpty()) return null;
    const sphere = new Sphere(this.#box.getCenter(new Vector3()), 0);
    const point = new Vector3();
    for (let index = 0; index < this.#points.length; index += 3) {
      sphere.radius = Math.max(sphere.radius, sphere.center.distanceToSquared(point.fromArray(this.#points, index)));
    }
    sphere.radius = Math.max(Math.sqrt(sphere.radius), 1e-6);
    return sphere;
  }

  #addMesh(mesh: Mesh): void {
    const { index, drawRange } = mesh.geometry;
    const positions = mesh.geometry.getAttribute('position');
    if (!positions) return;
    // Only what is drawn counts: buffers may have room for vertices that have not arrived.
    const drawnCount = Math.min(drawRange.count, (index ?? positions).count - drawRange.start);
    const isPosed = mesh instanceof SkinnedMesh || mesh.morphTargetInfluences !== undefined;
    const stride = Math.max(1, Math.ceil(drawnCount / (isPosed ? MAX_POSED_SAMPLES : MAX_SAMPLES)));
    const point = new Vector3();
    for (let at = drawRange.start; at < drawRange.start + drawnCount; at += stride) {
      const vertex = index ? index.getX(at) : at;
      if (isPosed) mesh.getVertexPosition(vertex, point);
      else point.fromBufferAttribute(positions, vertex);
      point.applyMatrix4(mesh.matrixWorld);
      if (!Number.isFinite(point.x + point.y + point.z)) continue;
      this.#box.expandByPoint(point);
      this.#points.push(point.x, point.y, point.z);
    }
  }
}

/** Bounding sphere of the drawn vertices of a subtree; null if nothing is drawn. */
export const boundsOf = (root: Object3D): Sphere | null => new Bounds().add(root).sphere();
