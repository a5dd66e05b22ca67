/** Presents a single mesh as a scene. */

import { Group, type Mesh } from 'three';
import type { LevelRequest } from '../protocol.ts';
import type { StriataMesh } from '../mesh.ts';
import type { Coloring, LevelTarget, LoaderOptions, Phase, StriataLod, Timings, VertexStep } from '../types.ts';
import { StriataScene } from './scene.ts';

/** Returns a scene whose only mesh is this one. */
export function sceneOfMesh(mesh: StriataMesh, { pixelError = 1 }: LoaderOptions): StriataScene {
  const scene = new MeshScene(mesh);
  if (pixelError !== null) scene.pixelError = pixelError;
  // All of a paged file would be too much.
  else if (mesh.kind === 'paged') scene.pixelError = 1;
  return scene;
}

/** A scene with a single mesh, which does everything itself. */
class MeshScene extends StriataScene {
  readonly #mesh: StriataMesh;

  constructor(mesh: StriataMesh) {
    super([], mesh.kind, { send: () => undefined, bytes: () => ({ received: mesh.bytesReceived, total: mesh.bytesTotal }), dispose: () => undefined });
    this.#mesh = mesh;
    (mesh as StriataMesh & { lod?: StriataLod }).lod = new MeshLod(mesh);
    this.lods = [(mesh as StriataMesh & { lod: StriataLod }).lod];
    this.scenes = [new Group().add(mesh)];
    this.add(this.scenes[0]!);
    this.end();
    this.finished = mesh.finished;
    mesh.addEventListener('change', () => this.dispatchEvent({ type: 'change' }));
    mesh.addEventListener('progress', ({ progress }) => this.dispatchEvent({ type: 'progress', progress }));
    mesh.addEventListener('error', ({ error }) => this.dispatchEvent({ type: 'error', error }));
  }

  override get isSolid(): boolean { return this.#mesh.isSolid; }
  override get isZUp(): boolean { return this.#mesh.isZUp; }
  override get detail(): number { return this.#mesh.detail; }
  override set detail(detail: number) { this.#mesh.detail = detail; }
  override get triangleBudget(): number | null { return this.#mesh.triangleBudget; }
  override set triangleBudget(budget: number | null) { this.#mesh.triangleBudget = budget; }
  override get maxError(): number | null { return this.#mesh.maxError; }
  override set maxError(error: number | null) { this.#mesh.maxError = error; }
  override get pixelError(): number | null { return this.#mesh.pixelError; }
  override set pixelError(pixels: number | null) { this.#mesh.pixelError = pixels; }
  override get frozen(): boolean { return this.#mesh.frozen; }
  override set frozen(frozen: boolean) { this.#mesh.frozen = frozen; }
  override get coloring(): Coloring { return this.#mesh.coloring; }
  override set coloring(coloring: Coloring) { this.#mesh.coloring = coloring; }
  override get wireframe(): boolean { return this.#mesh.wireframe; }
  override set wireframe(wireframe: boolean) { this.#mesh.wireframe = wireframe; }
  override get triangleCount(): number { return this.#mesh.triangleCount; }
  override get fullTriangleCount(): number { return this.#mesh.fullTriangleCount; }
  override get vertexCount(): number { return this.#mesh.vertexCount; }
  override get splitCount(): number { return this.#mesh.splitCount; }
  override get stepCount(): number { return this.#mesh.stepCount; }
  override get error(): number { return this.#mesh.error; }
  override get complete(): boolean { return this.#mesh.complete; }
  override get phase(): Phase { return this.#mesh.state.phase; }
  override get diagonal(): number { return this.#mesh.diagonal; }
  override get timings(): Readonly<Timings> { return this.#mesh.timings; }

  override dispose(): void {
    this.#mesh.dispose();
    super.dispose();
  }
}

/** The levels of a single mesh. */
class MeshLod implements StriataLod {
  readonly meshes: readonly Mesh[];
  readonly #mesh: StriataMesh;

  constructor(mesh: StriataMesh) {
    this.#mesh = mesh;
    this.meshes = [mesh as unknown as Mesh];
  }

  get detail(): number { return this.#mesh.detail; }
  set detail(detail: number) { this.#mesh.detail = detail; }
  get triangles(): number | null { return this.#mesh.triangleBudget; }
  set triangles(count: number | null) { this.#mesh.triangleBudget = count; }
  get error(): number | null { return this.#mesh.maxError; }
  set error(error: number | null) { this.#mesh.maxError = error; }
  get pixelError(): number | null { return this.#mesh.pixelError; }
  set pixelError(pixels: number | null) { this.#mesh.pixelError = pixels; }
  get triangleCount(): number { return this.#mesh.triangleCount; }
  get fullTriangleCount(): number { return this.#mesh.fullTriangleCount; }
  get shownError(): number { return this.#mesh.error; }

  indices({ error, triangles, detail }: LevelTarget): Promise<Uint32Array[]> {
    const request: LevelRequest = error !== undefined
      ? { by: 'error', value: error, limit: 0 }
      : triangles !== undefined ? { by: 'triangles', value: triangles, limit: 0 } : { by: 'detail', value: detail ?? 1, limit: 0 };
    return this.#mesh.indicesOf(request);
  }

  stepOf(vertex: number): Promise<VertexStep | null> { return this.#mesh.stepOf(vertex); }

  /** Copies of a single mesh share its geometry, but only the mesh itself chooses levels. */
  attach(): void {}
}
