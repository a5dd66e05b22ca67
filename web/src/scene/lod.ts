/** The levels of one glTF mesh, shared by all of its nodes. */

import { Box3, Matrix4, Mesh, Sphere, SkinnedMesh, Vector2, Vector3, type Camera, type Object3D, type PerspectiveCamera, type WebGLRenderer } from 'three';
import type { LevelRequest } from '../protocol.ts';
import type { LevelTarget, StriataLod, VertexStep } from '../types.ts';
import { viewOf } from '../view.ts';
import { LodGeometry, posedBox } from './lod-geometry.ts';
import type { MeshShare, MeshUpdate } from './protocol.ts';

/** What a lod needs of the scene that it belongs to. */
export interface LodOwner {
  /** Called when a lod needs another level. */
  changed(): void;
  /** Called when a lod is about to be drawn. */
  seen(): void;
  /** Whether levels stay as they are, whatever is seen. */
  readonly frozen: boolean;
  indices(mesh: number, request: LevelRequest): Promise<Uint32Array[]>;
  stepOf(mesh: number, vertex: number): Promise<VertexStep | null>;
}

const [size, center, scale, matrix, sphere] = [new Vector2(), new Vector3(), new Vector3(), new Matrix4(), new Sphere()];

/** Levels of one glTF mesh. */
export class SceneLod implements StriataLod {
  /** Index of the glTF mesh. */
  readonly index: number;
  readonly geometry: LodGeometry;
  readonly meshes: Mesh[] = [];
  last: MeshUpdate | undefined;
  readonly #owner: LodOwner;
  /** A level of its own; null if the scene chooses it. */
  #own: { by: 'detail' | 'triangles' | 'error'; value: number } | null = null;
  /** Tolerance of its own; null if the scene chooses it. */
  #pixelError: number | null = null;
  /** Pixels per unit of the mesh, at its nearest instance, in the current and in the last complete frame. */
  #seenNow = 0;
  #pixelsPerUnit = 0;
  #view: LevelRequest | undefined;

  constructor(index: number, primitiveCount: number, owner: LodOwner) {
    this.index = index;
    this.geometry = new LodGeometry(primitiveCount);
    this.#owner = owner;
  }

  get detail(): number {
    if (this.#own?.by === 'detail') return this.#own.value;
    return this.last && this.last.stepCount > 0 ? this.last.splitCount / this.last.stepCount : 1;
  }

  set detail(detail: number) {
    this.#show({ by: 'detail', value: Math.min(1, Math.max(0, number(detail, 'detail'))) });
  }

  get triangles(): number | null {
    return this.#own?.by === 'triangles' ? this.#own.value : null;
  }

  set triangles(count: number | null) {
    this.#show(count === null ? null : { by: 'triangles', value: Math.min(0xffffffff, Math.max(1, Math.floor(number(count, 'triangles')))) });
  }

  get error(): number | null {
    return this.#own?.by === 'error' ? this.#own.value : null;
  }

  set error(error: number | null) {
    this.#show(error === null ? null : { by: 'error', value: Math.max(0, number(error, 'error')) });
  }

  get pixelError(): number | null {
    return this.#pixelError;
  }

  set pixelError(pixels: number | null) {
    this.#pixelError = pixels === null ? null : Math.max(0, number(pixels, 'pixelError'));
    this.#own = null;
    this.#owner.changed();
  }

  get triangleCount(): number {
    return this.last ? this.last.groupCounts.reduce((sum, count) => sum + count, 0) : 0;
  }

  get fullTriangleCount(): number {
    return this.last?.fullTriangleCount ?? 0;
  }

  get shownError(): number {
    return this.last?.error ?? 0;
  }

  /** Indices of a level for each primitive, over the attributes that all levels share. */
  indices(target: LevelTarget): Promise<Uint32Array[]> {
    const { detail, triangles, error } = target;
    if (error !== undefined) return this.#owner.indices(this.index, { by: 'error', value: number(error, 'error'), limit: 0 });
    if (triangles !== undefined) return this.#owner.indices(this.index, { by: 'triangles', value: number(triangles, 'triangles'), limit: 0 });
    return this.#owner.indices(this.index, { by: 'detail', value: number(detail ?? 1, 'detail'), limit: 0 });
  }

  /** The step that adds a vertex; null for vertices of the base mesh. */
  stepOf(vertex: number): Promise<VertexStep | null> {
    return this.#owner.stepOf(this.index, number(vertex, 'vertex'));
  }

  /** Makes a mesh with one of this lod's geometries part of it: its size on the screen then counts. */
  attach(mesh: Mesh): void {
    if (this.meshes.includes(mesh)) return;
    this.meshes.push(mesh);
    (mesh as Mesh & { lod?: StriataLod }).lod = this;
    mesh.onBeforeRender = (renderer, _scene, camera) => this.#see(mesh, renderer as WebGLRenderer, camera);
    if ((mesh as SkinnedMesh).isSkinnedMesh) this.#boundPosed(mesh as SkinnedMesh);
  }

  /** Number of times that the triangles of a primitive are drawn. */
  get instanceCount(): number {
    const drawn = this.meshes.reduce((sum, mesh) => sum + ((mesh as Mesh & { count?: number }).count ?? 1), 0);
    return Math.max(1, Math.round(drawn / Math.max(1, this.geometry.primitives.length)));
  }

  /** Largest factor from units of the mesh to units of the world. */
  get worldScale(): number {
    return this.meshes.reduce((most, mesh) => Math.max(most, scaleOf(mesh)), 0) || 1;
  }

  /** Ends a frame: what was seen in it counts until something else is seen. Returns whether that differs much. */
  endFrame(): boolean {
    if (this.#seenNow === 0) return false;
    const ratio = this.#seenNow / (this.#pixelsPerUnit || Number.MIN_VALUE);
    this.#seenNow = ratio > 1.04 || ratio < 0.96 ? ((this.#pixelsPerUnit = this.#seenNow), 0) : 0;
    return ratio > 1.04 || ratio < 0.96;
  }

  /** This mesh's part of a target of the scene; `usesPixels` if its tolerance is in pixels. */
  share(usesPixels: boolean, tolerance: number): MeshShare {
    const instances = this.instanceCount;
    const base = { mesh: this.index, instances };
    if (this.#own) return { ...base, scale: 1, request: { ...this.#own, limit: 0 } };
    if (this.#pixelError !== null) {
      const value = this.#pixelsPerUnit > 0 ? this.#pixelError / this.#pixelsPerUnit : Number.MAX_VALUE;
      return { ...base, scale: 1, request: { by: 'error', value, limit: 0 } };
    }
    if (usesPixels && this.#view && this.isSingle) return { ...base, scale: 1, request: { ...this.#view, value: tolerance / (this.#view.value || 1) } };
    return { ...base, scale: usesPixels ? this.#pixelsPerUnit : this.worldScale };
  }

  /** Whether one rigid instance is drawn, so that parts of it can have different levels. */
  get isSingle(): boolean {
    const [first] = this.meshes;
    const isRigid = (mesh: Mesh) => !(mesh as SkinnedMesh).isSkinnedMesh && !mesh.morphTargetInfluences && !('isInstancedMesh' in mesh);
    const isTogether = (mesh: Mesh) => mesh === first || mesh.parent === first?.parent;
    return this.meshes.length <= this.geometry.primitives.length && this.meshes.every((mesh) => isRigid(mesh) && isTogether(mesh));
  }

  /** Notes how large the mesh is for a camera that is about to draw it. */
  #see(mesh: Mesh, renderer: WebGLRenderer, camera: Camera): void {
    if (this.#owner.frozen) return;
    const target = renderer.getRenderTarget();
    if (target) size.set(target.width, target.height);
    else renderer.getDrawingBufferSize(size);
    const pixels = pixelsPerUnit(mesh, camera, size.y);
    if (!(pixels > this.#seenNow)) return;
    this.#seenNow = pixels;
    const view = this.isSingle ? viewOf(mesh, camera, size.x, size.y) : undefined;
    this.#view = view?.kind === 'perspective' ? { by: 'view', value: view.stretch, limit: 0, camera: view.numbers } : undefined;
    this.#owner.seen();
  }

  /** Request for the camera of the last frame, if parts of the mesh can have different levels. */
  get view(): LevelRequest | undefined {
    return this.#view;
  }

  #show(own: { by: 'detail' | 'triangles' | 'error'; value: number } | null): void {
    this.#own = own;
    this.#pixelError = null;
    this.#owner.changed();
  }

  /** Bounds of a skinned mesh follow its pose; three.js would compute them once. */
  #boundPosed(mesh: SkinnedMesh): void {
    const box = () => posedBox(this.geometry, mesh.bindMatrix, mesh.bindMatrixInverse, mesh.skeleton.bones, mesh.skeleton.boneInverses);
    mesh.computeBoundingBox = () => void (mesh.boundingBox ??= new Box3());
    mesh.computeBoundingSphere = () => undefined;
    const [posed, ball] = [new Box3(), new Sphere()];
    Object.defineProperty(mesh, 'boundingBox', { configurable: true, get: () => posed.copy(box()), set: () => undefined });
    Object.defineProperty(mesh, 'boundingSphere', { configurable: true, get: () => box().getBoundingSphere(ball), set: () => undefined });
  }
}

/** Largest factor from units of a mesh to units of the world. */
function scaleOf(mesh: Mesh): number {
  matrix.copy(mesh.matrixWorld);
  const skinned = mesh as SkinnedMesh;
  const [bone, inverse] = [skinned.skeleton?.bones[0], skinned.skeleton?.boneInverses[0]];
  if (skinned.isSkinnedMesh && bone && inverse) matrix.multiply(skinned.bindMatrixInverse).multiply(bone.matrixWorld).multiply(inverse).multiply(skinned.bindMatrix);
  scale.setFromMatrixScale(matrix);
  return Math.max(scale.x, scale.y, scale.z);
}

/** Pixels that a unit of a mesh covers at its point nearest to the camera. */
function pixelsPerUnit(mesh: Mesh, camera: Camera, height: number): number {
  const projection = Math.abs(camera.projectionMatrix.elements[5]!) * (height / 2) * scaleOf(mesh);
  if (!(camera as PerspectiveCamera).isPerspectiveCamera) return projection;
  const own = (mesh as Object3D & { boundingSphere?: Sphere | null }).boundingSphere ?? mesh.geometry.boundingSphere;
  if (!own) return 0;
  sphere.copy(own).applyMatrix4(mesh.matrixWorld);
  const distance = center.setFromMatrixPosition(camera.matrixWorld).distanceTo(sphere.center) - sphere.radius;
  return projection / Math.max(distance, (camera as PerspectiveCamera).near, 1e-6 * sphere.radius);
}

function number(value: number, name: string): number {
  if (Number.isNaN(Number(value))) throw new TypeError(`${name} must be a number, not ${String(value)}`);
  return Number(value);
}
