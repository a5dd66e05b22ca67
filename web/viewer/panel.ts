/** The other controls of the panel: colors, shading, background, auto-rotation, full screen, images. */

import type { Coloring } from '../src/index.ts';
import { announce, element, input, prefersReducedMotion } from './dom.ts';
import { notify } from './notices.ts';
import { download, stemOf } from './saving.ts';
import type { Backs } from './surface.ts';
import { themeColor } from './theme.ts';
import { LIGHT_LIMIT, type LookState } from './view-state.ts';
import type { Viewer } from './viewer.ts';

const BACKGROUNDS: Record<string, string> = { white: '#ffffff', gray: '#808080', black: '#000000' };

/** A saved picture is this much larger than the view. */
const PICTURE_FACTOR = 2;

/** Degrees that a drag across a pixel turns the light by. */
const LIGHT_PER_PX = 0.6;

/** Windows at least this wide show the panel at the side. */
const isWide = matchMedia('(min-width: 701px)');

export class Panel {
  readonly #viewer: Viewer;

  constructor(viewer: Viewer) {
    this.#viewer = viewer;
    element('controls').addEventListener('submit', (event) => event.preventDefault());
    for (const radio of this.#colorings()) radio.addEventListener('change', () => this.#onLookChanged());
    for (const id of ['wireframe', 'flat', 'vertex-colors', 'backs']) element(id).addEventListener('change', () => this.#onLookChanged());
    input('z-up').addEventListener('change', () => viewer.setZUp(input('z-up').checked));
    input('turn').addEventListener('change', () => this.#onAutoRotateChanged());
    element('background').addEventListener('change', () => this.paintBackground());
    for (const id of ['light', 'exposure']) input(id).addEventListener('input', () => this.#onLightChanged());
    this.#dragLight();
    element('reset').addEventListener('click', () => this.reset());
    element('full').addEventListener('click', () => void this.#fullScreen());
    element('picture').addEventListener('click', () => void this.savePicture());
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

  /** Saves what is shown as a picture, larger than it is shown. */
  async savePicture(): Promise<void> {
    const name = `${stemOf(this.#viewer.name)}.png`;
    try {
      download(await this.#viewer.stage.toPng(PICTURE_FACTOR), name);
      announce(`Saved ${name}`);
    } catch (error) {
      notify({ title: `Cannot save ${name}`, reason: error instanceof Error ? error.message : String(error) });
    }
  }

  /** Turns the light by degrees. */
  turnLight(degrees: number): void {
    const turned = input('light').valueAsNumber + degrees;
    input('light').valueAsNumber = ((((turned + LIGHT_LIMIT) % 360) + 360) % 360) - LIGHT_LIMIT;
    this.#onLightChanged();
  }

  /** The settings of the panel that belong to a view. */
  lookState(): LookState {
    const { coloring, wireframe, flat, zUp, vertexColors, backs } = this.#viewer.look;
    return {
      coloring, wireframe, flat, zUp: zUp === this.#viewer.model?.isZUp ? null : zUp, vertexColors, backs, turns: input('turn').checked,
      background: element<HTMLSelectElement>('background').value, light: input('light').valueAsNumber, exposure: input('exposure').valueAsNumber,
    };
  }

  /** Sets everything that belongs to a view. */
  restoreLook(look: LookState): void {
    for (const radio of this.#colorings()) radio.checked = radio.value === look.coloring;
    const boxes = { wireframe: look.wireframe, flat: look.flat, 'vertex-colors': look.vertexColors, turn: look.turns };
    for (const [id, isOn] of Object.entries(boxes)) input(id).checked = isOn;
    element<HTMLSelectElement>('backs').value = look.backs;
    element<HTMLSelectElement>('background').value = look.background;
    input('light').valueAsNumber = look.light;
    input('exposure').valueAsNumber = look.exposure;
    this.#onLookChanged();
    this.#onAutoRotateChanged();
    this.paintBackground();
    this.#onLightChanged();
  }

  /** Tilts the model if z is up. */
  setZUp(zUp: boolean): void {
    input('z-up').checked = zUp;
    this.#viewer.setZUp(zUp);
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
    look.vertexColors = input('vertex-colors').checked;
    look.backs = element<HTMLSelectElement>('backs').value as Backs;
    this.#viewer.applyLook();
  }

  #onLightChanged(): void {
    const { stage } = this.#viewer;
    const [degrees, stops] = [input('light').valueAsNumber, input('exposure').valueAsNumber];
    const texts = { light: `${degrees}°`, exposure: `${stops > 0 ? '+' : ''}${stops}` };
    for (const [id, text] of Object.entries(texts)) {
      element(`${id}-value`).textContent = text;
      input(id).setAttribute('aria-valuetext', id === 'light' ? `${degrees} degrees` : `${text} stops`);
    }
    stage.lighting.turn(degrees);
    stage.setExposure(stops);
  }

  /** Turns the light while the stage is dragged with Alt. */
  #dragLight(): void {
    const canvas = this.#viewer.stage.renderer.domElement;
    const onDown = (event: PointerEvent): void => {
      if (!event.altKey || event.button !== 0 || event.target !== canvas) return;
      // Before the controls of the camera see it.
      event.stopPropagation();
      canvas.setPointerCapture(event.pointerId);
      const stop = new AbortController();
      let rest = 0;
      canvas.addEventListener('pointermove', ({ movementX }) => {
        rest += LIGHT_PER_PX * movementX;
        const whole = Math.trunc(rest);
        rest -= whole;
        this.turnLight(whole);
      }, stop);
      for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) canvas.addEventListener(end, () => stop.abort(), stop);
    };
    element('screen').addEventListener('pointerdown', onDown, { capture: true });
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
