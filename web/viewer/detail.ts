/**
 * The panel's first group: by what detail is chosen, and how much of it.
 *
 * The inputs hold the state; `apply` gives it to the mesh, also to one that was opened later.
 */

import type { StriataMesh } from '../src/index.ts';
import { count, digits, percent } from './numbers.ts';
import { element, input } from './page.ts';
import { budgetAt, detailAt, pixelsAt, positionOfBudget, positionOfDetail } from './scales.ts';

export type Mode = 'level' | 'pixels' | 'budget';

/** A key press moves the slider by so much. */
const KEY_STEP = 25;

export class Detail {
  readonly #changed: () => void;
  #mesh: StriataMesh | null = null;
  /** Views can be refined from when all is there. */
  #hasViews = false;
  #budget: number | null = null;

  /** `changed` is called after the mesh was asked for something else. */
  constructor(changed: () => void) {
    this.#changed = changed;
    for (const radio of this.#radios()) radio.addEventListener('change', () => this.apply());
    for (const id of ['detail', 'pixels']) input(id).addEventListener('input', () => this.apply());
    input('budget').addEventListener('input', () => this.#slideBudget());
    const typed = input('budget-typed');
    typed.addEventListener('change', () => this.#typeBudget());
    typed.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.#typeBudget();
    });
    input('freeze').addEventListener('change', () => this.apply());
    this.#show();
  }

  get mode(): Mode {
    return (this.#radios().find((radio) => radio.checked)?.value ?? 'level') as Mode;
  }

  get isFrozen(): boolean {
    return this.mode === 'pixels' && input('freeze').checked;
  }

  /** Whether the mode is there; view-dependent detail waits until all has come. */
  choose(mode: Mode): boolean {
    const radio = this.#radios().find((radio) => radio.value === mode);
    if (!radio || radio.disabled) return false;
    radio.checked = true;
    this.apply();
    return true;
  }

  freeze(isFrozen: boolean): boolean {
    if (isFrozen && !this.choose('pixels')) return false;
    input('freeze').checked = isFrozen;
    this.apply();
    return true;
  }

  /** One step of the slider in use, towards more detail (1) or less (-1). */
  step(towards: 1 | -1): void {
    const id = this.mode === 'level' ? 'detail' : this.mode;
    const slider = input(id);
    slider.valueAsNumber += (this.mode === 'pixels' ? -towards : towards) * KEY_STEP;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }

  /** Another mesh, with what is asked for now. */
  take(mesh: StriataMesh | null): void {
    this.#mesh = mesh;
    this.#hasViews = false;
    input('freeze').checked = false;
    if (this.mode === 'pixels') this.#check('level');
    if (this.mode === 'budget') this.#slideBudget();
    else this.apply();
  }

  /** All is there: views can be asked for. */
  allowViews(): void {
    this.#hasViews = true;
    this.#show();
  }

  /** Gives the mesh what the inputs say. */
  apply(): void {
    const mesh = this.#mesh;
    if (this.mode !== 'pixels') input('freeze').checked = false;
    if (mesh) {
      if (this.mode === 'level') {
        mesh.frozen = false;
        mesh.triangleBudget = null;
        mesh.detail = detailAt(input('detail').valueAsNumber);
      } else if (this.mode === 'pixels') {
        mesh.triangleBudget = null;
        mesh.pixelError = pixelsAt(input('pixels').valueAsNumber);
        mesh.frozen = input('freeze').checked;
      } else {
        mesh.frozen = false;
        mesh.detail = 1;
        mesh.triangleBudget = this.#budget ?? mesh.fullTriangleCount;
      }
    }
    this.#show();
    this.#changed();
  }

  /** The inputs after the mesh has changed: what a budget came to, how many triangles there are. */
  #show(): void {
    const { mode } = this;
    for (const row of document.querySelectorAll<HTMLElement>('#detail-set [data-mode]')) row.hidden = row.dataset.mode !== mode;
    element('freeze-row').hidden = mode !== 'pixels';
    const isWaiting = this.#mesh !== null && !this.#hasViews;
    for (const radio of this.#radios()) if (radio.value === 'pixels') radio.disabled = !this.#hasViews;
    const note = element('mode-note');
    note.hidden = !isWaiting;
    note.textContent = 'Pixels can be chosen when all of the model is there.';
    const detail = detailAt(input('detail').valueAsNumber);
    speak('detail', 'detail-shown', percent(detail));
    speak('pixels', 'pixels-asked', `${digits(pixelsAt(input('pixels').valueAsNumber))} px`);
    this.#showBudget();
  }

  #showBudget(): void {
    const typed = input('budget-typed');
    const full = this.#mesh?.fullTriangleCount ?? 0;
    if (document.activeElement !== typed) typed.value = String(this.#budget ?? full);
    input('budget').setAttribute('aria-valuetext', `${count(this.#budget ?? full)} triangles`);
  }

  #slideBudget(): void {
    this.#budget = budgetAt(input('budget').valueAsNumber, this.#mesh?.fullTriangleCount ?? 0);
    input('budget-typed').value = String(this.#budget);
    this.apply();
  }

  #typeBudget(): void {
    const typed = input('budget-typed');
    const full = this.#mesh?.fullTriangleCount ?? 0;
    // An emptied or impossible number means all of them.
    const asked = Number.isFinite(typed.valueAsNumber) && typed.valueAsNumber >= 1 ? Math.floor(typed.valueAsNumber) : full;
    this.#budget = Math.min(asked, full);
    typed.value = String(this.#budget);
    input('budget').value = String(positionOfBudget(this.#budget, full));
    this.apply();
  }

  #check(mode: Mode): void {
    for (const radio of this.#radios()) radio.checked = radio.value === mode;
  }

  #radios(): HTMLInputElement[] {
    return [...document.querySelectorAll<HTMLInputElement>('input[name="mode"]')];
  }
}

/** Sets the slider of a detail, for pages that open at one. */
export function setDetail(detail: number): void {
  const slider = input('detail');
  slider.value = String(positionOfDetail(Math.min(Math.max(detail, 0), 1)));
  slider.dispatchEvent(new Event('input', { bubbles: true }));
}

function speak(id: string, shown: string, text: string): void {
  input(id).setAttribute('aria-valuetext', text);
  element(shown).textContent = text;
}
