/**
 * What decodes, builds and answers: the same code in a worker and in the page.
 *
 * Bytes wait in a queue and are decoded in slices of a few milliseconds, so that requests are answered between them.
 * What has come is told now and then, the more seldom the longer telling takes.
 */

import { Failure, Model, View } from './wasm/striata_web.js';
import { asPlain, asStriataError, StriataError, type PlainError } from './error.ts';
import type { NewVertices, Order, Report, State, Update, Wish } from './protocol.ts';
import type { Coloring, Kind, Phase } from './types.ts';
import { unpacked } from './unpack.ts';

/** Bytes that are decoded between two looks at the clock. */
const PIECE_BYTES = 1 << 13;

/** Between two updates, at least so many milliseconds, and so many times what the last one took. */
const UPDATE_MS = 60;
const UPDATE_SHARE = 4;

/** Lets everything else have its turn. */
function turn(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}

export class Engine {
  readonly #report: (report: Report) => void;
  /** Milliseconds of decoding at a stretch. */
  readonly #sliceMs: number;
  #model = new Model();
  #queue: Uint8Array[] = [];
  #end: { error?: PlainError } | undefined;
  #isPumping = false;
  #isOver = false;
  #isDisposed = false;
  /** The stream is complete, or broken off: bytes that were still on their way are dropped. */
  #hasEnded = false;
  #wish: Wish = { by: 'detail', value: 1, limit: 0 };
  #coloring: Coloring = 'surface';
  #phase: Phase = 'download';
  /** Vertices that the page has. */
  #toldCount = 0;
  #hasNormals = false;
  /** Vertices that the page's computed normals are of; normals of a coarser level are other normals. */
  #smoothOf = -1;
  #decodeMs = 0;
  #buildMs = 0;
  #updateMs = 0;
  #nextUpdate = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(report: (report: Report) => void, sliceMs: number) {
    this.#report = report;
    this.#sliceMs = sliceMs;
  }

  /** Does what the page orders. */
  take(order: Order): void {
    if (this.#isOver) return;
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
        void this.#read(order.bytes, order.name);
        break;
      case 'show':
        this.#wish = order.wish;
        this.#coloring = order.coloring;
        if (this.#model.is_ready) this.#attempt(() => this.#tell(order.ticket));
        break;
    }
  }

  dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    this.#isOver = true;
    clearTimeout(this.#timer);
    this.#queue = [];
    this.#model.free();
  }

  /** Decodes what waits, then ends if nothing more comes. */
  async #pump(): Promise<void> {
    if (this.#isPumping) return;
    this.#isPumping = true;
    while (this.#queue.length > 0 && !this.#isOver) {
      this.#phase = 'decode';
      const error = this.#slice();
      if (error) {
        // What came before the damage stays.
        this.#queue = [];
        this.#end = { error: asPlain(error) };
        break;
      }
      if (performance.now() >= this.#nextUpdate) this.#attempt(() => this.#update());
      await turn();
    }
    this.#isPumping = false;
    if (this.#isOver) return;
    if (this.#end) this.#finish(this.#end.error);
    else this.#updateLater();
  }

  /** Tells what has been decoded even if the line stalls. */
  #updateLater(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      if (!this.#isPumping && !this.#isOver && !this.#hasEnded) this.#attempt(() => this.#update());
    }, this.#nextUpdate - performance.now());
  }

  /** Decodes for a few milliseconds, and prepares views of what came; returns what is wrong with the bytes. */
  #slice(): StriataError | undefined {
    const start = performance.now();
    try {
      while (performance.now() - start < this.#sliceMs) {
        const bytes = this.#queue.shift();
        if (!bytes) break;
        this.#model.push(bytes.subarray(0, PIECE_BYTES));
        if (bytes.length > PIECE_BYTES) this.#queue.unshift(bytes.subarray(PIECE_BYTES));
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
        failure = { code: 'corrupt', message: 'the stream ends before the mesh does', hint: 'was the file copied whole?' };
      }
      // Of damaged bytes nothing more is read; of bytes that are missing, what the last ones tell.
      if (failure?.code !== 'corrupt' || !error) this.#finishDecoding();
      this.#model.reveal();
      if (!this.#model.is_ready) throw new StriataError('corrupt', 'the stream ends before there is anything to draw');
      this.#phase = 'done';
      this.#tell(0);
    } catch (thrown) {
      failure ??= asPlain(asStriataError(thrown));
    }
    this.#end = undefined;
    this.#report(failure ? { type: 'failed', error: failure } : { type: 'finished' });
  }

  #finishDecoding(): void {
    const start = performance.now();
    try {
      this.#model.finish();
    } finally {
      this.#decodeMs += performance.now() - start;
    }
  }

  /** Reads a whole file and builds its model. */
  async #read(bytes: Uint8Array, name: string): Promise<void> {
    this.#phase = 'build';
    const start = performance.now();
    const sink = { report: (_: string, share: number) => this.#report({ type: 'building', share }) };
    let file: { bytes: Uint8Array; name: string } | undefined;
    let failure: unknown;
    try {
      file = await unpacked(bytes, name);
    } catch (thrown) {
      failure = thrown;
    }
    if (this.#isOver) return;
    this.#attempt(() => {
      if (!file) throw failure;
      const model = Model.from_file(file.bytes, file.name, sink);
      this.#model.free();
      this.#model = model;
      this.#buildMs = performance.now() - start;
      this.#phase = 'done';
      this.#tell(0);
      this.#report({ type: 'finished' });
    });
  }

  /** Reports what goes wrong; the engine then takes no more orders. */
  #attempt(work: () => void): void {
    try {
      work();
    } catch (thrown) {
      this.#isOver = true;
      this.#report({ type: 'failed', error: asPlain(asStriataError(thrown)) });
    }
  }

  /**
   * Tells what has been decoded since the last update. Only updates bring new vertices and normals: answers to requests
   * in between are of what the page has already, so that many of them do not hold decoding up.
   */
  #update(): void {
    this.#model.reveal();
    if (this.#model.is_ready) this.#tell(0);
  }

  /** Shows what is wished for, and tells it with what is new. */
  #tell(ticket: number): void {
    const start = performance.now();
    const settled = this.#show();
    const numbers = this.#numbers();
    const vertices = this.#newVertices();
    const smoothNormals = this.#smoothNormals();
    const model = this.#model;
    const [indices, groupCounts] = [model.indices(), model.group_counts()];
    this.#updateMs = performance.now() - start;
    this.#nextUpdate = performance.now() + Math.max(UPDATE_MS, UPDATE_SHARE * this.#updateMs);
    const state = this.#state();
    const update: Update = {
      type: 'update', state, vertices, smoothNormals, indices, groupCounts, numbers, settled, ticket,
    };
    this.#report(update);
  }

  /** Goes to the level that is wished for; whether asking again would show the same. */
  #show(): boolean {
    const { by, value, limit, camera } = this.#wish;
    const model = this.#model;
    if (by === 'view' && camera) return this.#showView(camera, value, limit);
    if (by === 'triangles') model.show_triangles(value);
    else if (by === 'error') model.show_error(value);
    else model.show_detail(by === 'detail' ? value : 1);
    const shownCount = model.group_counts().reduce((sum, count) => sum + count, 0);
    if (limit > 0 && shownCount > limit) model.show_triangles(limit);
    return true;
  }

  /** A camera that sees nothing leaves what is shown: another may see more. */
  #showView(camera: number[], pixels: number, limit: number): boolean {
    const view = new View(Float64Array.from(camera), pixels, limit);
    try {
      return this.#model.show_view(view);
    } catch (thrown) {
      if (!(thrown instanceof Failure)) throw thrown;
      thrown.free();
      return true;
    } finally {
      view.free();
    }
  }

  #numbers(): Uint32Array | undefined {
    if (this.#coloring === 'strips') return this.#model.color_strips();
    if (this.#coloring === 'fans') return this.#model.color_fans();
    if (this.#coloring === 'surface') return undefined;
    const count = this.#model.group_counts().reduce((sum, n) => sum + n, 0);
    return Uint32Array.from({ length: count }, (_, triangle) => triangle);
  }

  #newVertices(): NewVertices | undefined {
    const first = this.#toldCount;
    if (this.#model.vertex_count === first) return undefined;
    const vertices = this.#model.vertices(first);
    try {
      const normals = vertices.take_normals();
      this.#hasNormals = normals !== undefined;
      this.#toldCount = this.#model.vertex_count;
      return { first, positions: vertices.take_positions(), normals, colors: vertices.take_colors(), uvs: vertices.take_uvs() };
    } finally {
      vertices.free();
    }
  }

  #smoothNormals(): Float32Array | undefined {
    if (this.#hasNormals || this.#smoothOf === this.#model.vertex_count) return undefined;
    this.#smoothOf = this.#model.vertex_count;
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
      diagonal: model.diagonal,
      shownSplitCount: model.shown_split_count,
      shownError: model.shown_error,
      decodeMs: this.#decodeMs,
      buildMs: this.#buildMs,
      updateMs: this.#updateMs,
    };
  }
}
