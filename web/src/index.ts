/** Streaming, continuous level-of-detail meshes for three.js. */

export { StriataError } from './error.ts';
export { StriataLoader, type StriataLoaderConstructor, type StriataLoaderInstance } from './loader.ts';
export { StriataMesh } from './mesh.ts';
export type * from './types.ts';
