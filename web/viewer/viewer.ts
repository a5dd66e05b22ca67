/**
 * Shows one model at a time: opens it, follows it while it loads, and reports errors.
 *
 * If a model fails before anything could be drawn, the previous one stays. If it fails later, the part that has loaded is kept.
 * The previous download is canceled only when the new model replaces it, because the new one may fail.
 */

import type { Material } from 'three';
import { type Coloring, type ErrorCode, type Progress, StriataError, StriataLoader, type StriataMesh } from '../src/index.ts';
import { decoderUrl } from './decoder.ts';
import { DetailControls } from './detail-controls.ts';
import { describeProgress, Stats } from './stats.ts';
import { Framing } from './framing.ts';
import { FrozenView } from './frozen-view.ts';
import { dismissAll, notify } from './notices.ts';
import { formatCount } from './format.ts';
import { announce, element } from './dom.ts';
import { isCrossOrigin, type ModelSource } from './sources.ts';
import type { Stage } from './stage.ts';
import { themeColor } from './theme.ts';
import { Wireframe } from './wireframe.ts';

/** Color of models without colors of their own. */
const CLAY = 0xcfc4b4;

type SurfaceMaterial = Material & { flatShading?: boolean; color?: unknown };

/** Appearance of the model. */
export interface Look {
  coloring: Coloring;
  wireframe: boolean;
  flat: boolean;
  zUp: boolean;
}

export class Viewer {
  readonly stage: Stage;
  readonly framing: Framing;
  readonly detail: DetailControls;
  readonly look: Look = { coloring: 'surface', wireframe: false, flat: false, zUp: false };
  mesh: StriataMesh | null = null;
  /** Called when a model has appeared on the stage. */
  onShown: () => void = () => {};
  /** Called when no model could be opened and the stage is empty. */
  onEmpty: () => void = () => {};

  readonly #loader = StriataLoader({ wasm: decoderUrl() });
  readonly #stats: Stats;
  readonly #frozen: FrozenView;
  readonly #wireframe = new Wireframe();
  #source: ModelSource | null = null;
  #abort = new AbortController();
  #isOpening = false;
  /** Whether loading the rest of the model has failed. */
  #isIncomplete = false;
  /** Materials of the surface; other colorings have their own. */
  #materials: SurfaceMaterial[] = [];

  constructor(stage: Stage) {
    this.stage = stage;
    this.framing = new Framing(stage);
    this.#frozen = new FrozenView(stage, this.framing);
    this.#stats = new Stats(() => stage.framesPerSecond);
    this.detail = new DetailControls(() => this.#onDetailChanged());
  }

  /** Opens a model; `keepsCamera` if it is the same model again. */
  async open(source: ModelSource, keepsCamera = false): Promise<void> {
    const before = this.#abort;
    if (this.#isOpening) before.abort();
    const abort = new AbortController();
    this.#abort = abort;
    this.#isOpening = true;
    dismissAll();
    this.#stats.progress({ bytesReceived: 0, bytesTotal: null, triangleCount: 0, vertexCount: 0, complete: false, phase: 'download' });
    announce(`Opening ${source.name}`);
    try {
      const mesh = await this.#loader.load(source.data, {
        name: source.name,
        signal: abort.signal,
        onProgress: (progress) => this.#onProgress(abort, progress, source),
      });
      if (abort.signal.aborted) return mesh.dispose();
      this.#show(mesh, source, keepsCamera);
    } catch (error) {
      if (abort.signal.aborted) return;
      this.#isOpening = false;
      // The model that is shown may still be loading.
      this.#abort = before;
      this.#stats.progress(null);
      notify(noticeOf(error, `Cannot open ${source.name}`, source, () => void this.open(source, keepsCamera)));
      if (this.mesh) this.#update(this.mesh);
      else this.onEmpty();
    }
  }

  /** Applies the chosen appearance to the mesh. */
  applyLook(): void {
    const { mesh, look } = this;
    if (!mesh) return;
    mesh.coloring = look.coloring;
    this.#wireframe.show(mesh, look.wireframe);
    for (const material of this.#materials) {
      if ('flatShading' in material && material.flatShading !== look.flat) {
        material.flatShading = look.flat;
        material.needsUpdate = true;
      }
    }
    this.stage.invalidate();
  }

  /** Tilts the model if z is up. */
  setZUp(zUp: boolean): void {
    this.look.zUp = zUp;
    this.stage.pivot.rotation.x = zUp ? -Math.PI / 2 : 0;
    if (this.mesh) this.framing.onTilted(this.mesh, this.mesh.vertexCount);
    this.stage.invalidate();
  }

  /** Removes the model and cancels its download. */
  close(): void {
    this.#abort.abort();
    this.#isOpening = false;
    this.#stats.progress(null);
    this.#stats.hide();
    this.#remove();
    this.detail.setMesh(null);
    this.stage.invalidate();
  }

  /** Whether a model is shown or being opened. */
  get isBusy(): boolean {
    return this.mesh !== null || this.#isOpening;
  }

  /** URL of the model, if it has one. */
  get url(): string | null {
    return this.#source?.url ?? null;
  }

  get name(): string {
    return this.#source?.name ?? 'model';
  }

  #show(mesh: StriataMesh, source: ModelSource, keepsCamera: boolean): void {
    this.#isOpening = false;
    this.#isIncomplete = false;
    this.#remove();
    this.mesh = mesh;
    this.#source = source;
    this.#materials = materialsOf(mesh);
    for (const material of this.#materials) {
      if ('color' in material && !material.vertexColors) (material.color as { setHex(hex: number): void }).setHex(CLAY);
    }
    this.stage.pivot.add(mesh);
    this.framing.restart(keepsCamera);
    this.#listen(mesh, source);
    this.applyLook();
    this.detail.setMesh(mesh);
    this.#update(mesh);
    this.onShown();
  }

  #listen(mesh: StriataMesh, source: ModelSource): void {
    const update = (): void => this.#update(mesh);
    mesh.addEventListener('change', update);
    mesh.addEventListener('progress', update);
    mesh.finished.then(
      () => {
        if (this.mesh !== mesh) return;
        update();
        if (!this.#isOpening) this.#stats.progress(null);
        this.detail.enableViews();
        announce(`Loaded ${source.name}: ${formatCount(mesh.fullTriangleCount)} triangles`);
      },
      (error: unknown) => {
        if (this.mesh !== mesh || (error instanceof StriataError && error.code === 'aborted')) return;
        this.#isIncomplete = true;
        update();
        if (!this.#isOpening) this.#stats.progress(null);
        this.#reportIncomplete(mesh, source, error);
      },
    );
  }

  /** Reports that the rest of the model could not be loaded; the loaded part stays. */
  #reportIncomplete(mesh: StriataMesh, source: ModelSource, error: unknown): void {
    const notice = noticeOf(error, `Could not load all of ${source.name}`, source, () => void this.open(source, true));
    notice.reason += ` The loaded part is still shown: ${formatCount(mesh.triangleCount)} of ${formatCount(mesh.fullTriangleCount)} triangles.`;
    notify(notice);
  }

  #onProgress(abort: AbortController, progress: Progress, source: ModelSource): void {
    if (abort !== this.#abort) return;
    this.#stats.progress(progress);
    const isShown = this.mesh !== null && this.#source === source;
    if (!isShown) element('subtitle').textContent = `Opening ${source.name}: ${describeProgress(progress)}`;
  }

  #update(mesh: StriataMesh): void {
    if (this.mesh !== mesh) return;
    if (!this.#frozen.isFrozen) this.framing.follow(mesh, mesh.vertexCount, mesh.complete);
    this.#wireframe.show(mesh, this.look.wireframe);
    this.#stats.show(mesh);
    const kind = mesh.complete ? kindOf(mesh) : this.#isIncomplete ? 'incomplete' : 'loading';
    element('subtitle').textContent = `${formatCount(mesh.fullTriangleCount)} triangles, ${kind}`;
    this.stage.invalidate();
  }

  #onDetailChanged(): void {
    const { isFrozen } = this.detail;
    element('frozen-note').hidden = !isFrozen;
    if (isFrozen) this.#frozen.freeze(themeColor('--accent'));
    else this.#frozen.unfreeze();
    if (this.mesh) this.#stats.show(this.mesh);
    this.stage.invalidate();
  }

  #remove(): void {
    this.#frozen.unfreeze(false);
    const { mesh } = this;
    if (!mesh) return;
    this.mesh = null;
    mesh.removeFromParent();
    mesh.dispose();
  }
}

/** Hints for errors that the library gives none for. */
const HINTS: Partial<Record<ErrorCode, string>> = {
  format: 'The viewer opens .stri, .striata, .ply, .obj, .stl, .off, .gltf and .glb, optionally compressed as .gz or .zst.',
  unsupported: 'The viewer opens .stri, .striata, .ply, .obj, .stl, .off, .gltf and .glb, optionally compressed as .gz or .zst.',
  corrupt: 'Copy or download the file again.',
};

/** Capitalizes a sentence and ends it with a period. */
function sentence(text: string): string {
  const whole = /[.!?]$/.test(text) ? text : `${text}.`;
  return whole.charAt(0).toUpperCase() + whole.slice(1);
}

/** Turns an error into a notice: the library's message and hint, plus what this page knows. */
function noticeOf(error: unknown, title: string, source: ModelSource, retry: () => void) {
  const known = error instanceof StriataError ? error : null;
  const reason = sentence(known?.message ?? (error instanceof Error ? error.message : String(error)));
  const isNetwork = known?.code === 'network';
  let hint = known?.hint ?? (known ? HINTS[known.code] : undefined);
  if (isNetwork && source.url && isCrossOrigin(source.url)) {
    hint = 'The file is on another server, and either that server or this page does not allow loading it. Download it and drop it here.';
  } else if (isNetwork && !navigator.onLine) {
    hint = 'You are offline.';
  }
  return { title, reason, hint: hint && sentence(hint), retry: isNetwork || known?.code === 'not-found' ? retry : undefined };
}

function materialsOf(mesh: StriataMesh): SurfaceMaterial[] {
  return Array.isArray(mesh.material) ? mesh.material : [mesh.material];
}

function kindOf(mesh: StriataMesh): string {
  if (mesh.kind === 'mesh') return 'simplified in the browser';
  return mesh.kind === 'stream' ? 'stream' : '.striata file';
}
