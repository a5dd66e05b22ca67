/** A three.js mesh that goes to any level of its model. */
import { Mesh, type BufferGeometry, type Material } from 'three';
import { StriataError } from './error.ts';
import type { Order, State, Update } from './protocol.ts';
import type { Colouring, Kind, StriataEvents, StriataMeshLike, Timings } from './types.ts';
/** What a mesh needs of whoever loads it. */
export interface Mind {
    order(order: Order): void;
    bytes(): {
        received: number;
        total: number | null;
    };
    dispose(): void;
}
/** Made by a `StriataLoader`. */
export declare class StriataMesh extends Mesh<BufferGeometry, Material | Material[], StriataEvents> implements StriataMeshLike {
    #private;
    readonly isStriataMesh = true;
    readonly finished: Promise<void>;
    state: State;
    constructor(first: Update, material: Material | Material[] | undefined, mind: Mind);
    get detail(): number;
    set detail(detail: number);
    get triangleBudget(): number | null;
    set triangleBudget(budget: number | null);
    get error(): number;
    get maxError(): number | null;
    set maxError(error: number | null);
    get pixelError(): number | null;
    set pixelError(pixels: number | null);
    get frozen(): boolean;
    set frozen(frozen: boolean);
    get colouring(): Colouring;
    set colouring(colouring: Colouring);
    get wireframe(): boolean;
    set wireframe(wireframe: boolean);
    get triangleCount(): number;
    get fullTriangleCount(): number;
    get vertexCount(): number;
    get splitCount(): number;
    get stepCount(): number;
    get complete(): boolean;
    get bytesReceived(): number;
    get bytesTotal(): number | null;
    get diagonal(): number;
    get kind(): Kind;
    get timings(): Readonly<Timings>;
    /** A plain mesh that shows what this one shows: geometry and material are shared, levels are chosen here alone. */
    clone(recursive?: boolean): this;
    dispose(): void;
    /** Takes another level; called by the loader. */
    update(update: Update): void;
    /** Nothing more comes; called by the loader. */
    end(error?: StriataError): void;
}
