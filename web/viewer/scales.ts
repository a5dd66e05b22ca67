/**
 * What the sliders mean. All run from 0 to 1000; the eye judges ratios, so detail grows by the cube and pixels and
 * triangles by powers: half of the way is an eighth of the splits.
 */

const LAST = 1000;

/** Pixels at the two ends of their slider. */
export const FINEST_PX = 0.25;
export const COARSEST_PX = 20;

/** A budget's slider starts here, if the mesh has so many. */
const SMALLEST_BUDGET = 100;

export const detailAt = (position: number): number => (position / LAST) ** 3;
export const positionOfDetail = (detail: number): number => Math.round(LAST * Math.cbrt(detail));

/** Two digits are enough, and are what is shown. */
export const pixelsAt = (position: number): number =>
  Number((FINEST_PX * (COARSEST_PX / FINEST_PX) ** (position / LAST)).toPrecision(2));

/** Triangles at a place of the budget's slider, for a mesh of so many. */
export function budgetAt(position: number, full: number): number {
  const least = Math.min(SMALLEST_BUDGET, full);
  return Math.round(least * (full / least) ** (position / LAST));
}

/** The other way round. */
export function positionOfBudget(budget: number, full: number): number {
  const least = Math.min(SMALLEST_BUDGET, full);
  if (full <= least) return LAST;
  const position = (LAST * Math.log(Math.max(budget, least) / least)) / Math.log(full / least);
  return Math.round(Math.min(position, LAST));
}
