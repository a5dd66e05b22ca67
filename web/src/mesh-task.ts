/** Loads a single mesh: passes bytes to the engine as they arrive, and creates a mesh as soon as there is something to draw. */

import { LoadingManager } from 'three';
import { iterable, open } from './bytes.ts';
import { contentOf, type Content } from './content.ts';
import { aborted, asPlain, asStriataError, fromPlain, StriataError } from './error.ts';
import { connectEngine, connectPagedEngine, type EngineConnection } from './connection.ts';
import { StriataMesh, type LoaderHandle } from './mesh.ts';
import { nameOf, placeOf, type PagedPlace } from './paged/ranges.ts';
import { mergedArrays } from './plain/arrays.ts';
import { readFile, wholeFile } from './plain/open.ts';
import type { Order, Report } from './protocol.ts';
import type { LoaderOptions, LoadOptions, Source } from './types.ts';
import { builderModule, filesModule, start, wasmModule } from './wasm.ts';

/** Loads one model. */
export class MeshTask {
  readonly #loader: LoaderOptions;
  readonly #options: LoadOptions;
  /** Cancels loading altogether. */
  readonly #stop = new AbortController();
  /** Cancels only the download. */
  readonly #download = new AbortController();
  #engine: EngineConnection<Order> | undefined;
  #mesh: StriataMesh | undefined;
  /** Whether the engine receives only the stream inside a larger file. */
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
    const loaded = this.#begin();
    this.#fetch(source).catch((thrown: unknown) => this.#onSourceError(asStriataError(thrown)));
    return loaded;
  }

  #begin(): Promise<StriataMesh> {
    const { signal } = this.#options;
    const abort = () => this.#fail(aborted());
    signal?.addEventListener('abort', abort, { once: true });
    // Aborting the signal after loading has finished has no effect.
    this.#download.signal.addEventListener('abort', () => signal?.removeEventListener('abort', abort));
    return new Promise<StriataMesh>((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
  }

  async #fetch(source: Source): Promise<void> {
    const [module, opened] = await Promise.all([
      wasmModule(this.#loader.wasm),
      open(source, this.#options.name, this.#download.signal),
    ]);
    if (this.#stop.signal.aborted) return;
    // The page itself parses the headers of containers.
    start(module);
    this.#total = opened.length;
    const content = await contentOf(opened);
    if (this.#stop.signal.aborted) return;
    if (content.kind === 'scene') {
      throw new StriataError('unsupported', 'this is a scene, not a single mesh', 'use `loader.loadAsync(url)`');
    }
    if (content.kind === 'stream') return this.#receive(module, content);
    if (content.kind === 'paged') return this.#openPaged(module, placeOf(source, opened.name));
    const file = await wholeFile(content, opened.name, this.#download.signal, (received) => {
      this.#received = received;
      this.#progress();
    });
    if (file.stream) return this.#receive(module, file.stream);
    const context = { module, loader: this.#loader, options: {}, path: '', manager: new LoadingManager(), kind: 'mesh' as const, download: this.#download };
    const arrays = mergedArrays(await readFile(file, context));
    const builder = await builderModule(this.#loader);
    if (this.#stop.signal.aborted) return;
    this.#total = this.#received;
    this.#engine = connectEngine(module, this.#loader.worker ?? true, (report) => this.#onMessage(report));
    this.#engine.send({ type: 'arrays', arrays, builder });
  }

  /** Loads a source that has been opened. */
  runContent(module: WebAssembly.Module, content: Content, download: AbortController): Promise<StriataMesh> {
    download.signal.addEventListener('abort', () => this.#download.abort());
    const loaded = this.#begin();
    this.#receive(module, content).catch((thrown: unknown) => this.#onSourceError(asStriataError(thrown)));
    return loaded;
  }

  /** Loads a paged file, whose engine fetches what it needs. */
  runPaged(module: WebAssembly.Module, place: PagedPlace, download: AbortController): Promise<StriataMesh> {
    download.signal.addEventListener('abort', () => this.#download.abort());
    const loaded = this.#begin();
    this.#openPaged(module, place).catch((thrown: unknown) => this.#onSourceError(asStriataError(thrown)));
    return loaded;
  }

  async #openPaged(module: WebAssembly.Module, place: PagedPlace): Promise<void> {
    const files = await filesModule(this.#loader);
    if (this.#stop.signal.aborted) return;
    [this.#received, this.#total] = [0, null];
    const engine = connectPagedEngine(module, this.#loader.worker ?? true, (report) => this.#onMessage(report));
    this.#engine = engine;
    engine.send({ type: 'open', place, name: nameOf(place), module: files });
  }

  async #receive(module: WebAssembly.Module, content: Content): Promise<void> {
    this.#received = 0;
    this.#total = content.byteCount;
    this.#isInContainer = content.isInContainer;
    this.#engine = connectEngine(module, this.#loader.worker ?? true, (report) => this.#onMessage(report));
    for await (const bytes of iterable(content.chunks)) {
      if (this.#download.signal.aborted) return;
      this.#received += bytes.length;
      this.#engine.send({ type: 'bytes', bytes });
      this.#progress();
    }
    if (this.#download.signal.aborted) return;
    this.#total = this.#received;
    this.#engine.send({ type: 'end' });
    this.#progress();
  }

  /** The source failed; the part that has arrived may still be usable. */
  #onSourceError(error: StriataError): void {
    if (this.#download.signal.aborted) return;
    if (this.#engine && error.code !== 'aborted') this.#engine.send({ type: 'end', error: asPlain(error) });
    else this.#fail(error);
  }

  #onMessage(report: Report): void {
    if (this.#stop.signal.aborted) return;
    switch (report.type) {
      case 'update':
        if (this.#isInContainer) report.state.kind = 'striata';
        this.#received = report.state.receivedBytes ?? this.#received;
        if (this.#mesh) {
          this.#mesh.update(report);
        } else if (report.indices.length > 0 || report.state.complete) {
          this.#mesh = new StriataMesh(report, this.#options.material, this.#handle());
          this.#mesh.name = this.#options.name ?? '';
          this.#resolve(this.#mesh);
        }
        this.#progress();
        break;
      case 'accepted':
        this.#mesh?.accept(report.ticket);
        break;
      case 'step':
        this.#mesh?.answerStep(report.step);
        break;
      case 'building':
        this.#progress('build', report.share);
        break;
      case 'failed':
        this.#fail(fromPlain(report.error));
        break;
      case 'damaged':
        this.#mesh?.dispatchEvent({ type: 'error', error: fromPlain(report.error) });
        break;
      case 'solid':
        this.#mesh?.becomeSolid();
        break;
      case 'finished':
        this.#download.abort(aborted());
        this.#mesh?.end();
        this.#progress();
        break;
    }
  }

  /** The interface through which the mesh controls loading. */
  #handle(): LoaderHandle {
    return {
      send: (order) => this.#engine?.send(order),
      bytes: () => ({ received: this.#received, total: this.#total }),
      dispose: () => this.#close(),
    };
  }

  #progress(phase?: 'build', share?: number): void {
    const state = this.#mesh?.state;
    const progress = {
      bytesReceived: this.#received,
      bytesTotal: this.#total ?? (state?.streamBytes || null),
      triangleCount: state?.triangleCount ?? 0,
      vertexCount: state?.vertexCount ?? 0,
      complete: state?.complete ?? false,
      phase: phase ?? state?.phase ?? 'download',
      ...(share === undefined ? {} : { share }),
    };
    try {
      this.#options.onProgress?.(progress);
    } catch (thrown) {
      // An error in the caller's callback is reported as uncaught; loading continues.
      queueMicrotask(() => {
        throw thrown;
      });
    }
    this.#mesh?.dispatchEvent({ type: 'progress', progress });
  }

  /** Ends loading with an error. If there is a mesh, it keeps what has loaded. */
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
    this.#engine?.dispose();
  }
}
