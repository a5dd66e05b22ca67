/** gzip and zstd around a file: taken off by the browser, or by a small script. */

import { Decompress } from 'fzstd';
import { concatenated } from './bytes.ts';
import { StriataError } from './error.ts';

/** Layers that are taken off. */
const MOST_LAYERS = 3;

/** What grows past this is more than a page can hold. */
const MOST_BYTES = 1 << 30;

/** From this size on, a file may grow by so many times: more is a bomb, not a mesh. */
const RATIO_COUNTS_FROM = 64 << 20;
const MOST_RATIO = 2000;

/** The bytes without what they are packed in, and the name without its extension. */
export async function unpacked(bytes: Uint8Array, name: string): Promise<{ bytes: Uint8Array; name: string }> {
  for (let layer = 0; layer < MOST_LAYERS; layer++) {
    const kind = packing(bytes);
    if (!kind) break;
    const parts = new Parts(Math.min(MOST_BYTES, Math.max(RATIO_COUNTS_FROM, bytes.length * MOST_RATIO)), name);
    try {
      await (kind === 'gzip' ? gunzip(bytes, parts) : unzstd(bytes, parts));
    } catch (error) {
      if (error instanceof StriataError) throw error;
      throw new StriataError('corrupt', `${name}: the ${kind} data are damaged or cut off: ${error instanceof Error ? error.message : String(error)}`);
    }
    bytes = concatenated(parts.all);
    name = name.replace(/\.(gz|zst)$/i, '');
  }
  return { bytes, name };
}

function packing(bytes: Uint8Array): 'gzip' | 'zstd' | undefined {
  const starts = (...magic: number[]) => magic.every((byte, at) => bytes[at] === byte);
  if (starts(0x1f, 0x8b, 0x08)) return 'gzip';
  return starts(0x28, 0xb5, 0x2f, 0xfd) ? 'zstd' : undefined;
}

async function gunzip(bytes: Uint8Array, parts: Parts): Promise<void> {
  const stream = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new DecompressionStream('gzip'));
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return;
    parts.push(value);
  }
}

function unzstd(bytes: Uint8Array, parts: Parts): void {
  let isWhole = false;
  const decompress = new Decompress((part, isLast) => {
    parts.push(part);
    isWhole ||= isLast === true;
  });
  const step = 1 << 20;
  for (let at = 0; at < bytes.length; at += step) {
    decompress.push(bytes.subarray(at, at + step), at + step >= bytes.length);
  }
  if (!isWhole) throw new Error('they end too early');
}

/** Pieces of what comes out, not too much of it. */
class Parts {
  readonly all: Uint8Array[] = [];
  #count = 0;

  constructor(private readonly most: number, private readonly name: string) {}

  push(part: Uint8Array): void {
    this.#count += part.length;
    if (this.#count > this.most) {
      throw new StriataError('too-large', `${this.name}: grows past ${this.most} bytes, more than a mesh can`);
    }
    // The next piece may use the same memory.
    this.all.push(part.slice());
  }
}
