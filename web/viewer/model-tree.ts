/**
 * The parts of a scene as nested lists: nodes, meshes with their triangle counts, and materials. A node can be hidden, and the camera
 * moved to it. Lists are filled when they are unfolded, because a scene can have many thousands of nodes.
 */

import { Mesh, type Material, type Object3D } from 'three';
import type { StriataLod, StriataScene } from '../src/index.ts';
import { announce, createNode, element, setVisible } from './dom.ts';
import { formatCount } from './format.ts';
import { describeMaterial } from './material-facts.ts';

/** Longer lists are cut off. */
const MAX_ROWS = 500;

/** Nodes that are unfolded at first, while they have no more parts than this. */
const MAX_OPEN_ROWS = 12;

/** Paths of the icons, 24 x 24. */
const ICONS = {
  fold: 'm9 6 6 6-6 6',
  focus: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
  eye: 'M2 12s4-6.5 10-6.5S22 12 22 12s-4 6.5-10 6.5S2 12 2 12zm7 0a3 3 0 1 0 6 0 3 3 0 0 0-6 0z',
};

/** What the tree does with the stage. */
export interface TreeActions {
  /** Moves the camera to an object. */
  focus(object: Object3D): void;
  /** Called after an object was hidden or shown. */
  onVisibility(): void;
}

export class ModelTree {
  readonly #actions: TreeActions;
  readonly #list = element('tree');
  /** Counters of the meshes that are listed. */
  #counts: { counter: PartCounter; node: HTMLElement }[] = [];
  #hidden = new Set<Object3D>();
  /** Objects that are drawn, and their ancestors. Others, such as bones, are not listed. */
  #parts = new Set<Object3D>();

  constructor(actions: TreeActions) {
    this.#actions = actions;
    element('show-all').addEventListener('click', () => this.#showAll());
    this.#list.addEventListener('keydown', (event) => this.#onKey(event));
  }

  /** Lists the parts of another scene. */
  setScene(scene: StriataScene | null): void {
    this.#counts = [];
    this.#hidden.clear();
    this.#list.replaceChildren();
    setVisible('show-all', false);
    setVisible('model-set', scene !== null);
    if (!scene) return;
    this.#parts = partsOf(scene);
    this.#fill(this.#list, this.#roots(scene), 0);
  }

  /** Updates the numbers of triangles. */
  update(): void {
    for (const { counter, node } of this.#counts) {
      const text = counter.text();
      if (node.textContent !== text) node.textContent = text;
    }
  }

  /** The first objects worth listing: a nameless parent of all others says nothing. */
  #roots(scene: StriataScene): Object3D[] {
    const roots = this.#children(scene);
    const [only] = roots;
    if (!only || roots.length > 1 || only.name !== '' || isDrawn(only)) return roots;
    return this.#children(only);
  }

  #children(object: Object3D): Object3D[] {
    return object.children.filter((child) => this.#parts.has(child));
  }

  /** Lists objects; of a long list only its beginning. */
  #fill(list: HTMLElement, objects: readonly Object3D[], depth: number): void {
    for (const object of objects.slice(0, MAX_ROWS)) list.append(this.#row(object, depth));
    if (objects.length > MAX_ROWS) list.append(createNode('li', 'note', `and ${formatCount(objects.length - MAX_ROWS)} more`));
  }

  #row(object: Object3D, depth: number): HTMLLIElement {
    const item = createNode('li');
    const row = createNode('div', 'part');
    const name = nameOf(object);
    const parts = this.#children(object);
    const materials = materialsOf(object);
    const children = createNode('ul');
    // Lists without bullets are no lists for some screen readers.
    children.setAttribute('role', 'list');
    children.setAttribute('aria-label', `Parts of ${name}`);
    children.hidden = true;
    item.append(row);
    if (parts.length + materials.length > 0) {
      row.append(this.#foldButton(name, children, () => {
        for (const material of materials) children.append(materialRow(material));
        this.#fill(children, parts, depth + 1);
      }));
      item.append(children);
      const isShort = parts.length + materials.length <= MAX_OPEN_ROWS;
      if (isShort && depth < 2) row.querySelector('button')?.click();
    } else {
      row.append(createNode('span', 'no-fold'));
    }
    row.append(this.#nameButton(object, name), this.#eyeButton(object, name));
    return item;
  }

  #foldButton(name: string, children: HTMLElement, fill: () => void): HTMLButtonElement {
    const button = iconButton('fold', ICONS.fold, `Parts of ${name}`);
    button.setAttribute('aria-expanded', 'false');
    button.addEventListener('click', () => {
      const isOpen = children.hidden;
      if (isOpen && children.childElementCount === 0) fill();
      children.hidden = !isOpen;
      button.setAttribute('aria-expanded', String(isOpen));
    });
    return button;
  }

  /** The name, which moves the camera to the object, and its number of triangles. */
  #nameButton(object: Object3D, name: string): HTMLButtonElement {
    const button = createNode('button', 'name');
    button.type = 'button';
    button.title = `Move the camera to ${name}`;
    button.append(createNode('span', '', name));
    const lod = lodOf(object);
    if (lod && object instanceof Mesh) {
      const counter = new PartCounter(object, lod);
      const count = createNode('small', '', counter.text());
      this.#counts.push({ counter, node: count });
      button.append(count);
    }
    button.addEventListener('click', () => {
      this.#actions.focus(object);
      announce(`Camera moved to ${name}`);
    });
    return button;
  }

  #eyeButton(object: Object3D, name: string): HTMLButtonElement {
    const button = iconButton('eye', ICONS.eye, `Show ${name}`);
    const refresh = (): void => button.setAttribute('aria-pressed', String(object.visible));
    button.addEventListener('click', () => {
      object.visible = !object.visible;
      if (object.visible) this.#hidden.delete(object);
      else this.#hidden.add(object);
      this.#onVisibility();
      announce(`${name} ${object.visible ? 'shown' : 'hidden'}`);
    });
    button.addEventListener('striata-refresh', refresh);
    refresh();
    return button;
  }

  #showAll(): void {
    for (const object of this.#hidden) object.visible = true;
    this.#hidden.clear();
    this.#onVisibility();
    announce('All parts shown');
  }

  #onVisibility(): void {
    for (const button of this.#list.querySelectorAll('.eye')) button.dispatchEvent(new Event('striata-refresh'));
    setVisible('show-all', this.#hidden.size > 0);
    this.#actions.onVisibility();
  }

  /** Arrow keys move between rows, and fold and unfold them. */
  #onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const row = (event.target as HTMLElement).closest<HTMLElement>('.part');
    if (!row) return;
    const fold = row.querySelector<HTMLButtonElement>('.fold');
    const isOpen = fold?.getAttribute('aria-expanded') === 'true';
    const rows = [...this.#list.querySelectorAll<HTMLElement>('.part')].filter((row) => row.offsetParent !== null);
    const at = rows.indexOf(row);
    const goTo = (target: Element | null | undefined): void => target?.querySelector<HTMLElement>('.name')?.focus();
    if (event.key === 'ArrowDown') goTo(rows[at + 1]);
    else if (event.key === 'ArrowUp') goTo(rows[at - 1]);
    else if (event.key === 'Home') goTo(rows[0]);
    else if (event.key === 'End') goTo(rows.at(-1));
    else if (event.key === 'ArrowRight') {
      if (fold && !isOpen) fold.click();
      else goTo(row.nextElementSibling?.querySelector('.part'));
    } else if (event.key === 'ArrowLeft') {
      if (fold && isOpen) fold.click();
      else goTo(row.closest('ul')?.previousElementSibling);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

/** Drawn objects and their ancestors. */
function partsOf(root: Object3D): Set<Object3D> {
  const parts = new Set<Object3D>();
  root.traverse((object) => {
    if (!isDrawn(object)) return;
    for (let part: Object3D | null = object; part && part !== root && !parts.has(part); part = part.parent) parts.add(part);
  });
  return parts;
}

function isDrawn(object: Object3D): boolean {
  return object instanceof Mesh || 'isLine' in object || 'isPoints' in object;
}

function lodOf(object: Object3D): StriataLod | null {
  return (object as { lod?: StriataLod }).lod ?? null;
}

function materialsOf(object: Object3D): Material[] {
  return object instanceof Mesh ? [object.material as Material | Material[]].flat() : [];
}

/** Counts the triangles that a part draws: of a mesh with several materials, each part draws its own share. */
class PartCounter {
  readonly #mesh: Mesh;
  readonly #lod: StriataLod;
  /** Number of triangles at the full level, once it has been shown. */
  #full: number | null = null;

  constructor(mesh: Mesh, lod: StriataLod) {
    this.#mesh = mesh;
    this.#lod = lod;
  }

  text(): string {
    const { triangleCount, fullTriangleCount, meshes } = this.#lod;
    const isWhole = new Set(meshes.map(({ geometry }) => geometry)).size === 1;
    const shown = isWhole ? triangleCount : this.#drawnCount();
    if (triangleCount >= fullTriangleCount) this.#full = shown;
    const full = isWhole ? fullTriangleCount : this.#full;
    return full === null || shown >= full ? formatCount(shown) : `${formatCount(shown)} of ${formatCount(full)}`;
  }

  #drawnCount(): number {
    const { drawRange, index, attributes } = this.#mesh.geometry;
    return Math.min(drawRange.count, (index ?? attributes.position!).count - drawRange.start) / 3;
  }
}

/** Name of an object, or of what it is. */
function nameOf(object: Object3D): string {
  return object.name || (object instanceof Mesh ? 'Mesh' : 'Node');
}

function materialRow(material: Material): HTMLLIElement {
  const { name, color, details } = describeMaterial(material);
  const item = createNode('li', 'material');
  const swatch = createNode('i', 'swatch');
  swatch.style.background = color;
  const text = createNode('span', '', name);
  text.append(createNode('small', '', details.join(' · ')));
  item.append(swatch, text);
  return item;
}

function iconButton(className: string, path: string, label: string): HTMLButtonElement {
  const button = createNode('button', className);
  button.type = 'button';
  button.setAttribute('aria-label', label);
  button.title = label;
  button.innerHTML = `<svg aria-hidden="true" viewBox="0 0 24 24"><path d="${path}"/></svg>`;
  return button;
}
