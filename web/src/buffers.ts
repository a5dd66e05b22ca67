/** Vertex and index buffers that grow: updated in part while there is room, and doubled when they are full. */

import { Box3, BufferAttribute, BufferGeometry, Sphere, Vector3, type TypedArray } from 'three';
import type { Update } from './protocol.ts';

/** Initial capacity in vertices or triangles. */
const MIN_CAPACITY = 1024;

/** A geometry whose buffers are larger than their contents; its bounds are passed in rather than computed from them. */
export class GrowingGeometry extends BufferGeometry {
  /** Minimum and maximum coordinates. */
  bounds: ArrayLike<number> = [];
  #vertexCapacity = 0;
  #hasCapacityChanged = false;

  override computeBoundingBox(): void {
    // Copies, and geometries without vertices, have no bounds passed in.
    if (this.bounds.length !== 6) return super.computeBoundingBox();
    const [min, max] = [0, 3].map((at) => new Vector3().fromArray(Array.from(this.bounds), at));
    this.boundingBox = new Box3(min, max);
  }

  override computeBoundingSphere(): void {
    this.computeBoundingBox();
    this.boundingSphere = this.boundingBox!.getBoundingSphere(new Sphere());
  }

  /** Applies an update. */
  apply({ state, vertices, smoothNormals, indices, groupCounts }: Update): void {
    this.bounds = state.bounds;
    this.#reserveVertices(state.vertexCount, state.fullVertexCount);
    if (vertices) {
      const { first, positions, normals, colors, uvs } = vertices;
      this.#write('position', positions, 3, first);
      if (normals) this.#write('normal', normals, 3, first);
      if (colors) this.#write('color', colors, 4, first);
      if (uvs) this.#write('uv', uvs, 2, first);
    }
    if (smoothNormals) this.#write('normal', smoothNormals, 3, 0);
    this.#writeIndices(indices, 3 * state.fullTriangleCount);
    this.clearGroups();
    // Groups matter only for meshes with several materials, which can be assigned at any time.
    let start = 0;
    groupCounts.forEach((count, group) => {
      this.addGroup(start, 3 * count, group);
      start += 3 * count;
    });
    this.computeBoundingSphere();
    this.#hasCapacityChanged = false;
  }

  #reserveVertices(count: number, full: number): void {
    if (count <= this.#vertexCapacity) return;
    this.#vertexCapacity = grownCapacity(this.#vertexCapacity, count, full);
    this.#hasCapacityChanged = true;
    // Frees the old buffers on the GPU.
    this.dispose();
  }

  /** Writes attribute values of vertices, starting at vertex `first`. */
  #write(name: string, values: Float32Array | Uint16Array, width: number, first: number): void {
    let attribute = this.getAttribute(name) as BufferAttribute | undefined;
    if (!attribute || (this.#hasCapacityChanged && attribute.count !== this.#vertexCapacity)) {
      const array = values instanceof Uint16Array ? new Uint16Array(this.#vertexCapacity * width) : new Float32Array(this.#vertexCapacity * width);
      if (attribute) array.set((attribute.array as TypedArray).subarray(0, first * width));
      attribute = new BufferAttribute(array, width, values instanceof Uint16Array);
      this.setAttribute(name, attribute);
    } else {
      attribute.addUpdateRange(first * width, values.length);
    }
    attribute.array.set(values, first * width);
    attribute.needsUpdate = true;
  }

  #writeIndices(indices: Uint32Array, full: number): void {
    let attribute = this.index;
    if (!attribute || attribute.count < indices.length) {
      if (attribute) this.dispose();
      const array = new Uint32Array(grownCapacity(attribute?.count ?? 0, indices.length, full));
      attribute = new BufferAttribute(array, 1);
      this.setIndex(attribute);
    } else {
      attribute.addUpdateRange(0, indices.length);
    }
    attribute.array.set(indices);
    attribute.needsUpdate = true;
    this.setDrawRange(0, indices.length);
  }
}

/** Twice the previous capacity, but no more than the full mesh needs. */
function grownCapacity(before: number, needed: number, full: number): number {
  const doubled = Math.max(MIN_CAPACITY, 2 * before, needed);
  return full >= needed ? Math.min(doubled, full) : doubled;
}
