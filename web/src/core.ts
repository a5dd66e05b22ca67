/**
 * The model without three.js and without a worker, for other engines and for Node.js.
 *
 * Objects of this module live in wasm memory: release them with `free()`.
 */

export { StriataError, asStriataError } from './error.ts';
export { SceneEngine } from './scene/scene-engine.ts';
export type { MeshArrays, MeshShare, MeshUpdate, NewLayer, SceneDocument, SceneOrder, SceneReport, SceneState, SceneTarget } from './scene/protocol.ts';
export type { LevelRequest, NewVertices, Order, Report, State, Update } from './protocol.ts';
export type { Coloring, ErrorCode, Kind, Phase } from './types.ts';
export { Failure, Model, SceneModel, StreamPlace, VertexLayer, Vertices, View } from './wasm/striata.js';
import { Engine as MeshEngine } from './engine.ts';
import type { Report } from './protocol.ts';
import { builderModule, start, wasmModule } from './wasm.ts';
import type { LoaderOptions } from './types.ts';

let options: Pick<LoaderOptions, 'wasm' | 'builder'> = {};

/**
 * Initializes the wasm module; must be called before anything else in this module is used. `builder` is the location of
 * striata-builder.wasm, which an engine fetches to build levels of meshes without a stream.
 */
export async function initialize(wasm?: LoaderOptions['wasm'], builder?: LoaderOptions['builder']): Promise<void> {
  options = { ...(wasm === undefined ? {} : { wasm }), ...(builder === undefined ? {} : { builder }) };
  start(await wasmModule(wasm));
}

/** Decodes and builds one model: pass orders to `take`; reports are delivered to the callback. */
export class Engine extends MeshEngine {
  constructor(report: (report: Report) => void, sliceMs: number) {
    super(report, sliceMs, () => builderModule(options));
  }
}
