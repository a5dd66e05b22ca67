/** Bounds of a model in world space, with skins and morph targets in their current pose. */

import { Box3, type BufferAttribute, Mesh, type Object3D, SkinnedMesh, Sphere, Vector3 } from 'three';

/** Corners of a mesh that are measured; of larger meshes an even sample is. Posing a vertex takes about a microsecond. */
const MAX_SAMPLES = 60_000;
const MAX_POSED_SAMPLES = 8_000;
/** Vertices of a rigid mesh up to this number all count in the box. */
const MAX_BOXED = 4_000_000;

/** Collects points and their bounding sphere. */
export class Bounds {
  readonly #box = new Box3();
  readonly #points: number[] = [];

  /** Adds the triangles of a subtree that are drawn now, hidden objects left out. */
  addDrawn(root: Object3D): this {
    return this.#add(root, (mesh) => this.#addDrawn(mesh));
  }

  /**
   * Adds the vertices of a subtree that have arrived, hidden objects left out. They do not depend on the level that is shown: a coarse
   * one may lie well inside the model.
   */
  addArrived(root: Object3D): this {
    return this.#add(root, (mesh) => ('lod' in mesh && mesh.lod ? this.#addVertices(mesh) : this.#addDrawn(mesh)));
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

  #add(root: Object3D, addMesh: (mesh: Mesh) => void): this {
    root.updateWorldMatrix(true, true);
    root.traverseVisible((object) => {
      if (object instanceof Mesh) addMesh(object);
    });
    return this;
  }

  #addDrawn(mesh: Mesh): void {
    const { index, drawRange } = mesh.geometry;
    const positions = mesh.geometry.getAttribute('position');
    if (!positions) return;
    const count = Math.min(drawRange.count, (index ?? positions).count - drawRange.start);
    const stride = strideOf(mesh, count);
    for (let at = drawRange.start; at < drawRange.start + count; at += stride) this.#addVertex(mesh, index ? index.getX(at) : at);
  }

  #addVertices(mesh: Mesh): void {
    const positions = mesh.geometry.getAttribute('position') as BufferAttribute | undefined;
    if (!positions) return;
    // Buffers may have room for vertices that have not arrived.
    const count = (mesh as Mesh & { vertexCount?: number }).vertexCount ?? positions.count;
    const stride = strideOf(mesh, count);
    for (let vertex = 0; vertex < count; vertex += stride) this.#addVertex(mesh, vertex);
    if (!isPosed(mesh) && stride > 1 && count <= MAX_BOXED) this.#addExtremes(mesh, positions.array, count);
  }

  /** Adds the vertices at the sides of the box around a rigid mesh, which a sample may miss. */
  #addExtremes(mesh: Mesh, values: ArrayLike<number>, count: number): void {
    const [x, y, z] = [0, 1, 2].map((row) => [0, 4, 8].map((column) => mesh.matrixWorld.elements[row + column]!)) as [number[], number[], number[]];
    const extremes = [x, y, z].map(() => ({ low: Infinity, lowAt: 0, high: -Infinity, highAt: 0 }));
    for (const [axis, [a, b, c]] of [x, y, z].entries()) {
      const found = extremes[axis]!;
      for (let vertex = 0, at = 0; vertex < count; vertex += 1, at += 3) {
        const value = a! * values[at]! + b! * values[at + 1]! + c! * values[at + 2]!;
        if (value < found.low) [found.low, found.lowAt] = [value, vertex];
        if (value > found.high) [found.high, found.highAt] = [value, vertex];
      }
    }
    for (const { lowAt, highAt } of extremes) for (const vertex of [lowAt, highAt]) this.#addVertex(mesh, vertex);
  }

  #addVertex(mesh: Mesh, vertex: number): void {
    if (isPosed(mesh)) mesh.getVertexPosition(vertex, point);
    else point.fromBufferAttribute(mesh.geometry.getAttribute('position'), vertex);
    point.applyMatrix4(mesh.matrixWorld);
    if (!Number.isFinite(point.x + point.y + point.z)) return;
    this.#box.expandByPoint(point);
    this.#points.push(point.x, point.y, point.z);
  }
}

const point = new Vector3();

function isPosed(mesh: Mesh): boolean {
  return mesh instanceof SkinnedMesh || mesh.morphTargetInfluences !== undefined;
}

function strideOf(mesh: Mesh, count: number): number {
  return Math.max(1, Math.ceil(count / (isPosed(mesh) ? MAX_POSED_SAMPLES : MAX_SAMPLES)));
}

/** Bounding sphere of what is drawn of a subtree; null if nothing is. */
export const boundsOf = (root: Object3D): Sphere | null => new Bounds().addDrawn(root).sphere();
