/** Sources of models: a URL, a local file, or bytes embedded in the page. */

import type { ViewState } from './view-state.ts';

/** A model to open. */
export interface ModelSource {
  data: string | File | ArrayBuffer;
  /** Name to display. */
  name: string;
  /** Where the model can be downloaded, if anywhere. */
  url: string | null;
  /** How it is shown at first, if not as a whole. */
  view?: ViewState | null;
  /** Whether the page contains it. */
  isEmbedded?: boolean;
}

export function fromUrl(url: string, view: ViewState | null = null): ModelSource {
  return { data: url, name: nameOf(url), url, view };
}

export function fromFile(file: File): ModelSource {
  return { data: file, name: file.name, url: null };
}

/** The model embedded in a self-contained page as `<script type="text/plain" id="striata-model">`, if any. */
export function embeddedModel(): ModelSource | null {
  const holder = document.getElementById('striata-model');
  const text = holder?.textContent?.trim();
  if (!holder || !text) return null;
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let index = 0; index < binary.length; index += 1) bytes[index] = binary.charCodeAt(index);
  return { data: bytes.buffer, name: holder.dataset.name ?? 'model.stri', url: null, isEmbedded: true };
}

/** Last path segment of a URL. */
function nameOf(url: string): string {
  const path = url.split(/[?#]/, 1)[0] ?? url;
  const last = path.split('/').filter(Boolean).at(-1) ?? url;
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}

/** Whether a URL points to another origin than this page. */
export function isCrossOrigin(url: string): boolean {
  try {
    return new URL(url, location.href).origin !== location.origin;
  } catch {
    return false;
  }
}
