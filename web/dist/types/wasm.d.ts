/** Finding, compiling and starting the wasm. */
import type { LoaderOptions } from './types.ts';
type WasmSource = NonNullable<LoaderOptions['wasm']>;
/** The compiled module, from where the options say, from the page itself, or from beside this script. */
export declare function wasmModule(source: WasmSource | undefined): Promise<WebAssembly.Module>;
/** Starts a module in this very thread, once; what comes later finds it started. */
export declare function start(module: WebAssembly.Module): void;
export {};
