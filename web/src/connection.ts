/** A connection to an engine in a worker or on the page; both behave the same. */

import { Engine } from './engine.ts';
import { StriataError, asPlain } from './error.ts';
import type { Order, Report } from './protocol.ts';
import { start } from './wasm.ts';
import DecodingWorker from './worker.ts?worker&inline';

/** Decoding on the page must not block rendering noticeably. */
const PAGE_SLICE_MS = 6;

export interface EngineConnection {
  /** Sends an order to the engine. */
  send(order: Order): void;
  dispose(): void;
}

/** Starts an engine whose reports are passed to `report`. */
export function connectEngine(module: WebAssembly.Module, useWorker: boolean, report: (report: Report) => void): EngineConnection {
  return (useWorker && connectWorker(module, report)) || connectOnPage(module, report);
}

/** Returns undefined if workers are not available. */
function connectWorker(module: WebAssembly.Module, report: (report: Report) => void): EngineConnection | undefined {
  let worker: Worker;
  try {
    worker = new DecodingWorker();
    worker.postMessage(module);
  } catch {
    return undefined;
  }
  worker.onmessage = ({ data }: MessageEvent<Report>) => report(data);
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

function connectOnPage(module: WebAssembly.Module, report: (report: Report) => void): EngineConnection {
  start(module);
  let isDisposed = false;
  // Reports are always asynchronous, as they are with a worker.
  const defer = (work: () => void) => queueMicrotask(() => void (isDisposed || work()));
  const engine = new Engine((what) => defer(() => report(what)), PAGE_SLICE_MS);
  return {
    send: (order) => defer(() => engine.take(order)),
    dispose: () => {
      isDisposed = true;
      engine.dispose();
    },
  };
}
