/**
 * The 3D stage: renderer, camera and render loop.
 *
 * A frame is drawn only if something has changed: code that changes the picture calls `invalidate`. Model coordinates are y-up; for
 * z-up models the pivot is tilted. A picture can be split in two: the second half is drawn after `split.showSecond`.
 */

import {
  BackSide, Color, Group, LinearToneMapping, MathUtils, MeshBasicMaterial, NoToneMapping, type Object3D, PerspectiveCamera, Scene, Sphere, SRGBColorSpace, Vector2, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { StriataScene } from '../src/index.ts';
import { prefersReducedMotion } from './dom.ts';
import { Lighting } from './lighting.ts';

/** Higher pixel ratios are hardly visible but cost fill rate. */
const MAX_PIXEL_RATIO = 2;

/** Field of view of the shorter side, degrees: a model that fits once fits in windows of any shape. */
export const FIELD_OF_VIEW = 35;

/** Window over which frames are counted. */
const FRAME_COUNT_WINDOW_MS = 1000;

/** Layer of objects that are not part of the model, such as the lines of a frozen view. */
export const HELPER_LAYER = 1;

/** Lines of the wireframe are drawn this much closer, as a fraction of the depth range, so that they win against their surface. */
const LINE_DEPTH_OFFSET = 6e-5;

/** A picture whose left and right parts show the scene differently. */
export interface Split {
  /** Where the right part begins, as a fraction of the width. */
  readonly fraction: number;
  /** The model of the right part, if it is another one. */
  readonly other: StriataScene | null;
  /** Calls `draw` while the scene is as the right part shows it. */
  showSecond(draw: () => void): void;
}

export class Stage {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  readonly controls: OrbitControls;
  readonly lighting: Lighting;
  /** Parent of the model; tilted if z is up. */
  readonly pivot = new Group();
  /** Bounding sphere, in world space, that the near and far planes must enclose. */
  readonly content = new Sphere(new Vector3(), 1);
  /** Callbacks run before each frame with the seconds since the last one; returning true requests another frame. */
  readonly beforeFrame = new Set<(seconds: number) => boolean>();
  /** Whether edges are drawn over the surface; hidden edges stay hidden. */
  showsWireframe = false;
  /** Whether back faces are drawn in a color of their own. */
  tintsBacks = false;
  /** Called after each frame with the time that it took, milliseconds. */
  onFrame: (ms: number) => void = () => {};
  split: Split | null = null;

  readonly #lines = new MeshBasicMaterial({ color: 0x17130f, wireframe: true, transparent: true, opacity: 0.28, depthWrite: false, toneMapped: false });
  readonly #backs = new MeshBasicMaterial({ color: 0x3f6fd8, side: BackSide, transparent: true, opacity: 0.75, depthWrite: false, toneMapped: false });
  #frameRequest = 0;
  #lastFrameTime = 0;
  #frameTimes: number[] = [];

  /** Throws if the browser does not support WebGL 2. */
  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.scene.add(this.camera, this.pivot);
    this.camera.layers.enable(HELPER_LAYER);
    this.lighting = new Lighting(this.renderer, this.scene, this.camera);
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

  /** Draws the picture now. */
  render(): void {
    const { renderer, split } = this;
    if (!split) return this.#renderPart();
    const { x: width, y: height } = renderer.getSize(new Vector2());
    const border = Math.round(width * split.fraction);
    renderer.setScissorTest(true);
    renderer.setScissor(0, 0, border, height);
    if (border > 0) this.#renderPart();
    renderer.setScissor(border, 0, width - border, height);
    if (border < width) split.showSecond(() => this.#renderPart());
    renderer.setScissorTest(false);
  }

  /** Brightness of the picture, in stops: 1 doubles the light. */
  setExposure(stops: number): void {
    this.renderer.toneMapping = stops === 0 ? NoToneMapping : LinearToneMapping;
    this.renderer.toneMappingExposure = 2 ** stops;
    this.invalidate();
  }

  /** Renders the stage to a PNG image, `factor` times as large as it is shown, as far as the graphics card allows. */
  async toPng(factor: number): Promise<Blob> {
    const { renderer } = this;
    const canvas = renderer.domElement;
    const gl = renderer.getContext();
    const most = Math.min(...(gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array), gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) as number);
    const ratio = renderer.getPixelRatio();
    const room = most / Math.max(canvas.width, canvas.height, 1);
    const pictured = this.#withoutLevels(() => {
      renderer.setPixelRatio(ratio * Math.min(factor, room));
      this.#fitPlanes();
      this.render();
      // Takes the pixels before anything else is drawn.
      const blob = new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
      renderer.setPixelRatio(ratio);
      this.render();
      return blob;
    });
    const blob = await pictured;
    if (!blob) throw new Error('the browser could not encode the picture');
    return blob;
  }

  /** Draws without choosing levels: a larger picture would need finer ones than those that are shown. */
  #withoutLevels<T>(draw: () => T): T {
    const changed = new Map<Object3D, Object3D['onBeforeRender']>();
    this.pivot.traverse((object) => {
      if (!Object.hasOwn(object, 'onBeforeRender')) return;
      changed.set(object, object.onBeforeRender);
      object.onBeforeRender = () => {};
    });
    try {
      return draw();
    } finally {
      for (const [object, choose] of changed) object.onBeforeRender = choose;
    }
  }

  #frame(now: number): void {
    this.#frameRequest = 0;
    const started = performance.now();
    const seconds = Math.min((now - this.#lastFrameTime) / 1000, 0.1);
    this.#lastFrameTime = now;
    let again = this.controls.autoRotate && !document.hidden;
    for (const step of this.beforeFrame) again = step(seconds) || again;
    this.controls.update(seconds);
    this.#fitPlanes();
    this.render();
    const ended = performance.now();
    this.#frameTimes.push(ended);
    this.onFrame(ended - started);
    if (again) this.invalidate();
  }

  #renderPart(): void {
    this.renderer.render(this.scene, this.camera);
    if (this.tintsBacks) this.#renderOver(this.#backs);
    if (this.showsWireframe) this.#renderOver(this.#lines);
  }

  /** Draws the model again with another material, over its surface. */
  #renderOver(material: MeshBasicMaterial): void {
    const { renderer, scene, camera } = this;
    const { background } = scene;
    const gl = renderer.getContext();
    scene.background = null;
    scene.overrideMaterial = material;
    renderer.autoClear = false;
    camera.layers.disable(HELPER_LAYER);
    gl.depthRange(0, 1 - LINE_DEPTH_OFFSET);
    renderer.render(scene, camera);
    gl.depthRange(0, 1);
    camera.layers.enable(HELPER_LAYER);
    renderer.autoClear = true;
    scene.overrideMaterial = null;
    scene.background = background;
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
}

function verticalAngle(aspect: number): number {
  const half = Math.tan(MathUtils.degToRad(FIELD_OF_VIEW / 2));
  return aspect >= 1 ? FIELD_OF_VIEW : 2 * MathUtils.radToDeg(Math.atan(half / aspect));
}
