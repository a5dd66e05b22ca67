/** A frozen view: draws its frustum as lines, from the eye to behind the model, while the user looks at it from outside. */

import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments, type PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { CameraPose, Framing } from './framing.ts';
import { HELPER_LAYER, type Stage } from './stage.ts';

/** Where the camera goes: a factor on its distance, a minimum distance in model radii, and angles sideways and up in radians. */
const OUTSIDE = { distanceFactor: 2.3, minRadii: 4.4, sideways: 0.95, up: 0.22 };

export class FrozenView {
  readonly #stage: Stage;
  readonly #framing: Framing;
  #lines: LineSegments<BufferGeometry, LineBasicMaterial> | null = null;
  #before: { pose: CameraPose; radius: number } | null = null;

  constructor(stage: Stage, framing: Framing) {
    this.#stage = stage;
    this.#framing = framing;
  }

  get isFrozen(): boolean {
    return this.#lines !== null;
  }

  /** Draws the camera's frustum and moves the camera outside of it. */
  freeze(color: string): void {
    if (this.#lines) return;
    const { content, camera, controls } = this.#stage;
    const material = new LineBasicMaterial({ color });
    this.#lines = new LineSegments(frustumLines(camera, content.center, content.radius), material);
    this.#lines.layers.set(HELPER_LAYER);
    this.#stage.scene.add(this.#lines);
    const pose = this.#framing.pose();
    this.#before = { pose, radius: content.radius };
    // The near and far planes must enclose the frustum, too.
    content.radius += camera.position.distanceTo(content.center);
    const offset = new Spherical().setFromVector3(camera.position.clone().sub(controls.target));
    offset.radius = Math.max(OUTSIDE.distanceFactor * offset.radius, OUTSIDE.minRadii * this.#before.radius);
    offset.theta += OUTSIDE.sideways;
    offset.phi = Math.max(offset.phi - OUTSIDE.up, 0.2);
    this.#framing.takeControl();
    const target = content.center.clone();
    this.#framing.glideTo({ eye: new Vector3().setFromSpherical(offset).add(target), target });
  }

  /** Removes the lines and, unless `restoresCamera` is false, returns to the frozen view. */
  unfreeze(restoresCamera = true): void {
    if (!this.#lines || !this.#before) return;
    this.#lines.removeFromParent();
    this.#lines.geometry.dispose();
    this.#lines.material.dispose();
    this.#lines = null;
    if (restoresCamera) {
      this.#stage.content.radius = this.#before.radius;
      this.#framing.glideTo(this.#before.pose);
    }
    this.#before = null;
    this.#stage.invalidate();
  }
}

/** Lines from the eye through the corners of the picture, with rectangles in front of and behind the model. */
function frustumLines(camera: PerspectiveCamera, center: Vector3, radius: number): BufferGeometry {
  const distance = camera.position.distanceTo(center);
  const points: number[] = [];
  const near = corners(camera, Math.max(distance - radius, 0.15 * distance));
  const far = corners(camera, distance + radius);
  for (const [at, corner] of far.entries()) {
    points.push(...camera.position.toArray(), ...corner.toArray());
    for (const ring of [near, far]) {
      points.push(...(ring[at] ?? corner).toArray(), ...(ring[(at + 1) % ring.length] ?? corner).toArray());
    }
  }
  return new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points, 3));
}

function corners(camera: PerspectiveCamera, depth: number): Vector3[] {
  const signs: [number, number][] = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
  const height = depth * Math.tan((camera.fov * Math.PI) / 360);
  return signs.map(([x, y]) => camera.localToWorld(new Vector3(x * height * camera.aspect, y * height, -depth)));
}
