/**
 * Builds levels for a file that three.js' loaders have read, and shows them in its meshes. Large files are shown before they have
 * levels.
 */

import type { BufferGeometry, Mesh, MeshStandardMaterial } from 'three';
import { connectSceneEngine, type EngineConnection } from '../connection.ts';
import { aborted, asStriataError, fromPlain, type StriataError } from '../error.ts';
import type { SceneOrder, SceneReport, SceneState } from '../scene/protocol.ts';
import { StriataScene } from '../scene/scene.ts';
import type { SceneContext } from '../scene/scene-task.ts';
import { builderModule } from '../wasm.ts';
import { inputOf, meshesOf, triangleCountOf, unitsOf, type Unit } from './arrays.ts';
import { noTriangles, type ReadFile } from './read.ts';

/** Files with more triangles are shown before their levels are built, which takes seconds. */
const MIN_SHOWN_FIRST = 200_000;

/** State of a scene whose levels are being built. */
const BUILDING: SceneState = { phase: 'build', complete: false, streamBytes: 0, decodeMs: 0, buildMs: 0, updateMs: 0 };

/** Builds one scene. */
export class BuildTask {
  readonly #context: SceneContext;
  readonly #byteCount: number;
  #engine: EngineConnection<SceneOrder> | undefined;
  #scene: StriataScene | undefined;
  /** Built meshes, by their index. */
  readonly #built = new Set<number>();
  #resolve!: () => void;
  #reject!: (error: StriataError) => void;

  constructor(context: SceneContext, byteCount: number) {
    this.#context = context;
    this.#byteCount = byteCount;
  }

  /** Resolves when all levels have been built; with many triangles, as soon as these can be drawn. */
  async run(file: ReadFile): Promise<StriataScene> {
    const { module, loader, options } = this.#context;
    const meshes = meshesOf(file.scenes);
    const units = unitsOf(meshes, keysOf(file), options.smooth ?? !file.gltf);
    if (units.length === 0 && !file.gltf) throw noTriangles();
    this.#engine = connectSceneEngine(module, loader.worker ?? true, (report) => this.#take(report, units));
    const scene = new StriataScene(units.map(({ geometries }) => geometries.length), 'mesh', {
      send: (order) => this.#engine?.send(order),
      bytes: () => ({ received: this.#byteCount, total: this.#byteCount }),
      dispose: () => this.#engine?.dispose(),
    });
    this.#scene = scene;
    if (units.reduce((sum, { arrays }) => sum + triangleCountOf(arrays), 0) > MIN_SHOWN_FIRST) {
      scene.show(units.map(({ arrays }, unit) => inputOf(arrays, unit)), BUILDING, 0, false);
      units.forEach((_, unit) => this.#built.add(unit));
      this.#fill(scene, file, meshes, units);
      // If levels cannot be built, the triangles stay.
      this.#build(units).then(() => scene.end(), (thrown: unknown) => scene.end(asStriataError(thrown)));
      return scene;
    }
    try {
      await this.#build(units);
    } catch (thrown) {
      this.#engine.dispose();
      throw thrown;
    }
    this.#fill(scene, file, meshes, units);
    scene.end();
    return scene;
  }

  /** Resolves when all levels have been built. */
  async #build(units: readonly Unit[]): Promise<void> {
    const { loader, download } = this.#context;
    const builder = await builderModule(loader);
    if (download.signal.aborted) throw aborted();
    const built = new Promise<void>((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    const abort = () => this.#reject(aborted());
    download.signal.addEventListener('abort', abort, { once: true });
    this.#engine?.send({ type: 'build', meshes: units.map(({ arrays }) => arrays), builder });
    await built.finally(() => download.signal.removeEventListener('abort', abort));
  }

  #fill(scene: StriataScene, file: ReadFile, meshes: readonly Mesh[], units: readonly Unit[]): void {
    const { loader, options } = this.#context;
    scene.fill(file, this.#replaced(meshes, units));
    scene.name = options.name ?? '';
    const pixelError = loader.pixelError === undefined ? 1 : loader.pixelError;
    if (pixelError === null) scene.detail = 1;
    else scene.pixelError = pixelError;
  }

  /** Gives meshes the geometries with levels. */
  *#replaced(meshes: readonly Mesh[], units: readonly Unit[]): Generator<[Mesh, number]> {
    const places = new Map<BufferGeometry, [number, number]>();
    units.forEach(({ geometries }, unit) => geometries.forEach((geometry, group) => places.set(geometry, [unit, group])));
    for (const mesh of meshes) {
      const [unit, group] = places.get(mesh.geometry) ?? [-1, 0];
      const geometry = this.#built.has(unit) ? this.#scene?.lodOf(unit)?.geometry.primitives[group] : undefined;
      if (!geometry) continue;
      if (units[unit]!.arrays.isSmooth) for (const material of [mesh.material].flat()) (material as MeshStandardMaterial).flatShading = false;
      mesh.geometry = geometry;
      yield [mesh, unit];
    }
    for (const geometry of places.keys()) geometry.dispose();
  }

  #take(report: SceneReport, units: readonly Unit[]): void {
    const scene = this.#scene!;
    switch (report.type) {
      case 'building':
        this.#progress(report.share);
        break;
      case 'unbuilt':
        console.warn(`striata: mesh ${report.mesh} of ${units.length} has no levels: ${report.error.message}`);
        break;
      case 'meshes':
        for (const { mesh } of report.meshes) this.#built.add(mesh);
        scene.show(report.meshes, report.state, report.ticket, report.settled);
        break;
      case 'indices':
      case 'step':
        scene.answer(report);
        break;
      case 'failed':
        this.#reject(fromPlain(report.error));
        break;
      case 'solid':
        scene.becomeSolid();
        break;
      case 'finished':
        this.#resolve();
        this.#progress(1);
        break;
    }
  }

  #progress(share: number): void {
    const { complete, phase } = this.#scene!.state;
    const [triangleCount, vertexCount] = [this.#scene!.fullTriangleCount, this.#scene!.vertexCount];
    const progress = { bytesReceived: this.#byteCount, bytesTotal: this.#byteCount, triangleCount, vertexCount, complete, phase: complete ? phase : 'build' as const, share };
    try {
      this.#context.options.onProgress?.(progress);
    } catch (thrown) {
      // An error in the caller's callback is reported as uncaught; loading continues.
      queueMicrotask(() => {
        throw thrown;
      });
    }
  }
}

/** What meshes must have in common to be built together: the mesh of the file. */
function keysOf({ gltf }: ReadFile): (mesh: Mesh) => unknown {
  if (!gltf) return (mesh) => mesh.userData['striataMesh'];
  const associations = gltf.parser.associations as Map<unknown, { meshes?: number }>;
  return (mesh) => associations.get(mesh)?.meshes;
}
