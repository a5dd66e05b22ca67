/**
 * Decodes scenes and answers requests for the levels of their meshes; runs in a worker or on the page.
 *
 * Works like the engine of a single mesh: bytes are decoded in slices, and what has arrived is reported in intervals. A target for all
 * meshes is distributed over them again whenever more has arrived.
 */

import { Model, SceneModel, View, type SceneDocument as WasmDocument, type SceneImage as WasmImage } from '../wasm/striata.js';
import { StoredFile, View as StoredView } from '../wasm/striata-files.js';
import { asPlain, asStriataError, isFailure, StriataError, type PlainError } from '../error.ts';
import type { LevelRequest } from '../protocol.ts';
import type { Coloring, Phase } from '../types.ts';
import { buildModel, startBuilder } from '../build.ts';
import { stepOf } from '../engine.ts';
import { startFiles } from '../files.ts';
import { distribute } from './distribute.ts';
import type { MeshArrays, MeshUpdate, NewLayer, SceneDocument, SceneImage, SceneOrder, SceneReport, SceneState, SceneTarget } from './protocol.ts';
import { yieldToEventLoop } from '../event-loop.ts';

/** Bytes decoded between two checks of the clock. */
const CHUNK_BYTES = 1 << 13;

/** Minimum time between two updates. */
const MIN_UPDATE_INTERVAL_MS = 60;
/** Minimum time between two updates, as a multiple of the time the last one took. */
const UPDATE_INTERVAL_FACTOR = 4;

const ARRAYS = {
  f32: Float32Array, f64: Float64Array, i8: Int8Array, i16: Int16Array, i32: Int32Array, u8: Uint8Array, u16: Uint16Array, u32: Uint32Array,
};

/** A mesh of the scene, and what the page knows about it. */
interface EngineMesh {
  model: Model;
  /** The class of views of the module that the model belongs to. */
  View: typeof View;
  sentVertexCount: number;
  /** The level that was sent last, as a text that identifies it. */
  sentLevel: string;
  /** Whether a view can be refined further. */
  isSettled: boolean;
  /** Whether fewer steps than wanted had arrived when the level was sent. */
  isShort?: boolean;
}

/** Decodes one scene. Pass orders to `take`; reports are delivered to the callback. */
export class SceneEngine {
  readonly #report: (report: SceneReport) => void;
  readonly #sliceMs: number;
  /** The scene, if its meshes are parts of one stream. */
  #scene: SceneModel | undefined;
  #meshes: (EngineMesh | undefined)[] = [];
  #queue: { bytes: Uint8Array; mesh: number | undefined }[] = [];
  #end: { error?: PlainError } | undefined;
  #isPumping = false;
  #isDisposed = false;
  #hasEnded = false;
  #hasSentDocument = false;
  #hasSentAnimations = false;
  #target: SceneTarget = { meshes: [], tolerance: Infinity, limit: 0 };
  #coloring: Coloring = 'surface';
  /** Number of the last target. */
  #ticket = 0;
  #phase: Phase = 'download';
  #decodeMs = 0;
  #buildMs = 0;
  #updateMs = 0;
  #nextUpdate = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(report: (report: SceneReport) => void, sliceMs: number) {
    this.#report = report;
    this.#sliceMs = sliceMs;
  }

  /** Executes an order. */
  take(order: SceneOrder): void {
    if (this.#isDisposed) return;
    switch (order.type) {
      case 'bytes':
        if (this.#hasEnded) break;
        this.#queue.push({ bytes: order.bytes, mesh: order.mesh });
        void this.#pump();
        break;
      case 'end':
        if (this.#hasEnded) break;
        this.#end = order.error ? { error: order.error } : {};
        void this.#pump();
        break;
      case 'build':
        void this.#build(order.meshes, order.builder);
        break;
      case 'stored':
        void this.#openStored(order.bytes, order.files);
        break;
      case 'target':
        this.#target = order.target;
        this.#coloring = order.coloring;
        this.#ticket = order.ticket;
        // Before anything can be drawn, the first update is the answer.
        if (this.#isReady) this.#reportErrors(() => this.#postMeshes());
        break;
      case 'indices':
        this.#reportErrors(() => this.#postIndices(order.id, order.mesh, order.request));
        break;
      case 'step': {
        const model = this.#meshes[order.mesh]?.model;
        this.#report({ type: 'step', id: order.id, step: model ? stepOf(model, order.vertex) : null });
        break;
      }
    }
  }

  dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    clearTimeout(this.#timer);
    this.#queue = [];
    for (const mesh of this.#meshes) mesh?.model.free();
    this.#scene?.free();
  }

  /** Whether there is something to draw. */
  get #isReady(): boolean {
    return this.#scene ? this.#hasSentDocument : this.#meshes.some((mesh) => mesh?.model.is_ready);
  }

  get #isComplete(): boolean {
    return this.#scene ? this.#scene.is_complete : this.#meshes.every((mesh) => mesh === undefined || mesh.model.is_complete);
  }

  /** Builds the levels of all meshes. Those that cannot have any are reported, unless that concerns all of them. */
  async #build(meshes: MeshArrays[], builder: WebAssembly.Module): Promise<void> {
    this.#phase = 'build';
    const start = performance.now();
    const sizes = meshes.map(({ groups }) => groups.reduce((sum, { length }) => sum + length, 0));
    const total = sizes.reduce((sum, size) => sum + size, 0) || 1;
    const failures: [number, PlainError][] = [];
    let done = 0;
    startBuilder(builder);
    for (const [index, mesh] of meshes.entries()) {
      if (this.#isDisposed) return;
      try {
        const model = buildModel(mesh, (share) => this.#report({ type: 'building', share: (done + share * sizes[index]!) / total }));
        this.#meshes[index] = newMesh(model);
      } catch (thrown) {
        failures.push([index, asPlain(asStriataError(thrown))]);
      }
      done += sizes[index]!;
      await yieldToEventLoop();
    }
    if (this.#isDisposed) return;
    this.#buildMs = performance.now() - start;
    this.#hasEnded = true;
    this.#phase = 'done';
    if (failures.length > 0 && failures.length === meshes.length) return this.#report({ type: 'failed', error: failures[0]![1] });
    for (const [mesh, error] of failures) this.#report({ type: 'unbuilt', mesh, error });
    this.#reportErrors(() => {
      this.#postMeshes();
      this.#report({ type: 'finished' });
      this.#examine();
    });
  }

  /** Reports whether the backs of triangles can be seen. */
  #examine(): void {
    // Scenes of several meshes have materials, which say what is shown.
    const [mesh, ...others] = this.#meshes;
    if (mesh && others.length === 0 && mesh.model.is_solid()) this.#report({ type: 'solid' });
  }

  /** Reads a whole file. Of a large one, the first levels are shown while the others are put in order. */
  async #openStored(bytes: Uint8Array, files: WebAssembly.Module): Promise<void> {
    this.#phase = 'decode';
    let file: StoredFile | undefined;
    const later: number[] = [];
    this.#reportErrors(() => {
      const start = performance.now();
      startFiles(files);
      file = StoredFile.read(bytes);
      const document = documentOf(file.take_document()!);
      for (let index = 0; index < file.mesh_count; index++) {
        const first = file.first_levels(index);
        if (first) later.push(index);
        const model = first ?? file.take_mesh(index);
        this.#meshes.push(model && newMesh(model, StoredView));
      }
      this.#decodeMs = performance.now() - start;
      if (later.length === 0) this.#phase = 'done';
      this.#report({ type: 'document', document, meshes: this.#updates(), state: this.#state() });
    });
    for (const index of later) {
      // The first levels are drawn, and other targets arrive, between two meshes.
      await yieldToEventLoop();
      if (this.#isDisposed) break;
      this.#reportErrors(() => this.#complete(index, file!));
    }
    file?.free();
    if (this.#isDisposed) return;
    this.#hasEnded = true;
    this.#phase = 'done';
    this.#reportErrors(() => {
      if (later.length > 0) this.#postMeshes();
      this.#report({ type: 'finished' });
      this.#examine();
    });
  }

  /** Replaces the first levels of a mesh by all of them. */
  #complete(index: number, file: StoredFile): void {
    const start = performance.now();
    const model = file.take_mesh(index)!;
    this.#meshes[index]?.model.free();
    this.#meshes[index] = newMesh(model, StoredView);
    this.#decodeMs += performance.now() - start;
    if (performance.now() >= this.#nextUpdate) this.#postMeshes();
  }

  /** Decodes the queued bytes, then finishes if no more are coming. */
  async #pump(): Promise<void> {
    if (this.#isPumping) return;
    this.#isPumping = true;
    while (this.#queue.length > 0 && !this.#isDisposed) {
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
    if (this.#isDisposed) return;
    if (this.#end) this.#finish(this.#end.error);
    else this.#scheduleUpdate();
  }

  /** Schedules an update, so that decoded data is shown even if the connection stalls. */
  #scheduleUpdate(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      if (!this.#isPumping && !this.#isDisposed && !this.#hasEnded) this.#reportErrors(() => this.#update());
    }, this.#nextUpdate - performance.now());
  }

  /** Decodes for a few milliseconds; returns an error if the bytes are invalid. */
  #decodeSlice(): StriataError | undefined {
    const start = performance.now();
    try {
      while (performance.now() - start < this.#sliceMs) {
        const next = this.#queue[0];
        if (!next) break;
        this.#push(next.bytes.subarray(0, CHUNK_BYTES), next.mesh);
        if (next.bytes.length > CHUNK_BYTES) next.bytes = next.bytes.subarray(CHUNK_BYTES);
        else this.#queue.shift();
      }
      return undefined;
    } catch (thrown) {
      return asStriataError(thrown);
    } finally {
      this.#decodeMs += performance.now() - start;
    }
  }

  #push(bytes: Uint8Array, mesh: number | undefined): void {
    if (mesh !== undefined) {
      const own = (this.#meshes[mesh] ??= newMesh(new Model()));
      own.model.push(bytes);
      return;
    }
    this.#scene ??= new SceneModel();
    this.#scene.push(bytes);
    if (this.#meshes.length > 0 || !this.#scene.has_document) return;
    for (let index = 0; index < this.#scene.mesh_count; index++) {
      const model = this.#scene.mesh(index);
      this.#meshes.push(model && newMesh(model));
    }
  }

  #finish(error: PlainError | undefined): void {
    let failure = error;
    this.#hasEnded = true;
    clearTimeout(this.#timer);
    try {
      if (!failure && !this.#isComplete) {
        failure = { code: 'corrupt', message: 'the stream is incomplete', hint: 'check that the whole file was copied' };
      }
      // Damaged bytes are not decoded further; if bytes are missing, the last ones received are still used.
      if (failure?.code !== 'corrupt' || !error) this.#finishDecoding();
      this.#phase = 'done';
      this.#update();
      if (!this.#isReady) throw new StriataError('corrupt', 'the stream ends before anything can be drawn');
    } catch (thrown) {
      failure ??= asPlain(asStriataError(thrown));
    }
    this.#end = undefined;
    this.#report(failure ? { type: 'failed', error: failure } : { type: 'finished' });
    if (!failure) this.#examine();
  }

  #finishDecoding(): void {
    if (this.#isComplete) return;
    if (this.#scene) this.#scene.finish();
    else this.#meshes.forEach((mesh) => mesh?.model.finish());
  }

  /** Runs `work` and reports an error if it throws; the engine then accepts no more orders. */
  #reportErrors(work: () => void): void {
    try {
      work();
    } catch (thrown) {
      this.#isDisposed = true;
      this.#report({ type: 'failed', error: asPlain(asStriataError(thrown)) });
    }
  }

  /** Sends what has been decoded since the last update. */
  #update(): void {
    for (const mesh of this.#meshes) mesh?.model.reveal();
    const scene = this.#scene;
    if (!scene) {
      if (this.#isReady) this.#postMeshes();
      return;
    }
    if (!scene.is_drawable) return;
    if (!this.#hasSentDocument) {
      const document = documentOf(scene.document());
      this.#hasSentDocument = true;
      this.#hasSentAnimations = document.hasAnimations;
      scene.take_images();
      this.#report({ type: 'document', document, meshes: this.#updates(), state: this.#state() });
      return;
    }
    this.#postMeshes();
    const images = [...new Set(scene.take_images())].map((index) => imageOf(index, scene.image(index)!));
    if (images.length > 0) this.#report({ type: 'images', images });
    if (this.#hasSentAnimations) return;
    const document = scene.document();
    if (!document.has_animations) return document.free();
    this.#hasSentAnimations = true;
    this.#report({ type: 'animations', document: { ...documentOf(document), images: [] } });
  }

  /** Sends the meshes that have changed: always for the last target. */
  #postMeshes(): void {
    const start = performance.now();
    const meshes = this.#updates();
    this.#updateMs = performance.now() - start;
    this.#nextUpdate = performance.now() + Math.max(MIN_UPDATE_INTERVAL_MS, UPDATE_INTERVAL_FACTOR * this.#updateMs);
    const settled = this.#meshes.every((mesh) => mesh?.isSettled ?? true);
    this.#report({ type: 'meshes', meshes, state: this.#state(), ticket: this.#ticket, settled });
  }

  /** Shows the target, and returns the meshes that have changed. */
  #updates(): MeshUpdate[] {
    const ready = this.#meshes.map((mesh) => (mesh?.model.is_ready ? mesh : undefined));
    const splits = distribute(this.#target, ready.map((mesh) => mesh?.model));
    const requests = new Map(this.#target.meshes.map(({ mesh, request }) => [mesh, request]));
    const updates: MeshUpdate[] = [];
    ready.forEach((mesh, index) => {
      if (!mesh) return;
      const isNew = mesh.model.vertex_count !== mesh.sentVertexCount;
      const hasChanged = this.#show(mesh, requests.get(index), splits.get(index) ?? 0, isNew);
      if (isNew || hasChanged) updates.push(this.#updateOf(index, mesh, hasChanged));
    });
    return updates;
  }

  /** Shows a level; returns whether it differs from the one that was sent last. `isNew` if vertices have arrived since. */
  #show(mesh: EngineMesh, request: LevelRequest | undefined, splitCount: number, isNew: boolean): boolean {
    const { model } = mesh;
    const what = request ? JSON.stringify(request) : `split ${splitCount}`;
    const level = `${this.#coloring} ${what} ${request ? model.vertex_count : ''}`;
    if (level === mesh.sentLevel && mesh.isSettled && !(isNew && mesh.isShort)) return false;
    mesh.sentLevel = level;
    mesh.isSettled = true;
    if (request) mesh.isSettled = showRequest(mesh, request);
    else model.show_detail(model.step_count > 0 ? splitCount / model.step_count : 1);
    mesh.isShort = !request && model.shown_split_count < splitCount;
    return true;
  }

  #updateOf(index: number, mesh: EngineMesh, withIndices: boolean): MeshUpdate {
    const { model } = mesh;
    const numbers = withIndices ? this.#triangleNumbers(model) : undefined;
    const first = mesh.sentVertexCount;
    const layers = model.vertex_count > first ? newLayers(model, first) : [];
    mesh.sentVertexCount = model.vertex_count;
    return {
      mesh: index,
      first,
      layers,
      indices: withIndices ? model.indices() : undefined,
      groupCounts: model.group_counts(),
      numbers,
      bounds: model.bounds(),
      vertexCount: model.vertex_count,
      fullVertexCount: model.full_vertex_count,
      triangleCount: model.triangle_count,
      fullTriangleCount: model.full_triangle_count,
      splitCount: model.shown_split_count,
      stepCount: model.step_count,
      error: model.shown_error,
      complete: model.is_complete,
    };
  }

  #triangleNumbers(model: Model): Uint32Array | undefined {
    if (this.#coloring === 'strips') return model.color_strips();
    if (this.#coloring === 'fans') return model.color_fans();
    if (this.#coloring === 'surface') return undefined;
    const count = model.group_counts().reduce((sum, n) => sum + n, 0);
    return Uint32Array.from({ length: count }, (_, triangle) => triangle);
  }

  #postIndices(id: number, index: number, request: LevelRequest): void {
    const mesh = this.#meshes[index];
    const lists: Uint32Array[] = [];
    if (mesh?.model.is_ready) {
      showRequest(mesh, request);
      const indices = mesh.model.indices();
      let start = 0;
      for (const count of mesh.model.group_counts()) lists.push(indices.slice(start, (start += 3 * count)));
      // The level that the page shows is no longer that of the model.
      mesh.sentLevel = '';
    }
    this.#report({ type: 'indices', id, lists });
  }

  #state(): SceneState {
    return {
      phase: this.#phase,
      complete: this.#isComplete,
      streamBytes: this.#scene?.stream_bytes ?? 0,
      decodeMs: this.#decodeMs,
      buildMs: this.#buildMs,
      updateMs: this.#updateMs,
    };
  }
}

function newMesh(model: Model, ViewOf = View): EngineMesh {
  return { model, View: ViewOf, sentVertexCount: 0, sentLevel: '', isSettled: true };
}

/** Shows a requested level; returns whether repeating the request would give the same result. */
function showRequest({ model, View: ViewOf }: EngineMesh, { by, value, limit, camera }: LevelRequest): boolean {
  if (by === 'view' && camera) {
    const view = new ViewOf(Float64Array.from(camera), value, limit);
    try {
      return model.show_view(view);
    } catch (thrown) {
      // A camera that sees nothing changes nothing.
      if (!isFailure(thrown)) throw thrown;
      thrown.free();
      return true;
    } finally {
      view.free();
    }
  }
  if (by === 'triangles') model.show_triangles(value);
  else if (by === 'error') model.show_error(value);
  else model.show_detail(by === 'detail' ? value : 1);
  const shown = model.group_counts().reduce((sum, count) => sum + count, 0);
  if (limit > 0 && shown > limit) model.show_triangles(limit);
  return true;
}

function newLayers(model: Model, first: number): NewLayer[] {
  const vertices = model.vertices(first);
  try {
    const layers: NewLayer[] = [{ name: 'POSITION', itemSize: 3, normalized: false, values: vertices.take_positions() }];
    for (let layer = vertices.take_layer(); layer; layer = vertices.take_layer()) {
      const array = ARRAYS[layer.component_type as keyof typeof ARRAYS];
      const bytes = layer.bytes();
      const own = new array(bytes.buffer as ArrayBuffer, bytes.byteOffset, bytes.byteLength / array.BYTES_PER_ELEMENT);
      // Graphics cards have no doubles.
      const values = own instanceof Float64Array ? Float32Array.from(own) : own;
      layers.push({ name: layer.name, itemSize: layer.component_count, normalized: layer.is_normalized, values });
      layer.free();
    }
    return layers;
  } finally {
    vertices.free();
  }
}

function documentOf(document: WasmDocument): SceneDocument {
  const images: SceneImage[] = [];
  for (let image = document.take_image(); image; image = document.take_image()) images.push(imageOf(images.length, image));
  const { has_animations: hasAnimations } = document;
  const result = { json: document.take_json(), buffer: document.take_buffer(), hasAnimations, images };
  document.free();
  return result;
}

function imageOf(index: number, image: WasmImage): SceneImage {
  const { mime_type: mimeType, uri, is_full: isFull } = image;
  const result = { index, bytes: image.take_bytes(), mimeType, uri, isFull };
  image.free();
  return result;
}
