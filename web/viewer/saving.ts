/** Saves the model as a stream or a GLB file, or the level that is shown, with its progress in the panel. */

import { StriataError } from '../src/index.ts';
import { announce, element, setVisible } from './dom.ts';
import type { SavedFormat } from './encode-worker.ts';
import { encodeModel } from './encoder.ts';
import { formatBytes } from './format.ts';
import { notify } from './notices.ts';
import type { ModelSource } from './sources.ts';

const FORMATS: SavedFormat[] = ['level', 'stri', 'glb'];

export class Saving {
  #source: ModelSource | null = null;
  #abort: AbortController | null = null;
  readonly #shownTriangles: () => number;

  /** `shownTriangles` counts the triangles of the level that is shown. */
  constructor(shownTriangles: () => number) {
    this.#shownTriangles = shownTriangles;
    for (const format of FORMATS) element(`save-${format}`).addEventListener('click', () => void this.save(format));
    element('cancel-saving').addEventListener('click', () => this.cancel());
  }

  /** Sets the model that the buttons save. Saving another one goes on. */
  setSource(source: ModelSource | null): void {
    this.#source = source;
    for (const format of FORMATS) element<HTMLButtonElement>(`save-${format}`).disabled = source === null;
    const isStream = source !== null && /\.stri$/i.test(source.name);
    // A stream would only be encoded again.
    setVisible('save-stri', !isStream);
  }

  cancel(): void {
    this.#abort?.abort();
  }

  /** Encodes the model, and offers the result as a download. */
  async save(format: SavedFormat): Promise<void> {
    const source = this.#source;
    if (!source || this.#abort) return;
    const abort = new AbortController();
    this.#abort = abort;
    const stem = stemOf(source.name);
    const triangles = this.#shownTriangles();
    const name = format === 'level' ? `${stem}-${triangles}.glb` : `${stem}.${format}`;
    this.#show(name, 'read', 0);
    announce(`Saving ${name}`);
    try {
      const blob = await encodeModel(source, { format, triangles }, abort.signal, (phase, share) => this.#show(name, phase, share));
      download(blob, name);
      announce(`Saved ${name}, ${formatBytes(blob.size)}`);
    } catch (error) {
      if (abort.signal.aborted) announce('Saving was canceled');
      else this.#report(name, error, format);
    } finally {
      this.#abort = null;
      setVisible('saving', false);
    }
  }

  #show(name: string, phase: string, share: number): void {
    setVisible('saving', true);
    const percent = Math.floor(100 * share);
    element('saving-text').textContent = `${name}: ${phase} ${percent}%`;
    element<HTMLProgressElement>('saving-bar').value = percent;
  }

  #report(name: string, error: unknown, format: SavedFormat): void {
    const known = error instanceof StriataError ? error : null;
    const reason = error instanceof Error ? error.message : String(error);
    notify({ title: `Cannot save ${name}`, reason, hint: known?.hint, retry: () => void this.save(format) });
  }
}

/** Name of a file without its extensions. */
export function stemOf(name: string): string {
  return name.replace(/(\.\w+)?(\.gz|\.zst)?$/i, '') || 'model';
}

/** Offers a file as a download. */
export function download(blob: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser needs the address until the download has begun.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
