/** What went wrong, in words, over the stage: what, why, what to do; each can be dismissed. */

import { element, made } from './page.ts';

export interface Notice {
  title: string;
  reason: string;
  hint?: string | undefined;
  retry?: (() => void) | undefined;
}

/** More at a time would hide the model. */
const MOST = 2;

/** Shows a notice, above those that are there. */
export function notify(notice: Notice): void {
  const box = made('div', 'notice');
  box.setAttribute('role', 'alert');
  const dismiss = made('button', 'dismiss', '×');
  dismiss.setAttribute('aria-label', 'Dismiss');
  dismiss.addEventListener('click', () => box.remove());
  box.append(made('strong', '', notice.title), dismiss, made('p', 'reason', notice.reason));
  if (notice.hint) box.append(made('p', 'hint', notice.hint));
  const { retry } = notice;
  if (retry) {
    const button = made('button', 'retry strong', 'Try again');
    button.addEventListener('click', () => {
      box.remove();
      retry();
    });
    box.append(button);
  }
  const list = element('notices');
  list.prepend(box);
  while (list.children.length > MOST) list.lastElementChild?.remove();
}

/** Takes the newest away; false where there is none. */
export function dismissNewest(): boolean {
  const newest = element('notices').firstElementChild;
  newest?.remove();
  return newest !== null;
}

export function dismissAll(): void {
  element('notices').replaceChildren();
}
