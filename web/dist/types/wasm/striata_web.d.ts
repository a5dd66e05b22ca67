/* tslint:disable */
/* eslint-disable */

/**
 * Why something did not work; JavaScript catches it as an object with `code`, `message` and `hint`.
 */
export class Failure {
  private constructor();
  free(): void;
  [Symbol.dispose](): void;
  /**
   * `format`, `corrupt`, `too-large` or `unsupported`.
   */
  readonly code: string;
  /**
   * What may help.
   */
  readonly hint: string | undefined;
  /**
   * One sentence.
   */
  readonly message: string;
}

/**
 * A model. Streams are [pushed](Model::push) bytes and [revealed](Model::reveal); other files are read whole.
 *
 * A `show_` method makes a level; `indices`, `group_counts` and the getters that begin with `shown` are about the last of them.
 */
export class Model {
  free(): void;
  [Symbol.dispose](): void;
  /**
   * The smallest and the largest coordinates that are there; empty where nothing is.
   */
  bounds(): Float32Array;
  /**
   * Returns the fan of each triangle that is shown, whose order may change. For a stream that is the vertex that the triangle
   * turns around.
   */
  color_fans(): Uint32Array;
  /**
   * Puts the triangles that are shown into the order of strips made of them, and tells the strip of each.
   *
   * # Errors
   * Where no strips can be made.
   */
  color_strips(): Uint32Array;
  /**
   * No more bytes will come: reads what an incomplete rest of them tells.
   *
   * # Errors
   * Where there is no mesh without what is missing.
   */
  finish(): void;
  /**
   * Reads a whole file, unpacked, and builds its model; plain meshes are simplified, which takes a second or two for each 100,000
   * triangles. What is shown is all of it.
   *
   * # Errors
   * Where the bytes are damaged, of no kind that is known, or too much for a page.
   */
  static from_file(bytes: Uint8Array | number[], name: string, sink: { report(phase: string, share: number): void }): Model;
  /**
   * Triangles of each group that are shown.
   */
  group_counts(): Uint32Array;
  /**
   * Prepares views of what has been decoded since the last call. [`reveal`](Self::reveal) does so by itself; calls between pushes spread
   * the work.
   */
  grow(): void;
  /**
   * Corners of the triangles that are shown, group after group.
   */
  indices(): Uint32Array;
  /**
   * A model without any bytes yet, for a stream.
   */
  constructor();
  /**
   * Takes the next bytes of a stream and decodes what is whole.
   *
   * # Errors
   * Where they are no sound stream, or the whole would not fit into a page. What came before stays.
   */
  push(bytes: Uint8Array | number[]): void;
  /**
   * Lets levels and views show all that has been decoded. Counts, vertices and normals are of what has been revealed.
   */
  reveal(): void;
  /**
   * Shows a level by its detail, 0 to 1 of the full mesh.
   */
  show_detail(detail: number): void;
  /**
   * Shows the coarsest level that is no farther off, mesh units.
   */
  show_error(most: number): void;
  /**
   * Shows the finest level of no more triangles.
   */
  show_triangles(most: number): void;
  /**
   * Shows what a view asks for, of what has arrived; false if asking once more would show more of it.
   *
   * # Errors
   * If the camera sees nothing.
   */
  show_view(view: View): boolean;
  /**
   * Normals of all vertices that are there, made from the finest level of what has come.
   */
  smooth_normals(): Float32Array;
  /**
   * Vertices from one on.
   */
  vertices(first: number): Vertices;
  /**
   * Diagonal of these bounds, mesh units.
   */
  readonly diagonal: number;
  /**
   * Triangles that there will be; 0 as long as nobody has told.
   */
  readonly full_triangle_count: number;
  /**
   * Vertices that there will be; 0 as long as nobody has told.
   */
  readonly full_vertex_count: number;
  /**
   * Groups of triangles, at least one.
   */
  readonly group_count: number;
  /**
   * Whether all of the mesh is there.
   */
  readonly is_complete: boolean;
  /**
   * Whether there is something to show.
   */
  readonly is_ready: boolean;
  /**
   * `stream`, `striata` or `mesh`: what the bytes were.
   */
  readonly kind: string;
  /**
   * How far what is shown is from the full mesh, where it is farthest, mesh units.
   */
  readonly shown_error: number;
  /**
   * Vertex splits that are shown.
   */
  readonly shown_split_count: number;
  /**
   * Vertex splits from the base to the full mesh.
   */
  readonly step_count: number;
  /**
   * Bytes of the whole stream; 0 as long as nobody has told.
   */
  readonly stream_bytes: number;
  /**
   * Triangles of the finest level that is there.
   */
  readonly triangle_count: number;
  /**
   * Vertices that are there.
   */
  readonly vertex_count: number;
}

/**
 * What the first bytes of a file tell of the place of its stream.
 */
export class StreamPlace {
  private constructor();
  free(): void;
  [Symbol.dispose](): void;
  /**
   * Looks for the stream of a `.striata` file.
   *
   * # Errors
   * Where the bytes begin no `.striata` file, or its head is damaged.
   */
  static find(head: Uint8Array | number[]): StreamPlace;
  /**
   * Its bytes; 0 if the file has no stream.
   */
  length: number;
  /**
   * First bytes of the file that it may take to know; more than were given: ask again with so many.
   */
  needed: number;
  /**
   * Where the stream begins, bytes from the file's beginning.
   */
  offset: number;
}

/**
 * Vertices from some vertex on; what is taken is gone.
 */
export class Vertices {
  private constructor();
  free(): void;
  [Symbol.dispose](): void;
  /**
   * Red, green, blue and alpha a vertex, if the mesh has colours.
   */
  take_colors(): Uint8Array | undefined;
  /**
   * Three numbers a vertex, if the mesh has normals.
   */
  take_normals(): Float32Array | undefined;
  /**
   * Three numbers a vertex, mesh units.
   */
  take_positions(): Float32Array;
  /**
   * Two numbers a vertex, `v` downwards, if the mesh has texture coordinates.
   */
  take_uvs(): Float32Array | undefined;
}

/**
 * An eye in the model's space, its screen, and what is allowed on it.
 */
export class View {
  free(): void;
  [Symbol.dispose](): void;
  /**
   * `numbers`: eye, what it looks at, what is up (three each), tangent of half the vertical field of view, width and
   * height of the screen in pixels.
   *
   * # Errors
   * Where there are not 12 of them.
   */
  constructor(numbers: Float64Array | number[], pixels: number, triangle_limit: number);
  /**
   * Pixels that anything may be off.
   */
  pixels: number;
  /**
   * Triangles that are shown at most; 0 for no limit.
   */
  triangle_limit: number;
}

export type InitInput = RequestInfo | URL | Response | BufferSource | WebAssembly.Module;

export interface InitOutput {
  readonly memory: WebAssembly.Memory;
  readonly __wbg_failure_free: (a: number, b: number) => void;
  readonly __wbg_get_streamplace_length: (a: number) => number;
  readonly __wbg_get_streamplace_needed: (a: number) => number;
  readonly __wbg_get_streamplace_offset: (a: number) => number;
  readonly __wbg_get_view_pixels: (a: number) => number;
  readonly __wbg_get_view_triangle_limit: (a: number) => number;
  readonly __wbg_model_free: (a: number, b: number) => void;
  readonly __wbg_set_streamplace_length: (a: number, b: number) => void;
  readonly __wbg_set_streamplace_needed: (a: number, b: number) => void;
  readonly __wbg_set_streamplace_offset: (a: number, b: number) => void;
  readonly __wbg_set_view_pixels: (a: number, b: number) => void;
  readonly __wbg_set_view_triangle_limit: (a: number, b: number) => void;
  readonly __wbg_streamplace_free: (a: number, b: number) => void;
  readonly __wbg_vertices_free: (a: number, b: number) => void;
  readonly __wbg_view_free: (a: number, b: number) => void;
  readonly failure_code: (a: number) => [number, number];
  readonly failure_hint: (a: number) => [number, number];
  readonly failure_message: (a: number) => [number, number];
  readonly model_bounds: (a: number) => [number, number];
  readonly model_color_fans: (a: number) => [number, number];
  readonly model_color_strips: (a: number) => [number, number, number, number];
  readonly model_diagonal: (a: number) => number;
  readonly model_finish: (a: number) => [number, number];
  readonly model_from_file: (a: number, b: number, c: number, d: number, e: any) => [number, number, number];
  readonly model_full_triangle_count: (a: number) => number;
  readonly model_full_vertex_count: (a: number) => number;
  readonly model_group_count: (a: number) => number;
  readonly model_group_counts: (a: number) => [number, number];
  readonly model_grow: (a: number) => void;
  readonly model_indices: (a: number) => [number, number];
  readonly model_is_complete: (a: number) => number;
  readonly model_is_ready: (a: number) => number;
  readonly model_kind: (a: number) => [number, number];
  readonly model_new: () => number;
  readonly model_push: (a: number, b: number, c: number) => [number, number];
  readonly model_reveal: (a: number) => void;
  readonly model_show_detail: (a: number, b: number) => void;
  readonly model_show_error: (a: number, b: number) => void;
  readonly model_show_triangles: (a: number, b: number) => void;
  readonly model_show_view: (a: number, b: number) => [number, number, number];
  readonly model_shown_error: (a: number) => number;
  readonly model_shown_split_count: (a: number) => number;
  readonly model_smooth_normals: (a: number) => [number, number];
  readonly model_step_count: (a: number) => number;
  readonly model_stream_bytes: (a: number) => number;
  readonly model_triangle_count: (a: number) => number;
  readonly model_vertex_count: (a: number) => number;
  readonly model_vertices: (a: number, b: number) => number;
  readonly streamplace_find: (a: number, b: number) => [number, number, number];
  readonly vertices_take_colors: (a: number) => [number, number];
  readonly vertices_take_normals: (a: number) => [number, number];
  readonly vertices_take_positions: (a: number) => [number, number];
  readonly vertices_take_uvs: (a: number) => [number, number];
  readonly view_new: (a: number, b: number, c: number, d: number) => [number, number, number];
  readonly __wbindgen_externrefs: WebAssembly.Table;
  readonly __wbindgen_free: (a: number, b: number, c: number) => void;
  readonly __externref_table_dealloc: (a: number) => void;
  readonly __wbindgen_malloc: (a: number, b: number) => number;
  readonly __wbindgen_realloc: (a: number, b: number, c: number, d: number) => number;
  readonly __wbindgen_start: () => void;
}

export type SyncInitInput = BufferSource | WebAssembly.Module;

/**
* Instantiates the given `module`, which can either be bytes or
* a precompiled `WebAssembly.Module`.
*
* @param {{ module: SyncInitInput }} module - Passing `SyncInitInput` directly is deprecated.
*
* @returns {InitOutput}
*/
export function initSync(module: { module: SyncInitInput } | SyncInitInput): InitOutput;

/**
* If `module_or_path` is {RequestInfo} or {URL}, makes a request and
* for everything else, calls `WebAssembly.instantiate` directly.
*
* @param {{ module_or_path: InitInput | Promise<InitInput> }} module_or_path - Passing `InitInput` directly is deprecated.
*
* @returns {Promise<InitOutput>}
*/
export default function __wbg_init (module_or_path: { module_or_path: InitInput | Promise<InitInput> } | InitInput | Promise<InitInput>): Promise<InitOutput>;
