/**
 * Maps slider positions, 0 to 1000, to values. People perceive ratios, so detail grows with the cube of the position, and pixels
 * and triangles grow exponentially: halfway along the detail slider, an eighth of the vertex splits are applied.
 */

const MAX_POSITION = 1000;

/** Screen errors at the two ends of their slider. */
export const FINEST_PX = 0.25;
export const COARSEST_PX = 20;

/** Lower end of the budget slider, if the mesh has that many triangles. */
const SMALLEST_BUDGET = 100;

export const detailAt = (position: number): number => (position / MAX_POSITION) ** 3;
export const positionOfDetail = (detail: number): number => Math.round(MAX_POSITION * Math.cbrt(detail));

/** Screen error in pixels, rounded to the two digits that are displayed. */
export const pixelsAt = (position: number): number =>
  Number((FINEST_PX * (COARSEST_PX / FINEST_PX) ** (position / MAX_POSITION)).toPrecision(2));

/** Inverse of `pixelsAt`. */
export const positionOfPixels = (pixels: number): number =>
  Math.round((MAX_POSITION * Math.log(pixels / FINEST_PX)) / Math.log(COARSEST_PX / FINEST_PX));

/** Triangle budget at a slider position, for a mesh of `full` triangles. */
export function budgetAt(position: number, full: number): number {
  const least = Math.min(SMALLEST_BUDGET, full);
  return Math.round(least * (full / least) ** (position / MAX_POSITION));
}

/** Inverse of `budgetAt`. */
export function positionOfBudget(budget: number, full: number): number {
  const least = Math.min(SMALLEST_BUDGET, full);
  if (full <= least) return MAX_POSITION;
  const position = (MAX_POSITION * Math.log(Math.max(budget, least) / least)) / Math.log(full / least);
  return Math.round(Math.min(position, MAX_POSITION));
}
