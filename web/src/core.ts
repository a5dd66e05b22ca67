/**
 * Without three.js and without a worker: the model itself, for other engines and for Node.js.
 *
 * Objects of this module lie in the wasm's memory: `free()` them.
 */

export { StriataError, asStriataError } from './error.ts';
export { Engine } from './engine.ts';
export type { NewVertices, Order, Report, State, Update, Wish } from './protocol.ts';
export type { Coloring, ErrorCode, Kind, Phase } from './types.ts';
export { Failure, Model, StreamPlace, Vertices, View } from './wasm/striata_web.js';
import { start, wasmModule } from './wasm.ts';
import type { LoaderOptions } from './types.ts';

/** Starts the wasm: nothing else here works before. */
export async function initialize(wasm?: LoaderOptions['wasm']): Promise<void> {
  start(await wasmModule(wasm));
}
