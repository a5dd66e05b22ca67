/**
 * How the model is framed: from the bounds of what has come, once; later bounds move the camera only where it must, gently,
 * and never after someone has taken hold of it.
 */

import { Box3, type BufferGeometry, MathUtils, type Mesh, Sphere, Spherical, Vector3 } from 'three';
import { prefersStillness } from './page.ts';
import { ANGLE, type Stage } from './stage.ts';

/** From where one looks first: a little from the right and from above. */
const FIRST_LOOK = new Spherical(1, MathUtils.degToRad(76), MathUtils.degToRad(26));

/** Bounds that grow by less leave the camera alone. */
const GROWTH_SEEN = 1.08;

/** How long the camera takes from one place to another. */
const GLIDE_SECONDS = 0.7;

/** Room around the model. */
const MARGIN = 1.06;

/** Where a camera stands and what it looks at. */
export interface Look {
  eye: Vector3;
  target: Vector3;
}

export class Framing {
  readonly #stage: Stage;
  #framed = new Sphere(new Vector3(), 0);
  #measured = 0;
  #isHeld = false;
  #glide: ((seconds: number) => boolean) | null = null;

  constructor(stage: Stage) {
    this.#stage = stage;
    stage.controls.addEventListener('start', () => this.hold());
  }

  /** From now on the camera is the reader's. */
  hold(): void {
    this.#isHeld = true;
    this.#stop();
  }

  /** A new model: the next bounds frame it, unless the camera is to stay (the same model once more). */
  restart(keepsCamera: boolean): void {
    this.#measured = 0;
    this.#isHeld = keepsCamera;
    if (!keepsCamera) this.#framed.radius = 0;
  }

  /** Looks at the bounds again where the model has grown enough to matter; `true` to look in any case. */
  follow(mesh: Mesh<BufferGeometry>, vertexCount: number, isComplete: boolean): void {
    if (vertexCount < 1.5 * this.#measured && !(isComplete && vertexCount > this.#measured)) return;
    const sphere = boundsOf(mesh, vertexCount);
    if (!sphere) return;
    this.#measured = vertexCount;
    this.#stage.content.copy(sphere);
    const isFirst = this.#framed.radius === 0;
    if (!isFirst && (this.#isHeld || !hasOutgrown(sphere, this.#framed))) return;
    this.#framed.copy(sphere);
    // First, since the distances of the last model would hold the camera.
    this.#setDistances();
    const look = this.#wholeLook(isFirst ? new Vector3().setFromSpherical(FIRST_LOOK) : this.#direction());
    if (isFirst) this.#place(look);
    else this.glideTo(look);
  }

  /** The whole model from the first side. */
  reset(): void {
    this.#isHeld = false;
    this.#framed.copy(this.#stage.content);
    this.#setDistances();
    this.glideTo(this.#wholeLook(new Vector3().setFromSpherical(FIRST_LOOK)));
  }

  /** Bounds after the pivot was tilted. */
  turned(mesh: Mesh<BufferGeometry>, vertexCount: number): void {
    this.#measured = 0;
    this.#framed.radius = 0;
    this.follow(mesh, vertexCount, true);
  }

  /** Where the camera stands now. */
  look(): Look {
    return { eye: this.#stage.camera.position.clone(), target: this.#stage.controls.target.clone() };
  }

  /** Moves the camera there, at once where less motion is wanted. */
  glideTo(look: Look): void {
    this.#stop();
    if (prefersStillness()) return this.#place(look);
    const from = this.look();
    let passed = 0;
    const step = (seconds: number): boolean => {
      passed += seconds;
      const t = MathUtils.smootherstep(passed, 0, GLIDE_SECONDS);
      this.#stage.controls.target.lerpVectors(from.target, look.target, t);
      this.#stage.camera.position.copy(between(from, look, t)).add(this.#stage.controls.target);
      if (t >= 1) this.#stop();
      return t < 1;
    };
    this.#glide = step;
    this.#stage.beforeFrame.add(step);
    this.#stage.invalidate();
  }

  /** Turns about the target, radians; keys do it. */
  turn(right: number, up: number): void {
    this.hold();
    const { camera, controls } = this.#stage;
    const offset = new Spherical().setFromVector3(camera.position.clone().sub(controls.target));
    offset.theta += right;
    offset.phi = MathUtils.clamp(offset.phi - up, 0.02, Math.PI - 0.02);
    this.#place({ eye: new Vector3().setFromSpherical(offset).add(controls.target), target: controls.target.clone() });
  }

  /** Goes nearer (below 1) or farther. */
  zoom(factor: number): void {
    this.hold();
    const { camera, controls } = this.#stage;
    const offset = camera.position.clone().sub(controls.target);
    offset.setLength(MathUtils.clamp(offset.length() * factor, controls.minDistance, controls.maxDistance));
    this.#place({ eye: offset.add(controls.target), target: controls.target.clone() });
  }

  /** Moves sideways and up by shares of the distance. */
  pan(right: number, up: number): void {
    this.hold();
    const { camera, controls } = this.#stage;
    const away = camera.position.distanceTo(controls.target);
    const step = new Vector3(right * away, up * away, 0).applyQuaternion(camera.quaternion);
    this.#place({ eye: camera.position.clone().add(step), target: controls.target.clone().add(step) });
  }

  #wholeLook(direction: Vector3): Look {
    const away = (MARGIN * this.#framed.radius) / Math.sin(MathUtils.degToRad(ANGLE / 2));
    const target = this.#framed.center.clone();
    return { eye: direction.clone().setLength(away).add(target), target };
  }

  #direction(): Vector3 {
    return this.#stage.camera.position.clone().sub(this.#stage.controls.target);
  }

  #setDistances(): void {
    this.#stage.controls.minDistance = 0.02 * this.#framed.radius;
    this.#stage.controls.maxDistance = 60 * this.#framed.radius;
  }

  #place(look: Look): void {
    this.#stage.camera.position.copy(look.eye);
    this.#stage.controls.target.copy(look.target);
    this.#stage.controls.update();
    this.#stage.invalidate();
  }

  #stop(): void {
    if (this.#glide) this.#stage.beforeFrame.delete(this.#glide);
    this.#glide = null;
  }
}

/** From the target to the eye, on the way between two looks: round the model, not through it. */
function between(from: Look, to: Look, t: number): Vector3 {
  const start = new Spherical().setFromVector3(from.eye.clone().sub(from.target));
  const end = new Spherical().setFromVector3(to.eye.clone().sub(to.target));
  const turn = MathUtils.euclideanModulo(end.theta - start.theta + Math.PI, 2 * Math.PI) - Math.PI;
  const radius = start.radius * (end.radius / start.radius) ** t;
  return new Vector3().setFromSphericalCoords(radius, MathUtils.lerp(start.phi, end.phi, t), start.theta + turn * t);
}

function hasOutgrown(sphere: Sphere, framed: Sphere): boolean {
  return sphere.radius + sphere.center.distanceTo(framed.center) > GROWTH_SEEN * framed.radius;
}

/** A sphere about the vertices that have come, in the world. */
function boundsOf(mesh: Mesh<BufferGeometry>, vertexCount: number): Sphere | null {
  const positions = mesh.geometry.getAttribute('position');
  if (!positions) return null;
  const last = Math.min(vertexCount, positions.count);
  mesh.updateWorldMatrix(true, false);
  const point = new Vector3();
  const box = new Box3();
  const world = (index: number): Vector3 => point.fromBufferAttribute(positions, index).applyMatrix4(mesh.matrixWorld);
  for (let index = 0; index < last; index += 1) box.expandByPoint(world(index));
  if (box.isEmpty()) return null;
  const sphere = new Sphere(box.getCenter(new Vector3()), 0);
  for (let index = 0; index < last; index += 1) {
    sphere.radius = Math.max(sphere.radius, sphere.center.distanceToSquared(world(index)));
  }
  sphere.radius = Math.max(Math.sqrt(sphere.radius), 1e-6);
  return sphere;
}
