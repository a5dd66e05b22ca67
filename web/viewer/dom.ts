/** Helpers for the DOM: elements of index.html by id, new elements, and announcements for screen readers. */

/** Returns the element with this id, which index.html must contain. */
export function element<T extends Element = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`index.html has no #${id}`);
  return found as unknown as T;
}

export const input = (id: string): HTMLInputElement => element<HTMLInputElement>(id);

/** Announces text to screen readers without showing it. */
export function announce(text: string): void {
  element('announcer').textContent = text;
}

/** Creates an element with an optional class and text. */
export function createNode<K extends keyof HTMLElementTagNameMap>(tag: K, className = '', text = ''): HTMLElementTagNameMap[K] {
  const node = document.createElement(tag);
  if (className) node.className = className;
  node.textContent = text;
  return node;
}

/** Whether the user has asked the system for reduced motion. */
export function prefersReducedMotion(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}

/** Shows or hides the element with this id. */
export function setVisible(id: string, isVisible: boolean): void {
  element(id).hidden = !isVisible;
}
