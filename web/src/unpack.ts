/** Decompresses gzip and zstd files, with the browser's decompressor or a small script. */

import { Decompress } from 'fzstd';
import { concat } from './bytes.ts';
import { StriataError } from './error.ts';

/** Maximum number of nested compression layers. */
const MAX_LAYERS = 3;

/** Larger outputs do not fit into a page's memory. */
const MAX_BYTES = 1 << 30;

/** Beyond this size, output larger than `MAX_RATIO` times the input is taken for a decompression bomb. */
const RATIO_CHECK_BYTES = 64 << 20;
const MAX_RATIO = 2000;

/** Returns the decompressed bytes, and the name without the extensions of the compression. */
export async function decompressed(bytes: Uint8Array, name: string): Promise<{ bytes: Uint8Array; name: string }> {
  for (let layer = 0; layer < MAX_LAYERS; layer++) {
    const kind = compressionOf(bytes);
    if (!kind) break;
    const output = new OutputChunks(Math.min(MAX_BYTES, Math.max(RATIO_CHECK_BYTES, bytes.length * MAX_RATIO)), name);
    try {
      await (kind === 'gzip' ? gunzip(bytes, output) : unzstd(bytes, output));
    } catch (error) {
      if (error instanceof StriataError) throw error;
      throw new StriataError('corrupt', `${name}: the ${kind} data is damaged or truncated: ${error instanceof Error ? error.message : String(error)}`);
    }
    bytes = concat(output.chunks);
    name = name.replace(/\.(gz|zst)$/i, '');
  }
  return { bytes, name };
}

function compressionOf(bytes: Uint8Array): 'gzip' | 'zstd' | undefined {
  const starts = (...magic: number[]) => magic.every((byte, at) => bytes[at] === byte);
  if (starts(0x1f, 0x8b, 0x08)) return 'gzip';
  return starts(0x28, 0xb5, 0x2f, 0xfd) ? 'zstd' : undefined;
}

async function gunzip(bytes: Uint8Array, output: OutputChunks): Promise<void> {
  const stream = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new DecompressionStream('gzip'));
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return;
    output.push(value);
  }
}

function unzstd(bytes: Uint8Array, output: OutputChunks): void {
  let isWhole = false;
  const decompress = new Decompress((part, isLast) => {
    output.push(part);
    isWhole ||= isLast === true;
  });
  const step = 1 << 20;
  for (let at = 0; at < bytes.length; at += step) {
    decompress.push(bytes.subarray(at, at + step), at + step >= bytes.length);
  }
  if (!isWhole) throw new Error('unexpected end of data');
}

/** Collects output up to a limit. */
class OutputChunks {
  readonly chunks: Uint8Array[] = [];
  #byteCount = 0;

  constructor(private readonly maxBytes: number, private readonly name: string) {}

  push(part: Uint8Array): void {
    this.#byteCount += part.length;
    if (this.#byteCount > this.maxBytes) {
      throw new StriataError('too-large', `${this.name}: the decompressed data exceeds the limit of ${this.maxBytes} bytes`);
    }
    // The decompressor may reuse this memory for the next part.
    this.chunks.push(part.slice());
  }
}
