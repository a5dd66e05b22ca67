/** Error notices over the stage: what failed, why, and what to do. Each can be dismissed. */

import { createNode, element } from './dom.ts';

export interface Notice {
  title: string;
  reason: string;
  hint?: string | undefined;
  retry?: (() => void) | undefined;
}

/** More notices than this would hide the model. */
const MAX_NOTICES = 2;

/** Shows a notice above earlier ones. */
export function notify(notice: Notice): void {
  const box = createNode('div', 'notice');
  box.setAttribute('role', 'alert');
  const dismiss = createNode('button', 'dismiss', '×');
  dismiss.setAttribute('aria-label', 'Dismiss');
  dismiss.addEventListener('click', () => box.remove());
  box.append(createNode('strong', '', notice.title), dismiss, createNode('p', 'reason', notice.reason));
  if (notice.hint) box.append(createNode('p', 'hint', notice.hint));
  const { retry } = notice;
  if (retry) {
    const button = createNode('button', 'retry strong', 'Try again');
    button.addEventListener('click', () => {
      box.remove();
      retry();
    });
    box.append(button);
  }
  const list = element('notices');
  list.prepend(box);
  while (list.children.length > MAX_NOTICES) list.lastElementChild?.remove();
}

/** Dismisses the newest notice and returns whether there was one. */
export function dismissNewest(): boolean {
  const newest = element('notices').firstElementChild;
  newest?.remove();
  return newest !== null;
}

export function dismissAll(): void {
  element('notices').replaceChildren();
}
