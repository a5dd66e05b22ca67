/** The gallery of a server's models, filled from `models.json` as `striata serve` provides it. */

import { createNode, element } from './dom.ts';
import { formatBytes, formatCount } from './format.ts';

/** One model on the server. */
export interface ListedModel {
  name: string;
  path: string;
  url: string;
  bytes: number;
  kind: string;
  streams: boolean;
  triangle_count: number | null;
  vertex_count: number | null;
  picture: string | null;
}

interface Listing {
  name: string;
  models: ListedModel[];
  /** Whether the server has more models than it lists. */
  is_cut?: boolean;
  /** Whether the server stops when its page is closed. */
  ends_with_page?: boolean;
}

/** Lets the server know that this page is open, until it is closed: `striata view` ends with it. */
export async function holdSession(): Promise<void> {
  try {
    const response = await fetch('session', { cache: 'no-store' });
    const reader = response.body?.getReader();
    while (reader && !(await reader.read()).done);
  } catch {
    // The command was stopped first.
  }
}

/** Fetches the listing; `null` if the page was not served by `striata serve`. */
export async function fetchListing(): Promise<Listing | null> {
  if (location.protocol === 'file:') return null;
  try {
    const response = await fetch('models.json', { headers: { Accept: 'application/json' } });
    if (!response.ok) return null;
    const listing: unknown = await response.json();
    return isListing(listing) ? listing : null;
  } catch {
    return null;
  }
}

/** Fills the gallery. `open` is called with the chosen model; the links keep their addresses, so they can be opened in new tabs. */
export function fillGallery(listing: Listing, open: (model: ListedModel) => void): void {
  element('gallery-title').textContent = listing.name ? `Models in ${listing.name}` : 'Models';
  const cards = listing.models.map((model) => {
    const item = createNode('li');
    item.append(card(model, open));
    return item;
  });
  if (cards.length === 0) cards.push(createNode('li', '', 'No models yet. Drop a mesh here to view it.'));
  if (listing.is_cut) cards.push(createNode('li', '', `Only the first ${formatCount(listing.models.length)} models are listed. Serve a subfolder to see the rest.`));
  element('cards').replaceChildren(...cards);
}

/** Starts or pauses loading thumbnails: a browser opens few connections to a server, and the model being opened needs one. */
export function setThumbnailsEnabled(isEnabled: boolean): void {
  thumbnails.setEnabled(isEnabled);
}

/** Distance from the window at which thumbnails start to load. */
const NEAR = '600px';

/** Header of a thumbnail with the reason why its file is broken. */
const FAULT_HEADER = 'Striata-Fault';

/** Loads the thumbnails of cards that are near the window. */
class Thumbnails {
  readonly #models = new Map<Element, ListedModel>();
  /** Placeholders near the window whose pictures have not arrived. */
  readonly #wanted = new Set<HTMLElement>();
  readonly #observer = new IntersectionObserver((entries) => this.#onSeen(entries), { rootMargin: NEAR });
  #abort: AbortController | null = new AbortController();

  /** Returns a placeholder, which the picture will replace. */
  placeholder(model: ListedModel): HTMLElement {
    const holder = createNode('span', 'none waiting');
    this.#models.set(holder, model);
    this.#observer.observe(holder);
    return holder;
  }

  setEnabled(isEnabled: boolean): void {
    if (isEnabled === (this.#abort !== null)) return;
    this.#abort?.abort();
    this.#abort = isEnabled ? new AbortController() : null;
    for (const holder of this.#wanted) void this.#load(holder);
  }

  #onSeen(entries: IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      this.#observer.unobserve(target);
      this.#wanted.add(target as HTMLElement);
      void this.#load(target as HTMLElement);
    }
  }

  async #load(holder: HTMLElement): Promise<void> {
    const [model, signal] = [this.#models.get(holder), this.#abort?.signal];
    if (!model?.picture || !signal) return;
    let found: Node = createNode('span', 'none', model.kind);
    try {
      const response = await fetch(model.picture, { signal });
      const fault = response.headers.get(FAULT_HEADER);
      if (fault) found = brokenFile(holder, model, decodeURIComponent(fault));
      else if (response.ok) found = await pictureOf(await response.blob());
    } catch {
      // Without a picture, the card shows the kind of the model.
    }
    if (signal.aborted) return;
    this.#wanted.delete(holder);
    holder.replaceWith(found);
  }
}

const thumbnails = new Thumbnails();

async function pictureOf(bytes: Blob): Promise<HTMLImageElement> {
  const image = createNode('img');
  image.alt = '';
  image.src = URL.createObjectURL(bytes);
  await image.decode().finally(() => URL.revokeObjectURL(image.src));
  return image;
}

/** Says on the card of a broken file what is wrong with it, and returns what stands in place of its picture. */
function brokenFile(holder: HTMLElement, model: ListedModel, reason: string): HTMLElement {
  const facts = holder.parentElement?.querySelector('small');
  facts?.replaceChildren(`${formatBytes(model.bytes)} · ${reason}`);
  facts?.classList.add('fault');
  return createNode('span', 'none', 'cannot be read');
}

/** Address of this page with the given model. */
export function addressOf(url: string): string {
  // Slashes are allowed in a query and are easier to read.
  return `?model=${encodeURIComponent(url).replaceAll('%2F', '/')}`;
}

function card(model: ListedModel, open: (model: ListedModel) => void): HTMLAnchorElement {
  const link = createNode('a');
  link.href = addressOf(model.url);
  link.append(thumbnail(model), createNode('strong', '', model.path || model.name), createNode('small', '', describe(model)));
  link.addEventListener('click', (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.button !== 0) return;
    event.preventDefault();
    open(model);
  });
  return link;
}

function thumbnail(model: ListedModel): HTMLElement {
  return model.picture ? thumbnails.placeholder(model) : createNode('span', 'none', model.kind);
}

function describe(model: ListedModel): string {
  const parts = [formatBytes(model.bytes)];
  if (model.triangle_count !== null) parts.unshift(`${formatCount(model.triangle_count)} triangles`);
  if (model.streams) parts.push('streams');
  return parts.join(' · ');
}

function isListing(value: unknown): value is Listing {
  return typeof value === 'object' && value !== null && Array.isArray((value as Listing).models);
}
