/** A connection to an engine, in a worker of its own or in the page: both look the same. */

import { Engine } from './engine.ts';
import { StriataError, asPlain } from './error.ts';
import type { Order, Report } from './protocol.ts';
import { start } from './wasm.ts';
import DecodingWorker from './worker.ts?worker&inline';

/** In the page decoding must not be felt. */
const PAGE_SLICE_MS = 6;

export interface Link {
  order(order: Order): void;
  dispose(): void;
}

/** Starts an engine; what it reports comes to `report`. */
export function link(module: WebAssembly.Module, useWorker: boolean, report: (report: Report) => void): Link {
  return (useWorker && workerLink(module, report)) || pageLink(module, report);
}

/** Undefined where the page may not have workers. */
function workerLink(module: WebAssembly.Module, report: (report: Report) => void): Link | undefined {
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
    const error = new StriataError('unsupported', `the worker failed: ${message}`, 'try the option worker: false');
    report({ type: 'failed', error: asPlain(error) });
  };
  return {
    // Bytes are copied: a piece may be a part of a buffer that others still read.
    order: (order) => worker.postMessage(order),
    dispose: () => worker.terminate(),
  };
}

function pageLink(module: WebAssembly.Module, report: (report: Report) => void): Link {
  start(module);
  let isDisposed = false;
  // Never within the call that ordered it, as with a worker.
  const later = (work: () => void) => queueMicrotask(() => void (isDisposed || work()));
  const engine = new Engine((what) => later(() => report(what)), PAGE_SLICE_MS);
  return {
    order: (order) => later(() => engine.take(order)),
    dispose: () => {
      isDisposed = true;
      engine.dispose();
    },
  };
}
