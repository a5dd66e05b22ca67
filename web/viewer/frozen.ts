/**
 * A frozen view: its frustum as lines, from the eye to behind the model, while one looks at it from outside.
 */

import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments, type PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { Framing, Look } from './framing.ts';
import type { Stage } from './stage.ts';

/** How far outside one is put: farther away by this, at least so many radii of the model, and to the side and up (radians). */
const OUTSIDE = { farther: 2.3, radii: 4.4, aside: 0.95, up: 0.22 };

export class FrozenView {
  readonly #stage: Stage;
  readonly #framing: Framing;
  #lines: LineSegments<BufferGeometry, LineBasicMaterial> | null = null;
  #before: { look: Look; radius: number } | null = null;

  constructor(stage: Stage, framing: Framing) {
    this.#stage = stage;
    this.#framing = framing;
  }

  get isFrozen(): boolean {
    return this.#lines !== null;
  }

  /** Draws the camera's frustum and moves outside of it. */
  freeze(color: string): void {
    if (this.#lines) return;
    const { content, camera, controls } = this.#stage;
    const material = new LineBasicMaterial({ color: color });
    this.#lines = new LineSegments(frustumLines(camera, content.center, content.radius), material);
    this.#stage.scene.add(this.#lines);
    const look = this.#framing.look();
    this.#before = { look, radius: content.radius };
    // The planes must hold the frustum too.
    content.radius += camera.position.distanceTo(content.center);
    const offset = new Spherical().setFromVector3(camera.position.clone().sub(controls.target));
    offset.radius = Math.max(OUTSIDE.farther * offset.radius, OUTSIDE.radii * this.#before.radius);
    offset.theta += OUTSIDE.aside;
    offset.phi = Math.max(offset.phi - OUTSIDE.up, 0.2);
    this.#framing.hold();
    const target = content.center.clone();
    this.#framing.glideTo({ eye: new Vector3().setFromSpherical(offset).add(target), target });
  }

  /** Takes the lines away; goes back to where the view was frozen, unless told to stay. */
  thaw(goesBack = true): void {
    if (!this.#lines || !this.#before) return;
    this.#lines.removeFromParent();
    this.#lines.geometry.dispose();
    this.#lines.material.dispose();
    this.#lines = null;
    if (goesBack) {
      this.#stage.content.radius = this.#before.radius;
      this.#framing.glideTo(this.#before.look);
    }
    this.#before = null;
    this.#stage.invalidate();
  }
}

/** From the eye through the corners of the picture, with the picture before and behind the model. */
function frustumLines(camera: PerspectiveCamera, center: Vector3, radius: number): BufferGeometry {
  const away = camera.position.distanceTo(center);
  const points: number[] = [];
  const near = corners(camera, Math.max(away - radius, 0.15 * away));
  const far = corners(camera, away + radius);
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
