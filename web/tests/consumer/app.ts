// A project that uses the package: its types are checked, it is never run.

import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import {
  batchLevels, LevelBatch, registerStriata, StriataError, StriataLoader, studioEnvironment, type LoaderOptions, type StriataLod, type StriataMesh, type StriataScene,
} from 'striata';

const manager = new THREE.LoadingManager();
const options: LoaderOptions = { worker: false, pixelError: 2, configure: (loader) => loader.setCrossOrigin('anonymous') };

// Everything that three.js' loaders have.
const loader: THREE.Loader<StriataScene> = new StriataLoader(manager, options);
loader.setPath('/models/').setResourcePath('/textures/').setCrossOrigin('use-credentials').setWithCredentials(true).setRequestHeader({ a: 'b' });

/** A hook like that of react-three-fiber. */
declare function useLoader<T>(Proto: new (manager?: THREE.LoadingManager) => THREE.Loader<T>, url: string): T;
const hooked: StriataScene = useLoader(StriataLoader, 'helmet.stri');

export async function show(scene: THREE.Scene, file: File): Promise<void> {
  scene.environment = studioEnvironment();
  const own = new StriataLoader();
  own.pixelError = null;
  const model: StriataScene = await own.loadAsync('helmet.stri', (event) => console.log(event.loaded, event.total));
  own.load('helmet.stri', (loaded) => scene.add(loaded), undefined, (error) => console.error(error));
  const opened = await own.open(file, { signal: new AbortController().signal, onProgress: ({ bytesReceived }) => console.log(bytesReceived) });
  scene.add(model, opened, hooked);
  model.pixelError = 1;
  model.triangleBudget = 100_000;
  model.addEventListener('change', () => console.log(model.triangleCount, model.error, model.complete));
  model.addEventListener('error', ({ error }) => console.error(error.code, error.hint));
  const mixer = new THREE.AnimationMixer(model);
  for (const clip of model.animations) mixer.clipAction(clip).play();
  for (const lod of model.lods) await batch(lod);
  model.traverse((object) => {
    if (object instanceof THREE.Mesh && 'lod' in object) (object.lod as StriataLod).detail = 0.3;
  });
  await model.finished.catch((error: unknown) => {
    if (error instanceof StriataError) console.log(error.code);
  });
  model.dispose();
}

async function batch(lod: StriataLod): Promise<void> {
  lod.triangles = 1000;
  lod.error = null;
  const [indices]: (Uint32Array | undefined)[] = await lod.indices({ triangles: 500 });
  const [mesh]: readonly (THREE.Mesh | undefined)[] = lod.meshes;
  if (!indices || !mesh) return;
  const geometry = new THREE.BufferGeometry();
  geometry.attributes = mesh.geometry.attributes;
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  lod.attach(mesh.clone());
}

export async function crowd(scene: THREE.Scene, camera: THREE.Camera, model: StriataScene): Promise<number> {
  const batch: LevelBatch = await batchLevels(model, { maxInstances: 100 });
  const trees = await batchLevels(await new GLTFLoader().loadAsync('ordered.glb'), { maxInstances: 5, object: new THREE.Group() });
  scene.add(batch, trees);
  const instance: number = batch.addInstance(new THREE.Matrix4());
  batch.setMatrixAt(instance, new THREE.Matrix4()).setColorAt(instance, new THREE.Color()).setVisibleAt(instance, true);
  for (const mesh of batch.meshes) mesh.sortObjects = false;
  return batch.update(camera, 600, 2) + batch.levelAt(instance) + batch.triangleCount;
}

export const plugin: GLTFLoader = registerStriata(new GLTFLoader(), { worker: true });

// Calls of the first version.
export const old: Promise<StriataMesh> = StriataLoader().load(new URL('bunny.stri', location.href), { name: 'bunny' });

// @ts-expect-error A level is a number.
hooked.detail = 'high';
