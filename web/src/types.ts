/** What the package takes and gives: options, progress, errors, and the mesh that one draws. */

import type { BufferGeometry, Material, Mesh, Object3DEventMap } from 'three';

/** Where the bytes of a model come from. */
export type Source = string | URL | File | Blob | ArrayBuffer | ReadableStream<Uint8Array>;

/** What was read: a bare stream, a `.striata` file, or a plain mesh that was simplified here. */
export type Kind = 'stream' | 'striata' | 'mesh';

/** How triangles are colored: as the material has it, or by what draws them. */
export type Coloring = 'surface' | 'strips' | 'fans' | 'triangles';

/** What a model is waiting for. */
export type Phase = 'download' | 'decode' | 'build' | 'done';

/** How far loading has come. */
export interface Progress {
  bytesReceived: number;
  /** `null` where the source does not tell. */
  bytesTotal: number | null;
  /** Triangles and vertices that have come. */
  triangleCount: number;
  vertexCount: number;
  /** Whether all of the mesh is there. */
  complete: boolean;
  phase: Phase;
}

/** Why a model could not be loaded. */
export type ErrorCode = 'network' | 'not-found' | 'format' | 'corrupt' | 'too-large' | 'aborted' | 'unsupported';

/** Options of one `load`. */
export interface LoadOptions {
  /** Ends the download and the work; `load` then rejects with code `aborted`. A mesh that is `finished` stays as it is. */
  signal?: AbortSignal;
  onProgress?: (progress: Progress) => void;
  /** Default: a standard material that takes vertex colors where the mesh has any. */
  material?: Material | Material[];
  /** A file name, where the source has none. Kinds are told by content, then by extension. */
  name?: string;
}

/** Options of a loader. */
export interface LoaderOptions {
  /** Decode and build in a worker; default true. */
  worker?: boolean;
  /**
   * Where striata.wasm is. Default: a `<script type="text/plain" id="striata-wasm">` with it in base64, else the file
   * beside this script.
   */
  wasm?: string | URL | BufferSource | WebAssembly.Module;
}

/** Loads models; see `StriataLoader`. */
export interface Loader {
  /**
   * Resolves as soon as there is something to draw; the rest goes on coming in.
   *
   * Rejects with a `StriataError`.
   */
  load(source: Source, options?: LoadOptions): Promise<StriataMeshLike>;
}

/** How long things took, milliseconds. */
export interface Timings {
  /** Decoding the stream, without waiting for bytes. */
  decodeMs: number;
  /** Making what views are taken from: while the stream arrives, or of a whole file. */
  buildMs: number;
  /** The last change of level. */
  updateMs: number;
}

/** Events of a mesh, beside those of all objects. */
export interface StriataEvents extends Object3DEventMap {
  /** Other triangles are shown. */
  change: object;
  progress: { progress: Progress };
  /** The rest could not be loaded; the mesh keeps what has come. */
  error: { error: Error & { code: ErrorCode; hint?: string | undefined } };
}

/** What a model can do beside being a three.js mesh; `StriataMesh` is the class. */
export interface StriataMeshLike extends Mesh<BufferGeometry, Material | Material[], StriataEvents> {
  /** 0 is the base mesh, 1 all of it. Setting it leaves the other modes. */
  detail: number;
  /** At most so many triangles; in view-dependent mode too. `null` is no limit. */
  triangleBudget: number | null;
  /** How far what is shown is from the full mesh, mesh units; the largest place where it differs by view. */
  readonly error: number;
  /** The coarsest level that is no farther off, mesh units. `null` leaves the mode. */
  maxError: number | null;
  /** View-dependent: no farther off than so many pixels on the screen. `null` leaves the mode. */
  pixelError: number | null;
  /** Keeps the triangles of the last view, to look at them from elsewhere. */
  frozen: boolean;
  coloring: Coloring;
  wireframe: boolean;
  /** Triangles that are shown. */
  readonly triangleCount: number;
  readonly fullTriangleCount: number;
  /** Vertices that have come. */
  readonly vertexCount: number;
  /** Vertex splits that are shown. */
  readonly splitCount: number;
  /** Vertex splits of the full mesh. */
  readonly stepCount: number;
  /** Whether all bytes are in and decoded. */
  readonly complete: boolean;
  readonly bytesReceived: number;
  readonly bytesTotal: number | null;
  /** Of the bounding box, mesh units: what errors are measured by. */
  readonly diagonal: number;
  readonly kind: Kind;
  readonly timings: Readonly<Timings>;
  /**
   * All bytes are in and decoded. Rejects with a `StriataError` if the rest is damaged; the mesh then
   * keeps what has come.
   */
  readonly finished: Promise<void>;
  /** Frees the worker and the buffers; the material stays, it may be the caller's. */
  dispose(): void;
}
