/**
 * Shows levels of a paged file, and fetches the pages that they need; runs in a worker or on the page.
 *
 * While pages are missing, the finest level that needs none of them is shown, and then finer ones until the request is met. A new
 * request cancels the downloads of the last one, except for those that it needs too. A damaged page is reported, and the mesh stays
 * coarse there.
 */

import { asPlain, asStriataError, isFailure } from '../error.ts';
import { startFiles } from '../files.ts';
import type { LevelRequest, Order, Report, State, Update } from '../protocol.ts';
import type { Coloring } from '../types.ts';
import { PagedModel, View, type PagedWant } from '../wasm/striata-files.js';
import { readRange, type PagedPlace } from './ranges.ts';

/** The first order. */
export interface OpenPaged {
  type: 'open';
  place: PagedPlace;
  name: string;
  module: WebAssembly.Module;
}

export type PagedOrder = OpenPaged | Order;

/** Requests that run at the same time: what browsers allow for one server. */
const MAX_REQUESTS = 6;

/** Tolerances of the levels that are shown while pages are missing, as factors of the one that was asked for. */
const FACTORS = [64, 16, 4, 2, 1];

/** Most triangles of a level that is chosen by its detail. */
const MAX_TRIANGLES = 4_000_000;

/** Thrown when a new request has replaced the current one. */
const REPLACED = Symbol('replaced');

/** Shows one paged file. Pass orders to `take`; reports are delivered to the callback. */
export class PagedEngine {
  readonly #report: (report: Report) => void;
  #model: PagedModel | undefined;
  #place: PagedPlace | undefined;
  #request: LevelRequest = { by: 'error', value: Infinity, limit: 0 };
  #coloring: Coloring = 'surface';
  /** Number of requests. */
  #number = 0;
  #isRunning = false;
  #isClosed = false;
  #isOpen = false;
  readonly #downloads = new Map<string, { bytes: Promise<Uint8Array>; abort: AbortController }>();
  #received = 0;
  #decodeMs = 0;
  #updateMs = 0;

  constructor(report: (report: Report) => void) {
    this.#report = report;
  }

  /** Executes an order. */
  take(order: PagedOrder): void {
    if (this.#isClosed) return;
    if (order.type === 'open') {
      startFiles(order.module);
      this.#model = new PagedModel(order.name);
      this.#place = order.place;
    } else if (order.type === 'show') {
      [this.#request, this.#coloring] = [order.request, order.coloring];
      this.#number += 1;
      // The page may send its next request at once; this one may take many downloads.
      this.#report({ type: 'accepted', ticket: order.ticket });
    } else {
      return;
    }
    void this.#run();
  }

  dispose(): void {
    this.#isClosed = true;
    this.#cancel(new Set());
    if (!this.#isRunning) this.#free();
  }

  #free(): void {
    this.#model?.free();
    this.#model = undefined;
  }

  /** Meets requests, until the last one is met. */
  async #run(): Promise<void> {
    if (this.#isRunning) return;
    this.#isRunning = true;
    try {
      for (let met = -1; met !== this.#number && !this.#isClosed; ) {
        met = this.#number;
        await this.#meet(met).catch((thrown: unknown) => {
          if (thrown !== REPLACED) throw thrown;
        });
      }
    } catch (thrown) {
      this.#cancel(new Set());
      if (!this.#isClosed) this.#report({ type: 'failed', error: asPlain(asStriataError(thrown)) });
    }
    this.#isRunning = false;
    if (this.#isClosed) this.#free();
  }

  /** Shows the level that was asked for, and coarser ones while its pages are missing. */
  async #meet(number: number): Promise<void> {
    if (!this.#isOpen) {
      await this.#complete((model) => model.open(), 0);
      await this.#complete((model) => model.show_error(Infinity), 0);
      this.#isOpen = true;
      this.#post(false);
      this.#report({ type: 'finished' });
    }
    // Nothing else has been asked for yet.
    if (number === 0) return;
    const request = this.#request;
    const last = FACTORS.length - 1;
    // The finest level that needs no download comes first.
    let next = last;
    let isShown = this.#show(request, FACTORS[next]!);
    while (!isShown && next > 0) isShown = this.#show(request, FACTORS[(next -= 1)]!);
    for (; next <= last; next += 1) {
      const factor = FACTORS[next]!;
      if (!isShown) await this.#complete(() => this.#show(request, factor), number);
      isShown = false;
      this.#post(next === last);
    }
  }

  /** Shows a level; returns false if bytes are missing. */
  #show({ by, value, limit, camera }: LevelRequest, factor: number): boolean {
    const model = this.#model!;
    if (by === 'view' && camera) {
      const view = new View(Float64Array.from(camera), value, limit);
      try {
        return model.show_view(view, factor);
      } catch (thrown) {
        // A camera that sees nothing changes nothing.
        if (!isFailure(thrown) || thrown.code !== 'unsupported') throw thrown;
        thrown.free();
        return true;
      } finally {
        view.free();
      }
    }
    if (by === 'error') {
      if (limit === 0) return model.show_error(value * factor);
      // The number of triangles limits what is read; the error may allow fewer.
      return model.show_triangles(Math.max(1, Math.floor(limit / factor))) && (model.shown_error >= value * factor || model.show_error(value * factor));
    }
    const count = by === 'triangles' ? value : value * model.full_triangle_count;
    return model.show_triangles(Math.max(1, Math.floor(Math.min(count, limit || MAX_TRIANGLES, MAX_TRIANGLES) / factor)));
  }

  /** Repeats an action until all bytes that it needs are there; ends if another request than this one (0 for any) is the last. */
  async #complete(action: (model: PagedModel) => boolean, number: number): Promise<void> {
    for (;;) {
      this.#checkLast(number);
      const start = performance.now();
      const isDone = action(this.#model!);
      this.#decodeMs += performance.now() - start;
      if (isDone) return;
      await this.#fetch(this.#model!.take_wants(), number);
    }
  }

  /** Fetches bytes, a few requests at a time. */
  async #fetch(wants: PagedWant[], number: number): Promise<void> {
    const keys = wants.map(({ path, from, to }) => `${path} ${from} ${to}`);
    this.#cancel(new Set(keys));
    let next = 0;
    const fetchNext = async (): Promise<void> => {
      while (next < wants.length) {
        const at = next;
        next += 1;
        const { bytes } = this.#download(keys[at]!, wants[at]!);
        const arrived = await bytes;
        this.#checkLast(number);
        this.#downloads.delete(keys[at]!);
        this.#received += arrived.length;
        this.#model!.supply(wants[at]!, arrived);
      }
    };
    await Promise.all(Array.from({ length: MAX_REQUESTS }, fetchNext));
  }

  #checkLast(number: number): void {
    if (this.#isClosed || (number > 0 && number !== this.#number)) throw REPLACED;
  }

  #download(key: string, { path, from, to }: PagedWant): { bytes: Promise<Uint8Array> } {
    let download = this.#downloads.get(key);
    if (!download) {
      const abort = new AbortController();
      download = { bytes: readRange(this.#place!, path, from, to, abort.signal), abort };
      download.bytes.catch(() => undefined);
      this.#downloads.set(key, download);
    }
    return download;
  }

  /** Cancels all downloads but some. */
  #cancel(kept: ReadonlySet<string>): void {
    for (const [key, { abort }] of this.#downloads) {
      if (kept.has(key)) continue;
      abort.abort();
      this.#downloads.delete(key);
    }
  }

  /** Sends the shown level with its vertices. */
  #post(isComplete: boolean): void {
    const model = this.#model!;
    const start = performance.now();
    const numbers = this.#triangleNumbers(model);
    const vertices = model.vertices();
    try {
      const normals = vertices.take_normals();
      const smoothNormals = normals ? undefined : model.smooth_normals();
      const update: Update = {
        type: 'update',
        state: this.#state(model, isComplete),
        vertices: { first: 0, positions: vertices.take_positions(), normals, colors: vertices.take_colors(), uvs: vertices.take_uvs() },
        smoothNormals,
        indices: model.indices(),
        groupCounts: model.group_counts(),
        numbers,
        settled: true,
        ticket: 0,
      };
      this.#updateMs = performance.now() - start;
      this.#report(update);
      const damage = model.take_damage();
      if (damage) this.#report({ type: 'damaged', error: asPlain(asStriataError(damage)) });
    } finally {
      vertices.free();
    }
  }

  #triangleNumbers(model: PagedModel): Uint32Array | undefined {
    if (this.#coloring === 'surface') return undefined;
    if (this.#coloring === 'strips') return model.color_strips();
    if (this.#coloring === 'fans') return model.color_fans();
    return Uint32Array.from({ length: model.indices().length / 3 }, (_, triangle) => triangle);
  }

  #state(model: PagedModel, complete: boolean): State {
    return {
      kind: 'paged',
      phase: complete ? 'done' : 'download',
      complete,
      vertexCount: model.vertex_count,
      triangleCount: model.full_triangle_count,
      fullVertexCount: model.full_vertex_count,
      fullTriangleCount: model.full_triangle_count,
      stepCount: model.step_count,
      streamBytes: 0,
      receivedBytes: this.#received,
      bounds: model.bounds(),
      isZUp: model.is_z_up,
      diagonal: model.diagonal,
      shownSplitCount: model.shown_split_count,
      shownError: model.shown_error,
      decodeMs: this.#decodeMs,
      buildMs: 0,
      updateMs: this.#updateMs,
    };
  }
}
