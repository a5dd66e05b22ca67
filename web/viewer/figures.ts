/** The figures over the stage, and the line that shows how far loading has come. */

import type { Progress, StriataMesh } from '../src/index.ts';
import { bytes, count, digits, percent, share } from './numbers.ts';
import { element } from './page.ts';

/** Frames are looked at so often. */
const FRAMES_EVERY_MS = 250;

export class Figures {
  readonly #progress = element('progress');

  constructor(framesPerSecond: () => number) {
    setInterval(() => {
      const frames = framesPerSecond();
      put('frames', frames > 0 ? `${frames} a second` : 'at rest');
    }, FRAMES_EVERY_MS);
  }

  /** Of the mesh that is shown. */
  show(mesh: StriataMesh): void {
    element('figures').hidden = false;
    const full = Math.max(mesh.fullTriangleCount, mesh.triangleCount);
    put('triangles', mesh.triangleCount === full ? count(full) : `${count(mesh.triangleCount)} of ${count(full)}`);
    put('received', share(mesh.bytesReceived, mesh.complete ? mesh.bytesReceived : mesh.bytesTotal));
    const part = mesh.diagonal > 0 ? ` (${percent(mesh.error / mesh.diagonal)})` : '';
    put('error', mesh.error > 0 ? `${digits(mesh.error)}${part}` : 'none');
    put('change', `${mesh.timings.updateMs.toFixed(1)} ms`);
    // Out of sight it is as coarse as can be.
    put('error-name', mesh.pixelError === null ? 'Error' : 'Largest error');
    element('pixels-row').hidden = mesh.pixelError === null;
    if (mesh.pixelError !== null) put('pixels-shown', `≤ ${digits(mesh.pixelError)} px`);
  }

  hide(): void {
    element('figures').hidden = true;
  }

  /** The slim line; `null` takes it away. */
  progress(progress: Progress | null): void {
    const line = this.#progress;
    line.hidden = progress === null || progress.phase === 'done';
    if (!progress) return;
    const part = partOf(progress);
    line.classList.toggle('unknown', part === null);
    line.style.setProperty('--done', String(part ?? 0));
    if (part === null) line.removeAttribute('aria-valuenow');
    else line.setAttribute('aria-valuenow', String(Math.round(100 * part)));
    line.setAttribute('aria-valuetext', words(progress));
  }
}

/** How much of the phase is done, where that is known. */
function partOf(progress: Progress): number | null {
  if (progress.phase === 'build' || progress.bytesTotal === null || progress.bytesTotal === 0) return null;
  return Math.min(progress.bytesReceived / progress.bytesTotal, 1);
}

/** What is going on. */
export function words(progress: Progress): string {
  if (progress.phase === 'build') return 'building levels';
  const total = progress.bytesTotal === null ? '' : ` of ${bytes(progress.bytesTotal)}`;
  return `${bytes(progress.bytesReceived)}${total}`;
}

function put(id: string, text: string): void {
  const node = element(id);
  if (node.textContent !== text) node.textContent = text;
}
