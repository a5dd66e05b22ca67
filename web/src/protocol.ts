/** What page and engine tell each other; all of it can be posted to a worker. */

import type { PlainError } from './error.ts';
import type { Coloring, Kind, Phase } from './types.ts';

/** Which level is wanted. */
export interface Wish {
  by: 'detail' | 'triangles' | 'error' | 'view';
  /** The detail, the number of triangles, the error in mesh units, or the pixels. */
  value: number;
  /** Triangles at most, whatever is wanted; 0 is no limit. */
  limit: number;
  /** For views: eye, target and up in the mesh's space, tangent of half the field of view, width and height in pixels. */
  camera?: number[];
}

/** From the page to the engine. */
export type Order =
  | { type: 'bytes'; bytes: Uint8Array }
  /** No more bytes; with an error where not all have come. */
  | { type: 'end'; error?: PlainError }
  /** A whole file. */
  | { type: 'file'; bytes: Uint8Array; name: string }
  | { type: 'show'; wish: Wish; coloring: Coloring; ticket: number };

/** Vertices that are new, from one on. */
export interface NewVertices {
  first: number;
  positions: Float32Array;
  normals: Float32Array | undefined;
  colors: Uint8Array | undefined;
  uvs: Float32Array | undefined;
}

/** How far a model has come, and what is shown of it. */
export interface State {
  kind: Kind;
  phase: Phase;
  complete: boolean;
  vertexCount: number;
  /** Triangles of the finest level that is there. */
  triangleCount: number;
  fullVertexCount: number;
  fullTriangleCount: number;
  stepCount: number;
  streamBytes: number;
  /** Smallest and largest coordinates; empty before anything is there. */
  bounds: Float32Array;
  diagonal: number;
  shownSplitCount: number;
  shownError: number;
  decodeMs: number;
  buildMs: number;
  updateMs: number;
}

/** Another level, and the vertices that have come since the last. */
export interface Update {
  type: 'update';
  state: State;
  vertices: NewVertices | undefined;
  /** Normals of all vertices, where the mesh brings none of its own. */
  smoothNormals: Float32Array | undefined;
  indices: Uint32Array;
  groupCounts: Uint32Array;
  /** For each triangle the number of its strip or fan, unless the surface is shown as it is. */
  numbers: Uint32Array | undefined;
  /** Whether asking again would show the same. */
  settled: boolean;
  /** The request that this answers; 0 for what comes by itself. */
  ticket: number;
}

/** From the engine to the page. */
export type Report =
  | Update
  | { type: 'building'; share: number }
  /** Nothing more comes; where nothing has come there is no mesh either. */
  | { type: 'failed'; error: PlainError }
  | { type: 'finished' };

/** Memory of a report that can be given away. */
export function transferable(report: Report): ArrayBuffer[] {
  if (report.type !== 'update') return [];
  const { vertices, indices, groupCounts, numbers, smoothNormals } = report;
  const arrays: (ArrayBufferView | undefined)[] = [indices, groupCounts, numbers, smoothNormals];
  if (vertices) arrays.push(vertices.positions, vertices.normals, vertices.colors, vertices.uvs);
  return arrays.flatMap((array) => (array ? [array.buffer as ArrayBuffer] : []));
}
