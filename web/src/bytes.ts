/** Byte sources: the web, a file, memory. If a source supports random access, only the needed parts are read. */

import { StriataError } from './error.ts';
import type { Source } from './types.ts';

/** Bytes that arrive in chunks. */
export type ByteChunks = AsyncIterator<Uint8Array, void, undefined>;

/** A source that has been opened at its beginning. */
export interface OpenedSource {
  /** File name; empty if the source has none. */
  name: string;
  /** Length in bytes; null if unknown. */
  length: number | null;
  /** The bytes from the beginning; may end before the source does. */
  chunks: ByteChunks;
  /** Reads the bytes from one offset to another instead; null if the source does not support that. */
  range: ((from: number, to: number) => Promise<ByteChunks>) | null;
}

/** How much of a `.striata` file is requested first: more than its header, one or two network packets. */
const HEAD_BYTES = 1 << 16;

/** How a URL is requested. */
export interface RequestOptions {
  headers?: Record<string, string>;
  credentials?: RequestCredentials;
}

export async function open(
  source: Source, name: string | undefined, signal: AbortSignal, request: RequestOptions = {},
): Promise<OpenedSource> {
  if (typeof source === 'string' || source instanceof URL) return openUrl(source, name, signal, request);
  if (source instanceof Blob) {
    const part = (from: number, to: number) => chunks(source.slice(from, to).stream(), signal);
    return {
      name: name ?? (source instanceof File ? source.name : ''),
      length: source.size,
      chunks: part(0, source.size),
      range: (from, to) => Promise.resolve(part(from, to)),
    };
  }
  if (source instanceof ArrayBuffer) {
    const part = (from: number, to: number) => singleChunk(new Uint8Array(source.slice(from, to)));
    return {
      name: name ?? '',
      length: source.byteLength,
      chunks: part(0, source.byteLength),
      range: (from, to) => Promise.resolve(part(from, to)),
    };
  }
  if (source instanceof ReadableStream) {
    return { name: name ?? '', length: null, chunks: chunks(source, signal), range: null };
  }
  throw new StriataError('unsupported', 'the source must be a URL, File, Blob, ArrayBuffer or ReadableStream');
}

async function openUrl(
  source: string | URL, name: string | undefined, signal: AbortSignal, request: RequestOptions,
): Promise<OpenedSource> {
  const url = urlOf(source);
  const get = (url: URL, headers: Record<string, string>, signal: AbortSignal) => (
    fetchUrl(url, { ...request, headers: { ...request.headers, ...headers } }, signal)
  );
  const isContainer = /\.striata$/i.test(url.pathname);
  // Usually only the stream at the end of a container is needed.
  const headers: Record<string, string> = isContainer ? { Range: `bytes=0-${HEAD_BYTES - 1}` } : {};
  let response = await get(url, headers, signal);
  const total = /\/(\d+)$/.exec(response.headers.get('Content-Range') ?? '')?.[1];
  if (response.status === 206 && total === undefined) {
    // A cross-origin server may send a part without exposing the total length to this page; then the whole file is requested.
    await response.body?.cancel();
    response = await get(url, {}, signal);
  }
  // The length of a compressed response does not give the length of its contents.
  const isCompressed = response.headers.has('Content-Encoding');
  const length = total ?? (isCompressed ? null : response.headers.get('Content-Length'));
  const isPart = response.status === 206;
  const range = async (from: number, to: number) => {
    const part = await get(url, { Range: `bytes=${from}-${to - 1}` }, signal);
    const all = body(part, signal);
    return part.status === 206 ? all : skipBytes(all, from);
  };
  return {
    name: name ?? fileName(url),
    length: length === null ? null : Number(length),
    chunks: isPart && Number(total) > HEAD_BYTES ? chain(body(response, signal), () => range(HEAD_BYTES, Number(total))) : body(response, signal),
    range: isPart ? range : null,
  };
}

function urlOf(source: string | URL): URL {
  try {
    return new URL(source, typeof document === 'undefined' ? undefined : document.baseURI);
  } catch {
    throw new StriataError('unsupported', `${String(source)} is not a valid URL`);
  }
}

/** Last segment of a path, decoded if its escapes are valid. */
function fileName(url: URL): string {
  const last = url.pathname.split('/').pop() ?? '';
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}

async function fetchUrl(url: URL, request: RequestOptions, signal: AbortSignal): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url, { ...request, signal });
  } catch (error) {
    if (signal.aborted) throw error;
    throw new StriataError('network', `cannot fetch ${url.href}: ${error instanceof Error ? error.message : String(error)}`,
      'check that the server is reachable and allows requests from this page (CORS)');
  }
  if (response.ok) return response;
  await response.body?.cancel();
  if (response.status === 416) throw new StriataError('format', `${url.href} is too short; the file may be empty`);
  const code = response.status === 404 || response.status === 410 ? 'not-found' : 'network';
  throw new StriataError(code, `${url.href}: the server responded with ${response.status} ${response.statusText}`.trim());
}

function body(response: Response, signal: AbortSignal): ByteChunks {
  return response.body ? chunks(response.body, signal) : singleChunk(new Uint8Array());
}

async function* singleChunk(bytes: Uint8Array): AsyncGenerator<Uint8Array, void, undefined> {
  yield bytes;
}

async function* chunks(stream: ReadableStream<Uint8Array>, signal: AbortSignal): AsyncGenerator<Uint8Array, void, undefined> {
  const reader = stream.getReader();
  const stop = () => void reader.cancel(signal.reason).catch(() => undefined);
  signal.addEventListener('abort', stop, { once: true });
  let isFinished = false;
  try {
    for (;;) {
      signal.throwIfAborted();
      const { done, value } = await reader.read();
      signal.throwIfAborted();
      if (done) break;
      yield value;
    }
    isFinished = true;
  } catch (error) {
    if (signal.aborted || error instanceof StriataError) throw error;
    throw new StriataError('network', `the connection was interrupted: ${error instanceof Error ? error.message : String(error)}`);
  } finally {
    signal.removeEventListener('abort', stop);
    // A consumer that stops early needs no more bytes.
    if (!isFinished) await reader.cancel().catch(() => undefined);
  }
}

/** Skips the first `count` bytes. */
async function* skipBytes(from: ByteChunks, count: number): AsyncGenerator<Uint8Array, void, undefined> {
  try {
    for (let chunk = await from.next(); !chunk.done; chunk = await from.next()) {
      const bytes = chunk.value.subarray(count);
      count = Math.max(0, count - chunk.value.length);
      if (bytes.length > 0) yield bytes;
    }
  } finally {
    await from.return?.();
  }
}

/** Chunks of one source, followed by those of another that is requested only when the first is used up. */
async function* chain(first: ByteChunks, then: () => Promise<ByteChunks>): AsyncGenerator<Uint8Array, void, undefined> {
  for (let chunk = await first.next(); !chunk.done; chunk = await first.next()) yield chunk.value;
  yield* iterable(await then());
}

/** Bytes that were already read, followed by the remaining chunks. */
export async function* prepend(bytes: Uint8Array, rest: ByteChunks): AsyncGenerator<Uint8Array, void, undefined> {
  if (bytes.length > 0) yield bytes;
  yield* iterable(rest);
}

/** Passes on at most `count` bytes. */
export async function* takeBytes(from: ByteChunks, count: number): AsyncGenerator<Uint8Array, void, undefined> {
  for await (const chunk of iterable(from)) {
    yield chunk.subarray(0, count);
    count -= chunk.length;
    if (count <= 0) return;
  }
}

export { skipBytes };

export function iterable(from: ByteChunks): AsyncIterable<Uint8Array> {
  return { [Symbol.asyncIterator]: () => from };
}

/** Concatenates several chunks. */
export function concat(parts: Uint8Array[]): Uint8Array {
  if (parts.length === 1) return parts[0]!;
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
