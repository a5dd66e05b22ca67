/** Where the page's wasm modules are. */

/** Locations of the decoder of streams and of the encoder, which also reads other files. Undefined if the page embeds them. */
export interface WasmUrls {
  wasm?: URL;
  builder?: URL;
}

/** The locations, whose names contain hashes. A self-contained page embeds the modules instead. */
export function wasmUrls(): WasmUrls {
  if (document.getElementById('striata-wasm')) return {};
  return { wasm: new URL('../dist/striata.wasm', import.meta.url), builder: new URL('./wasm/striata-encoder.wasm', import.meta.url) };
}
