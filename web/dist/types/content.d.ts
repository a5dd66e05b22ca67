/** What a source holds, told by its first bytes: a stream that can be shown as it comes, or a file that has to be whole. */
import { type Opened, type Pieces } from './bytes.ts';
/** A stream as it comes, or pieces of a whole file. */
export interface Content {
    isStream: boolean;
    /** Whether the stream is a part of a `.striata` file. */
    isInContainer: boolean;
    pieces: Pieces;
    /** Bytes that will come; null where nobody tells. */
    byteCount: number | null;
}
/** Looks at the beginning of a source; wasm has to be started. */
export declare function contentOf(opened: Opened): Promise<Content>;
