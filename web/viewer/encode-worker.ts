/** Encodes a model in a worker: one message with the file, then messages with the progress, and the result or an error. */

import { asPlain, asStriataError, type PlainError } from '../src/error.ts';
import { decompressed } from '../src/unpack.ts';
import { encode_file, initSync } from './wasm/striata-encoder.js';

/** A stream, a GLB file with streams, or a GLB file of one level. */
export type SavedFormat = 'level' | 'stri' | 'glb';

/** What a file is to contain. */
export interface Saved {
  format: SavedFormat;
  /** Number of triangles of the level. */
  triangles: number;
}

/** What is to be encoded. */
export interface EncodeOrder extends Saved {
  module: WebAssembly.Module;
  bytes: ArrayBuffer;
  name: string;
}

/** What the worker answers. */
export type EncodeReport =
  | { type: 'progress'; phase: string; share: number }
  | { type: 'done'; bytes: Uint8Array<ArrayBuffer> }
  | { type: 'failed'; error: PlainError };

/** The part of a worker's global scope that is used here; TypeScript's DOM types describe only pages. */
interface WorkerScope {
  onmessage: ((event: MessageEvent<EncodeOrder>) => void) | null;
  postMessage(report: EncodeReport, transfer?: Transferable[]): void;
}

const scope = self as unknown as WorkerScope;

scope.onmessage = ({ data }) => {
  encode(data).then(
    (bytes) => scope.postMessage({ type: 'done', bytes }, [bytes.buffer]),
    (thrown: unknown) => scope.postMessage({ type: 'failed', error: asPlain(asStriataError(thrown)) }),
  );
};

async function encode({ module, bytes, name, format, triangles }: EncodeOrder): Promise<Uint8Array<ArrayBuffer>> {
  initSync({ module });
  const file = await decompressed(new Uint8Array(bytes), name);
  const sink = { report: (phase: string, share: number) => scope.postMessage({ type: 'progress', phase, share }) };
  return encode_file(file.bytes, file.name, format, triangles, sink) as Uint8Array<ArrayBuffer>;
}
