/** Bytes from anywhere: the web, a file, memory. Where a source can be read from any place, only what is needed is read. */

import { StriataError } from './error.ts';
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

/** As much of a `.striata` file as is asked for first: more than its head, in one packet or two. */
const HEAD_BYTES = 1 << 16;

export async function open(source: Source, name: string | undefined, signal: AbortSignal): Promise<Opened> {
  if (typeof source === 'string' || source instanceof URL) return openUrl(source, name, signal);
  if (source instanceof Blob) {
    const part = (from: number, to: number) => pieces(source.slice(from, to).stream(), signal);
    return {
      name: name ?? (source instanceof File ? source.name : ''),
      length: source.size,
      pieces: part(0, source.size),
      range: (from, to) => Promise.resolve(part(from, to)),
    };
  }
  if (source instanceof ArrayBuffer) {
    const part = (from: number, to: number) => whole(new Uint8Array(source.slice(from, to)));
    return {
      name: name ?? '',
      length: source.byteLength,
      pieces: part(0, source.byteLength),
      range: (from, to) => Promise.resolve(part(from, to)),
    };
  }
  if (source instanceof ReadableStream) {
    return { name: name ?? '', length: null, pieces: pieces(source, signal), range: null };
  }
  throw new StriataError('unsupported', 'a model is loaded from a URL, a File, a Blob, an ArrayBuffer or a ReadableStream');
}

async function openUrl(source: string | URL, name: string | undefined, signal: AbortSignal): Promise<Opened> {
  const url = urlOf(source);
  const isContainer = /\.striata$/i.test(url.pathname);
  // Of a container mostly the stream at its end is needed.
  const headers: HeadersInit = isContainer ? { Range: `bytes=0-${HEAD_BYTES - 1}` } : {};
  let response = await get(url, headers, signal);
  const total = /\/(\d+)$/.exec(response.headers.get('Content-Range') ?? '')?.[1];
  if (response.status === 206 && total === undefined) {
    // Servers elsewhere may send parts without letting this page see of how much: then all is asked for.
    await response.body?.cancel();
    response = await get(url, {}, signal);
  }
  // The length of what is packed says nothing of what comes out.
  const isPacked = response.headers.has('Content-Encoding');
  const length = total ?? (isPacked ? null : response.headers.get('Content-Length'));
  const isPart = response.status === 206;
  const range = async (from: number, to: number) => {
    const part = await get(url, { Range: `bytes=${from}-${to - 1}` }, signal);
    const all = body(part, signal);
    return part.status === 206 ? all : skipped(all, from);
  };
  return {
    name: name ?? fileName(url),
    length: length === null ? null : Number(length),
    pieces: isPart && Number(total) > HEAD_BYTES ? joined(body(response, signal), () => range(HEAD_BYTES, Number(total))) : body(response, signal),
    range: isPart ? range : null,
  };
}

function urlOf(source: string | URL): URL {
  try {
    return new URL(source, typeof document === 'undefined' ? undefined : document.baseURI);
  } catch {
    throw new StriataError('unsupported', `${String(source)} is no URL`);
  }
}

/** The last part of a path; as it is where its escapes are none. */
function fileName(url: URL): string {
  const last = url.pathname.split('/').pop() ?? '';
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}

async function get(url: URL, headers: HeadersInit, signal: AbortSignal): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url, { headers, signal });
  } catch (error) {
    if (signal.aborted) throw error;
    throw new StriataError('network', `${url.href} could not be fetched: ${error instanceof Error ? error.message : String(error)}`,
      'is the server reachable, and does it allow this page to read (CORS)?');
  }
  if (response.ok) return response;
  await response.body?.cancel();
  if (response.status === 416) throw new StriataError('format', `${url.href} is shorter than it should be: the file may be empty`);
  const code = response.status === 404 || response.status === 410 ? 'not-found' : 'network';
  throw new StriataError(code, `${url.href}: the server says ${response.status} ${response.statusText}`.trim());
}

function body(response: Response, signal: AbortSignal): Pieces {
  return response.body ? pieces(response.body, signal) : whole(new Uint8Array());
}

async function* whole(bytes: Uint8Array): AsyncGenerator<Uint8Array, void, undefined> {
  yield bytes;
}

async function* pieces(stream: ReadableStream<Uint8Array>, signal: AbortSignal): AsyncGenerator<Uint8Array, void, undefined> {
  const reader = stream.getReader();
  const stop = () => void reader.cancel(signal.reason).catch(() => undefined);
  signal.addEventListener('abort', stop, { once: true });
  let isOver = false;
  try {
    for (;;) {
      signal.throwIfAborted();
      const { done, value } = await reader.read();
      signal.throwIfAborted();
      if (done) break;
      yield value;
    }
    isOver = true;
  } catch (error) {
    if (signal.aborted || error instanceof StriataError) throw error;
    throw new StriataError('network', `the connection broke: ${error instanceof Error ? error.message : String(error)}`);
  } finally {
    signal.removeEventListener('abort', stop);
    // Who stops reading early wants no more bytes.
    if (!isOver) await reader.cancel().catch(() => undefined);
  }
}

/** Pieces from so many bytes on. */
async function* skipped(from: Pieces, count: number): AsyncGenerator<Uint8Array, void, undefined> {
  try {
    for (let piece = await from.next(); !piece.done; piece = await from.next()) {
      const bytes = piece.value.subarray(count);
      count = Math.max(0, count - piece.value.length);
      if (bytes.length > 0) yield bytes;
    }
  } finally {
    await from.return?.();
  }
}

/** Pieces, and those that are only asked for once these are used up. */
async function* joined(first: Pieces, then: () => Promise<Pieces>): AsyncGenerator<Uint8Array, void, undefined> {
  for (let piece = await first.next(); !piece.done; piece = await first.next()) yield piece.value;
  yield* iterable(await then());
}

/** Bytes that are there already, and then the rest of some pieces. */
export async function* preceded(bytes: Uint8Array, rest: Pieces): AsyncGenerator<Uint8Array, void, undefined> {
  if (bytes.length > 0) yield bytes;
  yield* iterable(rest);
}

/** At most so many bytes. */
export async function* limited(from: Pieces, count: number): AsyncGenerator<Uint8Array, void, undefined> {
  for await (const piece of iterable(from)) {
    yield piece.subarray(0, count);
    count -= piece.length;
    if (count <= 0) return;
  }
}

export { skipped };

export function iterable(from: Pieces): AsyncIterable<Uint8Array> {
  return { [Symbol.asyncIterator]: () => from };
}

/** Several pieces as one. */
export function concatenated(parts: Uint8Array[]): Uint8Array {
  if (parts.length === 1) return parts[0]!;
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
