/** Loads models: bytes to the engine as they come, a mesh as soon as there is something to draw. */

import { concatenated, iterable, open } from './bytes.ts';
import { contentOf } from './content.ts';
import { aborted, asPlain, asStriataError, fromPlain, StriataError } from './error.ts';
import { link, type Link } from './link.ts';
import { StriataMesh } from './mesh.ts';
import type { Report } from './protocol.ts';
import type { Loader, LoaderOptions, LoadOptions, Source } from './types.ts';
import { start, wasmModule } from './wasm.ts';

/** Makes loaders: `await StriataLoader().load(url)`; with `new` it is the same. */
export interface StriataLoaderConstructor {
  (options?: LoaderOptions): StriataLoaderInstance;
  new (options?: LoaderOptions): StriataLoaderInstance;
}

/** A loader whose meshes are known to be `StriataMesh`. */
export interface StriataLoaderInstance extends Loader {
  load(source: Source, options?: LoadOptions): Promise<StriataMesh>;
}

function makeLoader(options: LoaderOptions = {}): StriataLoaderInstance {
  return {
    load: (source, loadOptions = {}) => new Loading(options, loadOptions).run(source),
  };
}

// A plain function can be called in both ways, where a class cannot.
export const StriataLoader = function (options?: LoaderOptions) {
  return makeLoader(options);
} as unknown as StriataLoaderConstructor;

/** One model that is being loaded. */
class Loading {
  readonly #loader: LoaderOptions;
  readonly #options: LoadOptions;
  /** Ends everything. */
  readonly #stop = new AbortController();
  /** Ends the download alone. */
  readonly #download = new AbortController();
  #link: Link | undefined;
  #mesh: StriataMesh | undefined;
  /** Whether the engine only sees the stream of a larger file. */
  #isInContainer = false;
  #received = 0;
  #total: number | null = null;
  #resolve!: (mesh: StriataMesh) => void;
  #reject!: (error: StriataError) => void;

  constructor(loader: LoaderOptions, options: LoadOptions) {
    this.#loader = loader;
    this.#options = options;
  }

  run(source: Source): Promise<StriataMesh> {
    const { signal } = this.#options;
    if (signal?.aborted) return Promise.reject(aborted());
    const loaded = new Promise<StriataMesh>((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    const abort = () => this.#fail(aborted());
    signal?.addEventListener('abort', abort, { once: true });
    // What has been loaded lives on, whatever becomes of the signal.
    this.#download.signal.addEventListener('abort', () => signal?.removeEventListener('abort', abort));
    this.#fetch(source).catch((thrown: unknown) => this.#breakOff(asStriataError(thrown)));
    return loaded;
  }

  async #fetch(source: Source): Promise<void> {
    const [module, opened] = await Promise.all([
      wasmModule(this.#loader.wasm),
      open(source, this.#options.name, this.#download.signal),
    ]);
    if (this.#stop.signal.aborted) return;
    // The page itself looks into heads of containers.
    start(module);
    this.#total = opened.length;
    const content = await contentOf(opened);
    if (this.#stop.signal.aborted) return;
    this.#total = content.byteCount;
    this.#isInContainer = content.isInContainer;
    this.#link = link(module, this.#loader.worker ?? true, (report) => this.#hear(report));
    const parts: Uint8Array[] = [];
    for await (const bytes of iterable(content.pieces)) {
      if (this.#download.signal.aborted) return;
      this.#received += bytes.length;
      if (content.isStream) this.#link.order({ type: 'bytes', bytes });
      else parts.push(bytes);
      this.#progress();
    }
    if (this.#download.signal.aborted) return;
    this.#total = this.#received;
    if (content.isStream) this.#link.order({ type: 'end' });
    else this.#link.order({ type: 'file', bytes: concatenated(parts), name: opened.name || 'the file' });
    this.#progress();
  }

  /** The source failed: what has come of it may be something nevertheless. */
  #breakOff(error: StriataError): void {
    if (this.#download.signal.aborted) return;
    if (this.#link && error.code !== 'aborted') this.#link.order({ type: 'end', error: asPlain(error) });
    else this.#fail(error);
  }

  #hear(report: Report): void {
    if (this.#stop.signal.aborted) return;
    switch (report.type) {
      case 'update':
        if (this.#isInContainer) report.state.kind = 'striata';
        if (this.#mesh) {
          this.#mesh.update(report);
        } else if (report.indices.length > 0 || report.state.complete) {
          this.#mesh = new StriataMesh(report, this.#options.material, this.#mind());
          this.#mesh.name = this.#options.name ?? '';
          this.#resolve(this.#mesh);
        }
        this.#progress();
        break;
      case 'building':
        this.#progress('build');
        break;
      case 'failed':
        this.#fail(fromPlain(report.error));
        break;
      case 'finished':
        this.#download.abort(aborted());
        this.#mesh?.end();
        this.#progress();
        break;
    }
  }

  /** What the mesh needs of us. */
  #mind() {
    return {
      order: (order: Parameters<Link['order']>[0]) => this.#link?.order(order),
      bytes: () => ({ received: this.#received, total: this.#total }),
      dispose: () => this.#close(),
    };
  }

  #progress(phase?: 'build'): void {
    const state = this.#mesh?.state;
    const progress = {
      bytesReceived: this.#received,
      bytesTotal: this.#total ?? (state?.streamBytes || null),
      triangleCount: state?.triangleCount ?? 0,
      vertexCount: state?.vertexCount ?? 0,
      complete: state?.complete ?? false,
      phase: phase ?? state?.phase ?? 'download',
    };
    try {
      this.#options.onProgress?.(progress);
    } catch (thrown) {
      // The caller's fault, to be told as one; the model comes in all the same.
      queueMicrotask(() => {
        throw thrown;
      });
    }
    this.#mesh?.dispatchEvent({ type: 'progress', progress });
  }

  /** Ends loading; a mesh that is there stays, with what it has. */
  #fail(error: StriataError): void {
    if (this.#stop.signal.aborted) return;
    if (this.#mesh && error.code !== 'aborted') {
      this.#download.abort(aborted());
      this.#mesh.end(error);
      return;
    }
    this.#mesh?.end(error);
    this.#close();
    this.#reject(error);
  }

  #close(): void {
    this.#stop.abort(aborted());
    this.#download.abort(aborted());
    this.#link?.dispose();
  }
}
