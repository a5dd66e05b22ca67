/** Messages between the page and the engine of a scene. */

import type { PlainError } from '../error.ts';
import type { LevelRequest } from '../protocol.ts';
import type { Coloring, Phase, VertexStep } from '../types.ts';

/** How much a mesh counts when one target is distributed over all meshes. */
export interface MeshShare {
  mesh: number;
  /** Factor from errors of the mesh to the unit of the tolerance: pixels, or units of the scene. */
  scale: number;
  /** Number of times that its triangles count. */
  instances: number;
  /** A level of its own instead of a share of the target. */
  request?: LevelRequest;
}

/** Levels of all meshes. */
export interface SceneTarget {
  meshes: MeshShare[];
  /** Each mesh shows its coarsest level whose error, times its scale, is at most this. */
  tolerance: number;
  /** Share of the steps of all meshes; overrides the tolerance. */
  detail?: number;
  /** Maximum number of triangles of all meshes; 0 means no limit. */
  limit: number;
}

/** Messages from the page. */
export type SceneOrder =
  /** Bytes of the scene's stream, or of the stream of a single mesh. */
  | { type: 'bytes'; bytes: Uint8Array; mesh?: number }
  /** The end of the bytes; with an error if some are missing. */
  | { type: 'end'; error?: PlainError }
  /** Meshes whose levels are built by the second wasm module. */
  | { type: 'build'; meshes: MeshArrays[]; builder: WebAssembly.Module }
  /** A whole `.striata` file of a mesh or a scene, which the third wasm module reads. */
  | { type: 'stored'; bytes: Uint8Array; files: WebAssembly.Module }
  | { type: 'target'; target: SceneTarget; coloring: Coloring; ticket: number }
  /** A request for the indices of a level that is not shown. */
  | { type: 'indices'; mesh: number; request: LevelRequest; id: number }
  /** A question for the step that adds a vertex. */
  | { type: 'step'; mesh: number; vertex: number; id: number };

/** A mesh without levels. */
export interface MeshArrays {
  /** Attributes; one of them is `POSITION`. */
  layers: NewLayer[];
  /** Corners of the triangles of each group. */
  groups: Uint32Array[];
  /** Whether smooth normals are to be computed. */
  isSmooth: boolean;
}

/** Values of one attribute of new vertices. Names are those of glTF; morph targets have a number in front: `0/POSITION`. */
export interface NewLayer {
  name: string;
  itemSize: number;
  normalized: boolean;
  values: Float32Array | Int8Array | Int16Array | Int32Array | Uint8Array | Uint16Array | Uint32Array;
}

/** What a mesh shows, and its vertices that have arrived since the last update. */
export interface MeshUpdate {
  mesh: number;
  /** Index of the first new vertex. */
  first: number;
  layers: NewLayer[];
  /** Corners of the shown triangles, primitive by primitive; undefined if they have not changed. */
  indices: Uint32Array | undefined;
  groupCounts: Uint32Array;
  /** Strip, fan or triangle number of each shown triangle. */
  numbers: Uint32Array | undefined;
  bounds: Float32Array;
  vertexCount: number;
  fullVertexCount: number;
  /** Triangle count of the finest level available so far. */
  triangleCount: number;
  fullTriangleCount: number;
  splitCount: number;
  stepCount: number;
  error: number;
  complete: boolean;
}

/** An image of a scene. */
export interface SceneImage {
  index: number;
  bytes: Uint8Array;
  mimeType: string;
  uri: string;
  isFull: boolean;
}

/** Progress of loading. */
export interface SceneState {
  phase: Phase;
  complete: boolean;
  streamBytes: number;
  decodeMs: number;
  buildMs: number;
  updateMs: number;
}

/** Everything of a scene but its geometry. */
export interface SceneDocument {
  json: string;
  buffer: Uint8Array;
  hasAnimations: boolean;
  images: SceneImage[];
}

/** Messages to the page. */
export type SceneReport =
  /** The scene can be drawn. The first report, except for errors. */
  | { type: 'document'; document: SceneDocument; meshes: MeshUpdate[]; state: SceneState }
  | { type: 'meshes'; meshes: MeshUpdate[]; state: SceneState; ticket: number; settled: boolean }
  | { type: 'images'; images: SceneImage[] }
  /** The document again, now with animations. */
  | { type: 'animations'; document: SceneDocument }
  | { type: 'indices'; id: number; lists: Uint32Array[] }
  | { type: 'step'; id: number; step: VertexStep | null }
  /** Completed share of building all meshes. */
  | { type: 'building'; share: number }
  /** A mesh that cannot have levels. */
  | { type: 'unbuilt'; mesh: number; error: PlainError }
  | { type: 'failed'; error: PlainError }
  | { type: 'finished' }
  /** The backs of the triangles of all meshes cannot be seen: they enclose bodies and face outward. */
  | { type: 'solid' };

/** Buffers of a report that can be transferred instead of copied. */
export function sceneTransfer(report: SceneReport): ArrayBuffer[] {
  const arrays: (ArrayBufferView | undefined)[] = [];
  if (report.type === 'document' || report.type === 'meshes') {
    for (const { layers, indices, groupCounts, numbers } of report.meshes) {
      arrays.push(indices, groupCounts, numbers, ...layers.map(({ values }) => values));
    }
  }
  if (report.type === 'document' || report.type === 'animations') {
    arrays.push(report.document.buffer, ...report.document.images.map(({ bytes }) => bytes));
  }
  if (report.type === 'images') arrays.push(...report.images.map(({ bytes }) => bytes));
  if (report.type === 'indices') arrays.push(...report.lists);
  return arrays.flatMap((array) => (array ? [array.buffer as ArrayBuffer] : []));
}
