/** Encodes the file of a model as a stream, or as a GLB file with streams or of one level, in a worker. */

import { fromPlain, StriataError } from '../src/error.ts';
import { builderModule } from '../src/wasm.ts';
import type { EncodeOrder, EncodeReport, SavedFormat, Saved } from './encode-worker.ts';
import EncodeWorker from './encode-worker.ts?worker&inline';
import type { ModelSource } from './sources.ts';
import { wasmUrls } from './wasm-urls.ts';

/** How far encoding is: the fraction of a phase, 0 to 1. */
export type OnEncodeProgress = (phase: string, share: number) => void;

/** Encodes a model. Rejects with a `StriataError`, with code `aborted` if the signal is aborted. */
export async function encodeModel(
  source: ModelSource, saved: Saved, signal: AbortSignal, onProgress: OnEncodeProgress,
): Promise<Blob> {
  onProgress('read', 0);
  const [module, bytes] = await Promise.all([builderModule(wasmUrls()), bytesOf(source, signal)]);
  if (signal.aborted) throw aborted();
  const worker = new EncodeWorker();
  try {
    return await new Promise<Blob>((resolve, reject) => {
      signal.addEventListener('abort', () => reject(aborted()), { once: true });
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new StriataError('unsupported', `the worker failed: ${event.message || 'it could not start'}`));
      };
      worker.onmessage = ({ data }: MessageEvent<EncodeReport>) => {
        if (data.type === 'progress') onProgress(data.phase, data.share);
        else if (data.type === 'done') resolve(new Blob([data.bytes], { type: mediaType(saved.format) }));
        else reject(fromPlain(data.error));
      };
      const order: EncodeOrder = { module, bytes, name: source.name, ...saved };
      worker.postMessage(order, [bytes]);
    });
  } finally {
    worker.terminate();
  }
}

/** A copy of the bytes of a model's file. */
export async function bytesOf({ data, name }: ModelSource, signal: AbortSignal): Promise<ArrayBuffer> {
  if (data instanceof ArrayBuffer) return data.slice(0);
  if (typeof data !== 'string') {
    return data.arrayBuffer().catch((error: unknown) => {
      throw new StriataError('network', `cannot read ${name}: ${String(error)}`, 'the file has changed or was removed; open it again');
    });
  }
  const response = await fetch(data, { signal }).catch((error: unknown) => {
    throw signal.aborted ? aborted() : new StriataError('network', `cannot fetch ${name}: ${String(error)}`);
  });
  if (!response.ok) throw new StriataError('network', `cannot fetch ${name}: the server responded with ${response.status}`);
  return response.arrayBuffer();
}

function aborted(): StriataError {
  return new StriataError('aborted', 'saving was canceled');
}

const mediaType = (format: SavedFormat): string => (format === 'stri' ? 'application/octet-stream' : 'model/gltf-binary');
