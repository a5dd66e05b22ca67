/** The models of a server, with their pictures: `models.json`, as `striata serve` gives it. */

import { element, made } from './page.ts';
import { bytes, count } from './numbers.ts';

/** One model that the server has. */
export interface Listed {
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
  models: Listed[];
  /** Whether the server has more than it lists. */
  is_cut?: boolean;
}

/** The listing; `null` where the page comes from no such server. */
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

/** Fills the gallery; `open` gets what is chosen, while links keep their address for new tabs. */
export function fillGallery(listing: Listing, open: (model: Listed) => void): void {
  element('gallery-title').textContent = listing.name ? `Models in ${listing.name}` : 'Models';
  const cards = listing.models.map((model) => {
    const item = made('li');
    item.append(card(model, open));
    return item;
  });
  if (cards.length === 0) cards.push(made('li', '', 'No models here yet. Drop a mesh to look at it.'));
  if (listing.is_cut) cards.push(made('li', '', `The folder holds more than these ${count(listing.models.length)}; serve a part of it to see the rest.`));
  element('cards').replaceChildren(...cards);
}

/** Asks for pictures or stops asking: a browser has few connections to a server, and the model that is opened needs one. */
export function wantPictures(areWanted: boolean): void {
  for (const image of element('cards').querySelectorAll('img')) {
    if (areWanted && image.dataset.later) image.src = image.dataset.later;
    if (areWanted || image.complete) continue;
    image.dataset.later = image.src;
    image.removeAttribute('src');
  }
}

/** The page's address with that model. */
export function addressOf(url: string): string {
  // Slashes may stay as they are in a query, and read better.
  return `?model=${encodeURIComponent(url).replaceAll('%2F', '/')}`;
}

function card(model: Listed, open: (model: Listed) => void): HTMLAnchorElement {
  const link = made('a');
  link.href = addressOf(model.url);
  link.append(picture(model), made('strong', '', model.path || model.name), made('small', '', words(model)));
  link.addEventListener('click', (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.button !== 0) return;
    event.preventDefault();
    open(model);
  });
  return link;
}

function picture(model: Listed): HTMLElement {
  if (!model.picture) return made('span', 'none', model.kind);
  const image = made('img');
  image.src = model.picture;
  image.alt = '';
  image.loading = 'lazy';
  image.decoding = 'async';
  image.addEventListener('error', () => image.replaceWith(made('span', 'none', model.kind)));
  return image;
}

function words(model: Listed): string {
  const parts = [bytes(model.bytes)];
  if (model.triangle_count !== null) parts.unshift(`${count(model.triangle_count)} triangles`);
  if (model.streams) parts.push('streams');
  return parts.join(' · ');
}

function isListing(value: unknown): value is Listing {
  return typeof value === 'object' && value !== null && Array.isArray((value as Listing).models);
}
