/** Vertex and index buffers that grow: rewritten in part as long as there is room, by doubling where there is none. */
import { BufferGeometry } from 'three';
import type { Update } from './protocol.ts';
/** A geometry whose buffers have more room than there are vertices: its bounds are told, not looked for. */
export declare class GrowingGeometry extends BufferGeometry {
    #private;
    /** Smallest and largest coordinates. */
    bounds: ArrayLike<number>;
    computeBoundingBox(): void;
    computeBoundingSphere(): void;
    /** Takes what an update brings. */
    take({ state, vertices, smoothNormals, indices, groupCounts }: Update): void;
}
