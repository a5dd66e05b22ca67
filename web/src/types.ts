/** Public types: options, progress, errors, and the mesh. */

import type { AnimationClip, BufferGeometry, Camera, Group, Material, Mesh, Object3DEventMap } from 'three';
import type { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** A source of a model's bytes; a string is a URL. */
export type Source = string | URL | File | Blob | ArrayBuffer | ReadableStream<Uint8Array>;

/** What was loaded: a stream, a `.striata` file, a paged file, a glTF file, or a plain mesh that was simplified in the browser. */
export type Kind = 'stream' | 'striata' | 'paged' | 'gltf' | 'mesh';

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
  /** While levels are being built: the completed fraction, 0 to 1. */
  share?: number;
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

/** Where a wasm module is: a URL, bytes, the compiled module, or what gives it. */
export type WasmSource = string | URL | BufferSource | WebAssembly.Module | (() => Promise<WebAssembly.Module>);

/** Options of a loader. */
export interface LoaderOptions {
  /** Whether to decode and build in a worker. Default: true. */
  worker?: boolean;
  /**
   * URL, bytes or compiled module of striata.wasm. Default: the contents of `<script type="text/plain" id="striata-wasm">` in base64,
   * compressed by gzip or not, if present, else the file next to this script.
   */
  wasm?: WasmSource;
  /** striata-builder.wasm, which is fetched only for plain files. Default: next to striata.wasm. */
  builder?: WasmSource;
  /** striata-files.wasm, which is fetched only for `.striata` files without a stream. Default: next to striata.wasm. */
  files?: WasmSource;
  /** Screen error of every scene, in pixels, until it is set otherwise; `null` shows everything that has loaded. Default: 1. */
  pixelError?: number | null;
  /** Called with the `GLTFLoader` that makes the materials of a scene: to set a `KTX2Loader`, or to register plugins. */
  configure?: (loader: GLTFLoader) => void;
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

/** A level to select; the first of these that is given counts. */
export interface LevelTarget {
  /** Coarsest level whose error is at most this, mesh units. */
  error?: number;
  /** Finest level with at most this many triangles. */
  triangles?: number;
  /** 0 (base mesh) to 1 (full mesh). */
  detail?: number;
}

/**
 * Levels of one glTF mesh, shared by its nodes. A level that is set here takes precedence over that of the scene, until it is set to
 * `null`.
 */
export interface StriataLod {
  /** Level of detail from 0 (base mesh) to 1 (full mesh). */
  detail: number;
  /** Shows the finest level with at most this many triangles. */
  triangles: number | null;
  /** Shows the coarsest level whose error is at most this, mesh units. */
  error: number | null;
  /** Refines until the estimated error at the nearest instance is at most this, in pixels. */
  pixelError: number | null;
  /** Number of triangles shown. */
  readonly triangleCount: number;
  readonly fullTriangleCount: number;
  /** Error of the shown level relative to the full mesh, mesh units. */
  readonly shownError: number;
  /** The meshes that show these levels. */
  readonly meshes: readonly Mesh[];
  /**
     * Returns the indices of a level, one list for each primitive, over the attributes of its geometry, which all levels share: for
     * `InstancedMesh` or `THREE.LOD`; `batchLevels` makes a `BatchedMesh`.
     */
  indices(target: LevelTarget): Promise<Uint32Array[]>;
  /** Returns the step that adds a vertex, by its number in the attributes; null for vertices of the base mesh. */
  stepOf(vertex: number): Promise<VertexStep | null>;
  /** Makes a copy of one of the meshes count, too: its size on the screen, and its triangles in a budget. */
  attach(mesh: Mesh): void;
}

/** The step that adds a vertex. */
export interface VertexStep {
  /** Number of steps before it. */
  step: number;
  /** Error of the level without it, mesh units. */
  error: number;
}

/** Options of a single call of `open`. */
export interface OpenOptions extends Omit<LoadOptions, 'material'> {
  /** Whether glTF meshes without normals are smooth up to creases of 50 degrees. Default: false, which is flat, as glTF demands. */
  smooth?: boolean;
}

/** A scene: what it adds to a group. `StriataScene` implements it. Setting a mode turns off the others, as for a mesh. */
export interface StriataSceneLike extends Group<StriataEvents> {
  readonly isStriataScene: true;
  readonly animations: AnimationClip[];
  readonly cameras: Camera[];
  readonly scenes: Group[];
  /** Levels of each glTF mesh that has triangles. */
  readonly lods: readonly StriataLod[];
  /** Share of the steps of all meshes, 0 to 1. */
  detail: number;
  /** Maximum number of triangles of the scene; `null` means no limit. */
  triangleBudget: number | null;
  /** Each mesh shows the coarsest level whose error is at most this, units of the scene. `null` turns this mode off. */
  maxError: number | null;
  /** Each mesh is refined until the estimated error at its nearest instance is at most this, in pixels. `null` turns this mode off. */
  pixelError: number | null;
  /** Keeps the levels of the last view. */
  frozen: boolean;
  coloring: Coloring;
  wireframe: boolean;
  /** Number of triangles shown; those of a mesh count once for each instance. */
  readonly triangleCount: number;
  readonly fullTriangleCount: number;
  /** Number of vertices loaded so far. */
  readonly vertexCount: number;
  /** Largest error of the shown levels, units of the scene. */
  readonly error: number;
  readonly complete: boolean;
  readonly bytesReceived: number;
  readonly bytesTotal: number | null;
  /** Diagonal of the bounding box, units of the scene. */
  readonly diagonal: number;
  readonly kind: Kind;
  /** Whether the z axis points up: the mesh is a terrain with a georeference, or as flat along z as one. */
  readonly isZUp: boolean;
  readonly timings: Readonly<Timings>;
  /** Resolves when everything has arrived. Rejects with a `StriataError` if the rest could not be loaded. */
  readonly finished: Promise<void>;
  /** Terminates the worker and frees geometries, materials and textures. */
  dispose(): void;
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
