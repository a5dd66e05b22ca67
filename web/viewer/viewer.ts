/**
 * Shows one model at a time: opens it, follows it while it loads, and reports errors.
 *
 * If a model fails before anything could be drawn, the previous one stays. If it fails later, the part that has loaded is kept.
 * The previous download is canceled only when the new model replaces it, because the new one may fail.
 */

import type { Object3D, Sphere } from 'three';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { type Coloring, type ErrorCode, type Progress, StriataError, StriataLoader, type StriataScene } from '../src/index.ts';
import { Bounds, boundsOf } from './bounds.ts';
import { Comparison } from './comparison.ts';
import { DetailControls } from './detail-controls.ts';
import type { Saved } from './encode-worker.ts';
import { encodeModel } from './encoder.ts';
import { describeProgress, Stats } from './stats.ts';
import { Framing } from './framing.ts';
import { FrozenView } from './frozen-view.ts';
import { Inspection } from './inspection.ts';
import { ModelTree } from './model-tree.ts';
import { dismissAll, notify } from './notices.ts';
import { formatCount } from './format.ts';
import { announce, element, setVisible } from './dom.ts';
import { Picking } from './picking.ts';
import { Playback } from './playback.ts';
import { Plots } from './plots.ts';
import { Recording } from './recording.ts';
import { Saving } from './saving.ts';
import { fromFile, isCrossOrigin, type ModelSource } from './sources.ts';
import type { Stage } from './stage.ts';
import { type Backs, hasVertexColors, isBare, materialsOf, paintClay, shadeFlat, showBacks, showVertexColors } from './surface.ts';
import { themeColor } from './theme.ts';
import type { ViewState } from './view-state.ts';
import { wasmUrls } from './wasm-urls.ts';

/** Poses of an animation that are measured to frame the model. */
const MEASURED_POSES = 8;

const NO_PROGRESS: Progress = { bytesReceived: 0, bytesTotal: null, triangleCount: 0, vertexCount: 0, complete: false, phase: 'download' };

/** Appearance of the model. */
export interface Look {
  coloring: Coloring;
  wireframe: boolean;
  flat: boolean;
  zUp: boolean;
  vertexColors: boolean;
  backs: Backs;
}

export class Viewer {
  readonly stage: Stage;
  readonly framing: Framing;
  readonly detail: DetailControls;
  readonly playback: Playback;
  readonly comparison: Comparison;
  readonly look: Look = { coloring: 'surface', wireframe: false, flat: false, zUp: false, vertexColors: true, backs: 'file' };
  readonly recording: Recording;
  /** One multiresolution model of the file, drawn instead of the scene. */
  readonly inspection: Inspection;
  model: StriataScene | null = null;
  /** Called with the view that a model is to be shown in, before it appears. */
  onView: (view: ViewState) => void = () => {};
  /** Called with whether z is up, before a model appears. */
  onUp: (isZUp: boolean) => void = () => {};
  /** Called when a model has appeared on the stage. */
  onShown: () => void = () => {};
  /** Called when no model could be opened and the stage is empty. */
  onEmpty: () => void = () => {};
  /** Called when comparing two levels starts or ends. */
  onComparisonChanged: (isOn: boolean) => void = () => {};

  readonly #loader = new StriataLoader({ ...wasmUrls(), pixelError: null, configure: (loader) => void loader.setMeshoptDecoder(MeshoptDecoder) });
  readonly #stats: Stats;
  readonly #frozen: FrozenView;
  readonly #tree: ModelTree;
  readonly #picking: Picking;
  readonly #saving = new Saving(() => this.model?.triangleCount ?? 0);
  #source: ModelSource | null = null;
  #abort = new AbortController();
  #isOpening = false;
  /** Progress of the model that was opened last. */
  #progress = NO_PROGRESS;
  /** Whether loading the rest of the model has failed. */
  #isIncomplete = false;

  constructor(stage: Stage) {
    this.stage = stage;
    this.framing = new Framing(stage);
    this.#frozen = new FrozenView(stage, this.framing);
    this.#stats = new Stats(() => stage.framesPerSecond);
    this.detail = new DetailControls(() => this.#onDetailChanged());
    this.playback = new Playback(stage);
    this.recording = new Recording(this);
    this.inspection = new Inspection(stage, {
      level: () => this.detail.inspected,
      isFrozen: () => this.detail.isFrozen,
      look: () => ({ isColored: this.look.coloring !== 'surface', byTriangle: this.look.coloring === 'triangles', flat: this.look.flat }),
      onChange: () => this.#onInspected(),
    });
    this.#picking = new Picking(stage, () => this.model, this.inspection);
    new Plots(stage, () => this.model);
    this.comparison = new Comparison(stage, {
      onChange: () => this.onComparisonChanged(this.comparison.isOn),
      open: (file) => this.#openOther(fromFile(file)),
    });
    this.#tree = new ModelTree({
      focus: (object) => this.#focus(object),
      onVisibility: () => stage.invalidate(),
    });
  }

  /** Opens a model; `keepsCamera` if it is the same model again. */
  async open(source: ModelSource, keepsCamera = false): Promise<void> {
    const before = this.#abort;
    if (this.#isOpening) before.abort();
    const abort = new AbortController();
    this.#abort = abort;
    this.#isOpening = true;
    dismissAll();
    this.#stats.progress(NO_PROGRESS);
    announce(`Opening ${source.name}`);
    try {
      const model = await this.#load(source, abort);
      if (abort.signal.aborted) return model.dispose();
      this.#show(model, source, keepsCamera);
    } catch (error) {
      if (abort.signal.aborted) return;
      this.#isOpening = false;
      // The model that is shown may still be loading.
      this.#abort = before;
      this.#stats.progress(null);
      notify(noticeOf(error, `Cannot open ${source.name}`, source, () => void this.open(source, keepsCamera)));
      if (this.model) this.#update(this.model);
      else this.onEmpty();
    }
  }

  /**
   * Loads a model. Files that the page's own loaders cannot read are read by the reader of the command as plain GLB files, which also
   * says best what is wrong with them.
   */
  async #load(source: ModelSource, abort: AbortController): Promise<StriataScene> {
    const load = (data: ModelSource['data'] | Blob, name: string, isConverted = false): Promise<StriataScene> => this.#loader.open(data, {
      name,
      ...(isConverted && !/\.gl(b|tf)(\.|$)/i.test(source.name) ? { smooth: true } : {}),
      signal: abort.signal,
      onProgress: (progress) => this.#onProgress(abort, progress, source),
    });
    try {
      return await load(source.data, source.name);
    } catch (error) {
      if (!mayBeReadOtherwise(error, source.name)) throw error;
    }
    const saved: Saved = { format: 'level', triangles: ALL_TRIANGLES };
    const converted = await encodeModel(source, saved, abort.signal, (_, share) => this.#onProgress(abort, { ...NO_PROGRESS, phase: 'build', share }, source));
    return load(converted, `${source.name}.glb`, true);
  }

  /** Opens a model to compare with; returns null after reporting why it cannot be opened. */
  async #openOther(source: ModelSource): Promise<StriataScene | null> {
    announce(`Opening ${source.name}`);
    try {
      const scene = await this.#load(source, new AbortController());
      await scene.finished;
      const materials = materialsOf(scene);
      const bare = isBare(materials);
      paintClay(materials, bare);
      showBacks(materials, this.look.backs, scene.isSolid && bare);
      return scene;
    } catch (error) {
      notify(noticeOf(error, `Cannot open ${source.name}`, source, () => undefined));
      return null;
    }
  }

  /** Applies the chosen appearance to the model. */
  applyLook(): void {
    const { model, look } = this;
    if (!model) return;
    model.coloring = look.coloring;
    this.#applyToMaterials(model);
    this.inspection.applyLook();
    this.stage.showsWireframe = look.wireframe;
    this.stage.tintsBacks = look.backs === 'tint';
    this.stage.invalidate();
  }

  /** Changes the materials for the chosen appearance; those of colored triangles come later than their choice. */
  #applyToMaterials(model: StriataScene): void {
    const { look } = this;
    const materials = materialsOf(model);
    shadeFlat(materials, look.flat);
    showBacks(materials, look.backs, model.isSolid && isBare(materials));
    showVertexColors(materials, look.vertexColors || look.coloring !== 'surface');
    if (look.coloring === 'surface') setVisible('vertex-colors-row', hasVertexColors(materials));
    this.#light(model);
  }

  /** Tilts the model if z is up. */
  setZUp(zUp: boolean): void {
    this.look.zUp = zUp;
    this.stage.pivot.rotation.x = zUp ? -Math.PI / 2 : 0;
    const { model } = this;
    if (model) this.framing.onTilted(() => this.#measure(model), model.vertexCount);
    this.stage.invalidate();
  }

  /** Removes the model and cancels its download. */
  close(): void {
    this.#abort.abort();
    this.#isOpening = false;
    this.#stats.progress(null);
    this.#stats.hide();
    this.#remove();
    this.detail.setModel(null);
    this.stage.invalidate();
  }

  /** Whether a model is shown or being opened. */
  get isBusy(): boolean {
    return this.model !== null || this.#isOpening;
  }

  /** URL of the model, if it has one. */
  get url(): string | null {
    return this.#source?.url ?? null;
  }

  /** Whether a model is being opened. */
  get isOpening(): boolean {
    return this.#isOpening;
  }

  /** Whether the page contains the model. */
  get isEmbedded(): boolean {
    return this.#source?.isEmbedded === true;
  }

  /** Whether the view is looked at from outside. */
  get isFrozen(): boolean {
    return this.#frozen.isFrozen;
  }

  get name(): string {
    return this.#source?.name ?? 'model';
  }

  #show(model: StriataScene, source: ModelSource, keepsCamera: boolean): void {
    this.#isOpening = false;
    this.#isIncomplete = false;
    const wasTurned = this.model?.isZUp === true;
    this.#remove();
    const view = keepsCamera ? null : (source.view ?? null);
    if (view) this.onView(view);
    // Full detail of a paged file would be all of it.
    if (!keepsCamera && (view?.level || model.kind !== 'paged')) this.detail.restore(view?.level ?? null);
    this.model = model;
    this.#source = source;
    this.stage.lighting.use('lamps');
    this.stage.pivot.add(model);
    // A choice of the user stays, one that a model made does not.
    if (!keepsCamera) this.onUp(view ? (view.look.zUp ?? model.isZUp) : model.isZUp || (this.look.zUp && !wasTurned));
    this.framing.restart(keepsCamera, view?.camera);
    this.#listen(model, source);
    this.applyLook();
    this.playback.setScene(model, view?.playback);
    // Animations may follow after everything else that the first picture needs.
    void model.animated.then(() => {
      if (this.model !== model || this.playback.clipCount === model.animations.length) return;
      this.playback.setScene(model, view?.playback);
      this.framing.remeasure(() => this.#measure(model), model.vertexCount);
    });
    this.comparison.setScene(model);
    this.#tree.setScene(model);
    // Saving reads whole files.
    this.#saving.setSource(model.kind === 'paged' ? null : source);
    this.detail.setModel(model);
    this.inspection.setScene(model, source, view?.model ?? null);
    this.#update(model);
    this.onShown();
  }

  #listen(model: StriataScene, source: ModelSource): void {
    const update = (): void => this.#update(model);
    model.addEventListener('change', update);
    model.addEventListener('progress', update);
    // Pages of a paged file are read as long as it is shown.
    if (model.kind === 'paged') model.addEventListener('error', ({ error }) => this.model === model && this.#reportIncomplete(model, source, error));
    model.finished.then(
      () => {
        if (this.model !== model) return;
        update();
        if (!this.#isOpening) this.#stats.progress(null);
        this.detail.enableViews();
        if (model.kind !== 'paged') this.comparison.enable();
        announce(`Loaded ${source.name}: ${formatCount(model.fullTriangleCount)} triangles`);
      },
      (error: unknown) => {
        if (this.model !== model || (error instanceof StriataError && error.code === 'aborted')) return;
        this.#isIncomplete = true;
        update();
        if (!this.#isOpening) this.#stats.progress(null);
        this.#reportIncomplete(model, source, error);
      },
    );
  }

  /** Reports that the rest of the model could not be loaded; the loaded part stays. */
  #reportIncomplete(model: StriataScene, source: ModelSource, error: unknown): void {
    const notice = noticeOf(error, `Could not load all of ${source.name}`, source, () => void this.open(source, true));
    notice.reason += ` The loaded part is still shown: ${formatCount(model.triangleCount)} of ${formatCount(model.fullTriangleCount)} triangles.`;
    notify(notice);
  }

  #onProgress(abort: AbortController, progress: Progress, source: ModelSource): void {
    if (abort !== this.#abort) return;
    this.#stats.progress(progress);
    this.#progress = progress;
    if (this.model !== null && this.#source === source) this.#describe(this.model);
    else element('subtitle').textContent = `Opening ${source.name}: ${describeProgress(progress)}`;
  }

  #update(model: StriataScene): void {
    if (this.model !== model) return;
    if (!this.#frozen.isFrozen) this.framing.follow(() => this.#measure(model), model.vertexCount, model.complete);
    this.#applyToMaterials(model);
    this.#stats.show(model);
    this.#tree.update();
    this.comparison.update();
    this.#describe(model);
    this.stage.invalidate();
  }

  #describe(model: StriataScene): void {
    const loading = this.#progress.phase === 'build' ? describeProgress(this.#progress) : 'loading';
    const kind = model.complete ? kindOf(model) : this.#isIncomplete ? 'incomplete' : loading;
    element('subtitle').textContent = `${formatCount(model.fullTriangleCount)} triangles, ${kind}`;
  }

  #onDetailChanged(): void {
    const { isFrozen } = this.detail;
    element('frozen-note').hidden = !isFrozen;
    if (isFrozen) this.#frozen.freeze(themeColor('--accent'));
    else this.#frozen.unfreeze();
    if (this.model) this.#stats.show(this.model);
    this.stage.invalidate();
  }

  /** A comparison shows the scene, and what was picked belongs to what was drawn. */
  #onInspected(): void {
    if (this.inspection.mesh && this.comparison.isOn) this.comparison.toggle();
    this.#picking.clear();
  }

  /** Shows a bare scan as clay under lamps, and a scene with materials in the studio; textures may arrive late. */
  #light(model: StriataScene): void {
    const { lighting } = this.stage;
    if (lighting.name === 'studio') return;
    const materials = materialsOf(model);
    const bare = isBare(materials);
    paintClay(materials, bare);
    if (!bare) lighting.use('studio');
  }

  /** Bounds of the model, in all poses of its animation. */
  #measure(model: StriataScene): Sphere | null {
    const bounds = new Bounds();
    if (this.playback.isAvailable) this.playback.samplePoses(MEASURED_POSES, () => bounds.addArrived(model));
    else bounds.addArrived(model);
    return bounds.sphere();
  }

  #focus(part: Object3D): void {
    const sphere = boundsOf(part);
    if (sphere) this.framing.focus(sphere);
  }

  #remove(): void {
    this.recording.cancel();
    this.#picking.clear();
    this.#frozen.unfreeze(false);
    const { model } = this;
    if (!model) return;
    this.playback.setScene(null);
    this.comparison.setScene(null);
    this.inspection.setScene(null, null);
    this.#tree.setScene(null);
    this.#saving.setSource(null);
    this.model = null;
    model.removeFromParent();
    model.dispose();
  }
}

/** More triangles than any file has. */
const ALL_TRIANGLES = 0xffff_ffff;

/** Whether the reader of the command may read a file, or explain better why it cannot be read. */
function mayBeReadOtherwise(error: unknown, name: string): boolean {
  if (!(error instanceof StriataError) || /\.stri(ata)?(\.|$)/i.test(name)) return false;
  return error.code === 'unsupported' || error.code === 'format' || error.code === 'corrupt';
}

const FORMATS = 'The viewer opens .stri, .striata, .ply, .obj, .stl, .off, .gltf, .glb, .3mf, .vtk, .vtp and .vtu, optionally compressed as .gz or .zst.';

/** Hints for errors that the library gives none for. */
const HINTS: Partial<Record<ErrorCode, string>> = { format: FORMATS, unsupported: FORMATS, corrupt: 'Copy or download the file again.' };

/** Ends a sentence with a period, and capitalizes it unless it begins with the name of the file, which the title contains. */
function sentence(text: string, name = ''): string {
  const rest = name !== '' && text.startsWith(`${name}: `) ? text.slice(name.length + 2) : text;
  const whole = /[.!?]$/.test(rest) ? rest : `${rest}.`;
  return name !== '' && whole.startsWith(name) ? whole : whole.charAt(0).toUpperCase() + whole.slice(1);
}

/** Turns an error into a notice: the library's message and hint, plus what this page knows. */
function noticeOf(error: unknown, title: string, source: ModelSource, retry: () => void) {
  const known = error instanceof StriataError ? error : null;
  const reason = sentence(known?.message ?? (error instanceof Error ? error.message : String(error)), source.name);
  const isNetwork = known?.code === 'network';
  let hint = known?.hint ?? (known ? HINTS[known.code] : undefined);
  if (isNetwork && source.url && isCrossOrigin(source.url)) {
    hint = 'The file is on another server, and either that server or this page does not allow loading it. Download it and drop it here.';
  } else if (isNetwork && !navigator.onLine) {
    hint = 'You are offline.';
  }
  return { title, reason, hint: hint && sentence(hint), retry: isNetwork || known?.code === 'not-found' ? retry : undefined };
}

function kindOf(model: StriataScene): string {
  if (model.kind === 'mesh') return 'simplified in the browser';
  return { stream: 'stream', gltf: 'glTF with levels', striata: '.striata file', paged: 'paged file' }[model.kind];
}
