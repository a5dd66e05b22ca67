/** Runs an engine in a worker: the first message contains the wasm module and the kind of engine, all others are orders. */

import { Engine } from './engine.ts';
import { PagedEngine } from './paged/engine.ts';
import { transferable, type Order, type Report } from './protocol.ts';
import { sceneTransfer, type SceneOrder } from './scene/protocol.ts';
import { SceneEngine } from './scene/scene-engine.ts';
import { initSync } from './wasm/striata.js';

/** Longest uninterrupted decoding: a worker may decode longer than a page, but requests should be answered quickly. */
const SLICE_MS = 30;

/** The first message. */
interface Start {
  type: 'start';
  module: WebAssembly.Module;
  engine: 'mesh' | 'paged' | 'scene';
}

/** The part of a worker's global scope that is used here; TypeScript's DOM types describe only pages. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<Start | Order | SceneOrder>) => void) | null;
  postMessage(message: unknown, transfer: Transferable[]): void;
}

const scope = self as unknown as WorkerScope;
let take: (order: never) => void = () => undefined;

scope.onmessage = ({ data }) => {
  if (data.type !== 'start') return take(data as never);
  initSync({ module: data.module });
  const engine = engineOf(data.engine);
  take = (order) => engine.take(order);
};

function engineOf(kind: Start['engine']): { take(order: never): void } {
  const send = (report: Report) => scope.postMessage(report, transferable(report));
  if (kind === 'mesh') return new Engine(send, SLICE_MS);
  if (kind === 'paged') return new PagedEngine(send);
  return new SceneEngine((report) => scope.postMessage(report, sceneTransfer(report)), SLICE_MS);
}
