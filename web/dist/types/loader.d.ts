/** Loads models: bytes to the engine as they come, a mesh as soon as there is something to draw. */
import { StriataMesh } from './mesh.ts';
import type { Loader, LoaderOptions, LoadOptions, Source } from './types.ts';
/** Makes loaders: `await StriataLoader().load(url)`; with `new` it is the same. */
export interface StriataLoaderConstructor {
    (options?: LoaderOptions): StriataLoaderInstance;
    new (options?: LoaderOptions): StriataLoaderInstance;
}
/** A loader whose meshes are known to be `StriataMesh`. */
export interface StriataLoaderInstance extends Loader {
    load(source: Source, options?: LoadOptions): Promise<StriataMesh>;
}
export declare const StriataLoader: StriataLoaderConstructor;
