/** Numbers as people read them: counts, bytes, errors and percentages. */

const counts = new Intl.NumberFormat('en');

export const count = (value: number): string => counts.format(value);

/** Three digits that count, without an exponent where it can be helped. */
export function digits(value: number): string {
  if (value === 0) return '0';
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-5) return value.toExponential(2);
  return String(Number(value.toPrecision(3)));
}

const UNITS = ['bytes', 'kB', 'MB', 'GB'];

/** In units of 1000, as file managers show them. */
export function bytes(value: number): string {
  let unit = 0;
  while (value >= 999.5 && unit < UNITS.length - 1) {
    value /= 1000;
    unit += 1;
  }
  const text = unit === 0 || value >= 99.95 ? value.toFixed(0) : value.toFixed(value >= 9.995 ? 1 : 2);
  return `${text} ${UNITS[unit]}`;
}

/** `received of total`, where the total is known. */
export function share(received: number, total: number | null): string {
  return total !== null && total !== received ? `${bytes(received)} of ${bytes(total)}` : bytes(received);
}

/** A share of one as a percentage. */
export const percent = (value: number): string => `${digits(100 * value)} %`;
