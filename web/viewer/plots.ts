/** Plots of the last seconds: time of each frame, triangles, and bytes that have arrived. Nothing is measured while they are folded. */

import type { StriataScene } from '../src/index.ts';
import { element } from './dom.ts';
import { formatBytes, formatCount } from './format.ts';
import type { Stage } from './stage.ts';
import { themeColor } from './theme.ts';

/** Time that the plots show. */
const SPAN_MS = 10_000;

const REDRAW_INTERVAL_MS = 200;

/** Heights in CSS pixels: a plot, and its text above it. */
const PLOT_HEIGHT = 26;
const TEXT_HEIGHT = 15;

interface Sample {
  at: number;
  /** Null if no frame was drawn then. */
  frameMs: number | null;
  triangles: number;
  bytes: number;
}

/** One of the plots. */
interface Plot {
  name: string;
  value: (sample: Sample) => number | null;
  format: (value: number) => string;
  /** Whether each value is a bar of its own, because there is nothing between frames. */
  isBars: boolean;
}

const PLOTS: Plot[] = [
  { name: 'Frame time', value: ({ frameMs }) => frameMs, format: (ms) => `${ms.toFixed(1)} ms`, isBars: true },
  { name: 'Triangles', value: ({ triangles }) => triangles, format: formatCount, isBars: false },
  { name: 'Loaded', value: ({ bytes }) => bytes, format: formatBytes, isBars: false },
];

export class Plots {
  readonly #details = element<HTMLDetailsElement>('plots');
  readonly #canvas = element<HTMLCanvasElement>('plot');
  readonly #model: () => StriataScene | null;
  #samples: Sample[] = [];

  constructor(stage: Stage, model: () => StriataScene | null) {
    this.#model = model;
    stage.onFrame = (ms) => this.#sample(ms);
    this.#details.addEventListener('toggle', () => this.#refresh());
    setInterval(() => this.#refresh(), REDRAW_INTERVAL_MS);
  }

  #sample(frameMs: number | null): void {
    const model = this.#model();
    if (!this.#details.open || !model) return;
    this.#samples.push({ at: performance.now(), frameMs, triangles: model.triangleCount, bytes: model.bytesReceived });
  }

  #refresh(): void {
    if (!this.#details.open) {
      this.#samples = [];
      return;
    }
    if (document.hidden) return;
    this.#sample(null);
    const now = performance.now();
    this.#samples = this.#samples.filter(({ at }) => at > now - SPAN_MS);
    const pen = this.#pen();
    if (!pen) return;
    const texts = PLOTS.map((plot, row) => this.#draw(pen, plot, row, now));
    this.#canvas.setAttribute('aria-label', `Last ${SPAN_MS / 1000} seconds: ${texts.join(', ')}`);
  }

  /** Fits the canvas to its place, and clears it. */
  #pen(): CanvasRenderingContext2D | null {
    const canvas = this.#canvas;
    const ratio = Math.max(devicePixelRatio, 1);
    canvas.style.height = `${PLOTS.length * (PLOT_HEIGHT + TEXT_HEIGHT)}px`;
    canvas.width = Math.max(Math.round(canvas.clientWidth * ratio), 1);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    const pen = canvas.getContext('2d');
    pen?.scale(ratio, ratio);
    return pen;
  }

  /** Draws a plot, and returns its last value as text. */
  #draw(pen: CanvasRenderingContext2D, plot: Plot, row: number, now: number): string {
    const width = this.#canvas.clientWidth;
    const bottom = (row + 1) * (PLOT_HEIGHT + TEXT_HEIGHT) - 1;
    const values = this.#samples.flatMap((sample) => {
      const value = plot.value(sample);
      return value === null ? [] : [[width * (1 - (now - sample.at) / SPAN_MS), value] as const];
    });
    const most = values.reduce((most, [, value]) => Math.max(most, value), 0);
    const y = (value: number): number => bottom - (most > 0 ? (value / most) * (PLOT_HEIGHT - 3) : 0);
    pen.fillStyle = pen.strokeStyle = themeColor('--rule');
    pen.fillRect(0, bottom, width, 1);
    pen.fillStyle = pen.strokeStyle = themeColor('--accent');
    pen.lineWidth = 1.5;
    pen.beginPath();
    for (const [x, value] of values) {
      if (plot.isBars) pen.moveTo(x, bottom);
      pen.lineTo(x, y(value));
    }
    pen.stroke();
    const last = values.at(-1);
    const text = last ? `${plot.format(last[1])}${plot.isBars ? `, at most ${plot.format(most)}` : ''}` : 'none';
    pen.font = `11px ${getComputedStyle(this.#canvas).fontFamily}`;
    pen.fillStyle = themeColor('--soft');
    pen.fillText(plot.name, 0, bottom - PLOT_HEIGHT - 2);
    pen.fillStyle = themeColor('--ink');
    pen.textAlign = 'right';
    pen.fillText(text, width, bottom - PLOT_HEIGHT - 2);
    pen.textAlign = 'left';
    return `${plot.name} ${text}`;
  }
}
