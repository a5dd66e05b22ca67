/**
 * Keeps the view in the page's address, and copies it as a link.
 *
 * The address follows once nothing has changed for a moment. What moves by itself, a playing animation or a turning model, is
 * not followed; a copied link has it as it is then.
 */

import { announce, element } from './dom.ts';
import { addressOf } from './gallery.ts';
import { notify } from './notices.ts';
import type { Panel } from './panel.ts';
import type { Viewer } from './viewer.ts';
import { type ViewState, writeView } from './view-state.ts';

/** How often the view is compared with the address; a view is settled if it has not changed since the last time. */
const INTERVAL_MS = 400;

const COPY_TITLE = 'Copy a link to this view (K)';

export class Sharing {
  readonly #viewer: Viewer;
  readonly #panel: Panel;
  #last: string | null = null;
  /** Camera when the model began to turn, or when the view was frozen. */
  #camera: ViewState['camera'] = null;

  constructor(viewer: Viewer, panel: Panel) {
    this.#viewer = viewer;
    this.#panel = panel;
    element('copy-link').addEventListener('click', () => void this.copy());
    setInterval(() => this.#follow(), INTERVAL_MS);
    this.refresh();
  }

  /** Updates the button for the model that is shown. */
  refresh(): void {
    const obstacle = this.#obstacle();
    const button = element<HTMLButtonElement>('copy-link');
    button.disabled = obstacle !== null;
    button.title = obstacle ?? COPY_TITLE;
    this.#last = null;
    this.#camera = this.#poseOfUser();
  }

  /** Copies a link to what is shown now. */
  async copy(): Promise<void> {
    const obstacle = this.#obstacle();
    if (obstacle) return announce(obstacle);
    const link = new URL(this.#address(this.#view()), location.href).href;
    if (await copyText(link)) announce('Link copied');
    else notify({ title: 'The browser does not allow copying', reason: `Copy this link yourself: ${link}` });
    const button = element('copy-link');
    button.textContent = 'Link copied';
    setTimeout(() => (button.textContent = 'Copy link'), 1500);
  }

  /** Why no link leads to what is shown; null if one does. */
  #obstacle(): string | null {
    if (location.protocol === 'file:') return 'This page is a file on your computer, which a link cannot lead to';
    if (!this.#viewer.model) return 'No model is shown';
    if (this.#viewer.url !== null || this.#viewer.isEmbedded) return null;
    return 'This model is a file on your computer, which a link cannot lead to';
  }

  #follow(): void {
    const viewer = this.#viewer;
    if (location.protocol === 'file:' || !viewer.model || viewer.isOpening || viewer.recording.isOn) return;
    const address = this.#obstacle() ? location.pathname : this.#address(this.#settledView());
    const isSettled = address === this.#last;
    this.#last = address;
    if (!isSettled || new URL(address, location.href).href === location.href) return;
    history.replaceState(history.state, '', address);
  }

  #view(): ViewState {
    const { detail, inspection, playback, isFrozen } = this.#viewer;
    return {
      camera: isFrozen ? this.#camera : this.#poseOfUser(),
      level: detail.choice, playback: playback.state, model: inspection.model, look: this.#panel.lookState(),
    };
  }

  /** The camera, if it does not just frame the model. */
  #poseOfUser(): ViewState['camera'] {
    const { framing } = this.#viewer;
    return framing.isUserControlled ? framing.pose() : null;
  }

  #settledView(): ViewState {
    const view = this.#view();
    if (view.look.turns) view.camera = this.#camera;
    else this.#camera = view.camera;
    if (view.playback?.plays) view.playback = null;
    return view;
  }

  #address(view: ViewState): string {
    const { url } = this.#viewer;
    const parts = [...(url === null ? [] : [addressOf(url).slice(1)]), ...writeView(view)];
    return parts.length > 0 ? `${location.pathname}?${parts.join('&')}` : location.pathname;
  }
}

/** Copies a text, and returns whether the browser allows that. */
async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // Pages from other machines without HTTPS have no clipboard; the old way still works.
  }
  const field = document.createElement('textarea');
  field.value = text;
  field.className = 'unseen';
  document.body.append(field);
  field.select();
  const isCopied = document.execCommand('copy');
  field.remove();
  return isCopied;
}
