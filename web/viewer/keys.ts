/** Keyboard shortcuts: one table, which the help dialog lists. */

import { createNode, element } from './dom.ts';

/** A keyboard shortcut. */
export interface Shortcut {
  /** Values of `KeyboardEvent.key`; any of them triggers the shortcut. */
  keys: string[];
  /** Keys as shown in the help. */
  shown: string;
  description: string;
  run: (event: KeyboardEvent) => void;
  /** Only works while the stage has the focus, because sliders and radio buttons use these keys themselves. */
  onlyOnStage?: boolean;
}

/** Installs the shortcuts and lists them in the help. */
export function installShortcuts(shortcuts: Shortcut[]): void {
  const list = element('keys');
  for (const shortcut of shortcuts) {
    const row = createNode('div');
    const keys = createNode('dd');
    for (const key of shortcut.shown.split(' ')) keys.append(createNode('kbd', '', key), ' ');
    row.append(createNode('dt', '', shortcut.description), keys);
    list.append(row);
  }
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || isTyping(event.target)) return;
    if (document.querySelector('dialog[open]')) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const shortcut = shortcuts.find((shortcut) => shortcut.keys.includes(key));
    if (!shortcut || (shortcut.onlyOnStage && !isOnStage(event.target))) return;
    event.preventDefault();
    shortcut.run(event);
  });
}

function isTyping(target: EventTarget | null): boolean {
  if (target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement) return true;
  return target instanceof HTMLInputElement && !['range', 'radio', 'checkbox', 'button'].includes(target.type);
}

function isOnStage(target: EventTarget | null): boolean {
  return target === document.body || target instanceof HTMLCanvasElement;
}
