/** Runs the engine in a worker: the first message contains the wasm module, all others are orders. */

import { Engine } from './engine.ts';
import { transferable, type Order } from './protocol.ts';
import { initSync } from './wasm/striata_web.js';

/** Longest uninterrupted decoding: a worker may decode longer than a page, but requests should be answered quickly. */
const SLICE_MS = 30;

/** The part of a worker's global scope that is used here; TypeScript's DOM types describe only pages. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<WebAssembly.Module | Order>) => void) | null;
  postMessage(message: unknown, transfer: Transferable[]): void;
}

const scope = self as unknown as WorkerScope;
let engine: Engine | undefined;

scope.onmessage = ({ data }) => {
  if (data instanceof WebAssembly.Module) {
    initSync({ module: data });
    engine = new Engine((report) => scope.postMessage(report, transferable(report)), SLICE_MS);
  } else {
    engine?.take(data);
  }
};
