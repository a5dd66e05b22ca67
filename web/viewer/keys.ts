/** The keyboard: one table of keys, which the help overlay lists. */

import { element, made } from './page.ts';

/** What a key does. */
export interface Command {
  /** As `KeyboardEvent.key` has it; several may do the same. */
  keys: string[];
  /** As the help shows them. */
  shown: string;
  does: string;
  run: (event: KeyboardEvent) => void;
  /** Also works while a slider or radio has the focus, which use these keys themselves otherwise. */
  onlyOnStage?: boolean;
}

/** Listens for the commands and lists them in the help. */
export function listen(commands: Command[]): void {
  const list = element('keys');
  for (const command of commands) {
    const row = made('div');
    const keys = made('dd');
    for (const key of command.shown.split(' ')) keys.append(made('kbd', '', key), ' ');
    row.append(made('dt', '', command.does), keys);
    list.append(row);
  }
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || isTyping(event.target)) return;
    if (document.querySelector('dialog[open]')) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const command = commands.find((command) => command.keys.includes(key));
    if (!command || (command.onlyOnStage && !isOnStage(event.target))) return;
    event.preventDefault();
    command.run(event);
  });
}

function isTyping(target: EventTarget | null): boolean {
  if (target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement) return true;
  return target instanceof HTMLInputElement && !['range', 'radio', 'checkbox', 'button'].includes(target.type);
}

function isOnStage(target: EventTarget | null): boolean {
  return target === document.body || target instanceof HTMLCanvasElement;
}
