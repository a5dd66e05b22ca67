/**
 * The panel's first group of controls: how detail is chosen (level, screen error, triangle budget), and how much of it.
 *
 * The inputs are the state. `apply` passes it to the model, including a model that is opened later.
 */

import type { StriataScene } from '../src/index.ts';
import { formatCount, formatNumber, formatPercent } from './format.ts';
import { element, input } from './dom.ts';
import { budgetAt, detailAt, pixelsAt, positionOfBudget, positionOfDetail, positionOfPixels } from './scales.ts';
import type { LevelChoice } from './view-state.ts';

export type Mode = 'level' | 'pixels' | 'budget';

/** Slider units that one key press moves. */
const KEY_STEP = 25;

export class DetailControls {
  readonly #onChange: () => void;
  #model: StriataScene | null = null;
  /** Whether view-dependent refinement is available, which is once the model has loaded completely. */
  #isViewAvailable = false;
  #budget: number | null = null;
  /** What is to be chosen as soon as the model allows it. */
  #wanted: LevelChoice | null = null;

  /** `onChange` is called after new settings were passed to the model. */
  constructor(onChange: () => void) {
    this.#onChange = onChange;
    for (const radio of this.#radios()) radio.addEventListener('change', () => this.#onChosen());
    for (const id of ['detail', 'pixels']) input(id).addEventListener('input', () => this.#onChosen());
    input('budget').addEventListener('input', () => this.#onBudgetSlider());
    const typed = input('budget-typed');
    typed.addEventListener('change', () => this.#onBudgetTyped());
    typed.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.#onBudgetTyped();
    });
    input('freeze').addEventListener('change', () => this.apply());
    this.#refresh();
  }

  get mode(): Mode {
    return (this.#radios().find((radio) => radio.checked)?.value ?? 'level') as Mode;
  }

  /** How the level is chosen, or will be once the model has loaded; null if a model begins with it. */
  get choice(): LevelChoice | null {
    if (!this.#model || this.#wanted) return this.#wanted;
    const { mode } = this;
    if (mode === 'level') {
      const value = detailAt(input('detail').valueAsNumber);
      return value === 1 && this.#model.kind !== 'paged' ? null : { mode, value };
    }
    if (mode === 'pixels') return { mode, value: pixelsAt(input('pixels').valueAsNumber) };
    return { mode, value: this.#budget ?? this.#model.fullTriangleCount };
  }

  /** The level that a multiresolution model is to show. */
  get inspected(): { by: 'detail' | 'triangles' | 'view'; value: number } {
    const { mode } = this;
    if (mode === 'pixels') return { by: 'view', value: pixelsAt(input('pixels').valueAsNumber) };
    if (mode === 'budget') return { by: 'triangles', value: this.#budget ?? this.#model?.fullTriangleCount ?? 0 };
    return { by: 'detail', value: detailAt(input('detail').valueAsNumber) };
  }

  /** Chooses the level, as soon as the model allows that; `null` is full detail. */
  restore(choice: LevelChoice | null): void {
    this.#wanted = choice ?? { mode: 'level', value: 1 };
    if (this.#model) this.#fulfill(this.#model);
  }

  get isFrozen(): boolean {
    return this.mode === 'pixels' && input('freeze').checked;
  }

  /** Selects a mode and returns whether it is available; view-dependent detail needs a completely loaded model. */
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

  /** Moves the active slider by one step, toward more detail (1) or less (-1). */
  step(direction: 1 | -1): void {
    const id = this.mode === 'level' ? 'detail' : this.mode;
    const slider = input(id);
    slider.valueAsNumber += (this.mode === 'pixels' ? -direction : direction) * KEY_STEP;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }

  /** Switches to another model and applies the current settings to it. */
  setModel(model: StriataScene | null): void {
    this.#model = model;
    this.#isViewAvailable = false;
    input('freeze').checked = false;
    if (this.mode === 'pixels') this.#select('level');
    if (model?.kind === 'paged') {
      this.#isViewAvailable = true;
      this.#select('pixels');
    }
    if (this.#wanted && model) this.#fulfill(model);
    else if (this.mode === 'budget') this.#onBudgetSlider();
    else this.apply();
  }

  /** Enables view-dependent detail, after the model has loaded completely. */
  enableViews(): void {
    this.#isViewAvailable = true;
    if (this.#wanted && this.#model) this.#fulfill(this.#model);
    this.#refresh();
  }

  /** Chooses what is wanted, if that is possible already. */
  #fulfill(model: StriataScene): void {
    const wanted = this.#wanted;
    if (!wanted) return;
    const { mode, value } = wanted;
    if (mode === 'level') input('detail').value = String(positionOfDetail(value));
    else if (mode === 'pixels') input('pixels').value = String(positionOfPixels(value));
    else {
      this.#budget = Math.min(value, model.fullTriangleCount);
      input('budget').value = String(positionOfBudget(this.#budget, model.fullTriangleCount));
    }
    if (mode !== 'pixels' || this.#isViewAvailable) {
      this.#wanted = null;
      this.#select(mode);
    }
    this.apply();
  }

  /** The user's own choice replaces what was wanted. */
  #onChosen(): void {
    this.#wanted = null;
    this.apply();
  }

  /** Passes the state of the inputs to the model. */
  apply(): void {
    const model = this.#model;
    if (this.mode !== 'pixels') input('freeze').checked = false;
    if (model) {
      if (this.mode === 'level') {
        model.frozen = false;
        model.triangleBudget = null;
        model.detail = detailAt(input('detail').valueAsNumber);
      } else if (this.mode === 'pixels') {
        model.triangleBudget = null;
        model.pixelError = pixelsAt(input('pixels').valueAsNumber);
        model.frozen = input('freeze').checked;
      } else {
        model.frozen = false;
        model.detail = 1;
        model.triangleBudget = this.#budget ?? model.fullTriangleCount;
      }
    }
    this.#refresh();
    this.#onChange();
  }

  /** Updates the inputs and their labels. */
  #refresh(): void {
    const { mode } = this;
    for (const row of document.querySelectorAll<HTMLElement>('#detail-set [data-mode]')) row.hidden = row.dataset.mode !== mode;
    element('freeze-row').hidden = mode !== 'pixels';
    const isWaiting = this.#model !== null && !this.#isViewAvailable;
    for (const radio of this.#radios()) if (radio.value === 'pixels') radio.disabled = !this.#isViewAvailable;
    const note = element('mode-note');
    note.hidden = !isWaiting;
    note.textContent = 'Screen error is available once the model has loaded.';
    const detail = detailAt(input('detail').valueAsNumber);
    showValue('detail', 'detail-value', formatPercent(detail));
    showValue('pixels', 'pixels-value', `${formatNumber(pixelsAt(input('pixels').valueAsNumber))} px`);
    this.#refreshBudget();
  }

  #refreshBudget(): void {
    const typed = input('budget-typed');
    const full = this.#model?.fullTriangleCount ?? 0;
    if (document.activeElement !== typed) typed.value = String(this.#budget ?? full);
    input('budget').setAttribute('aria-valuetext', `${formatCount(this.#budget ?? full)} triangles`);
  }

  #onBudgetSlider(): void {
    this.#wanted = null;
    this.#budget = budgetAt(input('budget').valueAsNumber, this.#model?.fullTriangleCount ?? 0);
    input('budget-typed').value = String(this.#budget);
    this.apply();
  }

  #onBudgetTyped(): void {
    const typed = input('budget-typed');
    const full = this.#model?.fullTriangleCount ?? 0;
    // An empty or invalid number means no limit.
    const requested = Number.isFinite(typed.valueAsNumber) && typed.valueAsNumber >= 1 ? Math.floor(typed.valueAsNumber) : full;
    this.#wanted = null;
    this.#budget = Math.min(requested, full);
    typed.value = String(this.#budget);
    input('budget').value = String(positionOfBudget(this.#budget, full));
    this.apply();
  }

  #select(mode: Mode): void {
    for (const radio of this.#radios()) radio.checked = radio.value === mode;
  }

  #radios(): HTMLInputElement[] {
    return [...document.querySelectorAll<HTMLInputElement>('input[name="mode"]')];
  }
}

function showValue(id: string, outputId: string, text: string): void {
  input(id).setAttribute('aria-valuetext', text);
  element(outputId).textContent = text;
}
