/** The loader for three.js: scenes, single meshes, and files without levels. */

import { Loader as ThreeLoader, LoaderUtils, LoadingManager } from 'three';
import { open as openSource } from './bytes.ts';
import { contentOf } from './content.ts';
import { aborted, asStriataError } from './error.ts';
import type { StriataMesh } from './mesh.ts';
import { MeshTask } from './mesh-task.ts';
import { placeOf } from './paged/ranges.ts';
import { openWhole, wholeFile } from './plain/open.ts';
import { sceneOfMesh } from './scene/mesh-scene.ts';
import { SceneTask } from './scene/scene-task.ts';
import type { StriataScene } from './scene/scene.ts';
import type { LoaderOptions, LoadOptions, OpenOptions, Source } from './types.ts';
import { filesModule, start, wasmModule } from './wasm.ts';

/** Creates a loader, with or without `new`. */
export interface StriataLoaderConstructor {
  /** @deprecated Use `new`. */
  (options?: LoaderOptions): StriataLoaderInstance;
  new (manager?: LoadingManager | LoaderOptions, options?: LoaderOptions): StriataLoaderInstance;
  readonly prototype: StriataLoaderInstance;
}

/** A loader that creates `StriataScene` objects. */
export interface StriataLoaderInstance extends ThreeLoader<StriataScene> {
  /** Screen error of every scene, in pixels, until it is set otherwise; `null` shows everything that has loaded. */
  pixelError: number | null;
  /**
     * Loads a model. `onLoad` is called as soon as all of it can be drawn, textured by previews, with its animations; everything else
     * streams in.
     */
  load(
    url: string, onLoad: ((scene: StriataScene) => void) | undefined, onProgress?: (event: ProgressEvent) => void, onError?: (error: unknown) => void,
  ): void;
  /** @deprecated Loads a single mesh. Use `loadAsync` or `open`. */
  load(source: Source, options?: LoadOptions): Promise<StriataMesh>;
  loadAsync(url: string, onProgress?: (event: ProgressEvent) => void): Promise<StriataScene>;
  parse(data: ArrayBuffer, onLoad: (scene: StriataScene) => void, onError?: (error: unknown) => void): void;
  parseAsync(data: ArrayBuffer, name?: string): Promise<StriataScene>;
  /** Loads a model from any source. Resolves as soon as all of it can be drawn; animations may follow. */
  open(source: Source, options?: OpenOptions): Promise<StriataScene>;
}

class SceneLoader extends ThreeLoader<StriataScene> {
  pixelError: number | null;
  readonly #options: LoaderOptions;

  constructor(manager?: LoadingManager | LoaderOptions, options?: LoaderOptions) {
    const isManager = manager !== undefined && 'itemStart' in manager;
    super(isManager ? manager : undefined);
    this.#options = (isManager ? options : (manager as LoaderOptions | undefined)) ?? options ?? {};
    this.pixelError = this.#options.pixelError === undefined ? 1 : this.#options.pixelError;
  }

  override load(...words: unknown[]): void;
  override load(...words: unknown[]): unknown {
    const [source, second, onProgress, onError] = words;
    if (![second, onProgress, onError].some((word) => typeof word === 'function')) return new MeshTask(this.#options, (second ?? {}) as LoadOptions).run(source as Source);
    const onLoad = second as ((scene: StriataScene) => void) | undefined;
    this.#loadUrl(source as string, onProgress as ((event: ProgressEvent) => void) | undefined).then(
      (scene) => onLoad?.(scene),
      (error: unknown) => {
        if (typeof onError === 'function') onError(error);
        else console.error(error);
      },
    );
    return undefined;
  }

  override loadAsync(url: string, onProgress?: (event: ProgressEvent) => void): Promise<StriataScene> {
    return this.#loadUrl(url, onProgress);
  }

  parse(data: ArrayBuffer, onLoad: (scene: StriataScene) => void, onError?: (error: unknown) => void): void {
    this.parseAsync(data).then(onLoad, onError ?? ((error: unknown) => console.error(error)));
  }

  async parseAsync(data: ArrayBuffer, name?: string): Promise<StriataScene> {
    return withAnimations(await this.open(data, name === undefined ? {} : { name }));
  }

  async open(source: Source, options: OpenOptions = {}): Promise<StriataScene> {
    const { signal } = options;
    if (signal?.aborted) throw aborted();
    const download = new AbortController();
    const abort = () => download.abort(aborted());
    signal?.addEventListener('abort', abort, { once: true });
    try {
      return await this.#open(source, options, download);
    } catch (thrown) {
      throw signal?.aborted ? aborted() : asStriataError(thrown);
    } finally {
      signal?.removeEventListener('abort', abort);
    }
  }

  async #open(source: Source, options: OpenOptions, download: AbortController): Promise<StriataScene> {
    const address = this.#address(source);
    const credentials = this.withCredentials ? 'include' : 'same-origin';
    const [module, opened] = await Promise.all([
      wasmModule(this.#options.wasm),
      openSource(address, options.name, download.signal, { headers: this.requestHeader as Record<string, string>, credentials }),
    ]);
    // The page itself parses the headers of containers.
    start(module);
    const content = await contentOf(opened);
    const loader = { ...this.#options, pixelError: this.pixelError };
    const path = this.resourcePath || (typeof address === 'string' ? LoaderUtils.extractUrlBase(address) : '');
    const context = { module, loader, options, path, manager: this.manager, download };
    if (content.kind === 'paged') {
      const place = placeOf(address, opened.name, this.requestHeader as Record<string, string>, credentials);
      return sceneOfMesh(await new MeshTask(loader, options).runPaged(module, place, download), loader);
    }
    if (content.kind === 'scene') return new SceneTask({ ...context, kind: 'stream' }, content.byteCount).run(content.chunks);
    if (content.kind === 'gltf' || content.kind === 'file' || content.kind === 'stored') {
      // The module is needed as soon as the file has arrived; opening the file reports what fails.
      if (content.kind === 'stored') filesModule(this.#options).catch(() => undefined);
      const total = opened.length;
      const file = await wholeFile(content, opened.name, download.signal, (received) => options.onProgress?.({
        bytesReceived: received, bytesTotal: total, triangleCount: 0, vertexCount: 0, complete: false, phase: 'download',
      }));
      if (!file.stream) return openWhole(file, { ...context, kind: 'mesh' });
      if (file.stream.kind === 'scene') return new SceneTask({ ...context, kind: 'stream' }, file.stream.byteCount).run(file.stream.chunks);
      return sceneOfMesh(await new MeshTask(loader, options).runContent(module, file.stream, download), loader);
    }
    const mesh = await new MeshTask(loader, options).runContent(module, content, download);
    return sceneOfMesh(mesh, loader);
  }

  /** The URL that a source is requested from; other sources stay as they are. */
  #address(source: Source): Source {
    if (typeof source !== 'string' && !(source instanceof URL)) return source;
    return this.manager.resolveURL(LoaderUtils.resolveURL(String(source), this.path));
  }

  async #loadUrl(url: string, onProgress?: (event: ProgressEvent) => void): Promise<StriataScene> {
    const { manager } = this;
    manager.itemStart(url);
    const report = ({ bytesReceived, bytesTotal }: { bytesReceived: number; bytesTotal: number | null }) => {
      const init = { lengthComputable: bytesTotal !== null, loaded: bytesReceived, total: bytesTotal ?? 0 };
      onProgress?.(typeof ProgressEvent === 'undefined' ? (init as ProgressEvent) : new ProgressEvent('progress', init));
    };
    try {
      return await withAnimations(await this.open(url, { onProgress: report }));
    } catch (error) {
      manager.itemError(url);
      throw error;
    } finally {
      manager.itemEnd(url);
    }
  }
}

/** Waits for the animations of a scene, which callers expect to be there. */
async function withAnimations(scene: StriataScene): Promise<StriataScene> {
  await scene.animated;
  return scene;
}

// A class can be called only with `new`; today's calls without it continue to work.
export const StriataLoader = new Proxy(SceneLoader, {
  apply: (_target, _this, words: [LoaderOptions?]) => new SceneLoader(...words),
}) as unknown as StriataLoaderConstructor;
// Frameworks compare the two to recognize a class.
SceneLoader.prototype.constructor = StriataLoader as unknown as typeof SceneLoader;

