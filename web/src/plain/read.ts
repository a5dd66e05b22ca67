/** Reads plain files of meshes with the loaders of three.js, which are fetched when they are needed. */

import {
  BufferGeometry, DoubleSide, Group, type Material, Mesh, MeshStandardMaterial, type MeshPhongMaterial, type LoadingManager, LoaderUtils, type Object3D,
} from 'three';
import type { GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { StriataError } from '../error.ts';
import { isGlb } from '../magic.ts';
import type { SceneContents } from '../scene/scene.ts';
import { isOff, parseOff } from './off.ts';

/** A file that has been read. */
export interface ReadFile extends SceneContents {
  gltf?: GLTF;
  /** Size of the files that it refers to, as far as the browser says. */
  companionBytes?: number;
}

/** How a file is read. */
export interface ReadOptions {
  manager: LoadingManager;
  /** Where relative URLs begin; empty if there are no files beside this one. */
  path: string;
  /** Prepares the loader of glTF files. */
  configure: (loader: GLTFLoader) => void;
}

/** Hint for files in other formats. */
const FORMATS = 'supported: .stri, .striata, .ply, .obj, .stl, .off, .gltf and .glb, optionally .gz or .zst';

/** Number of bytes that are looked at to recognize a text. */
const TEXT_BYTES = 4096;

/** Reads a whole file; its name tells the format if its contents do not. */
export async function readPlain(bytes: Uint8Array, name: string, options: ReadOptions): Promise<ReadFile> {
  const format = formatOf(bytes, name);
  try {
    if (format === 'gltf') return await readGltf(bytes, options);
    if (format === 'obj') return ofObject(await readObj(textOf(bytes), options));
    if (format) return ofObject(single(await readGeometry(format, bytes)));
  } catch (thrown) {
    if (thrown instanceof StriataError) throw new StriataError(thrown.code, `${name}: ${thrown.message}`, thrown.hint);
    throw new StriataError('corrupt', `${name}: ${thrown instanceof Error ? thrown.message : String(thrown)}`);
  }
  throw new StriataError('format', `${name}: the format is not known`, FORMATS);
}

type Format = 'gltf' | 'ply' | 'obj' | 'stl' | 'off';

function formatOf(bytes: Uint8Array, name: string): Format | undefined {
  if (isGlb(bytes)) return 'gltf';
  const head = textOf(bytes.subarray(0, TEXT_BYTES));
  if (/^ply\r?\n/.test(head)) return 'ply';
  if (isOff(head)) return 'off';
  if (/^\s*\{/.test(head) && /\.gltf$/i.test(name)) return 'gltf';
  const isBinaryStl = bytes.length >= 84 && 84 + 50 * new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true) === bytes.length;
  if (isBinaryStl || /^\s*solid\b[^]*\bfacet\b/.test(head)) return 'stl';
  if (/^(?:v|vn|vt|f|o|g|mtllib|usemtl) +\S/m.test(head) && !head.includes('\0')) return 'obj';
  // A damaged file is better reported as such than as unknown.
  const extension = /\.(gltf|ply|obj|stl|off)$/i.exec(name)?.[1]?.toLowerCase();
  if (extension === 'stl' && bytes.length >= 84) return 'stl';
  return undefined;
}

function textOf(bytes: Uint8Array): string {
  return new TextDecoder().decode(bytes);
}

async function readGltf(bytes: Uint8Array, { manager, path, configure }: ReadOptions): Promise<ReadFile> {
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const loader = new GLTFLoader(manager);
  configure(loader);
  if (!loader.meshoptDecoder) {
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js');
    loader.setMeshoptDecoder(MeshoptDecoder);
  }
  const gltf = await loader.parseAsync(bytes.slice().buffer as ArrayBuffer, path);
  const { scene, scenes, cameras, animations } = gltf;
  return { gltf, scene, scenes, cameras, animations, companionBytes: companionBytes(gltf, path, manager) };
}

/** Size of the buffers and images that a document refers to. */
function companionBytes({ parser }: GLTF, path: string, manager: LoadingManager): number {
  const { buffers = [], images = [] } = parser.json as Record<'buffers' | 'images', { uri?: string }[] | undefined>;
  const uris = new Set([...buffers, ...images].flatMap(({ uri }) => (uri && !uri.startsWith('data:') ? [uri] : [])));
  let sum = 0;
  for (const uri of uris) {
    const url = manager.resolveURL(LoaderUtils.resolveURL(uri, path));
    const base = typeof document === 'undefined' ? undefined : document.baseURI;
    if (!URL.canParse(url, base)) continue;
    const entry = performance.getEntriesByName(new URL(url, base).href).at(-1) as PerformanceResourceTiming | undefined;
    sum += entry?.decodedBodySize ?? 0;
  }
  return sum;
}

async function readGeometry(format: 'ply' | 'stl' | 'off', bytes: Uint8Array): Promise<BufferGeometry> {
  if (format === 'off') return parseOff(textOf(bytes));
  const buffer = bytes.slice().buffer as ArrayBuffer;
  if (format === 'ply') {
    const { PLYLoader } = await import('three/addons/loaders/PLYLoader.js');
    const geometry = new PLYLoader().parse(buffer);
    if (!geometry.index) throw noTriangles();
    return geometry;
  }
  const { STLLoader } = await import('three/addons/loaders/STLLoader.js');
  const geometry = new STLLoader().parse(buffer);
  // Its normals are those of the triangles; smooth ones are computed instead.
  geometry.deleteAttribute('normal');
  geometry.clearGroups();
  return geometry;
}

/** The error of files that contain nothing to simplify. */
export function noTriangles(): StriataError {
  return new StriataError('unsupported', 'the file has no triangles', 'point clouds and curves cannot be simplified');
}

async function readObj(text: string, { manager, path }: ReadOptions): Promise<Object3D> {
  const { OBJLoader } = await import('three/addons/loaders/OBJLoader.js');
  const loader = new OBJLoader(manager);
  const library = /^mtllib +(.+?)\s*$/m.exec(text)?.[1];
  if (library && path) {
    const { MTLLoader } = await import('three/addons/loaders/MTLLoader.js');
    try {
      loader.setMaterials(await new MTLLoader(manager).setPath(path).setResourcePath(path).loadAsync(library));
    } catch (thrown) {
      console.warn(`striata: the materials ${library} cannot be read`, thrown);
    }
  }
  const object = loader.parse(text);
  // The loader gives every triangle its own normal if the file has none; smooth ones are computed instead.
  if (!/^vn\s/m.test(text)) object.traverse((child) => void (child as Mesh).geometry?.deleteAttribute('normal'));
  const converted = new Map<Material, Material>();
  const convert = (material: Material) => {
    if (!converted.has(material)) converted.set(material, standardOf(material as MeshPhongMaterial));
    return converted.get(material)!;
  };
  for (const mesh of [...object.children].filter((child): child is Mesh => (child as Mesh).isMesh)) {
    mesh.material = Array.isArray(mesh.material) ? mesh.material.map(convert) : convert(mesh.material);
    splitGroups(mesh);
  }
  return object;
}

/** Replaces a mesh with several materials by one mesh for each of them. */
function splitGroups(mesh: Mesh): void {
  if (!Array.isArray(mesh.material)) return;
  const { geometry, material, parent } = mesh;
  mesh.removeFromParent();
  for (const { start, count, materialIndex = 0 } of geometry.groups) {
    const own = new BufferGeometry();
    // The parts share their vertices.
    for (const [name, attribute] of Object.entries(geometry.attributes)) own.setAttribute(name, attribute);
    own.setIndex(Array.from({ length: count }, (_, at) => start + at));
    const part = new Mesh(own, material[materialIndex] ?? material[0]!);
    part.name = mesh.name;
    part.userData['striataMesh'] = geometry;
    parent?.add(part);
  }
}

/** The physical material that is most like one of Phong's, which environments do not light. */
function standardOf(phong: MeshPhongMaterial): MeshStandardMaterial {
  const { name, color, map, normalMap, bumpMap, emissive, emissiveMap, alphaMap, opacity, transparent, vertexColors, shininess } = phong;
  const roughness = Math.sqrt(2 / ((shininess ?? 30) + 2));
  return new MeshStandardMaterial({
    name, color, map, normalMap, bumpMap, emissive, emissiveMap, alphaMap, opacity, transparent, vertexColors, roughness: Math.max(0.3, roughness),
    metalness: 0, side: DoubleSide,
  });
}

function single(geometry: BufferGeometry): Mesh {
  const vertexColors = geometry.hasAttribute('color');
  return new Mesh(geometry, new MeshStandardMaterial({ vertexColors, side: DoubleSide, roughness: 0.8, metalness: 0 }));
}

function ofObject(object: Object3D): ReadFile {
  const scene = new Group().add(object);
  return { scene, scenes: [scene], cameras: [], animations: [] };
}
