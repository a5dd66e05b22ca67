/** Where models come from: an address, a file from the reader, or bytes that the page carries. */

/** A model to open. */
export interface Opened {
  source: string | File | ArrayBuffer;
  /** What to call it. */
  name: string;
  /** Where it can be downloaded. */
  url: string | null;
}

export function fromUrl(url: string): Opened {
  return { source: url, name: nameOf(url), url };
}

export function fromFile(file: File): Opened {
  return { source: file, name: file.name, url: null };
}

/** The model of a page that holds everything, from `<script type="text/plain" id="striata-model">`. */
export function fromPage(): Opened | null {
  const holder = document.getElementById('striata-model');
  const text = holder?.textContent?.trim();
  if (!holder || !text) return null;
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let index = 0; index < binary.length; index += 1) bytes[index] = binary.charCodeAt(index);
  return { source: bytes.buffer, name: holder.dataset.name ?? 'model.stri', url: null };
}

/** The last part of an address. */
function nameOf(url: string): string {
  const path = url.split(/[?#]/, 1)[0] ?? url;
  const last = path.split('/').filter(Boolean).at(-1) ?? url;
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}

/** Whether that address lies on another server than this page. */
export function isElsewhere(url: string): boolean {
  try {
    return new URL(url, location.href).origin !== location.origin;
  } catch {
    return false;
  }
}
