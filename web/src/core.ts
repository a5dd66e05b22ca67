/**
 * The model without three.js and without a worker, for other engines and for Node.js.
 *
 * Objects of this module live in wasm memory: release them with `free()`.
 */

export { StriataError, asStriataError } from './error.ts';
export { Engine } from './engine.ts';
export type { LevelRequest, NewVertices, Order, Report, State, Update, Wish } from './protocol.ts';
export type { Coloring, ErrorCode, Kind, Phase } from './types.ts';
export { Failure, Model, StreamPlace, Vertices, View } from './wasm/striata_web.js';
import { start, wasmModule } from './wasm.ts';
import type { LoaderOptions } from './types.ts';

/** Initializes the wasm module; must be called before anything else in this module is used. */
export async function initialize(wasm?: LoaderOptions['wasm']): Promise<void> {
  start(await wasmModule(wasm));
}
