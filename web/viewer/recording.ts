/** Records a short video of the stage: a turn of the model, or its detail from coarse to full. */

import { announce, element } from './dom.ts';
import { notify } from './notices.ts';
import { download, stemOf } from './saving.ts';
import type { Viewer } from './viewer.ts';

/** Length of a video. */
const SECONDS = 6;

/** Share of a video of the detail after which the full model is shown. */
const FULL_FROM = 0.85;

/** How long the first level of a video is waited for. */
const PATIENCE_MS = 2000;

const FRAME_RATE = 30;
const BITS_PER_SECOND = 12e6;

const TYPES = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

export type Motion = 'turn' | 'detail';

export class Recording {
  readonly #viewer: Viewer;
  #abort: AbortController | null = null;

  constructor(viewer: Viewer) {
    this.#viewer = viewer;
    element('record').addEventListener('click', () => this.toggle());
    document.addEventListener('visibilitychange', () => {
      if (document.hidden) this.cancel();
    });
  }

  get isOn(): boolean {
    return this.#abort !== null;
  }

  /** Starts recording, or cancels it. */
  toggle(): void {
    if (this.isOn) this.cancel();
    else void this.#save(element<HTMLSelectElement>('motion').value as Motion);
  }

  cancel(): void {
    this.#abort?.abort();
  }

  async #save(motion: Motion): Promise<void> {
    const { model, name: file } = this.#viewer;
    if (!model) return;
    const type = recordableType();
    if (!type) {
      notify({ title: 'This browser cannot record videos', reason: 'It has no encoder for WebM.', hint: 'Try Firefox or Chrome.' });
      return;
    }
    const abort = new AbortController();
    this.#abort = abort;
    const name = `${stemOf(file)}-${motion}.webm`;
    announce(`Recording ${name}`);
    try {
      const video = await this.#record(motion, type, abort.signal);
      if (abort.signal.aborted) announce('Recording was canceled');
      else {
        download(video, name);
        announce(`Saved ${name}`);
      }
    } catch (error) {
      notify({ title: `Cannot save ${name}`, reason: error instanceof Error ? error.message : String(error) });
    } finally {
      this.#abort = null;
      element('record').textContent = 'Save video';
    }
  }

  async #record(motion: Motion, type: string, signal: AbortSignal): Promise<Blob> {
    const { stage } = this.#viewer;
    const stream = stage.renderer.domElement.captureStream(FRAME_RATE);
    const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: BITS_PER_SECOND });
    const parts: Blob[] = [];
    recorder.ondataavailable = ({ data }) => parts.push(data);
    const stopped = new Promise<void>((resolve, reject) => {
      recorder.onstop = () => resolve();
      recorder.onerror = () => reject(new Error('the browser could not encode the video'));
    });
    const finish = this.#begin(motion);
    try {
      if (motion === 'detail') await this.#coarsest(signal);
      recorder.start();
      await this.#play(motion, signal);
      if (recorder.state !== 'inactive') recorder.stop();
      await stopped;
    } finally {
      for (const track of stream.getTracks()) track.stop();
      finish();
    }
    return new Blob(parts, { type: 'video/webm' });
  }

  /** Takes the camera and the detail, and returns what gives them back. */
  #begin(motion: Motion): () => void {
    const { stage, framing, detail, model } = this.#viewer;
    const { controls } = stage;
    const [turns, pose, choice] = [controls.autoRotate, framing.pose(), detail.choice];
    controls.enabled = false;
    controls.autoRotate = false;
    if (motion === 'detail') detail.choose('level');
    return () => {
      controls.enabled = true;
      controls.autoRotate = turns;
      if (this.#viewer.model !== model) return;
      if (motion === 'turn') framing.moveTo(pose);
      else detail.restore(choice);
    };
  }

  /** Shows the coarsest level, which a video begins with. */
  async #coarsest(signal: AbortSignal): Promise<void> {
    const { stage, detail, model } = this.#viewer;
    detail.restore({ mode: 'level', value: 0 });
    const latest = performance.now() + PATIENCE_MS;
    while (model && model.splitCount > 0 && !signal.aborted && performance.now() < latest) {
      stage.invalidate();
      await new Promise((resolve) => setTimeout(resolve, 1000 / FRAME_RATE));
    }
  }

  /** Moves the stage for the length of a video. */
  #play(motion: Motion, signal: AbortSignal): Promise<void> {
    const { stage, framing, detail } = this.#viewer;
    const started = performance.now();
    let before = 0;
    return new Promise((resolve) => {
      const step = (): boolean => {
        const share = Math.min((performance.now() - started) / (1000 * SECONDS), 1);
        if (motion === 'turn') framing.orbit(2 * Math.PI * (share - before), 0);
        else detail.restore({ mode: 'level', value: Math.min(share / FULL_FROM, 1) ** 3 });
        before = share;
        element('record').textContent = `Cancel (${Math.floor(100 * share)}%)`;
        if (share < 1 && !signal.aborted && this.#viewer.model) return true;
        stage.beforeFrame.delete(step);
        // The last frame still has to be drawn.
        setTimeout(resolve, 1000 / FRAME_RATE);
        return false;
      };
      stage.beforeFrame.add(step);
      signal.addEventListener('abort', () => {
        stage.beforeFrame.delete(step);
        resolve();
      });
      stage.invalidate();
    });
  }
}

/** A type of video that the browser records from a canvas, if any. */
function recordableType(): string | undefined {
  if (typeof MediaRecorder === 'undefined' || !('captureStream' in HTMLCanvasElement.prototype)) return undefined;
  return TYPES.find((type) => MediaRecorder.isTypeSupported(type));
}
