/** What a source holds, told by its first bytes: a stream that can be shown as it comes, or a file that has to be whole. */

import { concatenated, limited, preceded, skipped, type Opened, type Pieces } from './bytes.ts';
import { StreamPlace } from './wasm/striata_web.js';

/** A stream as it comes, or pieces of a whole file. */
export interface Content {
  isStream: boolean;
  /** Whether the stream is a part of a `.striata` file. */
  isInContainer: boolean;
  pieces: Pieces;
  /** Bytes that will come; null where nobody tells. */
  byteCount: number | null;
}

const STREAM_MAGIC = [0x89, 0x53, 0x54, 0x52];
const CONTAINER_MAGIC = [...'STRIATA\0'].map((character) => character.charCodeAt(0));

/** Rather than to ask once more, so many bytes are read and dropped. */
const WORTH_A_REQUEST = 1 << 16;

/** Looks at the beginning of a source; wasm has to be started. */
export async function contentOf(opened: Opened): Promise<Content> {
  const head = new Head(opened.pieces);
  await head.grow(CONTAINER_MAGIC.length);
  if (head.startsWith(STREAM_MAGIC)) {
    return { isStream: true, isInContainer: false, pieces: head.all(), byteCount: opened.length };
  }
  if (head.startsWith(CONTAINER_MAGIC)) {
    const place = await streamPlace(head);
    if (place) return contentOfStream(opened, head, place);
  }
  return { isStream: false, isInContainer: false, pieces: head.all(), byteCount: opened.length };
}

async function contentOfStream(opened: Opened, head: Head, { offset, length }: Place): Promise<Content> {
  const there = head.bytes.length;
  if (there < offset && opened.range && offset - there > WORTH_A_REQUEST) {
    await head.drop();
    const pieces = await opened.range(offset, offset + length);
    return { isStream: true, isInContainer: true, pieces, byteCount: length };
  }
  return { isStream: true, isInContainer: true, pieces: limited(skipped(head.all(), offset), length), byteCount: length };
}

interface Place {
  offset: number;
  length: number;
}

/** Where the stream of a container is; undefined if it has none, or ends before that is told. */
async function streamPlace(head: Head): Promise<Place | undefined> {
  for (;;) {
    const place = StreamPlace.find(head.bytes);
    const { needed, offset, length } = place;
    place.free();
    if (needed > head.bytes.length) {
      if (!(await head.grow(needed))) return undefined;
      continue;
    }
    return length > 0 ? { offset, length } : undefined;
  }
}

/** The first bytes of some pieces, which the pieces can be read with nevertheless. */
class Head {
  bytes: Uint8Array = new Uint8Array();
  readonly #rest: Pieces;

  constructor(pieces: Pieces) {
    this.#rest = pieces;
  }

  /** Reads until so many bytes are there; false if there are no more. */
  async grow(count: number): Promise<boolean> {
    while (this.bytes.length < count) {
      const piece = await this.#rest.next();
      if (piece.done) return false;
      this.bytes = concatenated([this.bytes, piece.value]);
    }
    return true;
  }

  startsWith(magic: number[]): boolean {
    return magic.every((byte, at) => this.bytes[at] === byte);
  }

  all(): Pieces {
    return preceded(this.bytes, this.#rest);
  }

  async drop(): Promise<void> {
    await this.#rest.return?.();
  }
}
