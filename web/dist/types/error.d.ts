/** Errors with a code for programs, a sentence for people, and the cure where it is known. */
import type { ErrorCode } from './types.ts';
/** What `load` and `finished` reject with. */
export declare class StriataError extends Error {
    readonly code: ErrorCode;
    readonly hint: string | undefined;
    constructor(code: ErrorCode, message: string, hint?: string);
}
/** An error as it crosses from the worker to the page. */
export interface PlainError {
    code: ErrorCode;
    message: string;
    hint: string | undefined;
}
/** Makes an error of ours of whatever was thrown. */
export declare function asStriataError(thrown: unknown): StriataError;
export declare function aborted(): StriataError;
export declare function asPlain(error: StriataError): PlainError;
export declare function fromPlain(plain: PlainError): StriataError;
