/** Converts a three.js camera to the engine's form: an eye in mesh space. */

import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector3, type Camera, type Object3D } from 'three';

/** A camera relative to a mesh. */
export type MeshView =
  /**
   * Eye, target, up, tangent of half the vertical field of view, width and height in pixels; and the ratio of the mesh's
   * largest to smallest scale.
   */
  | { kind: 'perspective'; numbers: number[]; stretch: number }
  /** Size of a pixel in mesh units, the same at every depth. */
  | { kind: 'orthographic'; unitsPerPixel: number };

const inverse = new Matrix4();
const [eye, target, up, scale] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];

/** Computes how a camera sees an object in a viewport of `width` by `height` pixels; undefined if it sees nothing. */
export function viewOf(object: Object3D, camera: Camera, width: number, height: number): MeshView | undefined {
  if (!(width >= 1 && height >= 1)) return undefined;
  scale.setFromMatrixScale(object.matrixWorld);
  const [minScale, maxScale] = [Math.min(...scale.toArray()), Math.max(...scale.toArray())];
  if (!(minScale > 0)) return undefined;
  if ((camera as OrthographicCamera).isOrthographicCamera) {
    const { top, bottom, zoom } = camera as OrthographicCamera;
    return { kind: 'orthographic', unitsPerPixel: Math.abs(top - bottom) / (zoom * height * maxScale) };
  }
  if (!(camera as PerspectiveCamera).isPerspectiveCamera) return undefined;
  inverse.copy(object.matrixWorld).invert();
  eye.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(inverse);
  // The target is as far from the eye as the eye is from the origin: closer, the two would coincide at large coordinates.
  target.setFromMatrixColumn(camera.matrixWorld, 2).negate().transformDirection(inverse);
  target.multiplyScalar(Math.max(1, eye.length())).add(eye);
  up.setFromMatrixColumn(camera.matrixWorld, 1).transformDirection(inverse);
  // An off-center frustum (tiled rendering, stereo) is enclosed in a symmetric one.
  const p = camera.projectionMatrix.elements;
  // Mirror and cube cameras flip the image; what they see is the same.
  const [xScale, yScale] = [Math.abs(p[0]!), Math.abs(p[5]!)];
  const half = [(1 + Math.abs(p[8]!)) / xScale, (1 + Math.abs(p[9]!)) / yScale] as const;
  const pixelsHigh = height * yScale * half[1];
  const sides = [Math.max(1, Math.round((pixelsHigh * half[0]) / half[1])), Math.max(1, Math.round(pixelsHigh))];
  const numbers = [...eye.toArray(), ...target.toArray(), ...up.toArray(), half[1], ...sides];
  if (!numbers.every(Number.isFinite)) return undefined;
  // If the object is stretched along one axis, errors are scaled by at most the largest factor.
  return { kind: 'perspective', numbers, stretch: maxScale / minScale };
}
