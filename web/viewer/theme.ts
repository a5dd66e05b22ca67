/** Dark or light: as the system has it until the reader says otherwise, which is remembered. */

import { element } from './page.ts';

const KEY = 'striata-theme';
const dark = matchMedia('(prefers-color-scheme: dark)');

type Theme = 'dark' | 'light';

/** Where storage is closed (file://, private windows), the choice lasts as long as the page. */
let chosen: Theme | null = stored();

/** Sets the theme, and calls `changed` now and whenever it changes. */
export function followTheme(changed: () => void): void {
  const apply = (): void => {
    document.documentElement.dataset.theme = theme();
    changed();
  };
  dark.addEventListener('change', apply);
  element('theme').addEventListener('click', () => {
    chosen = theme() === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem(KEY, chosen);
    } catch {
      // Kept in `chosen`.
    }
    apply();
  });
  apply();
}

/** A color of style.css as it is now. */
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
