/**
 * Compares two levels of the model side by side: the stage is drawn twice, with a divider in between. The left part shows the level
 * that the panel selects, the right part a second one, as other index lists over the same vertices.
 */

import { BufferAttribute, BufferGeometry, type Mesh } from 'three';
import type { StriataLod, StriataScene } from '../src/index.ts';
import { Divider } from './divider.ts';
import { element, input, setVisible } from './dom.ts';
import { formatCount, formatPercent } from './format.ts';
import { detailAt } from './scales.ts';
import type { Split, Stage } from './stage.ts';

export class Comparison implements Split {
  readonly #stage: Stage;
  readonly #onChange: () => void;
  readonly #divider: Divider;
  #scene: StriataScene | null = null;
  #isAvailable = false;
  /** Geometry that each mesh has in the right part. */
  #second = new Map<Mesh, BufferGeometry>();
  /** Number of the last request for a level, and whether one is pending. */
  #requested = 0;
  #isPending = false;
  #triangleCount: number | null = null;

  /** `onChange` is called when comparing starts or ends. */
  constructor(stage: Stage, onChange: () => void) {
    this.#stage = stage;
    this.#onChange = onChange;
    this.#divider = new Divider(element('divider'), () => {
      this.#place();
      stage.invalidate();
    });
    input('compare').addEventListener('change', () => this.#onSwitched());
    input('second').addEventListener('input', () => this.#onSecondChanged());
    this.#refresh();
  }

  get isOn(): boolean {
    return this.#stage.split === this;
  }

  get fraction(): number {
    return this.#divider.fraction;
  }

  /** Triangles of the level in the right part; null until it has been made. */
  get triangleCount(): number | null {
    return this.#triangleCount;
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
    element('right-side').textContent = this.#triangleCount === null ? 'preparing' : share(this.#triangleCount);
  }

  showSecond(draw: () => void): void {
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
    else this.#clear();
    this.#refresh();
    this.#place();
    this.update();
    this.#onChange();
    this.#stage.invalidate();
  }

  #onSecondChanged(): void {
    this.#refresh();
    void this.#request();
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
