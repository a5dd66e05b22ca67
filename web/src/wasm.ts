/** Locates, compiles and initializes the wasm module. */

import { StriataError } from './error.ts';
import type { LoaderOptions } from './types.ts';
import { initSync } from './wasm/striata_web.js';

type WasmSource = NonNullable<LoaderOptions['wasm']>;

/** Compiled modules by source, so that each is compiled once. */
const modules = new Map<unknown, Promise<WebAssembly.Module>>();
let isStarted = false;

/** Returns the compiled module: from the options, embedded in the page, or next to this script. */
export function wasmModule(source: WasmSource | undefined): Promise<WebAssembly.Module> {
  const key = source instanceof URL ? source.href : source;
  let module = modules.get(key);
  if (!module) {
    module = compile(source);
    // A later attempt may succeed.
    module.catch(() => modules.delete(key));
    modules.set(key, module);
  }
  return module;
}

/** Initializes a module on the current thread; later calls have no effect. */
export function start(module: WebAssembly.Module): void {
  if (!isStarted) initSync({ module });
  isStarted = true;
}

async function compile(source: WasmSource | undefined): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (source !== undefined && typeof source !== 'string' && !(source instanceof URL)) {
    return WebAssembly.compile(source);
  }
  const embedded = source === undefined ? embeddedBytes() : undefined;
  if (embedded) return WebAssembly.compile(embedded);
  const url = source ?? new URL(/* @vite-ignore */ 'striata.wasm', import.meta.url);
  const response = await fetch(url).catch((error: unknown) => {
    throw new StriataError('network', `cannot fetch striata.wasm: ${String(error)}`);
  });
  if (!response.ok) {
    throw new StriataError(
      response.status === 404 ? 'not-found' : 'network',
      `cannot fetch striata.wasm from ${String(url)}: the server responded with ${response.status}`,
      'the file is next to striata.js in the package; if you moved it, set the option `wasm`',
    );
  }
  // Streaming compilation requires the MIME type application/wasm, which some servers do not send.
  return WebAssembly.compile(await response.arrayBuffer());
}

function embeddedBytes(): Uint8Array<ArrayBuffer> | undefined {
  if (typeof document === 'undefined') return undefined;
  const text = document.getElementById('striata-wasm')?.textContent?.trim();
  return text ? Uint8Array.from(atob(text), (character) => character.charCodeAt(0)) : undefined;
}
