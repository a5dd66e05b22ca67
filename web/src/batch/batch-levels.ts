/** Makes a batch of the levels of a model. */

import { Matrix4, type BufferGeometry, type InstancedMesh, type Mesh, type Object3D, type SkinnedMesh } from 'three';
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js';
import { StriataError } from '../error.ts';
import type { StriataLod, StriataSceneLike } from '../types.ts';
import { LevelBatch, type BatchPart } from './level-batch.ts';
import { orderedLevels, type Levels } from './order.ts';
import { batchOf, sphereOf } from './shared-vertices.ts';
import { levelsOfLod, levelsOfMesh } from './streamed.ts';

/** Options of `batchLevels`. */
export interface BatchOptions {
  /** Largest number of instances. */
  maxInstances: number;
  /** The part of the model that an instance shows. Default: all of its scene. */
  object?: Object3D;
}

/**
 * Makes a batch of a scene that a `StriataLoader` has loaded, or of the result of a `GLTFLoader`: a file with the extension `STRIATA_order`
 * (`striata build model.glb -o ordered.glb`), or with streams (`registerStriata`). Waits until all levels have arrived. The batch uses the
 * vertex buffers and materials of the model, which need not be in a scene itself.
 *
 * Each level has half of the triangles of the one before. Meshes without levels are drawn at full detail. Morph targets are not moved.
 * Rejects with a `StriataError` with the code `unsupported` if the model has skins or no meshes.
 */
export async function batchLevels(model: GLTF | StriataSceneLike, { maxInstances, object }: BatchOptions): Promise<LevelBatch> {
  const gltf = 'parser' in model ? model : undefined;
  await ((gltf?.userData['striata'] ?? model) as Partial<StriataSceneLike>).finished;
  const root = object ?? gltf?.scene ?? (model as StriataSceneLike);
  const levelsOf = levelReader(gltf);
  const [parts, made]: [BatchPart[], Map<BufferGeometry, BufferGeometry>] = [[], new Map()];
  root.updateWorldMatrix(true, true);
  const toModel = new Matrix4().copy(root.matrixWorld).invert();
  for (const mesh of meshesOf(root)) {
    const levels = await levelsOf(mesh);
    const batch = batchOf(mesh.geometry, levels, [mesh.material].flat()[0]!, maxInstances);
    // Nodes that show the same geometry share its levels.
    batch.geometry = made.get(mesh.geometry) ?? batch.geometry;
    made.set(mesh.geometry, batch.geometry);
    batch.name = mesh.name;
    [batch.castShadow, batch.receiveShadow] = [mesh.castShadow, mesh.receiveShadow];
    const triangleCounts = levels.lists.map(({ length }) => length / 3);
    parts.push({ batch, errors: levels.errors, triangleCounts, matrix: toModel.clone().multiply(mesh.matrixWorld), sphere: sphereOf(mesh.geometry) });
  }
  return new LevelBatch(parts, maxInstances);
}

/** The meshes that an instance consists of. */
function meshesOf(root: Object3D): Mesh[] {
  const meshes: Mesh[] = [];
  root.traverse((object) => {
    const mesh = object as Mesh;
    if (!mesh.isMesh || !mesh.geometry.hasAttribute('position')) return;
    if ((mesh as Partial<SkinnedMesh>).isSkinnedMesh) throw new StriataError('unsupported', `the mesh ${mesh.name} has a skin, which a batch cannot pose`);
    if ((mesh as Partial<InstancedMesh>).isInstancedMesh) throw new StriataError('unsupported', `the mesh ${mesh.name} has instances of its own`);
    meshes.push(mesh);
  });
  if (meshes.length === 0) throw new StriataError('unsupported', 'the model has no meshes');
  return meshes;
}

/** Returns a function that reads the levels of a mesh, those of each lod once. */
function levelReader(gltf: GLTF | undefined): (mesh: Mesh) => Promise<Levels> {
  const known = new Map<StriataLod, Promise<Levels[]>>();
  return async (mesh) => {
    const { lod } = mesh as Mesh & { lod?: StriataLod };
    if (lod) {
      if (!known.has(lod)) known.set(lod, levelsOfLod(lod));
      return levelsOfMesh(await known.get(lod)!, lod, mesh);
    }
    return (gltf && (await orderedLevels(gltf.parser, mesh))) ?? fullLevel(mesh.geometry);
  };
}

/** The triangles of a geometry as its only level. */
function fullLevel({ index, attributes }: BufferGeometry): Levels {
  return { lists: [index?.array ?? Uint32Array.from({ length: attributes['position']!.count }, (_, vertex) => vertex)], errors: [0] };
}
