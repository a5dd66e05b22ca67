/**
 * Where the model stands: renderer, lights, camera and the loop that draws.
 *
 * Nothing is drawn unless something changed: whoever changes what is seen calls `invalidate`. Lights hang on the camera, so
 * a model is well lit from wherever one looks. Model coordinates are y-up; for z-up ones the pivot is tilted.
 */

import {
  Color, DirectionalLight, Group, HemisphereLight, MathUtils, PerspectiveCamera, Scene, Sphere, SRGBColorSpace, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { prefersStillness } from './page.ts';

/** Eyes do not see more, and fill rate is dear. */
const MOST_PIXEL_RATIO = 2;

/** What the shorter side of the picture spans, degrees: a model that fits once fits at any shape of the window. */
export const ANGLE = 35;

/** Frames are counted over so long. */
const COUNTED_MS = 1000;

export class Stage {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(ANGLE, 1, 0.01, 100);
  readonly controls: OrbitControls;
  /** Holds the model; tilted where z is up. */
  readonly pivot = new Group();
  /** What the near and far planes must hold, in the world. */
  readonly content = new Sphere(new Vector3(), 1);
  /** Called before each frame with the seconds since the last; true asks for another frame. */
  readonly beforeFrame = new Set<(seconds: number) => boolean>();

  #wanted = 0;
  #last = 0;
  #drawn: number[] = [];

  /** Throws where the browser gives no WebGL 2. */
  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.scene.add(this.camera, this.pivot);
    this.#light();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !prefersStillness();
    this.controls.dampingFactor = 0.12;
    this.controls.autoRotateSpeed = 1.6;
    this.controls.addEventListener('change', () => this.invalidate());
    this.controls.addEventListener('start', () => this.invalidate());
    new ResizeObserver(() => this.#resize()).observe(canvas);
    document.addEventListener('visibilitychange', () => this.invalidate());
  }

  /** Asks for a frame. */
  invalidate(): void {
    if (this.#wanted === 0) this.#wanted = requestAnimationFrame((now) => this.#frame(now));
  }

  /** Frames drawn in the last second; 0 at rest. */
  get framesPerSecond(): number {
    const since = performance.now() - COUNTED_MS;
    this.#drawn = this.#drawn.filter((time) => time > since);
    return this.#drawn.length > 2 ? this.#drawn.length : 0;
  }

  setBackground(color: string): void {
    this.scene.background = new Color(color);
    this.invalidate();
  }

  /** The picture as PNG. */
  async picture(): Promise<Blob> {
    this.#fitPlanes();
    this.renderer.render(this.scene, this.camera);
    const blob = await new Promise<Blob | null>((resolve) => this.renderer.domElement.toBlob(resolve, 'image/png'));
    if (!blob) throw new Error('the browser gave no picture');
    return blob;
  }

  #frame(now: number): void {
    this.#wanted = 0;
    const seconds = Math.min((now - this.#last) / 1000, 0.1);
    this.#last = now;
    let again = this.controls.autoRotate && !document.hidden;
    for (const step of this.beforeFrame) again = step(seconds) || again;
    this.controls.update(seconds);
    this.#fitPlanes();
    this.renderer.render(this.scene, this.camera);
    this.#drawn.push(performance.now());
    if (again) this.invalidate();
  }

  /** Near and far close around what is there, so that depth has all its bits. */
  #fitPlanes(): void {
    const { center, radius } = this.content;
    const away = this.camera.position.distanceTo(center);
    this.camera.far = away + 1.05 * radius;
    this.camera.near = Math.max(away - 1.05 * radius, this.camera.far * 5e-4);
    this.camera.updateProjectionMatrix();
  }

  #resize(): void {
    const { clientWidth, clientHeight } = this.renderer.domElement;
    const [width, height] = [Math.max(clientWidth, 1), Math.max(clientHeight, 1)];
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, MOST_PIXEL_RATIO));
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
  const half = Math.tan(MathUtils.degToRad(ANGLE / 2));
  return aspect >= 1 ? ANGLE : 2 * MathUtils.radToDeg(Math.atan(half / aspect));
}
