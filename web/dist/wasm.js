class q {
  static __wrap(e) {
    const r = Object.create(q.prototype);
    return r.__wbg_ptr = e, We.register(r, r.__wbg_ptr, r), r;
  }
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, We.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    s.__wbg_failure_free(e, 0);
  }
  /**
  * `format`, `corrupt`, `too-large` or `unsupported`.
  * @returns {string}
  */
  get code() {
    let e, r;
    try {
      const o = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.failure_code(o, this.__wbg_ptr);
      var n = l().getInt32(o + 0, !0), i = l().getInt32(o + 4, !0);
      return e = n, r = i, N(n, i);
    } finally {
      s.__wbindgen_add_to_stack_pointer(16), s.__wbindgen_export(e, r, 1);
    }
  }
  /**
   * What may help.
   * @returns {string | undefined}
   */
  get hint() {
    try {
      const n = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.failure_hint(n, this.__wbg_ptr);
      var e = l().getInt32(n + 0, !0), r = l().getInt32(n + 4, !0);
      let i;
      return e !== 0 && (i = N(e, r), s.__wbindgen_export(e, r * 1, 1)), i;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * One sentence.
   * @returns {string}
   */
  get message() {
    let e, r;
    try {
      const o = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.failure_message(o, this.__wbg_ptr);
      var n = l().getInt32(o + 0, !0), i = l().getInt32(o + 4, !0);
      return e = n, r = i, N(n, i);
    } finally {
      s.__wbindgen_add_to_stack_pointer(16), s.__wbindgen_export(e, r, 1);
    }
  }
}
Symbol.dispose && (q.prototype[Symbol.dispose] = q.prototype.free);
class V {
  static __wrap(e) {
    const r = Object.create(V.prototype);
    return r.__wbg_ptr = e, be.register(r, r.__wbg_ptr, r), r;
  }
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, be.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    s.__wbg_model_free(e, 0);
  }
  /**
  * The smallest and the largest coordinates that are there; empty where nothing is.
  * @returns {Float32Array}
  */
  bounds() {
    try {
      const i = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.model_bounds(i, this.__wbg_ptr);
      var e = l().getInt32(i + 0, !0), r = l().getInt32(i + 4, !0), n = te(e, r).slice();
      return s.__wbindgen_export(e, r * 4, 4), n;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
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
      const n = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.model_build(n, this.__wbg_ptr);
      var e = l().getInt32(n + 0, !0), r = l().getInt32(n + 4, !0);
      if (r)
        throw D(e);
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Puts the triangles that are shown into the order of fans, and tells the fan of each. Before the model is built: the
   * vertex that they turn around.
   * @returns {Uint32Array}
   */
  color_fans() {
    try {
      const i = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.model_color_fans(i, this.__wbg_ptr);
      var e = l().getInt32(i + 0, !0), r = l().getInt32(i + 4, !0), n = ue(e, r).slice();
      return s.__wbindgen_export(e, r * 4, 4), n;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
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
      const a = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.model_color_strips(a, this.__wbg_ptr);
      var e = l().getInt32(a + 0, !0), r = l().getInt32(a + 4, !0), n = l().getInt32(a + 8, !0), i = l().getInt32(a + 12, !0);
      if (i)
        throw D(n);
      var o = ue(e, r).slice();
      return s.__wbindgen_export(e, r * 4, 4), o;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Diagonal of these bounds, mesh units.
   * @returns {number}
   */
  get diagonal() {
    return s.model_diagonal(this.__wbg_ptr);
  }
  /**
   * No more bytes will come: reads what an incomplete rest of them tells.
   *
   * # Errors
   * Where there is no mesh without what is missing.
   */
  finish() {
    try {
      const n = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.model_finish(n, this.__wbg_ptr);
      var e = l().getInt32(n + 0, !0), r = l().getInt32(n + 4, !0);
      if (r)
        throw D(e);
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
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
  static from_file(e, r, n) {
    try {
      const _ = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      let c, g, p, u;
      try {
        c = Me(e, s.__wbindgen_export3), g = B, p = rt(r, s.__wbindgen_export3, s.__wbindgen_export4), u = B;
      } catch (y) {
        throw p && s.__wbindgen_export(p, u * 1, 1), c && s.__wbindgen_export(c, g * 1, 1), y;
      }
      s.model_from_file(_, c, g, p, u, n);
      var i = l().getInt32(_ + 0, !0), o = l().getInt32(_ + 4, !0), a = l().getInt32(_ + 8, !0);
      if (a)
        throw D(o);
      return V.__wrap(i);
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Triangles that there will be; 0 as long as nobody has told.
   * @returns {number}
   */
  get full_triangle_count() {
    return s.model_full_triangle_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Vertices that there will be; 0 as long as nobody has told.
   * @returns {number}
   */
  get full_vertex_count() {
    return s.model_full_vertex_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Groups of triangles, at least one.
   * @returns {number}
   */
  get group_count() {
    return s.model_group_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Triangles of each group that are shown.
   * @returns {Uint32Array}
   */
  group_counts() {
    try {
      const i = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.model_group_counts(i, this.__wbg_ptr);
      var e = l().getInt32(i + 0, !0), r = l().getInt32(i + 4, !0), n = ue(e, r).slice();
      return s.__wbindgen_export(e, r * 4, 4), n;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Corners of the triangles that are shown, group after group.
   * @returns {Uint32Array}
   */
  indices() {
    try {
      const i = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.model_indices(i, this.__wbg_ptr);
      var e = l().getInt32(i + 0, !0), r = l().getInt32(i + 4, !0), n = ue(e, r).slice();
      return s.__wbindgen_export(e, r * 4, 4), n;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Whether views can be shown.
   * @returns {boolean}
   */
  get is_built() {
    return s.model_is_built(this.__wbg_ptr) !== 0;
  }
  /**
   * Whether all of the mesh is there.
   * @returns {boolean}
   */
  get is_complete() {
    return s.model_is_complete(this.__wbg_ptr) !== 0;
  }
  /**
   * Whether there is something to show.
   * @returns {boolean}
   */
  get is_ready() {
    return s.model_is_ready(this.__wbg_ptr) !== 0;
  }
  /**
   * `stream`, `striata` or `mesh`: what the bytes were.
   * @returns {string}
   */
  get kind() {
    let e, r;
    try {
      const o = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.model_kind(o, this.__wbg_ptr);
      var n = l().getInt32(o + 0, !0), i = l().getInt32(o + 4, !0);
      return e = n, r = i, N(n, i);
    } finally {
      s.__wbindgen_add_to_stack_pointer(16), s.__wbindgen_export(e, r, 1);
    }
  }
  /**
   * A model without any bytes yet, for a stream.
   */
  constructor() {
    const e = s.model_new();
    return this.__wbg_ptr = e, be.register(this, this.__wbg_ptr, this), this;
  }
  /**
   * Takes the next bytes of a stream and decodes what is whole.
   *
   * # Errors
   * Where they are no sound stream, or the whole would not fit into a page. What came before stays.
   * @param {Uint8Array | number[]} bytes
   */
  push(e) {
    try {
      const i = s.__wbindgen_add_to_stack_pointer(-16) >>> 0, o = Me(e, s.__wbindgen_export3), a = B;
      s.model_push(i, this.__wbg_ptr, o, a);
      var r = l().getInt32(i + 0, !0), n = l().getInt32(i + 4, !0);
      if (n)
        throw D(r);
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Shows a level by its detail, 0 to 1 of the full mesh.
   * @param {number} detail
   */
  show_detail(e) {
    s.model_show_detail(this.__wbg_ptr, e);
  }
  /**
   * Shows the coarsest level that is no farther off, mesh units.
   * @param {number} most
   */
  show_error(e) {
    s.model_show_error(this.__wbg_ptr, e);
  }
  /**
   * Shows the finest level of no more triangles.
   * @param {number} most
   */
  show_triangles(e) {
    s.model_show_triangles(this.__wbg_ptr, e);
  }
  /**
   * Shows what a view asks for; false where asking once more would show more of it.
   *
   * # Errors
   * Where the model is not built, or the camera sees nothing.
   * @param {View} view
   * @returns {boolean}
   */
  show_view(e) {
    try {
      const o = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      Je(e, fe), s.model_show_view(o, this.__wbg_ptr, e.__wbg_ptr);
      var r = l().getInt32(o + 0, !0), n = l().getInt32(o + 4, !0), i = l().getInt32(o + 8, !0);
      if (i)
        throw D(n);
      return r !== 0;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * How far what is shown is from the full mesh, where it is farthest, mesh units.
   * @returns {number}
   */
  get shown_error() {
    return s.model_shown_error(this.__wbg_ptr);
  }
  /**
   * Vertex splits that are shown.
   * @returns {number}
   */
  get shown_split_count() {
    return s.model_shown_split_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Normals of all vertices that are there, made from the finest level of what has come.
   * @returns {Float32Array}
   */
  smooth_normals() {
    try {
      const i = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.model_smooth_normals(i, this.__wbg_ptr);
      var e = l().getInt32(i + 0, !0), r = l().getInt32(i + 4, !0), n = te(e, r).slice();
      return s.__wbindgen_export(e, r * 4, 4), n;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Vertex splits from the base to the full mesh.
   * @returns {number}
   */
  get step_count() {
    return s.model_step_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Bytes of the whole stream; 0 as long as nobody has told.
   * @returns {number}
   */
  get stream_bytes() {
    return s.model_stream_bytes(this.__wbg_ptr);
  }
  /**
   * Triangles of the finest level that is there.
   * @returns {number}
   */
  get triangle_count() {
    return s.model_triangle_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Vertices that are there.
   * @returns {number}
   */
  get vertex_count() {
    return s.model_vertex_count(this.__wbg_ptr) >>> 0;
  }
  /**
   * Vertices from one on.
   * @param {number} first
   * @returns {Vertices}
   */
  vertices(e) {
    const r = s.model_vertices(this.__wbg_ptr, e);
    return ie.__wrap(r);
  }
}
Symbol.dispose && (V.prototype[Symbol.dispose] = V.prototype.free);
class ne {
  static __wrap(e) {
    const r = Object.create(ne.prototype);
    return r.__wbg_ptr = e, De.register(r, r.__wbg_ptr, r), r;
  }
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, De.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    s.__wbg_streamplace_free(e, 0);
  }
  /**
  * Its bytes; 0 if the file has no stream.
  * @returns {number}
  */
  get length() {
    return s.__wbg_get_streamplace_length(this.__wbg_ptr);
  }
  /**
   * First bytes of the file that it takes to know; more than were given: ask again with so many.
   * @returns {number}
   */
  get needed() {
    return s.__wbg_get_streamplace_needed(this.__wbg_ptr);
  }
  /**
   * Where the stream begins, bytes from the file's beginning.
   * @returns {number}
   */
  get offset() {
    return s.__wbg_get_streamplace_offset(this.__wbg_ptr);
  }
  /**
   * Its bytes; 0 if the file has no stream.
   * @param {number} arg0
   */
  set length(e) {
    s.__wbg_set_streamplace_length(this.__wbg_ptr, e);
  }
  /**
   * First bytes of the file that it takes to know; more than were given: ask again with so many.
   * @param {number} arg0
   */
  set needed(e) {
    s.__wbg_set_streamplace_needed(this.__wbg_ptr, e);
  }
  /**
   * Where the stream begins, bytes from the file's beginning.
   * @param {number} arg0
   */
  set offset(e) {
    s.__wbg_set_streamplace_offset(this.__wbg_ptr, e);
  }
  /**
   * Looks for the stream of a `.striata` file.
   *
   * # Errors
   * Where the bytes begin no `.striata` file, or its header is damaged.
   * @param {Uint8Array | number[]} head
   * @returns {StreamPlace}
   */
  static find(e) {
    try {
      const o = s.__wbindgen_add_to_stack_pointer(-16) >>> 0, a = Me(e, s.__wbindgen_export3), _ = B;
      s.streamplace_find(o, a, _);
      var r = l().getInt32(o + 0, !0), n = l().getInt32(o + 4, !0), i = l().getInt32(o + 8, !0);
      if (i)
        throw D(n);
      return ne.__wrap(r);
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
}
Symbol.dispose && (ne.prototype[Symbol.dispose] = ne.prototype.free);
class ie {
  static __wrap(e) {
    const r = Object.create(ie.prototype);
    return r.__wbg_ptr = e, Le.register(r, r.__wbg_ptr, r), r;
  }
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, Le.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    s.__wbg_vertices_free(e, 0);
  }
  /**
  * Red, green, blue and alpha a vertex, if the mesh has colours.
  * @returns {Uint8Array | undefined}
  */
  take_colors() {
    try {
      const n = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.vertices_take_colors(n, this.__wbg_ptr);
      var e = l().getInt32(n + 0, !0), r = l().getInt32(n + 4, !0);
      let i;
      return e !== 0 && (i = Ke(e, r).slice(), s.__wbindgen_export(e, r * 1, 1)), i;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Three numbers a vertex, if the mesh has normals.
   * @returns {Float32Array | undefined}
   */
  take_normals() {
    try {
      const n = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.vertices_take_normals(n, this.__wbg_ptr);
      var e = l().getInt32(n + 0, !0), r = l().getInt32(n + 4, !0);
      let i;
      return e !== 0 && (i = te(e, r).slice(), s.__wbindgen_export(e, r * 4, 4)), i;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Three numbers a vertex, mesh units.
   * @returns {Float32Array}
   */
  take_positions() {
    try {
      const i = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.vertices_take_positions(i, this.__wbg_ptr);
      var e = l().getInt32(i + 0, !0), r = l().getInt32(i + 4, !0), n = te(e, r).slice();
      return s.__wbindgen_export(e, r * 4, 4), n;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
  /**
   * Two numbers a vertex, `v` downwards, if the mesh has texture coordinates.
   * @returns {Float32Array | undefined}
   */
  take_uvs() {
    try {
      const n = s.__wbindgen_add_to_stack_pointer(-16) >>> 0;
      s.vertices_take_uvs(n, this.__wbg_ptr);
      var e = l().getInt32(n + 0, !0), r = l().getInt32(n + 4, !0);
      let i;
      return e !== 0 && (i = te(e, r).slice(), s.__wbindgen_export(e, r * 4, 4)), i;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
}
Symbol.dispose && (ie.prototype[Symbol.dispose] = ie.prototype.free);
class fe {
  __destroy_into_raw() {
    const e = this.__wbg_ptr;
    return this.__wbg_ptr = 0, je.unregister(this), e;
  }
  free() {
    const e = this.__destroy_into_raw();
    s.__wbg_view_free(e, 0);
  }
  /**
  * Pixels that anything may be off.
  * @returns {number}
  */
  get pixels() {
    return s.__wbg_get_view_pixels(this.__wbg_ptr);
  }
  /**
   * Triangles that are shown at most; 0 for no limit.
   * @returns {number}
   */
  get triangle_limit() {
    return s.__wbg_get_view_triangle_limit(this.__wbg_ptr) >>> 0;
  }
  /**
   * Pixels that anything may be off.
   * @param {number} arg0
   */
  set pixels(e) {
    s.__wbg_set_view_pixels(this.__wbg_ptr, e);
  }
  /**
   * Triangles that are shown at most; 0 for no limit.
   * @param {number} arg0
   */
  set triangle_limit(e) {
    s.__wbg_set_view_triangle_limit(this.__wbg_ptr, e);
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
    try {
      const _ = s.__wbindgen_add_to_stack_pointer(-16) >>> 0, c = +r, g = +n, p = tt(e, s.__wbindgen_export3), u = B;
      s.view_new(_, p, u, c, g);
      var i = l().getInt32(_ + 0, !0), o = l().getInt32(_ + 4, !0), a = l().getInt32(_ + 8, !0);
      if (a)
        throw D(o);
      return this.__wbg_ptr = i, je.register(this, this.__wbg_ptr, this), this;
    } finally {
      s.__wbindgen_add_to_stack_pointer(16);
    }
  }
}
Symbol.dispose && (fe.prototype[Symbol.dispose] = fe.prototype.free);
function Ge() {
  return {
    __proto__: null,
    "./striata_web_bg.js": {
      __proto__: null,
      __wbg___wbindgen_throw_4c88d8bf264fd984: function(e, r) {
        throw new Error(N(e, r));
      },
      __wbg_failure_new: function(e) {
        return q.__wrap(e);
      },
      __wbg_report_581358a93077c908: function(e, r, n, i) {
        e.report(N(r, n), i);
      },
      __wbindgen_init_externref_table: function() {
        const e = s.__wbindgen_externrefs;
        e.set(0, void 0), e.set(1024, void 0), e.set(1025, null), e.set(1026, !0), e.set(1027, !1);
      }
    }
  };
}
const We = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => s.__wbg_failure_free(t, 1)), be = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => s.__wbg_model_free(t, 1)), De = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => s.__wbg_streamplace_free(t, 1)), Le = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => s.__wbg_vertices_free(t, 1)), je = typeof FinalizationRegistry > "u" ? { register: () => {
}, unregister: () => {
} } : new FinalizationRegistry((t) => s.__wbg_view_free(t, 1));
function Je(t, e) {
  if (!(t instanceof e))
    throw new Error(`expected instance of ${e.name}`);
}
function te(t, e) {
  return t = t >>> 0, Qe().subarray(t / 4, t / 4 + e);
}
function ue(t, e) {
  return t = t >>> 0, et().subarray(t / 4, t / 4 + e);
}
function Ke(t, e) {
  return t = t >>> 0, Y().subarray(t / 1, t / 1 + e);
}
let j = null;
function l() {
  return (j === null || j.buffer.detached === !0 || j.buffer.detached === void 0 && j.buffer !== s.memory.buffer) && (j = new DataView(s.memory.buffer)), j;
}
let J = null;
function Qe() {
  return (J === null || J.byteLength === 0) && (J = new Float32Array(s.memory.buffer)), J;
}
let K = null;
function Ze() {
  return (K === null || K.byteLength === 0) && (K = new Float64Array(s.memory.buffer)), K;
}
function N(t, e) {
  return t = t >>> 0, it(Y().subarray(t, t + e));
}
let Q = null;
function et() {
  return (Q === null || Q.byteLength === 0) && (Q = new Uint32Array(s.memory.buffer)), Q;
}
let Z = null;
function Y() {
  return (Z === null || Z.byteLength === 0) && (Z = new Uint8Array(s.memory.buffer)), Z;
}
function Me(t, e) {
  const r = e(t.length * 1, 1) >>> 0;
  return Y().set(t, r / 1), B = t.length, r;
}
function tt(t, e) {
  const r = e(t.length * 8, 8) >>> 0;
  return Ze().set(t, r / 8), B = t.length, r;
}
function rt(t, e, r) {
  if (r === void 0) {
    const _ = re.encode(t), c = e(_.length, 1) >>> 0;
    return Y().subarray(c, c + _.length).set(_), B = _.length, c;
  }
  let n = t.length, i = e(n, 1) >>> 0;
  const o = Y();
  let a = 0;
  for (; a < n; a++) {
    const _ = t.charCodeAt(a);
    if (_ > 127) break;
    o[i + a] = _;
  }
  if (a !== n) {
    a !== 0 && (t = t.slice(a)), i = r(i, n, n = a + t.length * 3, 1) >>> 0;
    const _ = Y().subarray(i + a, i + n), c = re.encodeInto(t, _);
    a += c.written, i = r(i, n, a, 1) >>> 0;
  }
  return B = a, i;
}
function D(t) {
  const e = s.__wbindgen_externrefs.get(t);
  return s.__wbindgen_export2(t), e;
}
let he = new TextDecoder("utf-8", { ignoreBOM: !0 });
he.decode();
const nt = 2146435072;
let ve = 0;
function it(t) {
  return ve += t.length, ve >= nt && (he = new TextDecoder("utf-8", { ignoreBOM: !0 }), he.decode(), ve = t.length), he.decode(t);
}
const re = new TextEncoder();
"encodeInto" in re || (re.encodeInto = function(t, e) {
  const r = re.encode(t);
  return e.set(r), {
    read: t.length,
    written: r.length
  };
});
let B = 0, s;
function st(t, e) {
  return s = t.exports, j = null, J = null, K = null, Q = null, Z = null, s.__wbindgen_start(), s;
}
function ot(t) {
  if (s !== void 0) return s;
  t !== void 0 && (Object.getPrototypeOf(t) === Object.prototype ? { module: t } = t : console.warn("using deprecated parameters for `initSync()`; pass a single object instead"));
  const e = Ge();
  t instanceof WebAssembly.Module || (t = new WebAssembly.Module(t));
  const r = new WebAssembly.Instance(t, e);
  return st(r);
}
class S extends Error {
  code;
  hint;
  constructor(e, r, n) {
    super(r), this.name = "StriataError", this.code = e, this.hint = n;
  }
}
function me(t) {
  if (t instanceof S) return t;
  if (t instanceof q) {
    const r = new S(t.code, t.message, t.hint);
    return t.free(), r;
  }
  if (t instanceof WebAssembly.RuntimeError || t instanceof RangeError)
    return new S(
      "too-large",
      "the model took more memory than the page has",
      "close other pages, or load a stream with fewer triangles"
    );
  if (t instanceof DOMException && t.name === "AbortError") return at();
  const e = t instanceof Error ? t.message : String(t);
  return new S("network", e);
}
function at() {
  return new S("aborted", "loading was aborted");
}
function ke(t) {
  return { code: t.code, message: t.message, hint: t.hint };
}
function jt(t) {
  return new S(t.code, t.message, t.hint);
}
var _t = ArrayBuffer, v = Uint8Array, ge = Uint16Array, ct = Int16Array, pe = Int32Array, xe = function(t, e, r) {
  if (v.prototype.slice)
    return v.prototype.slice.call(t, e, r);
  (e == null || e < 0) && (e = 0), (r == null || r > t.length) && (r = t.length);
  var n = new v(r - e);
  return n.set(t.subarray(e, r)), n;
}, we = function(t, e, r, n) {
  if (v.prototype.fill)
    return v.prototype.fill.call(t, e, r, n);
  for ((r == null || r < 0) && (r = 0), (n == null || n > t.length) && (n = t.length); r < n; ++r)
    t[r] = e;
  return t;
}, lt = function(t, e, r, n) {
  if (v.prototype.copyWithin)
    return v.prototype.copyWithin.call(t, e, r, n);
  for ((r == null || r < 0) && (r = 0), (n == null || n > t.length) && (n = t.length); r < n; )
    t[e++] = t[r++];
}, ut = [
  "invalid zstd data",
  "window size too large (>2046MB)",
  "invalid block type",
  "FSE accuracy too high",
  "match distance too far back",
  "unexpected EOF"
], b = function(t, e, r) {
  var n = new Error(e || ut[t]);
  if (n.code = t, Error.captureStackTrace && Error.captureStackTrace(n, b), !r)
    throw n;
  return n;
}, Pe = function(t, e, r) {
  for (var n = 0, i = 0; n < r; ++n)
    i |= t[e++] << (n << 3);
  return i;
}, ht = function(t, e) {
  return (t[e] | t[e + 1] << 8 | t[e + 2] << 16 | t[e + 3] << 24) >>> 0;
}, ft = function(t, e) {
  var r = t[0] | t[1] << 8 | t[2] << 16;
  if (r == 3126568 && t[3] == 253) {
    var n = t[4], i = n >> 5 & 1, o = n >> 2 & 1, a = n & 3, _ = n >> 6;
    n & 8 && b(0);
    var c = 6 - i, g = a == 3 ? 4 : a, p = Pe(t, c, g);
    c += g;
    var u = _ ? 1 << _ : i, y = Pe(t, c, u) + (_ == 1 && 256), m = y;
    if (!i) {
      var A = 1 << 10 + (t[5] >> 3);
      m = A + (A >> 3) * (t[5] & 7);
    }
    m > 2145386496 && b(1);
    var h = new v(m + 12);
    return h[0] = 1, h[4] = 4, h[8] = 8, {
      b: c + u,
      y: 0,
      l: 0,
      d: p,
      w: e && e != 1 ? e : h.subarray(12),
      e: m,
      o: new pe(h.buffer, 0, 3),
      u: y,
      c: o,
      m: Math.min(131072, m)
    };
  } else if ((r >> 4 | t[3] << 20) == 25481893)
    return ht(t, 4) + 8;
  b(0);
}, P = function(t) {
  for (var e = 0; 1 << e <= t; ++e)
    ;
  return e - 1;
}, se = function(t, e, r) {
  var n = (e << 3) + 4, i = (t[e] & 15) + 5;
  i > r && b(3);
  for (var o = 1 << i, a = o, _ = -1, c = -1, g = -1, p = o, u = new _t(512 + (o << 2)), y = new ct(u, 0, 256), m = new ge(u, 0, 256), A = new ge(u, 512, o), h = 512 + (o << 1), k = new v(u, h, o), U = new v(u, h + o); _ < 255 && a > 0; ) {
    var E = P(a + 1), x = n >> 3, W = (1 << E + 1) - 1, I = (t[x] | t[x + 1] << 8 | t[x + 2] << 16) >> (n & 7) & W, w = (1 << E) - 1, M = W - a - 1, R = I & w;
    if (R < M ? (n += E, I = R) : (n += E + 1, I > w && (I -= M)), y[++_] = --I, I == -1 ? (a += I, k[--p] = _) : a -= I, !I)
      do {
        var C = n >> 3;
        c = (t[C] | t[C + 1] << 8) >> (n & 7) & 3, n += 2, _ += c;
      } while (c == 3);
  }
  (_ > 255 || a) && b(0);
  for (var z = 0, O = (o >> 1) + (o >> 3) + 3, $ = o - 1, T = 0; T <= _; ++T) {
    var d = y[T];
    if (d < 1) {
      m[T] = -d;
      continue;
    }
    for (g = 0; g < d; ++g) {
      k[z] = T;
      do
        z = z + O & $;
      while (z >= p);
    }
  }
  for (z && b(0), g = 0; g < o; ++g) {
    var f = m[k[g]]++, F = U[g] = i - P(f);
    A[g] = (f << F) - o;
  }
  return [n + 7 >> 3, {
    b: i,
    s: k,
    n: U,
    t: A
  }];
}, gt = function(t, e) {
  var r = 0, n = -1, i = new v(292), o = t[e], a = i.subarray(0, 256), _ = i.subarray(256, 268), c = new ge(i.buffer, 268);
  if (o < 128) {
    var g = se(t, e + 1, 6), p = g[0], u = g[1];
    e += o;
    var y = p << 3, m = t[e];
    m || b(0);
    for (var A = 0, h = 0, k = u.b, U = k, E = (++e << 3) - 8 + P(m); E -= k, !(E < y); ) {
      var x = E >> 3;
      if (A += (t[x] | t[x + 1] << 8) >> (E & 7) & (1 << k) - 1, a[++n] = u.s[A], E -= U, E < y)
        break;
      x = E >> 3, h += (t[x] | t[x + 1] << 8) >> (E & 7) & (1 << U) - 1, a[++n] = u.s[h], k = u.n[A], A = u.t[A], U = u.n[h], h = u.t[h];
    }
    ++n > 255 && b(0);
  } else {
    for (n = o - 127; r < n; r += 2) {
      var W = t[++e];
      a[r] = W >> 4, a[r + 1] = W & 15;
    }
    ++e;
  }
  var I = 0;
  for (r = 0; r < n; ++r) {
    var w = a[r];
    w > 11 && b(0), I += w && 1 << w - 1;
  }
  var M = P(I) + 1, R = 1 << M, C = R - I;
  for (C & C - 1 && b(0), a[n++] = P(C) + 1, r = 0; r < n; ++r) {
    var w = a[r];
    ++_[a[r] = w && M + 1 - w];
  }
  var z = new v(R << 1), O = z.subarray(0, R), $ = z.subarray(R);
  for (c[M] = 0, r = M; r > 0; --r) {
    var T = c[r];
    we($, r, T, c[r - 1] = T + _[r] * (1 << M - r));
  }
  for (c[0] != R && b(0), r = 0; r < n; ++r) {
    var d = a[r];
    if (d) {
      var f = c[d];
      we(O, r, f, c[d] = f + (1 << M - d));
    }
  }
  return [e, {
    n: $,
    b: M,
    s: O
  }];
}, wt = se(/* @__PURE__ */ new v([
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
]), 0, 6)[1], pt = se(/* @__PURE__ */ new v([
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
]), 0, 6)[1], dt = se(/* @__PURE__ */ new v([
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
]), 0, 5)[1], qe = function(t, e) {
  for (var r = t.length, n = new pe(r), i = 0; i < r; ++i)
    n[i] = e, e += 1 << t[i];
  return n;
}, ze = /* @__PURE__ */ new v((/* @__PURE__ */ new pe([
  0,
  0,
  0,
  0,
  16843009,
  50528770,
  134678020,
  202050057,
  269422093
])).buffer, 0, 36), yt = /* @__PURE__ */ qe(ze, 0), Fe = /* @__PURE__ */ new v((/* @__PURE__ */ new pe([
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
])).buffer, 0, 53), bt = /* @__PURE__ */ qe(Fe, 3), ee = function(t, e, r) {
  var n = t.length, i = e.length, o = t[n - 1], a = (1 << r.b) - 1, _ = -r.b;
  o || b(0);
  for (var c = 0, g = r.b, p = (n << 3) - 8 + P(o) - g, u = -1; p > _ && u < i; ) {
    var y = p >> 3, m = (t[y] | t[y + 1] << 8 | t[y + 2] << 16) >> (p & 7);
    c = (c << g | m) & a, e[++u] = r.s[c], p -= g = r.n[c];
  }
  (p != _ || u + 1 != i) && b(0);
}, vt = function(t, e, r) {
  var n = 6, i = e.length, o = i + 3 >> 2, a = o << 1, _ = o + a;
  ee(t.subarray(n, n += t[0] | t[1] << 8), e.subarray(0, o), r), ee(t.subarray(n, n += t[2] | t[3] << 8), e.subarray(o, a), r), ee(t.subarray(n, n += t[4] | t[5] << 8), e.subarray(a, _), r), ee(t.subarray(n), e.subarray(_), r);
}, mt = function(t, e, r) {
  var n, i = e.b, o = t[i], a = o >> 1 & 3;
  e.l = o & 1;
  var _ = o >> 3 | t[i + 1] << 5 | t[i + 2] << 13, c = (i += 3) + _;
  if (a == 1)
    return i >= t.length ? void 0 : (e.b = i + 1, we(new v(_), t[i]));
  if (!(c > t.length)) {
    if (a == 0)
      return e.b = c, xe(t, i, c);
    if (a == 2) {
      var g = t[i], p = g & 3, u = g >> 2 & 3, y = g >> 4, m = 0, A = 0;
      p < 2 ? u & 1 ? y |= t[++i] << 4 | (u & 2 && t[++i] << 12) : y = g >> 3 : (A = u, u < 2 ? (y |= (t[++i] & 63) << 4, m = t[i] >> 6 | t[++i] << 2) : u == 2 ? (y |= t[++i] << 4 | (t[++i] & 3) << 12, m = t[i] >> 2 | t[++i] << 6) : (y |= t[++i] << 4 | (t[++i] & 63) << 12, m = t[i] >> 6 | t[++i] << 2 | t[++i] << 10)), ++i;
      var h = new v(e.m), k = h.length - y;
      if (p == 0)
        h.set(t.subarray(i, i += y), k);
      else if (p == 1)
        we(h, t[i++], k);
      else {
        var U = e.h;
        if (p == 2) {
          var E = gt(t, i);
          m += i - (i = E[0]), e.h = U = E[1];
        } else U || b(0);
        (A ? vt : ee)(t.subarray(i, i += m), h.subarray(k), U);
      }
      var x = t[i++];
      if (x) {
        x == 255 ? x = (t[i++] | t[i++] << 8) + 32512 : x > 127 && (x = x - 128 << 8 | t[i++]);
        var W = t[i++];
        W & 3 && b(0);
        for (var I = [pt, dt, wt], w = 2; w > -1; --w) {
          var M = W >> (w << 1) + 2 & 3;
          if (M == 1) {
            var R = new v([0, 0, t[i++]]);
            I[w] = {
              s: R.subarray(2, 3),
              n: R.subarray(0, 1),
              t: new ge(R.buffer, 0, 1),
              b: 0
            };
          } else M == 2 ? (n = se(t, i, 9 - (w & 1)), i = n[0], I[w] = n[1]) : M == 3 && (e.t || b(0), I[w] = e.t[w]);
        }
        var C = e.t = I, z = C[0], O = C[1], $ = C[2], T = t[c - 1];
        T || b(0);
        var d = (c << 3) - 8 + P(T) - $.b, f = d >> 3, F = 0, oe = (t[f] | t[f + 1] << 8) >> (d & 7) & (1 << $.b) - 1;
        f = (d -= O.b) >> 3;
        var ae = (t[f] | t[f + 1] << 8) >> (d & 7) & (1 << O.b) - 1;
        f = (d -= z.b) >> 3;
        var _e = (t[f] | t[f + 1] << 8) >> (d & 7) & (1 << z.b) - 1;
        for (++x; --x; ) {
          var de = $.s[oe], Ue = $.n[oe], ye = z.s[_e], Ce = z.n[_e], Oe = O.s[ae], $e = O.n[ae];
          f = (d -= Oe) >> 3;
          var Be = 1 << Oe, L = Be + ((t[f] | t[f + 1] << 8 | t[f + 2] << 16 | t[f + 3] << 24) >>> (d & 7) & Be - 1);
          f = (d -= Fe[ye]) >> 3;
          var H = bt[ye] + ((t[f] | t[f + 1] << 8 | t[f + 2] << 16) >> (d & 7) & (1 << Fe[ye]) - 1);
          f = (d -= ze[de]) >> 3;
          var ce = yt[de] + ((t[f] | t[f + 1] << 8 | t[f + 2] << 16) >> (d & 7) & (1 << ze[de]) - 1);
          if (f = (d -= Ue) >> 3, oe = $.t[oe] + ((t[f] | t[f + 1] << 8) >> (d & 7) & (1 << Ue) - 1), f = (d -= Ce) >> 3, _e = z.t[_e] + ((t[f] | t[f + 1] << 8) >> (d & 7) & (1 << Ce) - 1), f = (d -= $e) >> 3, ae = O.t[ae] + ((t[f] | t[f + 1] << 8) >> (d & 7) & (1 << $e) - 1), L > 3)
            e.o[2] = e.o[1], e.o[1] = e.o[0], e.o[0] = L -= 3;
          else {
            var le = L - (ce != 0);
            le ? (L = le == 3 ? e.o[0] - 1 : e.o[le], le > 1 && (e.o[2] = e.o[1]), e.o[1] = e.o[0], e.o[0] = L) : L = e.o[0];
          }
          for (var w = 0; w < ce; ++w)
            h[F + w] = h[k + w];
          F += ce, k += ce;
          var X = F - L;
          if (X < 0) {
            var G = -X, Xe = e.e + X;
            G > H && (G = H);
            for (var w = 0; w < G; ++w)
              h[F + w] = e.w[Xe + w];
            F += G, H -= G, X = 0;
          }
          for (var w = 0; w < H; ++w)
            h[F + w] = h[X + w];
          F += H;
        }
        if (F != k)
          for (; k < h.length; )
            h[F++] = h[k++];
        else
          F = h.length;
        h = xe(h, 0, F);
      } else {
        var w;
        k && (h = xe(h, k));
      }
      return e.b = c, h;
    }
    b(2);
  }
}, Ve = function(t, e) {
  if (t.length == 1)
    return t[0];
  for (var r = new v(e), n = 0, i = 0; n < t.length; ++n) {
    var o = t[n];
    r.set(o, i), i += o.length;
  }
  return r;
}, kt = /* @__PURE__ */ (function() {
  function t(e) {
    this.ondata = e, this.c = [], this.l = 0, this.z = 0;
  }
  return t.prototype.push = function(e, r) {
    if (typeof this.s == "number") {
      var n = Math.min(e.length, this.s);
      e = e.subarray(n), this.s -= n;
    }
    var i = e.length, o = i + this.l;
    if (!this.s) {
      if (r) {
        if (!o) {
          this.ondata(new v(0), !0);
          return;
        }
        o < 5 && b(5);
      } else if (o < 18) {
        this.c.push(e), this.l = o;
        return;
      }
      if (this.l && (this.c.push(e), e = Ve(this.c, o), this.c = [], this.l = 0), typeof (this.s = ft(e)) == "number")
        return this.push(e, r);
    }
    if (typeof this.s != "number") {
      if (o < (this.z || 3)) {
        r && b(5), this.c.push(e), this.l = o;
        return;
      }
      if (this.l && (this.c.push(e), e = Ve(this.c, o), this.c = [], this.l = 0), !this.z && o < (this.z = e[this.s.b] & 2 ? 4 : 3 + (e[this.s.b] >> 3 | e[this.s.b + 1] << 5 | e[this.s.b + 2] << 13))) {
        r && b(5), this.c.push(e), this.l = o;
        return;
      } else
        this.z = 0;
      for (; ; ) {
        var a = mt(e, this.s);
        if (a)
          this.ondata(a, !1), lt(this.s.w, 0, a.length), this.s.w.set(a, this.s.w.length - a.length);
        else {
          r && b(5);
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
    } else r && b(5);
  }, t;
})();
const Ie = 65536;
async function Pt(t, e, r) {
  if (typeof t == "string" || t instanceof URL) return xt(t, e, r);
  if (t instanceof Blob) {
    const n = (i, o) => Re(t.slice(i, o).stream(), r);
    return {
      name: e ?? (t instanceof File ? t.name : ""),
      length: t.size,
      pieces: n(0, t.size),
      range: (i, o) => Promise.resolve(n(i, o))
    };
  }
  if (t instanceof ArrayBuffer) {
    const n = (i, o) => He(new Uint8Array(t.slice(i, o)));
    return {
      name: e ?? "",
      length: t.byteLength,
      pieces: n(0, t.byteLength),
      range: (i, o) => Promise.resolve(n(i, o))
    };
  }
  if (t instanceof ReadableStream)
    return { name: e ?? "", length: null, pieces: Re(t, r), range: null };
  throw new S("unsupported", "a model is loaded from a URL, a File, a Blob, an ArrayBuffer or a ReadableStream");
}
async function xt(t, e, r) {
  const n = new URL(t, typeof document > "u" ? void 0 : document.baseURI), o = /\.striata$/i.test(n.pathname) ? { Range: `bytes=0-${Ie - 1}` } : {}, a = await Ne(n, o, r), _ = /\/(\d+)$/.exec(a.headers.get("Content-Range") ?? "")?.[1], c = a.headers.has("Content-Encoding"), g = _ ?? (c ? null : a.headers.get("Content-Length")), p = a.status === 206, u = async (y, m) => {
    const A = await Ne(n, { Range: `bytes=${y}-${m - 1}` }, r), h = Ae(A, r);
    return A.status === 206 ? h : It(h, y);
  };
  return {
    name: e ?? decodeURIComponent(n.pathname.split("/").pop() ?? ""),
    length: g === null ? null : Number(g),
    pieces: p && Number(_) > Ie ? At(Ae(a, r), () => u(Ie, Number(_))) : Ae(a, r),
    range: p ? u : null
  };
}
async function Ne(t, e, r) {
  let n;
  try {
    n = await fetch(t, { headers: e, signal: r });
  } catch (o) {
    throw r.aborted ? o : new S(
      "network",
      `${t.href} could not be fetched: ${o instanceof Error ? o.message : String(o)}`,
      "is the server reachable, and does it allow this page to read (CORS)?"
    );
  }
  if (n.ok) return n;
  await n.body?.cancel();
  const i = n.status === 404 || n.status === 410 ? "not-found" : "network";
  throw new S(i, `${t.href}: the server says ${n.status} ${n.statusText}`.trim());
}
function Ae(t, e) {
  return t.body ? Re(t.body, e) : He(new Uint8Array());
}
async function* He(t) {
  yield t;
}
async function* Re(t, e) {
  const r = t.getReader(), n = () => void r.cancel(e.reason).catch(() => {
  });
  e.addEventListener("abort", n, { once: !0 });
  let i = !1;
  try {
    for (; ; ) {
      e.throwIfAborted();
      const { done: o, value: a } = await r.read();
      if (e.throwIfAborted(), o) break;
      yield a;
    }
    i = !0;
  } catch (o) {
    throw e.aborted || o instanceof S ? o : new S("network", `the connection broke: ${o instanceof Error ? o.message : String(o)}`);
  } finally {
    e.removeEventListener("abort", n), i || await r.cancel().catch(() => {
    });
  }
}
async function* It(t, e) {
  try {
    for (let r = await t.next(); !r.done; r = await t.next()) {
      const n = r.value.subarray(e);
      e = Math.max(0, e - r.value.length), n.length > 0 && (yield n);
    }
  } finally {
    await t.return?.();
  }
}
async function* At(t, e) {
  for (let r = await t.next(); !r.done; r = await t.next()) yield r.value;
  yield* Te(await e());
}
async function* Vt(t, e) {
  t.length > 0 && (yield t), yield* Te(e);
}
async function* Nt(t, e) {
  for await (const r of Te(t))
    if (yield r.subarray(0, e), e -= r.length, e <= 0) return;
}
function Te(t) {
  return { [Symbol.asyncIterator]: () => t };
}
function St(t) {
  if (t.length === 1) return t[0];
  const e = new Uint8Array(t.reduce((n, i) => n + i.length, 0));
  let r = 0;
  for (const n of t)
    e.set(n, r), r += n.length;
  return e;
}
const Et = 3, Mt = 1 << 30, zt = 64 << 20, Ft = 2e3;
async function Rt(t, e) {
  for (let r = 0; r < Et; r++) {
    const n = Tt(t);
    if (!n) break;
    const i = new Ot(Math.min(Mt, Math.max(zt, t.length * Ft)), e);
    try {
      await (n === "gzip" ? Ut(t, i) : Ct(t, i));
    } catch (o) {
      throw o instanceof S ? o : new S("corrupt", `${e}: the ${n} data are damaged or cut off: ${o instanceof Error ? o.message : String(o)}`);
    }
    t = St(i.all), e = e.replace(/\.(gz|zst)$/i, "");
  }
  return { bytes: t, name: e };
}
function Tt(t) {
  const e = (...r) => r.every((n, i) => t[i] === n);
  return e(31, 139, 8) ? "gzip" : e(40, 181, 47, 253) ? "zstd" : void 0;
}
async function Ut(t, e) {
  const n = new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip")).getReader();
  for (; ; ) {
    const { done: i, value: o } = await n.read();
    if (i) return;
    e.push(o);
  }
}
function Ct(t, e) {
  let r = !1;
  const n = new kt((o, a) => {
    e.push(o), r ||= a === !0;
  }), i = 1 << 20;
  for (let o = 0; o < t.length; o += i)
    n.push(t.subarray(o, o + i), o + i >= t.length);
  if (!r) throw new Error("they end too early");
}
class Ot {
  constructor(e, r) {
    this.most = e, this.name = r;
  }
  all = [];
  #t = 0;
  push(e) {
    if (this.#t += e.length, this.#t > this.most)
      throw new S("too-large", `${this.name}: grows past ${this.most} bytes, more than a mesh can`);
    this.all.push(e.slice());
  }
}
const Se = 8192, $t = 60, Bt = 4;
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
  #g;
  #e = new V();
  #r = [];
  #s;
  #c = !1;
  #n = !1;
  #w = { by: "detail", value: 1, limit: 0 };
  #_ = "surface";
  #i = "download";
  /** Vertices that the page has. */
  #p = 0;
  #d = !1;
  /** Vertices that the page's computed normals are of; normals of a coarser level are other normals. */
  #y = -1;
  #l = 0;
  #u = 0;
  #h = 0;
  #b = 0;
  /** What the head promised, once the decoder is gone. */
  #o = { vertices: 0, triangles: 0, steps: 0, bytes: 0 };
  constructor(e, r) {
    this.#t = e, this.#g = r;
  }
  /** Does what the page orders. */
  take(e) {
    if (!this.#n)
      switch (e.type) {
        case "bytes":
          this.#r.push(e.bytes), this.#v();
          break;
        case "end":
          this.#s = e.error ? { error: e.error } : {}, this.#v();
          break;
        case "file":
          this.#I(e.bytes, e.name);
          break;
        case "show":
          this.#w = e.wish, this.#_ = e.colouring, this.#e.is_ready && this.#f(() => this.#a(e.ticket));
          break;
      }
  }
  dispose() {
    this.#n = !0, this.#r = [], this.#e.free();
  }
  /** Decodes what waits, then ends if nothing more comes. */
  async #v() {
    if (!this.#c) {
      for (this.#c = !0; this.#r.length > 0 && !this.#n; ) {
        this.#i = "decode";
        const e = this.#m();
        if (e) {
          this.#r = [], this.#s = { error: ke(e) };
          break;
        }
        this.#e.is_ready && performance.now() >= this.#b && this.#f(() => this.#a(0)), await Wt();
      }
      this.#c = !1, this.#s && !this.#n && this.#k(this.#s.error);
    }
  }
  /** Decodes for a few milliseconds; returns what is wrong with the bytes. */
  #m() {
    const e = performance.now();
    try {
      for (; performance.now() - e < this.#g; ) {
        const r = this.#r.shift();
        if (!r) break;
        this.#e.push(r.subarray(0, Se)), r.length > Se && this.#r.unshift(r.subarray(Se));
      }
      return;
    } catch (r) {
      return me(r);
    } finally {
      this.#l += performance.now() - e;
    }
  }
  #k(e) {
    let r = e;
    try {
      if (!r && !this.#e.is_complete && (r = { code: "corrupt", message: "the stream ends before the mesh does", hint: "was the file copied whole?" }), (r?.code !== "corrupt" || !e) && this.#x(), !this.#e.is_ready) throw new S("corrupt", "the stream ends before there is anything to draw");
      this.#A(), this.#i = "build", this.#a(0), this.#t({ type: "building", share: 0 });
      const n = performance.now();
      this.#e.build(), this.#u = performance.now() - n, this.#i = "done", this.#a(0);
    } catch (n) {
      r ??= ke(me(n));
    }
    this.#s = void 0, this.#t(r ? { type: "failed", error: r } : { type: "finished" });
  }
  #x() {
    const e = performance.now();
    try {
      this.#e.finish();
    } finally {
      this.#l += performance.now() - e;
    }
  }
  /** Reads a whole file and builds its model. */
  async #I(e, r) {
    this.#i = "build";
    const n = performance.now(), i = { report: (_, c) => this.#t({ type: "building", share: c }) };
    let o, a;
    try {
      o = await Rt(e, r);
    } catch (_) {
      a = _;
    }
    this.#n || this.#f(() => {
      if (!o) throw a;
      const _ = V.from_file(o.bytes, o.name, i);
      this.#e.free(), this.#e = _, this.#u = performance.now() - n, this.#i = "done", this.#a(0), this.#t({ type: "finished" });
    });
  }
  /** Reports what goes wrong; the engine then takes no more orders. */
  #f(e) {
    try {
      e();
    } catch (r) {
      this.#n = !0, this.#t({ type: "failed", error: ke(me(r)) });
    }
  }
  #A() {
    const e = this.#e;
    this.#o = {
      vertices: e.full_vertex_count,
      triangles: e.full_triangle_count,
      steps: e.step_count,
      bytes: e.stream_bytes
    };
  }
  /** Shows what is wished for, and tells it with what is new. */
  #a(e) {
    const r = performance.now(), n = this.#S(), i = this.#E(), o = this.#M(), a = this.#z(), _ = this.#e, [c, g] = [_.indices(), _.group_counts()];
    this.#h = performance.now() - r, this.#b = performance.now() + Math.max($t, Bt * this.#h);
    const u = {
      type: "update",
      state: this.#F(),
      vertices: o,
      smoothNormals: a,
      indices: c,
      groupCounts: g,
      numbers: i,
      settled: n,
      ticket: e
    };
    this.#t(u);
  }
  /** Goes to the level that is wished for; whether asking again would show the same. */
  #S() {
    const { by: e, value: r, limit: n, camera: i } = this.#w, o = this.#e;
    if (e === "view" && o.is_built && i) {
      const _ = new fe(Float64Array.from(i), r, n);
      try {
        return o.show_view(_);
      } finally {
        _.free();
      }
    }
    e === "triangles" ? o.show_triangles(r) : e === "error" ? o.show_error(r) : o.show_detail(e === "detail" ? r : 1);
    const a = o.group_counts().reduce((_, c) => _ + c, 0);
    return n > 0 && a > n && o.show_triangles(n), !0;
  }
  #E() {
    if (this.#_ === "strips") return this.#e.color_strips();
    if (this.#_ === "fans") return this.#e.color_fans();
    if (this.#_ === "surface") return;
    const e = this.#e.group_counts().reduce((r, n) => r + n, 0);
    return Uint32Array.from({ length: e }, (r, n) => n);
  }
  #M() {
    const e = this.#p;
    if (this.#e.vertex_count === e) return;
    const r = this.#e.vertices(e);
    try {
      const n = r.take_normals();
      return this.#d = n !== void 0, this.#p = this.#e.vertex_count, { first: e, positions: r.take_positions(), normals: n, colors: r.take_colors(), uvs: r.take_uvs() };
    } finally {
      r.free();
    }
  }
  #z() {
    if (!(this.#d || this.#y === this.#e.vertex_count))
      return this.#y = this.#e.vertex_count, this.#e.smooth_normals();
  }
  #F() {
    const e = this.#e;
    return {
      kind: e.kind,
      phase: this.#i,
      complete: e.is_complete,
      built: e.is_built,
      vertexCount: e.vertex_count,
      triangleCount: e.triangle_count,
      fullVertexCount: this.#o.vertices || e.full_vertex_count,
      fullTriangleCount: this.#o.triangles || e.full_triangle_count,
      stepCount: this.#o.steps || e.step_count,
      streamBytes: this.#o.bytes || e.stream_bytes,
      bounds: e.bounds(),
      diagonal: e.diagonal,
      shownSplitCount: e.shown_split_count,
      shownError: e.shown_error,
      decodeMs: this.#l,
      buildMs: this.#u,
      updateMs: this.#h
    };
  }
}
const Ee = /* @__PURE__ */ new Map();
let Ye = !1;
function qt(t) {
  const e = t instanceof URL ? t.href : t;
  let r = Ee.get(e);
  return r || (r = Dt(t), r.catch(() => Ee.delete(e)), Ee.set(e, r)), r;
}
function Ht(t) {
  Ye || ot({ module: t }), Ye = !0;
}
async function Dt(t) {
  if (t instanceof WebAssembly.Module) return t;
  if (t !== void 0 && typeof t != "string" && !(t instanceof URL))
    return WebAssembly.compile(t);
  const e = t === void 0 ? Lt() : void 0;
  if (e) return WebAssembly.compile(e);
  const r = t ?? new URL(
    /* @vite-ignore */
    "striata.wasm",
    import.meta.url
  ), n = await fetch(r).catch((i) => {
    throw new S("network", `striata.wasm could not be fetched: ${String(i)}`);
  });
  if (!n.ok)
    throw new S(
      n.status === 404 ? "not-found" : "network",
      `striata.wasm could not be fetched from ${String(r)}: the server says ${n.status}`,
      "it lies beside striata.js in the package; the option `wasm` says where else"
    );
  return WebAssembly.compile(await n.arrayBuffer());
}
function Lt() {
  if (typeof document > "u") return;
  const t = document.getElementById("striata-wasm")?.textContent?.trim();
  return t ? Uint8Array.from(atob(t), (e) => e.charCodeAt(0)) : void 0;
}
export {
  Yt as E,
  q as F,
  V as M,
  ne as S,
  ie as V,
  S as a,
  fe as b,
  me as c,
  St as d,
  It as e,
  ke as f,
  at as g,
  jt as h,
  Te as i,
  Nt as l,
  Pt as o,
  Vt as p,
  Ht as s,
  qt as w
};
