/** Plays the animations of a scene: play and pause, a time slider, and a choice of clips. Hidden if the scene has none. */

import { type AnimationAction, type AnimationClip, AnimationMixer } from 'three';
import type { StriataScene } from '../src/index.ts';
import { announce, createNode, element, input, prefersReducedMotion } from './dom.ts';
import type { Stage } from './stage.ts';
import type { PlaybackState } from './view-state.ts';

/** Steps of the time slider. */
const STEPS = 1000;

export class Playback {
  readonly #stage: Stage;
  readonly #step = (seconds: number): boolean => this.#advance(seconds);
  #mixer: AnimationMixer | null = null;
  #clips: readonly AnimationClip[] = [];
  #action: AnimationAction | null = null;
  #time = 0;
  #isPlaying = false;
  #clip = 0;

  constructor(stage: Stage) {
    this.#stage = stage;
    stage.beforeFrame.add(this.#step);
    element('play').addEventListener('click', () => this.toggle());
    element('clip').addEventListener('change', () => this.#choose(Number(element<HTMLSelectElement>('clip').value)));
    input('time').addEventListener('input', () => {
      // Pausing shows the current time.
      const share = input('time').valueAsNumber / STEPS;
      this.pause();
      this.seek(share * this.duration);
    });
  }

  get isAvailable(): boolean {
    return this.#clips.length > 0;
  }

  get clipCount(): number {
    return this.#clips.length;
  }

  get isPlaying(): boolean {
    return this.#isPlaying;
  }

  /** Time in the clip, seconds. */
  get time(): number {
    return this.#time;
  }

  /** Duration of the clip, seconds. */
  get duration(): number {
    return this.#action?.getClip().duration ?? 0;
  }

  /** Clip, time, and whether it plays; null if the scene has no animation. */
  get state(): PlaybackState | null {
    return this.isAvailable ? { clip: this.#clip, time: this.#time, plays: this.#isPlaying } : null;
  }

  /** Switches to another scene and plays its first clip, or begins at `first`. If the user prefers reduced motion, the clip is paused. */
  setScene(scene: StriataScene | null, first: PlaybackState | null = null): void {
    this.#mixer?.stopAllAction();
    this.#mixer = null;
    this.#action = null;
    this.#isPlaying = false;
    // A copy: a scene adds the clips that arrive later to its own list.
    this.#clips = [...(scene?.animations ?? [])];
    element('playback').hidden = !this.isAvailable;
    if (!scene || !this.isAvailable) return;
    this.#mixer = new AnimationMixer(scene);
    const options = this.#clips.map((clip, index) => {
      const option = createNode('option', '', clip.name || `Animation ${index + 1}`);
      option.value = String(index);
      return option;
    });
    element('clip').replaceChildren(...options);
    element('clip').hidden = options.length < 2;
    this.#choose(first && first.clip < this.#clips.length ? first.clip : 0);
    element<HTMLSelectElement>('clip').value = String(this.#clip);
    if (first) this.seek(first.time);
    if (prefersReducedMotion() || first?.plays === false) this.pause();
    else this.play();
  }

  toggle(): void {
    if (!this.isAvailable) return;
    if (this.#isPlaying) this.pause();
    else this.play();
    announce(this.#isPlaying ? 'Playing' : 'Paused');
  }

  play(): void {
    this.#isPlaying = this.isAvailable;
    this.#refresh();
    this.#stage.invalidate();
  }

  pause(): void {
    this.#isPlaying = false;
    this.#refresh();
  }

  /** Shows the pose at a time, seconds. */
  seek(seconds: number): void {
    this.#time = Math.min(Math.max(seconds, 0), this.duration);
    this.#pose();
    this.#refresh();
    this.#stage.invalidate();
  }

  /** Calls `look` in `count` poses, evenly distributed over the clip, and returns to the pose that is shown. */
  samplePoses(count: number, look: () => void): void {
    const time = this.#time;
    for (let index = 0; index < count; index += 1) {
      this.#time = (this.duration * index) / count;
      this.#pose();
      look();
    }
    this.#time = time;
    this.#pose();
  }

  #choose(index: number): void {
    const clip = this.#clips[index];
    if (!this.#mixer || !clip) return;
    this.#clip = index;
    // Nodes that the next clip does not move return to their own pose.
    this.#mixer.stopAllAction();
    this.#action = this.#mixer.clipAction(clip).play();
    this.seek(0);
  }

  #advance(seconds: number): boolean {
    if (!this.#isPlaying || document.hidden) return false;
    const { duration } = this;
    this.#time = duration > 0 ? (this.#time + seconds) % duration : 0;
    this.#pose();
    this.#refresh();
    return true;
  }

  #pose(): void {
    if (!this.#action) return;
    this.#action.time = this.#time;
    this.#mixer?.update(0);
  }

  #refresh(): void {
    const { duration } = this;
    const slider = input('time');
    slider.value = String(duration > 0 ? Math.round((STEPS * this.#time) / duration) : 0);
    slider.setAttribute('aria-valuetext', `${this.#time.toFixed(2)} of ${duration.toFixed(2)} seconds`);
    element('time-shown').textContent = `${this.#time.toFixed(1)} / ${duration.toFixed(1)} s`;
    const button = element('play');
    button.setAttribute('aria-label', this.#isPlaying ? 'Pause' : 'Play');
    button.classList.toggle('playing', this.#isPlaying);
  }
}
