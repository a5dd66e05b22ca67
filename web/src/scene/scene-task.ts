/** Loads a scene: passes bytes to the engine as they arrive, and creates the scene as soon as all of it can be drawn. */

import { LoadingManager } from 'three';
import { iterable, type ByteChunks } from '../bytes.ts';
import { connectSceneEngine, type EngineConnection } from '../connection.ts';
import { aborted, asPlain, asStriataError, fromPlain, StriataError } from '../error.ts';
import type { Kind, LoaderOptions, OpenOptions, Phase } from '../types.ts';
import { GltfScene } from './gltf-scene.ts';
import type { SceneDocument, SceneOrder, SceneReport } from './protocol.ts';
import { filesModule } from '../wasm.ts';
import { StriataScene } from './scene.ts';

/** What a scene needs besides its bytes. */
export interface SceneContext {
  module: WebAssembly.Module;
  loader: LoaderOptions;
  options: OpenOptions;
  /** Where relative URLs of images begin. */
  path: string;
  manager: LoadingManager;
  kind: Kind;
  /** Aborted when no more bytes are needed. */
  download: AbortController;
}

/** Loads one scene from the bytes of its stream. */
export class SceneTask {
  readonly #context: SceneContext;
  readonly #stop = new AbortController();
  #engine: EngineConnection<SceneOrder> | undefined;
  #scene: StriataScene | undefined;
  #gltf: GltfScene | undefined;
  /** Reports are handled one after the other, because three.js' loader is asynchronous. */
  #queue: Promise<void> = Promise.resolve();
  #received = 0;
  #total: number | null;
  #resolve!: (scene: StriataScene) => void;
  #reject!: (error: StriataError) => void;

  constructor(context: SceneContext, total: number | null) {
    this.#context = context;
    this.#total = total;
  }

  /** Resolves as soon as the scene can be drawn. */
  run(chunks: ByteChunks): Promise<StriataScene> {
    const { download } = this.#context;
    const loaded = this.#begin();
    this.#receive(chunks).catch((thrown: unknown) => {
      if (download.signal.aborted) return;
      const error = asStriataError(thrown);
      if (error.code === 'aborted') this.#fail(error);
      else this.#engine?.send({ type: 'end', error: asPlain(error) });
    });
    return loaded;
  }

  /** Opens a whole `.striata` file. */
  async runStored(bytes: Uint8Array): Promise<StriataScene> {
    this.#received = bytes.length;
    const files = await filesModule(this.#context.loader);
    if (this.#context.download.signal.aborted) throw aborted();
    const loaded = this.#begin();
    this.#engine?.send({ type: 'stored', bytes, files });
    return loaded;
  }

  #begin(): Promise<StriataScene> {
    const { options, download, module, loader } = this.#context;
    const loaded = new Promise<StriataScene>((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    const abort = () => this.#fail(aborted());
    options.signal?.addEventListener('abort', abort, { once: true });
    download.signal.addEventListener('abort', () => options.signal?.removeEventListener('abort', abort));
    this.#engine = connectSceneEngine(module, loader.worker ?? true, (report) => this.#enqueue(report));
    return loaded;
  }

  async #receive(chunks: ByteChunks): Promise<void> {
    const { download } = this.#context;
    for await (const bytes of iterable(chunks)) {
      if (download.signal.aborted) return;
      this.#received += bytes.length;
      this.#engine?.send({ type: 'bytes', bytes });
      this.#progress();
    }
    if (download.signal.aborted) return;
    this.#total = this.#received;
    this.#engine?.send({ type: 'end' });
    this.#progress();
  }

  #enqueue(report: SceneReport): void {
    this.#queue = this.#queue.then(() => (this.#stop.signal.aborted ? undefined : this.#take(report))).catch((thrown: unknown) => {
      this.#fail(thrown instanceof Error && !(thrown instanceof StriataError) ? new StriataError('corrupt', thrown.message) : asStriataError(thrown));
    });
  }

  async #take(report: SceneReport): Promise<void> {
    switch (report.type) {
      case 'document':
        await this.#create(report);
        break;
      case 'meshes':
        this.#scene?.show(report.meshes, report.state, report.ticket, report.settled);
        break;
      case 'images':
        for (const image of report.images) await this.#gltf?.replaceImage(image, this.#context.manager).catch(warn);
        this.#scene?.dispatchEvent({ type: 'change' });
        break;
      case 'animations':
        await this.#animate(report.document);
        break;
      case 'indices':
      case 'step':
        this.#scene?.answer(report);
        break;
      case 'failed':
        this.#fail(fromPlain(report.error));
        break;
      case 'solid':
        this.#scene?.becomeSolid();
        break;
      case 'finished':
        this.#context.download.abort(aborted());
        this.#scene?.end();
        break;
    }
    this.#progress();
  }

  async #create({ document, meshes, state }: Extract<SceneReport, { type: 'document' }>): Promise<void> {
    const { loader, options, kind, path, manager } = this.#context;
    const scene = new StriataScene(GltfScene.primitiveCounts(document.json), kind, {
      send: (order) => this.#engine?.send(order),
      bytes: () => ({ received: this.#received, total: this.#total }),
      dispose: () => this.#close(),
    });
    scene.show(meshes, state, 0, true);
    const made = new GltfScene(document, (mesh) => scene.lodOf(mesh)?.geometry);
    const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
    const own = new GLTFLoader(manager);
    loader.configure?.(own);
    const gltf = await made.load(own, path);
    if (this.#stop.signal.aborted) return;
    scene.fill(gltf, made.drawn());
    scene.name = options.name ?? '';
    const pixelError = loader.pixelError === undefined ? 1 : loader.pixelError;
    if (pixelError === null) scene.detail = 1;
    else scene.pixelError = pixelError;
    [this.#scene, this.#gltf] = [scene, made];
    if (document.hasAnimations) scene.animate([]);
    this.#resolve(scene);
  }

  async #animate(document: SceneDocument): Promise<void> {
    this.#scene?.animate((await this.#gltf?.animations(document)) ?? []);
  }

  #progress(): void {
    const scene = this.#scene;
    const phase: Phase = scene?.phase ?? 'download';
    const progress = {
      bytesReceived: this.#received,
      bytesTotal: this.#total ?? (scene?.state.streamBytes || null),
      triangleCount: scene?.triangleCount ?? 0,
      vertexCount: scene?.vertexCount ?? 0,
      complete: scene?.complete ?? false,
      phase,
    };
    try {
      this.#context.options.onProgress?.(progress);
    } catch (thrown) {
      // An error in the caller's callback is reported as uncaught; loading continues.
      queueMicrotask(() => {
        throw thrown;
      });
    }
    scene?.dispatchEvent({ type: 'progress', progress });
  }

  /** Ends loading with an error. If there is a scene, it keeps what has loaded. */
  #fail(error: StriataError): void {
    if (this.#stop.signal.aborted) return;
    this.#scene?.end(error);
    if (this.#scene && error.code !== 'aborted') return this.#context.download.abort(aborted());
    this.#close();
    this.#reject(error);
  }

  #close(): void {
    this.#stop.abort(aborted());
    this.#context.download.abort(aborted());
    this.#engine?.dispose();
  }
}

function warn(thrown: unknown): void {
  console.warn('striata: an image of the scene could not be decoded; its preview stays', thrown);
}
