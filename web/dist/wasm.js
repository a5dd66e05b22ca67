class v {
  static __wrap(t) {
    const e = Object.create(v.prototype);
    return e.__wbg_ptr = t, B.register(e, e.__wbg_ptr, e), e;
  }
  __destroy_into_raw() {
    const t = this.__wbg_ptr;
    return this.__wbg_ptr = 0, B.unregister(this), t;
  }
  free() {
    const t = this.__destroy_into_raw();
    r.__wbg_failure_free(t, 0);
  }
  /**
  * `format`, `corrupt`, `too-large` or `unsupported`.
  * @returns {string}
  */
  get code() {
    let t, e;
    try {
      const o = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.failure_code(o, this.__wbg_ptr);
      var _ = i().getInt32(o + 0, !0), s = i().getInt32(o + 4, !0);
      return t = _, e = s, m(_, s);
    } finally {
      r.__wbindgen_add_to_stack_pointer(16), r.__wbindgen_export(t, e, 1);
    }
  }
  /**
   * What may help.
   * @returns {string | undefined}
   */
  get hint() {
    try {
      const _ = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.failure_hint(_, this.__wbg_ptr);
      var t = i().getInt32(_ + 0, !0), e = i().getInt32(_ + 4, !0);
      let s;
      return t !== 0 && (s = m(t, e), r.__wbindgen_export(t, e * 1, 1)), s;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * One sentence.
   * @returns {string}
   */
  get message() {
    let t, e;
    try {
      const o = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.failure_message(o, this.__wbg_ptr);
      var _ = i().getInt32(o + 0, !0), s = i().getInt32(o + 4, !0);
      return t = _, e = s, m(_, s);
    } finally {
      r.__wbindgen_add_to_stack_pointer(16), r.__wbindgen_export(t, e, 1);
    }
  }
}
Symbol.dispose && (v.prototype[Symbol.dispose] = v.prototype.free);
class b {
  static __wrap(t) {
    const e = Object.create(b.prototype);
    return e.__wbg_ptr = t, T.register(e, e.__wbg_ptr, e), e;
  }
  __destroy_into_raw() {
    const t = this.__wbg_ptr;
    return this.__wbg_ptr = 0, T.unregister(this), t;
  }
  free() {
    const t = this.__destroy_into_raw();
    r.__wbg_model_free(t, 0);
  }
  /**
  * The smallest and the largest coordinates that are there; empty where nothing is.
  * @returns {Float32Array}
  */
  bounds() {
    try {
      const s = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.model_bounds(s, this.__wbg_ptr);
      var t = i().getInt32(s + 0, !0), e = i().getInt32(s + 4, !0), _ = F(t, e).slice();
      return r.__wbindgen_export(t, e * 4, 4), _;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Makes what views are taken from, of what has come. No more bytes can be pushed then.
   *
   * # Errors
   * Where too little has come.
   */
  build() {
    try {
      const _ = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.model_build(_, this.__wbg_ptr);
      var t = i().getInt32(_ + 0, !0), e = i().getInt32(_ + 4, !0);
      if (e)
        throw g(t);
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Puts the triangles that are shown into the order of fans, and tells the fan of each. Before the model is built: the
   * vertex that they turn around.
   * @returns {Uint32Array}
   */
  color_fans() {
    try {
      const s = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.model_color_fans(s, this.__wbg_ptr);
      var t = i().getInt32(s + 0, !0), e = i().getInt32(s + 4, !0), _ = R(t, e).slice();
      return r.__wbindgen_export(t, e * 4, 4), _;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Puts the triangles that are shown into the order of strips made of them, and tells the strip of each.
   *
   * # Errors
   * Where no strips can be made.
   * @returns {Uint32Array}
   */
  color_strips() {
    try {
      const a = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.model_color_strips(a, this.__wbg_ptr);
      var t = i().getInt32(a + 0, !0), e = i().getInt32(a + 4, !0), _ = i().getInt32(a + 8, !0), s = i().getInt32(a + 12, !0);
      if (s)
        throw g(_);
      var o = R(t, e).slice();
      return r.__wbindgen_export(t, e * 4, 4), o;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Diagonal of these bounds, mesh units.
   * @returns {number}
   */
  get diagonal() {
    return r.model_diagonal(this.__wbg_ptr);
  }
  /**
   * No more bytes will come: reads what an incomplete rest of them tells.
   *
   * # Errors
   * Where there is no mesh without what is missing.
   */
  finish() {
    try {
      const _ = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.model_finish(_, this.__wbg_ptr);
      var t = i().getInt32(_ + 0, !0), e = i().getInt32(_ + 4, !0);
      if (e)
        throw g(t);
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Reads a whole file and builds its model; plain meshes are simplified, which takes a second or two for each 100,000
   * triangles. What is shown is all of it.
   *
   * # Errors
   * Where the bytes are damaged, of no kind that is known, or too much for a page.
   * @param {Uint8Array | number[]} bytes
   * @param {string} name
   * @param {{ report(phase: string, share: number): void }} sink
   * @returns {Model}
   */
  static from_file(t, e, _) {
    try {
      const c = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      let l, p, h, f;
      try {
        l = V(t, r.__wbindgen_export3), p = u, h = Z(e, r.__wbindgen_export3, r.__wbindgen_export4), f = u;
      } catch (Y) {
        throw h && r.__wbindgen_export(h, f * 1, 1), l && r.__wbindgen_export(l, p * 1, 1), Y;
      }
      r.model_from_file(c, l, p, h, f, _);
      var s = i().getInt32(c + 0, !0), o = i().getInt32(c + 4, !0), a = i().getInt32(c + 8, !0);
      if (a)
        throw g(o);
      return b.__wrap(s);
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Triangles that there will be; 0 as long as nobody has told.
   * @returns {number}
   */
  get full_triangle_count() {
    return r.model_full_triangle_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Vertices that there will be; 0 as long as nobody has told.
   * @returns {number}
   */
  get full_vertex_count() {
    return r.model_full_vertex_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Groups of triangles, at least one.
   * @returns {number}
   */
  get group_count() {
    return r.model_group_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Triangles of each group that are shown.
   * @returns {Uint32Array}
   */
  group_counts() {
    try {
      const s = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.model_group_counts(s, this.__wbg_ptr);
      var t = i().getInt32(s + 0, !0), e = i().getInt32(s + 4, !0), _ = R(t, e).slice();
      return r.__wbindgen_export(t, e * 4, 4), _;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Corners of the triangles that are shown, group after group.
   * @returns {Uint32Array}
   */
  indices() {
    try {
      const s = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.model_indices(s, this.__wbg_ptr);
      var t = i().getInt32(s + 0, !0), e = i().getInt32(s + 4, !0), _ = R(t, e).slice();
      return r.__wbindgen_export(t, e * 4, 4), _;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Whether views can be shown.
   * @returns {boolean}
   */
  get is_built() {
    return r.model_is_built(this.__wbg_ptr) !== 0;
  }
  /**
   * Whether all of the mesh is there.
   * @returns {boolean}
   */
  get is_complete() {
    return r.model_is_complete(this.__wbg_ptr) !== 0;
  }
  /**
   * Whether there is something to show.
   * @returns {boolean}
   */
  get is_ready() {
    return r.model_is_ready(this.__wbg_ptr) !== 0;
  }
  /**
   * `stream`, `striata` or `mesh`: what the bytes were.
   * @returns {string}
   */
  get kind() {
    let t, e;
    try {
      const o = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.model_kind(o, this.__wbg_ptr);
      var _ = i().getInt32(o + 0, !0), s = i().getInt32(o + 4, !0);
      return t = _, e = s, m(_, s);
    } finally {
      r.__wbindgen_add_to_stack_pointer(16), r.__wbindgen_export(t, e, 1);
    }
  }
  /**
   * A model without any bytes yet, for a stream.
   */
  constructor() {
    const t = r.model_new();
    return this.__wbg_ptr = t, T.register(this, this.__wbg_ptr, this), this;
  }
  /**
   * Takes the next bytes of a stream and decodes what is whole.
   *
   * # Errors
   * Where they are no sound stream, or the whole would not fit into a page. What came before stays.
   * @param {Uint8Array | number[]} bytes
   */
  push(t) {
    try {
      const s = r.__wbindgen_add_to_stack_pointer(-16) >>> 0, o = V(t, r.__wbindgen_export3), a = u;
      r.model_push(s, this.__wbg_ptr, o, a);
      var e = i().getInt32(s + 0, !0), _ = i().getInt32(s + 4, !0);
      if (_)
        throw g(e);
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Shows a level by its detail, 0 to 1 of the full mesh.
   * @param {number} detail
   */
  show_detail(t) {
    r.model_show_detail(this.__wbg_ptr, t);
  }
  /**
   * Shows the coarsest level that is no farther off, mesh units.
   * @param {number} most
   */
  show_error(t) {
    r.model_show_error(this.__wbg_ptr, t);
  }
  /**
   * Shows the finest level of no more triangles.
   * @param {number} most
   */
  show_triangles(t) {
    r.model_show_triangles(this.__wbg_ptr, t);
  }
  /**
   * Shows what a view asks for; false where asking once more would show more of it.
   *
   * # Errors
   * Where the model is not built, or the camera sees nothing.
   * @param {View} view
   * @returns {boolean}
   */
  show_view(t) {
    try {
      const o = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      H(t, z), r.model_show_view(o, this.__wbg_ptr, t.__wbg_ptr);
      var e = i().getInt32(o + 0, !0), _ = i().getInt32(o + 4, !0), s = i().getInt32(o + 8, !0);
      if (s)
        throw g(_);
      return e !== 0;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * How far what is shown is from the full mesh, where it is farthest, mesh units.
   * @returns {number}
   */
  get shown_error() {
    return r.model_shown_error(this.__wbg_ptr);
  }
  /**
   * Vertex splits that are shown.
   * @returns {number}
   */
  get shown_split_count() {
    return r.model_shown_split_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Normals of all vertices that are there, made from the finest level of what has come.
   * @returns {Float32Array}
   */
  smooth_normals() {
    try {
      const s = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.model_smooth_normals(s, this.__wbg_ptr);
      var t = i().getInt32(s + 0, !0), e = i().getInt32(s + 4, !0), _ = F(t, e).slice();
      return r.__wbindgen_export(t, e * 4, 4), _;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Vertex splits from the base to the full mesh.
   * @returns {number}
   */
  get step_count() {
    return r.model_step_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Bytes of the whole stream; 0 as long as nobody has told.
   * @returns {number}
   */
  get stream_bytes() {
    return r.model_stream_bytes(this.__wbg_ptr);
  }
  /**
   * Triangles of the finest level that is there.
   * @returns {number}
   */
  get triangle_count() {
    return r.model_triangle_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Vertices that are there.
   * @returns {number}
   */
  get vertex_count() {
    return r.model_vertex_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Vertices from one on.
   * @param {number} first
   * @returns {Vertices}
   */
  vertices(t) {
    const e = r.model_vertices(this.__wbg_ptr, t);
    return S.__wrap(e);
  }
}
Symbol.dispose && (b.prototype[Symbol.dispose] = b.prototype.free);
class E {
  static __wrap(t) {
    const e = Object.create(E.prototype);
    return e.__wbg_ptr = t, L.register(e, e.__wbg_ptr, e), e;
  }
  __destroy_into_raw() {
    const t = this.__wbg_ptr;
    return this.__wbg_ptr = 0, L.unregister(this), t;
  }
  free() {
    const t = this.__destroy_into_raw();
    r.__wbg_streamplace_free(t, 0);
  }
  /**
  * Its bytes; 0 if the file has no stream.
  * @returns {number}
  */
  get length() {
    return r.__wbg_get_streamplace_length(this.__wbg_ptr);
  }
  /**
   * First bytes of the file that it takes to know; more than were given: ask again with so many.
   * @returns {number}
   */
  get needed() {
    return r.__wbg_get_streamplace_needed(this.__wbg_ptr);
  }
  /**
   * Where the stream begins, bytes from the file's beginning.
   * @returns {number}
   */
  get offset() {
    return r.__wbg_get_streamplace_offset(this.__wbg_ptr);
  }
  /**
   * Its bytes; 0 if the file has no stream.
   * @param {number} arg0
   */
  set length(t) {
    r.__wbg_set_streamplace_length(this.__wbg_ptr, t);
  }
  /**
   * First bytes of the file that it takes to know; more than were given: ask again with so many.
   * @param {number} arg0
   */
  set needed(t) {
    r.__wbg_set_streamplace_needed(this.__wbg_ptr, t);
  }
  /**
   * Where the stream begins, bytes from the file's beginning.
   * @param {number} arg0
   */
  set offset(t) {
    r.__wbg_set_streamplace_offset(this.__wbg_ptr, t);
  }
  /**
   * Looks for the stream of a `.striata` file.
   *
   * # Errors
   * Where the bytes begin no `.striata` file, or its header is damaged.
   * @param {Uint8Array | number[]} head
   * @returns {StreamPlace}
   */
  static find(t) {
    try {
      const o = r.__wbindgen_add_to_stack_pointer(-16) >>> 0, a = V(t, r.__wbindgen_export3), c = u;
      r.streamplace_find(o, a, c);
      var e = i().getInt32(o + 0, !0), _ = i().getInt32(o + 4, !0), s = i().getInt32(o + 8, !0);
      if (s)
        throw g(_);
      return E.__wrap(e);
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
}
Symbol.dispose && (E.prototype[Symbol.dispose] = E.prototype.free);
class S {
  static __wrap(t) {
    const e = Object.create(S.prototype);
    return e.__wbg_ptr = t, P.register(e, e.__wbg_ptr, e), e;
  }
  __destroy_into_raw() {
    const t = this.__wbg_ptr;
    return this.__wbg_ptr = 0, P.unregister(this), t;
  }
  free() {
    const t = this.__destroy_into_raw();
    r.__wbg_vertices_free(t, 0);
  }
  /**
  * Red, green, blue and alpha a vertex, if the mesh has colours.
  * @returns {Uint8Array | undefined}
  */
  take_colors() {
    try {
      const _ = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.vertices_take_colors(_, this.__wbg_ptr);
      var t = i().getInt32(_ + 0, !0), e = i().getInt32(_ + 4, !0);
      let s;
      return t !== 0 && (s = X(t, e).slice(), r.__wbindgen_export(t, e * 1, 1)), s;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Three numbers a vertex, if the mesh has normals.
   * @returns {Float32Array | undefined}
   */
  take_normals() {
    try {
      const _ = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.vertices_take_normals(_, this.__wbg_ptr);
      var t = i().getInt32(_ + 0, !0), e = i().getInt32(_ + 4, !0);
      let s;
      return t !== 0 && (s = F(t, e).slice(), r.__wbindgen_export(t, e * 4, 4)), s;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Three numbers a vertex, mesh units.
   * @returns {Float32Array}
   */
  take_positions() {
    try {
      const s = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.vertices_take_positions(s, this.__wbg_ptr);
      var t = i().getInt32(s + 0, !0), e = i().getInt32(s + 4, !0), _ = F(t, e).slice();
      return r.__wbindgen_export(t, e * 4, 4), _;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Two numbers a vertex, `v` downwards, if the mesh has texture coordinates.
   * @returns {Float32Array | undefined}
   */
  take_uvs() {
    try {
      const _ = r.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      r.vertices_take_uvs(_, this.__wbg_ptr);
      var t = i().getInt32(_ + 0, !0), e = i().getInt32(_ + 4, !0);
      let s;
      return t !== 0 && (s = F(t, e).slice(), r.__wbindgen_export(t, e * 4, 4)), s;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
}
Symbol.dispose && (S.prototype[Symbol.dispose] = S.prototype.free);
class z {
  __destroy_into_raw() {
    const t = this.__wbg_ptr;
    return this.__wbg_ptr = 0, N.unregister(this), t;
  }
  free() {
    const t = this.__destroy_into_raw();
    r.__wbg_view_free(t, 0);
  }
  /**
  * Pixels that anything may be off.
  * @returns {number}
  */
  get pixels() {
    return r.__wbg_get_view_pixels(this.__wbg_ptr);
  }
  /**
   * Triangles that are shown at most; 0 for no limit.
   * @returns {number}
   */
  get triangle_limit() {
    return r.__wbg_get_view_triangle_limit(this.__wbg_ptr) >>> 0;
  }
  /**
   * Pixels that anything may be off.
   * @param {number} arg0
   */
  set pixels(t) {
    r.__wbg_set_view_pixels(this.__wbg_ptr, t);
  }
  /**
   * Triangles that are shown at most; 0 for no limit.
   * @param {number} arg0
   */
  set triangle_limit(t) {
    r.__wbg_set_view_triangle_limit(this.__wbg_ptr, t);
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
  constructor(t, e, _) {
    try {
      const c = r.__wbindgen_add_to_stack_pointer(-16) >>> 0, l = +e, p = +_, h = Q(t, r.__wbindgen_export3), f = u;
      r.view_new(c, h, f, l, p);
      var s = i().getInt32(c + 0, !0), o = i().getInt32(c + 4, !0), a = i().getInt32(c + 8, !0);
      if (a)
        throw g(o);
      return this.__wbg_ptr = s, N.register(this, this.__wbg_ptr, this), this;
    } finally {
      r.__wbindgen_add_to_stack_pointer(16);
    }
  }
}
Symbol.dispose && (z.prototype[Symbol.dispose] = z.prototype.free);
function q() {
  return {
    __proto__: null,
    "./striata_web_bg.js": {
      __proto__: null,
      __wbg___wbindgen_throw_4c88d8bf264fd984: function(t, e) {
        throw new Error(m(t, e));
      },
      __wbg_failure_new: function(t) {
        return v.__wrap(t);
      },
      __wbg_report_581358a93077c908: function(t, e, _, s) {
        t.report(m(e, _), s);
      },
      __wbindgen_init_externref_table: function() {
        const t = r.__wbindgen_externrefs;
        t.set(0, void 0), t.set(1024, void 0), t.set(1025, null), t.set(1026, !0), t.set(1027, !1);
      }
    }
  };
}
const B = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((n) => r.__wbg_failure_free(n, 1)), T = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((n) => r.__wbg_model_free(n, 1)), L = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((n) => r.__wbg_streamplace_free(n, 1)), P = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((n) => r.__wbg_vertices_free(n, 1)), N = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((n) => r.__wbg_view_free(n, 1));
function H(n, t) {
  if (!(n instanceof t))
    throw new Error(`expected instance of ${t.name}`);
}
function F(n, t) {
  return n = n >>> 0, G().subarray(n / 4, n / 4 + t);
}
function R(n, t) {
  return n = n >>> 0, K().subarray(n / 4, n / 4 + t);
}
function X(n, t) {
  return n = n >>> 0, y().subarray(n / 1, n / 1 + t);
}
let w = null;
function i() {
  return (w === null || w.buffer.detached === !0 || w.buffer.detached === void 0 && w.buffer !== r.memory.buffer) && (w = new DataView(r.memory.buffer)), w;
}
let k = null;
function G() {
  return (k === null || k.byteLength === 0) && (k = new Float32Array(r.memory.buffer)), k;
}
let x = null;
function J() {
  return (x === null || x.byteLength === 0) && (x = new Float64Array(r.memory.buffer)), x;
}
function m(n, t) {
  return n = n >>> 0, et(y().subarray(n, n + t));
}
let I = null;
function K() {
  return (I === null || I.byteLength === 0) && (I = new Uint32Array(r.memory.buffer)), I;
}
let A = null;
function y() {
  return (A === null || A.byteLength === 0) && (A = new Uint8Array(r.memory.buffer)), A;
}
function V(n, t) {
  const e = t(n.length * 1, 1) >>> 0;
  return y().set(n, e / 1), u = n.length, e;
}
function Q(n, t) {
  const e = t(n.length * 8, 8) >>> 0;
  return J().set(n, e / 8), u = n.length, e;
}
function Z(n, t, e) {
  if (e === void 0) {
    const c = M.encode(n), l = t(c.length, 1) >>> 0;
    return y().subarray(l, l + c.length).set(c), u = c.length, l;
  }
  let _ = n.length, s = t(_, 1) >>> 0;
  const o = y();
  let a = 0;
  for (; a < _; a++) {
    const c = n.charCodeAt(a);
    if (c > 127) break;
    o[s + a] = c;
  }
  if (a !== _) {
    a !== 0 && (n = n.slice(a)), s = e(s, _, _ = a + n.length * 3, 1) >>> 0;
    const c = y().subarray(s + a, s + _), l = M.encodeInto(n, c);
    a += l.written, s = e(s, _, a, 1) >>> 0;
  }
  return u = a, s;
}
function g(n) {
  const t = r.__wbindgen_externrefs.get(n);
  return r.__wbindgen_export2(n), t;
}
let C = new TextDecoder("utf-8", { ignoreBOM: !0 });
C.decode();
const tt = 2146435072;
let U = 0;
function et(n) {
  return U += n.length, U >= tt && (C = new TextDecoder("utf-8", { ignoreBOM: !0 }), C.decode(), U = n.length), C.decode(n);
}
const M = new TextEncoder();
"encodeInto" in M || (M.encodeInto = function(n, t) {
  const e = M.encode(n);
  return t.set(e), {
    read: n.length,
    written: e.length
  };
});
let u = 0, r;
function rt(n, t) {
  return r = n.exports, w = null, k = null, x = null, I = null, A = null, r.__wbindgen_start(), r;
}
function nt(n) {
  if (r !== void 0) return r;
  n !== void 0 && (Object.getPrototypeOf(n) === Object.prototype ? { module: n } = n : console.warn("using deprecated parameters for `initSync()`; pass a single object instead"));
  const t = q();
  n instanceof WebAssembly.Module || (n = new WebAssembly.Module(n));
  const e = new WebAssembly.Instance(n, t);
  return rt(e);
}
class d extends Error {
  code;
  hint;
  constructor(t, e, _) {
    super(e), this.name = "StriataError", this.code = t, this.hint = _;
  }
}
function W(n) {
  if (n instanceof d) return n;
  if (n instanceof v) {
    const e = new d(n.code, n.message, n.hint);
    return n.free(), e;
  }
  if (n instanceof WebAssembly.RuntimeError || n instanceof RangeError)
    return new d(
      "too-large",
      "the model took more memory than the page has",
      "close other pages, or load a stream with fewer triangles"
    );
  if (n instanceof DOMException && n.name === "AbortError") return _t();
  const t = n instanceof Error ? n.message : String(n);
  return new d("network", t);
}
function _t() {
  return new d("aborted", "loading was aborted");
}
function O(n) {
  return { code: n.code, message: n.message, hint: n.hint };
}
function lt(n) {
  return new d(n.code, n.message, n.hint);
}
const j = 8192, st = 60, it = 4;
function ot() {
  return new Promise((n) => {
    const { port1: t, port2: e } = new MessageChannel();
    t.onmessage = () => {
      t.close(), n();
    }, e.postMessage(null);
  });
}
class dt {
  #e;
  /** Milliseconds of decoding at a stretch. */
  #p;
  #t = new b();
  #r = [];
  #_;
  #c = !1;
  #s = !1;
  #h = { by: "detail", value: 1, limit: 0 };
  #a = "surface";
  #n = "download";
  /** Vertices that the page has. */
  #f = 0;
  #w = !1;
  /** Vertices that the page's computed normals are of; normals of a coarser level are other normals. */
  #b = -1;
  #l = 0;
  #d = 0;
  #u = 0;
  #m = 0;
  /** What the head promised, once the decoder is gone. */
  #i = { vertices: 0, triangles: 0, steps: 0, bytes: 0 };
  constructor(t, e) {
    this.#e = t, this.#p = e;
  }
  /** Does what the page orders. */
  take(t) {
    if (!this.#s)
      switch (t.type) {
        case "bytes":
          this.#r.push(t.bytes), this.#y();
          break;
        case "end":
          this.#_ = t.error ? { error: t.error } : {}, this.#y();
          break;
        case "file":
          this.#I(t.bytes, t.name);
          break;
        case "show":
          this.#h = t.wish, this.#a = t.colouring, this.#t.is_ready && this.#g(() => this.#o(t.ticket));
          break;
      }
  }
  dispose() {
    this.#s = !0, this.#r = [], this.#t.free();
  }
  /** Decodes what waits, then ends if nothing more comes. */
  async #y() {
    if (!this.#c) {
      for (this.#c = !0; this.#r.length > 0 && !this.#s; ) {
        this.#n = "decode";
        const t = this.#v();
        if (t) {
          this.#r = [], this.#_ = { error: O(t) };
          break;
        }
        this.#t.is_ready && performance.now() >= this.#m && this.#g(() => this.#o(0)), await ot();
      }
      this.#c = !1, this.#_ && !this.#s && this.#k(this.#_.error);
    }
  }
  /** Decodes for a few milliseconds; returns what is wrong with the bytes. */
  #v() {
    const t = performance.now();
    try {
      for (; performance.now() - t < this.#p; ) {
        const e = this.#r.shift();
        if (!e) break;
        this.#t.push(e.subarray(0, j)), e.length > j && this.#r.unshift(e.subarray(j));
      }
      return;
    } catch (e) {
      return W(e);
    } finally {
      this.#l += performance.now() - t;
    }
  }
  #k(t) {
    let e = t;
    try {
      if (!e && !this.#t.is_complete && (e = { code: "corrupt", message: "the stream ends before the mesh does", hint: "was the file copied whole?" }), (e?.code !== "corrupt" || !t) && this.#x(), !this.#t.is_ready) throw new d("corrupt", "the stream ends before there is anything to draw");
      this.#A(), this.#n = "build", this.#o(0), this.#e({ type: "building", share: 0 });
      const _ = performance.now();
      this.#t.build(), this.#d = performance.now() - _, this.#n = "done", this.#o(0);
    } catch (_) {
      e ??= O(W(_));
    }
    this.#_ = void 0, this.#e(e ? { type: "failed", error: e } : { type: "finished" });
  }
  #x() {
    const t = performance.now();
    try {
      this.#t.finish();
    } finally {
      this.#l += performance.now() - t;
    }
  }
  /** Reads a whole file and builds its model. */
  #I(t, e) {
    this.#n = "build";
    const _ = performance.now(), s = { report: (o, a) => this.#e({ type: "building", share: a }) };
    this.#g(() => {
      const o = b.from_file(t, e, s);
      this.#t.free(), this.#t = o, this.#d = performance.now() - _, this.#n = "done", this.#o(0), this.#e({ type: "finished" });
    });
  }
  /** Reports what goes wrong; the engine then takes no more orders. */
  #g(t) {
    try {
      t();
    } catch (e) {
      this.#s = !0, this.#e({ type: "failed", error: O(W(e)) });
    }
  }
  #A() {
    const t = this.#t;
    this.#i = {
      vertices: t.full_vertex_count,
      triangles: t.full_triangle_count,
      steps: t.step_count,
      bytes: t.stream_bytes
    };
  }
  /** Shows what is wished for, and tells it with what is new. */
  #o(t) {
    const e = performance.now(), _ = this.#F(), s = this.#M(), o = this.#E(), a = this.#S(), c = this.#t, [l, p] = [c.indices(), c.group_counts()];
    this.#u = performance.now() - e, this.#m = performance.now() + Math.max(st, it * this.#u);
    const f = {
      type: "update",
      state: this.#R(),
      vertices: o,
      smoothNormals: a,
      indices: l,
      groupCounts: p,
      numbers: s,
      settled: _,
      ticket: t
    };
    this.#e(f);
  }
  /** Goes to the level that is wished for; whether asking again would show the same. */
  #F() {
    const { by: t, value: e, limit: _, camera: s } = this.#h, o = this.#t;
    if (t === "view" && o.is_built && s) {
      const c = new z(Float64Array.from(s), e, _);
      try {
        return o.show_view(c);
      } finally {
        c.free();
      }
    }
    t === "triangles" ? o.show_triangles(e) : t === "error" ? o.show_error(e) : o.show_detail(t === "detail" ? e : 1);
    const a = o.group_counts().reduce((c, l) => c + l, 0);
    return _ > 0 && a > _ && o.show_triangles(_), !0;
  }
  #M() {
    if (this.#a === "strips") return this.#t.color_strips();
    if (this.#a === "fans") return this.#t.color_fans();
    if (this.#a === "surface") return;
    const t = this.#t.group_counts().reduce((e, _) => e + _, 0);
    return Uint32Array.from({ length: t }, (e, _) => _);
  }
  #E() {
    const t = this.#f;
    if (this.#t.vertex_count === t) return;
    const e = this.#t.vertices(t);
    try {
      const _ = e.take_normals();
      return this.#w = _ !== void 0, this.#f = this.#t.vertex_count, { first: t, positions: e.take_positions(), normals: _, colors: e.take_colors(), uvs: e.take_uvs() };
    } finally {
      e.free();
    }
  }
  #S() {
    if (!(this.#w || this.#b === this.#t.vertex_count))
      return this.#b = this.#t.vertex_count, this.#t.smooth_normals();
  }
  #R() {
    const t = this.#t;
    return {
      kind: t.kind,
      phase: this.#n,
      complete: t.is_complete,
      built: t.is_built,
      vertexCount: t.vertex_count,
      triangleCount: t.triangle_count,
      fullVertexCount: this.#i.vertices || t.full_vertex_count,
      fullTriangleCount: this.#i.triangles || t.full_triangle_count,
      stepCount: this.#i.steps || t.step_count,
      streamBytes: this.#i.bytes || t.stream_bytes,
      bounds: t.bounds(),
      diagonal: t.diagonal,
      shownSplitCount: t.shown_split_count,
      shownError: t.shown_error,
      decodeMs: this.#l,
      buildMs: this.#d,
      updateMs: this.#u
    };
  }
}
const D = /* @__PURE__ */ new Map();
let $ = !1;
function ut(n) {
  const t = n instanceof URL ? n.href : n;
  let e = D.get(t);
  return e || (e = at(n), e.catch(() => D.delete(t)), D.set(t, e)), e;
}
function gt(n) {
  $ || nt({ module: n }), $ = !0;
}
async function at(n) {
  if (n instanceof WebAssembly.Module) return n;
  if (n !== void 0 && typeof n != "string" && !(n instanceof URL))
    return WebAssembly.compile(n);
  const t = n === void 0 ? ct() : void 0;
  if (t) return WebAssembly.compile(t);
  const e = n ?? new URL(
    /* @vite-ignore */
    "striata.wasm",
    import.meta.url
  ), _ = await fetch(e).catch((s) => {
    throw new d("network", `striata.wasm could not be fetched: ${String(s)}`);
  });
  if (!_.ok)
    throw new d(
      _.status === 404 ? "not-found" : "network",
      `striata.wasm could not be fetched from ${String(e)}: the server says ${_.status}`,
      "it lies beside striata.js in the package; the option `wasm` says where else"
    );
  return WebAssembly.compile(await _.arrayBuffer());
}
function ct() {
  if (typeof document > "u") return;
  const n = document.getElementById("striata-wasm")?.textContent?.trim();
  return n ? Uint8Array.from(atob(n), (t) => t.charCodeAt(0)) : void 0;
}
export {
  dt as E,
  v as F,
  b as M,
  E as S,
  S as V,
  d as a,
  z as b,
  W as c,
  O as d,
  _t as e,
  lt as f,
  gt as s,
  ut as w
};
