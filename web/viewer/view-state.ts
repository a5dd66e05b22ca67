/**
 * The view of a model as parameters of the page's address, after the model itself, so that a link shows what its sender saw. Values
 * that are missing or make no sense are left out of the view.
 */

import { Vector3 } from 'three';
import type { Coloring } from '../src/index.ts';
import type { Mode } from './detail-controls.ts';
import type { CameraPose } from './framing.ts';
import type { ModelName } from './inspect-worker.ts';
import { COARSEST_PX, FINEST_PX } from './scales.ts';
import type { Backs } from './surface.ts';

/** How the level is chosen: detail from 0 to 1, screen error in pixels, or a number of triangles. */
export interface LevelChoice {
  mode: Mode;
  value: number;
}

/** Clip, time in seconds, and whether it plays. */
export interface PlaybackState {
  clip: number;
  time: number;
  plays: boolean;
}

/** Settings of the panel; those of a page that nobody has touched by default. */
export interface LookState {
  coloring: Coloring;
  wireframe: boolean;
  flat: boolean;
  /** Null if the model decides. */
  zUp: boolean | null;
  turns: boolean;
  vertexColors: boolean;
  backs: Backs;
  background: string;
  /** Direction of the light, degrees. */
  light: number;
  /** Exposure, stops. */
  exposure: number;
}

export interface ViewState {
  /** Null if the page frames the model. */
  camera: CameraPose | null;
  /** Null if it is the one that the model begins with. */
  level: LevelChoice | null;
  playback: PlaybackState | null;
  /** Null for the page's own way of drawing. */
  model: ModelName | null;
  look: LookState;
}

const COLORINGS: Record<string, Coloring> = { strip: 'strips', fan: 'fans', triangle: 'triangles' };
const BACKS: Backs[] = ['both', 'hide', 'tint'];
const MODELS: ModelName[] = ['list', 'lodstrips', 'live-strips', 'mts', 'fans', 'patterns'];
const BACKGROUNDS = ['white', 'gray', 'black'];
const LEVELS: Record<string, { mode: Mode; least: number; most: number }> = {
  detail: { mode: 'level', least: 0, most: 1 },
  error: { mode: 'pixels', least: FINEST_PX, most: COARSEST_PX },
  triangles: { mode: 'budget', least: 1, most: 0xffff_ffff },
};

/** Limits of the sliders for the light. */
export const LIGHT_LIMIT = 180;
export const EXPOSURE_LIMIT = 3;

/** Significant digits of what is not a coordinate; enough to return to the same position of a slider. */
const DIGITS = 5;

/** Reads a view from the parameters of an address; null if it has none. */
export function readView(query: string): ViewState | null {
  const given = new URLSearchParams(query);
  given.delete('model');
  if (given.size === 0) return null;
  const flag = (name: string): boolean => given.get(name) === '1';
  const choice = <T extends string>(name: string, choices: readonly T[]): T | undefined => choices.find((value) => value === given.get(name));
  return {
    camera: readCamera(given),
    level: readLevel(given),
    playback: readPlayback(given),
    model: choice('as', MODELS) ?? null,
    look: {
      coloring: COLORINGS[given.get('color') ?? ''] ?? 'surface',
      wireframe: flag('wireframe'), flat: flag('flat'), zUp: given.has('z-up') ? flag('z-up') : null, turns: flag('turn'),
      vertexColors: given.get('vertex-colors') !== '0',
      backs: choice('backs', BACKS) ?? 'file',
      background: choice('background', BACKGROUNDS) ?? 'page',
      light: readNumber(given, 'light', -LIGHT_LIMIT, LIGHT_LIMIT) ?? 0,
      exposure: readNumber(given, 'exposure', -EXPOSURE_LIMIT, EXPOSURE_LIMIT) ?? 0,
    },
  };
}

/** Writes what differs from an untouched page as parameters. */
export function writeView({ camera, level, playback, model, look }: ViewState): string[] {
  const written: string[] = [];
  const add = (name: string, value: string | number | false): void => {
    if (value !== false) written.push(`${name}=${value}`);
  };
  if (level) {
    add(Object.keys(LEVELS).find((name) => LEVELS[name]?.mode === level.mode)!, rounded(level.value, level.mode === 'budget' ? 10 : DIGITS));
  }
  if (camera) {
    const distance = camera.eye.distanceTo(camera.target);
    add('eye', writePoint(camera.eye, distance));
    add('target', writePoint(camera.target, distance));
  }
  add('as', model ?? false);
  add('color', Object.keys(COLORINGS).find((name) => COLORINGS[name] === look.coloring) ?? false);
  add('wireframe', look.wireframe && 1);
  add('flat', look.flat && 1);
  add('vertex-colors', !look.vertexColors && 0);
  add('backs', look.backs !== 'file' && look.backs);
  add('background', look.background !== 'page' && look.background);
  add('light', look.light !== 0 && rounded(look.light));
  add('exposure', look.exposure !== 0 && rounded(look.exposure));
  add('z-up', look.zUp !== null && Number(look.zUp));
  add('turn', look.turns && 1);
  if (playback) {
    add('clip', playback.clip > 0 && playback.clip + 1);
    add('time', rounded(playback.time));
    add('play', playback.plays ? 1 : 0);
  }
  return written;
}

function readCamera(given: URLSearchParams): CameraPose | null {
  const [eye, target] = [readPoint(given, 'eye'), readPoint(given, 'target')];
  return eye && target && eye.distanceTo(target) > 0 ? { eye, target } : null;
}

function readLevel(given: URLSearchParams): LevelChoice | null {
  for (const [name, { mode, least, most }] of Object.entries(LEVELS)) {
    const value = readNumber(given, name, least, most);
    if (value !== null) return { mode, value: mode === 'budget' ? Math.floor(value) : value };
  }
  return null;
}

function readPlayback(given: URLSearchParams): PlaybackState | null {
  const time = readNumber(given, 'time', 0, Number.MAX_VALUE);
  if (time === null) return null;
  return { clip: Math.floor(readNumber(given, 'clip', 1, 0xffff) ?? 1) - 1, time, plays: given.get('play') === '1' };
}

function readNumber(given: URLSearchParams, name: string, least: number, most: number): number | null {
  const text = given.get(name)?.trim();
  const value = text ? Number(text) : Number.NaN;
  return value >= least && value <= most ? value : null;
}

function readPoint(given: URLSearchParams, name: string): Vector3 | null {
  const texts = given.get(name)?.split(',') ?? [];
  const [x, y, z] = texts.map((text) => (text.trim() ? Number(text) : Number.NaN));
  const isPoint = texts.length === 3 && [x, y, z].every((value) => Number.isFinite(value) && Math.abs(value!) < 1e30);
  return isPoint ? new Vector3(x, y, z) : null;
}

/** Coordinates as exact as the distance to the target needs them. */
function writePoint(point: Vector3, distance: number): string {
  const decimals = Math.min(Math.max(DIGITS - Math.floor(Math.log10(distance)), 0), 20);
  return point.toArray().map((value) => Number(value.toFixed(decimals))).join(',');
}

const rounded = (value: number, digits = DIGITS): number => Number(value.toPrecision(digits));
