/** Levels of meshes of glTF files in refinement order (extension `STRIATA_order`). */

import type { BufferAttribute, BufferGeometry, Mesh } from 'three';
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js';

/** Levels of one geometry, from the full one to the coarsest: a list of indices each, over the attributes of the geometry, and their errors. */
export interface Levels {
  lists: ArrayLike<number>[];
  /** Errors in units of the vertices; they never fall from level to level. */
  errors: number[];
}

const EXTENSION = 'STRIATA_order';

/** The extension of a primitive. */
interface OrderExtension {
  targets: number;
  levels: [vertices: number, triangles: number, error: number][];
  indices?: number;
  ranges?: [first: number, count: number, vertices: number, error: number][];
}

interface PrimitiveDefinition {
  extensions?: Record<string, unknown>;
}

/** Returns the levels of a mesh that `GLTFLoader` made; undefined if its primitive has none, or damaged ones. */
export async function orderedLevels(parser: GLTFParser, mesh: Mesh): Promise<Levels | undefined> {
  const meshes = (parser.json as { meshes?: { primitives: PrimitiveDefinition[] }[] }).meshes;
  const place = parser.associations.get(mesh) as { meshes?: number; primitives?: number } | undefined;
  const primitives = meshes?.[place?.meshes ?? -1]?.primitives;
  const order = primitives?.[place?.primitives ?? 0]?.extensions?.[EXTENSION] as OrderExtension | undefined;
  const full = mesh.geometry.index?.array;
  if (!primitives || !order || !full) return undefined;
  const targets = await integersOf(parser, order.targets);
  if (!targets || !areValid(targets, mesh.geometry)) {
    console.warn(`striata: the levels of meshes[${place!.meshes}] are damaged; it is drawn at full detail`);
    return undefined;
  }
  const stored = order.indices === undefined ? undefined : await integersOf(parser, order.indices);
  const levels: Levels = { lists: [], errors: [] };
  order.levels.forEach(([vertices, , error], row) => {
    if (!primitives.some((primitive) => hasTriangles(primitive, row))) return;
    const [first, count] = order.ranges?.[row] ?? [];
    const isStored = stored && first !== undefined && count !== undefined && first + count <= stored.length;
    levels.lists.push(isStored ? stored.subarray(first, first + count) : levelIndices(full, targets, vertices));
    levels.errors.push(error);
  });
  return levels;
}

/** Returns the indices of the level with this many vertices. */
export function levelIndices(indices: ArrayLike<number>, targets: ArrayLike<number>, vertexCount: number): Uint32Array {
  const map = new Uint32Array(targets.length);
  for (let vertex = 0; vertex < map.length; vertex++) map[vertex] = vertex < vertexCount ? vertex : map[targets[vertex]!]!;
  const list = new Uint32Array(indices.length);
  let count = 0;
  for (let at = 0; at < indices.length; at += 3) {
    const [a, b, c] = [map[indices[at]!]!, map[indices[at + 1]!]!, map[indices[at + 2]!]!];
    if (a === b || b === c || c === a) continue;
    list[count++] = a;
    list[count++] = b;
    list[count++] = c;
  }
  return list.slice(0, count);
}

/** Whether a primitive has triangles at a row of its table. Those of one mesh have the same rows, and vanish one after another. */
function hasTriangles({ extensions }: PrimitiveDefinition, row: number): boolean {
  return ((extensions?.[EXTENSION] as OrderExtension | undefined)?.levels[row]?.[1] ?? 0) > 0;
}

/** Whether each vertex has a target, which comes before it or is the vertex itself. */
function areValid(targets: ArrayLike<number>, geometry: BufferGeometry): boolean {
  if (targets.length !== geometry.getAttribute('position')?.count) return false;
  return Array.prototype.every.call(targets, (target: number, vertex) => target <= vertex);
}

async function integersOf(parser: GLTFParser, accessor: number): Promise<Uint32Array | Uint16Array | undefined> {
  const attribute = (await parser.getDependency('accessor', accessor).catch(() => undefined)) as BufferAttribute | undefined;
  return attribute?.array as Uint32Array | undefined;
}
