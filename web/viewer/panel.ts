/** The rest of the panel: colors, shading, background, turning, full screen, pictures. */

import type { Coloring } from '../src/index.ts';
import { element, input, prefersStillness, say } from './page.ts';
import { themeColor } from './theme.ts';
import type { Viewer } from './viewer.ts';

const BACKGROUNDS: Record<string, string> = { white: '#ffffff', gray: '#808080', black: '#000000' };

/** Screens from this width on show the panel at the side. */
const wide = matchMedia('(min-width: 701px)');

export class Panel {
  readonly #viewer: Viewer;

  constructor(viewer: Viewer) {
    this.#viewer = viewer;
    element('controls').addEventListener('submit', (event) => event.preventDefault());
    for (const radio of this.#colorings()) radio.addEventListener('change', () => this.#lookChanged());
    for (const id of ['wireframe', 'flat']) input(id).addEventListener('change', () => this.#lookChanged());
    input('z-up').addEventListener('change', () => viewer.setZUp(input('z-up').checked));
    input('turn').addEventListener('change', () => this.#turnChanged());
    element('background').addEventListener('change', () => this.paintBackground());
    element('reset').addEventListener('click', () => this.reset());
    element('full').addEventListener('click', () => void this.#fullScreen());
    element('picture').addEventListener('click', () => void this.savePicture());
    for (const id of ['fold', 'handle']) element(id).addEventListener('click', () => this.fold());
    this.fold(!wide.matches);
    wide.addEventListener('change', () => this.fold(!wide.matches));
    document.addEventListener('fullscreenchange', () => {
      element('full').textContent = document.fullscreenElement ? 'Leave full screen' : 'Full screen';
    });
    element('full').hidden = !document.fullscreenEnabled;
  }

  /** Presses a switch, as its key does. */
  toggle(id: string, name: string): void {
    const box = input(id);
    box.click();
    say(`${name} ${box.checked ? 'on' : 'off'}`);
  }

  color(coloring: Coloring): void {
    const radio = this.#colorings().find((radio) => radio.value === coloring);
    radio?.click();
    say(`Colors: ${coloring}`);
  }

  /** Colors by strips, or the surface again. */
  toggleStrips(): void {
    this.color(this.#viewer.look.coloring === 'strips' ? 'surface' : 'strips');
  }

  /** The next way of coloring. */
  nextColoring(): void {
    const radios = this.#colorings();
    const next = radios[(radios.findIndex((radio) => radio.checked) + 1) % radios.length];
    if (next) this.color(next.value as Coloring);
  }

  paintBackground(): void {
    const chosen = element<HTMLSelectElement>('background').value;
    this.#viewer.stage.setBackground(BACKGROUNDS[chosen] ?? themeColor('--stage'));
  }

  reset(): void {
    this.#viewer.detail.freeze(false);
    this.#viewer.framing.reset();
  }

  /** Folds or unfolds the controls. */
  fold(isFolded = !element('app').classList.contains('folded')): void {
    element('app').classList.toggle('folded', isFolded);
    for (const id of ['fold', 'handle']) element(id).setAttribute('aria-expanded', String(!isFolded));
  }

  /** The picture on the stage, as a file. */
  async savePicture(): Promise<void> {
    const blob = await this.#viewer.stage.picture();
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = `${this.#viewer.name.replace(/\.\w+$/, '')}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }

  /** What is there for the model that is shown. */
  modelShown(): void {
    const download = element<HTMLAnchorElement>('download');
    download.hidden = this.#viewer.url === null;
    if (this.#viewer.url) download.href = this.#viewer.url;
  }

  #lookChanged(): void {
    const { look } = this.#viewer;
    look.coloring = (this.#colorings().find((radio) => radio.checked)?.value ?? 'surface') as Coloring;
    look.wireframe = input('wireframe').checked;
    look.flat = input('flat').checked;
    this.#viewer.applyLook();
  }

  #turnChanged(): void {
    const { controls } = this.#viewer.stage;
    controls.autoRotate = input('turn').checked;
    // Who wants less motion and yet asks for this gets it slowly.
    controls.autoRotateSpeed = prefersStillness() ? 0.4 : 1.6;
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
