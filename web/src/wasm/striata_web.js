/* @ts-self-types="./striata_web.d.ts" */

/**
 * Why something did not work; JavaScript catches it as an object with `code`, `message` and `hint`.
 */
export class Failure {
static __wrap(ptr) {
                    const obj = Object.create(Failure.prototype);
                    obj.__wbg_ptr = ptr;
                    FailureFinalization.register(obj, obj.__wbg_ptr, obj);
                    return obj;
                }
                __destroy_into_raw() {
                const ptr = this.__wbg_ptr;
this.__wbg_ptr = 0;
FailureFinalization.unregister(this);
return ptr;
            }
            free() {
                const ptr = this.__destroy_into_raw();
                wasm.__wbg_failure_free(ptr, 0);
            }
            /**
 * `format`, `corrupt`, `too-large` or `unsupported`.
 * @returns {string}
 */
get code() {
let deferred1_0;
let deferred1_1;
try {
const ret = wasm.failure_code(this.__wbg_ptr);
deferred1_0 = ret[0];
deferred1_1 = ret[1];
return getStringFromWasm0(ret[0], ret[1]);
} finally {
wasm.__wbindgen_free(deferred1_0, deferred1_1, 1);
}
}
/**
 * What may help.
 * @returns {string | undefined}
 */
get hint() {
const ret = wasm.failure_hint(this.__wbg_ptr);
let v1;
if (ret[0] !== 0) {
v1 = getStringFromWasm0(ret[0], ret[1]);
wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
}
return v1;
}
/**
 * One sentence.
 * @returns {string}
 */
get message() {
let deferred1_0;
let deferred1_1;
try {
const ret = wasm.failure_message(this.__wbg_ptr);
deferred1_0 = ret[0];
deferred1_1 = ret[1];
return getStringFromWasm0(ret[0], ret[1]);
} finally {
wasm.__wbindgen_free(deferred1_0, deferred1_1, 1);
}
}
}
if (Symbol.dispose) Failure.prototype[Symbol.dispose] = Failure.prototype.free;

/**
 * A model. Streams are [pushed](Model::push) bytes and [revealed](Model::reveal); other files are read whole.
 *
 * A `show_` method makes a level; `indices`, `group_counts` and the getters that begin with `shown` are about the last of them.
 */
export class Model {
static __wrap(ptr) {
                    const obj = Object.create(Model.prototype);
                    obj.__wbg_ptr = ptr;
                    ModelFinalization.register(obj, obj.__wbg_ptr, obj);
                    return obj;
                }
                __destroy_into_raw() {
                const ptr = this.__wbg_ptr;
this.__wbg_ptr = 0;
ModelFinalization.unregister(this);
return ptr;
            }
            free() {
                const ptr = this.__destroy_into_raw();
                wasm.__wbg_model_free(ptr, 0);
            }
            /**
 * The smallest and the largest coordinates that are there; empty where nothing is.
 * @returns {Float32Array}
 */
bounds() {
const ret = wasm.model_bounds(this.__wbg_ptr);
var v1 = getArrayF32FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
return v1;
}
/**
 * Returns the fan of each triangle that is shown, whose order may change. For a stream that is the vertex that the triangle
 * turns around.
 * @returns {Uint32Array}
 */
color_fans() {
const ret = wasm.model_color_fans(this.__wbg_ptr);
var v1 = getArrayU32FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
return v1;
}
/**
 * Puts the triangles that are shown into the order of strips made of them, and tells the strip of each.
 *
 * # Errors
 * Where no strips can be made.
 * @returns {Uint32Array}
 */
color_strips() {
const ret = wasm.model_color_strips(this.__wbg_ptr);
if (ret[3]) {
throw takeFromExternrefTable0(ret[2]);
}
var v1 = getArrayU32FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
return v1;
}
/**
 * Diagonal of these bounds, mesh units.
 * @returns {number}
 */
get diagonal() {
const ret = wasm.model_diagonal(this.__wbg_ptr);
return ret;
}
/**
 * No more bytes will come: reads what an incomplete rest of them tells.
 *
 * # Errors
 * Where there is no mesh without what is missing.
 */
finish() {
const ret = wasm.model_finish(this.__wbg_ptr);
if (ret[1]) {
throw takeFromExternrefTable0(ret[0]);
}
}
/**
 * Reads a whole file, unpacked, and builds its model; plain meshes are simplified, which takes a second or two for each 100,000
 * triangles. What is shown is all of it.
 *
 * # Errors
 * Where the bytes are damaged, of no kind that is known, or too much for a page.
 * @param {Uint8Array | number[]} bytes
 * @param {string} name
 * @param {{ report(phase: string, share: number): void }} sink
 * @returns {Model}
 */
static from_file(bytes, name, sink) {
let ptr0, len0, ptr1, len1;
try {
ptr0 = passArray8ToWasm0(bytes, wasm.__wbindgen_malloc);
len0 = WASM_VECTOR_LEN;
ptr1 = passStringToWasm0(name, wasm.__wbindgen_malloc, wasm.__wbindgen_realloc);
len1 = WASM_VECTOR_LEN;
} catch (e) {
if (ptr1) { wasm.__wbindgen_free(ptr1, len1 * 1, 1); }
if (ptr0) { wasm.__wbindgen_free(ptr0, len0 * 1, 1); }
throw e;
}
const ret = wasm.model_from_file(ptr0, len0, ptr1, len1, sink);
if (ret[2]) {
throw takeFromExternrefTable0(ret[1]);
}
return Model.__wrap(ret[0]);
}
/**
 * Triangles that there will be; 0 as long as nobody has told.
 * @returns {number}
 */
get full_triangle_count() {
const ret = wasm.model_full_triangle_count(this.__wbg_ptr);
return ret >>> 0;
}
/**
 * Vertices that there will be; 0 as long as nobody has told.
 * @returns {number}
 */
get full_vertex_count() {
const ret = wasm.model_full_vertex_count(this.__wbg_ptr);
return ret >>> 0;
}
/**
 * Groups of triangles, at least one.
 * @returns {number}
 */
get group_count() {
const ret = wasm.model_group_count(this.__wbg_ptr);
return ret >>> 0;
}
/**
 * Triangles of each group that are shown.
 * @returns {Uint32Array}
 */
group_counts() {
const ret = wasm.model_group_counts(this.__wbg_ptr);
var v1 = getArrayU32FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
return v1;
}
/**
 * Prepares views of what has been decoded since the last call. [`reveal`](Self::reveal) does so by itself; calls between pushes spread
 * the work.
 */
grow() {
wasm.model_grow(this.__wbg_ptr);
}
/**
 * Corners of the triangles that are shown, group after group.
 * @returns {Uint32Array}
 */
indices() {
const ret = wasm.model_indices(this.__wbg_ptr);
var v1 = getArrayU32FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
return v1;
}
/**
 * Whether all of the mesh is there.
 * @returns {boolean}
 */
get is_complete() {
const ret = wasm.model_is_complete(this.__wbg_ptr);
return ret !== 0;
}
/**
 * Whether there is something to show.
 * @returns {boolean}
 */
get is_ready() {
const ret = wasm.model_is_ready(this.__wbg_ptr);
return ret !== 0;
}
/**
 * `stream`, `striata` or `mesh`: what the bytes were.
 * @returns {string}
 */
get kind() {
let deferred1_0;
let deferred1_1;
try {
const ret = wasm.model_kind(this.__wbg_ptr);
deferred1_0 = ret[0];
deferred1_1 = ret[1];
return getStringFromWasm0(ret[0], ret[1]);
} finally {
wasm.__wbindgen_free(deferred1_0, deferred1_1, 1);
}
}
/**
 * A model without any bytes yet, for a stream.
 */
constructor() {
const ret = wasm.model_new();
this.__wbg_ptr = ret;
ModelFinalization.register(this, this.__wbg_ptr, this);
return this;
}
/**
 * Takes the next bytes of a stream and decodes what is whole.
 *
 * # Errors
 * Where they are no sound stream, or the whole would not fit into a page. What came before stays.
 * @param {Uint8Array | number[]} bytes
 */
push(bytes) {
const ptr0 = passArray8ToWasm0(bytes, wasm.__wbindgen_malloc);
const len0 = WASM_VECTOR_LEN;
const ret = wasm.model_push(this.__wbg_ptr, ptr0, len0);
if (ret[1]) {
throw takeFromExternrefTable0(ret[0]);
}
}
/**
 * Lets levels and views show all that has been decoded. Counts, vertices and normals are of what has been revealed.
 */
reveal() {
wasm.model_reveal(this.__wbg_ptr);
}
/**
 * Shows a level by its detail, 0 to 1 of the full mesh.
 * @param {number} detail
 */
show_detail(detail) {
wasm.model_show_detail(this.__wbg_ptr, detail);
}
/**
 * Shows the coarsest level that is no farther off, mesh units.
 * @param {number} most
 */
show_error(most) {
wasm.model_show_error(this.__wbg_ptr, most);
}
/**
 * Shows the finest level of no more triangles.
 * @param {number} most
 */
show_triangles(most) {
wasm.model_show_triangles(this.__wbg_ptr, most);
}
/**
 * Shows what a view asks for, of what has arrived; false if asking once more would show more of it.
 *
 * # Errors
 * If the camera sees nothing.
 * @param {View} view
 * @returns {boolean}
 */
show_view(view) {
_assertClass(view, View);
const ret = wasm.model_show_view(this.__wbg_ptr, view.__wbg_ptr);
if (ret[2]) {
throw takeFromExternrefTable0(ret[1]);
}
return ret[0] !== 0;
}
/**
 * How far what is shown is from the full mesh, where it is farthest, mesh units.
 * @returns {number}
 */
get shown_error() {
const ret = wasm.model_shown_error(this.__wbg_ptr);
return ret;
}
/**
 * Vertex splits that are shown.
 * @returns {number}
 */
get shown_split_count() {
const ret = wasm.model_shown_split_count(this.__wbg_ptr);
return ret >>> 0;
}
/**
 * Normals of all vertices that are there, made from the finest level of what has come.
 * @returns {Float32Array}
 */
smooth_normals() {
const ret = wasm.model_smooth_normals(this.__wbg_ptr);
var v1 = getArrayF32FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
return v1;
}
/**
 * Vertex splits from the base to the full mesh.
 * @returns {number}
 */
get step_count() {
const ret = wasm.model_step_count(this.__wbg_ptr);
return ret >>> 0;
}
/**
 * Bytes of the whole stream; 0 as long as nobody has told.
 * @returns {number}
 */
get stream_bytes() {
const ret = wasm.model_stream_bytes(this.__wbg_ptr);
return ret;
}
/**
 * Triangles of the finest level that is there.
 * @returns {number}
 */
get triangle_count() {
const ret = wasm.model_triangle_count(this.__wbg_ptr);
return ret >>> 0;
}
/**
 * Vertices that are there.
 * @returns {number}
 */
get vertex_count() {
const ret = wasm.model_vertex_count(this.__wbg_ptr);
return ret >>> 0;
}
/**
 * Vertices from one on.
 * @param {number} first
 * @returns {Vertices}
 */
vertices(first) {
const ret = wasm.model_vertices(this.__wbg_ptr, first);
return Vertices.__wrap(ret);
}
}
if (Symbol.dispose) Model.prototype[Symbol.dispose] = Model.prototype.free;

/**
 * What the first bytes of a file tell of the place of its stream.
 */
export class StreamPlace {
static __wrap(ptr) {
                    const obj = Object.create(StreamPlace.prototype);
                    obj.__wbg_ptr = ptr;
                    StreamPlaceFinalization.register(obj, obj.__wbg_ptr, obj);
                    return obj;
                }
                __destroy_into_raw() {
                const ptr = this.__wbg_ptr;
this.__wbg_ptr = 0;
StreamPlaceFinalization.unregister(this);
return ptr;
            }
            free() {
                const ptr = this.__destroy_into_raw();
                wasm.__wbg_streamplace_free(ptr, 0);
            }
            /**
 * Its bytes; 0 if the file has no stream.
 * @returns {number}
 */
get length() {
const ret = wasm.__wbg_get_streamplace_length(this.__wbg_ptr);
return ret;
}
/**
 * First bytes of the file that it may take to know; more than were given: ask again with so many.
 * @returns {number}
 */
get needed() {
const ret = wasm.__wbg_get_streamplace_needed(this.__wbg_ptr);
return ret;
}
/**
 * Where the stream begins, bytes from the file's beginning.
 * @returns {number}
 */
get offset() {
const ret = wasm.__wbg_get_streamplace_offset(this.__wbg_ptr);
return ret;
}
/**
 * Its bytes; 0 if the file has no stream.
 * @param {number} arg0
 */
set length(arg0) {
wasm.__wbg_set_streamplace_length(this.__wbg_ptr, arg0);
}
/**
 * First bytes of the file that it may take to know; more than were given: ask again with so many.
 * @param {number} arg0
 */
set needed(arg0) {
wasm.__wbg_set_streamplace_needed(this.__wbg_ptr, arg0);
}
/**
 * Where the stream begins, bytes from the file's beginning.
 * @param {number} arg0
 */
set offset(arg0) {
wasm.__wbg_set_streamplace_offset(this.__wbg_ptr, arg0);
}
/**
 * Looks for the stream of a `.striata` file.
 *
 * # Errors
 * Where the bytes begin no `.striata` file, or its head is damaged.
 * @param {Uint8Array | number[]} head
 * @returns {StreamPlace}
 */
static find(head) {
const ptr0 = passArray8ToWasm0(head, wasm.__wbindgen_malloc);
const len0 = WASM_VECTOR_LEN;
const ret = wasm.streamplace_find(ptr0, len0);
if (ret[2]) {
throw takeFromExternrefTable0(ret[1]);
}
return StreamPlace.__wrap(ret[0]);
}
}
if (Symbol.dispose) StreamPlace.prototype[Symbol.dispose] = StreamPlace.prototype.free;

/**
 * Vertices from some vertex on; what is taken is gone.
 */
export class Vertices {
static __wrap(ptr) {
                    const obj = Object.create(Vertices.prototype);
                    obj.__wbg_ptr = ptr;
                    VerticesFinalization.register(obj, obj.__wbg_ptr, obj);
                    return obj;
                }
                __destroy_into_raw() {
                const ptr = this.__wbg_ptr;
this.__wbg_ptr = 0;
VerticesFinalization.unregister(this);
return ptr;
            }
            free() {
                const ptr = this.__destroy_into_raw();
                wasm.__wbg_vertices_free(ptr, 0);
            }
            /**
 * Red, green, blue and alpha a vertex, if the mesh has colours.
 * @returns {Uint8Array | undefined}
 */
take_colors() {
const ret = wasm.vertices_take_colors(this.__wbg_ptr);
let v1;
if (ret[0] !== 0) {
v1 = getArrayU8FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 1, 1);
}
return v1;
}
/**
 * Three numbers a vertex, if the mesh has normals.
 * @returns {Float32Array | undefined}
 */
take_normals() {
const ret = wasm.vertices_take_normals(this.__wbg_ptr);
let v1;
if (ret[0] !== 0) {
v1 = getArrayF32FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
}
return v1;
}
/**
 * Three numbers a vertex, mesh units.
 * @returns {Float32Array}
 */
take_positions() {
const ret = wasm.vertices_take_positions(this.__wbg_ptr);
var v1 = getArrayF32FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
return v1;
}
/**
 * Two numbers a vertex, `v` downwards, if the mesh has texture coordinates.
 * @returns {Float32Array | undefined}
 */
take_uvs() {
const ret = wasm.vertices_take_uvs(this.__wbg_ptr);
let v1;
if (ret[0] !== 0) {
v1 = getArrayF32FromWasm0(ret[0], ret[1]).slice();
wasm.__wbindgen_free(ret[0], ret[1] * 4, 4);
}
return v1;
}
}
if (Symbol.dispose) Vertices.prototype[Symbol.dispose] = Vertices.prototype.free;

/**
 * An eye in the model's space, its screen, and what is allowed on it.
 */
export class View {
__destroy_into_raw() {
                const ptr = this.__wbg_ptr;
this.__wbg_ptr = 0;
ViewFinalization.unregister(this);
return ptr;
            }
            free() {
                const ptr = this.__destroy_into_raw();
                wasm.__wbg_view_free(ptr, 0);
            }
            /**
 * Pixels that anything may be off.
 * @returns {number}
 */
get pixels() {
const ret = wasm.__wbg_get_view_pixels(this.__wbg_ptr);
return ret;
}
/**
 * Triangles that are shown at most; 0 for no limit.
 * @returns {number}
 */
get triangle_limit() {
const ret = wasm.__wbg_get_view_triangle_limit(this.__wbg_ptr);
return ret >>> 0;
}
/**
 * Pixels that anything may be off.
 * @param {number} arg0
 */
set pixels(arg0) {
wasm.__wbg_set_view_pixels(this.__wbg_ptr, arg0);
}
/**
 * Triangles that are shown at most; 0 for no limit.
 * @param {number} arg0
 */
set triangle_limit(arg0) {
wasm.__wbg_set_view_triangle_limit(this.__wbg_ptr, arg0);
}
/**
 * `numbers`: eye, what it looks at, what is up (three each), tangent of half the vertical field of view, width and
 * height of the screen in pixels.
 *
 * # Errors
 * Where there are not 12 of them.
 * @param {Float64Array | number[]} numbers
 * @param {number} pixels
 * @param {number} triangle_limit
 */
constructor(numbers, pixels, triangle_limit) {
const val2 = +pixels;
const val3 = +triangle_limit;
const ptr0 = passArrayF64ToWasm0(numbers, wasm.__wbindgen_malloc);
const len0 = WASM_VECTOR_LEN;
const ret = wasm.view_new(ptr0, len0, val2, val3);
if (ret[2]) {
throw takeFromExternrefTable0(ret[1]);
}
this.__wbg_ptr = ret[0];
ViewFinalization.register(this, this.__wbg_ptr, this);
return this;
}
}
if (Symbol.dispose) View.prototype[Symbol.dispose] = View.prototype.free;
function __wbg_get_imports() {
            const import0 = {
            __proto__: null,
        __wbg___wbindgen_throw_4c88d8bf264fd984: function(arg0, arg1) {
throw new Error(getStringFromWasm0(arg0, arg1));
},
__wbg_failure_new: function(arg0) {
const ret = Failure.__wrap(arg0);
return ret;
},
__wbg_report_581358a93077c908: function(arg0, arg1, arg2, arg3) {
arg0.report(getStringFromWasm0(arg1, arg2), arg3);
},
__wbindgen_init_externref_table: function() {
const table = wasm.__wbindgen_externrefs;
table.set(0, undefined);
table.set(1024, undefined);
table.set(1025, null);
table.set(1026, true);
table.set(1027, false);
},
};
        return {
            __proto__: null,
            "./striata_web_bg.js": import0,
        };
}

const FailureFinalization = (typeof FinalizationRegistry === 'undefined')
? { register: () => {}, unregister: () => {} }
: new FinalizationRegistry(ptr => wasm.__wbg_failure_free(ptr, 1));
const ModelFinalization = (typeof FinalizationRegistry === 'undefined')
? { register: () => {}, unregister: () => {} }
: new FinalizationRegistry(ptr => wasm.__wbg_model_free(ptr, 1));
const StreamPlaceFinalization = (typeof FinalizationRegistry === 'undefined')
? { register: () => {}, unregister: () => {} }
: new FinalizationRegistry(ptr => wasm.__wbg_streamplace_free(ptr, 1));
const VerticesFinalization = (typeof FinalizationRegistry === 'undefined')
? { register: () => {}, unregister: () => {} }
: new FinalizationRegistry(ptr => wasm.__wbg_vertices_free(ptr, 1));
const ViewFinalization = (typeof FinalizationRegistry === 'undefined')
? { register: () => {}, unregister: () => {} }
: new FinalizationRegistry(ptr => wasm.__wbg_view_free(ptr, 1));

function _assertClass(instance, klass) {
                if (!(instance instanceof klass)) {
                    throw new Error(`expected instance of ${klass.name}`);
                }
            }

function getArrayF32FromWasm0(ptr, len) {
                    ptr = ptr >>> 0;
                    return getFloat32ArrayMemory0().subarray(ptr / 4, ptr / 4 + len);
                }

function getArrayU32FromWasm0(ptr, len) {
                    ptr = ptr >>> 0;
                    return getUint32ArrayMemory0().subarray(ptr / 4, ptr / 4 + len);
                }

function getArrayU8FromWasm0(ptr, len) {
                    ptr = ptr >>> 0;
                    return getUint8ArrayMemory0().subarray(ptr / 1, ptr / 1 + len);
                }

let cachedFloat32ArrayMemory0 = null;
                function getFloat32ArrayMemory0() {
                    if (cachedFloat32ArrayMemory0 === null || cachedFloat32ArrayMemory0.byteLength === 0) {
                        cachedFloat32ArrayMemory0 = new Float32Array(wasm.memory.buffer);
                    }
                    return cachedFloat32ArrayMemory0;
                }

let cachedFloat64ArrayMemory0 = null;
                function getFloat64ArrayMemory0() {
                    if (cachedFloat64ArrayMemory0 === null || cachedFloat64ArrayMemory0.byteLength === 0) {
                        cachedFloat64ArrayMemory0 = new Float64Array(wasm.memory.buffer);
                    }
                    return cachedFloat64ArrayMemory0;
                }

function getStringFromWasm0(ptr, len) {
                    ptr = ptr >>> 0;
                    return decodeText(getUint8ArrayMemory0().subarray(ptr, ptr + len));
                }

let cachedUint32ArrayMemory0 = null;
                function getUint32ArrayMemory0() {
                    if (cachedUint32ArrayMemory0 === null || cachedUint32ArrayMemory0.byteLength === 0) {
                        cachedUint32ArrayMemory0 = new Uint32Array(wasm.memory.buffer);
                    }
                    return cachedUint32ArrayMemory0;
                }

let cachedUint8ArrayMemory0 = null;
                function getUint8ArrayMemory0() {
                    if (cachedUint8ArrayMemory0 === null || cachedUint8ArrayMemory0.byteLength === 0) {
                        cachedUint8ArrayMemory0 = new Uint8Array(wasm.memory.buffer);
                    }
                    return cachedUint8ArrayMemory0;
                }

function passArray8ToWasm0(arg, malloc) {
                    const ptr = malloc(arg.length * 1, 1) >>> 0;
                    getUint8ArrayMemory0().set(arg, ptr / 1);
                    WASM_VECTOR_LEN = arg.length;
                    return ptr;
                }

function passArrayF64ToWasm0(arg, malloc) {
                    const ptr = malloc(arg.length * 8, 8) >>> 0;
                    getFloat64ArrayMemory0().set(arg, ptr / 8);
                    WASM_VECTOR_LEN = arg.length;
                    return ptr;
                }

function passStringToWasm0(arg, malloc, realloc) {
                    if (realloc === undefined) {
                    const buf = cachedTextEncoder.encode(arg);
                    const ptr = malloc(buf.length, 1) >>> 0;
                    getUint8ArrayMemory0().subarray(ptr, ptr + buf.length).set(buf);
                    WASM_VECTOR_LEN = buf.length;
                    return ptr;
                }

                let len = arg.length;
                let ptr = malloc(len, 1) >>> 0;

                const mem = getUint8ArrayMemory0();

                let offset = 0;

                for (; offset < len; offset++) {
                    const code = arg.charCodeAt(offset);
                    if (code > 0x7F) break;
                    mem[ptr + offset] = code;
                }
            if (offset !== len) {
                        if (offset !== 0) {
                            arg = arg.slice(offset);
                        }
                        ptr = realloc(ptr, len, len = offset + arg.length * 3, 1) >>> 0;
                        const view = getUint8ArrayMemory0().subarray(ptr + offset, ptr + len);
                        const ret = cachedTextEncoder.encodeInto(arg, view);
                        
                        offset += ret.written;
                        ptr = realloc(ptr, len, offset, 1) >>> 0;
                    }

                    WASM_VECTOR_LEN = offset;
                    return ptr;
                }

function takeFromExternrefTable0(idx) {
                    const value = wasm.__wbindgen_externrefs.get(idx);
                    wasm.__externref_table_dealloc(idx);
                    return value;
                }

let cachedTextDecoder = new TextDecoder('utf-8', { ignoreBOM: true });
cachedTextDecoder.decode();
                        const MAX_SAFARI_DECODE_BYTES = 2146435072;
                        let numBytesDecoded = 0;
                        function decodeText(bytes) {
                            numBytesDecoded += bytes.length;
                            if (numBytesDecoded >= MAX_SAFARI_DECODE_BYTES) {
                                cachedTextDecoder = new TextDecoder('utf-8', { ignoreBOM: true });
                                cachedTextDecoder.decode();
                                numBytesDecoded = bytes.length;
                            }
                            return cachedTextDecoder.decode(bytes);
                        }

const cachedTextEncoder = new TextEncoder();

                        if (!('encodeInto' in cachedTextEncoder)) {
                            cachedTextEncoder.encodeInto = function (arg, view) {
                const buf = cachedTextEncoder.encode(arg);
                view.set(buf);
                return {
                    read: arg.length,
                    written: buf.length
                };
            };
                        }

let WASM_VECTOR_LEN = 0;

let wasmModule, wasmInstance, wasm;
            function __wbg_finalize_init(instance, module) {
                wasmInstance = instance;
                wasm = instance.exports;
                wasmModule = module;
                cachedFloat32ArrayMemory0 = null;
cachedFloat64ArrayMemory0 = null;
cachedUint32ArrayMemory0 = null;
cachedUint8ArrayMemory0 = null;
wasm.__wbindgen_start();
return wasm;
            }

            async function __wbg_load(module, imports) {
                if (typeof Response === 'function' && module instanceof Response) {
                    if (!module.ok) {
                        throw new Error(`failed to fetch Wasm: ${module.status} ${module.statusText} fetching '${module.url}'`);
                    }

                    if (typeof WebAssembly.instantiateStreaming === 'function') {
                        try {
                            return await WebAssembly.instantiateStreaming(module, imports);
                        } catch (e) {
                            const validResponse = expectedResponseType(module.type);

                            if (validResponse && module.headers.get('Content-Type') !== 'application/wasm') {
                                console.warn("`WebAssembly.instantiateStreaming` failed because your server does not serve Wasm with `application/wasm` MIME type. Falling back to `WebAssembly.instantiate` which is slower. Original error:\n", e);

                            } else { throw e; }
                        }
                    }

                    const bytes = await module.arrayBuffer();
                    return await WebAssembly.instantiate(bytes, imports);
                } else {
                    const instance = await WebAssembly.instantiate(module, imports);

                    if (instance instanceof WebAssembly.Instance) {
                        return { instance, module };
                    } else {
                        return instance;
                    }
                }

                function expectedResponseType(type) {
                    switch (type) {
                        case 'basic': case 'cors': case 'default': return true;
                    }
                    return false;
                }
            }

            function initSync(module) {
                if (wasm !== undefined) return wasm;

                
                if (module !== undefined) {
                    if (Object.getPrototypeOf(module) === Object.prototype) {
                        ({module} = module)
                    } else {
                        console.warn('using deprecated parameters for `initSync()`; pass a single object instead')
                    }
                }

                const imports = __wbg_get_imports();
                if (!(module instanceof WebAssembly.Module)) {
                    module = new WebAssembly.Module(module);
                }
                const instance = new WebAssembly.Instance(module, imports);
                return __wbg_finalize_init(instance, module);
            }

            let __wbg_init_promise;
            async function __wbg_init(module_or_path) {
                if (wasm !== undefined) return wasm;
                if (__wbg_init_promise === undefined) {
                    __wbg_init_promise = __wbg_init_once(module_or_path);
                    __wbg_init_promise.catch(() => { __wbg_init_promise = undefined; });
                }
                return __wbg_init_promise;
            }

            async function __wbg_init_once(module_or_path) {
                
                if (module_or_path !== undefined) {
                    if (Object.getPrototypeOf(module_or_path) === Object.prototype) {
                        ({module_or_path} = module_or_path)
                    } else {
                        console.warn('using deprecated parameters for the initialization function; pass a single object instead')
                    }
                }

                
                const imports = __wbg_get_imports();

                if (typeof module_or_path === 'string' || (typeof Request === 'function' && module_or_path instanceof Request) || (typeof URL === 'function' && module_or_path instanceof URL)) {
                    module_or_path = fetch(module_or_path);
                }

                const { instance, module } = await __wbg_load(await module_or_path, imports);

                return __wbg_finalize_init(instance, module);
            }
            
export { initSync, __wbg_init as default };