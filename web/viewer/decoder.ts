/** Where the page's wasm is: the decoder of the library, with the encoder that saves models. */

/** URL of the wasm, whose name contains a hash. Undefined in a self-contained page, which embeds it. */
export function wasmUrl(): URL | undefined {
  if (document.getElementById('striata-wasm')) return undefined;
  return new URL('./wasm/striata.wasm', import.meta.url);
}
