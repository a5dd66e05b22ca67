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
  for (const image of element('cards').querySelectorAll('img')) {
    if (isEnabled && image.dataset.pendingSrc) image.src = image.dataset.pendingSrc;
    if (isEnabled || image.complete) continue;
    image.dataset.pendingSrc = image.src;
    image.removeAttribute('src');
  }
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
  if (!model.picture) return createNode('span', 'none', model.kind);
  const image = createNode('img');
  image.src = model.picture;
  image.alt = '';
  image.loading = 'lazy';
  image.decoding = 'async';
  image.addEventListener('error', () => image.replaceWith(createNode('span', 'none', model.kind)));
  return image;
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
