/**
 * Picks a triangle with Shift and a click, or with a click while the switch is on: shows its mesh, material and number, the
 * nearest of its vertices, and the step that adds it. The mark stays on the triangle while it moves, and goes when the level no longer has it.
 */

import {
  BufferAttribute, BufferGeometry, InstancedMesh, type Intersection, LineBasicMaterial, LineLoop, type Material, Matrix4, Mesh, type Object3D,
  Points, PointsMaterial, Raycaster, Vector2, Vector3,
} from 'three';
import type { StriataLod, StriataScene, VertexStep } from '../src/index.ts';
import { announce, createNode, element, input, setVisible } from './dom.ts';
import { formatCount, formatNumber } from './format.ts';
import type { Inspection } from './inspection.ts';
import { HELPER_LAYER, type Stage } from './stage.ts';

/** A pointer that moves farther than this drags, CSS pixels. */
const CLICK_PX = 5;

/** The mark: a color that few models have, and the size of the dot at the vertex in pixels. */
const MARK = { color: 0xe0218a, depthTest: false, transparent: true, toneMapped: false };
const DOT_PX = 9;

interface Picked {
  mesh: Mesh;
  geometry: BufferGeometry;
  /** Number of the triangle in the list that is drawn. */
  triangle: number;
  corners: [number, number, number];
  /** Which corner is the nearest. */
  nearest: number;
  /** Which copy of the mesh it is, if there are several. */
  instance: number | undefined;
  /** Whether it is in the right part of a comparison. */
  isSecond: boolean;
}

export class Picking {
  readonly #stage: Stage;
  readonly #model: () => StriataScene | null;
  readonly #inspection: Inspection;
  readonly #mark: LineLoop<BufferGeometry, LineBasicMaterial>;
  readonly #dot: Points<BufferGeometry, PointsMaterial>;
  #picked: Picked | null = null;
  #down: { x: number; y: number } | null = null;

  constructor(stage: Stage, model: () => StriataScene | null, inspection: Inspection) {
    this.#stage = stage;
    this.#model = model;
    this.#inspection = inspection;
    const corners = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(9), 3));
    this.#mark = new LineLoop(corners, new LineBasicMaterial(MARK));
    this.#dot = new Points(new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(3), 3)), new PointsMaterial({ ...MARK, size: DOT_PX, sizeAttenuation: false }));
    this.#mark.add(this.#dot);
    for (const part of [this.#mark, this.#dot]) {
      part.layers.set(HELPER_LAYER);
      part.frustumCulled = false;
    }
    this.#mark.visible = false;
    stage.scene.add(this.#mark);
    stage.beforeFrame.add(() => this.#follow());
    const canvas = stage.renderer.domElement;
    canvas.addEventListener('pointerdown', (event) => this.#onDown(event));
    canvas.addEventListener('pointerup', (event) => this.#onUp(event));
    element('unpick').addEventListener('click', () => this.clear());
  }

  /** Forgets the triangle. */
  clear(): void {
    this.#picked = null;
    this.#mark.visible = false;
    setVisible('picked', false);
    this.#stage.invalidate();
  }

  #onDown({ isPrimary, button, clientX, clientY }: PointerEvent): void {
    this.#down = isPrimary && button === 0 ? { x: clientX, y: clientY } : null;
  }

  #onUp({ clientX, clientY, shiftKey }: PointerEvent): void {
    const down = this.#down;
    this.#down = null;
    if (!down || Math.hypot(clientX - down.x, clientY - down.y) > CLICK_PX) return;
    if (shiftKey || input('pick').checked) this.pick(clientX, clientY);
  }

  /** Picks the triangle at a point of the window. */
  pick(x: number, y: number): void {
    const model = this.#model();
    if (!model) return;
    const { split, camera, renderer } = this.#stage;
    const { left, top, width, height } = renderer.domElement.getBoundingClientRect();
    const at = new Vector2((x - left) / width, (y - top) / height);
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(2 * at.x - 1, 1 - 2 * at.y), camera);
    const isSecond = split !== null && at.x > split.fraction;
    let hit: Intersection | undefined;
    const shown = (isSecond && split.other) || model;
    const find = (): void => {
      hit = firstHit(this.#inspection.mesh ?? shown, ray);
      if (hit) this.#show(shown, hit, isSecond);
    };
    if (isSecond) split.showSecond(find);
    else find();
    if (hit) return;
    this.clear();
    announce('No triangle here');
  }

  #show(model: StriataScene, { object, face, faceIndex, instanceId, point }: Intersection, isSecond: boolean): void {
    const mesh = object as Mesh;
    const { a, b, c, materialIndex } = face!;
    const picked: Picked = { mesh, geometry: mesh.geometry, triangle: faceIndex!, corners: [a, b, c], nearest: 0, instance: instanceId, isSecond };
    const corners = cornersOf(picked);
    const nearest = corners.reduce((best, corner, at) => (corner.distanceTo(point) < corners[best]!.distanceTo(point) ? at : best), 0);
    picked.nearest = nearest;
    const rows: [string, string][] = [['Mesh', nameOf(mesh, model)]];
    const material = [mesh.material as Material | Material[]].flat()[materialIndex];
    // Triangles in colors have a material of the page and corners of their own, so that their vertices have no numbers.
    const isSurface = mesh.geometry.index !== null && mesh !== this.#inspection.mesh;
    if (isSurface) rows.push(['Material', material?.name || 'unnamed']);
    rows.push(['Triangle', `${formatCount(picked.triangle)} of this level`]);
    const corner = picked.corners[nearest]!;
    const inspected = this.#inspection.stepOf(mesh, corner);
    if (inspected) rows.push([inspected.primitive, formatCount(this.#inspection.primitiveOf(picked.triangle) ?? 0)]);
    if (isSurface || inspected) rows.push(['Nearest vertex', formatCount(inspected?.vertex ?? corner)]);
    if (inspected) rows.push(...stepRows(inspected.step));
    const { diagonal } = model;
    rows.push(['Vertex at', pointText(model.worldToLocal(corners[nearest]!.clone()), diagonal)]);
    rows.push(['Point at', pointText(model.worldToLocal(point.clone()), diagonal)]);
    this.#picked = picked;
    this.#mark.visible = true;
    this.#place(picked, corners);
    this.#list(rows);
    this.#stage.invalidate();
    const { lod } = mesh as Mesh & { lod?: StriataLod };
    if (!isSurface || !lod) return;
    void lod.stepOf(corner).then((step) => {
      if (this.#picked !== picked) return;
      rows.push(...stepRows(step));
      this.#list(rows);
    });
  }

  #list(rows: [string, string][]): void {
    const nodes = rows.map(([name, value]) => {
      const row = createNode('div');
      row.append(createNode('dt', '', name), createNode('dd', '', value));
      return row;
    });
    element('picked-facts').replaceChildren(...nodes);
    setVisible('picked', true);
    announce(rows.map((row) => row.join(' ')).join(', '));
  }

  /** Keeps the mark on the triangle of a moving mesh. */
  #follow(): boolean {
    const picked = this.#picked;
    if (!picked) return false;
    const { split } = this.#stage;
    let remains = false;
    const look = (): void => void (remains = isDrawn(picked));
    if (!picked.isSecond) look();
    else split?.showSecond(look);
    if (remains) this.#place(picked, cornersOf(picked));
    else this.clear();
    return false;
  }

  #place({ nearest }: Picked, corners: Vector3[]): void {
    const positions = this.#mark.geometry.getAttribute('position') as BufferAttribute;
    corners.forEach(({ x, y, z }, at) => positions.setXYZ(at, x, y, z));
    const dot = this.#dot.geometry.getAttribute('position') as BufferAttribute;
    dot.setXYZ(0, ...(corners[nearest] ?? new Vector3()).toArray());
    for (const attribute of [positions, dot]) attribute.needsUpdate = true;
  }
}

/** Rows about the step that adds a vertex. */
function stepRows(step: VertexStep | null): [string, string][] {
  if (!step) return [['Step', 'in the base mesh']];
  return [['Step', formatCount(step.step)], ['Error without it', formatNumber(step.error)]];
}

/** The nearest triangle of what is shown. */
function firstHit(model: Object3D, ray: Raycaster): Intersection | undefined {
  const drawn: Object3D[] = [];
  model.traverseVisible((object) => {
    if (object instanceof Mesh) drawn.push(object);
  });
  return ray.intersectObjects(drawn, false).find(({ face, faceIndex }) => face && typeof faceIndex === 'number');
}

/** Whether the level that is shown still has a triangle. */
function isDrawn({ mesh, geometry, triangle, corners }: Picked): boolean {
  const { index, drawRange } = mesh.geometry;
  if (!isShown(mesh) || mesh.geometry !== geometry) return false;
  const end = Math.min(drawRange.start + drawRange.count, (index ?? geometry.getAttribute('position')).count);
  return 3 * triangle + 2 < end && (index === null || corners.every((vertex, i) => index.getX(3 * triangle + i) === vertex));
}

/** Corners of a triangle in its current pose, in world space. */
function cornersOf({ mesh, corners, instance }: Picked): Vector3[] {
  mesh.updateWorldMatrix(true, false);
  const toWorld = mesh.matrixWorld.clone();
  if (instance !== undefined && mesh instanceof InstancedMesh) {
    const own = new Matrix4();
    mesh.getMatrixAt(instance, own);
    toWorld.multiply(own);
  }
  return corners.map((vertex) => mesh.getVertexPosition(vertex, new Vector3()).applyMatrix4(toWorld));
}

function isShown(object: Object3D): boolean {
  let part: Object3D | null = object;
  while (part?.visible && part.parent) part = part.parent;
  return part?.visible === true && 'isScene' in part;
}

/** Name of a mesh, or of the nearest of its parents that has one. */
function nameOf(mesh: Mesh, model: StriataScene): string {
  for (let part: Object3D | null = mesh; part && part !== model; part = part.parent) if (part.name) return part.name;
  return 'unnamed';
}

/** Coordinates as exact as single precision keeps them. */
function pointText(point: Vector3, diagonal: number): string {
  const decimals = Math.min(Math.max(6 - Math.ceil(Math.log10(diagonal || 1)), 0), 20);
  return point.toArray().map((value) => String(Number(value.toFixed(decimals)))).join(', ');
}
