/**
 * The vertices and levels of one glTF mesh: a geometry for each primitive, all of which share their attributes and one index buffer.
 *
 * Buffers are larger than their contents, so that most updates change them in part. Unused vertices repeat the first one, which keeps
 * bounds correct that three.js computes from whole attributes.
 */

import { Box3, BufferAttribute, BufferGeometry, Matrix4, Sphere, Vector3, type TypedArray } from 'three';
import type { MeshUpdate, NewLayer } from './protocol.ts';

/** Initial capacity in vertices or triangles. */
const MIN_CAPACITY = 256;

/** Names of glTF attributes in three.js; others are converted to lower case. */
const ATTRIBUTES: Record<string, string> = {
  POSITION: 'position', NORMAL: 'normal', TANGENT: 'tangent', TEXCOORD_0: 'uv', TEXCOORD_1: 'uv1', TEXCOORD_2: 'uv2', TEXCOORD_3: 'uv3',
  COLOR_0: 'color', WEIGHTS_0: 'skinWeight', JOINTS_0: 'skinIndex',
};

/** Attributes that three.js can displace by morph targets. */
const MORPHED = ['position', 'normal', 'color'];

export function attributeName(gltfName: string): string {
  return ATTRIBUTES[gltfName] ?? gltfName.toLowerCase();
}

/** A geometry whose bounds are those of the whole glTF mesh. */
export class PrimitiveGeometry extends BufferGeometry {
  readonly #lod: LodGeometry;

  constructor(lod: LodGeometry) {
    super();
    this.#lod = lod;
    this.morphTargetsRelative = true;
  }

  override computeBoundingBox(): void {
    this.boundingBox = this.#lod.box.clone();
  }

  override computeBoundingSphere(): void {
    this.boundingSphere = this.#lod.box.getBoundingSphere(new Sphere());
  }

  /** Returns a plain geometry with copies of the buffers. */
  override clone(): this {
    return new BufferGeometry().copy(this) as this;
  }
}

/** Geometries of the primitives of one glTF mesh. */
export class LodGeometry {
  readonly primitives: PrimitiveGeometry[];
  /** Bounds, with the displacements of morph targets. */
  readonly box = new Box3();
  /** Bounds of the vertices that each joint moves, in bind space; empty without a skin. */
  readonly jointBoxes: Box3[] = [];
  readonly #attributes = new Map<string, BufferAttribute>();
  readonly #largestDisplacement = new Vector3();
  #vertexCapacity = 0;
  #index = new BufferAttribute(new Uint32Array(3 * MIN_CAPACITY), 1);

  constructor(primitiveCount: number) {
    this.primitives = Array.from({ length: primitiveCount }, () => new PrimitiveGeometry(this));
    for (const primitive of this.primitives) primitive.setIndex(this.#index);
  }

  /** Names of the attributes as glTF names them. */
  get layerNames(): string[] {
    return [...this.#attributes.keys()];
  }

  attribute(gltfName: string): BufferAttribute | undefined {
    return this.#attributes.get(gltfName);
  }

  /** Applies an update. */
  apply(update: MeshUpdate): void {
    const { first, layers, vertexCount, fullVertexCount } = update;
    if (layers.length > 0) {
      const hasGrown = this.#reserve(vertexCount, fullVertexCount);
      for (const layer of layers) this.#write(layer, first, hasGrown);
      this.#bound(update);
      if (hasGrown) this.#assign();
      // The textures of morph targets are made once for each geometry; disposing of it makes them again.
      else if (layers.some(({ name }) => name.includes('/'))) this.#release();
      this.#growJointBoxes(first, vertexCount);
    }
    if (update.indices) this.#writeIndices(update.indices, update.groupCounts, 3 * update.fullTriangleCount);
  }

  dispose(): void {
    this.#release();
  }

  /** Frees the buffers on the GPU. */
  #release(): void {
    for (const primitive of this.primitives) primitive.dispose();
  }

  /** Makes room for vertices; returns whether the buffers must be replaced. */
  #reserve(count: number, full: number): boolean {
    if (count <= this.#vertexCapacity) return false;
    this.#release();
    this.#vertexCapacity = grownCapacity(this.#vertexCapacity, count, full);
    return true;
  }

  #write({ name, itemSize, normalized, values }: NewLayer, first: number, hasGrown: boolean): void {
    if (name === 'WEIGHTS_0' && values instanceof Float32Array) normalizeWeights(values, itemSize);
    let attribute = this.#attributes.get(name);
    if (!attribute || hasGrown) {
      const array = new (values.constructor as Float32ArrayConstructor)(this.#vertexCapacity * itemSize) as TypedArray;
      if (attribute) array.set((attribute.array as TypedArray).subarray(0, first * itemSize));
      attribute = new BufferAttribute(array, itemSize, normalized);
      this.#attributes.set(name, attribute);
    } else {
      attribute.addUpdateRange(first * itemSize, values.length);
    }
    const array = attribute.array as TypedArray;
    array.set(values, first * itemSize);
    if (hasGrown) for (let at = first * itemSize + values.length; at < array.length; at++) array[at] = array[at % itemSize]!;
    attribute.needsUpdate = true;
  }

  /** Gives the attributes to all primitives. */
  #assign(): void {
    const morphs = new Map<string, (BufferAttribute | undefined)[]>();
    let targetCount = 0;
    for (const [name, attribute] of this.#attributes) {
      const [target, morphed] = name.split('/');
      if (morphed === undefined) {
        for (const primitive of this.primitives) primitive.setAttribute(attributeName(name), attribute);
        continue;
      }
      const key = attributeName(morphed);
      if (!MORPHED.includes(key)) continue;
      const list = morphs.get(key) ?? [];
      list[Number(target)] = attribute;
      morphs.set(key, list);
      targetCount = Math.max(targetCount, list.length);
    }
    for (const [key, list] of morphs) {
      const itemSize = list.find(Boolean)?.itemSize ?? 3;
      const dense = Array.from({ length: targetCount }, (_, target) => (
        list[target] ?? new BufferAttribute(new Float32Array(this.#vertexCapacity * itemSize), itemSize)
      ));
      for (const primitive of this.primitives) primitive.morphAttributes[key as 'position'] = dense;
    }
  }

  #bound({ bounds, layers }: MeshUpdate): void {
    const most = this.#largestDisplacement;
    for (const { name, values } of layers) {
      if (!name.endsWith('/POSITION')) continue;
      for (let at = 0; at + 2 < values.length; at += 3) {
        most.set(
          Math.max(most.x, Math.abs(values[at]!)), Math.max(most.y, Math.abs(values[at + 1]!)), Math.max(most.z, Math.abs(values[at + 2]!)),
        );
      }
    }
    this.box.min.fromArray(bounds, 0).sub(most);
    this.box.max.fromArray(bounds, 3).add(most);
    for (const primitive of this.primitives) {
      primitive.computeBoundingBox();
      primitive.computeBoundingSphere();
    }
  }

  #growJointBoxes(first: number, vertexCount: number): void {
    const [joints, weights, positions] = ['JOINTS_0', 'WEIGHTS_0', 'POSITION'].map((name) => this.#attributes.get(name));
    if (!joints || !weights || !positions) return;
    const point = new Vector3();
    for (let vertex = first; vertex < vertexCount; vertex++) {
      point.fromBufferAttribute(positions, vertex);
      for (let i = 0; i < Math.min(joints.itemSize, weights.itemSize); i++) {
        if (weights.getComponent(vertex, i) <= 0) continue;
        const joint = joints.getComponent(vertex, i);
        (this.jointBoxes[joint] ??= new Box3()).expandByPoint(point);
      }
    }
  }

  #writeIndices(indices: Uint32Array, groupCounts: Uint32Array, full: number): void {
    if (this.#index.count < indices.length) {
      this.#release();
      this.#index = new BufferAttribute(new Uint32Array(grownCapacity(this.#index.count, indices.length, full)), 1);
      for (const primitive of this.primitives) primitive.setIndex(this.#index);
    } else {
      this.#index.addUpdateRange(0, indices.length);
    }
    this.#index.array.set(indices);
    this.#index.needsUpdate = true;
    let start = 0;
    this.primitives.forEach((primitive, group) => {
      const count = 3 * (groupCounts[group] ?? 0);
      primitive.setDrawRange(start, count);
      start += count;
    });
  }
}

const [corner, matrix] = [new Vector3(), new Matrix4()];

/** Bounds of a skinned mesh in its current pose, in its own space: around the corners of the boxes that its joints move. */
export function posedBox(lod: LodGeometry, bind: Matrix4, bindInverse: Matrix4, bones: readonly { matrixWorld: Matrix4 }[], inverses: readonly Matrix4[]): Box3 {
  const box = new Box3();
  lod.jointBoxes.forEach((own, joint) => {
    const [bone, inverse] = [bones[joint], inverses[joint]];
    if (!own || own.isEmpty() || !bone || !inverse) return;
    matrix.copy(bindInverse).multiply(bone.matrixWorld).multiply(inverse).multiply(bind);
    // Morph targets move vertices before the skin does.
    const [min, max] = [own.min, own.max];
    for (let at = 0; at < 8; at++) {
      corner.set(at & 1 ? max.x : min.x, at & 2 ? max.y : min.y, at & 4 ? max.z : min.z);
      box.expandByPoint(corner.applyMatrix4(matrix));
    }
  });
  return box.isEmpty() ? lod.box.clone() : box;
}

/** Divides the weights of each vertex, which were rounded one by one, by their sum. */
function normalizeWeights(weights: Float32Array, itemSize: number): void {
  for (let at = 0; at < weights.length; at += itemSize) {
    let sum = 0;
    for (let i = 0; i < itemSize; i++) sum += weights[at + i]!;
    if (sum > 0) for (let i = 0; i < itemSize; i++) weights[at + i]! /= sum;
    else weights[at] = 1;
  }
}

/** Twice the previous capacity, but no more than the full mesh needs. */
function grownCapacity(before: number, needed: number, full: number): number {
  const doubled = Math.max(MIN_CAPACITY, 2 * before, needed);
  return full >= needed ? Math.min(doubled, full) : doubled;
}
