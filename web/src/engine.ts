/**
 * Decodes and builds models and answers requests for levels; runs in a worker or on the page.
 *
 * Received bytes are queued and decoded in slices of a few milliseconds, so that requests are answered in between. Progress is
 * reported in intervals that grow with the time a report takes.
 */

import { Model, StreamPlace, View } from './wasm/striata.js';
import { buildModel, startBuilder } from './build.ts';
import { isContainer, isStream } from './magic.ts';
import { asPlain, asStriataError, isFailure, StriataError, type PlainError } from './error.ts';
import type { LevelRequest, NewVertices, Order, Report, State, Update } from './protocol.ts';
import type { MeshArrays } from './scene/protocol.ts';
import type { Coloring, Kind, Phase, VertexStep } from './types.ts';
import { decompressed } from './unpack.ts';
import { yieldToEventLoop } from './event-loop.ts';

/** Bytes decoded between two checks of the clock. */
const CHUNK_BYTES = 1 << 13;

/** Minimum time between two updates. */
const MIN_UPDATE_INTERVAL_MS = 60;
/** Minimum time between two updates, as a multiple of the time the last one took. */
const UPDATE_INTERVAL_FACTOR = 4;

function noBuilder(): Promise<WebAssembly.Module> {
  return Promise.reject(new StriataError('unsupported', 'meshes without a stream need striata-builder.wasm'));
}

/** The stream that a file is or contains; undefined if it has none. */
function streamIn(bytes: Uint8Array): Uint8Array | undefined {
  if (isStream(bytes)) return bytes;
  if (!isContainer(bytes)) return undefined;
  const place = StreamPlace.find(bytes);
  const { offset, length } = place;
  place.free();
  return length > 0 ? bytes.subarray(offset, offset + length) : undefined;
}

/** Decodes a file that is or contains a stream. */
async function streamFile(bytes: Uint8Array, name: string): Promise<Model> {
  const file = await decompressed(bytes, name);
  const stream = streamIn(file.bytes);
  if (stream) return wholeStream(stream);
  if (isContainer(file.bytes)) {
    throw new StriataError('unsupported', `${name} contains no stream`, 'convert it with `striata encode`');
  }
  throw new StriataError('format', `${name}: the file contains no stream`, 'files that contain one: .stri and .striata, optionally .gz or .zst');
}

function wholeStream(bytes: Uint8Array): Model {
  const model = new Model();
  try {
    model.push(bytes);
    if (!model.is_complete) throw new StriataError('corrupt', 'the stream is incomplete', 'check that the whole file was copied');
    model.reveal();
    return model;
  } catch (thrown) {
    model.free();
    throw thrown;
  }
}

/** Decodes one model. Pass orders to `take`; reports are delivered to the callback. */
export class Engine {
  readonly #report: (report: Report) => void;
  /** Longest uninterrupted decoding, milliseconds. */
  readonly #sliceMs: number;
  readonly #loadBuilder: () => Promise<WebAssembly.Module>;
  #model = new Model();
  #queue: Uint8Array[] = [];
  #end: { error?: PlainError } | undefined;
  #isPumping = false;
  #isClosed = false;
  #isDisposed = false;
  /** Whether the stream is complete or has failed; bytes that arrive later are dropped. */
  #hasEnded = false;
  #request: LevelRequest = { by: 'detail', value: 1, limit: 0 };
  #coloring: Coloring = 'surface';
  #phase: Phase = 'download';
  /** Number of vertices already sent to the page. */
  #sentVertexCount = 0;
  #hasNormals = false;
  /** Vertex count for which smooth normals were last computed; each vertex count has different normals. */
  #smoothNormalsVertexCount = -1;
  #decodeMs = 0;
  #buildMs = 0;
  #updateMs = 0;
  #nextUpdate = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** `loadBuilder` is called for files without a stream whose order brings no module. */
  constructor(report: (report: Report) => void, sliceMs: number, loadBuilder: () => Promise<WebAssembly.Module> = noBuilder) {
    this.#report = report;
    this.#sliceMs = sliceMs;
    this.#loadBuilder = loadBuilder;
  }

  /** Executes an order. */
  take(order: Order): void {
    if (this.#isClosed) return;
    switch (order.type) {
      case 'bytes':
        if (this.#hasEnded) break;
        this.#queue.push(order.bytes);
        void this.#pump();
        break;
      case 'end':
        if (this.#hasEnded) break;
        this.#end = order.error ? { error: order.error } : {};
        void this.#pump();
        break;
      case 'file':
        void this.#read(() => streamFile(order.bytes, order.name));
        break;
      case 'arrays':
        void this.#read(() => this.#build(order.arrays, order.builder));
        break;
      case 'show':
        this.#request = order.request;
        this.#coloring = order.coloring;
        if (this.#model.is_ready) this.#reportErrors(() => this.#postUpdate(order.ticket));
        break;
      case 'step':
        this.#report({ type: 'step', step: stepOf(this.#model, order.vertex) });
        break;
    }
  }

  dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    this.#isClosed = true;
    clearTimeout(this.#timer);
    this.#queue = [];
    this.#model.free();
  }

  /** Decodes the queued bytes, then finishes if no more are coming. */
  async #pump(): Promise<void> {
    if (this.#isPumping) return;
    this.#isPumping = true;
    while (this.#queue.length > 0 && !this.#isClosed) {
      this.#phase = 'decode';
      const error = this.#decodeSlice();
      if (error) {
        // The part before the damage is kept.
        this.#queue = [];
        this.#end = { error: asPlain(error) };
        break;
      }
      if (performance.now() >= this.#nextUpdate) this.#reportErrors(() => this.#update());
      await yieldToEventLoop();
    }
    this.#isPumping = false;
    if (this.#isClosed) return;
    if (this.#end) this.#finish(this.#end.error);
    else this.#scheduleUpdate();
  }

  /** Schedules an update, so that decoded data is shown even if the connection stalls. */
  #scheduleUpdate(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      if (!this.#isPumping && !this.#isClosed && !this.#hasEnded) this.#reportErrors(() => this.#update());
    }, this.#nextUpdate - performance.now());
  }

  /** Decodes for a few milliseconds and prepares view-dependent refinement; returns an error if the bytes are invalid. */
  #decodeSlice(): StriataError | undefined {
    const start = performance.now();
    try {
      while (performance.now() - start < this.#sliceMs) {
        const bytes = this.#queue.shift();
        if (!bytes) break;
        this.#model.push(bytes.subarray(0, CHUNK_BYTES));
        if (bytes.length > CHUNK_BYTES) this.#queue.unshift(bytes.subarray(CHUNK_BYTES));
      }
      return undefined;
    } catch (thrown) {
      return asStriataError(thrown);
    } finally {
      const end = performance.now();
      this.#decodeMs += end - start;
      this.#model.grow();
      this.#buildMs += performance.now() - end;
    }
  }

  #finish(error: PlainError | undefined): void {
    let failure = error;
    this.#hasEnded = true;
    clearTimeout(this.#timer);
    try {
      if (!failure && !this.#model.is_complete) {
        failure = { code: 'corrupt', message: 'the stream is incomplete', hint: 'check that the whole file was copied' };
      }
      // Damaged bytes are not decoded further; if bytes are missing, the last ones received are still used.
      if (failure?.code !== 'corrupt' || !error) this.#finishDecoding();
      this.#model.reveal();
      if (!this.#model.is_ready) throw new StriataError('corrupt', 'the stream ends before anything can be drawn');
      this.#phase = 'done';
      this.#postUpdate(0);
    } catch (thrown) {
      failure ??= asPlain(asStriataError(thrown));
    }
    this.#end = undefined;
    this.#report(failure ? { type: 'failed', error: failure } : { type: 'finished' });
    if (!failure) this.#examine();
  }

  /** Reports whether the backs of triangles can be seen. */
  #examine(): void {
    if (this.#model.is_solid()) this.#report({ type: 'solid' });
  }

  #finishDecoding(): void {
    const start = performance.now();
    try {
      this.#model.finish();
    } finally {
      this.#decodeMs += performance.now() - start;
    }
  }

  /** Replaces the model by one that is read or built as a whole. */
  async #read(read: () => Promise<Model>): Promise<void> {
    this.#phase = 'build';
    const start = performance.now();
    let model: Model | undefined;
    let failure: unknown;
    try {
      model = await read();
    } catch (thrown) {
      failure = thrown;
    }
    if (this.#isClosed) return model?.free();
    this.#reportErrors(() => {
      if (!model) throw failure;
      this.#model.free();
      this.#model = model;
      this.#buildMs = performance.now() - start;
      this.#phase = 'done';
      this.#postUpdate(0);
      this.#report({ type: 'finished' });
      this.#examine();
    });
  }

  async #build(arrays: MeshArrays, builder: WebAssembly.Module | undefined): Promise<Model> {
    startBuilder(builder ?? (await this.#loadBuilder()));
    return buildModel(arrays, (share) => this.#report({ type: 'building', share }));
  }

  /** Runs `work` and reports an error if it throws; the engine then accepts no more orders. */
  #reportErrors(work: () => void): void {
    try {
      work();
    } catch (thrown) {
      this.#isClosed = true;
      this.#report({ type: 'failed', error: asPlain(asStriataError(thrown)) });
    }
  }

  /**
     * Sends what has been decoded since the last update. Only updates contain new vertices and normals; answers to requests refer to
     * vertices the page already has, so that many requests do not slow down decoding.
     */
  #update(): void {
    this.#model.reveal();
    if (this.#model.is_ready) this.#postUpdate(0);
  }

  /** Switches to the requested level and sends it with any new vertices. */
  #postUpdate(ticket: number): void {
    const start = performance.now();
    const settled = this.#show();
    const numbers = this.#triangleNumbers();
    const vertices = this.#newVertices();
    const smoothNormals = this.#smoothNormals();
    const model = this.#model;
    const [indices, groupCounts] = [model.indices(), model.group_counts()];
    this.#updateMs = performance.now() - start;
    this.#nextUpdate = performance.now() + Math.max(MIN_UPDATE_INTERVAL_MS, UPDATE_INTERVAL_FACTOR * this.#updateMs);
    const state = this.#state();
    const update: Update = {
      type: 'update', state, vertices, smoothNormals, indices, groupCounts, numbers, settled, ticket,
    };
    this.#report(update);
  }

  /** Switches to the requested level; returns whether repeating the request would give the same result. */
  #show(): boolean {
    const { by, value, limit, camera } = this.#request;
    const model = this.#model;
    if (by === 'view' && camera) return this.#showView(camera, value, limit);
    if (by === 'triangles') model.show_triangles(value);
    else if (by === 'error') model.show_error(value);
    else model.show_detail(by === 'detail' ? value : 1);
    const shownCount = model.group_counts().reduce((sum, count) => sum + count, 0);
    if (limit > 0 && shownCount > limit) model.show_triangles(limit);
    return true;
  }

  /** Refines for a camera. A camera that sees nothing changes nothing. */
  #showView(camera: number[], pixels: number, limit: number): boolean {
    const numbers = Float64Array.from(camera);
    const model = this.#model;
    const view = new View(numbers, pixels, limit);
    try {
      return model.show_view(view);
    } catch (thrown) {
      if (!isFailure(thrown)) throw thrown;
      thrown.free();
      return true;
    } finally {
      view.free();
    }
  }

  #triangleNumbers(): Uint32Array | undefined {
    if (this.#coloring === 'strips') return this.#model.color_strips();
    if (this.#coloring === 'fans') return this.#model.color_fans();
    if (this.#coloring === 'surface') return undefined;
    const count = this.#model.group_counts().reduce((sum, n) => sum + n, 0);
    return Uint32Array.from({ length: count }, (_, triangle) => triangle);
  }

  #newVertices(): NewVertices | undefined {
    const first = this.#sentVertexCount;
    if (this.#model.vertex_count === first) return undefined;
    const vertices = this.#model.vertices(first);
    try {
      const normals = vertices.take_normals();
      this.#hasNormals = normals !== undefined;
      this.#sentVertexCount = this.#model.vertex_count;
      return { first, positions: vertices.take_positions(), normals, colors: vertices.take_colors(), uvs: vertices.take_uvs() };
    } finally {
      vertices.free();
    }
  }

  #smoothNormals(): Float32Array | undefined {
    if (this.#hasNormals || this.#smoothNormalsVertexCount === this.#model.vertex_count) return undefined;
    this.#smoothNormalsVertexCount = this.#model.vertex_count;
    return this.#model.smooth_normals();
  }

  #state(): State {
    const model = this.#model;
    return {
      kind: model.kind as Kind,
      phase: this.#phase,
      complete: model.is_complete,
      vertexCount: model.vertex_count,
      triangleCount: model.triangle_count,
      fullVertexCount: model.full_vertex_count,
      fullTriangleCount: model.full_triangle_count,
      stepCount: model.step_count,
      streamBytes: model.stream_bytes,
      bounds: model.bounds(),
      isZUp: model.is_z_up,
      diagonal: model.diagonal,
      shownSplitCount: model.shown_split_count,
      shownError: model.shown_error,
      decodeMs: this.#decodeMs,
      buildMs: this.#buildMs,
      updateMs: this.#updateMs,
    };
  }
}

/** The step that adds a vertex; null for vertices of the base mesh. */
export function stepOf(model: Model, vertex: number): VertexStep | null {
  const step = model.step_of(vertex);
  return step < 0 ? null : { step, error: model.error_at(step) };
}
