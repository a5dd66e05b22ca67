/** A three.js mesh that can switch to any level of detail of its model. */

import {
  DoubleSide, Mesh, MeshStandardMaterial, Vector2,
  type BufferGeometry, type Camera, type Material, type Scene, type WebGLRenderer,
} from 'three';
import { GrowingGeometry } from './buffers.ts';
import { StriataError } from './error.ts';
import { coloredTriangles } from './colored-triangles.ts';
import type { LevelRequest, Order, State, Update } from './protocol.ts';
import type { Coloring, Kind, StriataEvents, StriataMeshLike, Timings, VertexStep } from './types.ts';
import { viewOf } from './view.ts';

/** The interface through which a mesh controls its loader. */
export interface LoaderHandle {
  /** Sends an order to the engine. */
  send(order: Order): void;
  bytes(): { received: number; total: number | null };
  dispose(): void;
}

const size = new Vector2();

/** Largest triangle count the engine accepts, a 32-bit integer. */
const MAX_TRIANGLE_COUNT = 0xffffffff;

/** A mesh with continuous level of detail, created by a `StriataLoader`. */
export class StriataMesh extends Mesh<BufferGeometry, Material | Material[], StriataEvents> implements StriataMeshLike {
  readonly isStriataMesh = true;
  readonly finished: Promise<void>;
  state: State;
  /** Whether the backs of the triangles cannot be seen; known after everything has loaded. */
  isSolid = false;
  readonly #loader: LoaderHandle;
  readonly #surface: GrowingGeometry;
  /** The default material, which this mesh disposes of itself; undefined if the caller passed one. */
  readonly #ownMaterial: MeshStandardMaterial | undefined;
  #surfaceMaterial: Material | Material[];
  #coloringMaterial: MeshStandardMaterial | undefined;
  #last: Update;
  #detail: number | null = 1;
  #triangleBudget: number | null = null;
  #maxError: number | null = null;
  #pixelError: number | null = null;
  #isFrozen = false;
  #coloring: Coloring = 'surface';
  #isWireframe = false;
  /** Number of the last request, whether its answer is pending, and whether another request must follow. */
  #ticket = 0;
  #isWaiting = false;
  #hasChanged = false;
  #sent: LevelRequest = { by: 'detail', value: 1, limit: 0 };
  /** Request for the last camera; view requests are created when the mesh is drawn. */
  #viewRequest: LevelRequest | undefined;
  #isSettled = true;
  #isDisposed = false;
  /** Requests for indices of other levels; each is answered in turn, and then the shown level is requested again. */
  readonly #pendingSteps: ((step: VertexStep | null) => void)[] = [];
  readonly #pendingIndices: { request: LevelRequest; resolve: (lists: Uint32Array[]) => void }[] = [];
  #awaitedIndices: ((lists: Uint32Array[]) => void) | undefined;
  #resolve!: () => void;
  #reject!: (error: StriataError) => void;

  constructor(first: Update, material: Material | Material[] | undefined, loader: LoaderHandle) {
    const geometry = new GrowingGeometry();
    const own = material ? undefined : defaultMaterial(first);
    super(geometry, material ?? own!);
    this.#surface = geometry;
    this.#surfaceMaterial = this.material;
    this.#ownMaterial = own;
    this.#loader = loader;
    this.state = first.state;
    this.#last = first;
    this.finished = new Promise((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    // Without a handler, the rejection would be unhandled; the `error` event reports it, too.
    this.finished.catch(() => undefined);
    this.onBeforeRender = (renderer, _scene, camera) => this.#beforeRender(renderer as WebGLRenderer, _scene, camera);
    this.update(first);
  }

  get detail(): number {
    return this.#detail ?? (this.stepCount > 0 ? this.splitCount / this.stepCount : 1);
  }

  set detail(detail: number) {
    this.#detail = Math.min(1, Math.max(0, number(detail, 'detail')));
    [this.#triangleBudget, this.#maxError, this.#pixelError] = [null, null, null];
    this.#requestUpdate();
  }

  get triangleBudget(): number | null {
    return this.#triangleBudget;
  }

  set triangleBudget(budget: number | null) {
    this.#triangleBudget = budget === null ? null : Math.max(1, Math.floor(number(budget, 'triangleBudget')));
    this.#updateDetailMode();
    this.#requestUpdate();
  }

  get error(): number {
    return this.state.shownError;
  }

  get maxError(): number | null {
    return this.#maxError;
  }

  set maxError(error: number | null) {
    this.#maxError = error === null ? null : Math.max(0, number(error, 'maxError'));
    if (error !== null) this.#pixelError = null;
    this.#updateDetailMode();
    this.#requestUpdate();
  }

  get pixelError(): number | null {
    return this.#pixelError;
  }

  set pixelError(pixels: number | null) {
    this.#pixelError = pixels === null ? null : Math.max(0, number(pixels, 'pixelError'));
    if (pixels !== null) this.#maxError = null;
    this.#updateDetailMode();
    this.#requestUpdate();
    // The application may draw only when something changes, and the request is sent when the mesh is drawn.
    this.dispatchEvent({ type: 'change' });
  }

  get frozen(): boolean {
    return this.#isFrozen;
  }

  set frozen(frozen: boolean) {
    this.#isFrozen = frozen;
    this.dispatchEvent({ type: 'change' });
  }

  get coloring(): Coloring {
    return this.#coloring;
  }

  set coloring(coloring: Coloring) {
    if (coloring === this.#coloring) return;
    if (this.#coloring === 'surface') this.#surfaceMaterial = this.material;
    this.#coloring = coloring;
    this.#hasChanged = true;
    this.#send();
  }

  get wireframe(): boolean {
    return this.#isWireframe;
  }

  set wireframe(wireframe: boolean) {
    this.#isWireframe = wireframe;
    for (const material of [this.material].flat()) setWireframe(material, wireframe);
    this.dispatchEvent({ type: 'change' });
  }

  get triangleCount(): number {
    return this.#last.indices.length / 3;
  }

  get fullTriangleCount(): number {
    return this.state.fullTriangleCount;
  }

  get vertexCount(): number {
    return this.state.vertexCount;
  }

  get splitCount(): number {
    return this.state.shownSplitCount;
  }

  get stepCount(): number {
    return this.state.stepCount;
  }

  get isZUp(): boolean {
    return this.state.isZUp;
  }

  get complete(): boolean {
    return this.state.complete;
  }

  get bytesReceived(): number {
    return this.#loader.bytes().received;
  }

  get bytesTotal(): number | null {
    return this.#loader.bytes().total ?? (this.state.streamBytes || null);
  }

  get diagonal(): number {
    return this.state.diagonal;
  }

  get kind(): Kind {
    return this.state.kind;
  }

  get timings(): Readonly<Timings> {
    const { decodeMs, buildMs, updateMs } = this.state;
    return { decodeMs, buildMs, updateMs };
  }

  /** Returns a plain `THREE.Mesh` that shares geometry and material; only the original can change the level. */
  override clone(recursive?: boolean): this {
    return new Mesh(this.geometry, this.material).copy(this, recursive) as unknown as this;
  }

  override dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    this.#loader.dispose();
    this.#surface.dispose();
    if (this.geometry !== this.#surface) this.geometry.dispose();
    this.#ownMaterial?.dispose();
    this.#coloringMaterial?.dispose();
    this.#reject(new StriataError('aborted', 'the mesh has been disposed of'));
  }

  /** Shows another level; called by the loader. */
  update(update: Update): void {
    if (this.#isDisposed) return;
    if (update.ticket === this.#ticket && this.#awaitedIndices) return this.#answerIndices(update);
    this.state = update.state;
    this.#last = update;
    this.#surface.apply(update);
    this.#updateColoring(update);
    if (update.ticket === this.#ticket) {
      this.#isWaiting = false;
      this.#isSettled = update.settled;
    }
    if (this.#hasChanged) this.#send();
    this.dispatchEvent({ type: 'change' });
  }

  /** Allows the next request, before this one has been met; called by the loader. */
  accept(ticket: number): void {
    if (ticket !== this.#ticket) return;
    [this.#isWaiting, this.#isSettled] = [false, true];
    if (this.#hasChanged) this.#send();
  }

  /** Returns the indices of a level, one list for each group; the shown level stays. */
  indicesOf(request: LevelRequest): Promise<Uint32Array[]> {
    if (this.kind === 'paged') return Promise.reject(new StriataError('unsupported', 'the levels of a paged file do not share their vertices'));
    return new Promise((resolve) => {
      this.#pendingIndices.push({ request, resolve });
      this.#requestUpdate();
    });
  }

  /** The step that adds a vertex; null for vertices of the base mesh, and for those of paged files, which have no numbers. */
  stepOf(vertex: number): Promise<VertexStep | null> {
    if (this.kind === 'paged') return Promise.resolve(null);
    return new Promise((resolve) => {
      this.#pendingSteps.push(resolve);
      this.#loader.send({ type: 'step', vertex });
    });
  }

  /** Answers the oldest question for a step; called by the loader. */
  answerStep(step: VertexStep | null): void {
    this.#pendingSteps.shift()?.(step);
  }

  /** Notes that the backs of the triangles cannot be seen. */
  becomeSolid(): void {
    this.isSolid = true;
    this.dispatchEvent({ type: 'change' });
  }

  /** Ends loading; called by the loader. */
  end(error?: StriataError): void {
    if (!error) {
      this.#resolve();
      return;
    }
    this.#reject(error);
    this.dispatchEvent({ type: 'error', error });
  }

  /** Shows the surface, or triangles colored by strip, fan or number. */
  #updateColoring({ numbers, indices }: Update): void {
    const old = this.geometry;
    if (numbers && this.#coloring !== 'surface') {
      this.#coloringMaterial ??= new MeshStandardMaterial({ vertexColors: true, flatShading: true, side: DoubleSide, roughness: 0.9 });
      setWireframe(this.#coloringMaterial, this.#isWireframe);
      this.geometry = coloredTriangles(this.#surface.getAttribute('position')?.array ?? [], indices, numbers);
      this.geometry.boundingSphere = this.#surface.boundingSphere;
      this.geometry.boundingBox = this.#surface.boundingBox;
      this.material = this.#coloringMaterial;
    } else if (this.geometry !== this.#surface && this.#coloring === 'surface') {
      this.geometry = this.#surface;
      this.material = this.#surfaceMaterial;
      for (const material of [this.material].flat()) setWireframe(material, this.#isWireframe);
    }
    if (old !== this.geometry && old !== this.#surface) old.dispose();
  }

  #updateDetailMode(): void {
    const modes = [this.#triangleBudget, this.#maxError, this.#pixelError];
    this.#detail = modes.every((mode) => mode === null) ? 1 : null;
  }

  /** Requests an update now, or as soon as the pending request is answered. */
  #requestUpdate(): void {
    this.#hasChanged = true;
    this.#send();
  }

  #send(): void {
    if (this.#isWaiting || this.#isDisposed) return;
    this.#isWaiting = true;
    const next = this.#pendingIndices.shift();
    if (next) {
      this.#awaitedIndices = next.resolve;
      this.#hasChanged = true;
      this.#loader.send({ type: 'show', request: next.request, coloring: 'surface', ticket: ++this.#ticket });
      return;
    }
    this.#hasChanged = false;
    this.#sent = this.#levelRequest();
    this.#loader.send({ type: 'show', request: this.#sent, coloring: this.#coloring, ticket: ++this.#ticket });
  }

  #levelRequest(): LevelRequest {
    const limit = this.#limit();
    // Before the first frame the camera is unknown.
    if (this.#pixelError !== null) return this.#viewRequest ?? { by: 'detail', value: limit > 0 ? 1 : 0, limit };
    if (this.#maxError !== null) return { by: 'error', value: this.#maxError, limit };
    if (this.#triangleBudget !== null) return { by: 'triangles', value: limit, limit };
    return { by: 'detail', value: this.#detail ?? 1, limit: 0 };
  }

  /** Passes the indices of a level on that is not shown. */
  #answerIndices({ indices, groupCounts }: Update): void {
    let start = 0;
    this.#awaitedIndices?.([...groupCounts].map((count) => indices.slice(start, (start += 3 * count))));
    this.#awaitedIndices = undefined;
    this.#isWaiting = false;
    this.#send();
  }

  /** Triangle budget for the engine; 0 means none. */
  #limit(): number {
    return Math.min(this.#triangleBudget ?? 0, MAX_TRIANGLE_COUNT);
  }

  /** Requests the level for the camera that is about to draw the mesh. */
  #beforeRender(renderer: WebGLRenderer, _scene: Scene, camera: Camera): void {
    if (this.#pixelError === null || this.#isFrozen) return;
    const target = renderer.getRenderTarget();
    if (target) size.set(target.width, target.height);
    else renderer.getDrawingBufferSize(size);
    const view = viewOf(this, camera, size.x, size.y);
    if (!view) return;
    const limit = this.#limit();
    this.#viewRequest =
      view.kind === 'perspective'
        ? { by: 'view', value: this.#pixelError / view.stretch, limit, camera: view.numbers }
        : { by: 'error', value: this.#pixelError * view.unitsPerPixel, limit };
    if (this.#isSettled && isSame(this.#viewRequest, this.#sent)) return;
    this.#send();
  }
}

function number(value: number, name: string): number {
  if (Number.isNaN(Number(value))) throw new TypeError(`${name} must be a number, not ${String(value)}`);
  return Number(value);
}

function isSame(a: LevelRequest, b: LevelRequest): boolean {
  const isSameCamera = a.camera?.length === b.camera?.length && (a.camera ?? []).every((x, i) => x === b.camera?.[i]);
  return a.by === b.by && a.value === b.value && a.limit === b.limit && isSameCamera;
}

function setWireframe(material: Material, wireframe: boolean): void {
  if ('wireframe' in material) material.wireframe = wireframe;
}

function defaultMaterial({ vertices }: Update): MeshStandardMaterial {
  return new MeshStandardMaterial({ vertexColors: vertices?.colors !== undefined, side: DoubleSide, roughness: 0.8, metalness: 0 });
}
