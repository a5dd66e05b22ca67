/** The statistics over the stage, and the progress bar for loading. */

import type { Progress, StriataScene } from '../src/index.ts';
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

  /** Shows the statistics of a model. */
  show(model: StriataScene): void {
    element('figures').hidden = false;
    const full = Math.max(model.fullTriangleCount, model.triangleCount);
    setText('triangles', model.triangleCount === full ? formatCount(full) : `${formatCount(model.triangleCount)} of ${formatCount(full)}`);
    setText('received', formatReceived(model.bytesReceived, model.complete ? model.bytesReceived : model.bytesTotal));
    const fraction = model.diagonal > 0 ? ` (${formatPercent(model.error / model.diagonal)})` : '';
    setText('error', model.error > 0 ? `${formatNumber(model.error)}${fraction}` : 'none');
    setText('change', `${model.timings.updateMs.toFixed(1)} ms`);
    // Parts outside the view are as coarse as possible, so this is the largest error anywhere.
    setText('error-name', model.pixelError === null ? 'Error' : 'Max error');
    element('pixels-row').hidden = model.pixelError === null;
    if (model.pixelError !== null) setText('pixels-shown', `≤ ${formatNumber(model.pixelError)} px`);
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
  if (progress.phase === 'build') return progress.share ?? null;
  if (progress.bytesTotal === null || progress.bytesTotal === 0) return null;
  return Math.min(progress.bytesReceived / progress.bytesTotal, 1);
}

/** Describes the phase in a few words. */
export function describeProgress(progress: Progress): string {
  const fraction = fractionOf(progress);
  const percent = fraction === null ? '' : `, ${Math.floor(100 * fraction)}%`;
  if (progress.phase === 'build') return `building levels of detail${percent}`;
  const total = progress.bytesTotal === null ? '' : ` of ${formatBytes(progress.bytesTotal)}`;
  return `${formatBytes(progress.bytesReceived)}${total}${percent}`;
}

function setText(id: string, text: string): void {
  const node = element(id);
  if (node.textContent !== text) node.textContent = text;
}
