import { d as A, p as O, S as W, l as P, e as j, a as E, f as C, s as R, E as D, g as w, c as $, w as N, o as G, i as V, h as H } from "./wasm.js";
import { BufferGeometry as z, Vector3 as u, Box3 as q, Sphere as Q, BufferAttribute as p, Color as Y, SRGBColorSpace as J, Matrix4 as K, Mesh as X, MeshStandardMaterial as U, DoubleSide as B, Vector2 as Z } from "three";
const tt = [137, 83, 84, 82], v = [..."STRIATA\0"].map((n) => n.charCodeAt(0)), et = 65536;
async function rt(n) {
  const t = new st(n.pieces);
  if (await t.grow(v.length), t.startsWith(tt))
    return { isStream: !0, pieces: t.all(), byteCount: n.length };
  if (t.startsWith(v)) {
    const e = await it(t);
    if (e) return nt(n, t, e);
  }
  return { isStream: !1, pieces: t.all(), byteCount: n.length };
}
async function nt(n, t, { offset: e, length: r }) {
  const i = t.bytes.length;
  return i < e && n.range && e - i > et ? (await t.drop(), { isStream: !0, pieces: await n.range(e, e + r), byteCount: r }) : { isStream: !0, pieces: P(j(t.all(), e), r), byteCount: r };
}
async function it(n) {
  for (; ; ) {
    const t = W.find(n.bytes), { needed: e, offset: r, length: i } = t;
    if (t.free(), e > n.bytes.length) {
      if (!await n.grow(e)) return;
      continue;
    }
    return i > 0 ? { offset: r, length: i } : void 0;
  }
}
class st {
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
      this.bytes = A([this.bytes, e.value]);
    }
    return !0;
  }
  startsWith(t) {
    return t.every((e, r) => this.bytes[r] === e);
  }
  all() {
    return O(this.bytes, this.#t);
  }
  async drop() {
    await this.#t.return?.();
  }
}
const F = '(function(){"use strict";class N{static __wrap(e){const r=Object.create(N.prototype);return r.__wbg_ptr=e,Me.register(r,r.__wbg_ptr,r),r}__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,Me.unregister(this),e}free(){const e=this.__destroy_into_raw();s.__wbg_failure_free(e,0)}get code(){let e,r;try{const o=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.failure_code(o,this.__wbg_ptr);var n=c().getInt32(o+0,!0),i=c().getInt32(o+4,!0);return e=n,r=i,Y(n,i)}finally{s.__wbindgen_add_to_stack_pointer(16),s.__wbindgen_export(e,r,1)}}get hint(){try{const n=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.failure_hint(n,this.__wbg_ptr);var e=c().getInt32(n+0,!0),r=c().getInt32(n+4,!0);let i;return e!==0&&(i=Y(e,r),s.__wbindgen_export(e,r*1,1)),i}finally{s.__wbindgen_add_to_stack_pointer(16)}}get message(){let e,r;try{const o=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.failure_message(o,this.__wbg_ptr);var n=c().getInt32(o+0,!0),i=c().getInt32(o+4,!0);return e=n,r=i,Y(n,i)}finally{s.__wbindgen_add_to_stack_pointer(16),s.__wbindgen_export(e,r,1)}}}Symbol.dispose&&(N.prototype[Symbol.dispose]=N.prototype.free);class j{static __wrap(e){const r=Object.create(j.prototype);return r.__wbg_ptr=e,we.register(r,r.__wbg_ptr,r),r}__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,we.unregister(this),e}free(){const e=this.__destroy_into_raw();s.__wbg_model_free(e,0)}bounds(){try{const i=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.model_bounds(i,this.__wbg_ptr);var e=c().getInt32(i+0,!0),r=c().getInt32(i+4,!0),n=X(e,r).slice();return s.__wbindgen_export(e,r*4,4),n}finally{s.__wbindgen_add_to_stack_pointer(16)}}build(){try{const n=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.model_build(n,this.__wbg_ptr);var e=c().getInt32(n+0,!0),r=c().getInt32(n+4,!0);if(r)throw P(e)}finally{s.__wbindgen_add_to_stack_pointer(16)}}color_fans(){try{const i=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.model_color_fans(i,this.__wbg_ptr);var e=c().getInt32(i+0,!0),r=c().getInt32(i+4,!0),n=oe(e,r).slice();return s.__wbindgen_export(e,r*4,4),n}finally{s.__wbindgen_add_to_stack_pointer(16)}}color_strips(){try{const _=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.model_color_strips(_,this.__wbg_ptr);var e=c().getInt32(_+0,!0),r=c().getInt32(_+4,!0),n=c().getInt32(_+8,!0),i=c().getInt32(_+12,!0);if(i)throw P(n);var o=oe(e,r).slice();return s.__wbindgen_export(e,r*4,4),o}finally{s.__wbindgen_add_to_stack_pointer(16)}}get diagonal(){return s.model_diagonal(this.__wbg_ptr)}finish(){try{const n=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.model_finish(n,this.__wbg_ptr);var e=c().getInt32(n+0,!0),r=c().getInt32(n+4,!0);if(r)throw P(e)}finally{s.__wbindgen_add_to_stack_pointer(16)}}static from_file(e,r,n){try{const a=s.__wbindgen_add_to_stack_pointer(-16)>>>0;let l,p,d,h;try{l=Fe(e,s.__wbindgen_export3),p=W,d=He(r,s.__wbindgen_export3,s.__wbindgen_export4),h=W}catch(b){throw d&&s.__wbindgen_export(d,h*1,1),l&&s.__wbindgen_export(l,p*1,1),b}s.model_from_file(a,l,p,d,h,n);var i=c().getInt32(a+0,!0),o=c().getInt32(a+4,!0),_=c().getInt32(a+8,!0);if(_)throw P(o);return j.__wrap(i)}finally{s.__wbindgen_add_to_stack_pointer(16)}}get full_triangle_count(){return s.model_full_triangle_count(this.__wbg_ptr)>>>0}get full_vertex_count(){return s.model_full_vertex_count(this.__wbg_ptr)>>>0}get group_count(){return s.model_group_count(this.__wbg_ptr)>>>0}group_counts(){try{const i=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.model_group_counts(i,this.__wbg_ptr);var e=c().getInt32(i+0,!0),r=c().getInt32(i+4,!0),n=oe(e,r).slice();return s.__wbindgen_export(e,r*4,4),n}finally{s.__wbindgen_add_to_stack_pointer(16)}}indices(){try{const i=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.model_indices(i,this.__wbg_ptr);var e=c().getInt32(i+0,!0),r=c().getInt32(i+4,!0),n=oe(e,r).slice();return s.__wbindgen_export(e,r*4,4),n}finally{s.__wbindgen_add_to_stack_pointer(16)}}get is_built(){return s.model_is_built(this.__wbg_ptr)!==0}get is_complete(){return s.model_is_complete(this.__wbg_ptr)!==0}get is_ready(){return s.model_is_ready(this.__wbg_ptr)!==0}get kind(){let e,r;try{const o=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.model_kind(o,this.__wbg_ptr);var n=c().getInt32(o+0,!0),i=c().getInt32(o+4,!0);return e=n,r=i,Y(n,i)}finally{s.__wbindgen_add_to_stack_pointer(16),s.__wbindgen_export(e,r,1)}}constructor(){const e=s.model_new();return this.__wbg_ptr=e,we.register(this,this.__wbg_ptr,this),this}push(e){try{const i=s.__wbindgen_add_to_stack_pointer(-16)>>>0,o=Fe(e,s.__wbindgen_export3),_=W;s.model_push(i,this.__wbg_ptr,o,_);var r=c().getInt32(i+0,!0),n=c().getInt32(i+4,!0);if(n)throw P(r)}finally{s.__wbindgen_add_to_stack_pointer(16)}}show_detail(e){s.model_show_detail(this.__wbg_ptr,e)}show_error(e){s.model_show_error(this.__wbg_ptr,e)}show_triangles(e){s.model_show_triangles(this.__wbg_ptr,e)}show_view(e){try{const o=s.__wbindgen_add_to_stack_pointer(-16)>>>0;Pe(e,se),s.model_show_view(o,this.__wbg_ptr,e.__wbg_ptr);var r=c().getInt32(o+0,!0),n=c().getInt32(o+4,!0),i=c().getInt32(o+8,!0);if(i)throw P(n);return r!==0}finally{s.__wbindgen_add_to_stack_pointer(16)}}get shown_error(){return s.model_shown_error(this.__wbg_ptr)}get shown_split_count(){return s.model_shown_split_count(this.__wbg_ptr)>>>0}smooth_normals(){try{const i=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.model_smooth_normals(i,this.__wbg_ptr);var e=c().getInt32(i+0,!0),r=c().getInt32(i+4,!0),n=X(e,r).slice();return s.__wbindgen_export(e,r*4,4),n}finally{s.__wbindgen_add_to_stack_pointer(16)}}get step_count(){return s.model_step_count(this.__wbg_ptr)>>>0}get stream_bytes(){return s.model_stream_bytes(this.__wbg_ptr)}get triangle_count(){return s.model_triangle_count(this.__wbg_ptr)>>>0}get vertex_count(){return s.model_vertex_count(this.__wbg_ptr)>>>0}vertices(e){const r=s.model_vertices(this.__wbg_ptr,e);return H.__wrap(r)}}Symbol.dispose&&(j.prototype[Symbol.dispose]=j.prototype.free);class H{static __wrap(e){const r=Object.create(H.prototype);return r.__wbg_ptr=e,ze.register(r,r.__wbg_ptr,r),r}__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,ze.unregister(this),e}free(){const e=this.__destroy_into_raw();s.__wbg_vertices_free(e,0)}take_colors(){try{const n=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.vertices_take_colors(n,this.__wbg_ptr);var e=c().getInt32(n+0,!0),r=c().getInt32(n+4,!0);let i;return e!==0&&(i=Le(e,r).slice(),s.__wbindgen_export(e,r*1,1)),i}finally{s.__wbindgen_add_to_stack_pointer(16)}}take_normals(){try{const n=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.vertices_take_normals(n,this.__wbg_ptr);var e=c().getInt32(n+0,!0),r=c().getInt32(n+4,!0);let i;return e!==0&&(i=X(e,r).slice(),s.__wbindgen_export(e,r*4,4)),i}finally{s.__wbindgen_add_to_stack_pointer(16)}}take_positions(){try{const i=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.vertices_take_positions(i,this.__wbg_ptr);var e=c().getInt32(i+0,!0),r=c().getInt32(i+4,!0),n=X(e,r).slice();return s.__wbindgen_export(e,r*4,4),n}finally{s.__wbindgen_add_to_stack_pointer(16)}}take_uvs(){try{const n=s.__wbindgen_add_to_stack_pointer(-16)>>>0;s.vertices_take_uvs(n,this.__wbg_ptr);var e=c().getInt32(n+0,!0),r=c().getInt32(n+4,!0);let i;return e!==0&&(i=X(e,r).slice(),s.__wbindgen_export(e,r*4,4)),i}finally{s.__wbindgen_add_to_stack_pointer(16)}}}Symbol.dispose&&(H.prototype[Symbol.dispose]=H.prototype.free);class se{__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,Ee.unregister(this),e}free(){const e=this.__destroy_into_raw();s.__wbg_view_free(e,0)}get pixels(){return s.__wbg_get_view_pixels(this.__wbg_ptr)}get triangle_limit(){return s.__wbg_get_view_triangle_limit(this.__wbg_ptr)>>>0}set pixels(e){s.__wbg_set_view_pixels(this.__wbg_ptr,e)}set triangle_limit(e){s.__wbg_set_view_triangle_limit(this.__wbg_ptr,e)}constructor(e,r,n){try{const a=s.__wbindgen_add_to_stack_pointer(-16)>>>0,l=+r,p=+n,d=qe(e,s.__wbindgen_export3),h=W;s.view_new(a,d,h,l,p);var i=c().getInt32(a+0,!0),o=c().getInt32(a+4,!0),_=c().getInt32(a+8,!0);if(_)throw P(o);return this.__wbg_ptr=i,Ee.register(this,this.__wbg_ptr,this),this}finally{s.__wbindgen_add_to_stack_pointer(16)}}}Symbol.dispose&&(se.prototype[Symbol.dispose]=se.prototype.free);function Ve(){return{__proto__:null,"./striata_web_bg.js":{__proto__:null,__wbg___wbindgen_throw_4c88d8bf264fd984:function(e,r){throw new Error(Y(e,r))},__wbg_failure_new:function(e){return N.__wrap(e)},__wbg_report_581358a93077c908:function(e,r,n,i){e.report(Y(r,n),i)},__wbindgen_init_externref_table:function(){const e=s.__wbindgen_externrefs;e.set(0,void 0),e.set(1024,void 0),e.set(1025,null),e.set(1026,!0),e.set(1027,!1)}}}}const Me=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(t=>s.__wbg_failure_free(t,1)),we=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(t=>s.__wbg_model_free(t,1));typeof FinalizationRegistry>"u"||new FinalizationRegistry(t=>s.__wbg_streamplace_free(t,1));const ze=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(t=>s.__wbg_vertices_free(t,1)),Ee=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(t=>s.__wbg_view_free(t,1));function Pe(t,e){if(!(t instanceof e))throw new Error(`expected instance of ${e.name}`)}function X(t,e){return t=t>>>0,$e().subarray(t/4,t/4+e)}function oe(t,e){return t=t>>>0,Ye().subarray(t/4,t/4+e)}function Le(t,e){return t=t>>>0,q().subarray(t/1,t/1+e)}let V=null;function c(){return(V===null||V.buffer.detached===!0||V.buffer.detached===void 0&&V.buffer!==s.memory.buffer)&&(V=new DataView(s.memory.buffer)),V}let G=null;function $e(){return(G===null||G.byteLength===0)&&(G=new Float32Array(s.memory.buffer)),G}let J=null;function Ne(){return(J===null||J.byteLength===0)&&(J=new Float64Array(s.memory.buffer)),J}function Y(t,e){return t=t>>>0,Ge(q().subarray(t,t+e))}let K=null;function Ye(){return(K===null||K.byteLength===0)&&(K=new Uint32Array(s.memory.buffer)),K}let Q=null;function q(){return(Q===null||Q.byteLength===0)&&(Q=new Uint8Array(s.memory.buffer)),Q}function Fe(t,e){const r=e(t.length*1,1)>>>0;return q().set(t,r/1),W=t.length,r}function qe(t,e){const r=e(t.length*8,8)>>>0;return Ne().set(t,r/8),W=t.length,r}function He(t,e,r){if(r===void 0){const a=Z.encode(t),l=e(a.length,1)>>>0;return q().subarray(l,l+a.length).set(a),W=a.length,l}let n=t.length,i=e(n,1)>>>0;const o=q();let _=0;for(;_<n;_++){const a=t.charCodeAt(_);if(a>127)break;o[i+_]=a}if(_!==n){_!==0&&(t=t.slice(_)),i=r(i,n,n=_+t.length*3,1)>>>0;const a=q().subarray(i+_,i+n),l=Z.encodeInto(t,a);_+=l.written,i=r(i,n,_,1)>>>0}return W=_,i}function P(t){const e=s.__wbindgen_externrefs.get(t);return s.__wbindgen_export2(t),e}let _e=new TextDecoder("utf-8",{ignoreBOM:!0});_e.decode();const Xe=2146435072;let de=0;function Ge(t){return de+=t.length,de>=Xe&&(_e=new TextDecoder("utf-8",{ignoreBOM:!0}),_e.decode(),de=t.length),_e.decode(t)}const Z=new TextEncoder;"encodeInto"in Z||(Z.encodeInto=function(t,e){const r=Z.encode(t);return e.set(r),{read:t.length,written:r.length}});let W=0,s;function Je(t,e){return s=t.exports,V=null,G=null,J=null,K=null,Q=null,s.__wbindgen_start(),s}function Ke(t){if(s!==void 0)return s;t!==void 0&&(Object.getPrototypeOf(t)===Object.prototype?{module:t}=t:console.warn("using deprecated parameters for `initSync()`; pass a single object instead"));const e=Ve();t instanceof WebAssembly.Module||(t=new WebAssembly.Module(t));const r=new WebAssembly.Instance(t,e);return Je(r)}class U extends Error{code;hint;constructor(e,r,n){super(r),this.name="StriataError",this.code=e,this.hint=n}}function ve(t){if(t instanceof U)return t;if(t instanceof N){const r=new U(t.code,t.message,t.hint);return t.free(),r}if(t instanceof WebAssembly.RuntimeError||t instanceof RangeError)return new U("too-large","the model took more memory than the page has","close other pages, or load a stream with fewer triangles");if(t instanceof DOMException&&t.name==="AbortError")return Qe();const e=t instanceof Error?t.message:String(t);return new U("network",e)}function Qe(){return new U("aborted","loading was aborted")}function ye(t){return{code:t.code,message:t.message,hint:t.hint}}var Ze=ArrayBuffer,y=Uint8Array,ae=Uint16Array,et=Int16Array,le=Int32Array,be=function(t,e,r){if(y.prototype.slice)return y.prototype.slice.call(t,e,r);(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length);var n=new y(r-e);return n.set(t.subarray(e,r)),n},ce=function(t,e,r,n){if(y.prototype.fill)return y.prototype.fill.call(t,e,r,n);for((r==null||r<0)&&(r=0),(n==null||n>t.length)&&(n=t.length);r<n;++r)t[r]=e;return t},tt=function(t,e,r,n){if(y.prototype.copyWithin)return y.prototype.copyWithin.call(t,e,r,n);for((r==null||r<0)&&(r=0),(n==null||n>t.length)&&(n=t.length);r<n;)t[e++]=t[r++]},rt=["invalid zstd data","window size too large (>2046MB)","invalid block type","FSE accuracy too high","match distance too far back","unexpected EOF"],v=function(t,e,r){var n=new Error(e||rt[t]);if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,v),!r)throw n;return n},Se=function(t,e,r){for(var n=0,i=0;n<r;++n)i|=t[e++]<<(n<<3);return i},nt=function(t,e){return(t[e]|t[e+1]<<8|t[e+2]<<16|t[e+3]<<24)>>>0},it=function(t,e){var r=t[0]|t[1]<<8|t[2]<<16;if(r==3126568&&t[3]==253){var n=t[4],i=n>>5&1,o=n>>2&1,_=n&3,a=n>>6;n&8&&v(0);var l=6-i,p=_==3?4:_,d=Se(t,l,p);l+=p;var h=a?1<<a:i,b=Se(t,l,h)+(a==1&&256),x=b;if(!i){var M=1<<10+(t[5]>>3);x=M+(M>>3)*(t[5]&7)}x>2145386496&&v(1);var g=new y(x+12);return g[0]=1,g[4]=4,g[8]=8,{b:l+h,y:0,l:0,d,w:e&&e!=1?e:g.subarray(12),e:x,o:new le(g.buffer,0,3),u:b,c:o,m:Math.min(131072,x)}}else if((r>>4|t[3]<<20)==25481893)return nt(t,4)+8;v(0)},L=function(t){for(var e=0;1<<e<=t;++e);return e-1},ee=function(t,e,r){var n=(e<<3)+4,i=(t[e]&15)+5;i>r&&v(3);for(var o=1<<i,_=o,a=-1,l=-1,p=-1,d=o,h=new Ze(512+(o<<2)),b=new et(h,0,256),x=new ae(h,0,256),M=new ae(h,512,o),g=512+(o<<1),m=new y(h,g,o),O=new y(h,g+o);a<255&&_>0;){var A=L(_+1),I=n>>3,B=(1<<A+1)-1,k=(t[I]|t[I+1]<<8|t[I+2]<<16)>>(n&7)&B,f=(1<<A)-1,z=B-_-1,S=k&f;if(S<z?(n+=A,k=S):(n+=A+1,k>f&&(k-=z)),b[++a]=--k,k==-1?(_+=k,m[--d]=a):_-=k,!k)do{var R=n>>3;l=(t[R]|t[R+1]<<8)>>(n&7)&3,n+=2,a+=l}while(l==3)}(a>255||_)&&v(0);for(var E=0,C=(o>>1)+(o>>3)+3,D=o-1,T=0;T<=a;++T){var w=b[T];if(w<1){x[T]=-w;continue}for(p=0;p<w;++p){m[E]=T;do E=E+C&D;while(E>=d)}}for(E&&v(0),p=0;p<o;++p){var u=x[m[p]]++,F=O[p]=i-L(u);M[p]=(u<<F)-o}return[n+7>>3,{b:i,s:m,n:O,t:M}]},st=function(t,e){var r=0,n=-1,i=new y(292),o=t[e],_=i.subarray(0,256),a=i.subarray(256,268),l=new ae(i.buffer,268);if(o<128){var p=ee(t,e+1,6),d=p[0],h=p[1];e+=o;var b=d<<3,x=t[e];x||v(0);for(var M=0,g=0,m=h.b,O=m,A=(++e<<3)-8+L(x);A-=m,!(A<b);){var I=A>>3;if(M+=(t[I]|t[I+1]<<8)>>(A&7)&(1<<m)-1,_[++n]=h.s[M],A-=O,A<b)break;I=A>>3,g+=(t[I]|t[I+1]<<8)>>(A&7)&(1<<O)-1,_[++n]=h.s[g],m=h.n[M],M=h.t[M],O=h.n[g],g=h.t[g]}++n>255&&v(0)}else{for(n=o-127;r<n;r+=2){var B=t[++e];_[r]=B>>4,_[r+1]=B&15}++e}var k=0;for(r=0;r<n;++r){var f=_[r];f>11&&v(0),k+=f&&1<<f-1}var z=L(k)+1,S=1<<z,R=S-k;for(R&R-1&&v(0),_[n++]=L(R)+1,r=0;r<n;++r){var f=_[r];++a[_[r]=f&&z+1-f]}var E=new y(S<<1),C=E.subarray(0,S),D=E.subarray(S);for(l[z]=0,r=z;r>0;--r){var T=l[r];ce(D,r,T,l[r-1]=T+a[r]*(1<<z-r))}for(l[0]!=S&&v(0),r=0;r<n;++r){var w=_[r];if(w){var u=l[w];ce(C,r,u,l[w]=u+(1<<z-w))}}return[e,{n:D,b:z,s:C}]},ot=ee(new y([81,16,99,140,49,198,24,99,12,33,196,24,99,102,102,134,70,146,4]),0,6)[1],_t=ee(new y([33,20,196,24,99,140,33,132,16,66,8,33,132,16,66,8,33,68,68,68,68,68,68,68,68,36,9]),0,6)[1],at=ee(new y([32,132,16,66,102,70,68,68,68,68,36,73,2]),0,5)[1],Te=function(t,e){for(var r=t.length,n=new le(r),i=0;i<r;++i)n[i]=e,e+=1<<t[i];return n},me=new y(new le([0,0,0,0,16843009,50528770,134678020,202050057,269422093]).buffer,0,36),lt=Te(me,0),xe=new y(new le([0,0,0,0,0,0,0,0,16843009,50528770,117769220,185207048,252579084,16]).buffer,0,53),ct=Te(xe,3),te=function(t,e,r){var n=t.length,i=e.length,o=t[n-1],_=(1<<r.b)-1,a=-r.b;o||v(0);for(var l=0,p=r.b,d=(n<<3)-8+L(o)-p,h=-1;d>a&&h<i;){var b=d>>3,x=(t[b]|t[b+1]<<8|t[b+2]<<16)>>(d&7);l=(l<<p|x)&_,e[++h]=r.s[l],d-=p=r.n[l]}(d!=a||h+1!=i)&&v(0)},ut=function(t,e,r){var n=6,i=e.length,o=i+3>>2,_=o<<1,a=o+_;te(t.subarray(n,n+=t[0]|t[1]<<8),e.subarray(0,o),r),te(t.subarray(n,n+=t[2]|t[3]<<8),e.subarray(o,_),r),te(t.subarray(n,n+=t[4]|t[5]<<8),e.subarray(_,a),r),te(t.subarray(n),e.subarray(a),r)},ht=function(t,e,r){var n,i=e.b,o=t[i],_=o>>1&3;e.l=o&1;var a=o>>3|t[i+1]<<5|t[i+2]<<13,l=(i+=3)+a;if(_==1)return i>=t.length?void 0:(e.b=i+1,ce(new y(a),t[i]));if(!(l>t.length)){if(_==0)return e.b=l,be(t,i,l);if(_==2){var p=t[i],d=p&3,h=p>>2&3,b=p>>4,x=0,M=0;d<2?h&1?b|=t[++i]<<4|(h&2&&t[++i]<<12):b=p>>3:(M=h,h<2?(b|=(t[++i]&63)<<4,x=t[i]>>6|t[++i]<<2):h==2?(b|=t[++i]<<4|(t[++i]&3)<<12,x=t[i]>>2|t[++i]<<6):(b|=t[++i]<<4|(t[++i]&63)<<12,x=t[i]>>6|t[++i]<<2|t[++i]<<10)),++i;var g=new y(e.m),m=g.length-b;if(d==0)g.set(t.subarray(i,i+=b),m);else if(d==1)ce(g,t[i++],m);else{var O=e.h;if(d==2){var A=st(t,i);x+=i-(i=A[0]),e.h=O=A[1]}else O||v(0);(M?ut:te)(t.subarray(i,i+=x),g.subarray(m),O)}var I=t[i++];if(I){I==255?I=(t[i++]|t[i++]<<8)+32512:I>127&&(I=I-128<<8|t[i++]);var B=t[i++];B&3&&v(0);for(var k=[_t,at,ot],f=2;f>-1;--f){var z=B>>(f<<1)+2&3;if(z==1){var S=new y([0,0,t[i++]]);k[f]={s:S.subarray(2,3),n:S.subarray(0,1),t:new ae(S.buffer,0,1),b:0}}else z==2?(n=ee(t,i,9-(f&1)),i=n[0],k[f]=n[1]):z==3&&(e.t||v(0),k[f]=e.t[f])}var R=e.t=k,E=R[0],C=R[1],D=R[2],T=t[l-1];T||v(0);var w=(l<<3)-8+L(T)-D.b,u=w>>3,F=0,ue=(t[u]|t[u+1]<<8)>>(w&7)&(1<<D.b)-1;u=(w-=C.b)>>3;var he=(t[u]|t[u+1]<<8)>>(w&7)&(1<<C.b)-1;u=(w-=E.b)>>3;var fe=(t[u]|t[u+1]<<8)>>(w&7)&(1<<E.b)-1;for(++I;--I;){var ke=D.s[ue],De=D.n[ue],Ae=E.s[fe],Ue=E.n[fe],We=C.s[he],Be=C.n[he];u=(w-=We)>>3;var je=1<<We,$=je+((t[u]|t[u+1]<<8|t[u+2]<<16|t[u+3]<<24)>>>(w&7)&je-1);u=(w-=xe[Ae])>>3;var re=ct[Ae]+((t[u]|t[u+1]<<8|t[u+2]<<16)>>(w&7)&(1<<xe[Ae])-1);u=(w-=me[ke])>>3;var ge=lt[ke]+((t[u]|t[u+1]<<8|t[u+2]<<16)>>(w&7)&(1<<me[ke])-1);if(u=(w-=De)>>3,ue=D.t[ue]+((t[u]|t[u+1]<<8)>>(w&7)&(1<<De)-1),u=(w-=Ue)>>3,fe=E.t[fe]+((t[u]|t[u+1]<<8)>>(w&7)&(1<<Ue)-1),u=(w-=Be)>>3,he=C.t[he]+((t[u]|t[u+1]<<8)>>(w&7)&(1<<Be)-1),$>3)e.o[2]=e.o[1],e.o[1]=e.o[0],e.o[0]=$-=3;else{var pe=$-(ge!=0);pe?($=pe==3?e.o[0]-1:e.o[pe],pe>1&&(e.o[2]=e.o[1]),e.o[1]=e.o[0],e.o[0]=$):$=e.o[0]}for(var f=0;f<ge;++f)g[F+f]=g[m+f];F+=ge,m+=ge;var ne=F-$;if(ne<0){var ie=-ne,St=e.e+ne;ie>re&&(ie=re);for(var f=0;f<ie;++f)g[F+f]=e.w[St+f];F+=ie,re-=ie,ne=0}for(var f=0;f<re;++f)g[F+f]=g[ne+f];F+=re}if(F!=m)for(;m<g.length;)g[F++]=g[m++];else F=g.length;g=be(g,0,F)}else{var f;m&&(g=be(g,m))}return e.b=l,g}v(2)}},Oe=function(t,e){if(t.length==1)return t[0];for(var r=new y(e),n=0,i=0;n<t.length;++n){var o=t[n];r.set(o,i),i+=o.length}return r},ft=(function(){function t(e){this.ondata=e,this.c=[],this.l=0,this.z=0}return t.prototype.push=function(e,r){if(typeof this.s=="number"){var n=Math.min(e.length,this.s);e=e.subarray(n),this.s-=n}var i=e.length,o=i+this.l;if(!this.s){if(r){if(!o){this.ondata(new y(0),!0);return}o<5&&v(5)}else if(o<18){this.c.push(e),this.l=o;return}if(this.l&&(this.c.push(e),e=Oe(this.c,o),this.c=[],this.l=0),typeof(this.s=it(e))=="number")return this.push(e,r)}if(typeof this.s!="number"){if(o<(this.z||3)){r&&v(5),this.c.push(e),this.l=o;return}if(this.l&&(this.c.push(e),e=Oe(this.c,o),this.c=[],this.l=0),!this.z&&o<(this.z=e[this.s.b]&2?4:3+(e[this.s.b]>>3|e[this.s.b+1]<<5|e[this.s.b+2]<<13))){r&&v(5),this.c.push(e),this.l=o;return}else this.z=0;for(;;){var _=ht(e,this.s);if(_)this.ondata(_,!1),tt(this.s.w,0,_.length),this.s.w.set(_,this.s.w.length-_.length);else{r&&v(5);var a=e.subarray(this.s.b);this.s.b=0,this.c.push(a),this.l+=a.length;return}if(this.s.l){var l=e.subarray(this.s.b);this.s=this.s.c*4,this.push(l,r);return}}}else r&&v(5)},t})();function gt(t){if(t.length===1)return t[0];const e=new Uint8Array(t.reduce((n,i)=>n+i.length,0));let r=0;for(const n of t)e.set(n,r),r+=n.length;return e}const pt=3,wt=1<<30,dt=64<<20,vt=2e3;async function yt(t,e){for(let r=0;r<pt;r++){const n=bt(t);if(!n)break;const i=new It(Math.min(wt,Math.max(dt,t.length*vt)),e);try{await(n==="gzip"?mt(t,i):xt(t,i))}catch(o){throw o instanceof U?o:new U("corrupt",`${e}: the ${n} data are damaged or cut off: ${o instanceof Error?o.message:String(o)}`)}t=gt(i.all),e=e.replace(/\\.(gz|zst)$/i,"")}return{bytes:t,name:e}}function bt(t){const e=(...r)=>r.every((n,i)=>t[i]===n);return e(31,139,8)?"gzip":e(40,181,47,253)?"zstd":void 0}async function mt(t,e){const n=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip")).getReader();for(;;){const{done:i,value:o}=await n.read();if(i)return;e.push(o)}}function xt(t,e){let r=!1;const n=new ft((o,_)=>{e.push(o),r||=_===!0}),i=1<<20;for(let o=0;o<t.length;o+=i)n.push(t.subarray(o,o+i),o+i>=t.length);if(!r)throw new Error("they end too early")}class It{constructor(e,r){this.most=e,this.name=r}all=[];#t=0;push(e){if(this.#t+=e.length,this.#t>this.most)throw new U("too-large",`${this.name}: grows past ${this.most} bytes, more than a mesh can`);this.all.push(e.slice())}}const Ie=8192,kt=60,At=4;function Mt(){return new Promise(t=>{const{port1:e,port2:r}=new MessageChannel;e.onmessage=()=>{e.close(),t()},r.postMessage(null)})}class zt{#t;#g;#e=new j;#r=[];#s;#l=!1;#n=!1;#p={by:"detail",value:1,limit:0};#a="surface";#i="download";#w=0;#d=!1;#v=-1;#c=0;#u=0;#h=0;#y=0;#o={vertices:0,triangles:0,steps:0,bytes:0};constructor(e,r){this.#t=e,this.#g=r}take(e){if(!this.#n)switch(e.type){case"bytes":this.#r.push(e.bytes),this.#b();break;case"end":this.#s=e.error?{error:e.error}:{},this.#b();break;case"file":this.#k(e.bytes,e.name);break;case"show":this.#p=e.wish,this.#a=e.colouring,this.#e.is_ready&&this.#f(()=>this.#_(e.ticket));break}}dispose(){this.#n=!0,this.#r=[],this.#e.free()}async#b(){if(!this.#l){for(this.#l=!0;this.#r.length>0&&!this.#n;){this.#i="decode";const e=this.#m();if(e){this.#r=[],this.#s={error:ye(e)};break}this.#e.is_ready&&performance.now()>=this.#y&&this.#f(()=>this.#_(0)),await Mt()}this.#l=!1,this.#s&&!this.#n&&this.#x(this.#s.error)}}#m(){const e=performance.now();try{for(;performance.now()-e<this.#g;){const r=this.#r.shift();if(!r)break;this.#e.push(r.subarray(0,Ie)),r.length>Ie&&this.#r.unshift(r.subarray(Ie))}return}catch(r){return ve(r)}finally{this.#c+=performance.now()-e}}#x(e){let r=e;try{if(!r&&!this.#e.is_complete&&(r={code:"corrupt",message:"the stream ends before the mesh does",hint:"was the file copied whole?"}),(r?.code!=="corrupt"||!e)&&this.#I(),!this.#e.is_ready)throw new U("corrupt","the stream ends before there is anything to draw");this.#A(),this.#i="build",this.#_(0),this.#t({type:"building",share:0});const n=performance.now();this.#e.build(),this.#u=performance.now()-n,this.#i="done",this.#_(0)}catch(n){r??=ye(ve(n))}this.#s=void 0,this.#t(r?{type:"failed",error:r}:{type:"finished"})}#I(){const e=performance.now();try{this.#e.finish()}finally{this.#c+=performance.now()-e}}async#k(e,r){this.#i="build";const n=performance.now(),i={report:(a,l)=>this.#t({type:"building",share:l})};let o,_;try{o=await yt(e,r)}catch(a){_=a}this.#n||this.#f(()=>{if(!o)throw _;const a=j.from_file(o.bytes,o.name,i);this.#e.free(),this.#e=a,this.#u=performance.now()-n,this.#i="done",this.#_(0),this.#t({type:"finished"})})}#f(e){try{e()}catch(r){this.#n=!0,this.#t({type:"failed",error:ye(ve(r))})}}#A(){const e=this.#e;this.#o={vertices:e.full_vertex_count,triangles:e.full_triangle_count,steps:e.step_count,bytes:e.stream_bytes}}#_(e){const r=performance.now(),n=this.#M(),i=this.#z(),o=this.#E(),_=this.#F(),a=this.#e,[l,p]=[a.indices(),a.group_counts()];this.#h=performance.now()-r,this.#y=performance.now()+Math.max(kt,At*this.#h);const h={type:"update",state:this.#S(),vertices:o,smoothNormals:_,indices:l,groupCounts:p,numbers:i,settled:n,ticket:e};this.#t(h)}#M(){const{by:e,value:r,limit:n,camera:i}=this.#p,o=this.#e;if(e==="view"&&o.is_built&&i){const a=new se(Float64Array.from(i),r,n);try{return o.show_view(a)}finally{a.free()}}e==="triangles"?o.show_triangles(r):e==="error"?o.show_error(r):o.show_detail(e==="detail"?r:1);const _=o.group_counts().reduce((a,l)=>a+l,0);return n>0&&_>n&&o.show_triangles(n),!0}#z(){if(this.#a==="strips")return this.#e.color_strips();if(this.#a==="fans")return this.#e.color_fans();if(this.#a==="surface")return;const e=this.#e.group_counts().reduce((r,n)=>r+n,0);return Uint32Array.from({length:e},(r,n)=>n)}#E(){const e=this.#w;if(this.#e.vertex_count===e)return;const r=this.#e.vertices(e);try{const n=r.take_normals();return this.#d=n!==void 0,this.#w=this.#e.vertex_count,{first:e,positions:r.take_positions(),normals:n,colors:r.take_colors(),uvs:r.take_uvs()}}finally{r.free()}}#F(){if(!(this.#d||this.#v===this.#e.vertex_count))return this.#v=this.#e.vertex_count,this.#e.smooth_normals()}#S(){const e=this.#e;return{kind:e.kind,phase:this.#i,complete:e.is_complete,built:e.is_built,vertexCount:e.vertex_count,triangleCount:e.triangle_count,fullVertexCount:this.#o.vertices||e.full_vertex_count,fullTriangleCount:this.#o.triangles||e.full_triangle_count,stepCount:this.#o.steps||e.step_count,streamBytes:this.#o.bytes||e.stream_bytes,bounds:e.bounds(),diagonal:e.diagonal,shownSplitCount:e.shown_split_count,shownError:e.shown_error,decodeMs:this.#c,buildMs:this.#u,updateMs:this.#h}}}function Et(t){if(t.type!=="update")return[];const{vertices:e,indices:r,groupCounts:n,numbers:i,smoothNormals:o}=t,_=[r,n,i,o];return e&&_.push(e.positions,e.normals,e.colors,e.uvs),_.flatMap(a=>a?[a.buffer]:[])}const Ft=30,Re=self;let Ce;Re.onmessage=({data:t})=>{t instanceof WebAssembly.Module?(Ke({module:t}),Ce=new zt(e=>Re.postMessage(e,Et(e)),Ft)):Ce?.take(t)}})();\n', k = typeof self < "u" && self.Blob && new Blob([F], { type: "text/javascript;charset=utf-8" });
function ot(n) {
  let t;
  try {
    if (t = k && (self.URL || self.webkitURL).createObjectURL(k), !t) throw "";
    const e = new Worker(t, {
      name: n?.name
    });
    return e.addEventListener("error", () => {
      (self.URL || self.webkitURL).revokeObjectURL(t);
    }), e;
  } catch {
    return new Worker(
      "data:text/javascript;charset=utf-8," + encodeURIComponent(F),
      {
        name: n?.name
      }
    );
  } finally {
    t && (self.URL || self.webkitURL).revokeObjectURL(t);
  }
}
const at = 6;
function _t(n, t, e) {
  return t && ht(n, e) || lt(n, e);
}
function ht(n, t) {
  let e;
  try {
    e = new ot(), e.postMessage(n);
  } catch {
    return;
  }
  return e.onmessage = ({ data: r }) => t(r), e.onerror = (r) => {
    r.preventDefault();
    const i = r.message || "the worker could not start", s = new E("unsupported", `the worker failed: ${i}`, "try the option worker: false");
    t({ type: "failed", error: C(s) });
  }, {
    // Bytes are copied: a piece may be a part of a buffer that others still read.
    order: (r) => e.postMessage(r),
    dispose: () => e.terminate()
  };
}
function lt(n, t) {
  R(n);
  let e = !1;
  const r = (s) => queueMicrotask(() => void (e || s())), i = new D((s) => r(() => t(s)), at);
  return {
    order: (s) => r(() => i.take(s)),
    dispose: () => {
      e = !0, i.dispose();
    }
  };
}
const ut = 1024;
class ct extends z {
  /** Smallest and largest coordinates. */
  bounds = [];
  #t = 0;
  #e = !1;
  computeBoundingBox() {
    const [t, e] = [0, 3].map((r) => new u().fromArray(this.bounds.length === 6 ? Array.from(this.bounds) : new Array(6).fill(0), r));
    this.boundingBox = new q(t, e);
  }
  computeBoundingSphere() {
    this.computeBoundingBox(), this.boundingSphere = this.boundingBox.getBoundingSphere(new Q());
  }
  /** Takes what an update brings. */
  take({ state: t, vertices: e, smoothNormals: r, indices: i, groupCounts: s }, o) {
    if (this.bounds = t.bounds, this.#i(t.vertexCount, t.fullVertexCount), e) {
      const { first: a, positions: _, normals: h, colors: l, uvs: c } = e;
      this.#r("position", _, 3, a), h && this.#r("normal", h, 3, a), l && this.#r("color", l, 4, a), c && this.#r("uv", c, 2, a);
    }
    if (r && this.#r("normal", r, 3, 0), this.#n(i, 3 * t.fullTriangleCount), this.clearGroups(), o) {
      let a = 0;
      s.forEach((_, h) => {
        this.addGroup(a, 3 * _, h), a += 3 * _;
      });
    }
    this.computeBoundingSphere(), this.#e = !1;
  }
  #i(t, e) {
    t <= this.#t || (this.#t = x(this.#t, t, e), this.#e = !0, this.dispose());
  }
  /** Writes numbers of vertices from one on. */
  #r(t, e, r, i) {
    let s = this.getAttribute(t);
    if (!s || this.#e && s.count !== this.#t) {
      const o = e instanceof Uint8Array ? new Uint8Array(this.#t * r) : new Float32Array(this.#t * r);
      s && o.set(s.array.subarray(0, i * r)), s = new p(o, r, e instanceof Uint8Array), this.setAttribute(t, s);
    } else
      s.addUpdateRange(i * r, e.length);
    s.array.set(e, i * r), s.needsUpdate = !0;
  }
  #n(t, e) {
    let r = this.index;
    if (!r || r.count < t.length) {
      r && this.dispose();
      const i = new Uint32Array(x(r?.count ?? 0, t.length, e));
      r = new p(i, 1), this.setIndex(r);
    } else
      r.addUpdateRange(0, t.length);
    r.array.set(t), r.needsUpdate = !0, this.setDrawRange(0, t.length);
  }
}
function x(n, t, e) {
  const r = Math.max(ut, 2 * n, t);
  return e >= t ? Math.min(r, e) : r;
}
const b = 1024, dt = 2654435761, gt = pt();
function ft(n, t, e) {
  const r = { positions: new Float32Array(3 * t.length), colors: new Uint8Array(4 * t.length) };
  for (let s = 0; s < t.length; s++) {
    const o = 3 * t[s], a = 3 * (Math.imul(e[s / 3 | 0], dt) >>> 22);
    for (let _ = 0; _ < 3; _++)
      r.positions[3 * s + _] = n[o + _], r.colors[4 * s + _] = gt[a + _];
    r.colors[4 * s + 3] = 255;
  }
  const i = new z();
  return i.setAttribute("position", new p(r.positions, 3)), i.setAttribute("color", new p(r.colors, 4, !0)), i;
}
function pt() {
  const n = new Uint8Array(3 * b), t = new Y();
  for (let e = 0; e < b; e++)
    t.setHSL(e / b, 0.62, 0.5 + 0.1 * (e % 3), J), [t.r, t.g, t.b].forEach((r, i) => n[3 * e + i] = Math.round(255 * r));
  return n;
}
const d = new K(), [M, I, S, y] = [new u(), new u(), new u(), new u()];
function wt(n, t, e, r) {
  if (!(e >= 1 && r >= 1)) return;
  y.setFromMatrixScale(n.matrixWorld);
  const [i, s] = [Math.min(...y.toArray()), Math.max(...y.toArray())];
  if (!(i > 0)) return;
  if (t.isOrthographicCamera) {
    const { top: c, bottom: T, zoom: L } = t;
    return { kind: "orthographic", unitsPerPixel: Math.abs(c - T) / (L * r * s) };
  }
  if (!t.isPerspectiveCamera) return;
  d.copy(n.matrixWorld).invert(), M.setFromMatrixPosition(t.matrixWorld).applyMatrix4(d), I.set(0, 0, -1).applyMatrix4(t.matrixWorld).applyMatrix4(d), S.setFromMatrixColumn(t.matrixWorld, 1).transformDirection(d);
  const o = t.projectionMatrix.elements, a = [(1 + Math.abs(o[8])) / o[0], (1 + Math.abs(o[9])) / o[5]], _ = r * o[5] * a[1], h = [Math.max(1, Math.round(_ * a[0] / a[1])), Math.max(1, Math.round(_))], l = [...M.toArray(), ...I.toArray(), ...S.toArray(), a[1], ...h];
  if (l.every(Number.isFinite))
    return { kind: "perspective", numbers: l, stretch: s / i };
}
const g = new Z();
class bt extends X {
  isStriataMesh = !0;
  finished;
  state;
  #t;
  #e;
  /** Made here, and freed here. */
  #i;
  #r;
  #n;
  #l;
  #a = 1;
  #s = null;
  #_ = null;
  #o = null;
  #f = !1;
  #h = "surface";
  #g = !1;
  /** The request that has not been answered yet, and whether another has to follow it. */
  #u = 0;
  #c = !1;
  #d = !1;
  #p = { by: "detail", value: 1, limit: 0 };
  /** The last camera, as a wish; for views a wish is made when the mesh is drawn. */
  #w;
  #x = !0;
  #b = !1;
  #M;
  #v;
  constructor(t, e, r) {
    const i = new ct(), s = e ? void 0 : mt(t);
    super(i, e ?? s), this.#e = i, this.#r = this.material, this.#i = s, this.#t = r, this.state = t.state, this.#l = t, this.finished = new Promise((o, a) => {
      this.#M = o, this.#v = a;
    }), this.finished.catch(() => {
    }), this.onBeforeRender = (o, a, _) => this.#A(o, a, _), this.update(t);
  }
  get detail() {
    return this.#a ?? (this.stepCount > 0 ? this.splitCount / this.stepCount : 1);
  }
  set detail(t) {
    this.#a = Math.min(1, Math.max(0, f(t, "detail"))), [this.#s, this.#_, this.#o] = [null, null, null], this.#y();
  }
  get triangleBudget() {
    return this.#s;
  }
  set triangleBudget(t) {
    this.#s = t === null ? null : Math.max(1, Math.floor(f(t, "triangleBudget"))), this.#k(), this.#y();
  }
  get error() {
    return this.state.shownError;
  }
  get maxError() {
    return this.#_;
  }
  set maxError(t) {
    this.#_ = t === null ? null : Math.max(0, f(t, "maxError")), t !== null && (this.#o = null), this.#k(), this.#y();
  }
  get pixelError() {
    return this.#o;
  }
  set pixelError(t) {
    this.#o = t === null ? null : Math.max(0, f(t, "pixelError")), t !== null && (this.#_ = null), this.#k(), this.#y(), this.dispatchStriata({ type: "change" });
  }
  get frozen() {
    return this.#f;
  }
  set frozen(t) {
    this.#f = t, this.dispatchStriata({ type: "change" });
  }
  get colouring() {
    return this.#h;
  }
  set colouring(t) {
    t !== this.#h && (this.#h === "surface" && (this.#r = this.material), this.#h = t, this.#d = !0, this.#m());
  }
  get wireframe() {
    return this.#g;
  }
  set wireframe(t) {
    this.#g = t;
    for (const e of [this.material].flat()) m(e, t);
    this.dispatchStriata({ type: "change" });
  }
  get triangleCount() {
    return this.#l.indices.length / 3;
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
    this.#b || (this.#b = !0, this.#t.dispose(), this.#e.dispose(), this.geometry !== this.#e && this.geometry.dispose(), this.#i?.dispose(), this.#n?.dispose(), this.#v(new E("aborted", "the mesh was disposed of")));
  }
  /** Takes another level; called by the loader. */
  update(t) {
    this.#b || (this.state = t.state, this.#l = t, this.#e.take(t, Array.isArray(this.#r)), this.#I(t), t.ticket === this.#u && (this.#c = !1, this.#x = t.settled), this.#d && this.#m(), this.dispatchStriata({ type: "change" }));
  }
  /** Nothing more comes; called by the loader. */
  end(t) {
    if (!t) {
      this.#M();
      return;
    }
    this.#v(t), this.dispatchStriata({ type: "error", error: t });
  }
  /** Shows the surface, or triangles in the colours of what draws them. */
  #I({ numbers: t, indices: e }) {
    const r = this.geometry;
    if (t && this.#h !== "surface")
      this.#n ??= new U({ vertexColors: !0, flatShading: !0, side: B, roughness: 0.9 }), m(this.#n, this.#g), this.geometry = ft(this.#e.getAttribute("position").array, e, t), this.geometry.boundingSphere = this.#e.boundingSphere, this.geometry.boundingBox = this.#e.boundingBox, this.material = this.#n;
    else if (this.geometry !== this.#e && this.#h === "surface") {
      this.geometry = this.#e, this.material = this.#r;
      for (const i of [this.material].flat()) m(i, this.#g);
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
    this.#c || this.#b || (this.#d = !1, this.#c = !0, this.#p = this.#S(), this.#t.order({ type: "show", wish: this.#p, colouring: this.#h, ticket: ++this.#u }));
  }
  #S() {
    const t = this.#s ?? 0;
    return this.#o !== null ? this.#w ?? { by: "detail", value: t > 0 ? 1 : 0, limit: t } : this.#_ !== null ? { by: "error", value: this.#_, limit: t } : this.#s !== null ? { by: "triangles", value: this.#s, limit: t } : { by: "detail", value: this.#a ?? 1, limit: 0 };
  }
  /** Follows the camera that the mesh is about to be drawn for. */
  #A(t, e, r) {
    if (this.#o === null || this.#f) return;
    const i = t.getRenderTarget();
    i ? g.set(i.width, i.height) : t.getDrawingBufferSize(g);
    const s = wt(this, r, g.x, g.y);
    if (!s) return;
    const o = this.#s ?? 0;
    this.#w = s.kind === "perspective" ? { by: "view", value: this.#o / s.stretch, limit: o, camera: s.numbers } : { by: "error", value: this.#o * s.unitsPerPixel, limit: o }, !(!this.state.built && this.#p.by === this.#w.by) && (this.#x && yt(this.#w, this.#p) || this.#m());
  }
  /** three's types know no events but their own. */
  dispatchStriata(t) {
    this.dispatchEvent(t);
  }
}
function f(n, t) {
  if (Number.isNaN(Number(n))) throw new TypeError(`${t} has to be a number, not ${String(n)}`);
  return Number(n);
}
function yt(n, t) {
  const e = n.camera?.length === t.camera?.length && (n.camera ?? []).every((r, i) => r === t.camera?.[i]);
  return n.by === t.by && n.value === t.value && n.limit === t.limit && e;
}
function m(n, t) {
  "wireframe" in n && (n.wireframe = t);
}
function mt({ vertices: n }) {
  return new U({ vertexColors: n?.colors !== void 0, side: B, roughness: 0.8, metalness: 0 });
}
function vt(n = {}) {
  return {
    load: (t, e = {}) => new kt(n, e).run(t)
  };
}
const It = function(n) {
  return vt(n);
};
class kt {
  #t;
  #e;
  #i = new AbortController();
  #r;
  #n;
  #l = 0;
  #a = null;
  #s;
  #_;
  constructor(t, e) {
    this.#t = t, this.#e = e;
  }
  run(t) {
    const { signal: e } = this.#e;
    if (e?.aborted) return Promise.reject(w());
    const r = new Promise((s, o) => {
      this.#s = s, this.#_ = o;
    }), i = () => this.#c(w());
    return e?.addEventListener("abort", i, { once: !0 }), this.#i.signal.addEventListener("abort", () => e?.removeEventListener("abort", i)), this.#o(t).catch((s) => this.#f($(s))), r;
  }
  async #o(t) {
    const [e, r] = await Promise.all([
      N(this.#t.wasm),
      G(t, this.#e.name, this.#i.signal)
    ]);
    if (this.#i.signal.aborted) return;
    R(e), this.#a = r.length;
    const i = await rt(r);
    if (this.#i.signal.aborted) return;
    this.#a = i.byteCount, this.#r = _t(e, this.#t.worker ?? !0, (o) => this.#h(o));
    const s = [];
    for await (const o of V(i.pieces)) {
      if (this.#i.signal.aborted) return;
      this.#l += o.length, i.isStream ? this.#r.order({ type: "bytes", bytes: o }) : s.push(o), this.#u();
    }
    this.#i.signal.aborted || (this.#a = this.#l, i.isStream ? this.#r.order({ type: "end" }) : this.#r.order({ type: "file", bytes: A(s), name: r.name }), this.#u());
  }
  /** The source failed: what has come of it may be something nevertheless. */
  #f(t) {
    this.#r && t.code !== "aborted" ? this.#r.order({ type: "end", error: C(t) }) : this.#c(t);
  }
  #h(t) {
    if (!this.#i.signal.aborted)
      switch (t.type) {
        case "update":
          this.#n ? this.#n.update(t) : (t.indices.length > 0 || t.state.complete) && (this.#n = new bt(t, this.#e.material, this.#g()), this.#n.name = this.#e.name ?? "", this.#s(this.#n)), this.#u();
          break;
        case "building":
          this.#u("build");
          break;
        case "failed":
          this.#c(H(t.error));
          break;
        case "finished":
          this.#n?.end(), this.#u();
          break;
      }
  }
  /** What the mesh needs of us. */
  #g() {
    return {
      order: (t) => this.#r?.order(t),
      bytes: () => ({ received: this.#l, total: this.#a }),
      dispose: () => this.#d()
    };
  }
  #u(t) {
    const e = this.#n?.state, r = {
      bytesReceived: this.#l,
      bytesTotal: this.#a ?? (e?.streamBytes || null),
      triangleCount: e?.triangleCount ?? 0,
      vertexCount: e?.vertexCount ?? 0,
      complete: e?.complete ?? !1,
      phase: t ?? e?.phase ?? "download"
    };
    this.#e.onProgress?.(r), this.#n?.dispatchStriata({ type: "progress", progress: r });
  }
  /** Ends loading; a mesh that is there stays, with what it has. */
  #c(t) {
    if (!this.#i.signal.aborted) {
      if (this.#n && t.code !== "aborted") {
        this.#n.end(t);
        return;
      }
      this.#n?.end(t), this.#d(), this.#_(t);
    }
  }
  #d() {
    this.#i.abort(w()), this.#r?.dispose();
  }
}
export {
  E as StriataError,
  It as StriataLoader,
  bt as StriataMesh
};
