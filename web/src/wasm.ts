/** Locates, compiles and initializes the wasm module. */

import { StriataError } from './error.ts';
import type { LoaderOptions, WasmSource } from './types.ts';
import { initSync } from './wasm/striata.js';

/** Compiled modules by source, so that each is compiled once. */
const modules = new Map<unknown, Promise<WebAssembly.Module>>();
let isStarted = false;

/** Options of loaders with the locations of the modules. */
const OPTIONS = { striata: 'wasm', 'striata-builder': 'builder', 'striata-files': 'files' } as const;

type ModuleName = 'striata' | 'striata-builder' | 'striata-files';

/** Returns the compiled module that decodes streams: from the options, embedded in the page, or next to this script. */
export function wasmModule(source: WasmSource | undefined): Promise<WebAssembly.Module> {
  return moduleOf('striata', source);
}

/** Returns the compiled module that builds levels of other files. */
export function builderModule({ wasm, builder }: Pick<LoaderOptions, 'wasm' | 'builder'> = {}): Promise<WebAssembly.Module> {
  return moduleBeside(wasm, 'striata-builder', builder);
}

/** Returns the compiled module that reads `.striata` files. */
export function filesModule({ wasm, files }: Pick<LoaderOptions, 'wasm' | 'files'> = {}): Promise<WebAssembly.Module> {
  return moduleBeside(wasm, 'striata-files', files);
}

/** A module that is next to the one at a URL, unless it has a source of its own. */
function moduleBeside(wasm: WasmSource | undefined, name: ModuleName, source: WasmSource | undefined): Promise<WebAssembly.Module> {
  if (source !== undefined || (typeof wasm !== 'string' && !(wasm instanceof URL))) return moduleOf(name, source);
  const base = typeof document === 'undefined' ? undefined : document.baseURI;
  return moduleOf(name, new URL(`${name}.wasm`, new URL(wasm, base)));
}

function moduleOf(name: ModuleName, source: WasmSource | undefined): Promise<WebAssembly.Module> {
  const key = source instanceof URL ? source.href : (source ?? name);
  let module = modules.get(key);
  if (!module) {
    module = compile(name, source);
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

async function compile(name: ModuleName, source: WasmSource | undefined): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (typeof source === 'function') return source();
  if (source !== undefined && typeof source !== 'string' && !(source instanceof URL)) {
    return WebAssembly.compile(source);
  }
  const embedded = source === undefined ? await embeddedBytes(name) : undefined;
  if (embedded) return WebAssembly.compile(embedded);
  return WebAssembly.compile(await fetchModule(name, source ?? nextToScript(name)));
}

/** Bundlers recognize this form with a literal name, and copy the file. */
function nextToScript(name: ModuleName): URL {
  if (name === 'striata') return new URL(/* @vite-ignore */ 'striata.wasm', import.meta.url);
  if (name === 'striata-files') return new URL(/* @vite-ignore */ 'striata-files.wasm', import.meta.url);
  return new URL(/* @vite-ignore */ 'striata-builder.wasm', import.meta.url);
}

async function fetchModule(name: ModuleName, url: string | URL): Promise<ArrayBuffer> {
  if (url instanceof URL && url.protocol === 'file:' && typeof process !== 'undefined') {
    // Node.js does not fetch files.
    const files = 'node:fs/promises';
    const { readFile } = (await import(/* @vite-ignore */ files)) as typeof import('node:fs/promises');
    const bytes = await readFile(url);
    return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) as ArrayBuffer;
  }
  const hint = `the file is next to striata.js in the package; if you moved it, set the option \`${OPTIONS[name]}\``;
  const response = await fetch(url).catch((error: unknown) => {
    throw new StriataError('network', `cannot fetch ${name}.wasm: ${String(error)}`);
  });
  if (!response.ok) {
    throw new StriataError(
      response.status === 404 ? 'not-found' : 'network',
      `cannot fetch ${name}.wasm from ${String(url)}: the server responded with ${response.status}`,
      hint,
    );
  }
  // Streaming compilation requires the MIME type application/wasm, which some servers do not send.
  const bytes = await response.arrayBuffer();
  if (WASM_MAGIC.some((byte, at) => new Uint8Array(bytes)[at] !== byte)) {
    const type = response.headers.get('Content-Type');
    throw new StriataError('not-found', `${String(url)} is not the wasm module ${name}.wasm${type ? `, but ${type}` : ''}`, hint);
  }
  return bytes;
}

/** The first bytes of every wasm module. */
const WASM_MAGIC = [0x00, 0x61, 0x73, 0x6d];

/** A module that the page embeds in base64, compressed by gzip or not. */
async function embeddedBytes(name: ModuleName): Promise<BufferSource | undefined> {
  if (typeof document === 'undefined') return undefined;
  const text = document.getElementById(`${name}-wasm`)?.textContent?.trim();
  if (!text) return undefined;
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}
