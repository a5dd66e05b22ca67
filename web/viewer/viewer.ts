/**
 * One model after the other on the stage: opening, following it while it comes in, and saying so when it does not.
 *
 * A model that fails before anything could be drawn leaves the one that is shown in its place; one that fails on its way
 * keeps what has come. The download of the last ends when another takes its place, not before: the other may fail.
 */

import type { Material } from 'three';
import { type Coloring, type ErrorCode, type Progress, StriataError, StriataLoader, type StriataMesh } from '../src/index.ts';
import { Detail } from './detail.ts';
import { Figures, words } from './figures.ts';
import { Framing } from './framing.ts';
import { FrozenView } from './frozen.ts';
import { dismissAll, notify } from './notices.ts';
import { count } from './numbers.ts';
import { element, say } from './page.ts';
import { isElsewhere, type Opened } from './sources.ts';
import type { Stage } from './stage.ts';
import { themeColor } from './theme.ts';
import { Wires } from './wires.ts';

/** What a plain model is made of, where the file gives it no colors. */
const CLAY = 0xcfc4b4;

type SurfaceMaterial = Material & { flatShading?: boolean; color?: unknown };

/** How every model is to look. */
export interface Look {
  coloring: Coloring;
  wireframe: boolean;
  flat: boolean;
  zUp: boolean;
}

export class Viewer {
  readonly stage: Stage;
  readonly framing: Framing;
  readonly detail: Detail;
  readonly look: Look = { coloring: 'surface', wireframe: false, flat: false, zUp: false };
  mesh: StriataMesh | null = null;
  /** Called when a model is on the stage, and when none could be opened and the stage is empty. */
  onShown: () => void = () => {};
  onNothing: () => void = () => {};

  readonly #loader = StriataLoader();
  readonly #figures: Figures;
  readonly #frozen: FrozenView;
  readonly #wires = new Wires();
  #opened: Opened | null = null;
  #abort = new AbortController();
  #isOpening = false;
  /** The rest of the model that is shown does not come. */
  #isCut = false;
  /** Of the surface; other colorings have their own. */
  #materials: SurfaceMaterial[] = [];

  constructor(stage: Stage) {
    this.stage = stage;
    this.framing = new Framing(stage);
    this.#frozen = new FrozenView(stage, this.framing);
    this.#figures = new Figures(() => stage.framesPerSecond);
    this.detail = new Detail(() => this.#detailChanged());
  }

  /** Opens a model; `keepsCamera` where it is the same once more. */
  async open(opened: Opened, keepsCamera = false): Promise<void> {
    const before = this.#abort;
    if (this.#isOpening) before.abort();
    const abort = new AbortController();
    this.#abort = abort;
    this.#isOpening = true;
    dismissAll();
    this.#figures.progress({ bytesReceived: 0, bytesTotal: null, triangleCount: 0, vertexCount: 0, complete: false, phase: 'download' });
    say(`Opening ${opened.name}`);
    try {
      const mesh = await this.#loader.load(opened.source, {
        name: opened.name,
        signal: abort.signal,
        onProgress: (progress) => this.#came(abort, progress, opened),
      });
      if (abort.signal.aborted) return mesh.dispose();
      this.#show(mesh, opened, keepsCamera);
    } catch (error) {
      if (abort.signal.aborted) return;
      this.#isOpening = false;
      // What is shown may still be coming in.
      this.#abort = before;
      this.#figures.progress(null);
      notify(noticeOf(error, `Cannot open ${opened.name}`, opened, () => void this.open(opened, keepsCamera)));
      if (this.mesh) this.#update(this.mesh);
      else this.onNothing();
    }
  }

  /** Gives the mesh the look that is asked for. */
  applyLook(): void {
    const { mesh, look } = this;
    if (!mesh) return;
    mesh.coloring = look.coloring;
    this.#wires.show(mesh, look.wireframe);
    for (const material of this.#materials) {
      if ('flatShading' in material && material.flatShading !== look.flat) {
        material.flatShading = look.flat;
        material.needsUpdate = true;
      }
    }
    this.stage.invalidate();
  }

  /** Tilts the model where z is up. */
  setZUp(zUp: boolean): void {
    this.look.zUp = zUp;
    this.stage.pivot.rotation.x = zUp ? -Math.PI / 2 : 0;
    if (this.mesh) this.framing.turned(this.mesh, this.mesh.vertexCount);
    this.stage.invalidate();
  }

  /** Leaves the model: the stage is empty, the download ends. */
  close(): void {
    this.#abort.abort();
    this.#isOpening = false;
    this.#figures.progress(null);
    this.#figures.hide();
    this.#remove();
    this.detail.take(null);
    this.stage.invalidate();
  }

  /** Whether a model is shown or being opened. */
  get isBusy(): boolean {
    return this.mesh !== null || this.#isOpening;
  }

  /** The address of the model, where it has one. */
  get url(): string | null {
    return this.#opened?.url ?? null;
  }

  get name(): string {
    return this.#opened?.name ?? 'model';
  }

  #show(mesh: StriataMesh, opened: Opened, keepsCamera: boolean): void {
    this.#isOpening = false;
    this.#isCut = false;
    this.#remove();
    this.mesh = mesh;
    this.#opened = opened;
    this.#materials = materialsOf(mesh);
    for (const material of this.#materials) {
      if ('color' in material && !material.vertexColors) (material.color as { setHex(hex: number): void }).setHex(CLAY);
    }
    this.stage.pivot.add(mesh);
    this.framing.restart(keepsCamera);
    this.#listen(mesh, opened);
    this.applyLook();
    this.detail.take(mesh);
    this.#update(mesh);
    this.onShown();
  }

  #listen(mesh: StriataMesh, opened: Opened): void {
    const update = (): void => this.#update(mesh);
    mesh.addEventListener('change', update);
    mesh.addEventListener('progress', update);
    mesh.finished.then(
      () => {
        if (this.mesh !== mesh) return;
        update();
        if (!this.#isOpening) this.#figures.progress(null);
        this.detail.allowViews();
        say(`${opened.name} is there: ${count(mesh.fullTriangleCount)} triangles`);
      },
      (error: unknown) => {
        if (this.mesh !== mesh || (error instanceof StriataError && error.code === 'aborted')) return;
        this.#isCut = true;
        update();
        if (!this.#isOpening) this.#figures.progress(null);
        this.#sayCut(mesh, opened, error);
      },
    );
  }

  /** The rest of the model does not come: what is there stays. */
  #sayCut(mesh: StriataMesh, opened: Opened, error: unknown): void {
    const notice = noticeOf(error, `${opened.name} did not come in whole`, opened, () => void this.open(opened, true));
    notice.reason += ` What came is kept: ${count(mesh.triangleCount)} of ${count(mesh.fullTriangleCount)} triangles.`;
    notify(notice);
  }

  #came(abort: AbortController, progress: Progress, opened: Opened): void {
    if (abort !== this.#abort) return;
    this.#figures.progress(progress);
    const isShown = this.mesh !== null && this.#opened === opened;
    if (!isShown) element('subtitle').textContent = `opening ${opened.name}: ${words(progress)}`;
  }

  #update(mesh: StriataMesh): void {
    if (this.mesh !== mesh) return;
    if (!this.#frozen.isFrozen) this.framing.follow(mesh, mesh.vertexCount, mesh.complete);
    this.#wires.show(mesh, this.look.wireframe);
    this.#figures.show(mesh);
    const kind = mesh.complete ? kindOf(mesh) : this.#isCut ? 'not all there' : 'coming in';
    element('subtitle').textContent = `${count(mesh.fullTriangleCount)} triangles, ${kind}`;
    this.stage.invalidate();
  }

  #detailChanged(): void {
    const { isFrozen } = this.detail;
    element('outside').hidden = !isFrozen;
    if (isFrozen) this.#frozen.freeze(themeColor('--accent'));
    else this.#frozen.thaw();
    if (this.mesh) this.#figures.show(this.mesh);
    this.stage.invalidate();
  }

  #remove(): void {
    this.#frozen.thaw(false);
    const { mesh } = this;
    if (!mesh) return;
    this.mesh = null;
    mesh.removeFromParent();
    mesh.dispose();
  }
}

/** What may help where the library does not say. */
const HINTS: Partial<Record<ErrorCode, string>> = {
  format: 'The viewer opens .stri, .striata, .ply, .obj, .stl, .off, .gltf and .glb, also with .gz or .zst.',
  unsupported: 'The viewer opens .stri, .striata, .ply, .obj, .stl, .off, .gltf and .glb, also with .gz or .zst.',
  corrupt: 'Copy or download the file once more.',
};

/** Begins large and ends with a full stop. */
function sentence(text: string): string {
  const whole = /[.!?]$/.test(text) ? text : `${text}.`;
  return whole.charAt(0).toUpperCase() + whole.slice(1);
}

/** An error as a notice: what the library says, and what this page knows beside it. */
function noticeOf(error: unknown, title: string, opened: Opened, retry: () => void) {
  const known = error instanceof StriataError ? error : null;
  const reason = sentence(known?.message ?? (error instanceof Error ? error.message : String(error)));
  const isNetwork = known?.code === 'network';
  let hint = known?.hint ?? (known ? HINTS[known.code] : undefined);
  if (isNetwork && opened.url && isElsewhere(opened.url)) {
    hint = 'The file lies on another server, which this page may not read unless both allow it; download it and drop it here.';
  } else if (isNetwork && !navigator.onLine) {
    hint = 'This machine is offline.';
  }
  return { title, reason, hint: hint && sentence(hint), retry: isNetwork || known?.code === 'not-found' ? retry : undefined };
}

function materialsOf(mesh: StriataMesh): SurfaceMaterial[] {
  return Array.isArray(mesh.material) ? mesh.material : [mesh.material];
}

function kindOf(mesh: StriataMesh): string {
  if (mesh.kind === 'mesh') return 'simplified in this page';
  return mesh.kind === 'stream' ? 'a stream' : 'a .striata file';
}
