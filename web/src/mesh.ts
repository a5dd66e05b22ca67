/** A three.js mesh that goes to any level of its model. */

import {
  DoubleSide, Mesh, MeshStandardMaterial, Vector2,
  type BufferGeometry, type Camera, type Material, type Scene, type WebGLRenderer,
} from 'three';
import { GrowingGeometry } from './buffers.ts';
import { StriataError } from './error.ts';
import { painted } from './painted.ts';
import type { Order, State, Update, Wish } from './protocol.ts';
import type { Coloring, Kind, StriataEvents, StriataMeshLike, Timings } from './types.ts';
import { look } from './view.ts';

/** What a mesh needs of whoever loads it. */
export interface Mind {
  order(order: Order): void;
  bytes(): { received: number; total: number | null };
  dispose(): void;
}

const size = new Vector2();

/** Numbers of triangles as the engine takes them. */
const MOST_TRIANGLES = 0xffffffff;

/** Made by a `StriataLoader`. */
export class StriataMesh extends Mesh<BufferGeometry, Material | Material[], StriataEvents> implements StriataMeshLike {
  readonly isStriataMesh = true;
  readonly finished: Promise<void>;
  state: State;
  readonly #mind: Mind;
  readonly #surface: GrowingGeometry;
  /** Made here, and freed here. */
  readonly #ownMaterial: MeshStandardMaterial | undefined;
  #surfaceMaterial: Material | Material[];
  #paintMaterial: MeshStandardMaterial | undefined;
  #last: Update;
  #detail: number | null = 1;
  #triangleBudget: number | null = null;
  #maxError: number | null = null;
  #pixelError: number | null = null;
  #isFrozen = false;
  #coloring: Coloring = 'surface';
  #isWireframe = false;
  /** The request that has not been answered yet, and whether another has to follow it. */
  #ticket = 0;
  #isWaiting = false;
  #hasChanged = false;
  #sent: Wish = { by: 'detail', value: 1, limit: 0 };
  /** The last camera, as a wish; for views a wish is made when the mesh is drawn. */
  #viewWish: Wish | undefined;
  #isSettled = true;
  #isDisposed = false;
  #resolve!: () => void;
  #reject!: (error: StriataError) => void;

  constructor(first: Update, material: Material | Material[] | undefined, mind: Mind) {
    const geometry = new GrowingGeometry();
    const own = material ? undefined : defaultMaterial(first);
    super(geometry, material ?? own!);
    this.#surface = geometry;
    this.#surfaceMaterial = this.material;
    this.#ownMaterial = own;
    this.#mind = mind;
    this.state = first.state;
    this.#last = first;
    this.finished = new Promise((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    // Who does not wait for it hears of it by the event.
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
    this.#ask();
  }

  get triangleBudget(): number | null {
    return this.#triangleBudget;
  }

  set triangleBudget(budget: number | null) {
    this.#triangleBudget = budget === null ? null : Math.max(1, Math.floor(number(budget, 'triangleBudget')));
    this.#leaveDetail();
    this.#ask();
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
    this.#leaveDetail();
    this.#ask();
  }

  get pixelError(): number | null {
    return this.#pixelError;
  }

  set pixelError(pixels: number | null) {
    this.#pixelError = pixels === null ? null : Math.max(0, number(pixels, 'pixelError'));
    if (pixels !== null) this.#maxError = null;
    this.#leaveDetail();
    this.#ask();
    // Nobody may be drawing until something changes.
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

  /** @deprecated Use `coloring`. */
  get colouring(): Coloring {
    return this.coloring;
  }

  set colouring(coloring: Coloring) {
    this.coloring = coloring;
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

  get complete(): boolean {
    return this.state.complete;
  }

  get bytesReceived(): number {
    return this.#mind.bytes().received;
  }

  get bytesTotal(): number | null {
    return this.#mind.bytes().total ?? (this.state.streamBytes || null);
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

  /** A plain mesh that shows what this one shows: geometry and material are shared, levels are chosen here alone. */
  override clone(recursive?: boolean): this {
    return new Mesh(this.geometry, this.material).copy(this, recursive) as unknown as this;
  }

  override dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    this.#mind.dispose();
    this.#surface.dispose();
    if (this.geometry !== this.#surface) this.geometry.dispose();
    this.#ownMaterial?.dispose();
    this.#paintMaterial?.dispose();
    this.#reject(new StriataError('aborted', 'the mesh was disposed of'));
  }

  /** Takes another level; called by the loader. */
  update(update: Update): void {
    if (this.#isDisposed) return;
    this.state = update.state;
    this.#last = update;
    this.#surface.take(update);
    this.#paint(update);
    if (update.ticket === this.#ticket) {
      this.#isWaiting = false;
      this.#isSettled = update.settled;
    }
    if (this.#hasChanged) this.#send();
    this.dispatchEvent({ type: 'change' });
  }

  /** Nothing more comes; called by the loader. */
  end(error?: StriataError): void {
    if (!error) {
      this.#resolve();
      return;
    }
    this.#reject(error);
    this.dispatchEvent({ type: 'error', error });
  }

  /** Shows the surface, or triangles in the colors of what draws them. */
  #paint({ numbers, indices }: Update): void {
    const old = this.geometry;
    if (numbers && this.#coloring !== 'surface') {
      this.#paintMaterial ??= new MeshStandardMaterial({ vertexColors: true, flatShading: true, side: DoubleSide, roughness: 0.9 });
      setWireframe(this.#paintMaterial, this.#isWireframe);
      this.geometry = painted(this.#surface.getAttribute('position')?.array ?? [], indices, numbers);
      this.geometry.boundingSphere = this.#surface.boundingSphere;
      this.geometry.boundingBox = this.#surface.boundingBox;
      this.material = this.#paintMaterial;
    } else if (this.geometry !== this.#surface && this.#coloring === 'surface') {
      this.geometry = this.#surface;
      this.material = this.#surfaceMaterial;
      for (const material of [this.material].flat()) setWireframe(material, this.#isWireframe);
    }
    if (old !== this.geometry && old !== this.#surface) old.dispose();
  }

  #leaveDetail(): void {
    const modes = [this.#triangleBudget, this.#maxError, this.#pixelError];
    this.#detail = modes.every((mode) => mode === null) ? 1 : null;
  }

  /** Sends a wish, at once or when the last one is answered. */
  #ask(): void {
    this.#hasChanged = true;
    this.#send();
  }

  #send(): void {
    if (this.#isWaiting || this.#isDisposed) return;
    this.#hasChanged = false;
    this.#isWaiting = true;
    this.#sent = this.#wish();
    this.#mind.order({ type: 'show', wish: this.#sent, coloring: this.#coloring, ticket: ++this.#ticket });
  }

  #wish(): Wish {
    const limit = this.#limit();
    // Before the first frame nobody knows from where the mesh is seen.
    if (this.#pixelError !== null) return this.#viewWish ?? { by: 'detail', value: limit > 0 ? 1 : 0, limit };
    if (this.#maxError !== null) return { by: 'error', value: this.#maxError, limit };
    if (this.#triangleBudget !== null) return { by: 'triangles', value: limit, limit };
    return { by: 'detail', value: this.#detail ?? 1, limit: 0 };
  }

  /** The budget for the engine; 0 is none. */
  #limit(): number {
    return Math.min(this.#triangleBudget ?? 0, MOST_TRIANGLES);
  }

  /** Follows the camera that the mesh is about to be drawn for. */
  #beforeRender(renderer: WebGLRenderer, _scene: Scene, camera: Camera): void {
    if (this.#pixelError === null || this.#isFrozen) return;
    const target = renderer.getRenderTarget();
    if (target) size.set(target.width, target.height);
    else renderer.getDrawingBufferSize(size);
    const seen = look(this, camera, size.x, size.y);
    if (!seen) return;
    const limit = this.#limit();
    this.#viewWish =
      seen.kind === 'perspective'
        ? { by: 'view', value: this.#pixelError / seen.stretch, limit, camera: seen.numbers }
        : { by: 'error', value: this.#pixelError * seen.unitsPerPixel, limit };
    if (this.#isSettled && isSame(this.#viewWish, this.#sent)) return;
    this.#send();
  }
}

function number(value: number, name: string): number {
  if (Number.isNaN(Number(value))) throw new TypeError(`${name} has to be a number, not ${String(value)}`);
  return Number(value);
}

function isSame(a: Wish, b: Wish): boolean {
  const isSameCamera = a.camera?.length === b.camera?.length && (a.camera ?? []).every((x, i) => x === b.camera?.[i]);
  return a.by === b.by && a.value === b.value && a.limit === b.limit && isSameCamera;
}

function setWireframe(material: Material, wireframe: boolean): void {
  if ('wireframe' in material) material.wireframe = wireframe;
}

function defaultMaterial({ vertices }: Update): MeshStandardMaterial {
  return new MeshStandardMaterial({ vertexColors: vertices?.colors !== undefined, side: DoubleSide, roughness: 0.8, metalness: 0 });
}
