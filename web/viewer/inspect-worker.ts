/** Looks at the multiresolution models of a file in a worker: opens the file once, then answers each request for a level. */

import { asPlain, asStriataError, type PlainError } from '../src/error.ts';
import { decompressed } from '../src/unpack.ts';
import { initSync, InspectedMesh, View } from './wasm/striata-encoder.js';

/** Models that can be looked at. */
export const MODELS = ['list', 'lodstrips', 'live-strips', 'mts', 'fans', 'patterns'] as const;

export type ModelName = (typeof MODELS)[number];

/** The level to show: detail from 0 to 1, a number of triangles, or a camera with a tolerance in pixels. */
export interface InspectRequest {
  model: ModelName;
  by: 'detail' | 'triangles' | 'view';
  value: number;
  camera?: number[];
  /** Whether vertices move from the level before. */
  morphs: boolean;
}

/** Messages from the page. */
export type InspectOrder =
  | { type: 'open'; module: WebAssembly.Module; bytes: ArrayBuffer; name: string }
  | { type: 'show'; request: InspectRequest };

/** The mesh: vertices in refinement order. */
export interface InspectedVertices {
  positions: Float32Array;
  normals: Float32Array;
  /** Step that adds each vertex; -1 for those of the base mesh. */
  steps: Int32Array;
  /** Error of each level but the full mesh. */
  errors: Float32Array;
  triangleCount: number;
  stored: ModelName[];
  available: ModelName[];
}

/** Triangles with the number of the strip, fan or fragment of each. */
export interface NumberedTriangles {
  indices: Uint32Array;
  numbers: Uint32Array;
}

/** A level as one model draws it. */
export interface InspectedLevel extends NumberedTriangles {
  model: ModelName;
  primitiveCount: number;
  indexCount: number;
  changedCount: number;
  splitCount: number;
  error: number;
  modelBytes: number;
  instanceBytes: number;
  updateMs: number;
  /** The triangles that are drawn while vertices move, and the vertices that move, those that appear first. */
  morph: (NumberedTriangles & { vertices: Uint32Array; targets: Uint32Array; appearingCount: number }) | null;
}

/** Messages from the worker. */
export type InspectReport =
  | { type: 'progress'; phase: string; share: number }
  | { type: 'opened'; vertices: InspectedVertices }
  | { type: 'level'; level: InspectedLevel }
  | { type: 'failed'; error: PlainError };

/** The part of a worker's global scope that is used here; TypeScript's DOM types describe only pages. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<InspectOrder>) => void) | null;
  postMessage(report: InspectReport, transfer?: Transferable[]): void;
}

const scope = self as unknown as WorkerScope;
let mesh: InspectedMesh | undefined;

scope.onmessage = ({ data }) => {
  answer(data).catch((thrown: unknown) => scope.postMessage({ type: 'failed', error: asPlain(asStriataError(thrown)) }));
};

async function answer(order: InspectOrder): Promise<void> {
  if (order.type === 'show') return show(order.request);
  initSync({ module: order.module });
  const file = await decompressed(new Uint8Array(order.bytes), order.name);
  const sink = { report: (phase: string, share: number) => scope.postMessage({ type: 'progress', phase, share }) };
  mesh = InspectedMesh.read(file.bytes, file.name, sink);
  const which = (test: (model: ModelName) => boolean): ModelName[] => MODELS.filter(test);
  const opened = mesh;
  scope.postMessage({
    type: 'opened',
    vertices: {
      positions: opened.positions(), normals: opened.normals(), steps: opened.steps(), errors: opened.errors(), triangleCount: opened.triangle_count,
      stored: which((model) => opened.is_stored(model)), available: which((model) => opened.is_available(model)),
    },
  });
}

function show({ model, by, value, camera, morphs }: InspectRequest): void {
  if (!mesh) return;
  const started = performance.now();
  const level = levelOf(mesh, { model, by, value, camera, morphs });
  const updateMs = performance.now() - started;
  const triangles: NumberedTriangles = { indices: level.indices(), numbers: level.numbers() };
  const morph = level.has_morph
    ? { indices: level.morph_indices(), numbers: level.morph_numbers(), vertices: level.moving(), targets: level.moving_targets(), appearingCount: level.appearing_count }
    : null;
  const shown: InspectedLevel = {
    ...triangles, model, morph, updateMs,
    primitiveCount: level.primitive_count, indexCount: level.index_count, changedCount: level.changed_count, splitCount: level.split_count,
    error: level.error, modelBytes: level.model_bytes, instanceBytes: level.instance_bytes,
  };
  level.free();
  const arrays = [triangles.indices, triangles.numbers, ...(morph ? [morph.indices, morph.numbers, morph.vertices, morph.targets] : [])];
  scope.postMessage({ type: 'level', level: shown }, arrays.map(({ buffer }) => buffer));
}

function levelOf(from: InspectedMesh, { model, by, value, camera, morphs }: InspectRequest) {
  if (by === 'triangles') return from.show_triangles(model, value, morphs);
  if (by === 'detail' || !camera) return from.show_detail(model, value, morphs);
  const view = new View(Float64Array.from(camera), value, 0);
  try {
    return from.show_view(model, view, morphs);
  } finally {
    view.free();
  }
}
