/** Bytes from anywhere: the web, a file, memory. Where a source can be read from any place, only what is needed is read. */
import type { Source } from './types.ts';
/** Bytes that come one piece after the other. */
export type Pieces = AsyncIterator<Uint8Array, void, undefined>;
/** A source that has been opened at its beginning. */
export interface Opened {
    /** Its file name, as far as it has one. */
    name: string;
    /** Its length; null where nobody tells. */
    length: number | null;
    /** The first bytes, maybe not all. */
    pieces: Pieces;
    /** Bytes from one place to another instead; null where the source cannot do that. */
    range: ((from: number, to: number) => Promise<Pieces>) | null;
}
export declare function open(source: Source, name: string | undefined, signal: AbortSignal): Promise<Opened>;
/** Pieces from so many bytes on. */
declare function skipped(from: Pieces, count: number): AsyncGenerator<Uint8Array, void, undefined>;
/** Bytes that are there already, and then the rest of some pieces. */
export declare function preceded(bytes: Uint8Array, rest: Pieces): AsyncGenerator<Uint8Array, void, undefined>;
/** At most so many bytes. */
export declare function limited(from: Pieces, count: number): AsyncGenerator<Uint8Array, void, undefined>;
export { skipped };
export declare function iterable(from: Pieces): AsyncIterable<Uint8Array>;
/** Several pieces as one. */
export declare function concatenated(parts: Uint8Array[]): Uint8Array;
