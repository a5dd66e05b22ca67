/** Lets three.js' own loader make everything of a scene but its geometry: nodes, materials, textures, skins, cameras, lights, clips. */

import { type AnimationClip, ImageBitmapLoader, type LoadingManager, type Mesh, type Object3D, Texture } from 'three';
import type { GLTF, GLTFLoader, GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import type { SceneDocument, SceneImage } from './protocol.ts';
import type { LodGeometry } from './lod-geometry.ts';

/** The parts of a glTF document that are used here. */
interface Json {
  meshes?: { primitives: Primitive[]; weights?: number[] }[];
  accessors?: unknown[];
  bufferViews?: { byteOffset?: number; byteLength: number; buffer: number }[];
  images?: { uri?: string; bufferView?: number; mimeType?: string; name?: string }[];
  textures?: { source?: number; extensions?: Record<string, { source?: number }> }[];
  animations?: { samplers: { input: number; output: number }[] }[];
}

interface Primitive {
  mode?: number;
  /** Accessors; null for attributes that are in the stream of the mesh. */
  attributes: Record<string, number | null>;
  targets?: Record<string, number | null>[];
}

/** Number of values for each type of accessor. */
const TYPES = ['', 'SCALAR', 'VEC2', 'VEC3', 'VEC4'];
const FLOAT = 5126;
const UNSIGNED_SHORT = 5123;

/** A scene that three.js has made, without geometry of its own. */
export class GltfScene {
  gltf!: GLTF;
  readonly #json: Json;
  #buffer: Uint8Array;
  readonly #streamed = new Set<Primitive>();
  readonly #imageBytes = new Map<number, Uint8Array>();
  /** Primitives whose geometry is replaced: those of each mesh, in their order. */
  readonly #geometryOf: (mesh: number) => LodGeometry | undefined;

  constructor(document: SceneDocument, geometryOf: (mesh: number) => LodGeometry | undefined) {
    this.#json = JSON.parse(document.json) as Json;
    this.#buffer = document.buffer;
    this.#geometryOf = geometryOf;
    this.#prepareImages(document.images);
    this.#json.meshes?.forEach((mesh, index) => this.#prepareMesh(mesh.primitives, geometryOf(index)));
  }

  /** Number of triangle primitives of each mesh, whose geometry is not in the document. */
  static primitiveCounts(json: string): number[] {
    const { meshes = [] } = JSON.parse(json) as Json;
    return meshes.map(({ primitives }) => primitives.filter(isStreamed).length);
  }

  /** Loads the scene with a loader that was made for it. */
  async load(loader: GLTFLoader, path: string): Promise<GLTF> {
    loader.register((parser) => ({
      name: 'striata',
      loadMesh: (index: number) => this.#loadMesh(parser, index),
      loadBufferView: (index: number) => this.#loadBufferView(index),
    }) as never);
    const json = this.#json as unknown as ArrayBuffer;
    this.gltf = await new Promise<GLTF>((resolve, reject) => loader.parse(json, path, resolve, reject));
    this.#buffer = this.#hasAnimations ? new Uint8Array() : this.#buffer;
    return this.gltf;
  }

  /** Makes the clips, once their data has arrived. */
  async animations({ json, buffer }: SceneDocument): Promise<AnimationClip[]> {
    const { animations = [], accessors = [], bufferViews = [] } = JSON.parse(json) as Json;
    const own = this.#json;
    this.#buffer = buffer;
    own.animations = animations;
    // Views that were read before the data arrived are replaced by copies with new numbers.
    const first = (own.bufferViews ??= []).length;
    own.bufferViews.push(...bufferViews.map((view) => ({ ...view })));
    for (const { samplers } of animations) {
      for (const index of samplers.flatMap(({ input, output }) => [input, output])) {
        const accessor = accessors[index] as { bufferView?: number } | undefined;
        if (accessor?.bufferView === undefined) continue;
        (own.accessors ??= [])[index] = { ...accessor, bufferView: accessor.bufferView + first };
      }
    }
    const { parser } = this.gltf;
    return Promise.all(animations.map((_, index) => parser.getDependency('animation', index) as Promise<AnimationClip>));
  }

  get #hasAnimations(): boolean {
    return (this.#json.animations?.length ?? 0) > 0;
  }

  /** The meshes of the scenes with the lods whose geometry they show. */
  *drawn(): Generator<[Mesh, number]> {
    const meshOf = new Map<unknown, number>();
    this.#json.meshes?.forEach((_, index) => this.#geometryOf(index)?.primitives.forEach((geometry) => meshOf.set(geometry, index)));
    for (const scene of this.gltf.scenes) {
      const found: [Mesh, number][] = [];
      scene.traverse((object: Object3D) => {
        const index = meshOf.get((object as Mesh).geometry);
        if (index !== undefined) found.push([object as Mesh, index]);
      });
      yield* found;
    }
  }

  /** Shows an image in place of its preview. */
  async replaceImage({ index, bytes }: SceneImage, manager: LoadingManager): Promise<boolean> {
    const textures = this.#texturesOf(index);
    if (textures.length === 0) return false;
    const type = mimeTypeOf(bytes);
    const url = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>], type ? { type } : {}));
    try {
      const image = await decodeImage(url, textures[0]!.image, manager);
      // Textures of another size need new storage on the GPU; all of them share the image.
      // The class has had several names in three.js.
      const source = new (textures[0]!.source.constructor as new (data: unknown) => Texture['source'])(image);
      for (const texture of textures) {
        texture.dispose();
        texture.source = source;
        texture.needsUpdate = true;
      }
      return true;
    } finally {
      URL.revokeObjectURL(url);
    }
  }

  /** Textures of all materials that show an image. */
  #texturesOf(image: number): Texture[] {
    const definitions = this.#json.textures ?? [];
    const shows = (definition: (typeof definitions)[number] | undefined) => (
      definition?.source === image || Object.values(definition?.extensions ?? {}).some((extension) => extension?.source === image)
    );
    const sources = new Set<unknown>();
    for (const [object, reference] of this.gltf.parser.associations as Map<unknown, { textures?: number }>) {
      if (object instanceof Texture && reference?.textures !== undefined && shows(definitions[reference.textures])) sources.add(object.source);
    }
    const found = new Set<Texture>();
    const visit = (value: unknown) => {
      if (value instanceof Texture && (sources.has(value.source) || value.userData['striataImage'] === image)) {
        value.userData['striataImage'] = image;
        found.add(value);
      }
    };
    for (const object of (this.gltf.parser.associations as Map<unknown, unknown>).keys()) visit(object);
    for (const scene of this.gltf.scenes) {
      scene.traverse((object) => {
        for (const material of [(object as Mesh).material ?? []].flat()) Object.values(material).forEach(visit);
      });
    }
    return [...found];
  }

  #prepareImages(images: SceneImage[]): void {
    const own = this.#json.images ?? [];
    for (const { index, bytes, uri, mimeType } of images) {
      const image = own[index];
      if (!image) continue;
      if (bytes.length === 0) {
        if (uri) image.uri = uri;
        continue;
      }
      image.bufferView = (this.#json.bufferViews ??= []).length;
      image.mimeType = mimeTypeOf(bytes) ?? mimeType;
      this.#json.bufferViews.push({ buffer: 0, byteLength: bytes.length });
      this.#imageBytes.set(image.bufferView, bytes);
    }
  }

  /** Gives primitives accessors of zeros: materials depend on which attributes there are, and nothing is drawn of them. */
  #prepareMesh(primitives: Primitive[], geometry: LodGeometry | undefined): void {
    for (const primitive of primitives) {
      if (!isStreamed(primitive)) continue;
      this.#streamed.add(primitive);
      primitive.mode = 4;
      const fill = (attributes: Record<string, number | null>, target: string) => {
        for (const name of Object.keys(attributes)) {
          const itemSize = geometry?.attribute(target + name)?.itemSize ?? 3;
          attributes[name] = this.#zeros(itemSize, name.startsWith('JOINTS'));
        }
      };
      fill(primitive.attributes, '');
      primitive.targets?.forEach((target, index) => fill(target, `${index}/`));
    }
  }

  #zeros(itemSize: number, isInteger: boolean): number {
    const accessors = (this.#json.accessors ??= []);
    const componentType = isInteger ? UNSIGNED_SHORT : FLOAT;
    return accessors.push({ componentType, count: 3, type: TYPES[itemSize], min: [0, 0, 0], max: [0, 0, 0] }) - 1;
  }

  /** Loads a mesh, and gives it the geometry that grows. */
  async #loadMesh(parser: GLTFParser, index: number): Promise<Object3D | undefined> {
    const object = await (parser as unknown as { loadMesh(index: number): Promise<Object3D> }).loadMesh(index);
    const geometry = this.#geometryOf(index);
    const primitives = this.#json.meshes?.[index]?.primitives ?? [];
    const parts = primitives.length === 1 ? [object] : object.children;
    let at = 0;
    primitives.forEach((primitive, place) => {
      const part = parts[place] as Mesh | undefined;
      if (!this.#streamed.has(primitive) || !part || !geometry) return;
      part.geometry = geometry.primitives[at] ?? part.geometry;
      at += 1;
    });
    return object;
  }

  #loadBufferView(index: number): Promise<ArrayBuffer> | null {
    const image = this.#imageBytes.get(index);
    if (image) return Promise.resolve(image.slice().buffer as ArrayBuffer);
    const { byteOffset = 0, byteLength } = this.#json.bufferViews![index]!;
    return Promise.resolve(this.#buffer.slice(byteOffset, byteOffset + byteLength).buffer as ArrayBuffer);
  }
}

/** Whether the attributes of a primitive are in the stream of its mesh. */
function isStreamed({ attributes }: Primitive): boolean {
  return attributes?.['POSITION'] === null;
}

/** Decodes an image in the same way as the one that it replaces, which three.js' loader decoded. */
async function decodeImage(url: string, before: unknown, manager: LoadingManager): Promise<ImageBitmap | HTMLImageElement> {
  if (typeof ImageBitmap !== 'undefined' && before instanceof ImageBitmap) {
    const loader = new ImageBitmapLoader(manager).setOptions({ premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
    return new Promise((resolve, reject) => loader.load(url, resolve, undefined, reject));
  }
  const image = new Image();
  image.src = url;
  await image.decode();
  return image;
}

/** MIME type of an image according to its first bytes. */
function mimeTypeOf(bytes: Uint8Array): string | undefined {
  const starts = (magic: string, at = 0) => [...magic].every((letter, i) => bytes[at + i] === letter.charCodeAt(0));
  if (starts('\x89PNG')) return 'image/png';
  if (starts('\xff\xd8')) return 'image/jpeg';
  if (starts('RIFF') && starts('WEBP', 8)) return 'image/webp';
  if (starts('ftypavif', 4)) return 'image/avif';
  return starts('\xabKTX 20') ? 'image/ktx2' : undefined;
}
