/** Distributes a target over the meshes of a scene by one priority: the error, in units that are common to all of them. */

import type { SceneTarget } from './protocol.ts';

/** What the distribution needs to know about a mesh. */
export interface Distributable {
  readonly step_count: number;
  split_count_for_error(error: number): number;
  triangle_count_at(splitCount: number): number;
  error_at(splitCount: number): number;
}

/** A mesh that takes part, with the factor from its errors to the common unit. */
interface Participant {
  mesh: number;
  model: Distributable;
  scale: number;
  instances: number;
}

/** Halvings of the interval of errors; errors are known to about a thousandth. */
const HALVINGS = 40;

/** Returns the split count of each mesh that has a share of the target. */
export function distribute(target: SceneTarget, models: (Distributable | undefined)[]): Map<number, number> {
  const participants: Participant[] = [];
  for (const { mesh, scale, instances, request } of target.meshes) {
    const model = models[mesh];
    if (model && !request) participants.push({ mesh, model, scale: Math.max(scale, Number.MIN_VALUE), instances });
  }
  const splitsAt = (error: number) => participants.map(({ model, scale }) => model.split_count_for_error(error / scale));
  const { detail, limit, tolerance } = target;
  let splits = detail === undefined ? splitsAt(tolerance) : undefined;
  if (detail !== undefined) {
    const total = participants.reduce((sum, { model }) => sum + model.step_count, 0);
    splits = largestWithin(participants, splitsAt, Math.round(Math.min(1, Math.max(0, detail)) * total), (_, split) => split);
  }
  const triangles = ({ model, instances }: Participant, split: number) => instances * model.triangle_count_at(split);
  if (limit > 0 && sumOf(participants, splits!, triangles) > limit) splits = largestWithin(participants, splitsAt, limit, triangles);
  return new Map(participants.map(({ mesh }, at) => [mesh, splits![at]!]));
}

type Count = (participant: Participant, splitCount: number) => number;

function sumOf(participants: Participant[], splits: number[], count: Count): number {
  return participants.reduce((sum, participant, at) => sum + count(participant, splits[at]!), 0);
}

/** Levels of the least common error whose counts add up to at most `limit`, then refined as far as the limit allows. */
function largestWithin(participants: Participant[], splitsAt: (error: number) => number[], limit: number, count: Count): number[] {
  // The last steps may have no error at all.
  const full = participants.map(({ model }) => model.step_count);
  if (sumOf(participants, full, count) <= limit) return full;
  let high = participants.reduce((most, { model, scale }) => Math.max(most, model.error_at(0) * scale), 0);
  let low = 0;
  for (let halving = 0; halving < HALVINGS; halving++) {
    const middle = low === 0 ? high / 2 ** 8 : Math.sqrt(low * high);
    if (!(middle > low && middle < high)) break;
    if (sumOf(participants, splitsAt(middle), count) <= limit) high = middle;
    else low = middle;
  }
  const splits = splitsAt(high);
  // The next smaller error exceeds the limit, because errors fall in steps; what is left goes to one mesh after the other.
  const finer = splitsAt(low);
  let left = limit - sumOf(participants, splits, count);
  participants.forEach((participant, at) => {
    const start = count(participant, splits[at]!);
    let [fits, exceeds] = [splits[at]!, finer[at]! + 1];
    while (exceeds - fits > 1) {
      const middle = (fits + exceeds) >> 1;
      if (count(participant, middle) - start <= left) fits = middle;
      else exceeds = middle;
    }
    left -= count(participant, fits) - start;
    splits[at] = fits;
  });
  return splits;
}
