/** Lets three.js' `GLTFLoader` refine meshes that have the extension `STRIATA_lod`. */

import type { Mesh, Object3D } from 'three';
import type { GLTF, GLTFLoader, GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import { connectSceneEngine, type EngineConnection } from './connection.ts';
import { fromPlain } from './error.ts';
import type { SceneOrder, SceneReport } from './scene/protocol.ts';
import { StriataScene } from './scene/scene.ts';
import type { LoaderOptions } from './types.ts';
import { wasmModule } from './wasm.ts';

const EXTENSION = 'STRIATA_lod';
const VERSION = 1;

/** The extension of a mesh. */
interface LodExtension {
  version: number;
  bufferView: number;
}

interface MeshDefinition {
  primitives: { mode?: number; attributes: Record<string, number> }[];
  extensions?: Record<string, unknown>;
}

/** Registers a plugin for meshes with streams, which replaces their coarse level as it decodes. Returns the loader. */
export function registerStriata(loader: GLTFLoader, options: LoaderOptions = {}): GLTFLoader {
  return loader.register((parser) => new LodPlugin(parser, options) as never);
}

/** Refines the meshes of one glTF file. */
class LodPlugin {
  readonly name = EXTENSION;
  readonly #parser: GLTFParser;
  readonly #options: LoaderOptions;
  readonly #extensions = new Map<number, LodExtension>();
  /** Places of the coarse geometries: mesh and primitive. */
  readonly #places = new Map<unknown, [mesh: number, primitive: number]>();

  constructor(parser: GLTFParser, options: LoaderOptions) {
    this.#parser = parser;
    this.#options = options;
    definitions(parser).forEach((mesh, index) => {
      const extension = mesh.extensions?.[EXTENSION] as LodExtension | undefined;
      if (!extension) return;
      if (extension.version === VERSION) this.#extensions.set(index, extension);
      else console.warn(`striata: meshes[${index}] has version ${extension.version} of ${EXTENSION}; its coarse level is shown`);
    });
  }

  /** Loads a mesh as usual, and remembers which geometries are to be replaced. */
  loadMesh(index: number): Promise<Object3D> | null {
    if (!this.#extensions.has(index)) return null;
    return (this.#parser as unknown as { loadMesh(index: number): Promise<Object3D> }).loadMesh(index).then((object) => {
      const primitives = definitions(this.#parser)[index]?.primitives ?? [];
      const parts = primitives.length === 1 ? [object] : object.children;
      let group = 0;
      primitives.forEach(({ mode = 4, attributes }, place) => {
        if (mode < 4 || mode > 6 || attributes['POSITION'] === undefined) return;
        const { geometry } = (parts[place] ?? {}) as Mesh;
        if (geometry) this.#places.set(geometry, [index, group]);
        group += 1;
      });
      return object;
    });
  }

  /** Starts decoding; the loader does not wait for it. */
  async afterRoot(gltf: GLTF): Promise<void> {
    if (this.#extensions.size === 0) return;
    const [module, streams] = await Promise.all([wasmModule(this.#options.wasm), this.#streams()]);
    const refinement = new Refinement(gltf, this.#places, module, this.#options);
    gltf.userData['striata'] = refinement.scene;
    refinement.start(streams);
  }

  async #streams(): Promise<Map<number, Uint8Array>> {
    const streams = new Map<number, Uint8Array>();
    for (const [mesh, { bufferView }] of this.#extensions) {
      const bytes = (await this.#parser.getDependency('bufferView', bufferView).catch(() => null)) as ArrayBuffer | null;
      if (bytes) streams.set(mesh, new Uint8Array(bytes));
      else console.warn(`striata: the stream of meshes[${mesh}] is missing; its coarse level is shown`);
    }
    return streams;
  }
}

/** Decodes the streams of a glTF file's meshes, and shows them in place of the coarse level. */
class Refinement {
  readonly scene: StriataScene;
  readonly #engine: EngineConnection<SceneOrder>;
  readonly #drawn = new Map<number, [Mesh, number][]>();
  readonly #shown = new Set<number>();
  #received = 0;

  constructor(gltf: GLTF, places: Map<unknown, [number, number]>, module: WebAssembly.Module, options: LoaderOptions) {
    for (const scene of gltf.scenes) {
      scene.traverse((object) => {
        const place = places.get((object as Mesh).geometry);
        if (!place) return;
        const [mesh, primitive] = place;
        this.#drawn.set(mesh, [...(this.#drawn.get(mesh) ?? []), [object as Mesh, primitive]]);
      });
    }
    const counts: number[] = [];
    for (const [mesh, primitive] of places.values()) counts[mesh] = Math.max(counts[mesh] ?? 0, primitive + 1);
    this.#engine = connectSceneEngine(module, options.worker ?? true, (report) => this.#take(report));
    this.scene = new StriataScene(counts, 'gltf', {
      send: (order) => this.#engine.send(order),
      bytes: () => ({ received: this.#received, total: this.#received }),
      dispose: () => this.#engine.dispose(),
    });
    if (options.pixelError !== null) this.scene.pixelError = options.pixelError ?? 1;
  }

  start(streams: Map<number, Uint8Array>): void {
    for (const [mesh, bytes] of streams) {
      this.#received += bytes.length;
      this.#engine.send({ type: 'bytes', bytes, mesh });
    }
    this.#engine.send({ type: 'end' });
  }

  #take(report: SceneReport): void {
    switch (report.type) {
      case 'meshes':
        this.scene.show(report.meshes, report.state, report.ticket, report.settled);
        for (const { mesh } of report.meshes) this.#replace(mesh);
        break;
      case 'indices':
      case 'step':
        this.scene.answer(report);
        break;
      case 'failed':
        console.warn(`striata: ${report.error.message}; the coarse level stays`);
        this.scene.end(fromPlain(report.error));
        break;
      case 'finished':
        this.scene.end();
        break;
    }
  }

  /** Gives the meshes the geometry that has been decoded, once. */
  #replace(index: number): void {
    const lod = this.scene.lodOf(index);
    if (!lod || this.#shown.has(index)) return;
    this.#shown.add(index);
    for (const [mesh, primitive] of this.#drawn.get(index) ?? []) {
      const geometry = lod.geometry.primitives[primitive];
      if (!geometry) continue;
      mesh.geometry.dispose();
      mesh.geometry = geometry;
      lod.attach(mesh);
    }
  }
}

function definitions(parser: GLTFParser): MeshDefinition[] {
  return (parser.json as { meshes?: MeshDefinition[] }).meshes ?? [];
}
