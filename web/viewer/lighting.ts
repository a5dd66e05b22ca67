/**
 * Light of the stage. Bare scans get lamps that are attached to the camera, so that they are well lit from every side. Scenes with
 * materials of their own get the studio, an environment that stays in place while the camera moves.
 */

import { DirectionalLight, Group, HemisphereLight, MathUtils, type PerspectiveCamera, PMREMGenerator, type Scene, type Texture, type WebGLRenderer } from 'three';
import { studioEnvironment } from '../src/index.ts';

export type LightingName = 'lamps' | 'studio';

export class Lighting {
  readonly #renderer: WebGLRenderer;
  readonly #scene: Scene;
  /** Parent of the lamps that have a direction. */
  readonly #rig = new Group();
  readonly #lamps: (DirectionalLight | HemisphereLight)[];
  /** The environment, made when it is needed first. */
  #studio: Texture | null = null;

  constructor(renderer: WebGLRenderer, scene: Scene, camera: PerspectiveCamera) {
    this.#renderer = renderer;
    this.#scene = scene;
    const key = new DirectionalLight(0xfff4e6, 2.1);
    key.position.set(-0.7, 0.9, 0.9);
    const rim = new DirectionalLight(0xbfd4ff, 0.7);
    rim.position.set(1, -0.2, -0.35);
    const sky = new HemisphereLight(0xf4f0ff, 0x9c8a78, 1.3);
    this.#rig.add(key, key.target, rim, rim.target);
    camera.add(this.#rig);
    scene.add(sky);
    this.#lamps = [key, rim, sky];
  }

  get name(): LightingName {
    return this.#scene.environment ? 'studio' : 'lamps';
  }

  /** Switches between the lamps and the studio. */
  use(name: LightingName): void {
    for (const lamp of this.#lamps) lamp.visible = name === 'lamps';
    this.#scene.environment = name === 'studio' ? this.#environment() : null;
  }

  /** Turns the light around the vertical axis; degrees. */
  turn(degrees: number): void {
    const angle = MathUtils.degToRad(degrees);
    this.#rig.rotation.y = angle;
    this.#scene.environmentRotation.y = angle;
  }

  #environment(): Texture {
    if (this.#studio) return this.#studio;
    const generator = new PMREMGenerator(this.#renderer);
    const light = studioEnvironment();
    this.#studio = generator.fromEquirectangular(light).texture;
    light.dispose();
    generator.dispose();
    return this.#studio;
  }
}
