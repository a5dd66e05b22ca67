/** A connection to an engine, in a worker of its own or in the page: both look the same. */
import type { Order, Report } from './protocol.ts';
export interface Link {
    order(order: Order): void;
    dispose(): void;
}
/** Starts an engine; what it reports comes to `report`. */
export declare function link(module: WebAssembly.Module, useWorker: boolean, report: (report: Report) => void): Link;
