/**
 * The viewer page: what it opens first, and what its keys do.
 *
 * First comes the model that the page carries, else the one its address asks for (`?model=URL`), else the gallery of the
 * server, else a place to drop a file.
 */

import { takeFiles } from './dropping.ts';
import { addressOf, fetchListing, fillGallery, type Listed, wantPictures } from './gallery.ts';
import { listen } from './keys.ts';
import { dismissNewest, notify } from './notices.ts';
import { element, say } from './page.ts';
import { Panel } from './panel.ts';
import { fromFile, fromPage, fromUrl, type Opened } from './sources.ts';
import { Stage } from './stage.ts';
import { followTheme } from './theme.ts';
import { Viewer } from './viewer.ts';

/** Turning by a key, radians; moving and zooming by shares. */
const STEP = { turn: Math.PI / 30, pan: 0.06, zoom: 1.12 };

/** Which way arrows go: right and up. */
const ARROWS: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

declare global {
  interface Window {
    /** The viewer, for the console and for tests. */
    striataViewer?: Viewer;
  }
}

class Page {
  readonly #viewer: Viewer;
  readonly #panel: Panel;
  #hasGallery = false;

  constructor(stage: Stage) {
    this.#viewer = new Viewer(stage);
    this.#panel = new Panel(this.#viewer);
    window.striataViewer = this.#viewer;
    this.#viewer.onShown = () => {
      this.#panel.modelShown();
      this.#name(this.#viewer.name);
    };
    this.#viewer.onNothing = () => this.#showStart();
    followTheme(() => this.#panel.paintBackground());
    takeFiles((file) => this.#openFile(file));
    element('to-gallery').addEventListener('click', () => this.#toGallery());
    element('ask').addEventListener('click', () => this.#help());
    addEventListener('popstate', () => this.#openAddress());
    this.#listen();
  }

  /** Opens what there is to open first. */
  async start(): Promise<void> {
    const carried = fromPage();
    if (carried) return this.#open(carried);
    const asked = askedModel();
    if (asked) this.#open(fromUrl(asked));
    const listing = await fetchListing();
    if (listing) {
      fillGallery(listing, (model) => this.#openListed(model));
      const only = listing.models.length === 1 ? listing.models[0] : undefined;
      this.#hasGallery = !only;
      element('to-gallery').hidden = !this.#hasGallery;
      if (!asked && only) return this.#open(fromUrl(only.url));
    }
    // Also where what was asked for has failed by now.
    if (!this.#viewer.isBusy) this.#showStart();
  }

  #open(opened: Opened): void {
    if (!this.#viewer.mesh) this.#name(opened.name);
    element('welcome').hidden = true;
    this.#showGallery(false);
    void this.#viewer.open(opened);
  }

  /** A file has no address: the page's is no longer that of a model. */
  #openFile(file: File): void {
    if (askedModel() && location.protocol !== 'file:') history.pushState(null, '', location.pathname);
    this.#open(fromFile(file));
  }

  #name(name: string): void {
    element('title').textContent = name;
    document.title = `${name} – striata`;
  }

  #openListed(model: Listed): void {
    history.pushState(null, '', addressOf(model.url));
    this.#open(fromUrl(model.url));
  }

  #openAddress(): void {
    const asked = askedModel();
    if (asked) this.#open(fromUrl(asked));
    else this.#showStart();
  }

  #toGallery(): void {
    history.pushState(null, '', location.pathname);
    this.#showStart();
    element('gallery').focus();
  }

  /** The gallery, or a place to drop files where there is none. */
  #showStart(): void {
    this.#viewer.close();
    element('title').textContent = 'striata';
    element('subtitle').textContent = 'continuous level of detail';
    document.title = 'striata viewer';
    element('welcome').hidden = this.#hasGallery;
    this.#showGallery(this.#hasGallery);
    this.#showControls(false);
  }

  #showGallery(isShown: boolean): void {
    element('gallery').hidden = !isShown;
    wantPictures(isShown);
    this.#showControls(!isShown);
  }

  #showControls(isShown: boolean): void {
    for (const id of ['panel', 'fold']) element(id).hidden = !isShown;
  }

  #help(): void {
    element<HTMLDialogElement>('help').showModal();
  }

  #listen(): void {
    const { framing, detail } = this.#viewer;
    const panel = this.#panel;
    listen([
      { keys: Object.keys(ARROWS), shown: '← → ↑ ↓', does: 'Turn (with Shift: move)', run: (event) => this.#move(event), onlyOnStage: true },
      { keys: ['+', '='], shown: '+', does: 'Nearer', run: () => framing.zoom(1 / STEP.zoom) },
      { keys: ['-', '_'], shown: '-', does: 'Farther', run: () => framing.zoom(STEP.zoom) },
      { keys: [']'], shown: ']', does: 'More detail', run: () => detail.step(1) },
      { keys: ['['], shown: '[', does: 'Less detail', run: () => detail.step(-1) },
      { keys: ['v'], shown: 'V', does: 'Detail by pixels of this view', run: () => this.#toggleView() },
      { keys: ['f'], shown: 'F', does: 'Freeze the view', run: () => this.#toggleFreeze() },
      { keys: ['w'], shown: 'W', does: 'Wireframe', run: () => panel.toggle('wireframe', 'Wireframe') },
      { keys: ['s'], shown: 'S', does: 'Colors of strips', run: () => panel.toggleStrips() },
      { keys: ['c'], shown: 'C', does: 'Next colors', run: () => panel.nextColoring() },
      { keys: ['l'], shown: 'L', does: 'Flat shading', run: () => panel.toggle('flat', 'Flat shading') },
      { keys: ['z'], shown: 'Z', does: 'Z is up', run: () => panel.toggle('z-up', 'Z is up') },
      { keys: ['t'], shown: 'T', does: 'Turn by itself', run: () => panel.toggle('turn', 'Turning') },
      { keys: ['r'], shown: 'R', does: 'Reset the view', run: () => panel.reset() },
      { keys: ['p'], shown: 'P', does: 'Save a picture', run: () => void panel.savePicture() },
      { keys: ['o'], shown: 'O', does: 'Open a file', run: () => element('open').click() },
      { keys: ['h'], shown: 'H', does: 'Show or hide the controls', run: () => panel.fold() },
      { keys: ['?'], shown: '?', does: 'These keys', run: () => this.#help() },
      { keys: ['Escape'], shown: 'Esc', does: 'Dismiss a message', run: () => void dismissNewest() },
    ]);
  }

  #move(event: KeyboardEvent): void {
    const [right, up] = ARROWS[event.key] ?? [0, 0];
    const { framing } = this.#viewer;
    if (event.shiftKey) framing.pan(-right * STEP.pan, -up * STEP.pan);
    else framing.turn(right * STEP.turn, up * STEP.turn);
  }

  #toggleView(): void {
    const { detail } = this.#viewer;
    const isOn = detail.choose(detail.mode === 'pixels' ? 'level' : 'pixels');
    say(isOn ? `Detail by ${detail.mode}` : 'Pixels can be chosen when all of the model is there');
  }

  #toggleFreeze(): void {
    const { detail } = this.#viewer;
    const isDone = detail.freeze(!detail.isFrozen);
    say(isDone ? `View ${detail.isFrozen ? 'frozen' : 'free'}` : 'A view can be frozen when all of the model is there');
  }
}

/** What the page's address asks for. */
function askedModel(): string | null {
  return new URLSearchParams(location.search).get('model');
}

/** The stage; `null`, with a notice, where the browser cannot draw. */
function raiseStage(): Stage | null {
  try {
    return new Stage(element<HTMLCanvasElement>('view'));
  } catch {
    notify({
      title: 'This browser shows no 3D',
      reason: 'The viewer draws with WebGL 2, which this browser does not give.',
      hint: 'Turn on hardware acceleration in its settings, or try another browser.',
    });
    followTheme(() => {});
    for (const id of ['panel', 'fold', 'open', 'ask']) element(id).hidden = true;
    return null;
  }
}

const stage = raiseStage();
if (stage) void new Page(stage).start();
