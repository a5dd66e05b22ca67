/** Formats numbers for people: counts, sizes, errors and percentages. */

const counts = new Intl.NumberFormat('en');

export const formatCount = (value: number): string => counts.format(value);

/** Three significant digits, with an exponent only for very large or small numbers. */
export function formatNumber(value: number): string {
  if (value === 0) return '0';
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-5) return value.toExponential(2);
  return String(Number(value.toPrecision(3)));
}

const UNITS = ['bytes', 'kB', 'MB', 'GB'];

/** Size in units of 1000 bytes, as file managers show it. */
export function formatBytes(value: number): string {
  let unit = 0;
  while (value >= 999.5 && unit < UNITS.length - 1) {
    value /= 1000;
    unit += 1;
  }
  const text = unit === 0 || value >= 99.95 ? value.toFixed(0) : value.toFixed(value >= 9.995 ? 1 : 2);
  return `${text} ${UNITS[unit]}`;
}

/** `received of total`, or just `received` if the total is unknown or reached. */
export function formatReceived(received: number, total: number | null): string {
  return total !== null && total !== received ? `${formatBytes(received)} of ${formatBytes(total)}` : formatBytes(received);
}

/** A fraction of one as a percentage. */
export const formatPercent = (value: number): string => `${formatNumber(100 * value)}%`;
