/**
 * The 3D stage: renderer, lights, camera and render loop.
 *
 * A frame is drawn only if something has changed: code that changes the picture calls `invalidate`. The lights are attached to
 * the camera, so a model is well lit from every side. Model coordinates are y-up; for z-up models the pivot is tilted.
 */

import {
  Color, DirectionalLight, Group, HemisphereLight, MathUtils, PerspectiveCamera, Scene, Sphere, SRGBColorSpace, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { prefersReducedMotion } from './dom.ts';

/** Higher pixel ratios are hardly visible but cost fill rate. */
const MAX_PIXEL_RATIO = 2;

/** Field of view of the shorter side, degrees: a model that fits once fits in windows of any shape. */
export const FIELD_OF_VIEW = 35;

/** Window over which frames are counted. */
const FRAME_COUNT_WINDOW_MS = 1000;

export class Stage {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  readonly controls: OrbitControls;
  /** Parent of the model; tilted if z is up. */
  readonly pivot = new Group();
  /** Bounding sphere, in world space, that the near and far planes must enclose. */
  readonly content = new Sphere(new Vector3(), 1);
  /** Callbacks run before each frame with the seconds since the last one; returning true requests another frame. */
  readonly beforeFrame = new Set<(seconds: number) => boolean>();

  #frameRequest = 0;
  #lastFrameTime = 0;
  #frameTimes: number[] = [];

  /** Throws if the browser does not support WebGL 2. */
  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.scene.add(this.camera, this.pivot);
    this.#light();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !prefersReducedMotion();
    this.controls.dampingFactor = 0.12;
    this.controls.autoRotateSpeed = 1.6;
    this.controls.addEventListener('change', () => this.invalidate());
    this.controls.addEventListener('start', () => this.invalidate());
    new ResizeObserver(() => this.#resize()).observe(canvas);
    document.addEventListener('visibilitychange', () => this.invalidate());
  }

  /** Requests a frame. */
  invalidate(): void {
    if (this.#frameRequest === 0) this.#frameRequest = requestAnimationFrame((now) => this.#frame(now));
  }

  /** Frames drawn in the last second; 0 when idle. */
  get framesPerSecond(): number {
    const since = performance.now() - FRAME_COUNT_WINDOW_MS;
    this.#frameTimes = this.#frameTimes.filter((time) => time > since);
    return this.#frameTimes.length > 2 ? this.#frameTimes.length : 0;
  }

  setBackground(color: string): void {
    this.scene.background = new Color(color);
    this.invalidate();
  }

  /** Renders the stage to a PNG image. */
  async toPng(): Promise<Blob> {
    this.#fitPlanes();
    this.renderer.render(this.scene, this.camera);
    const blob = await new Promise<Blob | null>((resolve) => this.renderer.domElement.toBlob(resolve, 'image/png'));
    if (!blob) throw new Error('the browser could not encode the image');
    return blob;
  }

  #frame(now: number): void {
    this.#frameRequest = 0;
    const seconds = Math.min((now - this.#lastFrameTime) / 1000, 0.1);
    this.#lastFrameTime = now;
    let again = this.controls.autoRotate && !document.hidden;
    for (const step of this.beforeFrame) again = step(seconds) || again;
    this.controls.update(seconds);
    this.#fitPlanes();
    this.renderer.render(this.scene, this.camera);
    this.#frameTimes.push(performance.now());
    if (again) this.invalidate();
  }

  /** Fits the near and far planes tightly around the content, to make best use of the depth buffer. */
  #fitPlanes(): void {
    const { center, radius } = this.content;
    const distance = this.camera.position.distanceTo(center);
    this.camera.far = distance + 1.05 * radius;
    this.camera.near = Math.max(distance - 1.05 * radius, this.camera.far * 5e-4);
    this.camera.updateProjectionMatrix();
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.renderer.domElement;
    const [width, height] = [Math.max(clientWidth, 1), Math.max(clientHeight, 1)];
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, MAX_PIXEL_RATIO));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.fov = verticalAngle(this.camera.aspect);
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }

  #light(): void {
    const key = new DirectionalLight(0xfff4e6, 2.1);
    key.position.set(-0.7, 0.9, 0.9);
    const rim = new DirectionalLight(0xbfd4ff, 0.7);
    rim.position.set(1, -0.2, -0.35);
    this.camera.add(key, key.target, rim, rim.target);
    this.scene.add(new HemisphereLight(0xf4f0ff, 0x9c8a78, 1.3));
  }
}

function verticalAngle(aspect: number): number {
  const half = Math.tan(MathUtils.degToRad(FIELD_OF_VIEW / 2));
  return aspect >= 1 ? FIELD_OF_VIEW : 2 * MathUtils.radToDeg(Math.atan(half / aspect));
}
