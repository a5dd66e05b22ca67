/** Finding, compiling and starting the wasm. */

import { StriataError } from './error.ts';
import type { LoaderOptions } from './types.ts';
import { initSync } from './wasm/striata_web.js';

type WasmSource = NonNullable<LoaderOptions['wasm']>;

/** Modules by where they come from: each is compiled once. */
const modules = new Map<unknown, Promise<WebAssembly.Module>>();
let isStarted = false;

/** The compiled module, from where the options say, from the page itself, or from beside this script. */
export function wasmModule(source: WasmSource | undefined): Promise<WebAssembly.Module> {
  const key = source instanceof URL ? source.href : source;
  let module = modules.get(key);
  if (!module) {
    module = compile(source);
    // What failed once may work later.
    module.catch(() => modules.delete(key));
    modules.set(key, module);
  }
  return module;
}

/** Starts a module in this very thread, once; what comes later finds it started. */
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
    throw new StriataError('network', `striata.wasm could not be fetched: ${String(error)}`);
  });
  if (!response.ok) {
    throw new StriataError(
      response.status === 404 ? 'not-found' : 'network',
      `striata.wasm could not be fetched from ${String(url)}: the server says ${response.status}`,
      'it lies beside striata.js in the package; the option `wasm` says where else',
    );
  }
  // Not every server knows the type that compiling from a stream asks for.
  return WebAssembly.compile(await response.arrayBuffer());
}

function embeddedBytes(): Uint8Array<ArrayBuffer> | undefined {
  if (typeof document === 'undefined') return undefined;
  const text = document.getElementById('striata-wasm')?.textContent?.trim();
  return text ? Uint8Array.from(atob(text), (character) => character.charCodeAt(0)) : undefined;
}
