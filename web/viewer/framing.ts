/**
 * Frames the model: once, from the bounds of the vertices that have arrived first. Later bounds move the camera only if the model
 * outgrows the picture, smoothly, and never after the user has moved the camera.
 */

import { MathUtils, Sphere, Spherical, Vector3 } from 'three';
import { prefersReducedMotion } from './dom.ts';
import { FIELD_OF_VIEW, type Stage } from './stage.ts';

/** Initial direction of the camera: a little from the right and from above. */
const INITIAL_DIRECTION = new Spherical(1, MathUtils.degToRad(76), MathUtils.degToRad(26));

/** Bounds that grow by less than this factor do not move the camera. */
const GROWTH_THRESHOLD = 1.08;

/** Duration of a camera move. */
const GLIDE_SECONDS = 0.7;

/** Margin around the model, as a factor of its radius. */
const MARGIN = 1.06;

/** Position of a camera and the point it looks at. */
export interface CameraPose {
  eye: Vector3;
  target: Vector3;
}

export class Framing {
  readonly #stage: Stage;
  #framed = new Sphere(new Vector3(), 0);
  #measuredVertexCount = 0;
  #isUserControlled = false;
  /** Pose that the first bounds set instead of that of the whole model. */
  #first: CameraPose | null = null;
  #glide: ((seconds: number) => boolean) | null = null;

  constructor(stage: Stage) {
    this.#stage = stage;
    stage.controls.addEventListener('start', () => this.takeControl());
  }

  /** Stops automatic framing: from now on the user controls the camera. */
  takeControl(): void {
    this.#isUserControlled = true;
    this.#stop();
  }

  /** Whether the camera is where the user has moved it, and not where it frames the model. */
  get isUserControlled(): boolean {
    return this.#isUserControlled;
  }

  /** Starts a new model: its first bounds set the camera, unless `keepsCamera` (the same model loaded again). `first` is where it begins. */
  restart(keepsCamera: boolean, first: CameraPose | null = null): void {
    this.#first = first;
    this.#measuredVertexCount = 0;
    this.#isUserControlled = keepsCamera;
    if (!keepsCamera) this.#framed.radius = 0;
  }

  /** Follows the bounds of a loading model, in world space, once it has grown enough to matter. */
  follow(measure: () => Sphere | null, vertexCount: number, isComplete: boolean): void {
    if (vertexCount < 1.5 * this.#measuredVertexCount && !(isComplete && vertexCount > this.#measuredVertexCount)) return;
    const sphere = measure();
    if (!sphere) return;
    this.#measuredVertexCount = vertexCount;
    this.#stage.content.copy(sphere);
    const isFirst = this.#framed.radius === 0;
    if (!isFirst && (this.#isUserControlled || !hasOutgrown(sphere, this.#framed))) return;
    this.#framed.copy(sphere);
    // Set first, since the distance limits of the last model would clamp the camera.
    this.#setDistanceLimits();
    if (isFirst && this.#first) return this.#begin(this.#first);
    const pose = this.#wholeModelPose(isFirst ? new Vector3().setFromSpherical(INITIAL_DIRECTION) : this.#direction());
    if (isFirst) this.moveTo(pose);
    else this.glideTo(pose);
  }

  /** Moves the camera to where another user had it. */
  #begin(pose: CameraPose): void {
    this.#first = null;
    this.#isUserControlled = true;
    const { controls } = this.#stage;
    const distance = pose.eye.distanceTo(pose.target);
    controls.minDistance = Math.min(controls.minDistance, 0.9 * distance);
    controls.maxDistance = Math.max(controls.maxDistance, 1.1 * distance);
    this.moveTo(pose);
  }

  /** Follows bounds that have changed although no vertices have arrived. */
  remeasure(measure: () => Sphere | null, vertexCount: number): void {
    this.#measuredVertexCount = 0;
    this.follow(measure, vertexCount, true);
  }

  /** Shows the whole model from the initial direction. */
  reset(): void {
    this.#isUserControlled = false;
    this.#framed.copy(this.#stage.content);
    this.#setDistanceLimits();
    this.glideTo(this.#wholeModelPose(new Vector3().setFromSpherical(INITIAL_DIRECTION)));
  }

  /** Frames the model again after the pivot was tilted. */
  onTilted(measure: () => Sphere | null, vertexCount: number): void {
    this.#framed.radius = 0;
    this.remeasure(measure, vertexCount);
  }

  /** Moves the camera to a part of the model, and keeps its direction. */
  focus(part: Sphere): void {
    this.takeControl();
    const { controls } = this.#stage;
    controls.minDistance = Math.min(controls.minDistance, 0.02 * part.radius);
    this.glideTo(poseFor(part, this.#direction()));
  }

  /** Current camera pose. */
  pose(): CameraPose {
    return { eye: this.#stage.camera.position.clone(), target: this.#stage.controls.target.clone() };
  }

  /** Moves the camera smoothly, or immediately if the user prefers reduced motion. */
  glideTo(pose: CameraPose): void {
    this.#stop();
    if (prefersReducedMotion()) return this.moveTo(pose);
    const from = this.pose();
    let elapsed = 0;
    const step = (seconds: number): boolean => {
      elapsed += seconds;
      const t = MathUtils.smootherstep(elapsed, 0, GLIDE_SECONDS);
      this.#stage.controls.target.lerpVectors(from.target, pose.target, t);
      this.#stage.camera.position.copy(interpolate(from, pose, t)).add(this.#stage.controls.target);
      if (t >= 1) this.#stop();
      return t < 1;
    };
    this.#glide = step;
    this.#stage.beforeFrame.add(step);
    this.#stage.invalidate();
  }

  /** Orbits around the target by angles in radians, for keyboard control. */
  orbit(right: number, up: number): void {
    this.takeControl();
    const { camera, controls } = this.#stage;
    const offset = new Spherical().setFromVector3(camera.position.clone().sub(controls.target));
    offset.theta += right;
    offset.phi = MathUtils.clamp(offset.phi - up, 0.02, Math.PI - 0.02);
    this.moveTo({ eye: new Vector3().setFromSpherical(offset).add(controls.target), target: controls.target.clone() });
  }

  /** Multiplies the distance to the target: below 1 moves closer. */
  zoom(factor: number): void {
    this.takeControl();
    const { camera, controls } = this.#stage;
    const offset = camera.position.clone().sub(controls.target);
    offset.setLength(MathUtils.clamp(offset.length() * factor, controls.minDistance, controls.maxDistance));
    this.moveTo({ eye: offset.add(controls.target), target: controls.target.clone() });
  }

  /** Moves sideways and up by fractions of the distance to the target. */
  pan(right: number, up: number): void {
    this.takeControl();
    const { camera, controls } = this.#stage;
    const distance = camera.position.distanceTo(controls.target);
    const step = new Vector3(right * distance, up * distance, 0).applyQuaternion(camera.quaternion);
    this.moveTo({ eye: camera.position.clone().add(step), target: controls.target.clone().add(step) });
  }

  #wholeModelPose(direction: Vector3): CameraPose {
    return poseFor(this.#framed, direction);
  }

  #direction(): Vector3 {
    return this.#stage.camera.position.clone().sub(this.#stage.controls.target);
  }

  #setDistanceLimits(): void {
    this.#stage.controls.minDistance = 0.02 * this.#framed.radius;
    this.#stage.controls.maxDistance = 60 * this.#framed.radius;
  }

  /** Moves the camera at once. */
  moveTo(pose: CameraPose): void {
    this.#stage.camera.position.copy(pose.eye);
    this.#stage.controls.target.copy(pose.target);
    this.#stage.controls.update();
    this.#stage.invalidate();
  }

  #stop(): void {
    if (this.#glide) this.#stage.beforeFrame.delete(this.#glide);
    this.#glide = null;
  }
}

/** Offset from the target to the eye between two poses: around the model, not through it. */
function interpolate(from: CameraPose, to: CameraPose, t: number): Vector3 {
  const start = new Spherical().setFromVector3(from.eye.clone().sub(from.target));
  const end = new Spherical().setFromVector3(to.eye.clone().sub(to.target));
  const turn = MathUtils.euclideanModulo(end.theta - start.theta + Math.PI, 2 * Math.PI) - Math.PI;
  const radius = start.radius * (end.radius / start.radius) ** t;
  return new Vector3().setFromSphericalCoords(radius, MathUtils.lerp(start.phi, end.phi, t), start.theta + turn * t);
}

function hasOutgrown(sphere: Sphere, framed: Sphere): boolean {
  return sphere.radius + sphere.center.distanceTo(framed.center) > GROWTH_THRESHOLD * framed.radius;
}

/** Pose that shows a sphere from a direction. */
function poseFor({ center, radius }: Sphere, direction: Vector3): CameraPose {
  const distance = (MARGIN * radius) / Math.sin(MathUtils.degToRad(FIELD_OF_VIEW / 2));
  return { eye: direction.clone().setLength(distance).add(center), target: center.clone() };
}
