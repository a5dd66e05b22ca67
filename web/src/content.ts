/** Detects from its first bytes whether a source is a stream, which can be shown as it loads, or a file that must be complete. */

import { concat, prepend, skipBytes, takeBytes, type ByteChunks, type OpenedSource } from './bytes.ts';
import { StriataError } from './error.ts';
import { isContainer, isGlb, isPaged, isSceneStream, isStream, isWebPage, MAGIC_BYTES } from './magic.ts';
import { StreamPlace } from './wasm/striata.js';

/** The bytes of a stream, or of a whole file. */
export interface Content {
  /** Whether it is the stream of a mesh or a scene, a paged file, a `.striata` file without a stream, a glTF file, or another file. */
  kind: 'stream' | 'scene' | 'paged' | 'stored' | 'gltf' | 'file';
  /** Whether the stream is part of a `.striata` file. */
  isInContainer: boolean;
  chunks: ByteChunks;
  /** Number of bytes to expect; null if unknown. */
  byteCount: number | null;
}

/** Gaps up to this many bytes are read and dropped rather than skipped by another request. */
const MAX_SKIPPED_BYTES = 1 << 16;

/** Detects the content of a source; the wasm module must be initialized. */
export async function contentOf(opened: OpenedSource): Promise<Content> {
  const head = new Head(opened.chunks);
  await head.grow(MAGIC_BYTES);
  if (isWebPage(head.bytes)) {
    throw new StriataError('not-found', `${opened.name || 'the source'} is a web page (HTML), not a model`,
      'the server may send its start page for files that it does not have; check the address');
  }
  if (isPaged(head.bytes)) {
    await head.drop();
    return { kind: 'paged', isInContainer: false, chunks: head.all(), byteCount: null };
  }
  const whole = (kind: Content['kind']): Content => ({ kind, isInContainer: false, chunks: head.all(), byteCount: opened.length });
  if (isStream(head.bytes)) return whole('stream');
  if (isSceneStream(head.bytes)) return whole('scene');
  if (isGlb(head.bytes) || /\.gltf$/i.test(opened.name)) return whole('gltf');
  if (isContainer(head.bytes)) {
    const streamRange = await findStream(head);
    return streamRange ? contentOfStream(opened, head, streamRange) : whole('stored');
  }
  return whole('file');
}

async function contentOfStream(opened: OpenedSource, head: Head, { offset, length }: ByteRange): Promise<Content> {
  const available = head.bytes.length;
  if (available < offset && opened.range && offset - available > MAX_SKIPPED_BYTES) {
    await head.drop();
    const chunks = await opened.range(offset, offset + length);
    return { kind: 'stream', isInContainer: true, chunks, byteCount: length };
  }
  return { kind: 'stream', isInContainer: true, chunks: takeBytes(skipBytes(head.all(), offset), length), byteCount: length };
}

interface ByteRange {
  offset: number;
  length: number;
}

/** Location of the stream in a container; undefined if it has none, or ends before its location is known. */
async function findStream(head: Head): Promise<ByteRange | undefined> {
  for (;;) {
    const streamRange = StreamPlace.find(head.bytes);
    const { needed, offset, length } = streamRange;
    streamRange.free();
    if (needed > head.bytes.length) {
      if (!(await head.grow(needed))) return undefined;
      continue;
    }
    return length > 0 ? { offset, length } : undefined;
  }
}

/** Buffers the first bytes of a source for inspection, without consuming them. */
class Head {
  bytes: Uint8Array = new Uint8Array();
  readonly #rest: ByteChunks;

  constructor(chunks: ByteChunks) {
    this.#rest = chunks;
  }

  /** Reads until at least `count` bytes are buffered; false if the source ends before. */
  async grow(count: number): Promise<boolean> {
    while (this.bytes.length < count) {
      const chunk = await this.#rest.next();
      if (chunk.done) return false;
      this.bytes = concat([this.bytes, chunk.value]);
    }
    return true;
  }

  all(): ByteChunks {
    return prepend(this.bytes, this.#rest);
  }

  async drop(): Promise<void> {
    await this.#rest.return?.();
  }
}
