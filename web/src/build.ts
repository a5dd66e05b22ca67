/** Builds the levels of a mesh with the second wasm module, and passes them to the first, which shows them. */

import { initSync, MeshBuilder } from './wasm/striata-builder.js';
import { type Model, PrefixParts } from './wasm/striata.js';
import type { MeshArrays } from './scene/protocol.ts';

let isStarted = false;

/** Initializes the module that builds levels; later calls have no effect. */
export function startBuilder(module: WebAssembly.Module): void {
  if (!isStarted) initSync({ module });
  isStarted = true;
}

/** Simplifies a mesh; `report` receives the completed share. */
export function buildModel({ layers, groups, isSmooth }: MeshArrays, report: (share: number) => void): Model {
  const positions = layers.find(({ name }) => name === 'POSITION')?.values ?? new Float32Array();
  const mesh = new MeshBuilder(positions as Float32Array);
  for (const { name, itemSize, values } of layers) {
    if (name === 'POSITION') continue;
    if (values instanceof Uint16Array) mesh.add_shorts(name, itemSize, values);
    else mesh.add_floats(name, itemSize, values as Float32Array);
  }
  for (const group of groups) mesh.add_group(group);
  if (isSmooth) mesh.add_smooth_normals();
  // Building consumes the arrays.
  const built = mesh.build({ report: (_: string, share: number) => report(share) });
  const vertices = built.vertices();
  try {
    const parts = new PrefixParts(vertices.take_positions(), built.first_vertices(), built.targets(), built.added_counts(), built.errors());
    for (let layer = vertices.take_layer(); layer; layer = vertices.take_layer()) {
      const bytes = layer.bytes();
      if (layer.component_type === 'u16') parts.add_shorts(layer.name, layer.component_count, new Uint16Array(bytes.buffer));
      else parts.add_floats(layer.name, layer.component_count, new Float32Array(bytes.buffer));
      layer.free();
    }
    return parts.build(built.triangles(), built.groups(), groups.length);
  } finally {
    vertices.free();
    built.free();
  }
}
