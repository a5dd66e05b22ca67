/**
 * What decodes, builds and answers: the same code in a worker and in the page.
 *
 * Bytes wait in a queue and are decoded in slices of a few milliseconds, so that requests are answered between them.
 * What has come is told now and then, the more seldom the longer telling takes.
 */
import type { Order, Report } from './protocol.ts';
export declare class Engine {
    #private;
    constructor(report: (report: Report) => void, sliceMs: number);
    /** Does what the page orders. */
    take(order: Order): void;
    dispose(): void;
}
