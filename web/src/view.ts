/** A three.js camera as what the engine asks for: an eye in the mesh's own space. */

import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector3, type Camera, type Object3D } from 'three';

/** What a camera sees. */
export type Seen =
  /** Eye, target, up, tangent of half the vertical field of view, width and height in pixels. */
  | { kind: 'perspective'; numbers: number[]; stretch: number }
  /** Units of the mesh that a pixel shows everywhere. */
  | { kind: 'orthographic'; unitsPerPixel: number };

const inverse = new Matrix4();
const [eye, target, up, scale] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];

/** Looks at an object through a camera onto so many pixels; undefined where that shows nothing. */
export function look(object: Object3D, camera: Camera, width: number, height: number): Seen | undefined {
  if (!(width >= 1 && height >= 1)) return undefined;
  scale.setFromMatrixScale(object.matrixWorld);
  const [least, most] = [Math.min(...scale.toArray()), Math.max(...scale.toArray())];
  if (!(least > 0)) return undefined;
  if ((camera as OrthographicCamera).isOrthographicCamera) {
    const { top, bottom, zoom } = camera as OrthographicCamera;
    return { kind: 'orthographic', unitsPerPixel: Math.abs(top - bottom) / (zoom * height * most) };
  }
  if (!(camera as PerspectiveCamera).isPerspectiveCamera) return undefined;
  inverse.copy(object.matrixWorld).invert();
  eye.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(inverse);
  // As far away as the eye is from the origin: nearer, the two would be one where coordinates are large.
  target.setFromMatrixColumn(camera.matrixWorld, 2).negate().transformDirection(inverse);
  target.multiplyScalar(Math.max(1, eye.length())).add(eye);
  up.setFromMatrixColumn(camera.matrixWorld, 1).transformDirection(inverse);
  // A picture whose middle is not where the camera looks (a part of a larger one, one eye's) lies within one whose is.
  const p = camera.projectionMatrix.elements;
  // Cameras that look into a mirror or a cube have it upside down: they see as much.
  const [across, upwards] = [Math.abs(p[0]!), Math.abs(p[5]!)];
  const half = [(1 + Math.abs(p[8]!)) / across, (1 + Math.abs(p[9]!)) / upwards] as const;
  const pixelsHigh = height * upwards * half[1];
  const sides = [Math.max(1, Math.round((pixelsHigh * half[0]) / half[1])), Math.max(1, Math.round(pixelsHigh))];
  const numbers = [...eye.toArray(), ...target.toArray(), ...up.toArray(), half[1], ...sides];
  if (!numbers.every(Number.isFinite)) return undefined;
  // Where the object is stretched along one axis, an error is as large as along the longest.
  return { kind: 'perspective', numbers, stretch: most / least };
}
