/** Vertex and index buffers that grow: rewritten in part as long as there is room, by doubling where there is none. */

import { Box3, BufferAttribute, BufferGeometry, Sphere, Vector3, type TypedArray } from 'three';
import type { Update } from './protocol.ts';

/** Room that is made at first, vertices or triangles. */
const LEAST_ROOM = 1024;

/** A geometry whose buffers have more room than there are vertices: its bounds are told, not looked for. */
export class GrowingGeometry extends BufferGeometry {
  /** Smallest and largest coordinates. */
  bounds: ArrayLike<number> = [];
  #vertexRoom = 0;
  #hasRoomChanged = false;

  override computeBoundingBox(): void {
    // Nobody told a copy, or one without vertices.
    if (this.bounds.length !== 6) return super.computeBoundingBox();
    const [min, max] = [0, 3].map((at) => new Vector3().fromArray(Array.from(this.bounds), at));
    this.boundingBox = new Box3(min, max);
  }

  override computeBoundingSphere(): void {
    this.computeBoundingBox();
    this.boundingSphere = this.boundingBox!.getBoundingSphere(new Sphere());
  }

  /** Takes what an update brings. */
  take({ state, vertices, smoothNormals, indices, groupCounts }: Update): void {
    this.bounds = state.bounds;
    this.#makeRoom(state.vertexCount, state.fullVertexCount);
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
    // They count only for meshes with several materials, which a mesh can be given at any time.
    let start = 0;
    groupCounts.forEach((count, group) => {
      this.addGroup(start, 3 * count, group);
      start += 3 * count;
    });
    this.computeBoundingSphere();
    this.#hasRoomChanged = false;
  }

  #makeRoom(count: number, full: number): void {
    if (count <= this.#vertexRoom) return;
    this.#vertexRoom = room(this.#vertexRoom, count, full);
    this.#hasRoomChanged = true;
    // Frees what the graphics card has of the old buffers.
    this.dispose();
  }

  /** Writes numbers of vertices from one on. */
  #write(name: string, numbers: Float32Array | Uint8Array, width: number, first: number): void {
    let attribute = this.getAttribute(name) as BufferAttribute | undefined;
    if (!attribute || (this.#hasRoomChanged && attribute.count !== this.#vertexRoom)) {
      const array = numbers instanceof Uint8Array ? new Uint8Array(this.#vertexRoom * width) : new Float32Array(this.#vertexRoom * width);
      if (attribute) array.set((attribute.array as TypedArray).subarray(0, first * width));
      attribute = new BufferAttribute(array, width, numbers instanceof Uint8Array);
      this.setAttribute(name, attribute);
    } else {
      attribute.addUpdateRange(first * width, numbers.length);
    }
    attribute.array.set(numbers, first * width);
    attribute.needsUpdate = true;
  }

  #writeIndices(indices: Uint32Array, full: number): void {
    let attribute = this.index;
    if (!attribute || attribute.count < indices.length) {
      if (attribute) this.dispose();
      const array = new Uint32Array(room(attribute?.count ?? 0, indices.length, full));
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

/** Twice as much as before, and never more than there will be. */
function room(before: number, needed: number, full: number): number {
  const doubled = Math.max(LEAST_ROOM, 2 * before, needed);
  return full >= needed ? Math.min(doubled, full) : doubled;
}
