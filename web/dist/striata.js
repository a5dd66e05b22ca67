import { a as u, S as V, d as P, s as W, E as q, e as v, c as Q, w as Y, f as J } from "./wasm.js";
import { BufferGeometry as z, Vector3 as d, Box3 as K, Sphere as X, BufferAttribute as b, Color as Z, SRGBColorSpace as tt, Matrix4 as et, Mesh as rt, MeshStandardMaterial as j, DoubleSide as D, Vector2 as nt } from "three";
const k = 65536;
async function it(n, t, e) {
  if (typeof n == "string" || n instanceof URL) return st(n, t, e);
  if (n instanceof Blob) {
    const r = (s, i) => C(n.slice(s, i).stream(), e);
    return {
      name: t ?? (n instanceof File ? n.name : ""),
      length: n.size,
      pieces: r(0, n.size),
      range: (s, i) => Promise.resolve(r(s, i))
    };
  }
  if (n instanceof ArrayBuffer) {
    const r = (s, i) => $(new Uint8Array(n.slice(s, i)));
    return {
      name: t ?? "",
      length: n.byteLength,
      pieces: r(0, n.byteLength),
      range: (s, i) => Promise.resolve(r(s, i))
    };
  }
  if (n instanceof ReadableStream)
    return { name: t ?? "", length: null, pieces: C(n, e), range: null };
  throw new u("unsupported", "a model is loaded from a URL, a File, a Blob, an ArrayBuffer or a ReadableStream");
}
async function st(n, t, e) {
  const r = new URL(n, typeof document > "u" ? void 0 : document.baseURI), i = /\.striata$/i.test(r.pathname) ? { Range: `bytes=0-${k - 1}` } : {}, o = await E(r, i, e), a = /\/(\d+)$/.exec(o.headers.get("Content-Range") ?? "")?.[1], _ = o.headers.has("Content-Encoding"), l = a ?? (_ ? null : o.headers.get("Content-Length")), h = o.status === 206, c = async (g, m) => {
    const A = await E(r, { Range: `bytes=${g}-${m - 1}` }, e), R = x(A, e);
    return A.status === 206 ? R : N(R, g);
  };
  return {
    name: t ?? decodeURIComponent(r.pathname.split("/").pop() ?? ""),
    length: l === null ? null : Number(l),
    pieces: h && Number(a) > k ? ot(x(o, e), () => c(k, Number(a))) : x(o, e),
    range: h ? c : null
  };
}
async function E(n, t, e) {
  let r;
  try {
    r = await fetch(n, { headers: t, signal: e });
  } catch (i) {
    throw e.aborted ? i : new u(
      "network",
      `${n.href} could not be fetched: ${i instanceof Error ? i.message : String(i)}`,
      "is the server reachable, and does it allow this page to read (CORS)?"
    );
  }
  if (r.ok) return r;
  await r.body?.cancel();
  const s = r.status === 404 || r.status === 410 ? "not-found" : "network";
  throw new u(s, `${n.href}: the server says ${r.status} ${r.statusText}`.trim());
}
function x(n, t) {
  return n.body ? C(n.body, t) : $(new Uint8Array());
}
async function* $(n) {
  yield n;
}
async function* C(n, t) {
  const e = n.getReader(), r = () => void e.cancel(t.reason).catch(() => {
  });
  t.addEventListener("abort", r, { once: !0 });
  let s = !1;
  try {
    for (; ; ) {
      t.throwIfAborted();
      const { done: i, value: o } = await e.read();
      if (t.throwIfAborted(), i) break;
      yield o;
    }
    s = !0;
  } catch (i) {
    throw t.aborted || i instanceof u ? i : new u("network", `the connection broke: ${i instanceof Error ? i.message : String(i)}`);
  } finally {
    t.removeEventListener("abort", r), s || await e.cancel().catch(() => {
    });
  }
}
async function* N(n, t) {
  try {
    for (let e = await n.next(); !e.done; e = await n.next()) {
      const r = e.value.subarray(t);
      t = Math.max(0, t - e.value.length), r.length > 0 && (yield r);
    }
  } finally {
    await n.return?.();
  }
}
async function* ot(n, t) {
  for (let e = await n.next(); !e.done; e = await n.next()) yield e.value;
  yield* y(await t());
}
async function* at(n, t) {
  n.length > 0 && (yield n), yield* y(t);
}
async function* _t(n, t) {
  for await (const e of y(n))
    if (yield e.subarray(0, t), t -= e.length, t <= 0) return;
}
function y(n) {
  return { [Symbol.asyncIterator]: () => n };
}
function G(n) {
  if (n.length === 1) return n[0];
  const t = new Uint8Array(n.reduce((r, s) => r + s.length, 0));
  let e = 0;
  for (const r of n)
    t.set(r, e), e += r.length;
  return t;
}
const lt = [137, 83, 84, 82], U = [..."STRIATA\0"].map((n) => n.charCodeAt(0)), ht = 65536;
async function ct(n) {
  const t = new gt(n.pieces);
  if (await t.grow(U.length), t.startsWith(lt))
    return { isStream: !0, pieces: t.all(), byteCount: n.length };
  if (t.startsWith(U)) {
    const e = await dt(t);
    if (e) return ut(n, t, e);
  }
  return { isStream: !1, pieces: t.all(), byteCount: n.length };
}
async function ut(n, t, { offset: e, length: r }) {
  const s = t.bytes.length;
  return s < e && n.range && e - s > ht ? (await t.drop(), { isStream: !0, pieces: await n.range(e, e + r), byteCount: r }) : { isStream: !0, pieces: _t(N(t.all(), e), r), byteCount: r };
}
async function dt(n) {
  for (; ; ) {
    const t = V.find(n.bytes), { needed: e, offset: r, length: s } = t;
    if (t.free(), e > n.bytes.length) {
      if (!await n.grow(e)) return;
      continue;
    }
    return s > 0 ? { offset: r, length: s } : void 0;
  }
}
class gt {
  bytes = new Uint8Array();
  #t;
  constructor(t) {
    this.#t = t;
  }
  /** Reads until so many bytes are there; false if there are no more. */
  async grow(t) {
    for (; this.bytes.length < t; ) {
      const e = await this.#t.next();
      if (e.done) return !1;
      this.bytes = G([this.bytes, e.value]);
    }
    return !0;
  }
  startsWith(t) {
    return t.every((e, r) => this.bytes[r] === e);
  }
  all() {
    return at(this.bytes, this.#t);
  }
  async drop() {
    await this.#t.return?.();
  }
}
const H = '(function(){"use strict";class b{static __wrap(t){const e=Object.create(b.prototype);return e.__wbg_ptr=t,U.register(e,e.__wbg_ptr,e),e}__destroy_into_raw(){const t=this.__wbg_ptr;return this.__wbg_ptr=0,U.unregister(this),t}free(){const t=this.__destroy_into_raw();r.__wbg_failure_free(t,0)}get code(){let t,e;try{const o=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.failure_code(o,this.__wbg_ptr);var _=s().getInt32(o+0,!0),i=s().getInt32(o+4,!0);return t=_,e=i,y(_,i)}finally{r.__wbindgen_add_to_stack_pointer(16),r.__wbindgen_export(t,e,1)}}get hint(){try{const _=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.failure_hint(_,this.__wbg_ptr);var t=s().getInt32(_+0,!0),e=s().getInt32(_+4,!0);let i;return t!==0&&(i=y(t,e),r.__wbindgen_export(t,e*1,1)),i}finally{r.__wbindgen_add_to_stack_pointer(16)}}get message(){let t,e;try{const o=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.failure_message(o,this.__wbg_ptr);var _=s().getInt32(o+0,!0),i=s().getInt32(o+4,!0);return t=_,e=i,y(_,i)}finally{r.__wbindgen_add_to_stack_pointer(16),r.__wbindgen_export(t,e,1)}}}Symbol.dispose&&(b.prototype[Symbol.dispose]=b.prototype.free);class d{static __wrap(t){const e=Object.create(d.prototype);return e.__wbg_ptr=t,z.register(e,e.__wbg_ptr,e),e}__destroy_into_raw(){const t=this.__wbg_ptr;return this.__wbg_ptr=0,z.unregister(this),t}free(){const t=this.__destroy_into_raw();r.__wbg_model_free(t,0)}bounds(){try{const i=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.model_bounds(i,this.__wbg_ptr);var t=s().getInt32(i+0,!0),e=s().getInt32(i+4,!0),_=x(t,e).slice();return r.__wbindgen_export(t,e*4,4),_}finally{r.__wbindgen_add_to_stack_pointer(16)}}build(){try{const _=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.model_build(_,this.__wbg_ptr);var t=s().getInt32(_+0,!0),e=s().getInt32(_+4,!0);if(e)throw p(t)}finally{r.__wbindgen_add_to_stack_pointer(16)}}color_fans(){try{const i=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.model_color_fans(i,this.__wbg_ptr);var t=s().getInt32(i+0,!0),e=s().getInt32(i+4,!0),_=C(t,e).slice();return r.__wbindgen_export(t,e*4,4),_}finally{r.__wbindgen_add_to_stack_pointer(16)}}color_strips(){try{const a=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.model_color_strips(a,this.__wbg_ptr);var t=s().getInt32(a+0,!0),e=s().getInt32(a+4,!0),_=s().getInt32(a+8,!0),i=s().getInt32(a+12,!0);if(i)throw p(_);var o=C(t,e).slice();return r.__wbindgen_export(t,e*4,4),o}finally{r.__wbindgen_add_to_stack_pointer(16)}}get diagonal(){return r.model_diagonal(this.__wbg_ptr)}finish(){try{const _=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.model_finish(_,this.__wbg_ptr);var t=s().getInt32(_+0,!0),e=s().getInt32(_+4,!0);if(e)throw p(t)}finally{r.__wbindgen_add_to_stack_pointer(16)}}static from_file(t,e,_){try{const c=r.__wbindgen_add_to_stack_pointer(-16)>>>0;let l,h,f,w;try{l=P(t,r.__wbindgen_export3),h=u,f=J(e,r.__wbindgen_export3,r.__wbindgen_export4),w=u}catch(at){throw f&&r.__wbindgen_export(f,w*1,1),l&&r.__wbindgen_export(l,h*1,1),at}r.model_from_file(c,l,h,f,w,_);var i=s().getInt32(c+0,!0),o=s().getInt32(c+4,!0),a=s().getInt32(c+8,!0);if(a)throw p(o);return d.__wrap(i)}finally{r.__wbindgen_add_to_stack_pointer(16)}}get full_triangle_count(){return r.model_full_triangle_count(this.__wbg_ptr)>>>0}get full_vertex_count(){return r.model_full_vertex_count(this.__wbg_ptr)>>>0}get group_count(){return r.model_group_count(this.__wbg_ptr)>>>0}group_counts(){try{const i=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.model_group_counts(i,this.__wbg_ptr);var t=s().getInt32(i+0,!0),e=s().getInt32(i+4,!0),_=C(t,e).slice();return r.__wbindgen_export(t,e*4,4),_}finally{r.__wbindgen_add_to_stack_pointer(16)}}indices(){try{const i=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.model_indices(i,this.__wbg_ptr);var t=s().getInt32(i+0,!0),e=s().getInt32(i+4,!0),_=C(t,e).slice();return r.__wbindgen_export(t,e*4,4),_}finally{r.__wbindgen_add_to_stack_pointer(16)}}get is_built(){return r.model_is_built(this.__wbg_ptr)!==0}get is_complete(){return r.model_is_complete(this.__wbg_ptr)!==0}get is_ready(){return r.model_is_ready(this.__wbg_ptr)!==0}get kind(){let t,e;try{const o=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.model_kind(o,this.__wbg_ptr);var _=s().getInt32(o+0,!0),i=s().getInt32(o+4,!0);return t=_,e=i,y(_,i)}finally{r.__wbindgen_add_to_stack_pointer(16),r.__wbindgen_export(t,e,1)}}constructor(){const t=r.model_new();return this.__wbg_ptr=t,z.register(this,this.__wbg_ptr,this),this}push(t){try{const i=r.__wbindgen_add_to_stack_pointer(-16)>>>0,o=P(t,r.__wbindgen_export3),a=u;r.model_push(i,this.__wbg_ptr,o,a);var e=s().getInt32(i+0,!0),_=s().getInt32(i+4,!0);if(_)throw p(e)}finally{r.__wbindgen_add_to_stack_pointer(16)}}show_detail(t){r.model_show_detail(this.__wbg_ptr,t)}show_error(t){r.model_show_error(this.__wbg_ptr,t)}show_triangles(t){r.model_show_triangles(this.__wbg_ptr,t)}show_view(t){try{const o=r.__wbindgen_add_to_stack_pointer(-16)>>>0;Y(t,S),r.model_show_view(o,this.__wbg_ptr,t.__wbg_ptr);var e=s().getInt32(o+0,!0),_=s().getInt32(o+4,!0),i=s().getInt32(o+8,!0);if(i)throw p(_);return e!==0}finally{r.__wbindgen_add_to_stack_pointer(16)}}get shown_error(){return r.model_shown_error(this.__wbg_ptr)}get shown_split_count(){return r.model_shown_split_count(this.__wbg_ptr)>>>0}smooth_normals(){try{const i=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.model_smooth_normals(i,this.__wbg_ptr);var t=s().getInt32(i+0,!0),e=s().getInt32(i+4,!0),_=x(t,e).slice();return r.__wbindgen_export(t,e*4,4),_}finally{r.__wbindgen_add_to_stack_pointer(16)}}get step_count(){return r.model_step_count(this.__wbg_ptr)>>>0}get stream_bytes(){return r.model_stream_bytes(this.__wbg_ptr)}get triangle_count(){return r.model_triangle_count(this.__wbg_ptr)>>>0}get vertex_count(){return r.model_vertex_count(this.__wbg_ptr)>>>0}vertices(t){const e=r.model_vertices(this.__wbg_ptr,t);return k.__wrap(e)}}Symbol.dispose&&(d.prototype[Symbol.dispose]=d.prototype.free);class k{static __wrap(t){const e=Object.create(k.prototype);return e.__wbg_ptr=t,j.register(e,e.__wbg_ptr,e),e}__destroy_into_raw(){const t=this.__wbg_ptr;return this.__wbg_ptr=0,j.unregister(this),t}free(){const t=this.__destroy_into_raw();r.__wbg_vertices_free(t,0)}take_colors(){try{const _=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.vertices_take_colors(_,this.__wbg_ptr);var t=s().getInt32(_+0,!0),e=s().getInt32(_+4,!0);let i;return t!==0&&(i=q(t,e).slice(),r.__wbindgen_export(t,e*1,1)),i}finally{r.__wbindgen_add_to_stack_pointer(16)}}take_normals(){try{const _=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.vertices_take_normals(_,this.__wbg_ptr);var t=s().getInt32(_+0,!0),e=s().getInt32(_+4,!0);let i;return t!==0&&(i=x(t,e).slice(),r.__wbindgen_export(t,e*4,4)),i}finally{r.__wbindgen_add_to_stack_pointer(16)}}take_positions(){try{const i=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.vertices_take_positions(i,this.__wbg_ptr);var t=s().getInt32(i+0,!0),e=s().getInt32(i+4,!0),_=x(t,e).slice();return r.__wbindgen_export(t,e*4,4),_}finally{r.__wbindgen_add_to_stack_pointer(16)}}take_uvs(){try{const _=r.__wbindgen_add_to_stack_pointer(-16)>>>0;r.vertices_take_uvs(_,this.__wbg_ptr);var t=s().getInt32(_+0,!0),e=s().getInt32(_+4,!0);let i;return t!==0&&(i=x(t,e).slice(),r.__wbindgen_export(t,e*4,4)),i}finally{r.__wbindgen_add_to_stack_pointer(16)}}}Symbol.dispose&&(k.prototype[Symbol.dispose]=k.prototype.free);class S{__destroy_into_raw(){const t=this.__wbg_ptr;return this.__wbg_ptr=0,V.unregister(this),t}free(){const t=this.__destroy_into_raw();r.__wbg_view_free(t,0)}get pixels(){return r.__wbg_get_view_pixels(this.__wbg_ptr)}get triangle_limit(){return r.__wbg_get_view_triangle_limit(this.__wbg_ptr)>>>0}set pixels(t){r.__wbg_set_view_pixels(this.__wbg_ptr,t)}set triangle_limit(t){r.__wbg_set_view_triangle_limit(this.__wbg_ptr,t)}constructor(t,e,_){try{const c=r.__wbindgen_add_to_stack_pointer(-16)>>>0,l=+e,h=+_,f=G(t,r.__wbindgen_export3),w=u;r.view_new(c,f,w,l,h);var i=s().getInt32(c+0,!0),o=s().getInt32(c+4,!0),a=s().getInt32(c+8,!0);if(a)throw p(o);return this.__wbg_ptr=i,V.register(this,this.__wbg_ptr,this),this}finally{r.__wbindgen_add_to_stack_pointer(16)}}}Symbol.dispose&&(S.prototype[Symbol.dispose]=S.prototype.free);function N(){return{__proto__:null,"./striata_web_bg.js":{__proto__:null,__wbg___wbindgen_throw_4c88d8bf264fd984:function(t,e){throw new Error(y(t,e))},__wbg_failure_new:function(t){return b.__wrap(t)},__wbg_report_581358a93077c908:function(t,e,_,i){t.report(y(e,_),i)},__wbindgen_init_externref_table:function(){const t=r.__wbindgen_externrefs;t.set(0,void 0),t.set(1024,void 0),t.set(1025,null),t.set(1026,!0),t.set(1027,!1)}}}}const U=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(n=>r.__wbg_failure_free(n,1)),z=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(n=>r.__wbg_model_free(n,1));typeof FinalizationRegistry>"u"||new FinalizationRegistry(n=>r.__wbg_streamplace_free(n,1));const j=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(n=>r.__wbg_vertices_free(n,1)),V=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(n=>r.__wbg_view_free(n,1));function Y(n,t){if(!(n instanceof t))throw new Error(`expected instance of ${t.name}`)}function x(n,t){return n=n>>>0,H().subarray(n/4,n/4+t)}function C(n,t){return n=n>>>0,$().subarray(n/4,n/4+t)}function q(n,t){return n=n>>>0,m().subarray(n/1,n/1+t)}let g=null;function s(){return(g===null||g.buffer.detached===!0||g.buffer.detached===void 0&&g.buffer!==r.memory.buffer)&&(g=new DataView(r.memory.buffer)),g}let I=null;function H(){return(I===null||I.byteLength===0)&&(I=new Float32Array(r.memory.buffer)),I}let A=null;function X(){return(A===null||A.byteLength===0)&&(A=new Float64Array(r.memory.buffer)),A}function y(n,t){return n=n>>>0,Q(m().subarray(n,n+t))}let M=null;function $(){return(M===null||M.byteLength===0)&&(M=new Uint32Array(r.memory.buffer)),M}let F=null;function m(){return(F===null||F.byteLength===0)&&(F=new Uint8Array(r.memory.buffer)),F}function P(n,t){const e=t(n.length*1,1)>>>0;return m().set(n,e/1),u=n.length,e}function G(n,t){const e=t(n.length*8,8)>>>0;return X().set(n,e/8),u=n.length,e}function J(n,t,e){if(e===void 0){const c=E.encode(n),l=t(c.length,1)>>>0;return m().subarray(l,l+c.length).set(c),u=c.length,l}let _=n.length,i=t(_,1)>>>0;const o=m();let a=0;for(;a<_;a++){const c=n.charCodeAt(a);if(c>127)break;o[i+a]=c}if(a!==_){a!==0&&(n=n.slice(a)),i=e(i,_,_=a+n.length*3,1)>>>0;const c=m().subarray(i+a,i+_),l=E.encodeInto(n,c);a+=l.written,i=e(i,_,a,1)>>>0}return u=a,i}function p(n){const t=r.__wbindgen_externrefs.get(n);return r.__wbindgen_export2(n),t}let T=new TextDecoder("utf-8",{ignoreBOM:!0});T.decode();const K=2146435072;let R=0;function Q(n){return R+=n.length,R>=K&&(T=new TextDecoder("utf-8",{ignoreBOM:!0}),T.decode(),R=n.length),T.decode(n)}const E=new TextEncoder;"encodeInto"in E||(E.encodeInto=function(n,t){const e=E.encode(n);return t.set(e),{read:n.length,written:e.length}});let u=0,r;function Z(n,t){return r=n.exports,g=null,I=null,A=null,M=null,F=null,r.__wbindgen_start(),r}function tt(n){if(r!==void 0)return r;n!==void 0&&(Object.getPrototypeOf(n)===Object.prototype?{module:n}=n:console.warn("using deprecated parameters for `initSync()`; pass a single object instead"));const t=N();n instanceof WebAssembly.Module||(n=new WebAssembly.Module(n));const e=new WebAssembly.Instance(n,t);return Z(e)}class v extends Error{code;hint;constructor(t,e,_){super(e),this.name="StriataError",this.code=t,this.hint=_}}function D(n){if(n instanceof v)return n;if(n instanceof b){const e=new v(n.code,n.message,n.hint);return n.free(),e}if(n instanceof WebAssembly.RuntimeError||n instanceof RangeError)return new v("too-large","the model took more memory than the page has","close other pages, or load a stream with fewer triangles");if(n instanceof DOMException&&n.name==="AbortError")return et();const t=n instanceof Error?n.message:String(n);return new v("network",t)}function et(){return new v("aborted","loading was aborted")}function O(n){return{code:n.code,message:n.message,hint:n.hint}}const W=8192,rt=60,nt=4;function _t(){return new Promise(n=>{const{port1:t,port2:e}=new MessageChannel;t.onmessage=()=>{t.close(),n()},e.postMessage(null)})}class it{#e;#p;#t=new d;#r=[];#_;#c=!1;#i=!1;#h={by:"detail",value:1,limit:0};#a="surface";#n="download";#f=0;#w=!1;#b=-1;#l=0;#u=0;#d=0;#y=0;#s={vertices:0,triangles:0,steps:0,bytes:0};constructor(t,e){this.#e=t,this.#p=e}take(t){if(!this.#i)switch(t.type){case"bytes":this.#r.push(t.bytes),this.#m();break;case"end":this.#_=t.error?{error:t.error}:{},this.#m();break;case"file":this.#I(t.bytes,t.name);break;case"show":this.#h=t.wish,this.#a=t.colouring,this.#t.is_ready&&this.#g(()=>this.#o(t.ticket));break}}dispose(){this.#i=!0,this.#r=[],this.#t.free()}async#m(){if(!this.#c){for(this.#c=!0;this.#r.length>0&&!this.#i;){this.#n="decode";const t=this.#v();if(t){this.#r=[],this.#_={error:O(t)};break}this.#t.is_ready&&performance.now()>=this.#y&&this.#g(()=>this.#o(0)),await _t()}this.#c=!1,this.#_&&!this.#i&&this.#k(this.#_.error)}}#v(){const t=performance.now();try{for(;performance.now()-t<this.#p;){const e=this.#r.shift();if(!e)break;this.#t.push(e.subarray(0,W)),e.length>W&&this.#r.unshift(e.subarray(W))}return}catch(e){return D(e)}finally{this.#l+=performance.now()-t}}#k(t){let e=t;try{if(!e&&!this.#t.is_complete&&(e={code:"corrupt",message:"the stream ends before the mesh does",hint:"was the file copied whole?"}),(e?.code!=="corrupt"||!t)&&this.#x(),!this.#t.is_ready)throw new v("corrupt","the stream ends before there is anything to draw");this.#A(),this.#n="build",this.#o(0),this.#e({type:"building",share:0});const _=performance.now();this.#t.build(),this.#u=performance.now()-_,this.#n="done",this.#o(0)}catch(_){e??=O(D(_))}this.#_=void 0,this.#e(e?{type:"failed",error:e}:{type:"finished"})}#x(){const t=performance.now();try{this.#t.finish()}finally{this.#l+=performance.now()-t}}#I(t,e){this.#n="build";const _=performance.now(),i={report:(o,a)=>this.#e({type:"building",share:a})};this.#g(()=>{const o=d.from_file(t,e,i);this.#t.free(),this.#t=o,this.#u=performance.now()-_,this.#n="done",this.#o(0),this.#e({type:"finished"})})}#g(t){try{t()}catch(e){this.#i=!0,this.#e({type:"failed",error:O(D(e))})}}#A(){const t=this.#t;this.#s={vertices:t.full_vertex_count,triangles:t.full_triangle_count,steps:t.step_count,bytes:t.stream_bytes}}#o(t){const e=performance.now(),_=this.#M(),i=this.#F(),o=this.#E(),a=this.#S(),c=this.#t,[l,h]=[c.indices(),c.group_counts()];this.#d=performance.now()-e,this.#y=performance.now()+Math.max(rt,nt*this.#d);const w={type:"update",state:this.#C(),vertices:o,smoothNormals:a,indices:l,groupCounts:h,numbers:i,settled:_,ticket:t};this.#e(w)}#M(){const{by:t,value:e,limit:_,camera:i}=this.#h,o=this.#t;if(t==="view"&&o.is_built&&i){const c=new S(Float64Array.from(i),e,_);try{return o.show_view(c)}finally{c.free()}}t==="triangles"?o.show_triangles(e):t==="error"?o.show_error(e):o.show_detail(t==="detail"?e:1);const a=o.group_counts().reduce((c,l)=>c+l,0);return _>0&&a>_&&o.show_triangles(_),!0}#F(){if(this.#a==="strips")return this.#t.color_strips();if(this.#a==="fans")return this.#t.color_fans();if(this.#a==="surface")return;const t=this.#t.group_counts().reduce((e,_)=>e+_,0);return Uint32Array.from({length:t},(e,_)=>_)}#E(){const t=this.#f;if(this.#t.vertex_count===t)return;const e=this.#t.vertices(t);try{const _=e.take_normals();return this.#w=_!==void 0,this.#f=this.#t.vertex_count,{first:t,positions:e.take_positions(),normals:_,colors:e.take_colors(),uvs:e.take_uvs()}}finally{e.free()}}#S(){if(!(this.#w||this.#b===this.#t.vertex_count))return this.#b=this.#t.vertex_count,this.#t.smooth_normals()}#C(){const t=this.#t;return{kind:t.kind,phase:this.#n,complete:t.is_complete,built:t.is_built,vertexCount:t.vertex_count,triangleCount:t.triangle_count,fullVertexCount:this.#s.vertices||t.full_vertex_count,fullTriangleCount:this.#s.triangles||t.full_triangle_count,stepCount:this.#s.steps||t.step_count,streamBytes:this.#s.bytes||t.stream_bytes,bounds:t.bounds(),diagonal:t.diagonal,shownSplitCount:t.shown_split_count,shownError:t.shown_error,decodeMs:this.#l,buildMs:this.#u,updateMs:this.#d}}}function st(n){if(n.type!=="update")return[];const{vertices:t,indices:e,groupCounts:_,numbers:i,smoothNormals:o}=n,a=[e,_,i,o];return t&&a.push(t.positions,t.normals,t.colors,t.uvs),a.flatMap(c=>c?[c.buffer]:[])}const ot=30,B=self;let L;B.onmessage=({data:n})=>{n instanceof WebAssembly.Module?(tt({module:n}),L=new it(t=>B.postMessage(t,st(t)),ot)):L?.take(n)}})();\n', L = typeof self < "u" && self.Blob && new Blob([H], { type: "text/javascript;charset=utf-8" });
function ft(n) {
  let t;
  try {
    if (t = L && (self.URL || self.webkitURL).createObjectURL(L), !t) throw "";
    const e = new Worker(t, {
      name: n?.name
    });
    return e.addEventListener("error", () => {
      (self.URL || self.webkitURL).revokeObjectURL(t);
    }), e;
  } catch {
    return new Worker(
      "data:text/javascript;charset=utf-8," + encodeURIComponent(H),
      {
        name: n?.name
      }
    );
  } finally {
    t && (self.URL || self.webkitURL).revokeObjectURL(t);
  }
}
const pt = 6;
function wt(n, t, e) {
  return t && bt(n, e) || yt(n, e);
}
function bt(n, t) {
  let e;
  try {
    e = new ft(), e.postMessage(n);
  } catch {
    return;
  }
  return e.onmessage = ({ data: r }) => t(r), e.onerror = (r) => {
    r.preventDefault();
    const s = r.message || "the worker could not start", i = new u("unsupported", `the worker failed: ${s}`, "try the option worker: false");
    t({ type: "failed", error: P(i) });
  }, {
    // Bytes are copied: a piece may be a part of a buffer that others still read.
    order: (r) => e.postMessage(r),
    dispose: () => e.terminate()
  };
}
function yt(n, t) {
  W(n);
  let e = !1;
  const r = (i) => queueMicrotask(() => void (e || i())), s = new q((i) => r(() => t(i)), pt);
  return {
    order: (i) => r(() => s.take(i)),
    dispose: () => {
      e = !0, s.dispose();
    }
  };
}
const mt = 1024;
class vt extends z {
  /** Smallest and largest coordinates. */
  bounds = [];
  #t = 0;
  #e = !1;
  computeBoundingBox() {
    const [t, e] = [0, 3].map((r) => new d().fromArray(this.bounds.length === 6 ? Array.from(this.bounds) : new Array(6).fill(0), r));
    this.boundingBox = new K(t, e);
  }
  computeBoundingSphere() {
    this.computeBoundingBox(), this.boundingSphere = this.boundingBox.getBoundingSphere(new X());
  }
  /** Takes what an update brings. */
  take({ state: t, vertices: e, smoothNormals: r, indices: s, groupCounts: i }, o) {
    if (this.bounds = t.bounds, this.#i(t.vertexCount, t.fullVertexCount), e) {
      const { first: a, positions: _, normals: l, colors: h, uvs: c } = e;
      this.#r("position", _, 3, a), l && this.#r("normal", l, 3, a), h && this.#r("color", h, 4, a), c && this.#r("uv", c, 2, a);
    }
    if (r && this.#r("normal", r, 3, 0), this.#n(s, 3 * t.fullTriangleCount), this.clearGroups(), o) {
      let a = 0;
      i.forEach((_, l) => {
        this.addGroup(a, 3 * _, l), a += 3 * _;
      });
    }
    this.computeBoundingSphere(), this.#e = !1;
  }
  #i(t, e) {
    t <= this.#t || (this.#t = B(this.#t, t, e), this.#e = !0, this.dispose());
  }
  /** Writes numbers of vertices from one on. */
  #r(t, e, r, s) {
    let i = this.getAttribute(t);
    if (!i || this.#e && i.count !== this.#t) {
      const o = e instanceof Uint8Array ? new Uint8Array(this.#t * r) : new Float32Array(this.#t * r);
      i && o.set(i.array.subarray(0, s * r)), i = new b(o, r, e instanceof Uint8Array), this.setAttribute(t, i);
    } else
      i.addUpdateRange(s * r, e.length);
    i.array.set(e, s * r), i.needsUpdate = !0;
  }
  #n(t, e) {
    let r = this.index;
    if (!r || r.count < t.length) {
      r && this.dispose();
      const s = new Uint32Array(B(r?.count ?? 0, t.length, e));
      r = new b(s, 1), this.setIndex(r);
    } else
      r.addUpdateRange(0, t.length);
    r.array.set(t), r.needsUpdate = !0, this.setDrawRange(0, t.length);
  }
}
function B(n, t, e) {
  const r = Math.max(mt, 2 * n, t);
  return e >= t ? Math.min(r, e) : r;
}
const S = 1024, kt = 2654435761, xt = Mt();
function St(n, t, e) {
  const r = { positions: new Float32Array(3 * t.length), colors: new Uint8Array(4 * t.length) };
  for (let i = 0; i < t.length; i++) {
    const o = 3 * t[i], a = 3 * (Math.imul(e[i / 3 | 0], kt) >>> 22);
    for (let _ = 0; _ < 3; _++)
      r.positions[3 * i + _] = n[o + _], r.colors[4 * i + _] = xt[a + _];
    r.colors[4 * i + 3] = 255;
  }
  const s = new z();
  return s.setAttribute("position", new b(r.positions, 3)), s.setAttribute("color", new b(r.colors, 4, !0)), s;
}
function Mt() {
  const n = new Uint8Array(3 * S), t = new Z();
  for (let e = 0; e < S; e++)
    t.setHSL(e / S, 0.62, 0.5 + 0.1 * (e % 3), tt), [t.r, t.g, t.b].forEach((r, s) => n[3 * e + s] = Math.round(255 * r));
  return n;
}
const f = new et(), [F, T, O, M] = [new d(), new d(), new d(), new d()];
function It(n, t, e, r) {
  if (!(e >= 1 && r >= 1)) return;
  M.setFromMatrixScale(n.matrixWorld);
  const [s, i] = [Math.min(...M.toArray()), Math.max(...M.toArray())];
  if (!(s > 0)) return;
  if (t.isOrthographicCamera) {
    const { top: c, bottom: g, zoom: m } = t;
    return { kind: "orthographic", unitsPerPixel: Math.abs(c - g) / (m * r * i) };
  }
  if (!t.isPerspectiveCamera) return;
  f.copy(n.matrixWorld).invert(), F.setFromMatrixPosition(t.matrixWorld).applyMatrix4(f), T.set(0, 0, -1).applyMatrix4(t.matrixWorld).applyMatrix4(f), O.setFromMatrixColumn(t.matrixWorld, 1).transformDirection(f);
  const o = t.projectionMatrix.elements, a = [(1 + Math.abs(o[8])) / o[0], (1 + Math.abs(o[9])) / o[5]], _ = r * o[5] * a[1], l = [Math.max(1, Math.round(_ * a[0] / a[1])), Math.max(1, Math.round(_))], h = [...F.toArray(), ...T.toArray(), ...O.toArray(), a[1], ...l];
  if (h.every(Number.isFinite))
    return { kind: "perspective", numbers: h, stretch: i / s };
}
const p = new nt();
class Ct extends rt {
  isStriataMesh = !0;
  finished;
  state;
  #t;
  #e;
  /** Made here, and freed here. */
  #i;
  #r;
  #n;
  #h;
  #a = 1;
  #s = null;
  #_ = null;
  #o = null;
  #f = !1;
  #l = "surface";
  #g = !1;
  /** The request that has not been answered yet, and whether another has to follow it. */
  #c = 0;
  #u = !1;
  #d = !1;
  #p = { by: "detail", value: 1, limit: 0 };
  /** The last camera, as a wish; for views a wish is made when the mesh is drawn. */
  #w;
  #x = !0;
  #b = !1;
  #S;
  #v;
  constructor(t, e, r) {
    const s = new vt(), i = e ? void 0 : Rt(t);
    super(s, e ?? i), this.#e = s, this.#r = this.material, this.#i = i, this.#t = r, this.state = t.state, this.#h = t, this.finished = new Promise((o, a) => {
      this.#S = o, this.#v = a;
    }), this.finished.catch(() => {
    }), this.onBeforeRender = (o, a, _) => this.#C(o, a, _), this.update(t);
  }
  get detail() {
    return this.#a ?? (this.stepCount > 0 ? this.splitCount / this.stepCount : 1);
  }
  set detail(t) {
    this.#a = Math.min(1, Math.max(0, w(t, "detail"))), [this.#s, this.#_, this.#o] = [null, null, null], this.#y();
  }
  get triangleBudget() {
    return this.#s;
  }
  set triangleBudget(t) {
    this.#s = t === null ? null : Math.max(1, Math.floor(w(t, "triangleBudget"))), this.#k(), this.#y();
  }
  get error() {
    return this.state.shownError;
  }
  get maxError() {
    return this.#_;
  }
  set maxError(t) {
    this.#_ = t === null ? null : Math.max(0, w(t, "maxError")), t !== null && (this.#o = null), this.#k(), this.#y();
  }
  get pixelError() {
    return this.#o;
  }
  set pixelError(t) {
    this.#o = t === null ? null : Math.max(0, w(t, "pixelError")), t !== null && (this.#_ = null), this.#k(), this.#y(), this.dispatchStriata({ type: "change" });
  }
  get frozen() {
    return this.#f;
  }
  set frozen(t) {
    this.#f = t, this.dispatchStriata({ type: "change" });
  }
  get colouring() {
    return this.#l;
  }
  set colouring(t) {
    t !== this.#l && (this.#l === "surface" && (this.#r = this.material), this.#l = t, this.#d = !0, this.#m());
  }
  get wireframe() {
    return this.#g;
  }
  set wireframe(t) {
    this.#g = t;
    for (const e of [this.material].flat()) I(e, t);
    this.dispatchStriata({ type: "change" });
  }
  get triangleCount() {
    return this.#h.indices.length / 3;
  }
  get fullTriangleCount() {
    return this.state.fullTriangleCount;
  }
  get vertexCount() {
    return this.state.vertexCount;
  }
  get splitCount() {
    return this.state.shownSplitCount;
  }
  get stepCount() {
    return this.state.stepCount;
  }
  get complete() {
    return this.state.complete;
  }
  get bytesReceived() {
    return this.#t.bytes().received;
  }
  get bytesTotal() {
    return this.#t.bytes().total ?? (this.state.streamBytes || null);
  }
  get diagonal() {
    return this.state.diagonal;
  }
  get kind() {
    return this.state.kind;
  }
  get timings() {
    const { decodeMs: t, buildMs: e, updateMs: r } = this.state;
    return { decodeMs: t, buildMs: e, updateMs: r };
  }
  dispose() {
    this.#b || (this.#b = !0, this.#t.dispose(), this.#e.dispose(), this.geometry !== this.#e && this.geometry.dispose(), this.#i?.dispose(), this.#n?.dispose(), this.#v(new u("aborted", "the mesh was disposed of")));
  }
  /** Takes another level; called by the loader. */
  update(t) {
    this.#b || (this.state = t.state, this.#h = t, this.#e.take(t, Array.isArray(this.#r)), this.#M(t), t.ticket === this.#c && (this.#u = !1, this.#x = t.settled), this.#d && this.#m(), this.dispatchStriata({ type: "change" }));
  }
  /** Nothing more comes; called by the loader. */
  end(t) {
    if (!t) {
      this.#S();
      return;
    }
    this.#v(t), this.dispatchStriata({ type: "error", error: t });
  }
  /** Shows the surface, or triangles in the colours of what draws them. */
  #M({ numbers: t, indices: e }) {
    const r = this.geometry;
    if (t && this.#l !== "surface")
      this.#n ??= new j({ vertexColors: !0, flatShading: !0, side: D, roughness: 0.9 }), I(this.#n, this.#g), this.geometry = St(this.#e.getAttribute("position").array, e, t), this.geometry.boundingSphere = this.#e.boundingSphere, this.geometry.boundingBox = this.#e.boundingBox, this.material = this.#n;
    else if (this.geometry !== this.#e && this.#l === "surface") {
      this.geometry = this.#e, this.material = this.#r;
      for (const s of [this.material].flat()) I(s, this.#g);
    }
    r !== this.geometry && r !== this.#e && r.dispose();
  }
  #k() {
    const t = [this.#s, this.#_, this.#o];
    this.#a = t.every((e) => e === null) ? 1 : null;
  }
  /** Sends a wish, at once or when the last one is answered. */
  #y() {
    this.#d = !0, this.#m();
  }
  #m() {
    this.#u || this.#b || (this.#d = !1, this.#u = !0, this.#p = this.#I(), this.#t.order({ type: "show", wish: this.#p, colouring: this.#l, ticket: ++this.#c }));
  }
  #I() {
    const t = this.#s ?? 0;
    return this.#o !== null ? this.#w ?? { by: "detail", value: t > 0 ? 1 : 0, limit: t } : this.#_ !== null ? { by: "error", value: this.#_, limit: t } : this.#s !== null ? { by: "triangles", value: this.#s, limit: t } : { by: "detail", value: this.#a ?? 1, limit: 0 };
  }
  /** Follows the camera that the mesh is about to be drawn for. */
  #C(t, e, r) {
    if (this.#o === null || this.#f) return;
    const s = t.getRenderTarget();
    s ? p.set(s.width, s.height) : t.getDrawingBufferSize(p);
    const i = It(this, r, p.x, p.y);
    if (!i) return;
    const o = this.#s ?? 0;
    this.#w = i.kind === "perspective" ? { by: "view", value: this.#o / i.stretch, limit: o, camera: i.numbers } : { by: "error", value: this.#o * i.unitsPerPixel, limit: o }, !(!this.state.built && this.#p.by === this.#w.by) && (this.#x && At(this.#w, this.#p) || this.#m());
  }
  /** three's types know no events but their own. */
  dispatchStriata(t) {
    this.dispatchEvent(t);
  }
}
function w(n, t) {
  if (Number.isNaN(Number(n))) throw new TypeError(`${t} has to be a number, not ${String(n)}`);
  return Number(n);
}
function At(n, t) {
  const e = n.camera?.length === t.camera?.length && (n.camera ?? []).every((r, s) => r === t.camera?.[s]);
  return n.by === t.by && n.value === t.value && n.limit === t.limit && e;
}
function I(n, t) {
  "wireframe" in n && (n.wireframe = t);
}
function Rt({ vertices: n }) {
  return new j({ vertexColors: n?.colors !== void 0, side: D, roughness: 0.8, metalness: 0 });
}
function Et(n = {}) {
  return {
    load: (t, e = {}) => new Ut(n, e).run(t)
  };
}
const Ft = function(n) {
  return Et(n);
};
class Ut {
  #t;
  #e;
  #i = new AbortController();
  #r;
  #n;
  #h = 0;
  #a = null;
  #s;
  #_;
  constructor(t, e) {
    this.#t = t, this.#e = e;
  }
  run(t) {
    const { signal: e } = this.#e;
    if (e?.aborted) return Promise.reject(v());
    const r = new Promise((i, o) => {
      this.#s = i, this.#_ = o;
    }), s = () => this.#u(v());
    return e?.addEventListener("abort", s, { once: !0 }), this.#i.signal.addEventListener("abort", () => e?.removeEventListener("abort", s)), this.#o(t).catch((i) => this.#f(Q(i))), r;
  }
  async #o(t) {
    const [e, r] = await Promise.all([
      Y(this.#t.wasm),
      it(t, this.#e.name, this.#i.signal)
    ]);
    if (this.#i.signal.aborted) return;
    W(e), this.#a = r.length;
    const s = await ct(r);
    if (this.#i.signal.aborted) return;
    this.#a = s.byteCount, this.#r = wt(e, this.#t.worker ?? !0, (o) => this.#l(o));
    const i = [];
    for await (const o of y(s.pieces)) {
      if (this.#i.signal.aborted) return;
      this.#h += o.length, s.isStream ? this.#r.order({ type: "bytes", bytes: o }) : i.push(o), this.#c();
    }
    this.#i.signal.aborted || (this.#a = this.#h, s.isStream ? this.#r.order({ type: "end" }) : this.#r.order({ type: "file", bytes: G(i), name: r.name }), this.#c());
  }
  /** The source failed: what has come of it may be something nevertheless. */
  #f(t) {
    this.#r && t.code !== "aborted" ? this.#r.order({ type: "end", error: P(t) }) : this.#u(t);
  }
  #l(t) {
    if (!this.#i.signal.aborted)
      switch (t.type) {
        case "update":
          this.#n ? this.#n.update(t) : (t.indices.length > 0 || t.state.complete) && (this.#n = new Ct(t, this.#e.material, this.#g()), this.#n.name = this.#e.name ?? "", this.#s(this.#n)), this.#c();
          break;
        case "building":
          this.#c("build");
          break;
        case "failed":
          this.#u(J(t.error));
          break;
        case "finished":
          this.#n?.end(), this.#c();
          break;
      }
  }
  /** What the mesh needs of us. */
  #g() {
    return {
      order: (t) => this.#r?.order(t),
      bytes: () => ({ received: this.#h, total: this.#a }),
      dispose: () => this.#d()
    };
  }
  #c(t) {
    const e = this.#n?.state, r = {
      bytesReceived: this.#h,
      bytesTotal: this.#a ?? (e?.streamBytes || null),
      triangleCount: e?.triangleCount ?? 0,
      vertexCount: e?.vertexCount ?? 0,
      complete: e?.complete ?? !1,
      phase: t ?? e?.phase ?? "download"
    };
    this.#e.onProgress?.(r), this.#n?.dispatchStriata({ type: "progress", progress: r });
  }
  /** Ends loading; a mesh that is there stays, with what it has. */
  #u(t) {
    if (!this.#i.signal.aborted) {
      if (this.#n && t.code !== "aborted") {
        this.#n.end(t);
        return;
      }
      this.#n?.end(t), this.#d(), this.#_(t);
    }
  }
  #d() {
    this.#i.abort(v()), this.#r?.dispose();
  }
}
export {
  u as StriataError,
  Ft as StriataLoader,
  Ct as StriataMesh
};
