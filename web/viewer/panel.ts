/** The other controls of the panel: colors, shading, background, auto-rotation, full screen, images. */

import type { Coloring } from '../src/index.ts';
import { announce, element, input, prefersReducedMotion } from './dom.ts';
import { download } from './saving.ts';
import { themeColor } from './theme.ts';
import type { Viewer } from './viewer.ts';

const BACKGROUNDS: Record<string, string> = { white: '#ffffff', gray: '#808080', black: '#000000' };

/** Windows at least this wide show the panel at the side. */
const isWide = matchMedia('(min-width: 701px)');

export class Panel {
  readonly #viewer: Viewer;

  constructor(viewer: Viewer) {
    this.#viewer = viewer;
    element('controls').addEventListener('submit', (event) => event.preventDefault());
    for (const radio of this.#colorings()) radio.addEventListener('change', () => this.#onLookChanged());
    for (const id of ['wireframe', 'flat']) input(id).addEventListener('change', () => this.#onLookChanged());
    input('z-up').addEventListener('change', () => viewer.setZUp(input('z-up').checked));
    input('turn').addEventListener('change', () => this.#onAutoRotateChanged());
    element('background').addEventListener('change', () => this.paintBackground());
    element('reset').addEventListener('click', () => this.reset());
    element('full').addEventListener('click', () => void this.#fullScreen());
    element('picture').addEventListener('click', () => void this.saveImage());
    for (const id of ['fold', 'handle']) element(id).addEventListener('click', () => this.fold());
    this.fold(!isWide.matches);
    isWide.addEventListener('change', () => this.fold(!isWide.matches));
    document.addEventListener('fullscreenchange', () => {
      element('full').textContent = document.fullscreenElement ? 'Exit full screen' : 'Full screen';
    });
    element('full').hidden = !document.fullscreenEnabled;
  }

  /** Toggles a switch, as its key does. */
  toggle(id: string, name: string): void {
    const box = input(id);
    box.click();
    announce(`${name} ${box.checked ? 'on' : 'off'}`);
  }

  /** Selects a coloring. */
  setColoring(coloring: Coloring): void {
    const radio = this.#colorings().find((radio) => radio.value === coloring);
    if (radio?.disabled) return announce('Two levels are compared by their surface');
    radio?.click();
    announce(`Color by ${coloring === 'triangles' ? 'triangle' : coloring.replace(/s$/, '')}`);
  }

  /** Toggles between coloring by strip and the surface's own colors. */
  toggleStrips(): void {
    this.setColoring(this.#viewer.look.coloring === 'strips' ? 'surface' : 'strips');
  }

  /** Selects the next coloring. */
  nextColoring(): void {
    const radios = this.#colorings();
    if (radios.some((radio) => radio.disabled)) return announce('Two levels are compared by their surface');
    const next = radios[(radios.findIndex((radio) => radio.checked) + 1) % radios.length];
    if (next) this.setColoring(next.value as Coloring);
  }

  paintBackground(): void {
    const chosen = element<HTMLSelectElement>('background').value;
    this.#viewer.stage.setBackground(BACKGROUNDS[chosen] ?? themeColor('--stage'));
  }

  reset(): void {
    this.#viewer.detail.freeze(false);
    this.#viewer.framing.reset();
  }

  /** Shows or hides the controls; toggles them by default. */
  fold(isFolded = !element('app').classList.contains('folded')): void {
    element('app').classList.toggle('folded', isFolded);
    for (const id of ['fold', 'handle']) element(id).setAttribute('aria-expanded', String(!isFolded));
  }

  /** Saves the stage as an image file. */
  async saveImage(): Promise<void> {
    download(await this.#viewer.stage.toPng(), `${this.#viewer.name.replace(/\.\w+$/, '')}.png`);
  }

  /** Updates the panel for the model that is shown. */
  onModelShown(): void {
    const link = element<HTMLAnchorElement>('download');
    link.hidden = this.#viewer.url === null;
    if (this.#viewer.url) link.href = this.#viewer.url;
  }

  /** Colorings belong to one level, so two levels are compared by their surface. */
  onComparisonChanged(isOn: boolean): void {
    if (isOn) this.#colorings().find((radio) => radio.value === 'surface')?.click();
    for (const radio of this.#colorings()) radio.disabled = isOn && radio.value !== 'surface';
  }

  #onLookChanged(): void {
    const { look } = this.#viewer;
    look.coloring = (this.#colorings().find((radio) => radio.checked)?.value ?? 'surface') as Coloring;
    look.wireframe = input('wireframe').checked;
    look.flat = input('flat').checked;
    this.#viewer.applyLook();
  }

  #onAutoRotateChanged(): void {
    const { controls } = this.#viewer.stage;
    controls.autoRotate = input('turn').checked;
    // Users who prefer reduced motion but turn this on get a slow rotation.
    controls.autoRotateSpeed = prefersReducedMotion() ? 0.4 : 1.6;
    this.#viewer.stage.invalidate();
  }

  async #fullScreen(): Promise<void> {
    if (document.fullscreenElement) await document.exitFullscreen();
    else await element('app').requestFullscreen();
  }

  #colorings(): HTMLInputElement[] {
    return [...document.querySelectorAll<HTMLInputElement>('input[name="coloring"]')];
  }
}
