/** Errors with a code for programs, a message for people, and a hint if a remedy is known. */

import { Failure } from './wasm/striata.js';
import { Failure as BuilderFailure } from './wasm/striata-builder.js';
import { Failure as FilesFailure } from './wasm/striata-files.js';
import type { ErrorCode } from './types.ts';

/** The error that `load` and `finished` reject with. */
export class StriataError extends Error {
  /** Kind of error. */
  readonly code: ErrorCode;
  /** How to fix the problem, if known. */
  readonly hint: string | undefined;

  constructor(code: ErrorCode, message: string, hint?: string) {
    super(message);
    this.name = 'StriataError';
    this.code = code;
    this.hint = hint;
  }
}

/** Serializable form of an error, for messages between the worker and the page. */
export interface PlainError {
  code: ErrorCode;
  message: string;
  hint: string | undefined;
}

/** What the wasm modules throw: each has its own class. */
interface WasmFailure {
  readonly code: string;
  readonly message: string;
  readonly hint: string | undefined;
  free(): void;
}

/** Whether a wasm module has thrown this; it is released with `free()`. */
export function isFailure(thrown: unknown): thrown is WasmFailure {
  return thrown instanceof Failure || thrown instanceof BuilderFailure || thrown instanceof FilesFailure;
}

/** Converts anything that was thrown to a `StriataError`. */
export function asStriataError(thrown: unknown): StriataError {
  if (thrown instanceof StriataError) return thrown;
  if (isFailure(thrown)) {
    const error = new StriataError(thrown.code as ErrorCode, thrown.message, thrown.hint);
    thrown.free();
    return error;
  }
  if (thrown instanceof WebAssembly.RuntimeError || thrown instanceof RangeError) {
    return new StriataError(
      'too-large',
      'the model needs more memory than is available',
      'close other tabs, or load a model with fewer triangles',
    );
  }
  if (thrown instanceof DOMException && thrown.name === 'AbortError') return aborted();
  const message = thrown instanceof Error ? thrown.message : String(thrown);
  return new StriataError('network', message);
}

export function aborted(): StriataError {
  return new StriataError('aborted', 'loading was aborted');
}

export function asPlain(error: StriataError): PlainError {
  return { code: error.code, message: error.message, hint: error.hint };
}

export function fromPlain(plain: PlainError): StriataError {
  return new StriataError(plain.code, plain.message, plain.hint);
}
