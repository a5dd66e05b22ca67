// Levels of the meshes of a PlayCanvas container from STRIATA_order: each entry that `orderMeshes` returns has a mesh, its
// table of levels, and `show(error)`, which makes the mesh draw the coarsest level whose error is at most `error` mesh
// units, with another index buffer over the same vertices.

import { BUFFER_STATIC, INDEXFORMAT_UINT32, IndexBuffer } from 'playcanvas';
import { levelIndices, openGlb, rowForError } from './order.mjs';

/** Adds levels to the meshes of a container resource that was loaded from these bytes. */
export function orderMeshes(device, resource, bytes) {
  const { json, integers } = openGlb(bytes), made = [];
  json.meshes.forEach(({ primitives }, index) => primitives.forEach((primitive, number) => {
    const order = primitive.extensions?.STRIATA_order;
    if (!order) return;
    const mesh = resource.renders[index].resource.meshes[number];
    const full = integers(primitive.indices), targets = integers(order.targets), buffers = new Map();
    const show = (error) => {
      const [n, triangles] = rowForError(order.levels, error);
      if (!buffers.has(n)) {
        const indices = Uint32Array.from(levelIndices(full, targets, n));
        buffers.set(n, new IndexBuffer(device, INDEXFORMAT_UINT32, indices.length, BUFFER_STATIC, indices.buffer));
      }
      mesh.indexBuffer[0] = buffers.get(n);
      mesh.primitive[0].count = 3 * triangles;
    };
    made.push({ mesh, levels: order.levels, show });
  }));
  return made;
}
