/** A three.js camera as what the engine asks for: an eye in the mesh's own space. */
import { type Camera, type Object3D } from 'three';
/** What a camera sees. */
export type Seen = 
/** Eye, target, up, tangent of half the vertical field of view, width and height in pixels. */
{
    kind: 'perspective';
    numbers: number[];
    stretch: number;
}
/** Units of the mesh that a pixel shows everywhere. */
 | {
    kind: 'orthographic';
    unitsPerPixel: number;
};
/** Looks at an object through a camera onto so many pixels; undefined where that shows nothing. */
export declare function look(object: Object3D, camera: Camera, width: number, height: number): Seen | undefined;
