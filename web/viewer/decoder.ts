/** Where the decoder, striata.wasm, is. */

/** URL of the decoder: its name contains a hash. Undefined in a self-contained page, which embeds it. */
export function decoderUrl(): URL | undefined {
  if (document.getElementById('striata-wasm')) return undefined;
  return new URL('../dist/striata.wasm', import.meta.url);
}
