/** Levels of meshes that a `StriataLoader` has loaded. */

import type { Mesh } from 'three';
import type { SceneLod } from '../scene/lod.ts';
import type { StriataLod } from '../types.ts';
import { StriataError } from '../error.ts';
import type { Levels } from './order.ts';

/** Returns the levels of all primitives of a lod, each with half of the triangles of the one before. */
export async function levelsOfLod(lod: StriataLod): Promise<Levels[]> {
  const rows: { lists: Uint32Array[]; error: number }[] = [];
  for (let triangles = lod.fullTriangleCount, least = Infinity; triangles >= 1; triangles = Math.floor(triangles / 2)) {
    const lists = await lod.indices({ triangles });
    const count = lists.reduce((sum, list) => sum + list.length / 3, 0);
    // The base mesh is the coarsest level, whatever the target.
    if (count >= least || count === 0) break;
    least = count;
    rows.push({ lists, error: rows.length === 0 ? 0 : await errorOf(lod, lists) });
  }
  const primitives = rows[0]?.lists ?? [];
  return primitives.map((_, primitive) => ({ lists: rows.map(({ lists }) => lists[primitive]!), errors: rows.map(({ error }) => error) }));
}

/** Levels of one of a lod's meshes. */
export function levelsOfMesh(all: readonly Levels[], lod: StriataLod, mesh: Mesh): Levels {
  const { geometry } = lod as Partial<SceneLod>;
  // A single mesh has groups over one geometry. Colored triangles have no indices.
  const levels = geometry ? all[geometry.primitives.indexOf(mesh.geometry as never)] : joined(all);
  if (!levels || !mesh.geometry.index) throw new StriataError('unsupported', `the mesh ${mesh.name} does not show its surface`, "set the scene's coloring to 'surface'");
  return levels;
}

/** Levels whose lists are those of all groups. */
function joined(all: readonly Levels[]): Levels {
  const [first = { lists: [], errors: [] }] = all;
  return { lists: first.lists.map((_, level) => all.flatMap(({ lists }) => Array.from(lists[level]!))), errors: first.errors };
}

/** Error of a level: that of the step that adds the first vertex that the level does not use. */
async function errorOf(lod: StriataLod, lists: readonly Uint32Array[]): Promise<number> {
  let vertexCount = 0;
  for (const list of lists) for (const vertex of list) vertexCount = Math.max(vertexCount, vertex + 1);
  return (await lod.stepOf(vertexCount))?.error ?? 0;
}
