/** Messages between the page and the engine; all of them can be posted to a worker. */

import type { PlainError } from './error.ts';
import type { MeshArrays } from './scene/protocol.ts';
import type { Coloring, Kind, Phase, VertexStep } from './types.ts';

/** A request for a level of detail. */
export interface LevelRequest {
  by: 'detail' | 'triangles' | 'error' | 'view';
  /** Depending on `by`: the detail (0 to 1), the triangle count, the error in mesh units, or the screen error in pixels. */
  value: number;
  /** Maximum triangle count; 0 means no limit. */
  limit: number;
  /** For views: eye, target and up in mesh space, tangent of half the vertical field of view, width and height in pixels. */
  camera?: number[];
}

/** Messages from the page to the engine. */
export type Order =
  | { type: 'bytes'; bytes: Uint8Array }
  /** The end of the bytes; with an error if some are missing. */
  | { type: 'end'; error?: PlainError }
  /** A complete file that is or contains a stream, perhaps compressed. */
  | { type: 'file'; bytes: Uint8Array; name: string }
  /** A mesh whose levels are built by the second wasm module. */
  | { type: 'arrays'; arrays: MeshArrays; builder?: WebAssembly.Module }
  /** A request to show a level. */
  | { type: 'show'; request: LevelRequest; coloring: Coloring; ticket: number }
  /** A question for the step that adds a vertex. */
  | { type: 'step'; vertex: number };

/** New vertices, starting at index `first`. */
export interface NewVertices {
  first: number;
  positions: Float32Array;
  normals: Float32Array | undefined;
  colors: Uint16Array | undefined;
  uvs: Float32Array | undefined;
}

/** Loading progress of a model, and the level that is shown. */
export interface State {
  kind: Kind;
  phase: Phase;
  complete: boolean;
  vertexCount: number;
  /** Triangle count of the finest level available so far. */
  triangleCount: number;
  fullVertexCount: number;
  fullTriangleCount: number;
  stepCount: number;
  streamBytes: number;
  /** Of a paged file: the bytes that have been fetched. */
  receivedBytes?: number;
  /** Minimum and maximum coordinates; empty before any vertices have loaded. */
  bounds: Float32Array;
  /** Whether z is up. */
  isZUp: boolean;
  diagonal: number;
  shownSplitCount: number;
  shownError: number;
  decodeMs: number;
  buildMs: number;
  updateMs: number;
}

/** A level to show, and the vertices that have loaded since the last update. */
export interface Update {
  type: 'update';
  state: State;
  vertices: NewVertices | undefined;
  /** Normals of all vertices, if the mesh has none of its own. */
  smoothNormals: Float32Array | undefined;
  indices: Uint32Array;
  groupCounts: Uint32Array;
  /** Strip, fan or triangle number of each triangle, unless the coloring is `surface`. */
  numbers: Uint32Array | undefined;
  /** Whether repeating the request would give the same result. */
  settled: boolean;
  /** The request that this answers; 0 for updates sent without a request. */
  ticket: number;
}

/** Messages from the engine to the page. */
export type Report =
  | Update
  /** A request whose level will follow in updates without a ticket. */
  | { type: 'accepted'; ticket: number }
  | { type: 'step'; step: VertexStep | null }
  | { type: 'building'; share: number }
  /** Loading has failed. If no update was sent before, there is no mesh either. */
  | { type: 'failed'; error: PlainError }
  /** Part of the mesh is damaged, and stays coarse. */
  | { type: 'damaged'; error: PlainError }
  | { type: 'finished' }
  /** The backs of the triangles cannot be seen: they enclose bodies and face outward. */
  | { type: 'solid' };

/** Buffers of a report that can be transferred instead of copied. */
export function transferable(report: Report): ArrayBuffer[] {
  if (report.type !== 'update') return [];
  const { vertices, indices, groupCounts, numbers, smoothNormals } = report;
  const arrays: (ArrayBufferView | undefined)[] = [indices, groupCounts, numbers, smoothNormals];
  if (vertices) arrays.push(vertices.positions, vertices.normals, vertices.colors, vertices.uvs);
  return arrays.flatMap((array) => (array ? [array.buffer as ArrayBuffer] : []));
}
