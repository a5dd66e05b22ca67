/** Dark or light theme: the system's until the user chooses one, which is remembered. */

import { element } from './dom.ts';

const KEY = 'striata-theme';
const dark = matchMedia('(prefers-color-scheme: dark)');

type Theme = 'dark' | 'light';

/** The user's choice. If storage is unavailable (file://, private windows), it lasts as long as the page. */
let chosen: Theme | null = stored();

/** Applies the theme, and calls `onChange` now and whenever it changes. */
export function followTheme(onChange: () => void): void {
  const apply = (): void => {
    document.documentElement.dataset.theme = theme();
    onChange();
  };
  dark.addEventListener('change', apply);
  element('theme').addEventListener('click', () => {
    chosen = theme() === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem(KEY, chosen);
    } catch {
      // The choice is still kept in `chosen`.
    }
    apply();
  });
  apply();
}

/** Current value of a custom property of style.css. */
export function themeColor(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function theme(): Theme {
  return chosen ?? (dark.matches ? 'dark' : 'light');
}

function stored(): Theme | null {
  try {
    const value = localStorage.getItem(KEY);
    return value === 'dark' || value === 'light' ? value : null;
  } catch {
    return null;
  }
}
