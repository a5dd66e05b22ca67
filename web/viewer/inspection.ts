/**
 * Shows one multiresolution model of a file instead of the page's own way of drawing, which is a list: fans, strips, MTS, patterns, with
 * their statistics. The file becomes one mesh without materials; its level follows the panel and the camera. With geomorphs, vertices
 * glide to their places when the level changes.
 */

import {
  BufferAttribute, BufferGeometry, type Camera, DoubleSide, Mesh, MeshStandardMaterial, type PerspectiveCamera, Vector2,
} from 'three';
import type { StriataScene, VertexStep } from '../src/index.ts';
import { coloredTriangles } from '../src/colored-triangles.ts';
import { fromPlain, StriataError } from '../src/error.ts';
import { viewOf } from '../src/view.ts';
import { builderModule } from '../src/wasm.ts';
import { announce, createNode, element, input, setVisible } from './dom.ts';
import { bytesOf } from './encoder.ts';
import { formatBytes, formatCount, formatNumber } from './format.ts';
import {
  type InspectedLevel, type InspectedVertices, type InspectOrder, type InspectReport, type InspectRequest, type ModelName, type NumberedTriangles,
} from './inspect-worker.ts';
import InspectWorker from './inspect-worker.ts?worker&inline';
import { notify } from './notices.ts';
import type { ModelSource } from './sources.ts';
import type { Stage } from './stage.ts';
import { wasmUrls } from './wasm-urls.ts';

/** Duration of a geomorph. */
const MORPH_SECONDS = 0.4;

/** Names of the strips, fans or fragments of each model. */
const PRIMITIVES: Record<ModelName, string> = {
  list: 'Triangles', lodstrips: 'Strips', 'live-strips': 'Strips', mts: 'Strips', fans: 'Fans', patterns: 'Fragments',
};

/** Color of a mesh without materials. */
const CLAY = 0xcfc4b4;

/** The part of the viewer that the inspection needs. */
export interface InspectionHost {
  /** The level that the panel asks for; `camera` if it depends on it. */
  level: () => Pick<InspectRequest, 'by' | 'value'>;
  /** Whether the level stays as it is. */
  isFrozen: () => boolean;
  look: () => { isColored: boolean; byTriangle: boolean; flat: boolean };
  /** Called when the model that is shown, or its level, has changed. */
  onChange: () => void;
}

export class Inspection {
  readonly #stage: Stage;
  readonly #host: InspectionHost;
  #scene: StriataScene | null = null;
  #source: ModelSource | null = null;
  #worker: Worker | null = null;
  #abort = new AbortController();
  #vertices: InspectedVertices | null = null;
  #mesh: Mesh<BufferGeometry, MeshStandardMaterial> | null = null;
  #level: InspectedLevel | null = null;
  /** The request that was sent last, and whether it is still being answered. */
  #sent = '';
  #isPending = false;
  /** Positions that are drawn; those of moving vertices differ from their own. */
  #positions = new Float32Array();
  /** Seconds since the vertices began to move; null if they do not. */
  #morphed: number | null = null;
  #wanted: ModelName | null = null;

  constructor(stage: Stage, host: InspectionHost) {
    this.#stage = stage;
    this.#host = host;
    this.#select.addEventListener('change', () => void this.choose(this.#select.value as ModelName | ''));
    input('morphs').addEventListener('change', () => stage.invalidate());
    stage.beforeFrame.add((seconds) => this.#frame(seconds));
  }

  get #select(): HTMLSelectElement {
    return element<HTMLSelectElement>('inspected');
  }

  /** The model that is shown or being prepared; null for the page's own way. */
  get model(): ModelName | null {
    return (this.#select.value || null) as ModelName | null;
  }

  /** The mesh that is drawn instead of the scene, if any. */
  get mesh(): Mesh | null {
    return this.#mesh;
  }

  /** The model that is drawn. */
  get shown(): ModelName | null {
    return this.#level?.model ?? null;
  }

  /** Whether vertices move. */
  get isMoving(): boolean {
    return this.#morphed !== null;
  }

  /** Number of triangles that are drawn; while vertices move, more than the level has. */
  get drawnTriangleCount(): number {
    const geometry = this.#mesh?.geometry;
    return ((geometry?.index ?? geometry?.getAttribute('position'))?.count ?? 0) / 3;
  }

  get triangleCount(): number {
    return (this.#level?.indices.length ?? 0) / 3;
  }

  /** Switches to another file, of which no model is shown; `first` is the one to begin with once the file has loaded. */
  setScene(scene: StriataScene | null, source: ModelSource | null, first: ModelName | null = null): void {
    this.#close();
    this.#select.value = '';
    this.#scene = scene;
    this.#source = source;
    this.#wanted = first;
    // Pages are read as they are needed; models need the whole mesh.
    this.#select.disabled = scene === null || scene.kind === 'paged';
    this.#list();
    if (!scene || !first) return;
    const begin = (): void => void (this.#scene === scene && this.#wanted === first && this.choose(first));
    scene.finished.then(begin, () => undefined);
  }

  /** Shows a model, or the scene as it is. */
  async choose(model: ModelName | ''): Promise<void> {
    this.#wanted = null;
    if (this.#select.disabled) return;
    this.#select.value = model;
    if (model === '') {
      this.#close();
      announce('Shown as it is');
    } else {
      announce(`Preparing ${model}`);
      if (!this.#worker) await this.#open();
      this.#ask();
    }
    this.#stage.invalidate();
    this.#host.onChange();
  }

  /** Applies colors and shading. */
  applyLook(): void {
    if (this.#level) this.#draw(this.#level);
  }

  /** Step and error of a corner of what is drawn; null if it is not drawn here. */
  stepOf(mesh: Mesh, corner: number): { vertex: number; step: VertexStep | null; primitive: string } | null {
    const [level, vertices] = [this.#level, this.#vertices];
    if (mesh !== this.#mesh || !level || !vertices) return null;
    const vertex = mesh.geometry.index ? corner : level.indices[corner];
    if (vertex === undefined) return null;
    const step = vertices.steps[vertex]!;
    return { vertex, step: step < 0 ? null : { step, error: vertices.errors[step] ?? 0 }, primitive: PRIMITIVES[level.model].replace(/s$/, '') };
  }

  /** Number of the strip, fan or fragment of a triangle. */
  primitiveOf(triangle: number): number | undefined {
    return this.#level?.numbers[triangle];
  }

  async #open(): Promise<void> {
    const [source, scene, abort] = [this.#source, this.#scene, this.#abort];
    if (!source || !scene) return;
    this.#note('reading the file');
    try {
      const [module, bytes] = await Promise.all([builderModule(wasmUrls()), bytesOf(source, abort.signal)]);
      if (abort.signal.aborted || this.#worker) return;
      const worker = new InspectWorker();
      this.#worker = worker;
      worker.onmessage = ({ data }: MessageEvent<InspectReport>) => this.#take(data);
      worker.onerror = (event) => {
        event.preventDefault();
        this.#fail(new StriataError('unsupported', `the worker failed: ${event.message || 'it could not start'}`));
      };
      this.#send({ type: 'open', module, bytes, name: source.name }, [bytes]);
    } catch (error) {
      if (!abort.signal.aborted) this.#fail(error);
    }
  }

  #send(order: InspectOrder, transfer: Transferable[] = []): void {
    this.#worker?.postMessage(order, transfer);
  }

  #take(report: InspectReport): void {
    if (report.type === 'progress') this.#note(`${report.phase} ${Math.floor(100 * report.share)}%`);
    else if (report.type === 'failed') this.#fail(fromPlain(report.error));
    else if (report.type === 'opened') {
      this.#vertices = report.vertices;
      this.#positions = report.vertices.positions.slice();
      for (const option of this.#select.options) option.disabled = option.value !== '' && !report.vertices.available.includes(option.value as ModelName);
      this.#note('building the model');
      this.#ask();
    } else this.#show(report.level);
  }

  #fail(error: unknown): void {
    const known = error instanceof StriataError ? error : null;
    const name = this.#source?.name ?? 'the file';
    this.#select.value = '';
    this.#close();
    notify({ title: `Cannot show this model of ${name}`, reason: error instanceof Error ? error.message : String(error), hint: known?.hint });
    this.#host.onChange();
  }

  /** Asks for the level that the panel and the camera want, unless it is shown. */
  #ask(): void {
    const { model } = this;
    if (!model || !this.#vertices || this.#isPending) return;
    const wanted: InspectRequest = { model, morphs: input('morphs').checked, ...this.#host.level() };
    if (wanted.by === 'view') {
      if (this.#host.isFrozen() && this.#level?.model === model) return;
      const camera = this.#camera();
      if (!camera) return;
      wanted.camera = camera;
    }
    const text = JSON.stringify({ ...wanted, morphs: false });
    if (text === this.#sent) return;
    this.#sent = text;
    this.#isPending = true;
    this.#send({ type: 'show', request: wanted });
  }

  /** How the camera sees the mesh. */
  #camera(): number[] | undefined {
    const { renderer, camera, pivot } = this.#stage;
    const size = renderer.getDrawingBufferSize(new Vector2());
    // The camera may have moved since it last drew.
    camera.updateMatrixWorld();
    const view = viewOf(this.#mesh ?? pivot, camera as Camera & PerspectiveCamera, size.x, size.y);
    return view?.kind === 'perspective' ? view.numbers : undefined;
  }

  #show(level: InspectedLevel): void {
    this.#isPending = false;
    if (this.model !== level.model) return this.#ask();
    this.#level = level;
    this.#morphed = level.morph ? 0 : null;
    this.#positions.set(this.#vertices!.positions);
    this.#draw(level);
    if (this.#scene) this.#scene.visible = false;
    this.#list();
    this.#stage.invalidate();
    this.#host.onChange();
    this.#ask();
  }

  /** Draws a level, or what is drawn on the way to it. */
  #draw(level: InspectedLevel): void {
    const { isColored, byTriangle, flat } = this.#host.look();
    this.#mesh ??= this.#newMesh();
    this.#mesh.geometry.dispose();
    if (this.#morphed !== null && level.morph) this.#blend(level.morph, this.#morphed / MORPH_SECONDS);
    const shown: NumberedTriangles = this.#morphed !== null && level.morph ? level.morph : level;
    if (isColored) {
      const numbers = byTriangle ? shown.numbers.map((_, triangle) => triangle) : shown.numbers;
      this.#mesh.geometry = coloredTriangles(this.#positions, shown.indices, numbers);
    } else {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(this.#positions, 3));
      geometry.setAttribute('normal', new BufferAttribute(this.#vertices!.normals, 3));
      geometry.setIndex(new BufferAttribute(shown.indices, 1));
      this.#mesh.geometry = geometry;
    }
    const { material } = this.#mesh;
    const settings = { vertexColors: isColored, flatShading: isColored || flat };
    if (material.vertexColors !== settings.vertexColors || material.flatShading !== settings.flatShading) material.needsUpdate = true;
    Object.assign(material, settings);
    material.color.setHex(isColored ? 0xffffff : CLAY);
  }

  #newMesh(): Mesh<BufferGeometry, MeshStandardMaterial> {
    const mesh = new Mesh(new BufferGeometry(), new MeshStandardMaterial({ side: DoubleSide, roughness: 0.85, metalness: 0 }));
    mesh.name = this.#source?.name ?? '';
    mesh.frustumCulled = false;
    this.#stage.pivot.add(mesh);
    return mesh;
  }

  /** Asks for another level if the view has changed, and moves vertices. Returns whether they go on moving. */
  #frame(seconds: number): boolean {
    if (!this.model || !this.#vertices) return false;
    const level = this.#level;
    if (this.#morphed !== null && level?.morph) {
      this.#morphed += seconds;
      if (this.#morphed >= MORPH_SECONDS) {
        this.#morphed = null;
        this.#positions.set(this.#vertices.positions);
      }
      this.#draw(level);
      // Another level may have been chosen meanwhile.
      if (this.#morphed === null) this.#ask();
      return this.#morphed !== null;
    }
    this.#ask();
    return false;
  }

  /** Moves vertices to where they are at a fraction of the way. */
  #blend({ vertices, targets, appearingCount }: NonNullable<InspectedLevel['morph']>, fraction: number): void {
    const own = this.#vertices!.positions;
    // Slow at both ends.
    const eased = fraction * fraction * (3 - 2 * fraction);
    vertices.forEach((vertex, at) => {
      const share = at < appearingCount ? eased : 1 - eased;
      const [to, from] = [3 * vertex, 3 * targets[at]!];
      for (let i = 0; i < 3; i++) this.#positions[to + i] = own[from + i]! + share * (own[to + i]! - own[from + i]!);
    });
  }

  #note(text: string): void {
    const note = element('inspected-note');
    note.hidden = text === '';
    note.textContent = text;
  }

  /** Lists the statistics. */
  #list(): void {
    const level = this.#level;
    setVisible('inspected-facts', level !== null);
    setVisible('morphs-row', level !== null);
    this.#note('');
    if (!level) return;
    const triangles = level.indices.length / 3;
    const rows: [string, string][] = [['Triangles', formatCount(triangles)]];
    if (level.primitiveCount > 0) rows.push([PRIMITIVES[level.model], formatCount(level.primitiveCount)]);
    rows.push(
      ['Indices', `${formatCount(level.indexCount)}, ${(level.indexCount / Math.max(triangles, 1)).toFixed(2)} a triangle`],
      ['Written for this level', formatCount(level.changedCount)],
      ['Steps refined', `${formatCount(level.splitCount)} of ${formatCount(this.#vertices!.errors.length)}`],
      ['Error', level.error > 0 ? formatNumber(level.error) : 'none'],
    );
    const built = this.#vertices!.stored.includes(level.model) ? 'from the file' : 'built here';
    if (level.modelBytes > 0) rows.push(['Model', `${formatBytes(level.modelBytes)}, ${built}`]);
    rows.push(['Each instance', formatBytes(level.instanceBytes)], ['Last update', `${level.updateMs.toFixed(1)} ms`]);
    element('inspected-facts').replaceChildren(...rows.map(([name, value]) => {
      const row = createNode('div');
      row.append(createNode('dt', '', name), createNode('dd', '', value));
      return row;
    }));
  }

  #close(): void {
    this.#abort.abort();
    this.#abort = new AbortController();
    this.#worker?.terminate();
    this.#mesh?.geometry.dispose();
    this.#mesh?.material.dispose();
    this.#mesh?.removeFromParent();
    if (this.#scene) this.#scene.visible = true;
    [this.#worker, this.#vertices, this.#mesh, this.#level, this.#morphed] = [null, null, null, null, null];
    [this.#sent, this.#isPending] = ['', false];
    for (const option of this.#select.options) option.disabled = false;
    this.#list();
    this.#stage.invalidate();
  }
}
