/** Reads ranges of a paged file: of a file or folder on a web server, or of a local file. */

import { StriataError } from '../error.ts';
import type { Source } from '../types.ts';

/** Where a paged file is; can be posted to a worker. */
export type PagedPlace =
  | { url: string; headers: Record<string, string>; credentials: RequestCredentials }
  | { blob: Blob; name: string };

/** Where a source is, if parts of it can be read. */
export function placeOf(source: Source, name: string, headers: Record<string, string> = {}, credentials: RequestCredentials = 'same-origin'): PagedPlace {
  if (source instanceof Blob) return { blob: source, name };
  if (source instanceof ArrayBuffer) return { blob: new Blob([source]), name };
  if (typeof source === 'string' || source instanceof URL) {
    return { url: new URL(source, typeof document === 'undefined' ? undefined : document.baseURI).href, headers, credentials };
  }
  throw new StriataError('unsupported', 'a paged file cannot be read from a stream of bytes', 'pass its address, or a file');
}

/** Name of a place, for messages. */
export const nameOf = (place: PagedPlace): string => ('blob' in place ? place.name : place.url);

/** Reads bytes of an object of the folder, or of the file itself if the path is empty; fewer if it ends before. */
export async function readRange(place: PagedPlace, path: string, from: number, to: number, signal: AbortSignal): Promise<Uint8Array> {
  if ('blob' in place) {
    if (path !== '') throw new StriataError('unsupported', `${place.name} refers to pages in other files`, 'open the folder through a web server');
    return new Uint8Array(await place.blob.slice(from, to).arrayBuffer());
  }
  const url = path === '' ? place.url : new URL(path, place.url).href;
  const headers = { ...place.headers, Range: `bytes=${from}-${to - 1}` };
  let response: Response;
  try {
    response = await fetch(url, { headers, credentials: place.credentials, signal });
  } catch (error) {
    if (signal.aborted) throw error;
    throw new StriataError('network', `cannot fetch ${url}: ${error instanceof Error ? error.message : String(error)}`, 'check that the server is reachable and allows requests from this page (CORS)');
  }
  if (response.status === 206) return new Uint8Array(await response.arrayBuffer());
  // Small objects may be sent whole; of large files that would be everything.
  const length = Number(response.headers.get('Content-Length') ?? Infinity);
  if (response.status === 200 && (path !== '' || length <= to)) return new Uint8Array(await response.arrayBuffer()).subarray(from, to);
  await response.body?.cancel();
  if (response.ok) throw new StriataError('unsupported', `${url}: the server does not send parts of files`, 'paged files need a server that answers range requests, as `striata serve` does');
  const code = response.status === 404 || response.status === 410 ? 'not-found' : 'network';
  throw new StriataError(code, `${url}: the server responded with ${response.status} ${response.statusText}`.trim());
}
