/** The engine in a worker: the first message brings the module, all others are orders. */

import { Engine } from './engine.ts';
import { transferable, type Order } from './protocol.ts';
import { initSync } from './wasm/striata_web.js';

/** Nothing else runs here, but requests shall be answered soon. */
const SLICE_MS = 30;

/** What is used of a worker's own scope: the types of pages know no other. */
interface Scope {
  onmessage: ((event: MessageEvent<WebAssembly.Module | Order>) => void) | null;
  postMessage(message: unknown, transfer: Transferable[]): void;
}

const scope = self as unknown as Scope;
let engine: Engine | undefined;

scope.onmessage = ({ data }) => {
  if (data instanceof WebAssembly.Module) {
    initSync({ module: data });
    engine = new Engine((report) => scope.postMessage(report, transferable(report)), SLICE_MS);
  } else {
    engine?.take(data);
  }
};
