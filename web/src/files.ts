/** The third wasm module, which reads `.striata` files. */

import { initSync } from './wasm/striata-files.js';

let isStarted = false;

/** Initializes the module; later calls have no effect. */
export function startFiles(module: WebAssembly.Module): void {
  if (!isStarted) initSync({ module });
  isStarted = true;
}
