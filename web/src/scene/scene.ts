/** A scene whose meshes can switch to any level of detail while it streams in. */

import { Box3, Group, Matrix4, Vector3, type AnimationClip, type Camera, type Material, type Mesh, type Object3D } from 'three';
import { StriataError } from '../error.ts';
import type { LevelRequest } from '../protocol.ts';
import type { Coloring, Kind, Phase, StriataEvents, StriataLod, StriataSceneLike, Timings, VertexStep } from '../types.ts';
import { ColoredMeshes } from './colored-meshes.ts';
import { SceneLod, type LodOwner } from './lod.ts';
import type { MeshUpdate, SceneOrder, SceneReport, SceneState, SceneTarget } from './protocol.ts';

/** The interface through which a scene controls its loader. */
export interface SceneHandle {
  send(order: SceneOrder): void;
  bytes(): { received: number; total: number | null };
  dispose(): void;
}

/** The parts that three.js' loader made. */
export interface SceneContents {
  scene: Object3D | undefined;
  scenes: Group[];
  cameras: Camera[];
  animations: AnimationClip[];
}

/** How the levels of all meshes are chosen. */
interface SceneMode {
  detail: number | null;
  triangleBudget: number | null;
  maxError: number | null;
  pixelError: number | null;
}

const COARSEST = Number.MAX_VALUE;

/** A scene with levels of detail, created by a `StriataLoader`. The default scene of the glTF document is its child. */
export class StriataScene extends Group<StriataEvents> implements StriataSceneLike, LodOwner {
  readonly isStriataScene = true;
  override readonly animations: AnimationClip[] = [];
  cameras: Camera[] = [];
  scenes: Group[] = [];
  lods: readonly StriataLod[];
  finished: Promise<void>;
  /** Resolves when the animations are complete, or loading has ended. */
  readonly animated: Promise<void>;
  state: SceneState = { phase: 'download', complete: false, streamBytes: 0, decodeMs: 0, buildMs: 0, updateMs: 0 };
  readonly kind: Kind;
  readonly #handle: SceneHandle;
  readonly #own: readonly SceneLod[];
  readonly #byIndex = new Map<number, SceneLod>();
  readonly #colored: ColoredMeshes;
  #mode: SceneMode = { detail: 1, triangleBudget: null, maxError: null, pixelError: null };
  #isFrozen = false;
  #coloring: Coloring = 'surface';
  #isWireframe = false;
  #ticket = 0;
  #isWaiting = false;
  #hasChanged = false;
  #isSettled = true;
  #isFrameScheduled = false;
  #isDisposed = false;
  #isSolid = false;
  #sentView = '';
  readonly #pendingIndices = new Map<number, (lists: Uint32Array[]) => void>();
  readonly #pendingSteps = new Map<number, (step: VertexStep | null) => void>();
  #resolve!: () => void;
  #resolveAnimated!: () => void;
  #reject!: (error: StriataError) => void;

  constructor(primitiveCounts: readonly (number | undefined)[], kind: Kind, handle: SceneHandle) {
    super();
    this.kind = kind;
    this.#handle = handle;
    primitiveCounts.forEach((count, index) => {
      if (count !== undefined && count > 0) this.#byIndex.set(index, new SceneLod(index, count, this));
    });
    this.#own = [...this.#byIndex.values()];
    this.lods = this.#own;
    this.#colored = new ColoredMeshes(this.#own);
    this.finished = new Promise((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    this.animated = new Promise((resolve) => {
      this.#resolveAnimated = resolve;
    });
    // Without a handler, the rejection would be unhandled; the `error` event reports it, too.
    this.finished.catch(() => undefined);
  }

  /**
   * Whether the model is one mesh whose triangles enclose bodies and face outward, so that `FrontSide` suffices for a material of your
   * own; known after everything has loaded.
   */
  get isSolid(): boolean {
    return this.#isSolid;
  }

  /** Whether the z axis points up: the model is a mesh with a georeference, or as flat along z as a terrain. Other scenes are y up, as three.js has it. */
  get isZUp(): boolean {
    return false;
  }

  get detail(): number {
    if (this.#mode.detail !== null) return this.#mode.detail;
    const [shown, all] = this.#sum((last) => last.splitCount, (last) => last.stepCount);
    return all > 0 ? shown / all : 1;
  }

  set detail(detail: number) {
    const value = Math.min(1, Math.max(0, number(detail, 'detail')));
    this.#mode = { detail: value, triangleBudget: null, maxError: null, pixelError: null };
    this.changed();
  }

  get triangleBudget(): number | null {
    return this.#mode.triangleBudget;
  }

  set triangleBudget(budget: number | null) {
    this.#setMode({ triangleBudget: budget === null ? null : Math.max(1, Math.floor(number(budget, 'triangleBudget'))) });
  }

  get maxError(): number | null {
    return this.#mode.maxError;
  }

  set maxError(error: number | null) {
    const maxError = error === null ? null : Math.max(0, number(error, 'maxError'));
    this.#setMode(maxError === null ? { maxError } : { maxError, pixelError: null });
  }

  get pixelError(): number | null {
    return this.#mode.pixelError;
  }

  set pixelError(pixels: number | null) {
    const pixelError = pixels === null ? null : Math.max(0, number(pixels, 'pixelError'));
    this.#setMode(pixelError === null ? { pixelError } : { pixelError, maxError: null });
    // The application may draw only when something changes, and sizes on the screen are known when the scene is drawn.
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
    this.#coloring = coloring;
    this.changed();
  }

  get wireframe(): boolean {
    return this.#isWireframe;
  }

  set wireframe(wireframe: boolean) {
    this.#isWireframe = wireframe;
    this.#colored.wireframe = wireframe;
    for (const material of this.#materials()) if ('wireframe' in material) material.wireframe = wireframe;
    this.dispatchEvent({ type: 'change' });
  }

  /** Number of triangles shown; those of a mesh count once for each instance. */
  get triangleCount(): number {
    return this.#own.reduce((sum, lod) => sum + lod.instanceCount * lod.triangleCount, 0);
  }

  get fullTriangleCount(): number {
    return this.#own.reduce((sum, lod) => sum + lod.instanceCount * lod.fullTriangleCount, 0);
  }

  get vertexCount(): number {
    return this.#own.reduce((sum, { last }) => sum + (last?.vertexCount ?? 0), 0);
  }

  get splitCount(): number {
    return this.#sum((last) => last.splitCount, () => 0)[0];
  }

  get stepCount(): number {
    return this.#sum((last) => last.stepCount, () => 0)[0];
  }

  /** Largest error of the shown levels, in units of the scene. */
  get error(): number {
    const largest = this.#own.reduce((most, lod) => Math.max(most, lod.shownError * lod.worldScale), 0);
    return largest / (Math.max(...this.getWorldScale(new Vector3())) || 1);
  }

  get complete(): boolean {
    return this.state.complete;
  }

  get phase(): Phase {
    return this.state.phase;
  }

  get bytesReceived(): number {
    return this.#handle.bytes().received;
  }

  get bytesTotal(): number | null {
    return this.#handle.bytes().total ?? (this.state.streamBytes || null);
  }

  /** Diagonal of the bounding box of all meshes in their current pose, in units of the scene. */
  get diagonal(): number {
    const [box, part, toScene, matrix] = [new Box3(), new Box3(), this.matrixWorld.clone().invert(), new Matrix4()];
    this.traverse((object) => {
      const own = boundsOf(object as Mesh);
      if (own && !own.isEmpty()) box.union(part.copy(own).applyMatrix4(matrix.multiplyMatrices(toScene, object.matrixWorld)));
    });
    return box.isEmpty() ? 0 : box.min.distanceTo(box.max);
  }

  get timings(): Readonly<Timings> {
    const { decodeMs, buildMs, updateMs } = this.state;
    return { decodeMs, buildMs, updateMs };
  }

  /** The lod of a glTF mesh; called by the loader. */
  lodOf(mesh: number): SceneLod | undefined {
    return this.#byIndex.get(mesh);
  }

  /** Takes what three.js' loader made; called by the loader. */
  fill({ scene, scenes, cameras, animations }: SceneContents, drawn: Iterable<[Mesh, number]>): void {
    this.scenes = scenes;
    this.cameras = cameras;
    this.animations.push(...animations);
    for (const [mesh, index] of drawn) this.#byIndex.get(index)?.attach(mesh);
    if (scene) this.add(scene);
    this.updateMatrixWorld(true);
  }

  /** Shows what has arrived; called by the loader. */
  show(updates: readonly MeshUpdate[], state: SceneState, ticket: number, settled: boolean): void {
    if (this.#isDisposed) return;
    this.state = state;
    for (const update of updates) {
      const lod = this.#byIndex.get(update.mesh);
      if (!lod) continue;
      lod.last = update;
      lod.geometry.apply(update);
      this.#colored.show(lod, this.#coloring === 'surface' ? undefined : update);
    }
    if (ticket === this.#ticket) {
      this.#isWaiting = false;
      this.#isSettled = settled;
    }
    if (this.#hasChanged) this.#send();
    if (updates.length > 0) this.dispatchEvent({ type: 'change' });
  }

  /** Answers a request for indices or a step; called by the loader. */
  answer(report: Extract<SceneReport, { type: 'indices' | 'step' }>): void {
    if (report.type === 'indices') this.#pendingIndices.get(report.id)?.(report.lists);
    else this.#pendingSteps.get(report.id)?.(report.step);
    this.#pendingIndices.delete(report.id);
    this.#pendingSteps.delete(report.id);
  }

  /** Takes the clips; called by the loader when no more will follow. */
  animate(clips: readonly AnimationClip[]): void {
    this.animations.push(...clips);
    this.#resolveAnimated();
    if (clips.length > 0) this.dispatchEvent({ type: 'change' });
  }

  /** Notes that the backs of the triangles cannot be seen. */
  becomeSolid(): void {
    this.#isSolid = true;
    this.dispatchEvent({ type: 'change' });
  }

  /** Ends loading; called by the loader. */
  end(error?: StriataError): void {
    this.#resolveAnimated();
    if (!error) return this.#resolve();
    this.#reject(error);
    this.dispatchEvent({ type: 'error', error });
  }

  indices(mesh: number, request: LevelRequest): Promise<Uint32Array[]> {
    return new Promise((resolve) => {
      const id = ++this.#lastId;
      this.#pendingIndices.set(id, resolve);
      this.#handle.send({ type: 'indices', mesh, request, id });
      // The request may have changed what the engine shows.
      this.changed();
    });
  }

  stepOf(mesh: number, vertex: number): Promise<VertexStep | null> {
    return new Promise((resolve) => {
      const id = ++this.#lastId;
      this.#pendingSteps.set(id, resolve);
      this.#handle.send({ type: 'step', mesh, vertex, id });
    });
  }

  #lastId = 0;

  changed(): void {
    this.#hasChanged = true;
    this.#send();
  }

  /** Called when a mesh is about to be drawn: levels are chosen after the whole frame has been drawn. */
  seen(): void {
    if (this.#isFrameScheduled || this.#isFrozen || this.#isDisposed) return;
    this.#isFrameScheduled = true;
    queueMicrotask(() => this.#endFrame());
  }

  override dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    this.#handle.dispose();
    for (const lod of this.#own) lod.geometry.dispose();
    this.#colored.dispose();
    for (const material of this.#materials()) {
      for (const value of Object.values(material)) if (isTexture(value)) value.dispose();
      material.dispose();
    }
    this.traverse((object) => {
      const { geometry } = object as Mesh;
      if (geometry) geometry.dispose();
    });
    this.#reject(new StriataError('aborted', 'the scene has been disposed of'));
  }

  #setMode(change: Partial<SceneMode>): void {
    const mode = { ...this.#mode, ...change };
    const isUniform = mode.triangleBudget === null && mode.maxError === null && mode.pixelError === null;
    this.#mode = { ...mode, detail: isUniform ? 1 : null };
    this.changed();
  }

  #endFrame(): void {
    this.#isFrameScheduled = false;
    if (this.#isDisposed) return;
    let hasMoved = false;
    for (const lod of this.#own) hasMoved = lod.endFrame() || hasMoved;
    const usesPixels = this.#mode.pixelError !== null || this.#own.some((lod) => lod.pixelError !== null);
    if (!usesPixels) return;
    const view = this.#viewKey();
    if (!hasMoved && view === this.#sentView && this.#isSettled) return;
    this.changed();
  }

  /** Identifies the camera, if parts of a mesh have levels of their own. */
  #viewKey(): string {
    const [only] = this.#own;
    if (this.#own.length !== 1 || !only?.isSingle || this.#mode.pixelError === null) return '';
    return String(only.view?.camera ?? '');
  }

  #send(): void {
    if (this.#isWaiting || this.#isDisposed) return;
    this.#hasChanged = false;
    this.#isWaiting = true;
    this.#sentView = this.#viewKey();
    this.#handle.send({ type: 'target', target: this.#target(), coloring: this.#coloring, ticket: ++this.#ticket });
  }

  #target(): SceneTarget {
    const { detail, triangleBudget, maxError, pixelError } = this.#mode;
    const limit = Math.min(triangleBudget ?? 0, 0xffffffff);
    const usesPixels = pixelError !== null;
    const meshes = this.#own.map((lod) => lod.share(usesPixels, pixelError ?? 0));
    const [only] = this.#own;
    // A single rigid mesh is refined where the camera looks.
    if (usesPixels && this.#own.length === 1 && only?.isSingle && only.view && meshes[0] && !meshes[0].request) {
      const { value: stretch } = only.view;
      meshes[0].request = { ...only.view, value: pixelError / (stretch || 1), limit };
    }
    if (detail !== null) return { meshes, tolerance: 0, detail, limit: 0 };
    const tolerance = pixelError ?? maxError ?? 0;
    // Before the first frame nothing is known about sizes on the screen.
    const isUnseen = usesPixels && meshes.every(({ scale, request }) => scale === 0 && !request);
    return { meshes, tolerance: isUnseen ? COARSEST : tolerance, limit };
  }

  #sum(shown: (last: MeshUpdate) => number, all: (last: MeshUpdate) => number): [number, number] {
    let sums: [number, number] = [0, 0];
    for (const { last } of this.#own) if (last) sums = [sums[0] + shown(last), sums[1] + all(last)];
    return sums;
  }

  #materials(): Set<Material> {
    const found = new Set<Material>();
    for (const scene of this.scenes) scene.traverse((object) => [(object as Mesh).material ?? []].flat().forEach((material) => found.add(material)));
    return found;
  }
}

/** Bounds of a mesh in its own space; those of skinned and instanced meshes are their own instead of their geometry's. */
function boundsOf(mesh: Mesh & { boundingBox?: Box3 | null; computeBoundingBox?: () => void }): Box3 | null {
  if (!mesh.isMesh) return null;
  if (mesh.boundingBox === undefined) {
    if (!mesh.geometry.boundingBox) mesh.geometry.computeBoundingBox();
    return mesh.geometry.boundingBox;
  }
  if (mesh.boundingBox === null) mesh.computeBoundingBox?.();
  return mesh.boundingBox;
}

function isTexture(value: unknown): value is { dispose(): void } {
  return typeof value === 'object' && value !== null && 'isTexture' in value;
}

function number(value: number, name: string): number {
  if (Number.isNaN(Number(value))) throw new TypeError(`${name} must be a number, not ${String(value)}`);
  return Number(value);
}
