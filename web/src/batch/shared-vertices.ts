/**
 * Several lists of indices over one set of vertices in a `BatchedMesh`.
 *
 * `addGeometry` copies vertices, and adds the place of their copies to the indices. So the first level brings all vertices, and the others
 * bring none: their places would be behind the last vertex, from which their indices count backward, as negative numbers. All of this is
 * public API. Each level is then a geometry of the batch, and `setGeometryIdAt` switches an instance to it.
 *
 *     vertices   |0 ........................ n|          the source's own attributes, which are shared in place of the copy
 *     indices    | level 0          | level 1 |2 |..|    geometry ids 0, 1, 2, ...
 */

import { BatchedMesh, BufferAttribute, BufferGeometry, type InterleavedBufferAttribute, type Material, type Sphere, type TypedArray } from 'three';
import type { Levels } from './order.ts';

/** Attributes that only skins use, which batches do not have. */
const SKIN = ['skinIndex', 'skinWeight'];

/** Returns a batch whose geometry `i` is level `i`. */
export function batchOf(source: BufferGeometry, { lists }: Levels, material: Material, maxInstances: number): BatchedMesh {
  const vertexCount = source.getAttribute('position').count;
  const indexCount = lists.reduce((sum, list) => sum + list.length, 0);
  const batch = new BatchedMesh(maxInstances, vertexCount, indexCount, material);
  const names = Object.keys(source.attributes).filter((name) => !SKIN.includes(name));
  lists.forEach((list, level) => {
    const geometry = new BufferGeometry();
    for (const name of names) geometry.setAttribute(name, level === 0 ? source.getAttribute(name) : emptyLike(source.getAttribute(name)));
    geometry.setIndex(new BufferAttribute(level === 0 ? Uint32Array.from(list) : Int32Array.from(list, (vertex) => vertex - vertexCount), 1));
    // Levels use some vertices of the full mesh, whose bounds hold for all of them.
    geometry.boundingSphere = sphereOf(source);
    geometry.boundingBox = source.boundingBox;
    batch.addGeometry(geometry);
  });
  for (const name of names) batch.geometry.setAttribute(name, source.getAttribute(name));
  return batch;
}

/** Bounds of a geometry, computed if they are not known yet. */
export function sphereOf(geometry: BufferGeometry): Sphere {
  if (!geometry.boundingSphere) geometry.computeBoundingSphere();
  return geometry.boundingSphere!;
}

/** An attribute of the same type without values. */
function emptyLike({ array, itemSize, normalized }: BufferAttribute | InterleavedBufferAttribute): BufferAttribute {
  return new BufferAttribute(new (array.constructor as Float32ArrayConstructor)(0) as TypedArray, itemSize, normalized);
}
