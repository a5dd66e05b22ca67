/**
 * Entry point of the viewer page: what it opens first, and its keyboard shortcuts.
 *
 * The page opens the model embedded in it, if any; else the model in its address (`?model=URL`); else the server's gallery;
 * else it asks for a file.
 */

import { acceptFiles } from './file-input.ts';
import { addressOf, fetchListing, fillGallery, holdSession, type ListedModel, setThumbnailsEnabled } from './gallery.ts';
import type { ModelName } from './inspect-worker.ts';
import { installShortcuts } from './keys.ts';
import { dismissNewest, notify } from './notices.ts';
import { announce, element } from './dom.ts';
import { Panel } from './panel.ts';
import { Sharing } from './sharing.ts';
import { embeddedModel, fromFile, fromUrl, type ModelSource } from './sources.ts';
import { Stage } from './stage.ts';
import { followTheme } from './theme.ts';
import { readView } from './view-state.ts';
import { Viewer } from './viewer.ts';

/** Step of one key press: orbit in radians, pan and zoom as fractions of the distance, light in degrees. */
const STEP = { orbit: Math.PI / 30, pan: 0.06, zoom: 1.12, light: 15 };

/** Directions of the arrow keys: right and up. */
const ARROWS: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const MODE_NAMES = { level: 'level', pixels: 'screen error', budget: 'budget' };

declare global {
  interface Window {
    /** The viewer, for the console and for tests. */
    striataViewer?: Viewer;
  }
}

class Page {
  readonly #viewer: Viewer;
  readonly #panel: Panel;
  readonly #sharing: Sharing;
  #hasGallery = false;

  constructor(stage: Stage) {
    this.#viewer = new Viewer(stage);
    this.#panel = new Panel(this.#viewer);
    this.#sharing = new Sharing(this.#viewer, this.#panel);
    window.striataViewer = this.#viewer;
    this.#viewer.onView = ({ look }) => this.#panel.restoreLook(look);
    this.#viewer.onUp = (isZUp) => this.#panel.setZUp(isZUp);
    this.#viewer.onShown = () => {
      this.#panel.onModelShown();
      this.#sharing.refresh();
      this.#setTitle(this.#viewer.name);
    };
    this.#viewer.onComparisonChanged = (isOn) => this.#panel.onComparisonChanged(isOn);
    this.#viewer.onEmpty = () => this.#showStart();
    followTheme(() => this.#panel.paintBackground());
    acceptFiles((file) => this.#openFile(file));
    element('to-gallery').addEventListener('click', () => this.#goToGallery());
    element('show-help').addEventListener('click', () => this.#showHelp());
    addEventListener('popstate', () => this.#openAddress());
    this.#installShortcuts();
  }

  /** Opens the first model, or shows the gallery or the welcome screen. */
  async start(): Promise<void> {
    const embedded = embeddedModel();
    const view = readView(location.search);
    if (embedded) return this.#open({ ...embedded, view });
    const requested = requestedModel();
    if (requested) this.#open(fromUrl(requested, view));
    const listing = await fetchListing();
    if (listing?.ends_with_page) void holdSession();
    if (listing) {
      fillGallery(listing, (model) => this.#openListed(model));
      const only = listing.models.length === 1 ? listing.models[0] : undefined;
      this.#hasGallery = !only;
      element('to-gallery').hidden = !this.#hasGallery;
      if (!requested && only) return this.#open(fromUrl(only.url, view));
    }
    // Also if the requested model has already failed to load.
    if (!this.#viewer.isBusy) this.#showStart();
  }

  #open(source: ModelSource): void {
    if (!this.#viewer.model) this.#setTitle(source.name);
    element('welcome').hidden = true;
    this.#showGallery(false);
    void this.#viewer.open(source);
  }

  /** Opens a local file and removes the model from the page's address, since a file has none. */
  #openFile(file: File): void {
    if (requestedModel() && location.protocol !== 'file:') history.pushState(null, '', location.pathname);
    this.#open(fromFile(file));
  }

  #setTitle(name: string): void {
    element('title').textContent = name;
    document.title = `${name} – striata`;
  }

  #openListed(model: ListedModel): void {
    history.pushState(null, '', addressOf(model.url));
    this.#open(fromUrl(model.url));
  }

  #openAddress(): void {
    const requested = requestedModel();
    // A link to a part of the page leads to no other model.
    if (location.hash && requested === this.#viewer.url) return;
    if (requested) this.#open(fromUrl(requested, readView(location.search)));
    else this.#showStart();
  }

  #goToGallery(): void {
    history.pushState(null, '', location.pathname);
    this.#showStart();
    element('gallery').focus();
  }

  /** Shows the gallery, or the welcome screen if there is no gallery. */
  #showStart(): void {
    this.#viewer.close();
    this.#sharing.refresh();
    element('title').textContent = 'striata';
    element('subtitle').textContent = 'continuous level of detail';
    document.title = 'striata viewer';
    element('welcome').hidden = this.#hasGallery;
    this.#showGallery(this.#hasGallery);
    this.#showControls(false);
  }

  #showGallery(isShown: boolean): void {
    element('gallery').hidden = !isShown;
    setThumbnailsEnabled(isShown);
    this.#showControls(!isShown);
  }

  #showControls(isShown: boolean): void {
    for (const id of ['panel', 'fold']) element(id).hidden = !isShown;
  }

  #showHelp(): void {
    element<HTMLDialogElement>('help').showModal();
  }

  #installShortcuts(): void {
    const { framing, detail, playback, recording } = this.#viewer;
    const panel = this.#panel;
    installShortcuts([
      { keys: Object.keys(ARROWS), shown: '← → ↑ ↓', description: 'Rotate (with Shift: pan)', run: (event) => this.#move(event), onlyOnStage: true },
      { keys: ['+', '='], shown: '+', description: 'Zoom in', run: () => framing.zoom(1 / STEP.zoom) },
      { keys: ['-', '_'], shown: '-', description: 'Zoom out', run: () => framing.zoom(STEP.zoom) },
      { keys: [']'], shown: ']', description: 'More detail', run: () => detail.step(1) },
      { keys: ['['], shown: '[', description: 'Less detail', run: () => detail.step(-1) },
      { keys: ['v'], shown: 'V', description: 'Detail by screen error', run: () => this.#toggleView() },
      { keys: ['f'], shown: 'F', description: 'Freeze view', run: () => this.#toggleFreeze() },
      { keys: ['b'], shown: 'B', description: 'Compare two levels', run: () => this.#toggleComparison() },
      { keys: [' '], shown: 'Space', description: 'Play or pause', run: () => playback.toggle(), onlyOnStage: true },
      { keys: ['w'], shown: 'W', description: 'Wireframe', run: () => panel.toggle('wireframe', 'Wireframe') },
      { keys: ['s'], shown: 'S', description: 'Color by strip', run: () => panel.toggleStrips() },
      { keys: ['c'], shown: 'C', description: 'Next coloring', run: () => panel.nextColoring() },
      { keys: ['l'], shown: 'L', description: 'Flat shading', run: () => panel.toggle('flat', 'Flat shading') },
      { keys: ['z'], shown: 'Z', description: 'Z up', run: () => panel.toggle('z-up', 'Z up') },
      { keys: ['t'], shown: 'T', description: 'Auto-rotate', run: () => panel.toggle('turn', 'Auto-rotate') },
      { keys: ['r'], shown: 'R', description: 'Reset view', run: () => panel.reset() },
      { keys: ['p'], shown: 'P', description: 'Save picture', run: () => void panel.savePicture() },
      { keys: ['m'], shown: 'M', description: 'Save video, or cancel it', run: () => recording.toggle() },
      { keys: ['k'], shown: 'K', description: 'Copy link', run: () => void this.#sharing.copy() },
      { keys: ['i'], shown: 'I', description: 'Pick triangles (also: Shift and a click)', run: () => panel.toggle('pick', 'Picking') },
      { keys: [','], shown: ',', description: 'Turn the light left', run: () => panel.turnLight(-STEP.light) },
      { keys: ['.'], shown: '.', description: 'Turn the light right (also: Alt and drag)', run: () => panel.turnLight(STEP.light) },
      { keys: ['g'], shown: 'G', description: 'Plots', run: () => element('plots-title').click() },
      { keys: ['d'], shown: 'D', description: 'Next multiresolution model', run: () => void this.#nextModel() },
      { keys: ['j'], shown: 'J', description: 'Geomorphs of the model', run: () => panel.toggle('morphs', 'Geomorphs') },
      { keys: ['o'], shown: 'O', description: 'Open file', run: () => element('open').click() },
      { keys: ['h'], shown: 'H', description: 'Show or hide controls', run: () => panel.fold() },
      { keys: ['?'], shown: '?', description: 'Show this help', run: () => this.#showHelp() },
      { keys: ['Escape'], shown: 'Esc', description: 'Dismiss message', run: () => void dismissNewest() },
    ]);
  }

  #move(event: KeyboardEvent): void {
    const [right, up] = ARROWS[event.key] ?? [0, 0];
    const { framing } = this.#viewer;
    if (event.shiftKey) framing.pan(-right * STEP.pan, -up * STEP.pan);
    else framing.orbit(right * STEP.orbit, up * STEP.orbit);
  }

  async #nextModel(): Promise<void> {
    const { inspection } = this.#viewer;
    const select = element<HTMLSelectElement>('inspected');
    if (select.disabled) return announce('Pages have no multiresolution models');
    const options = [...select.options].filter((option) => !option.disabled);
    const next = options[(options.findIndex((option) => option.selected) + 1) % options.length];
    await inspection.choose((next?.value ?? '') as ModelName | '');
    announce(`Drawn as ${next?.textContent ?? ''}`);
  }

  #toggleView(): void {
    const { detail } = this.#viewer;
    const isAvailable = detail.choose(detail.mode === 'pixels' ? 'level' : 'pixels');
    announce(isAvailable ? `Detail by ${MODE_NAMES[detail.mode]}` : 'Screen error is available once the model has loaded');
  }

  #toggleComparison(): void {
    const { comparison } = this.#viewer;
    const isAvailable = comparison.toggle();
    announce(isAvailable ? `Comparing ${comparison.isOn ? 'two levels' : 'ended'}` : 'Levels can be compared once the model has loaded');
  }

  #toggleFreeze(): void {
    const { detail } = this.#viewer;
    const isAvailable = detail.freeze(!detail.isFrozen);
    announce(isAvailable ? `View ${detail.isFrozen ? 'frozen' : 'unfrozen'}` : 'The view can be frozen once the model has loaded');
  }
}

/** URL of the model in the page's address, if any. */
function requestedModel(): string | null {
  return new URLSearchParams(location.search).get('model');
}

/** Creates the stage, or shows a notice and returns `null` if the browser does not support WebGL 2. */
function createStage(): Stage | null {
  try {
    return new Stage(element<HTMLCanvasElement>('view'));
  } catch {
    notify({
      title: 'This browser cannot show 3D graphics',
      reason: 'The viewer needs WebGL 2, which is not available.',
      hint: 'Turn on hardware acceleration in the browser settings, or try another browser.',
    });
    followTheme(() => {});
    for (const id of ['panel', 'fold', 'open', 'show-help']) element(id).hidden = true;
    return null;
  }
}

const stage = createStage();
if (stage) void new Page(stage).start();
