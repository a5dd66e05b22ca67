/** Many instances of a model, each at the level of detail that its size on the screen needs. */

import { Group, Matrix4, Vector3, type BatchedMesh, type Camera, type Color, type PerspectiveCamera, type Sphere } from 'three';

/** One mesh of the model. */
export interface BatchPart {
  /** A batch whose geometry `i` is level `i`. */
  batch: BatchedMesh;
  /** Errors of the levels in units of the mesh; the first level is the full one. */
  errors: readonly number[];
  /** Triangles of the levels. */
  triangleCounts: readonly number[];
  /** From the mesh to the model. */
  matrix: Matrix4;
  /** Bounds in units of the mesh. */
  sphere: Sphere;
}

/** Numbers of each instance of a part: center, radius, and units of the group per unit of the mesh. */
const STRIDE = 5;
/** Level of instances that have been deleted. */
const NO_LEVEL = 255;

const [matrix, inverse, center, scale] = [new Matrix4(), new Matrix4(), new Vector3(), new Vector3()];

/**
 * Instances of a model with levels of detail, one `BatchedMesh` for each of its meshes. `batchLevels` creates it. An instance shows its
 * coarsest level until the first `update`.
 */
export class LevelBatch extends Group {
  readonly isLevelBatch = true;
  /** The meshes that are drawn: for materials, shadows, `sortObjects` and the like. Change instances by the methods of the batch. */
  readonly meshes: readonly BatchedMesh[];
  readonly maxInstances: number;
  readonly #parts: readonly BatchPart[];
  /** Of each part, the level of each instance. */
  readonly #levels: readonly Uint8Array[];
  /** Of each part, where its instances are. */
  readonly #places: readonly Float64Array[];
  /** Number of instances that there have been at the same time. */
  #end = 0;

  constructor(parts: readonly BatchPart[], maxInstances: number) {
    super();
    this.maxInstances = maxInstances;
    this.#parts = parts;
    this.meshes = parts.map(({ batch }) => batch);
    this.#levels = parts.map(() => new Uint8Array(maxInstances).fill(NO_LEVEL));
    this.#places = parts.map(() => new Float64Array(STRIDE * maxInstances));
    // Instances are culled one by one; bounds of all of them would have to follow their motion.
    for (const mesh of this.meshes) mesh.frustumCulled = false;
    if (parts.length > 0) this.add(...this.meshes);
  }

  /** Number of instances. */
  get instanceCount(): number {
    return this.meshes[0]?.instanceCount ?? 0;
  }

  /** Number of triangles of all instances at their levels, inside and outside of the view. */
  get triangleCount(): number {
    let sum = 0;
    this.#parts.forEach(({ triangleCounts }, part) => {
      const levels = this.#levels[part]!;
      for (let instance = 0; instance < this.#end; instance++) sum += triangleCounts[levels[instance]!] ?? 0;
    });
    return sum;
  }

  /** Adds an instance; returns its number. Numbers of deleted instances are used again. */
  addInstance(at: Matrix4): number {
    let instance = 0;
    this.#parts.forEach(({ batch, errors }, part) => {
      instance = batch.addInstance(errors.length - 1);
      this.#levels[part]![instance] = errors.length - 1;
    });
    this.#end = Math.max(this.#end, instance + 1);
    this.setMatrixAt(instance, at);
    return instance;
  }

  deleteInstance(instance: number): this {
    this.#parts.forEach(({ batch }, part) => {
      batch.deleteInstance(instance);
      this.#levels[part]![instance] = NO_LEVEL;
    });
    return this;
  }

  /** Places an instance in the group. */
  setMatrixAt(instance: number, at: Matrix4): this {
    this.#parts.forEach(({ batch, matrix: own, sphere }, part) => {
      batch.setMatrixAt(instance, matrix.multiplyMatrices(at, own));
      const largest = matrix.getMaxScaleOnAxis();
      center.copy(sphere.center).applyMatrix4(matrix).toArray(this.#places[part]!, STRIDE * instance);
      this.#places[part]![STRIDE * instance + 3] = sphere.radius * largest;
      this.#places[part]![STRIDE * instance + 4] = largest;
    });
    return this;
  }

  setColorAt(instance: number, color: Color): this {
    for (const mesh of this.meshes) mesh.setColorAt(instance, color);
    return this;
  }

  setVisibleAt(instance: number, visible: boolean): this {
    for (const mesh of this.meshes) mesh.setVisibleAt(instance, visible);
    return this;
  }

  /** Level of an instance, 0 being the full one; `part` is the place of a mesh in `meshes`. */
  levelAt(instance: number, part = 0): number {
    return this.meshes[part]!.getGeometryIdAt(instance);
  }

  /**
   * Gives each instance the coarsest level whose error covers at most `pixels` pixels for a camera; `height` is that of the viewport
   * (`renderer.domElement.height`). Instances whose level stays are not touched. Returns the number of levels that have changed.
   */
  update(camera: Camera, height: number, pixels = 1): number {
    this.updateWorldMatrix(true, false);
    camera.updateWorldMatrix(true, false);
    const view = viewOf(this, camera, height);
    let changed = 0;
    this.#parts.forEach(({ batch, errors }, part) => {
      const [levels, places] = [this.#levels[part]!, this.#places[part]!];
      for (let instance = 0; instance < this.#end; instance++) {
        const before = levels[instance]!;
        if (before === NO_LEVEL) continue;
        const tolerance = pixels / pixelsPerUnit(view, places, STRIDE * instance);
        let level = errors.length - 1;
        while (level > 0 && errors[level]! > tolerance) level--;
        if (level === before) continue;
        levels[instance] = level;
        batch.setGeometryIdAt(instance, level);
        changed++;
      }
    });
    return changed;
  }

  /** Frees the buffers on the GPU; materials, which are those of the model, stay. */
  override dispose(): void {
    for (const mesh of this.meshes) mesh.dispose();
  }
}

/** A camera in the space of a group. */
interface GroupView {
  isPerspective: boolean;
  x: number;
  y: number;
  z: number;
  near: number;
  /** Pixels that a unit of the group covers, at a distance of 1 if the camera is in perspective. */
  pixels: number;
}

function viewOf(group: Group, camera: Camera, height: number): GroupView {
  scale.setFromMatrixScale(group.matrixWorld);
  const [least, largest] = [Math.min(scale.x, scale.y, scale.z), Math.max(scale.x, scale.y, scale.z)];
  const { x, y, z } = center.setFromMatrixPosition(camera.matrixWorld).applyMatrix4(inverse.copy(group.matrixWorld).invert());
  const { isPerspectiveCamera, near } = camera as PerspectiveCamera;
  const pixels = (Math.abs(camera.projectionMatrix.elements[5]!) * height) / 2;
  // If the group is stretched along one axis, errors grow by at most the largest factor, and distances by at least the smallest.
  return isPerspectiveCamera
    ? { isPerspective: true, x, y, z, near: near / largest, pixels: pixels * (largest / least) }
    : { isPerspective: false, x, y, z, near: 0, pixels: pixels * largest };
}

/** Pixels that a unit of a mesh covers where its bounds are nearest to the camera. */
function pixelsPerUnit({ isPerspective, x, y, z, near, pixels }: GroupView, places: Float64Array, at: number): number {
  const size = pixels * places[at + 4]!;
  if (!isPerspective) return size;
  const [dx, dy, dz] = [places[at]! - x, places[at + 1]! - y, places[at + 2]! - z];
  return size / Math.max(Math.sqrt(dx * dx + dy * dy + dz * dz) - places[at + 3]!, near);
}
