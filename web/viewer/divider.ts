/** A divider over the stage that is dragged with the mouse or a finger, or moved by keys. */

/** Part of the width that an arrow key moves it by, and with Shift. */
const STEP = 0.02;
const LARGE_STEP = 0.1;

export class Divider {
  readonly #handle: HTMLElement;
  readonly #onMove: () => void;
  #fraction = 0.5;

  /** `onMove` is called when the user has moved the divider. */
  constructor(handle: HTMLElement, onMove: () => void) {
    this.#handle = handle;
    this.#onMove = onMove;
    handle.addEventListener('keydown', (event) => this.#onKey(event));
    handle.addEventListener('pointerdown', (event) => this.#onPointerDown(event));
    this.#show();
  }

  /** Position as a fraction of the width, from the left. */
  get fraction(): number {
    return this.#fraction;
  }

  set fraction(fraction: number) {
    this.#fraction = Math.min(Math.max(fraction, 0), 1);
    this.#show();
    this.#onMove();
  }

  #onPointerDown(event: PointerEvent): void {
    if (event.button !== 0) return;
    event.preventDefault();
    const handle = this.#handle;
    handle.focus({ preventScroll: true });
    handle.setPointerCapture(event.pointerId);
    const stop = new AbortController();
    const move = ({ clientX, pointerId }: PointerEvent): void => {
      const track = handle.parentElement?.getBoundingClientRect();
      if (pointerId === event.pointerId && track && track.width > 0) this.fraction = (clientX - track.left) / track.width;
    };
    handle.addEventListener('pointermove', move, stop);
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      handle.addEventListener(end, () => stop.abort(), stop);
    }
  }

  #onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? LARGE_STEP : STEP;
    const targets: Record<string, number> = {
      ArrowLeft: this.#fraction - step, ArrowRight: this.#fraction + step, Home: 0, End: 1,
      PageUp: this.#fraction - LARGE_STEP, PageDown: this.#fraction + LARGE_STEP,
    };
    const target = targets[event.key];
    if (target === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    this.fraction = target;
  }

  #show(): void {
    this.#handle.setAttribute('aria-valuenow', String(Math.round(100 * this.#fraction)));
    this.#handle.setAttribute('aria-valuetext', `${Math.round(100 * this.#fraction)}% from the left`);
  }
}
