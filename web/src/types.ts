/** Public types: options, progress, errors, and the mesh. */

import type { BufferGeometry, Material, Mesh, Object3DEventMap } from 'three';

/** A source of a model's bytes; a string is a URL. */
export type Source = string | URL | File | Blob | ArrayBuffer | ReadableStream<Uint8Array>;

/** What was loaded: a bare stream, a `.striata` file, or a plain mesh that was simplified in the browser. */
export type Kind = 'stream' | 'striata' | 'mesh';

/** How triangles are colored: by the material, or by the strip, fan or triangle they belong to. */
export type Coloring = 'surface' | 'strips' | 'fans' | 'triangles';

/** Current phase of loading. */
export type Phase = 'download' | 'decode' | 'build' | 'done';

/** Progress of loading. */
export interface Progress {
  bytesReceived: number;
  /** Total number of bytes; `null` if unknown. */
  bytesTotal: number | null;
  /** Number of triangles and vertices loaded so far. */
  triangleCount: number;
  vertexCount: number;
  /** Whether the whole mesh has loaded. */
  complete: boolean;
  phase: Phase;
}

/** Why a model could not be loaded. */
export type ErrorCode = 'network' | 'not-found' | 'format' | 'corrupt' | 'too-large' | 'aborted' | 'unsupported';

/** Options of a single call of `load`. */
export interface LoadOptions {
  /** Aborts loading; `load` then rejects with code `aborted`. Has no effect on a mesh that is `finished`. */
  signal?: AbortSignal;
  /** Called whenever more of the model has loaded. */
  onProgress?: (progress: Progress) => void;
  /** Material, or one for each group of triangles. Default: a standard material that uses the mesh's vertex colors, if any. */
  material?: Material | Material[];
  /** File name, for sources without one. The format is detected by content first, then by extension. */
  name?: string;
}

/** Options of a loader. */
export interface LoaderOptions {
  /** Whether to decode and build in a worker. Default: true. */
  worker?: boolean;
  /**
     * URL, bytes or compiled module of striata.wasm. Default: the contents of `<script type="text/plain" id="striata-wasm">` in base64
     * if present, else the file next to this script.
     */
  wasm?: string | URL | BufferSource | WebAssembly.Module;
}

/** Loads models; see `StriataLoader`. */
export interface Loader {
  /**
     * Loads a model. Resolves as soon as there is something to draw; the rest continues to stream in.
     *
     * Rejects with a `StriataError`.
     */
  load(source: Source, options?: LoadOptions): Promise<StriataMeshLike>;
}

/** Durations in milliseconds. */
export interface Timings {
  /** Decoding the stream, not counting the wait for bytes. */
  decodeMs: number;
  /** Preparing view-dependent refinement while a stream loads, or building the model of a plain mesh. */
  buildMs: number;
  /** The last change of level. */
  updateMs: number;
}

/** Events of the mesh, in addition to those of every `Object3D`. */
export interface StriataEvents extends Object3DEventMap {
  /** The mesh has changed and should be drawn again. */
  change: object;
  /** More of the model has loaded. */
  progress: { progress: Progress };
  /** The rest of the model could not be loaded; the mesh keeps the part that has been loaded. */
  error: { error: Error & { code: ErrorCode; hint?: string | undefined } };
}

/** The mesh of a model: what it adds to a three.js mesh. `StriataMesh` implements it. */
export interface StriataMeshLike extends Mesh<BufferGeometry, Material | Material[], StriataEvents> {
  /** Level of detail from 0 (base mesh) to 1 (full mesh). Setting it turns off the other modes. */
  detail: number;
  /** Maximum number of triangles, also in view-dependent mode; `null` means no limit. */
  triangleBudget: number | null;
  /** Error of the shown level relative to the full mesh, mesh units; with view-dependent detail, the largest error anywhere. */
  readonly error: number;
  /** Selects the coarsest level whose error is at most this, mesh units. `null` turns this mode off. */
  maxError: number | null;
  /** View-dependent detail: refines until the estimated screen error is at most this, in pixels. `null` turns this mode off. */
  pixelError: number | null;
  /** Keeps the triangles of the last view, so that they can be viewed from elsewhere. */
  frozen: boolean;
  coloring: Coloring;
  wireframe: boolean;
  /** Number of triangles shown. */
  readonly triangleCount: number;
  readonly fullTriangleCount: number;
  /** Number of vertices loaded so far. */
  readonly vertexCount: number;
  /** Number of vertex splits of the shown level. */
  readonly splitCount: number;
  /** Number of vertex splits of the full mesh. */
  readonly stepCount: number;
  /** Whether the model has been received and decoded completely. */
  readonly complete: boolean;
  readonly bytesReceived: number;
  readonly bytesTotal: number | null;
  /** Diagonal of the bounding box, mesh units; a scale for errors. */
  readonly diagonal: number;
  readonly kind: Kind;
  readonly timings: Readonly<Timings>;
  /**
     * Resolves when the model has been received and decoded completely. Rejects with a `StriataError` if the rest could not be loaded; the
     * mesh then keeps the part that has.
     */
  readonly finished: Promise<void>;
  /** Terminates the worker and frees the buffers. A material that you passed to `load` is not disposed of. */
  dispose(): void;
}
