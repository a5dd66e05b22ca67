/** The statistics over the stage, and the progress bar for loading. */

import type { Progress, StriataMesh } from '../src/index.ts';
import { formatBytes, formatCount, formatNumber, formatPercent, formatReceived } from './format.ts';
import { element } from './dom.ts';

/** How often the frame rate is updated. */
const FRAME_RATE_INTERVAL_MS = 250;

export class Stats {
  readonly #progress = element('progress');

  constructor(framesPerSecond: () => number) {
    setInterval(() => {
      const frames = framesPerSecond();
      setText('frames', frames > 0 ? `${frames} fps` : 'idle');
    }, FRAME_RATE_INTERVAL_MS);
  }

  /** Shows the statistics of a mesh. */
  show(mesh: StriataMesh): void {
    element('figures').hidden = false;
    const full = Math.max(mesh.fullTriangleCount, mesh.triangleCount);
    setText('triangles', mesh.triangleCount === full ? formatCount(full) : `${formatCount(mesh.triangleCount)} of ${formatCount(full)}`);
    setText('received', formatReceived(mesh.bytesReceived, mesh.complete ? mesh.bytesReceived : mesh.bytesTotal));
    const fraction = mesh.diagonal > 0 ? ` (${formatPercent(mesh.error / mesh.diagonal)})` : '';
    setText('error', mesh.error > 0 ? `${formatNumber(mesh.error)}${fraction}` : 'none');
    setText('change', `${mesh.timings.updateMs.toFixed(1)} ms`);
    // Parts outside the view are as coarse as possible, so this is the largest error anywhere.
    setText('error-name', mesh.pixelError === null ? 'Error' : 'Max error');
    element('pixels-row').hidden = mesh.pixelError === null;
    if (mesh.pixelError !== null) setText('pixels-shown', `≤ ${formatNumber(mesh.pixelError)} px`);
  }

  hide(): void {
    element('figures').hidden = true;
  }

  /** Updates the progress bar; `null` hides it. */
  progress(progress: Progress | null): void {
    const bar = this.#progress;
    bar.hidden = progress === null || progress.phase === 'done';
    if (!progress) return;
    const fraction = fractionOf(progress);
    bar.classList.toggle('unknown', fraction === null);
    bar.style.setProperty('--done', String(fraction ?? 0));
    if (fraction === null) bar.removeAttribute('aria-valuenow');
    else bar.setAttribute('aria-valuenow', String(Math.round(100 * fraction)));
    bar.setAttribute('aria-valuetext', describeProgress(progress));
  }
}

/** Completed fraction of the phase, or `null` if it is unknown. */
function fractionOf(progress: Progress): number | null {
  if (progress.phase === 'build' || progress.bytesTotal === null || progress.bytesTotal === 0) return null;
  return Math.min(progress.bytesReceived / progress.bytesTotal, 1);
}

/** Describes the phase in a few words. */
export function describeProgress(progress: Progress): string {
  if (progress.phase === 'build') return 'building levels of detail';
  const total = progress.bytesTotal === null ? '' : ` of ${formatBytes(progress.bytesTotal)}`;
  return `${formatBytes(progress.bytesReceived)}${total}`;
}

function setText(id: string, text: string): void {
  const node = element(id);
  if (node.textContent !== text) node.textContent = text;
}
