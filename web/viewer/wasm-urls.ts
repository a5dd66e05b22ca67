/** Where the page's wasm modules are. */

import { builderModule } from '../src/wasm.ts';

/** Locations of the decoder of streams and of the encoder, which also reads other files. Undefined if the page embeds them. */
export interface WasmUrls {
  wasm?: URL;
  builder?: URL;
  files: URL | (() => Promise<WebAssembly.Module>);
}

/** The locations, whose names contain hashes. A self-contained page embeds the modules instead. */
export function wasmUrls(): WasmUrls {
  if (document.getElementById('striata-wasm')) return { files: () => builderModule() };
  const encoder = new URL('./wasm/striata-encoder.wasm', import.meta.url);
  return { wasm: new URL('../dist/striata.wasm', import.meta.url), builder: encoder, files: encoder };
}
