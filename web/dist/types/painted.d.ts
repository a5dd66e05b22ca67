/** Triangles in colours of their own: no two share a vertex, so each can have any colour. */
import { BufferGeometry } from 'three';
/** A geometry of its own for triangles with a number each. */
export declare function painted(positions: ArrayLike<number>, indices: ArrayLike<number>, numbers: ArrayLike<number>): BufferGeometry;
