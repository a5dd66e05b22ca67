class j {
  static __wrap(e) {
    const r = Object.create(j.prototype);
    return r.__wbg_ptr = e, Le.register(r, r.__wbg_ptr, r), r;
  }
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, Le.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    o.__wbg_failure_free(e, 0);
  }
  /**
  * `format`, `corrupt`, `too-large` or `unsupported`.
  * @returns {string}
  */
  get code() {
    let e, r;
    try {
      const n = o.failure_code(this.__wbg_ptr);
      return e = n[0], r = n[1], N(n[0], n[1]);
    } finally {
      o.__wbindgen_free(e, r, 1);
    }
  }
  /**
   * What may help.
   * @returns {string | undefined}
   */
  get hint() {
    const e = o.failure_hint(this.__wbg_ptr);
    let r;
    return e[0] !== 0 && (r = N(e[0], e[1]), o.__wbindgen_free(e[0], e[1] * 1, 1)), r;
  }
  /**
   * One sentence.
   * @returns {string}
   */
  get message() {
    let e, r;
    try {
      const n = o.failure_message(this.__wbg_ptr);
      return e = n[0], r = n[1], N(n[0], n[1]);
    } finally {
      o.__wbindgen_free(e, r, 1);
    }
  }
}
Symbol.dispose && (j.prototype[Symbol.dispose] = j.prototype.free);
class P {
  static __wrap(e) {
    const r = Object.create(P.prototype);
    return r.__wbg_ptr = e, de.register(r, r.__wbg_ptr, r), r;
  }
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, de.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    o.__wbg_model_free(e, 0);
  }
  /**
  * The smallest and the largest coordinates that are there; empty where nothing is.
  * @returns {Float32Array}
  */
  bounds() {
    const e = o.model_bounds(this.__wbg_ptr);
    var r = Z(e[0], e[1]).slice();
    return o.__wbindgen_free(e[0], e[1] * 4, 4), r;
  }
  /**
   * Returns the fan of each triangle that is shown, whose order may change. For a stream that is the vertex that the triangle
   * turns around.
   * @returns {Uint32Array}
   */
  color_fans() {
    const e = o.model_color_fans(this.__wbg_ptr);
    var r = ce(e[0], e[1]).slice();
    return o.__wbindgen_free(e[0], e[1] * 4, 4), r;
  }
  /**
   * Puts the triangles that are shown into the order of strips made of them, and tells the strip of each.
   *
   * # Errors
   * Where no strips can be made.
   * @returns {Uint32Array}
   */
  color_strips() {
    const e = o.model_color_strips(this.__wbg_ptr);
    if (e[3])
      throw D(e[2]);
    var r = ce(e[0], e[1]).slice();
    return o.__wbindgen_free(e[0], e[1] * 4, 4), r;
  }
  /**
   * Diagonal of these bounds, mesh units.
   * @returns {number}
   */
  get diagonal() {
    return o.model_diagonal(this.__wbg_ptr);
  }
  /**
   * No more bytes will come: reads what an incomplete rest of them tells.
   *
   * # Errors
   * Where there is no mesh without what is missing.
   */
  finish() {
    const e = o.model_finish(this.__wbg_ptr);
    if (e[1])
      throw D(e[0]);
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
  static from_file(e, r, n) {
    let i, s, a, _;
    try {
      i = Fe(e, o.__wbindgen_malloc), s = B, a = et(r, o.__wbindgen_malloc, o.__wbindgen_realloc), _ = B;
    } catch (u) {
      throw a && o.__wbindgen_free(a, _ * 1, 1), i && o.__wbindgen_free(i, s * 1, 1), u;
    }
    const c = o.model_from_file(i, s, a, _, n);
    if (c[2])
      throw D(c[1]);
    return P.__wrap(c[0]);
  }
  /**
   * Triangles that there will be; 0 as long as nobody has told.
   * @returns {number}
   */
  get full_triangle_count() {
    return o.model_full_triangle_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Vertices that there will be; 0 as long as nobody has told.
   * @returns {number}
   */
  get full_vertex_count() {
    return o.model_full_vertex_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Groups of triangles, at least one.
   * @returns {number}
   */
  get group_count() {
    return o.model_group_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Triangles of each group that are shown.
   * @returns {Uint32Array}
   */
  group_counts() {
    const e = o.model_group_counts(this.__wbg_ptr);
    var r = ce(e[0], e[1]).slice();
    return o.__wbindgen_free(e[0], e[1] * 4, 4), r;
  }
  /**
   * Prepares views of what has been decoded since the last call. [`reveal`](Self::reveal) does so by itself; calls between pushes spread
   * the work.
   */
  grow() {
    o.model_grow(this.__wbg_ptr);
  }
  /**
   * Corners of the triangles that are shown, group after group.
   * @returns {Uint32Array}
   */
  indices() {
    const e = o.model_indices(this.__wbg_ptr);
    var r = ce(e[0], e[1]).slice();
    return o.__wbindgen_free(e[0], e[1] * 4, 4), r;
  }
  /**
   * Whether all of the mesh is there.
   * @returns {boolean}
   */
  get is_complete() {
    return o.model_is_complete(this.__wbg_ptr) !== 0;
  }
  /**
   * Whether there is something to show.
   * @returns {boolean}
   */
  get is_ready() {
    return o.model_is_ready(this.__wbg_ptr) !== 0;
  }
  /**
   * `stream`, `striata` or `mesh`: what the bytes were.
   * @returns {string}
   */
  get kind() {
    let e, r;
    try {
      const n = o.model_kind(this.__wbg_ptr);
      return e = n[0], r = n[1], N(n[0], n[1]);
    } finally {
      o.__wbindgen_free(e, r, 1);
    }
  }
  /**
   * A model without any bytes yet, for a stream.
   */
  constructor() {
    const e = o.model_new();
    return this.__wbg_ptr = e, de.register(this, this.__wbg_ptr, this), this;
  }
  /**
   * Takes the next bytes of a stream and decodes what is whole.
   *
   * # Errors
   * Where they are no sound stream, or the whole would not fit into a page. What came before stays.
   * @param {Uint8Array | number[]} bytes
   */
  push(e) {
    const r = Fe(e, o.__wbindgen_malloc), n = B, i = o.model_push(this.__wbg_ptr, r, n);
    if (i[1])
      throw D(i[0]);
  }
  /**
   * Lets levels and views show all that has been decoded. Counts, vertices and normals are of what has been revealed.
   */
  reveal() {
    o.model_reveal(this.__wbg_ptr);
  }
  /**
   * Shows a level by its detail, 0 to 1 of the full mesh.
   * @param {number} detail
   */
  show_detail(e) {
    o.model_show_detail(this.__wbg_ptr, e);
  }
  /**
   * Shows the coarsest level that is no farther off, mesh units.
   * @param {number} most
   */
  show_error(e) {
    o.model_show_error(this.__wbg_ptr, e);
  }
  /**
   * Shows the finest level of no more triangles.
   * @param {number} most
   */
  show_triangles(e) {
    o.model_show_triangles(this.__wbg_ptr, e);
  }
  /**
   * Shows what a view asks for, of what has arrived; false if asking once more would show more of it.
   *
   * # Errors
   * If the camera sees nothing.
   * @param {View} view
   * @returns {boolean}
   */
  show_view(e) {
    Xe(e, he);
    const r = o.model_show_view(this.__wbg_ptr, e.__wbg_ptr);
    if (r[2])
      throw D(r[1]);
    return r[0] !== 0;
  }
  /**
   * How far what is shown is from the full mesh, where it is farthest, mesh units.
   * @returns {number}
   */
  get shown_error() {
    return o.model_shown_error(this.__wbg_ptr);
  }
  /**
   * Vertex splits that are shown.
   * @returns {number}
   */
  get shown_split_count() {
    return o.model_shown_split_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Normals of all vertices that are there, made from the finest level of what has come.
   * @returns {Float32Array}
   */
  smooth_normals() {
    const e = o.model_smooth_normals(this.__wbg_ptr);
    var r = Z(e[0], e[1]).slice();
    return o.__wbindgen_free(e[0], e[1] * 4, 4), r;
  }
  /**
   * Vertex splits from the base to the full mesh.
   * @returns {number}
   */
  get step_count() {
    return o.model_step_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Bytes of the whole stream; 0 as long as nobody has told.
   * @returns {number}
   */
  get stream_bytes() {
    return o.model_stream_bytes(this.__wbg_ptr);
  }
  /**
   * Triangles of the finest level that is there.
   * @returns {number}
   */
  get triangle_count() {
    return o.model_triangle_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Vertices that are there.
   * @returns {number}
   */
  get vertex_count() {
    return o.model_vertex_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Vertices from one on.
   * @param {number} first
   * @returns {Vertices}
   */
  vertices(e) {
    const r = o.model_vertices(this.__wbg_ptr, e);
    return re.__wrap(r);
  }
}
Symbol.dispose && (P.prototype[Symbol.dispose] = P.prototype.free);
class te {
  static __wrap(e) {
    const r = Object.create(te.prototype);
    return r.__wbg_ptr = e, We.register(r, r.__wbg_ptr, r), r;
  }
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, We.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    o.__wbg_streamplace_free(e, 0);
  }
  /**
  * Its bytes; 0 if the file has no stream.
  * @returns {number}
  */
  get length() {
    return o.__wbg_get_streamplace_length(this.__wbg_ptr);
  }
  /**
   * First bytes of the file that it may take to know; more than were given: ask again with so many.
   * @returns {number}
   */
  get needed() {
    return o.__wbg_get_streamplace_needed(this.__wbg_ptr);
  }
  /**
   * Where the stream begins, bytes from the file's beginning.
   * @returns {number}
   */
  get offset() {
    return o.__wbg_get_streamplace_offset(this.__wbg_ptr);
  }
  /**
   * Its bytes; 0 if the file has no stream.
   * @param {number} arg0
   */
  set length(e) {
    o.__wbg_set_streamplace_length(this.__wbg_ptr, e);
  }
  /**
   * First bytes of the file that it may take to know; more than were given: ask again with so many.
   * @param {number} arg0
   */
  set needed(e) {
    o.__wbg_set_streamplace_needed(this.__wbg_ptr, e);
  }
  /**
   * Where the stream begins, bytes from the file's beginning.
   * @param {number} arg0
   */
  set offset(e) {
    o.__wbg_set_streamplace_offset(this.__wbg_ptr, e);
  }
  /**
   * Looks for the stream of a `.striata` file.
   *
   * # Errors
   * Where the bytes begin no `.striata` file, or its head is damaged.
   * @param {Uint8Array | number[]} head
   * @returns {StreamPlace}
   */
  static find(e) {
    const r = Fe(e, o.__wbindgen_malloc), n = B, i = o.streamplace_find(r, n);
    if (i[2])
      throw D(i[1]);
    return te.__wrap(i[0]);
  }
}
Symbol.dispose && (te.prototype[Symbol.dispose] = te.prototype.free);
class re {
  static __wrap(e) {
    const r = Object.create(re.prototype);
    return r.__wbg_ptr = e, De.register(r, r.__wbg_ptr, r), r;
  }
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, De.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    o.__wbg_vertices_free(e, 0);
  }
  /**
  * Red, green, blue and alpha a vertex, if the mesh has colours.
  * @returns {Uint8Array | undefined}
  */
  take_colors() {
    const e = o.vertices_take_colors(this.__wbg_ptr);
    let r;
    return e[0] !== 0 && (r = Ge(e[0], e[1]).slice(), o.__wbindgen_free(e[0], e[1] * 1, 1)), r;
  }
  /**
   * Three numbers a vertex, if the mesh has normals.
   * @returns {Float32Array | undefined}
   */
  take_normals() {
    const e = o.vertices_take_normals(this.__wbg_ptr);
    let r;
    return e[0] !== 0 && (r = Z(e[0], e[1]).slice(), o.__wbindgen_free(e[0], e[1] * 4, 4)), r;
  }
  /**
   * Three numbers a vertex, mesh units.
   * @returns {Float32Array}
   */
  take_positions() {
    const e = o.vertices_take_positions(this.__wbg_ptr);
    var r = Z(e[0], e[1]).slice();
    return o.__wbindgen_free(e[0], e[1] * 4, 4), r;
  }
  /**
   * Two numbers a vertex, `v` downwards, if the mesh has texture coordinates.
   * @returns {Float32Array | undefined}
   */
  take_uvs() {
    const e = o.vertices_take_uvs(this.__wbg_ptr);
    let r;
    return e[0] !== 0 && (r = Z(e[0], e[1]).slice(), o.__wbindgen_free(e[0], e[1] * 4, 4)), r;
  }
}
Symbol.dispose && (re.prototype[Symbol.dispose] = re.prototype.free);
class he {
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, Ie.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    o.__wbg_view_free(e, 0);
  }
  /**
  * Pixels that anything may be off.
  * @returns {number}
  */
  get pixels() {
    return o.__wbg_get_view_pixels(this.__wbg_ptr);
  }
  /**
   * Triangles that are shown at most; 0 for no limit.
   * @returns {number}
   */
  get triangle_limit() {
    return o.__wbg_get_view_triangle_limit(this.__wbg_ptr) >>> 0;
  }
  /**
   * Pixels that anything may be off.
   * @param {number} arg0
   */
  set pixels(e) {
    o.__wbg_set_view_pixels(this.__wbg_ptr, e);
  }
  /**
   * Triangles that are shown at most; 0 for no limit.
   * @param {number} arg0
   */
  set triangle_limit(e) {
    o.__wbg_set_view_triangle_limit(this.__wbg_ptr, e);
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
  constructor(e, r, n) {
    const i = +r, s = +n, a = Ze(e, o.__wbindgen_malloc), _ = B, c = o.view_new(a, _, i, s);
    if (c[2])
      throw D(c[1]);
    return this.__wbg_ptr = c[0], Ie.register(this, this.__wbg_ptr, this), this;
  }
}
Symbol.dispose && (he.prototype[Symbol.dispose] = he.prototype.free);
function He() {
  return {
    __proto__: null,
    "./striata_web_bg.js": {
      __proto__: null,
      __wbg___wbindgen_throw_4c88d8bf264fd984: function(e, r) {
        throw new Error(N(e, r));
      },
      __wbg_failure_new: function(e) {
        return j.__wrap(e);
      },
      __wbg_report_581358a93077c908: function(e, r, n, i) {
        e.report(N(r, n), i);
      },
      __wbindgen_init_externref_table: function() {
        const e = o.__wbindgen_externrefs;
        e.set(0, void 0), e.set(1024, void 0), e.set(1025, null), e.set(1026, !0), e.set(1027, !1);
      }
    }
  };
}
const Le = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => o.__wbg_failure_free(t, 1)), de = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => o.__wbg_model_free(t, 1)), We = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => o.__wbg_streamplace_free(t, 1)), De = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => o.__wbg_vertices_free(t, 1)), Ie = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => o.__wbg_view_free(t, 1));
function Xe(t, e) {
  if (!(t instanceof e))
    throw new Error(`expected instance of ${e.name}`);
}
function Z(t, e) {
  return t = t >>> 0, Je().subarray(t / 4, t / 4 + e);
}
function ce(t, e) {
  return t = t >>> 0, Qe().subarray(t / 4, t / 4 + e);
}
function Ge(t, e) {
  return t = t >>> 0, V().subarray(t / 1, t / 1 + e);
}
let X = null;
function Je() {
  return (X === null || X.byteLength === 0) && (X = new Float32Array(o.memory.buffer)), X;
}
let G = null;
function Ke() {
  return (G === null || G.byteLength === 0) && (G = new Float64Array(o.memory.buffer)), G;
}
function N(t, e) {
  return t = t >>> 0, rt(V().subarray(t, t + e));
}
let J = null;
function Qe() {
  return (J === null || J.byteLength === 0) && (J = new Uint32Array(o.memory.buffer)), J;
}
let K = null;
function V() {
  return (K === null || K.byteLength === 0) && (K = new Uint8Array(o.memory.buffer)), K;
}
function Fe(t, e) {
  const r = e(t.length * 1, 1) >>> 0;
  return V().set(t, r / 1), B = t.length, r;
}
function Ze(t, e) {
  const r = e(t.length * 8, 8) >>> 0;
  return Ke().set(t, r / 8), B = t.length, r;
}
function et(t, e, r) {
  if (r === void 0) {
    const _ = ee.encode(t), c = e(_.length, 1) >>> 0;
    return V().subarray(c, c + _.length).set(_), B = _.length, c;
  }
  let n = t.length, i = e(n, 1) >>> 0;
  const s = V();
  let a = 0;
  for (; a < n; a++) {
    const _ = t.charCodeAt(a);
    if (_ > 127) break;
    s[i + a] = _;
  }
  if (a !== n) {
    a !== 0 && (t = t.slice(a)), i = r(i, n, n = a + t.length * 3, 1) >>> 0;
    const _ = V().subarray(i + a, i + n), c = ee.encodeInto(t, _);
    a += c.written, i = r(i, n, a, 1) >>> 0;
  }
  return B = a, i;
}
function D(t) {
  const e = o.__wbindgen_externrefs.get(t);
  return o.__externref_table_dealloc(t), e;
}
let le = new TextDecoder("utf-8", { ignoreBOM: !0 });
le.decode();
const tt = 2146435072;
let ye = 0;
function rt(t) {
  return ye += t.length, ye >= tt && (le = new TextDecoder("utf-8", { ignoreBOM: !0 }), le.decode(), ye = t.length), le.decode(t);
}
const ee = new TextEncoder();
"encodeInto" in ee || (ee.encodeInto = function(t, e) {
  const r = ee.encode(t);
  return e.set(r), {
    read: t.length,
    written: r.length
  };
});
let B = 0, o;
function nt(t, e) {
  return o = t.exports, X = null, G = null, J = null, K = null, o.__wbindgen_start(), o;
}
function it(t) {
  if (o !== void 0) return o;
  t !== void 0 && (Object.getPrototypeOf(t) === Object.prototype ? { module: t } = t : console.warn("using deprecated parameters for `initSync()`; pass a single object instead"));
  const e = He();
  t instanceof WebAssembly.Module || (t = new WebAssembly.Module(t));
  const r = new WebAssembly.Instance(t, e);
  return nt(r);
}
class A extends Error {
  code;
  hint;
  constructor(e, r, n) {
    super(r), this.name = "StriataError", this.code = e, this.hint = n;
  }
}
function me(t) {
  if (t instanceof A) return t;
  if (t instanceof j) {
    const r = new A(t.code, t.message, t.hint);
    return t.free(), r;
  }
  if (t instanceof WebAssembly.RuntimeError || t instanceof RangeError)
    return new A(
      "too-large",
      "the model took more memory than the page has",
      "close other pages, or load a stream with fewer triangles"
    );
  if (t instanceof DOMException && t.name === "AbortError") return st();
  const e = t instanceof Error ? t.message : String(t);
  return new A("network", e);
}
function st() {
  return new A("aborted", "loading was aborted");
}
function ve(t) {
  return { code: t.code, message: t.message, hint: t.hint };
}
function jt(t) {
  return new A(t.code, t.message, t.hint);
}
var ot = ArrayBuffer, y = Uint8Array, fe = Uint16Array, at = Int16Array, we = Int32Array, be = function(t, e, r) {
  if (y.prototype.slice)
    return y.prototype.slice.call(t, e, r);
  (e == null || e < 0) && (e = 0), (r == null || r > t.length) && (r = t.length);
  var n = new y(r - e);
  return n.set(t.subarray(e, r)), n;
}, ue = function(t, e, r, n) {
  if (y.prototype.fill)
    return y.prototype.fill.call(t, e, r, n);
  for ((r == null || r < 0) && (r = 0), (n == null || n > t.length) && (n = t.length); r < n; ++r)
    t[r] = e;
  return t;
}, _t = function(t, e, r, n) {
  if (y.prototype.copyWithin)
    return y.prototype.copyWithin.call(t, e, r, n);
  for ((r == null || r < 0) && (r = 0), (n == null || n > t.length) && (n = t.length); r < n; )
    t[e++] = t[r++];
}, ct = [
  "invalid zstd data",
  "window size too large (>2046MB)",
  "invalid block type",
  "FSE accuracy too high",
  "match distance too far back",
  "unexpected EOF"
], p = function(t, e, r) {
  var n = new Error(e || ct[t]);
  if (n.code = t, Error.captureStackTrace && Error.captureStackTrace(n, p), !r)
    throw n;
  return n;
}, je = function(t, e, r) {
  for (var n = 0, i = 0; n < r; ++n)
    i |= t[e++] << (n << 3);
  return i;
}, lt = function(t, e) {
  return (t[e] | t[e + 1] << 8 | t[e + 2] << 16 | t[e + 3] << 24) >>> 0;
}, ht = function(t, e) {
  var r = t[0] | t[1] << 8 | t[2] << 16;
  if (r == 3126568 && t[3] == 253) {
    var n = t[4], i = n >> 5 & 1, s = n >> 2 & 1, a = n & 3, _ = n >> 6;
    n & 8 && p(0);
    var c = 6 - i, u = a == 3 ? 4 : a, m = je(t, c, u);
    c += u;
    var w = _ ? 1 << _ : i, d = je(t, c, w) + (_ == 1 && 256), v = d;
    if (!i) {
      var x = 1 << 10 + (t[5] >> 3);
      v = x + (x >> 3) * (t[5] & 7);
    }
    v > 2145386496 && p(1);
    var l = new y(v + 12);
    return l[0] = 1, l[4] = 4, l[8] = 8, {
      b: c + w,
      y: 0,
      l: 0,
      d: m,
      w: e && e != 1 ? e : l.subarray(12),
      e: v,
      o: new we(l.buffer, 0, 3),
      u: d,
      c: s,
      m: Math.min(131072, v)
    };
  } else if ((r >> 4 | t[3] << 20) == 25481893)
    return lt(t, 4) + 8;
  p(0);
}, I = function(t) {
  for (var e = 0; 1 << e <= t; ++e)
    ;
  return e - 1;
}, ne = function(t, e, r) {
  var n = (e << 3) + 4, i = (t[e] & 15) + 5;
  i > r && p(3);
  for (var s = 1 << i, a = s, _ = -1, c = -1, u = -1, m = s, w = new ot(512 + (s << 2)), d = new at(w, 0, 256), v = new fe(w, 0, 256), x = new fe(w, 512, s), l = 512 + (s << 1), b = new y(w, l, s), U = new y(w, l + s); _ < 255 && a > 0; ) {
    var z = I(a + 1), S = n >> 3, L = (1 << z + 1) - 1, E = (t[S] | t[S + 1] << 8 | t[S + 2] << 16) >> (n & 7) & L, f = (1 << z) - 1, F = L - a - 1, T = E & f;
    if (T < F ? (n += z, E = T) : (n += z + 1, E > f && (E -= F)), d[++_] = --E, E == -1 ? (a += E, b[--m] = _) : a -= E, !E)
      do {
        var C = n >> 3;
        c = (t[C] | t[C + 1] << 8) >> (n & 7) & 3, n += 2, _ += c;
      } while (c == 3);
  }
  (_ > 255 || a) && p(0);
  for (var M = 0, O = (s >> 1) + (s >> 3) + 3, $ = s - 1, k = 0; k <= _; ++k) {
    var g = d[k];
    if (g < 1) {
      v[k] = -g;
      continue;
    }
    for (u = 0; u < g; ++u) {
      b[M] = k;
      do
        M = M + O & $;
      while (M >= m);
    }
  }
  for (M && p(0), u = 0; u < s; ++u) {
    var h = v[b[u]]++, R = U[u] = i - I(h);
    x[u] = (h << R) - s;
  }
  return [n + 7 >> 3, {
    b: i,
    s: b,
    n: U,
    t: x
  }];
}, ft = function(t, e) {
  var r = 0, n = -1, i = new y(292), s = t[e], a = i.subarray(0, 256), _ = i.subarray(256, 268), c = new fe(i.buffer, 268);
  if (s < 128) {
    var u = ne(t, e + 1, 6), m = u[0], w = u[1];
    e += s;
    var d = m << 3, v = t[e];
    v || p(0);
    for (var x = 0, l = 0, b = w.b, U = b, z = (++e << 3) - 8 + I(v); z -= b, !(z < d); ) {
      var S = z >> 3;
      if (x += (t[S] | t[S + 1] << 8) >> (z & 7) & (1 << b) - 1, a[++n] = w.s[x], z -= U, z < d)
        break;
      S = z >> 3, l += (t[S] | t[S + 1] << 8) >> (z & 7) & (1 << U) - 1, a[++n] = w.s[l], b = w.n[x], x = w.t[x], U = w.n[l], l = w.t[l];
    }
    ++n > 255 && p(0);
  } else {
    for (n = s - 127; r < n; r += 2) {
      var L = t[++e];
      a[r] = L >> 4, a[r + 1] = L & 15;
    }
    ++e;
  }
  var E = 0;
  for (r = 0; r < n; ++r) {
    var f = a[r];
    f > 11 && p(0), E += f && 1 << f - 1;
  }
  var F = I(E) + 1, T = 1 << F, C = T - E;
  for (C & C - 1 && p(0), a[n++] = I(C) + 1, r = 0; r < n; ++r) {
    var f = a[r];
    ++_[a[r] = f && F + 1 - f];
  }
  var M = new y(T << 1), O = M.subarray(0, T), $ = M.subarray(T);
  for (c[F] = 0, r = F; r > 0; --r) {
    var k = c[r];
    ue($, r, k, c[r - 1] = k + _[r] * (1 << F - r));
  }
  for (c[0] != T && p(0), r = 0; r < n; ++r) {
    var g = a[r];
    if (g) {
      var h = c[g];
      ue(O, r, h, c[g] = h + (1 << F - g));
    }
  }
  return [e, {
    n: $,
    b: F,
    s: O
  }];
}, ut = ne(/* @__PURE__ */ new y([
  81,
  16,
  99,
  140,
  49,
  198,
  24,
  99,
  12,
  33,
  196,
  24,
  99,
  102,
  102,
  134,
  70,
  146,
  4
]), 0, 6)[1], wt = ne(/* @__PURE__ */ new y([
  33,
  20,
  196,
  24,
  99,
  140,
  33,
  132,
  16,
  66,
  8,
  33,
  132,
  16,
  66,
  8,
  33,
  68,
  68,
  68,
  68,
  68,
  68,
  68,
  68,
  36,
  9
]), 0, 6)[1], gt = ne(/* @__PURE__ */ new y([
  32,
  132,
  16,
  66,
  102,
  70,
  68,
  68,
  68,
  68,
  36,
  73,
  2
]), 0, 5)[1], Ve = function(t, e) {
  for (var r = t.length, n = new we(r), i = 0; i < r; ++i)
    n[i] = e, e += 1 << t[i];
  return n;
}, Me = /* @__PURE__ */ new y((/* @__PURE__ */ new we([
  0,
  0,
  0,
  0,
  16843009,
  50528770,
  134678020,
  202050057,
  269422093
])).buffer, 0, 36), pt = /* @__PURE__ */ Ve(Me, 0), Re = /* @__PURE__ */ new y((/* @__PURE__ */ new we([
  0,
  0,
  0,
  0,
  0,
  0,
  0,
  0,
  16843009,
  50528770,
  117769220,
  185207048,
  252579084,
  16
])).buffer, 0, 53), dt = /* @__PURE__ */ Ve(Re, 3), Q = function(t, e, r) {
  var n = t.length, i = e.length, s = t[n - 1], a = (1 << r.b) - 1, _ = -r.b;
  s || p(0);
  for (var c = 0, u = r.b, m = (n << 3) - 8 + I(s) - u, w = -1; m > _ && w < i; ) {
    var d = m >> 3, v = (t[d] | t[d + 1] << 8 | t[d + 2] << 16) >> (m & 7);
    c = (c << u | v) & a, e[++w] = r.s[c], m -= u = r.n[c];
  }
  (m != _ || w + 1 != i) && p(0);
}, yt = function(t, e, r) {
  var n = 6, i = e.length, s = i + 3 >> 2, a = s << 1, _ = s + a;
  Q(t.subarray(n, n += t[0] | t[1] << 8), e.subarray(0, s), r), Q(t.subarray(n, n += t[2] | t[3] << 8), e.subarray(s, a), r), Q(t.subarray(n, n += t[4] | t[5] << 8), e.subarray(a, _), r), Q(t.subarray(n), e.subarray(_), r);
}, mt = function(t, e, r) {
  var n, i = e.b, s = t[i], a = s >> 1 & 3;
  e.l = s & 1;
  var _ = s >> 3 | t[i + 1] << 5 | t[i + 2] << 13, c = (i += 3) + _;
  if (a == 1)
    return i >= t.length ? void 0 : (e.b = i + 1, ue(new y(_), t[i]));
  if (!(c > t.length)) {
    if (a == 0)
      return e.b = c, be(t, i, c);
    if (a == 2) {
      var u = t[i], m = u & 3, w = u >> 2 & 3, d = u >> 4, v = 0, x = 0;
      m < 2 ? w & 1 ? d |= t[++i] << 4 | (w & 2 && t[++i] << 12) : d = u >> 3 : (x = w, w < 2 ? (d |= (t[++i] & 63) << 4, v = t[i] >> 6 | t[++i] << 2) : w == 2 ? (d |= t[++i] << 4 | (t[++i] & 3) << 12, v = t[i] >> 2 | t[++i] << 6) : (d |= t[++i] << 4 | (t[++i] & 63) << 12, v = t[i] >> 6 | t[++i] << 2 | t[++i] << 10)), ++i;
      var l = new y(e.m), b = l.length - d;
      if (m == 0)
        l.set(t.subarray(i, i += d), b);
      else if (m == 1)
        ue(l, t[i++], b);
      else {
        var U = e.h;
        if (m == 2) {
          var z = ft(t, i);
          v += i - (i = z[0]), e.h = U = z[1];
        } else U || p(0);
        (x ? yt : Q)(t.subarray(i, i += v), l.subarray(b), U);
      }
      var S = t[i++];
      if (S) {
        S == 255 ? S = (t[i++] | t[i++] << 8) + 32512 : S > 127 && (S = S - 128 << 8 | t[i++]);
        var L = t[i++];
        L & 3 && p(0);
        for (var E = [wt, gt, ut], f = 2; f > -1; --f) {
          var F = L >> (f << 1) + 2 & 3;
          if (F == 1) {
            var T = new y([0, 0, t[i++]]);
            E[f] = {
              s: T.subarray(2, 3),
              n: T.subarray(0, 1),
              t: new fe(T.buffer, 0, 1),
              b: 0
            };
          } else F == 2 ? (n = ne(t, i, 9 - (f & 1)), i = n[0], E[f] = n[1]) : F == 3 && (e.t || p(0), E[f] = e.t[f]);
        }
        var C = e.t = E, M = C[0], O = C[1], $ = C[2], k = t[c - 1];
        k || p(0);
        var g = (c << 3) - 8 + I(k) - $.b, h = g >> 3, R = 0, ie = (t[h] | t[h + 1] << 8) >> (g & 7) & (1 << $.b) - 1;
        h = (g -= O.b) >> 3;
        var se = (t[h] | t[h + 1] << 8) >> (g & 7) & (1 << O.b) - 1;
        h = (g -= M.b) >> 3;
        var oe = (t[h] | t[h + 1] << 8) >> (g & 7) & (1 << M.b) - 1;
        for (++S; --S; ) {
          var ge = $.s[ie], Ue = $.n[ie], pe = M.s[oe], Ce = M.n[oe], Oe = O.s[se], $e = O.n[se];
          h = (g -= Oe) >> 3;
          var Be = 1 << Oe, W = Be + ((t[h] | t[h + 1] << 8 | t[h + 2] << 16 | t[h + 3] << 24) >>> (g & 7) & Be - 1);
          h = (g -= Re[pe]) >> 3;
          var Y = dt[pe] + ((t[h] | t[h + 1] << 8 | t[h + 2] << 16) >> (g & 7) & (1 << Re[pe]) - 1);
          h = (g -= Me[ge]) >> 3;
          var ae = pt[ge] + ((t[h] | t[h + 1] << 8 | t[h + 2] << 16) >> (g & 7) & (1 << Me[ge]) - 1);
          if (h = (g -= Ue) >> 3, ie = $.t[ie] + ((t[h] | t[h + 1] << 8) >> (g & 7) & (1 << Ue) - 1), h = (g -= Ce) >> 3, oe = M.t[oe] + ((t[h] | t[h + 1] << 8) >> (g & 7) & (1 << Ce) - 1), h = (g -= $e) >> 3, se = O.t[se] + ((t[h] | t[h + 1] << 8) >> (g & 7) & (1 << $e) - 1), W > 3)
            e.o[2] = e.o[1], e.o[1] = e.o[0], e.o[0] = W -= 3;
          else {
            var _e = W - (ae != 0);
            _e ? (W = _e == 3 ? e.o[0] - 1 : e.o[_e], _e > 1 && (e.o[2] = e.o[1]), e.o[1] = e.o[0], e.o[0] = W) : W = e.o[0];
          }
          for (var f = 0; f < ae; ++f)
            l[R + f] = l[b + f];
          R += ae, b += ae;
          var q = R - W;
          if (q < 0) {
            var H = -q, qe = e.e + q;
            H > Y && (H = Y);
            for (var f = 0; f < H; ++f)
              l[R + f] = e.w[qe + f];
            R += H, Y -= H, q = 0;
          }
          for (var f = 0; f < Y; ++f)
            l[R + f] = l[q + f];
          R += Y;
        }
        if (R != b)
          for (; b < l.length; )
            l[R++] = l[b++];
        else
          R = l.length;
        l = be(l, 0, R);
      } else {
        var f;
        b && (l = be(l, b));
      }
      return e.b = c, l;
    }
    p(2);
  }
}, Pe = function(t, e) {
  if (t.length == 1)
    return t[0];
  for (var r = new y(e), n = 0, i = 0; n < t.length; ++n) {
    var s = t[n];
    r.set(s, i), i += s.length;
  }
  return r;
}, vt = /* @__PURE__ */ (function() {
  function t(e) {
    this.ondata = e, this.c = [], this.l = 0, this.z = 0;
  }
  return t.prototype.push = function(e, r) {
    if (typeof this.s == "number") {
      var n = Math.min(e.length, this.s);
      e = e.subarray(n), this.s -= n;
    }
    var i = e.length, s = i + this.l;
    if (!this.s) {
      if (r) {
        if (!s) {
          this.ondata(new y(0), !0);
          return;
        }
        s < 5 && p(5);
      } else if (s < 18) {
        this.c.push(e), this.l = s;
        return;
      }
      if (this.l && (this.c.push(e), e = Pe(this.c, s), this.c = [], this.l = 0), typeof (this.s = ht(e)) == "number")
        return this.push(e, r);
    }
    if (typeof this.s != "number") {
      if (s < (this.z || 3)) {
        r && p(5), this.c.push(e), this.l = s;
        return;
      }
      if (this.l && (this.c.push(e), e = Pe(this.c, s), this.c = [], this.l = 0), !this.z && s < (this.z = e[this.s.b] & 2 ? 4 : 3 + (e[this.s.b] >> 3 | e[this.s.b + 1] << 5 | e[this.s.b + 2] << 13))) {
        r && p(5), this.c.push(e), this.l = s;
        return;
      } else
        this.z = 0;
      for (; ; ) {
        var a = mt(e, this.s);
        if (a)
          this.ondata(a, !1), _t(this.s.w, 0, a.length), this.s.w.set(a, this.s.w.length - a.length);
        else {
          r && p(5);
          var _ = e.subarray(this.s.b);
          this.s.b = 0, this.c.push(_), this.l += _.length;
          return;
        }
        if (this.s.l) {
          var c = e.subarray(this.s.b);
          this.s = this.s.c * 4, this.push(c, r);
          return;
        }
      }
    } else r && p(5);
  }, t;
})();
const Ae = 65536;
async function Pt(t, e, r) {
  if (typeof t == "string" || t instanceof URL) return bt(t, e, r);
  if (t instanceof Blob) {
    const n = (i, s) => Te(t.slice(i, s).stream(), r);
    return {
      name: e ?? (t instanceof File ? t.name : ""),
      length: t.size,
      pieces: n(0, t.size),
      range: (i, s) => Promise.resolve(n(i, s))
    };
  }
  if (t instanceof ArrayBuffer) {
    const n = (i, s) => Ye(new Uint8Array(t.slice(i, s)));
    return {
      name: e ?? "",
      length: t.byteLength,
      pieces: n(0, t.byteLength),
      range: (i, s) => Promise.resolve(n(i, s))
    };
  }
  if (t instanceof ReadableStream)
    return { name: e ?? "", length: null, pieces: Te(t, r), range: null };
  throw new A("unsupported", "a model is loaded from a URL, a File, a Blob, an ArrayBuffer or a ReadableStream");
}
async function bt(t, e, r) {
  const n = At(t), s = /\.striata$/i.test(n.pathname) ? { Range: `bytes=0-${Ae - 1}` } : {};
  let a = await Se(n, s, r);
  const _ = /\/(\d+)$/.exec(a.headers.get("Content-Range") ?? "")?.[1];
  a.status === 206 && _ === void 0 && (await a.body?.cancel(), a = await Se(n, {}, r));
  const c = a.headers.has("Content-Encoding"), u = _ ?? (c ? null : a.headers.get("Content-Length")), m = a.status === 206, w = async (d, v) => {
    const x = await Se(n, { Range: `bytes=${d}-${v - 1}` }, r), l = Ee(x, r);
    return x.status === 206 ? l : Et(l, d);
  };
  return {
    name: e ?? St(n),
    length: u === null ? null : Number(u),
    pieces: m && Number(_) > Ae ? xt(Ee(a, r), () => w(Ae, Number(_))) : Ee(a, r),
    range: m ? w : null
  };
}
function At(t) {
  try {
    return new URL(t, typeof document > "u" ? void 0 : document.baseURI);
  } catch {
    throw new A("unsupported", `${String(t)} is no URL`);
  }
}
function St(t) {
  const e = t.pathname.split("/").pop() ?? "";
  try {
    return decodeURIComponent(e);
  } catch {
    return e;
  }
}
async function Se(t, e, r) {
  let n;
  try {
    n = await fetch(t, { headers: e, signal: r });
  } catch (s) {
    throw r.aborted ? s : new A(
      "network",
      `${t.href} could not be fetched: ${s instanceof Error ? s.message : String(s)}`,
      "is the server reachable, and does it allow this page to read (CORS)?"
    );
  }
  if (n.ok) return n;
  if (await n.body?.cancel(), n.status === 416) throw new A("format", `${t.href} is shorter than it should be: the file may be empty`);
  const i = n.status === 404 || n.status === 410 ? "not-found" : "network";
  throw new A(i, `${t.href}: the server says ${n.status} ${n.statusText}`.trim());
}
function Ee(t, e) {
  return t.body ? Te(t.body, e) : Ye(new Uint8Array());
}
async function* Ye(t) {
  yield t;
}
async function* Te(t, e) {
  const r = t.getReader(), n = () => void r.cancel(e.reason).catch(() => {
  });
  e.addEventListener("abort", n, { once: !0 });
  let i = !1;
  try {
    for (; ; ) {
      e.throwIfAborted();
      const { done: s, value: a } = await r.read();
      if (e.throwIfAborted(), s) break;
      yield a;
    }
    i = !0;
  } catch (s) {
    throw e.aborted || s instanceof A ? s : new A("network", `the connection broke: ${s instanceof Error ? s.message : String(s)}`);
  } finally {
    e.removeEventListener("abort", n), i || await r.cancel().catch(() => {
    });
  }
}
async function* Et(t, e) {
  try {
    for (let r = await t.next(); !r.done; r = await t.next()) {
      const n = r.value.subarray(e);
      e = Math.max(0, e - r.value.length), n.length > 0 && (yield n);
    }
  } finally {
    await t.return?.();
  }
}
async function* xt(t, e) {
  for (let r = await t.next(); !r.done; r = await t.next()) yield r.value;
  yield* ke(await e());
}
async function* Nt(t, e) {
  t.length > 0 && (yield t), yield* ke(e);
}
async function* Vt(t, e) {
  for await (const r of ke(t))
    if (yield r.subarray(0, e), e -= r.length, e <= 0) return;
}
function ke(t) {
  return { [Symbol.asyncIterator]: () => t };
}
function zt(t) {
  if (t.length === 1) return t[0];
  const e = new Uint8Array(t.reduce((n, i) => n + i.length, 0));
  let r = 0;
  for (const n of t)
    e.set(n, r), r += n.length;
  return e;
}
const Ft = 3, Mt = 1 << 30, Rt = 64 << 20, Tt = 2e3;
async function kt(t, e) {
  for (let r = 0; r < Ft; r++) {
    const n = Ut(t);
    if (!n) break;
    const i = new $t(Math.min(Mt, Math.max(Rt, t.length * Tt)), e);
    try {
      await (n === "gzip" ? Ct(t, i) : Ot(t, i));
    } catch (s) {
      throw s instanceof A ? s : new A("corrupt", `${e}: the ${n} data are damaged or cut off: ${s instanceof Error ? s.message : String(s)}`);
    }
    t = zt(i.all), e = e.replace(/\.(gz|zst)$/i, "");
  }
  return { bytes: t, name: e };
}
function Ut(t) {
  const e = (...r) => r.every((n, i) => t[i] === n);
  return e(31, 139, 8) ? "gzip" : e(40, 181, 47, 253) ? "zstd" : void 0;
}
async function Ct(t, e) {
  const n = new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip")).getReader();
  for (; ; ) {
    const { done: i, value: s } = await n.read();
    if (i) return;
    e.push(s);
  }
}
function Ot(t, e) {
  let r = !1;
  const n = new vt((s, a) => {
    e.push(s), r ||= a === !0;
  }), i = 1 << 20;
  for (let s = 0; s < t.length; s += i)
    n.push(t.subarray(s, s + i), s + i >= t.length);
  if (!r) throw new Error("they end too early");
}
class $t {
  constructor(e, r) {
    this.most = e, this.name = r;
  }
  all = [];
  #t = 0;
  push(e) {
    if (this.#t += e.length, this.#t > this.most)
      throw new A("too-large", `${this.name}: grows past ${this.most} bytes, more than a mesh can`);
    this.all.push(e.slice());
  }
}
const xe = 8192, Bt = 60, Lt = 4;
function Wt() {
  return new Promise((t) => {
    const { port1: e, port2: r } = new MessageChannel();
    e.onmessage = () => {
      e.close(), t();
    }, r.postMessage(null);
  });
}
class Yt {
  #t;
  /** Milliseconds of decoding at a stretch. */
  #p;
  #e = new P();
  #n = [];
  #i;
  #o = !1;
  #r = !1;
  #d = !1;
  /** The stream is complete, or broken off: bytes that were still on their way are dropped. */
  #a = !1;
  #y = { by: "detail", value: 1, limit: 0 };
  #_ = "surface";
  #s = "download";
  /** Vertices that the page has. */
  #m = 0;
  #v = !1;
  /** Vertices that the page's computed normals are of; normals of a coarser level are other normals. */
  #b = -1;
  #f = 0;
  #u = 0;
  #w = 0;
  #g = 0;
  #c;
  constructor(e, r) {
    this.#t = e, this.#p = r;
  }
  /** Does what the page orders. */
  take(e) {
    if (!this.#r)
      switch (e.type) {
        case "bytes":
          if (this.#a) break;
          this.#n.push(e.bytes), this.#A();
          break;
        case "end":
          if (this.#a) break;
          this.#i = e.error ? { error: e.error } : {}, this.#A();
          break;
        case "file":
          this.#M(e.bytes, e.name);
          break;
        case "show":
          this.#y = e.wish, this.#_ = e.colouring, this.#e.is_ready && this.#l(() => this.#h(e.ticket));
          break;
      }
  }
  dispose() {
    this.#d || (this.#d = !0, this.#r = !0, clearTimeout(this.#c), this.#n = [], this.#e.free());
  }
  /** Decodes what waits, then ends if nothing more comes. */
  async #A() {
    if (!this.#o) {
      for (this.#o = !0; this.#n.length > 0 && !this.#r; ) {
        this.#s = "decode";
        const e = this.#x();
        if (e) {
          this.#n = [], this.#i = { error: ve(e) };
          break;
        }
        performance.now() >= this.#g && this.#l(() => this.#S()), await Wt();
      }
      this.#o = !1, !this.#r && (this.#i ? this.#z(this.#i.error) : this.#E());
    }
  }
  /** Tells what has been decoded even if the line stalls. */
  #E() {
    clearTimeout(this.#c), this.#c = setTimeout(() => {
      !this.#o && !this.#r && !this.#a && this.#l(() => this.#S());
    }, this.#g - performance.now());
  }
  /** Decodes for a few milliseconds, and prepares views of what came; returns what is wrong with the bytes. */
  #x() {
    const e = performance.now();
    try {
      for (; performance.now() - e < this.#p; ) {
        const r = this.#n.shift();
        if (!r) break;
        this.#e.push(r.subarray(0, xe)), r.length > xe && this.#n.unshift(r.subarray(xe));
      }
      return;
    } catch (r) {
      return me(r);
    } finally {
      const r = performance.now();
      this.#f += r - e, this.#e.grow(), this.#u += performance.now() - r;
    }
  }
  #z(e) {
    let r = e;
    this.#a = !0, clearTimeout(this.#c);
    try {
      if (!r && !this.#e.is_complete && (r = { code: "corrupt", message: "the stream ends before the mesh does", hint: "was the file copied whole?" }), (r?.code !== "corrupt" || !e) && this.#F(), this.#e.reveal(), !this.#e.is_ready) throw new A("corrupt", "the stream ends before there is anything to draw");
      this.#s = "done", this.#h(0);
    } catch (n) {
      r ??= ve(me(n));
    }
    this.#i = void 0, this.#t(r ? { type: "failed", error: r } : { type: "finished" });
  }
  #F() {
    const e = performance.now();
    try {
      this.#e.finish();
    } finally {
      this.#f += performance.now() - e;
    }
  }
  /** Reads a whole file and builds its model. */
  async #M(e, r) {
    this.#s = "build";
    const n = performance.now(), i = { report: (_, c) => this.#t({ type: "building", share: c }) };
    let s, a;
    try {
      s = await kt(e, r);
    } catch (_) {
      a = _;
    }
    this.#r || this.#l(() => {
      if (!s) throw a;
      const _ = P.from_file(s.bytes, s.name, i);
      this.#e.free(), this.#e = _, this.#u = performance.now() - n, this.#s = "done", this.#h(0), this.#t({ type: "finished" });
    });
  }
  /** Reports what goes wrong; the engine then takes no more orders. */
  #l(e) {
    try {
      e();
    } catch (r) {
      this.#r = !0, this.#t({ type: "failed", error: ve(me(r)) });
    }
  }
  /**
   * Tells what has been decoded since the last update. Only updates bring new vertices and normals: answers to requests
   * in between are of what the page has already, so that many of them do not hold decoding up.
   */
  #S() {
    this.#e.reveal(), this.#e.is_ready && this.#h(0);
  }
  /** Shows what is wished for, and tells it with what is new. */
  #h(e) {
    const r = performance.now(), n = this.#R(), i = this.#k(), s = this.#U(), a = this.#C(), _ = this.#e, [c, u] = [_.indices(), _.group_counts()];
    this.#w = performance.now() - r, this.#g = performance.now() + Math.max(Bt, Lt * this.#w);
    const w = {
      type: "update",
      state: this.#O(),
      vertices: s,
      smoothNormals: a,
      indices: c,
      groupCounts: u,
      numbers: i,
      settled: n,
      ticket: e
    };
    this.#t(w);
  }
  /** Goes to the level that is wished for; whether asking again would show the same. */
  #R() {
    const { by: e, value: r, limit: n, camera: i } = this.#y, s = this.#e;
    if (e === "view" && i) return this.#T(i, r, n);
    e === "triangles" ? s.show_triangles(r) : e === "error" ? s.show_error(r) : s.show_detail(e === "detail" ? r : 1);
    const a = s.group_counts().reduce((_, c) => _ + c, 0);
    return n > 0 && a > n && s.show_triangles(n), !0;
  }
  /** A camera that sees nothing leaves what is shown: another may see more. */
  #T(e, r, n) {
    const i = new he(Float64Array.from(e), r, n);
    try {
      return this.#e.show_view(i);
    } catch (s) {
      if (!(s instanceof j)) throw s;
      return s.free(), !0;
    } finally {
      i.free();
    }
  }
  #k() {
    if (this.#_ === "strips") return this.#e.color_strips();
    if (this.#_ === "fans") return this.#e.color_fans();
    if (this.#_ === "surface") return;
    const e = this.#e.group_counts().reduce((r, n) => r + n, 0);
    return Uint32Array.from({ length: e }, (r, n) => n);
  }
  #U() {
    const e = this.#m;
    if (this.#e.vertex_count === e) return;
    const r = this.#e.vertices(e);
    try {
      const n = r.take_normals();
      return this.#v = n !== void 0, this.#m = this.#e.vertex_count, { first: e, positions: r.take_positions(), normals: n, colors: r.take_colors(), uvs: r.take_uvs() };
    } finally {
      r.free();
    }
  }
  #C() {
    if (!(this.#v || this.#b === this.#e.vertex_count))
      return this.#b = this.#e.vertex_count, this.#e.smooth_normals();
  }
  #O() {
    const e = this.#e;
    return {
      kind: e.kind,
      phase: this.#s,
      complete: e.is_complete,
      vertexCount: e.vertex_count,
      triangleCount: e.triangle_count,
      fullVertexCount: e.full_vertex_count,
      fullTriangleCount: e.full_triangle_count,
      stepCount: e.step_count,
      streamBytes: e.stream_bytes,
      bounds: e.bounds(),
      diagonal: e.diagonal,
      shownSplitCount: e.shown_split_count,
      shownError: e.shown_error,
      decodeMs: this.#f,
      buildMs: this.#u,
      updateMs: this.#w
    };
  }
}
const ze = /* @__PURE__ */ new Map();
let Ne = !1;
function qt(t) {
  const e = t instanceof URL ? t.href : t;
  let r = ze.get(e);
  return r || (r = Dt(t), r.catch(() => ze.delete(e)), ze.set(e, r)), r;
}
function Ht(t) {
  Ne || it({ module: t }), Ne = !0;
}
async function Dt(t) {
  if (t instanceof WebAssembly.Module) return t;
  if (t !== void 0 && typeof t != "string" && !(t instanceof URL))
    return WebAssembly.compile(t);
  const e = t === void 0 ? It() : void 0;
  if (e) return WebAssembly.compile(e);
  const r = t ?? new URL(
    /* @vite-ignore */
    "striata.wasm",
    import.meta.url
  ), n = await fetch(r).catch((i) => {
    throw new A("network", `striata.wasm could not be fetched: ${String(i)}`);
  });
  if (!n.ok)
    throw new A(
      n.status === 404 ? "not-found" : "network",
      `striata.wasm could not be fetched from ${String(r)}: the server says ${n.status}`,
      "it lies beside striata.js in the package; the option `wasm` says where else"
    );
  return WebAssembly.compile(await n.arrayBuffer());
}
function It() {
  if (typeof document > "u") return;
  const t = document.getElementById("striata-wasm")?.textContent?.trim();
  return t ? Uint8Array.from(atob(t), (e) => e.charCodeAt(0)) : void 0;
}
export {
  Yt as E,
  j as F,
  P as M,
  te as S,
  re as V,
  A as a,
  he as b,
  me as c,
  zt as d,
  Et as e,
  ve as f,
  st as g,
  jt as h,
  ke as i,
  Vt as l,
  Pt as o,
  Nt as p,
  Ht as s,
  qt as w
};
