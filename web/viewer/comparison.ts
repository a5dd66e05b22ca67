/**
 * Compares two levels of the model side by side, or the model with another file: the stage is drawn twice, with a divider in between.
 * The left part shows the level that the panel selects. The right part shows a second one, as other index lists over the same vertices,
 * or a level of the other file, in the same coordinates.
 */

import { BufferAttribute, BufferGeometry, type Mesh } from 'three';
import type { StriataLod, StriataScene } from '../src/index.ts';
import { Divider } from './divider.ts';
import { element, input, setVisible } from './dom.ts';
import { formatCount, formatPercent } from './format.ts';
import { detailAt } from './scales.ts';
import type { Split, Stage } from './stage.ts';

/** What a comparison needs of the viewer. */
export interface ComparisonHost {
  /** Called when comparing starts or ends. */
  onChange: () => void;
  /** Opens a file as the model was opened; null if it cannot be opened, which the user has been told. */
  open: (file: File) => Promise<StriataScene | null>;
}

export class Comparison implements Split {
  readonly #stage: Stage;
  readonly #host: ComparisonHost;
  readonly #divider: Divider;
  #scene: StriataScene | null = null;
  /** The model of another file, and its name. */
  #other: { scene: StriataScene; name: string } | null = null;
  #isAvailable = false;
  /** Geometry that each mesh has in the right part. */
  #second = new Map<Mesh, BufferGeometry>();
  /** Number of the last request for a level, and whether one is pending. */
  #requested = 0;
  #isPending = false;
  #triangleCount: number | null = null;

  constructor(stage: Stage, host: ComparisonHost) {
    this.#stage = stage;
    this.#host = host;
    this.#divider = new Divider(element('divider'), () => {
      this.#place();
      stage.invalidate();
    });
    input('compare').addEventListener('change', () => this.#onSwitched());
    input('second').addEventListener('input', () => this.#onSecondChanged());
    element('compare-file').addEventListener('click', () => (this.#other ? this.#setOther(null) : input('compared').click()));
    input('compared').addEventListener('change', () => void this.#onFileChosen());
    this.#refresh();
  }

  get isOn(): boolean {
    return this.#stage.split === this;
  }

  get other(): StriataScene | null {
    return this.#other?.scene ?? null;
  }

  get fraction(): number {
    return this.#divider.fraction;
  }

  /** Triangles of the level in the right part; null until it has been made. */
  get triangleCount(): number | null {
    return this.#other ? this.#other.scene.triangleCount : this.#triangleCount;
  }

  /** Switches to another scene, which is not compared yet. */
  setScene(scene: StriataScene | null): void {
    this.#isAvailable = false;
    input('compare').checked = false;
    this.#onSwitched();
    this.#scene = scene;
    this.#refresh();
  }

  /** Allows comparing, after the model has loaded completely. */
  enable(): void {
    this.#isAvailable = true;
    this.#refresh();
  }

  /** Turns comparing on or off, and returns whether that is possible. */
  toggle(): boolean {
    if (!this.#isAvailable) return false;
    input('compare').click();
    return true;
  }

  /** Updates the labels of the two levels. */
  update(): void {
    if (!this.isOn || !this.#scene) return;
    const { triangleCount, fullTriangleCount } = this.#scene;
    const share = (count: number): string => `${formatCount(count)} triangles (${formatPercent(count / Math.max(fullTriangleCount, 1))})`;
    element('left-side').textContent = share(triangleCount);
    const second = this.triangleCount;
    const text = second === null ? 'preparing' : share(second);
    element('right-side').textContent = this.#other ? `${this.#other.name}: ${text}` : text;
  }

  showSecond(draw: () => void): void {
    const [scene, other] = [this.#scene, this.#other?.scene];
    if (scene && other) {
      [scene.visible, other.visible] = [false, true];
      draw();
      [scene.visible, other.visible] = [true, false];
      return;
    }
    const first = new Map<Mesh, BufferGeometry>();
    for (const [mesh, geometry] of this.#second) {
      first.set(mesh, mesh.geometry);
      shareVertices(mesh.geometry, geometry);
      mesh.geometry = geometry;
    }
    draw();
    for (const [mesh, geometry] of first) mesh.geometry = geometry;
  }

  #onSwitched(): void {
    const isOn = input('compare').checked && this.#isAvailable && this.#scene !== null;
    this.#stage.split = isOn ? this : null;
    if (isOn) void this.#request();
    else {
      this.#clear();
      if (this.#other) this.#setOther(null);
    }
    this.#refresh();
    this.#place();
    this.update();
    this.#host.onChange();
    this.#stage.invalidate();
  }

  #onSecondChanged(): void {
    this.#refresh();
    void this.#request();
  }

  async #onFileChosen(): Promise<void> {
    const picker = input('compared');
    const file = picker.files?.[0];
    // Lets the same file be chosen again.
    picker.value = '';
    const scene = this.#scene;
    if (!file || !scene) return;
    const other = await this.#host.open(file);
    if (!other) return;
    if (this.#scene === scene && this.isOn) this.#setOther({ scene: other, name: file.name });
    else other.dispose();
  }

  /** Shows another file at the right, or again a level of the model. */
  #setOther(other: { scene: StriataScene; name: string } | null): void {
    this.#other?.scene.removeFromParent();
    this.#other?.scene.dispose();
    this.#other = other;
    if (other) {
      const { scene } = other;
      scene.visible = false;
      this.#stage.pivot.add(scene);
      scene.addEventListener('change', () => {
        this.update();
        this.#stage.invalidate();
      });
      input('second').value = input('second').max;
    }
    element('compare-file').textContent = other ? `Close ${other.name}` : 'Compare with a file…';
    this.#onSecondChanged();
    this.update();
    this.#stage.invalidate();
  }

  #refresh(): void {
    const box = input('compare');
    box.disabled = !this.#isAvailable;
    setVisible('compare-row', this.isOn);
    for (const id of ['divider', 'left-side', 'right-side']) setVisible(id, this.isOn);
    const text = formatPercent(detailAt(input('second').valueAsNumber));
    input('second').setAttribute('aria-valuetext', text);
    element('second-value').textContent = text;
  }

  /** Moves the labels next to the divider. */
  #place(): void {
    element('stage').style.setProperty('--divider', String(this.#divider.fraction));
  }

  /** Makes the second level; while one is being made, only the last request is kept. */
  async #request(): Promise<void> {
    this.#requested += 1;
    if (this.#isPending) return;
    this.#isPending = true;
    try {
      for (let made = -1; made !== this.#requested && this.isOn; ) {
        made = this.#requested;
        await this.#make(detailAt(input('second').valueAsNumber));
      }
    } finally {
      this.#isPending = false;
    }
  }

  async #make(detail: number): Promise<void> {
    const scene = this.#scene;
    if (!scene) return;
    if (this.#other) {
      this.#other.scene.detail = detail;
      return;
    }
    const lists = await Promise.all(scene.lods.map((lod) => lod.indices({ detail })));
    if (this.#scene !== scene || !this.isOn) return;
    this.#clear();
    this.#triangleCount = 0;
    for (const [at, lod] of scene.lods.entries()) this.#add(lod, lists[at] ?? []);
    this.update();
    this.#stage.invalidate();
  }

  #add(lod: StriataLod, lists: readonly Uint32Array[]): void {
    for (const [at, mesh] of lod.meshes.entries()) {
      const indices = lists[at % Math.max(lists.length, 1)] ?? new Uint32Array(0);
      const geometry = new BufferGeometry().setIndex(new BufferAttribute(indices, 1));
      this.#second.set(mesh, geometry);
      this.#triangleCount = (this.#triangleCount ?? 0) + indices.length / 3;
    }
  }

  #clear(): void {
    for (const geometry of this.#second.values()) {
      // Disposing of a geometry also frees the buffers of its attributes, which belong to the mesh.
      for (const name of Object.keys(geometry.attributes)) geometry.deleteAttribute(name);
      geometry.dispose();
    }
    this.#second.clear();
    this.#triangleCount = null;
  }
}

/** Gives a geometry the vertices and bounds of another one. */
function shareVertices(from: BufferGeometry, to: BufferGeometry): void {
  for (const [name, attribute] of Object.entries(from.attributes)) {
    if (to.getAttribute(name) !== attribute) to.setAttribute(name, attribute);
  }
  to.morphAttributes = from.morphAttributes;
  to.morphTargetsRelative = from.morphTargetsRelative;
  to.boundingBox = from.boundingBox;
  to.boundingSphere = from.boundingSphere;
}
