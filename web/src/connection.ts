/** A connection to an engine in a worker or on the page; both behave the same. */

import { Engine } from './engine.ts';
import { StriataError, asPlain, type PlainError } from './error.ts';
import { PagedEngine, type PagedOrder } from './paged/engine.ts';
import type { Order, Report } from './protocol.ts';
import type { SceneOrder, SceneReport } from './scene/protocol.ts';
import { SceneEngine } from './scene/scene-engine.ts';
import { start } from './wasm.ts';
import DecodingWorker from './worker.ts?worker&inline';

/** Decoding on the page must not block rendering noticeably. */
const PAGE_SLICE_MS = 6;

export interface EngineConnection<O> {
  /** Sends an order to the engine. */
  send(order: O): void;
  dispose(): void;
}

/** What both kinds of engines have in common. */
interface AnyEngine<O> {
  take(order: O): void;
  dispose(): void;
}

/** Starts an engine of a single mesh whose reports are passed to `report`. */
export function connectEngine(module: WebAssembly.Module, useWorker: boolean, report: (report: Report) => void): EngineConnection<Order> {
  const onPage = () => connectOnPage<Order, Report>(module, report, (send) => new Engine(send, PAGE_SLICE_MS));
  return (useWorker && connectWorker<Order, Report>(module, 'mesh', report)) || onPage();
}

/** Starts an engine of a paged file. */
export function connectPagedEngine(module: WebAssembly.Module, useWorker: boolean, report: (report: Report) => void): EngineConnection<PagedOrder> {
  const onPage = () => connectOnPage<PagedOrder, Report>(module, report, (send) => new PagedEngine(send));
  return (useWorker && connectWorker<PagedOrder, Report>(module, 'paged', report)) || onPage();
}

/** Starts an engine of a scene. */
export function connectSceneEngine(
  module: WebAssembly.Module, useWorker: boolean, report: (report: SceneReport) => void,
): EngineConnection<SceneOrder> {
  const onPage = () => connectOnPage<SceneOrder, SceneReport>(module, report, (send) => new SceneEngine(send, PAGE_SLICE_MS));
  return (useWorker && connectWorker<SceneOrder, SceneReport>(module, 'scene', report)) || onPage();
}

/** Returns undefined if workers are not available. */
function connectWorker<O, R>(
  module: WebAssembly.Module, engine: 'mesh' | 'paged' | 'scene', report: (report: R | { type: 'failed'; error: PlainError }) => void,
): EngineConnection<O> | undefined {
  let worker: Worker;
  try {
    worker = new DecodingWorker();
    worker.postMessage({ type: 'start', module, engine });
  } catch {
    return undefined;
  }
  worker.onmessage = ({ data }: MessageEvent<R>) => report(data);
  worker.onerror = (event) => {
    event.preventDefault();
    const message = event.message || 'the worker could not start';
    const error = new StriataError('unsupported', `the worker failed: ${message}`, 'try the option `worker: false`');
    report({ type: 'failed', error: asPlain(error) });
  };
  return {
    // Bytes are copied, not transferred: a chunk may share its buffer with others.
    send: (order) => worker.postMessage(order),
    dispose: () => worker.terminate(),
  };
}

function connectOnPage<O, R>(
  module: WebAssembly.Module, report: (report: R) => void, create: (report: (report: R) => void) => AnyEngine<O>,
): EngineConnection<O> {
  start(module);
  let isDisposed = false;
  // Reports are always asynchronous, as they are with a worker.
  const defer = (work: () => void) => queueMicrotask(() => void (isDisposed || work()));
  const engine = create((what) => defer(() => report(what)));
  return {
    send: (order) => defer(() => engine.take(order)),
    dispose: () => {
      isDisposed = true;
      engine.dispose();
    },
  };
}
