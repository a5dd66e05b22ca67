/** Streaming, continuous level-of-detail meshes and scenes for three.js. */

export { StriataError } from './error.ts';
export { StriataLoader, type StriataLoaderConstructor, type StriataLoaderInstance } from './loader.ts';
export { StriataMesh } from './mesh.ts';
export { registerStriata } from './register.ts';
export { StriataScene } from './scene/scene.ts';
export { studioEnvironment } from './studio.ts';
export { batchLevels, type BatchOptions } from './batch/batch-levels.ts';
export { LevelBatch } from './batch/level-batch.ts';
export type * from './types.ts';
