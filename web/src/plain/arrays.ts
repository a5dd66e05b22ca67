/** Collects the triangles that three.js' loaders have read, as the arrays that levels are built from. */

import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute, type Mesh, type Object3D } from 'three';
import type { MeshArrays, MeshUpdate } from '../scene/protocol.ts';
import { noTriangles } from './read.ts';

/** A mesh to build, and the geometries that its groups replace. */
export interface Unit {
  arrays: MeshArrays;
  geometries: BufferGeometry[];
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Names of attributes in glTF. */
const NAMES: Record<string, string> = {
  position: 'POSITION', normal: 'NORMAL', tangent: 'TANGENT', uv: 'TEXCOORD_0', uv1: 'TEXCOORD_1', uv2: 'TEXCOORD_2', uv3: 'TEXCOORD_3',
  color: 'COLOR_0', skinWeight: 'WEIGHTS_0', skinIndex: 'JOINTS_0',
};

/** Meshes with triangles below some objects, each object once. */
export function meshesOf(roots: readonly Object3D[]): Mesh[] {
  const found = new Set<Mesh>();
  for (const root of roots) root.traverse((object) => void ((object as Mesh).isMesh && isDrawn((object as Mesh).geometry) && found.add(object as Mesh)));
  return [...found];
}

function isDrawn(geometry: BufferGeometry): boolean {
  const position = geometry.getAttribute('position');
  return position?.itemSize === 3 && (geometry.index ?? position).count >= 3;
}

/**
 * Combines geometries into meshes: those with one key and the same attributes are groups of one mesh, so that no gaps open between
 * them. `isSmooth` asks for smooth normals of geometries without any.
 */
export function unitsOf(meshes: readonly Mesh[], keyOf: (mesh: Mesh) => unknown, isSmooth: boolean): Unit[] {
  const units = new Map<string, BufferGeometry[]>();
  const keys = new Map<unknown, number>();
  const seen = new Set<BufferGeometry>();
  for (const mesh of meshes) {
    const { geometry } = mesh;
    if (seen.has(geometry)) continue;
    seen.add(geometry);
    const key = keyOf(mesh) ?? geometry;
    if (!keys.has(key)) keys.set(key, keys.size);
    const text = `${keys.get(key)} ${signatureOf(geometry)}`;
    units.set(text, [...(units.get(text) ?? []), geometry]);
  }
  return [...units.values()].map((geometries) => ({ geometries, arrays: arraysOf(geometries, isSmooth) }));
}

/** Attributes of a geometry by the names of glTF; those of morph targets have a number in front. */
function attributesOf(geometry: BufferGeometry): Map<string, Attribute> {
  const found = new Map<string, Attribute>();
  const { count } = geometry.getAttribute('position');
  const add = (name: string, attribute: Attribute | undefined) => {
    if (attribute && attribute.count >= count && attribute.itemSize <= 4) found.set(name, attribute);
  };
  const nameOf = (name: string) => NAMES[name] ?? name.toUpperCase();
  for (const [name, attribute] of Object.entries(geometry.attributes)) add(nameOf(name), attribute as Attribute);
  if (!geometry.morphTargetsRelative) return found;
  for (const [name, targets] of Object.entries(geometry.morphAttributes)) {
    (targets as Attribute[]).forEach((target, index) => add(`${index}/${nameOf(name)}`, target));
  }
  return found;
}

function signatureOf(geometry: BufferGeometry): string {
  return [...attributesOf(geometry)].map(([name, { itemSize }]) => `${name}:${itemSize}`).sort().join(' ');
}

function arraysOf(geometries: readonly BufferGeometry[], isSmooth: boolean): MeshArrays {
  // Geometries that share their vertices, as primitives of one glTF mesh may, keep sharing them.
  const firstOf = new Map<unknown, number>();
  const owners: Map<string, Attribute>[] = [];
  let vertexCount = 0;
  const groups = geometries.map((geometry) => {
    const attributes = attributesOf(geometry);
    const key = [...attributes].map(([name, attribute]) => `${name}${idOf(attribute)}`).sort().join(' ');
    const first = firstOf.get(key) ?? vertexCount;
    if (!firstOf.has(key)) {
      firstOf.set(key, first);
      owners.push(attributes);
      vertexCount += geometry.getAttribute('position').count;
    }
    return cornersOf(geometry, first);
  });
  const layers = [...owners[0]!].map(([name, { itemSize }]) => {
    const values = new (name.startsWith('JOINTS') ? Uint16Array : Float32Array)(vertexCount * itemSize);
    let at = 0;
    for (const owner of owners) {
      const { count } = owner.get('POSITION')!;
      copy(owner.get(name)!, count, values, at);
      at += count * itemSize;
    }
    return { name, itemSize, normalized: false, values };
  });
  return { layers, groups, isSmooth: isSmooth && !layers.some(({ name }) => name === 'NORMAL') };
}

export function triangleCountOf({ groups }: MeshArrays): number {
  return groups.reduce((sum, { length }) => sum + length / 3, 0);
}

/** A mesh as it is before it has levels, with smooth normals if it has none and none are flat. */
export function inputOf(arrays: MeshArrays, mesh: number): MeshUpdate {
  const { groups, isSmooth } = arrays;
  const layers = [...arrays.layers];
  const positions = layers.find(({ name }) => name === 'POSITION')!.values as Float32Array;
  const indices = new Uint32Array(3 * triangleCountOf(arrays));
  let at = 0;
  for (const group of groups) {
    indices.set(group, at);
    at += group.length;
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3)).setIndex(new BufferAttribute(indices, 1));
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox!;
  if (isSmooth) {
    geometry.computeVertexNormals();
    layers.push({ name: 'NORMAL', itemSize: 3, normalized: false, values: geometry.getAttribute('normal').array as Float32Array });
  }
  const [vertexCount, triangleCount] = [positions.length / 3, indices.length / 3];
  return {
    mesh, first: 0, layers, indices, groupCounts: Uint32Array.from(groups, ({ length }) => length / 3), numbers: undefined,
    bounds: Float32Array.of(...min.toArray(), ...max.toArray()), vertexCount, fullVertexCount: vertexCount, triangleCount,
    fullTriangleCount: triangleCount, splitCount: 0, stepCount: 0, error: 0, complete: false,
  };
}

const ids = new WeakMap<object, number>();
let lastId = 0;

function idOf(attribute: Attribute): number {
  if (!ids.has(attribute)) ids.set(attribute, ++lastId);
  return ids.get(attribute)!;
}

function cornersOf(geometry: BufferGeometry, first: number): Uint32Array {
  const { index } = geometry;
  const count = (index ?? geometry.getAttribute('position')).count;
  const corners = new Uint32Array(count - (count % 3));
  for (let at = 0; at < corners.length; at++) corners[at] = first + (index ? index.getX(at) : at);
  return corners;
}

function copy(attribute: Attribute, count: number, into: Float32Array | Uint16Array, at: number): void {
  const { itemSize, array } = attribute;
  if (array instanceof Float32Array && !('isInterleavedBufferAttribute' in attribute)) return into.set(array.subarray(0, count * itemSize), at);
  for (let vertex = 0; vertex < count; vertex++) {
    for (let i = 0; i < itemSize; i++) into[at + vertex * itemSize + i] = attribute.getComponent(vertex, i);
  }
}

/** Combines all meshes of a file in the pose that it states: positions, and the other attributes that all of them have. */
export function mergedArrays({ scene }: { scene: Object3D | undefined }): MeshArrays {
  scene?.updateMatrixWorld(true);
  const meshes = scene ? meshesOf([scene]) : [];
  if (meshes.length === 0) throw noTriangles();
  const posed = meshes.map((mesh) => {
    const geometry = mesh.geometry.clone().applyMatrix4(mesh.matrixWorld);
    for (const name of Object.keys(geometry.attributes)) {
      const isCommon = meshes.every(({ geometry: other }) => other.getAttribute(name)?.itemSize === geometry.getAttribute(name).itemSize);
      if (!isCommon || !MERGED.includes(name)) geometry.deleteAttribute(name);
    }
    geometry.morphAttributes = {};
    return geometry;
  });
  return arraysOf(posed, false);
}

/** Attributes that a single mesh draws. */
const MERGED = ['position', 'normal', 'color', 'uv'];
