import { d as R, p as j, S as D, l as N, e as $, a as z, f as T, s as U, E as G, g as u, c as H, w as V, o as q, i as Q, h as J } from "./wasm.js";
import { BufferGeometry as B, Vector3 as _, Box3 as K, Sphere as X, BufferAttribute as b, Color as Z, SRGBColorSpace as Y, Matrix4 as ee, Mesh as k, MeshStandardMaterial as F, DoubleSide as O, Vector2 as te } from "three";
const re = [137, 83, 84, 82], A = [..."STRIATA\0"].map((s) => s.charCodeAt(0)), se = 65536;
async function ie(s) {
  const e = new ae(s.pieces);
  if (await e.grow(A.length), e.startsWith(re))
    return { isStream: !0, isInContainer: !1, pieces: e.all(), byteCount: s.length };
  if (e.startsWith(A)) {
    const t = await oe(e);
    if (t) return ne(s, e, t);
  }
  return { isStream: !1, isInContainer: !1, pieces: e.all(), byteCount: s.length };
}
async function ne(s, e, { offset: t, length: r }) {
  const i = e.bytes.length;
  return i < t && s.range && t - i > se ? (await e.drop(), { isStream: !0, isInContainer: !0, pieces: await s.range(t, t + r), byteCount: r }) : { isStream: !0, isInContainer: !0, pieces: N($(e.all(), t), r), byteCount: r };
}
async function oe(s) {
  for (; ; ) {
    const e = D.find(s.bytes), { needed: t, offset: r, length: i } = e;
    if (e.free(), t > s.bytes.length) {
      if (!await s.grow(t)) return;
      continue;
    }
    return i > 0 ? { offset: r, length: i } : void 0;
  }
}
class ae {
  bytes = new Uint8Array();
  #e;
  constructor(e) {
    this.#e = e;
  }
  /** Reads until so many bytes are there; false if there are no more. */
  async grow(e) {
    for (; this.bytes.length < e; ) {
      const t = await this.#e.next();
      if (t.done) return !1;
      this.bytes = R([this.bytes, t.value]);
    }
    return !0;
  }
  startsWith(e) {
    return e.every((t, r) => this.bytes[r] === t);
  }
  all() {
    return j(this.bytes, this.#e);
  }
  async drop() {
    await this.#e.return?.();
  }
}
const L = '(function(){"use strict";class I{static __wrap(e){const t=Object.create(I.prototype);return t.__wbg_ptr=e,Ee.register(t,t.__wbg_ptr,t),t}__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,Ee.unregister(this),e}free(){const e=this.__destroy_into_raw();o.__wbg_failure_free(e,0)}get code(){let e,t;try{const n=o.failure_code(this.__wbg_ptr);return e=n[0],t=n[1],V(n[0],n[1])}finally{o.__wbindgen_free(e,t,1)}}get hint(){const e=o.failure_hint(this.__wbg_ptr);let t;return e[0]!==0&&(t=V(e[0],e[1]),o.__wbindgen_free(e[0],e[1]*1,1)),t}get message(){let e,t;try{const n=o.failure_message(this.__wbg_ptr);return e=n[0],t=n[1],V(n[0],n[1])}finally{o.__wbindgen_free(e,t,1)}}}Symbol.dispose&&(I.prototype[Symbol.dispose]=I.prototype.free);class j{static __wrap(e){const t=Object.create(j.prototype);return t.__wbg_ptr=e,ge.register(t,t.__wbg_ptr,t),t}__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,ge.unregister(this),e}free(){const e=this.__destroy_into_raw();o.__wbg_model_free(e,0)}bounds(){const e=o.model_bounds(this.__wbg_ptr);var t=q(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}color_fans(){const e=o.model_color_fans(this.__wbg_ptr);var t=ie(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}color_strips(){const e=o.model_color_strips(this.__wbg_ptr);if(e[3])throw N(e[2]);var t=ie(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}get diagonal(){return o.model_diagonal(this.__wbg_ptr)}finish(){const e=o.model_finish(this.__wbg_ptr);if(e[1])throw N(e[0])}static from_file(e,t,n){let i,s,a,_;try{i=Se(e,o.__wbindgen_malloc),s=D,a=Ye(t,o.__wbindgen_malloc,o.__wbindgen_realloc),_=D}catch(f){throw a&&o.__wbindgen_free(a,_*1,1),i&&o.__wbindgen_free(i,s*1,1),f}const h=o.model_from_file(i,s,a,_,n);if(h[2])throw N(h[1]);return j.__wrap(h[0])}get full_triangle_count(){return o.model_full_triangle_count(this.__wbg_ptr)>>>0}get full_vertex_count(){return o.model_full_vertex_count(this.__wbg_ptr)>>>0}get group_count(){return o.model_group_count(this.__wbg_ptr)>>>0}group_counts(){const e=o.model_group_counts(this.__wbg_ptr);var t=ie(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}grow(){o.model_grow(this.__wbg_ptr)}indices(){const e=o.model_indices(this.__wbg_ptr);var t=ie(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}get is_complete(){return o.model_is_complete(this.__wbg_ptr)!==0}get is_ready(){return o.model_is_ready(this.__wbg_ptr)!==0}get kind(){let e,t;try{const n=o.model_kind(this.__wbg_ptr);return e=n[0],t=n[1],V(n[0],n[1])}finally{o.__wbindgen_free(e,t,1)}}constructor(){const e=o.model_new();return this.__wbg_ptr=e,ge.register(this,this.__wbg_ptr,this),this}push(e){const t=Se(e,o.__wbindgen_malloc),n=D,i=o.model_push(this.__wbg_ptr,t,n);if(i[1])throw N(i[0])}reveal(){o.model_reveal(this.__wbg_ptr)}show_detail(e){o.model_show_detail(this.__wbg_ptr,e)}show_error(e){o.model_show_error(this.__wbg_ptr,e)}show_triangles(e){o.model_show_triangles(this.__wbg_ptr,e)}show_view(e){je(e,ne);const t=o.model_show_view(this.__wbg_ptr,e.__wbg_ptr);if(t[2])throw N(t[1]);return t[0]!==0}get shown_error(){return o.model_shown_error(this.__wbg_ptr)}get shown_split_count(){return o.model_shown_split_count(this.__wbg_ptr)>>>0}smooth_normals(){const e=o.model_smooth_normals(this.__wbg_ptr);var t=q(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}get step_count(){return o.model_step_count(this.__wbg_ptr)>>>0}get stream_bytes(){return o.model_stream_bytes(this.__wbg_ptr)}get triangle_count(){return o.model_triangle_count(this.__wbg_ptr)>>>0}get vertex_count(){return o.model_vertex_count(this.__wbg_ptr)>>>0}vertices(e){const t=o.model_vertices(this.__wbg_ptr,e);return Y.__wrap(t)}}Symbol.dispose&&(j.prototype[Symbol.dispose]=j.prototype.free);class Y{static __wrap(e){const t=Object.create(Y.prototype);return t.__wbg_ptr=e,ze.register(t,t.__wbg_ptr,t),t}__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,ze.unregister(this),e}free(){const e=this.__destroy_into_raw();o.__wbg_vertices_free(e,0)}take_colors(){const e=o.vertices_take_colors(this.__wbg_ptr);let t;return e[0]!==0&&(t=Le(e[0],e[1]).slice(),o.__wbindgen_free(e[0],e[1]*1,1)),t}take_normals(){const e=o.vertices_take_normals(this.__wbg_ptr);let t;return e[0]!==0&&(t=q(e[0],e[1]).slice(),o.__wbindgen_free(e[0],e[1]*4,4)),t}take_positions(){const e=o.vertices_take_positions(this.__wbg_ptr);var t=q(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}take_uvs(){const e=o.vertices_take_uvs(this.__wbg_ptr);let t;return e[0]!==0&&(t=q(e[0],e[1]).slice(),o.__wbindgen_free(e[0],e[1]*4,4)),t}}Symbol.dispose&&(Y.prototype[Symbol.dispose]=Y.prototype.free);class ne{__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,Fe.unregister(this),e}free(){const e=this.__destroy_into_raw();o.__wbg_view_free(e,0)}get pixels(){return o.__wbg_get_view_pixels(this.__wbg_ptr)}get triangle_limit(){return o.__wbg_get_view_triangle_limit(this.__wbg_ptr)>>>0}set pixels(e){o.__wbg_set_view_pixels(this.__wbg_ptr,e)}set triangle_limit(e){o.__wbg_set_view_triangle_limit(this.__wbg_ptr,e)}constructor(e,t,n){const i=+t,s=+n,a=Ne(e,o.__wbindgen_malloc),_=D,h=o.view_new(a,_,i,s);if(h[2])throw N(h[1]);return this.__wbg_ptr=h[0],Fe.register(this,this.__wbg_ptr,this),this}}Symbol.dispose&&(ne.prototype[Symbol.dispose]=ne.prototype.free);function Ie(){return{__proto__:null,"./striata_web_bg.js":{__proto__:null,__wbg___wbindgen_throw_4c88d8bf264fd984:function(e,t){throw new Error(V(e,t))},__wbg_failure_new:function(e){return I.__wrap(e)},__wbg_report_581358a93077c908:function(e,t,n,i){e.report(V(t,n),i)},__wbindgen_init_externref_table:function(){const e=o.__wbindgen_externrefs;e.set(0,void 0),e.set(1024,void 0),e.set(1025,null),e.set(1026,!0),e.set(1027,!1)}}}}const Ee=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(r=>o.__wbg_failure_free(r,1)),ge=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(r=>o.__wbg_model_free(r,1));typeof FinalizationRegistry>"u"||new FinalizationRegistry(r=>o.__wbg_streamplace_free(r,1));const ze=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(r=>o.__wbg_vertices_free(r,1)),Fe=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(r=>o.__wbg_view_free(r,1));function je(r,e){if(!(r instanceof e))throw new Error(`expected instance of ${e.name}`)}function q(r,e){return r=r>>>0,Pe().subarray(r/4,r/4+e)}function ie(r,e){return r=r>>>0,$e().subarray(r/4,r/4+e)}function Le(r,e){return r=r>>>0,$().subarray(r/1,r/1+e)}let H=null;function Pe(){return(H===null||H.byteLength===0)&&(H=new Float32Array(o.memory.buffer)),H}let X=null;function Ve(){return(X===null||X.byteLength===0)&&(X=new Float64Array(o.memory.buffer)),X}function V(r,e){return r=r>>>0,He($().subarray(r,r+e))}let G=null;function $e(){return(G===null||G.byteLength===0)&&(G=new Uint32Array(o.memory.buffer)),G}let J=null;function $(){return(J===null||J.byteLength===0)&&(J=new Uint8Array(o.memory.buffer)),J}function Se(r,e){const t=e(r.length*1,1)>>>0;return $().set(r,t/1),D=r.length,t}function Ne(r,e){const t=e(r.length*8,8)>>>0;return Ve().set(r,t/8),D=r.length,t}function Ye(r,e,t){if(t===void 0){const _=K.encode(r),h=e(_.length,1)>>>0;return $().subarray(h,h+_.length).set(_),D=_.length,h}let n=r.length,i=e(n,1)>>>0;const s=$();let a=0;for(;a<n;a++){const _=r.charCodeAt(a);if(_>127)break;s[i+a]=_}if(a!==n){a!==0&&(r=r.slice(a)),i=t(i,n,n=a+r.length*3,1)>>>0;const _=$().subarray(i+a,i+n),h=K.encodeInto(r,_);a+=h.written,i=t(i,n,a,1)>>>0}return D=a,i}function N(r){const e=o.__wbindgen_externrefs.get(r);return o.__externref_table_dealloc(r),e}let se=new TextDecoder("utf-8",{ignoreBOM:!0});se.decode();const qe=2146435072;let we=0;function He(r){return we+=r.length,we>=qe&&(se=new TextDecoder("utf-8",{ignoreBOM:!0}),se.decode(),we=r.length),se.decode(r)}const K=new TextEncoder;"encodeInto"in K||(K.encodeInto=function(r,e){const t=K.encode(r);return e.set(t),{read:r.length,written:t.length}});let D=0,o;function Xe(r,e){return o=r.exports,H=null,X=null,G=null,J=null,o.__wbindgen_start(),o}function Ge(r){if(o!==void 0)return o;r!==void 0&&(Object.getPrototypeOf(r)===Object.prototype?{module:r}=r:console.warn("using deprecated parameters for `initSync()`; pass a single object instead"));const e=Ie();r instanceof WebAssembly.Module||(r=new WebAssembly.Module(r));const t=new WebAssembly.Instance(r,e);return Xe(t)}class W extends Error{code;hint;constructor(e,t,n){super(t),this.name="StriataError",this.code=e,this.hint=n}}function pe(r){if(r instanceof W)return r;if(r instanceof I){const t=new W(r.code,r.message,r.hint);return r.free(),t}if(r instanceof WebAssembly.RuntimeError||r instanceof RangeError)return new W("too-large","the model took more memory than the page has","close other pages, or load a stream with fewer triangles");if(r instanceof DOMException&&r.name==="AbortError")return Je();const e=r instanceof Error?r.message:String(r);return new W("network",e)}function Je(){return new W("aborted","loading was aborted")}function ve(r){return{code:r.code,message:r.message,hint:r.hint}}var Ke=ArrayBuffer,v=Uint8Array,oe=Uint16Array,Qe=Int16Array,ae=Int32Array,me=function(r,e,t){if(v.prototype.slice)return v.prototype.slice.call(r,e,t);(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length);var n=new v(t-e);return n.set(r.subarray(e,t)),n},_e=function(r,e,t,n){if(v.prototype.fill)return v.prototype.fill.call(r,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>r.length)&&(n=r.length);t<n;++t)r[t]=e;return r},Ze=function(r,e,t,n){if(v.prototype.copyWithin)return v.prototype.copyWithin.call(r,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>r.length)&&(n=r.length);t<n;)r[e++]=r[t++]},er=["invalid zstd data","window size too large (>2046MB)","invalid block type","FSE accuracy too high","match distance too far back","unexpected EOF"],p=function(r,e,t){var n=new Error(e||er[r]);if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,p),!t)throw n;return n},xe=function(r,e,t){for(var n=0,i=0;n<t;++n)i|=r[e++]<<(n<<3);return i},rr=function(r,e){return(r[e]|r[e+1]<<8|r[e+2]<<16|r[e+3]<<24)>>>0},tr=function(r,e){var t=r[0]|r[1]<<8|r[2]<<16;if(t==3126568&&r[3]==253){var n=r[4],i=n>>5&1,s=n>>2&1,a=n&3,_=n>>6;n&8&&p(0);var h=6-i,f=a==3?4:a,d=xe(r,h,f);h+=f;var g=_?1<<_:i,m=xe(r,h,g)+(_==1&&256),b=m;if(!i){var z=1<<10+(r[5]>>3);b=z+(z>>3)*(r[5]&7)}b>2145386496&&p(1);var u=new v(b+12);return u[0]=1,u[4]=4,u[8]=8,{b:h+g,y:0,l:0,d,w:e&&e!=1?e:u.subarray(12),e:b,o:new ae(u.buffer,0,3),u:m,c:s,m:Math.min(131072,b)}}else if((t>>4|r[3]<<20)==25481893)return rr(r,4)+8;p(0)},L=function(r){for(var e=0;1<<e<=r;++e);return e-1},Q=function(r,e,t){var n=(e<<3)+4,i=(r[e]&15)+5;i>t&&p(3);for(var s=1<<i,a=s,_=-1,h=-1,f=-1,d=s,g=new Ke(512+(s<<2)),m=new Qe(g,0,256),b=new oe(g,0,256),z=new oe(g,512,s),u=512+(s<<1),y=new v(g,u,s),R=new v(g,u+s);_<255&&a>0;){var E=L(a+1),A=n>>3,B=(1<<E+1)-1,M=(r[A]|r[A+1]<<8|r[A+2]<<16)>>(n&7)&B,c=(1<<E)-1,F=B-a-1,T=M&c;if(T<F?(n+=E,M=T):(n+=E+1,M>c&&(M-=F)),m[++_]=--M,M==-1?(a+=M,y[--d]=_):a-=M,!M)do{var C=n>>3;h=(r[C]|r[C+1]<<8)>>(n&7)&3,n+=2,_+=h}while(h==3)}(_>255||a)&&p(0);for(var S=0,k=(s>>1)+(s>>3)+3,U=s-1,O=0;O<=_;++O){var w=m[O];if(w<1){b[O]=-w;continue}for(f=0;f<w;++f){y[S]=O;do S=S+k&U;while(S>=d)}}for(S&&p(0),f=0;f<s;++f){var l=b[y[f]]++,x=R[f]=i-L(l);z[f]=(l<<x)-s}return[n+7>>3,{b:i,s:y,n:R,t:z}]},nr=function(r,e){var t=0,n=-1,i=new v(292),s=r[e],a=i.subarray(0,256),_=i.subarray(256,268),h=new oe(i.buffer,268);if(s<128){var f=Q(r,e+1,6),d=f[0],g=f[1];e+=s;var m=d<<3,b=r[e];b||p(0);for(var z=0,u=0,y=g.b,R=y,E=(++e<<3)-8+L(b);E-=y,!(E<m);){var A=E>>3;if(z+=(r[A]|r[A+1]<<8)>>(E&7)&(1<<y)-1,a[++n]=g.s[z],E-=R,E<m)break;A=E>>3,u+=(r[A]|r[A+1]<<8)>>(E&7)&(1<<R)-1,a[++n]=g.s[u],y=g.n[z],z=g.t[z],R=g.n[u],u=g.t[u]}++n>255&&p(0)}else{for(n=s-127;t<n;t+=2){var B=r[++e];a[t]=B>>4,a[t+1]=B&15}++e}var M=0;for(t=0;t<n;++t){var c=a[t];c>11&&p(0),M+=c&&1<<c-1}var F=L(M)+1,T=1<<F,C=T-M;for(C&C-1&&p(0),a[n++]=L(C)+1,t=0;t<n;++t){var c=a[t];++_[a[t]=c&&F+1-c]}var S=new v(T<<1),k=S.subarray(0,T),U=S.subarray(T);for(h[F]=0,t=F;t>0;--t){var O=h[t];_e(U,t,O,h[t-1]=O+_[t]*(1<<F-t))}for(h[0]!=T&&p(0),t=0;t<n;++t){var w=a[t];if(w){var l=h[w];_e(k,t,l,h[w]=l+(1<<F-w))}}return[e,{n:U,b:F,s:k}]},ir=Q(new v([81,16,99,140,49,198,24,99,12,33,196,24,99,102,102,134,70,146,4]),0,6)[1],sr=Q(new v([33,20,196,24,99,140,33,132,16,66,8,33,132,16,66,8,33,68,68,68,68,68,68,68,68,36,9]),0,6)[1],or=Q(new v([32,132,16,66,102,70,68,68,68,68,36,73,2]),0,5)[1],Te=function(r,e){for(var t=r.length,n=new ae(t),i=0;i<t;++i)n[i]=e,e+=1<<r[i];return n},ye=new v(new ae([0,0,0,0,16843009,50528770,134678020,202050057,269422093]).buffer,0,36),ar=Te(ye,0),be=new v(new ae([0,0,0,0,0,0,0,0,16843009,50528770,117769220,185207048,252579084,16]).buffer,0,53),_r=Te(be,3),Z=function(r,e,t){var n=r.length,i=e.length,s=r[n-1],a=(1<<t.b)-1,_=-t.b;s||p(0);for(var h=0,f=t.b,d=(n<<3)-8+L(s)-f,g=-1;d>_&&g<i;){var m=d>>3,b=(r[m]|r[m+1]<<8|r[m+2]<<16)>>(d&7);h=(h<<f|b)&a,e[++g]=t.s[h],d-=f=t.n[h]}(d!=_||g+1!=i)&&p(0)},hr=function(r,e,t){var n=6,i=e.length,s=i+3>>2,a=s<<1,_=s+a;Z(r.subarray(n,n+=r[0]|r[1]<<8),e.subarray(0,s),t),Z(r.subarray(n,n+=r[2]|r[3]<<8),e.subarray(s,a),t),Z(r.subarray(n,n+=r[4]|r[5]<<8),e.subarray(a,_),t),Z(r.subarray(n),e.subarray(_),t)},lr=function(r,e,t){var n,i=e.b,s=r[i],a=s>>1&3;e.l=s&1;var _=s>>3|r[i+1]<<5|r[i+2]<<13,h=(i+=3)+_;if(a==1)return i>=r.length?void 0:(e.b=i+1,_e(new v(_),r[i]));if(!(h>r.length)){if(a==0)return e.b=h,me(r,i,h);if(a==2){var f=r[i],d=f&3,g=f>>2&3,m=f>>4,b=0,z=0;d<2?g&1?m|=r[++i]<<4|(g&2&&r[++i]<<12):m=f>>3:(z=g,g<2?(m|=(r[++i]&63)<<4,b=r[i]>>6|r[++i]<<2):g==2?(m|=r[++i]<<4|(r[++i]&3)<<12,b=r[i]>>2|r[++i]<<6):(m|=r[++i]<<4|(r[++i]&63)<<12,b=r[i]>>6|r[++i]<<2|r[++i]<<10)),++i;var u=new v(e.m),y=u.length-m;if(d==0)u.set(r.subarray(i,i+=m),y);else if(d==1)_e(u,r[i++],y);else{var R=e.h;if(d==2){var E=nr(r,i);b+=i-(i=E[0]),e.h=R=E[1]}else R||p(0);(z?hr:Z)(r.subarray(i,i+=b),u.subarray(y),R)}var A=r[i++];if(A){A==255?A=(r[i++]|r[i++]<<8)+32512:A>127&&(A=A-128<<8|r[i++]);var B=r[i++];B&3&&p(0);for(var M=[sr,or,ir],c=2;c>-1;--c){var F=B>>(c<<1)+2&3;if(F==1){var T=new v([0,0,r[i++]]);M[c]={s:T.subarray(2,3),n:T.subarray(0,1),t:new oe(T.buffer,0,1),b:0}}else F==2?(n=Q(r,i,9-(c&1)),i=n[0],M[c]=n[1]):F==3&&(e.t||p(0),M[c]=e.t[c])}var C=e.t=M,S=C[0],k=C[1],U=C[2],O=r[h-1];O||p(0);var w=(h<<3)-8+L(O)-U.b,l=w>>3,x=0,he=(r[l]|r[l+1]<<8)>>(w&7)&(1<<U.b)-1;l=(w-=k.b)>>3;var le=(r[l]|r[l+1]<<8)>>(w&7)&(1<<k.b)-1;l=(w-=S.b)>>3;var ce=(r[l]|r[l+1]<<8)>>(w&7)&(1<<S.b)-1;for(++A;--A;){var Ae=U.s[he],ke=U.n[he],Me=S.s[ce],Ue=S.n[ce],We=k.s[le],De=k.n[le];l=(w-=We)>>3;var Be=1<<We,P=Be+((r[l]|r[l+1]<<8|r[l+2]<<16|r[l+3]<<24)>>>(w&7)&Be-1);l=(w-=be[Me])>>3;var ee=_r[Me]+((r[l]|r[l+1]<<8|r[l+2]<<16)>>(w&7)&(1<<be[Me])-1);l=(w-=ye[Ae])>>3;var ue=ar[Ae]+((r[l]|r[l+1]<<8|r[l+2]<<16)>>(w&7)&(1<<ye[Ae])-1);if(l=(w-=ke)>>3,he=U.t[he]+((r[l]|r[l+1]<<8)>>(w&7)&(1<<ke)-1),l=(w-=Ue)>>3,ce=S.t[ce]+((r[l]|r[l+1]<<8)>>(w&7)&(1<<Ue)-1),l=(w-=De)>>3,le=k.t[le]+((r[l]|r[l+1]<<8)>>(w&7)&(1<<De)-1),P>3)e.o[2]=e.o[1],e.o[1]=e.o[0],e.o[0]=P-=3;else{var fe=P-(ue!=0);fe?(P=fe==3?e.o[0]-1:e.o[fe],fe>1&&(e.o[2]=e.o[1]),e.o[1]=e.o[0],e.o[0]=P):P=e.o[0]}for(var c=0;c<ue;++c)u[x+c]=u[y+c];x+=ue,y+=ue;var re=x-P;if(re<0){var te=-re,xr=e.e+re;te>ee&&(te=ee);for(var c=0;c<te;++c)u[x+c]=e.w[xr+c];x+=te,ee-=te,re=0}for(var c=0;c<ee;++c)u[x+c]=u[re+c];x+=ee}if(x!=y)for(;y<u.length;)u[x++]=u[y++];else x=u.length;u=me(u,0,x)}else{var c;y&&(u=me(u,y))}return e.b=h,u}p(2)}},Oe=function(r,e){if(r.length==1)return r[0];for(var t=new v(e),n=0,i=0;n<r.length;++n){var s=r[n];t.set(s,i),i+=s.length}return t},cr=(function(){function r(e){this.ondata=e,this.c=[],this.l=0,this.z=0}return r.prototype.push=function(e,t){if(typeof this.s=="number"){var n=Math.min(e.length,this.s);e=e.subarray(n),this.s-=n}var i=e.length,s=i+this.l;if(!this.s){if(t){if(!s){this.ondata(new v(0),!0);return}s<5&&p(5)}else if(s<18){this.c.push(e),this.l=s;return}if(this.l&&(this.c.push(e),e=Oe(this.c,s),this.c=[],this.l=0),typeof(this.s=tr(e))=="number")return this.push(e,t)}if(typeof this.s!="number"){if(s<(this.z||3)){t&&p(5),this.c.push(e),this.l=s;return}if(this.l&&(this.c.push(e),e=Oe(this.c,s),this.c=[],this.l=0),!this.z&&s<(this.z=e[this.s.b]&2?4:3+(e[this.s.b]>>3|e[this.s.b+1]<<5|e[this.s.b+2]<<13))){t&&p(5),this.c.push(e),this.l=s;return}else this.z=0;for(;;){var a=lr(e,this.s);if(a)this.ondata(a,!1),Ze(this.s.w,0,a.length),this.s.w.set(a,this.s.w.length-a.length);else{t&&p(5);var _=e.subarray(this.s.b);this.s.b=0,this.c.push(_),this.l+=_.length;return}if(this.s.l){var h=e.subarray(this.s.b);this.s=this.s.c*4,this.push(h,t);return}}}else t&&p(5)},r})();function ur(r){if(r.length===1)return r[0];const e=new Uint8Array(r.reduce((n,i)=>n+i.length,0));let t=0;for(const n of r)e.set(n,t),t+=n.length;return e}const fr=3,gr=1<<30,wr=64<<20,pr=2e3;async function vr(r,e){for(let t=0;t<fr;t++){const n=mr(r);if(!n)break;const i=new dr(Math.min(gr,Math.max(wr,r.length*pr)),e);try{await(n==="gzip"?yr(r,i):br(r,i))}catch(s){throw s instanceof W?s:new W("corrupt",`${e}: the ${n} data are damaged or cut off: ${s instanceof Error?s.message:String(s)}`)}r=ur(i.all),e=e.replace(/\\.(gz|zst)$/i,"")}return{bytes:r,name:e}}function mr(r){const e=(...t)=>t.every((n,i)=>r[i]===n);return e(31,139,8)?"gzip":e(40,181,47,253)?"zstd":void 0}async function yr(r,e){const n=new Blob([r]).stream().pipeThrough(new DecompressionStream("gzip")).getReader();for(;;){const{done:i,value:s}=await n.read();if(i)return;e.push(s)}}function br(r,e){let t=!1;const n=new cr((s,a)=>{e.push(s),t||=a===!0}),i=1<<20;for(let s=0;s<r.length;s+=i)n.push(r.subarray(s,s+i),s+i>=r.length);if(!t)throw new Error("they end too early")}class dr{constructor(e,t){this.most=e,this.name=t}all=[];#r=0;push(e){if(this.#r+=e.length,this.#r>this.most)throw new W("too-large",`${this.name}: grows past ${this.most} bytes, more than a mesh can`);this.all.push(e.slice())}}const de=8192,Ar=60,Mr=4;function Er(){return new Promise(r=>{const{port1:e,port2:t}=new MessageChannel;e.onmessage=()=>{e.close(),r()},t.postMessage(null)})}class zr{#r;#p;#e=new j;#n=[];#i;#o=!1;#t=!1;#v=!1;#a=!1;#m={by:"detail",value:1,limit:0};#_="surface";#s="download";#y=0;#b=!1;#d=-1;#u=0;#f=0;#g=0;#w=0;#h;constructor(e,t){this.#r=e,this.#p=t}take(e){if(!this.#t)switch(e.type){case"bytes":if(this.#a)break;this.#n.push(e.bytes),this.#A();break;case"end":if(this.#a)break;this.#i=e.error?{error:e.error}:{},this.#A();break;case"file":this.#x(e.bytes,e.name);break;case"show":this.#m=e.wish,this.#_=e.colouring,this.#e.is_ready&&this.#l(()=>this.#c(e.ticket));break}}dispose(){this.#v||(this.#v=!0,this.#t=!0,clearTimeout(this.#h),this.#n=[],this.#e.free())}async#A(){if(!this.#o){for(this.#o=!0;this.#n.length>0&&!this.#t;){this.#s="decode";const e=this.#z();if(e){this.#n=[],this.#i={error:ve(e)};break}performance.now()>=this.#w&&this.#l(()=>this.#M()),await Er()}this.#o=!1,!this.#t&&(this.#i?this.#F(this.#i.error):this.#E())}}#E(){clearTimeout(this.#h),this.#h=setTimeout(()=>{!this.#o&&!this.#t&&!this.#a&&this.#l(()=>this.#M())},this.#w-performance.now())}#z(){const e=performance.now();try{for(;performance.now()-e<this.#p;){const t=this.#n.shift();if(!t)break;this.#e.push(t.subarray(0,de)),t.length>de&&this.#n.unshift(t.subarray(de))}return}catch(t){return pe(t)}finally{const t=performance.now();this.#u+=t-e,this.#e.grow(),this.#f+=performance.now()-t}}#F(e){let t=e;this.#a=!0,clearTimeout(this.#h);try{if(!t&&!this.#e.is_complete&&(t={code:"corrupt",message:"the stream ends before the mesh does",hint:"was the file copied whole?"}),(t?.code!=="corrupt"||!e)&&this.#S(),this.#e.reveal(),!this.#e.is_ready)throw new W("corrupt","the stream ends before there is anything to draw");this.#s="done",this.#c(0)}catch(n){t??=ve(pe(n))}this.#i=void 0,this.#r(t?{type:"failed",error:t}:{type:"finished"})}#S(){const e=performance.now();try{this.#e.finish()}finally{this.#u+=performance.now()-e}}async#x(e,t){this.#s="build";const n=performance.now(),i={report:(_,h)=>this.#r({type:"building",share:h})};let s,a;try{s=await vr(e,t)}catch(_){a=_}this.#t||this.#l(()=>{if(!s)throw a;const _=j.from_file(s.bytes,s.name,i);this.#e.free(),this.#e=_,this.#f=performance.now()-n,this.#s="done",this.#c(0),this.#r({type:"finished"})})}#l(e){try{e()}catch(t){this.#t=!0,this.#r({type:"failed",error:ve(pe(t))})}}#M(){this.#e.reveal(),this.#e.is_ready&&this.#c(0)}#c(e){const t=performance.now(),n=this.#T(),i=this.#R(),s=this.#C(),a=this.#k(),_=this.#e,[h,f]=[_.indices(),_.group_counts()];this.#g=performance.now()-t,this.#w=performance.now()+Math.max(Ar,Mr*this.#g);const g={type:"update",state:this.#U(),vertices:s,smoothNormals:a,indices:h,groupCounts:f,numbers:i,settled:n,ticket:e};this.#r(g)}#T(){const{by:e,value:t,limit:n,camera:i}=this.#m,s=this.#e;if(e==="view"&&i)return this.#O(i,t,n);e==="triangles"?s.show_triangles(t):e==="error"?s.show_error(t):s.show_detail(e==="detail"?t:1);const a=s.group_counts().reduce((_,h)=>_+h,0);return n>0&&a>n&&s.show_triangles(n),!0}#O(e,t,n){const i=new ne(Float64Array.from(e),t,n);try{return this.#e.show_view(i)}catch(s){if(!(s instanceof I))throw s;return s.free(),!0}finally{i.free()}}#R(){if(this.#_==="strips")return this.#e.color_strips();if(this.#_==="fans")return this.#e.color_fans();if(this.#_==="surface")return;const e=this.#e.group_counts().reduce((t,n)=>t+n,0);return Uint32Array.from({length:e},(t,n)=>n)}#C(){const e=this.#y;if(this.#e.vertex_count===e)return;const t=this.#e.vertices(e);try{const n=t.take_normals();return this.#b=n!==void 0,this.#y=this.#e.vertex_count,{first:e,positions:t.take_positions(),normals:n,colors:t.take_colors(),uvs:t.take_uvs()}}finally{t.free()}}#k(){if(!(this.#b||this.#d===this.#e.vertex_count))return this.#d=this.#e.vertex_count,this.#e.smooth_normals()}#U(){const e=this.#e;return{kind:e.kind,phase:this.#s,complete:e.is_complete,vertexCount:e.vertex_count,triangleCount:e.triangle_count,fullVertexCount:e.full_vertex_count,fullTriangleCount:e.full_triangle_count,stepCount:e.step_count,streamBytes:e.stream_bytes,bounds:e.bounds(),diagonal:e.diagonal,shownSplitCount:e.shown_split_count,shownError:e.shown_error,decodeMs:this.#u,buildMs:this.#f,updateMs:this.#g}}}function Fr(r){if(r.type!=="update")return[];const{vertices:e,indices:t,groupCounts:n,numbers:i,smoothNormals:s}=r,a=[t,n,i,s];return e&&a.push(e.positions,e.normals,e.colors,e.uvs),a.flatMap(_=>_?[_.buffer]:[])}const Sr=30,Re=self;let Ce;Re.onmessage=({data:r})=>{r instanceof WebAssembly.Module?(Ge({module:r}),Ce=new zr(e=>Re.postMessage(e,Fr(e)),Sr)):Ce?.take(r)}})();\n', S = typeof self < "u" && self.Blob && new Blob([L], { type: "text/javascript;charset=utf-8" });
function he(s) {
  let e;
  try {
    if (e = S && (self.URL || self.webkitURL).createObjectURL(S), !e) throw "";
    const t = new Worker(e, {
      name: s?.name
    });
    return t.addEventListener("error", () => {
      (self.URL || self.webkitURL).revokeObjectURL(e);
    }), t;
  } catch {
    return new Worker(
      "data:text/javascript;charset=utf-8," + encodeURIComponent(L),
      {
        name: s?.name
      }
    );
  } finally {
    e && (self.URL || self.webkitURL).revokeObjectURL(e);
  }
}
const le = 6;
function ue(s, e, t) {
  return e && ce(s, t) || _e(s, t);
}
function ce(s, e) {
  let t;
  try {
    t = new he(), t.postMessage(s);
  } catch {
    return;
  }
  return t.onmessage = ({ data: r }) => e(r), t.onerror = (r) => {
    r.preventDefault();
    const i = r.message || "the worker could not start", n = new z("unsupported", `the worker failed: ${i}`, "try the option worker: false");
    e({ type: "failed", error: T(n) });
  }, {
    // Bytes are copied: a piece may be a part of a buffer that others still read.
    order: (r) => t.postMessage(r),
    dispose: () => t.terminate()
  };
}
function _e(s, e) {
  U(s);
  let t = !1;
  const r = (n) => queueMicrotask(() => void (t || n())), i = new G((n) => r(() => e(n)), le);
  return {
    order: (n) => r(() => i.take(n)),
    dispose: () => {
      t = !0, i.dispose();
    }
  };
}
const fe = 1024;
class ge extends B {
  /** Smallest and largest coordinates. */
  bounds = [];
  #e = 0;
  #t = !1;
  computeBoundingBox() {
    if (this.bounds.length !== 6) return super.computeBoundingBox();
    const [e, t] = [0, 3].map((r) => new _().fromArray(Array.from(this.bounds), r));
    this.boundingBox = new K(e, t);
  }
  computeBoundingSphere() {
    this.computeBoundingBox(), this.boundingSphere = this.boundingBox.getBoundingSphere(new X());
  }
  /** Takes what an update brings. */
  take({ state: e, vertices: t, smoothNormals: r, indices: i, groupCounts: n }) {
    if (this.bounds = e.bounds, this.#h(e.vertexCount, e.fullVertexCount), t) {
      const { first: a, positions: h, normals: l, colors: c, uvs: f } = t;
      this.#r("position", h, 3, a), l && this.#r("normal", l, 3, a), c && this.#r("color", c, 4, a), f && this.#r("uv", f, 2, a);
    }
    r && this.#r("normal", r, 3, 0), this.#s(i, 3 * e.fullTriangleCount), this.clearGroups();
    let o = 0;
    n.forEach((a, h) => {
      this.addGroup(o, 3 * a, h), o += 3 * a;
    }), this.computeBoundingSphere(), this.#t = !1;
  }
  #h(e, t) {
    e <= this.#e || (this.#e = C(this.#e, e, t), this.#t = !0, this.dispose());
  }
  /** Writes numbers of vertices from one on. */
  #r(e, t, r, i) {
    let n = this.getAttribute(e);
    if (!n || this.#t && n.count !== this.#e) {
      const o = t instanceof Uint8Array ? new Uint8Array(this.#e * r) : new Float32Array(this.#e * r);
      n && o.set(n.array.subarray(0, i * r)), n = new b(o, r, t instanceof Uint8Array), this.setAttribute(e, n);
    } else
      n.addUpdateRange(i * r, t.length);
    n.array.set(t, i * r), n.needsUpdate = !0;
  }
  #s(e, t) {
    let r = this.index;
    if (!r || r.count < e.length) {
      r && this.dispose();
      const i = new Uint32Array(C(r?.count ?? 0, e.length, t));
      r = new b(i, 1), this.setIndex(r);
    } else
      r.addUpdateRange(0, e.length);
    r.array.set(e), r.needsUpdate = !0, this.setDrawRange(0, e.length);
  }
}
function C(s, e, t) {
  const r = Math.max(fe, 2 * s, e);
  return t >= e ? Math.min(r, t) : r;
}
const m = 1024, de = 2654435761, pe = be();
function we(s, e, t) {
  const r = { positions: new Float32Array(3 * e.length), colors: new Uint8Array(4 * e.length) };
  for (let n = 0; n < e.length; n++) {
    const o = 3 * e[n], a = 3 * (Math.imul(t[n / 3 | 0], de) >>> 22);
    for (let h = 0; h < 3; h++)
      r.positions[3 * n + h] = s[o + h], r.colors[4 * n + h] = pe[a + h];
    r.colors[4 * n + 3] = 255;
  }
  const i = new B();
  return i.setAttribute("position", new b(r.positions, 3)), i.setAttribute("color", new b(r.colors, 4, !0)), i;
}
function be() {
  const s = new Uint8Array(3 * m), e = new Z();
  for (let t = 0; t < m; t++)
    e.setHSL(t / m, 0.62, 0.5 + 0.1 * (t % 3), Y), [e.r, e.g, e.b].forEach((r, i) => s[3 * t + i] = Math.round(255 * r));
  return s;
}
const g = new ee(), [d, y, E, v] = [new _(), new _(), new _(), new _()];
function me(s, e, t, r) {
  if (!(t >= 1 && r >= 1)) return;
  v.setFromMatrixScale(s.matrixWorld);
  const [i, n] = [Math.min(...v.toArray()), Math.max(...v.toArray())];
  if (!(i > 0)) return;
  if (e.isOrthographicCamera) {
    const { top: W, bottom: I, zoom: P } = e;
    return { kind: "orthographic", unitsPerPixel: Math.abs(W - I) / (P * r * n) };
  }
  if (!e.isPerspectiveCamera) return;
  g.copy(s.matrixWorld).invert(), d.setFromMatrixPosition(e.matrixWorld).applyMatrix4(g), y.setFromMatrixColumn(e.matrixWorld, 2).negate().transformDirection(g), y.multiplyScalar(Math.max(1, d.length())).add(d), E.setFromMatrixColumn(e.matrixWorld, 1).transformDirection(g);
  const o = e.projectionMatrix.elements, [a, h] = [Math.abs(o[0]), Math.abs(o[5])], l = [(1 + Math.abs(o[8])) / a, (1 + Math.abs(o[9])) / h], c = r * h * l[1], f = [Math.max(1, Math.round(c * l[0] / l[1])), Math.max(1, Math.round(c))], M = [...d.toArray(), ...y.toArray(), ...E.toArray(), l[1], ...f];
  if (M.every(Number.isFinite))
    return { kind: "perspective", numbers: M, stretch: n / i };
}
const p = new te(), ye = 4294967295;
class ve extends k {
  isStriataMesh = !0;
  finished;
  state;
  #e;
  #t;
  /** Made here, and freed here. */
  #h;
  #r;
  #s;
  #i;
  #c = 1;
  #a = null;
  #n = null;
  #o = null;
  #f = !1;
  #u = "surface";
  #g = !1;
  /** The request that has not been answered yet, and whether another has to follow it. */
  #w = 0;
  #p = !1;
  #l = !1;
  #_ = { by: "detail", value: 1, limit: 0 };
  /** The last camera, as a wish; for views a wish is made when the mesh is drawn. */
  #d;
  #M = !0;
  #b = !1;
  #k;
  #v;
  constructor(e, t, r) {
    const i = new ge(), n = t ? void 0 : Me(e);
    super(i, t ?? n), this.#t = i, this.#r = this.material, this.#h = n, this.#e = r, this.state = e.state, this.#i = e, this.finished = new Promise((o, a) => {
      this.#k = o, this.#v = a;
    }), this.finished.catch(() => {
    }), this.onBeforeRender = (o, a, h) => this.#E(o, a, h), this.update(e);
  }
  get detail() {
    return this.#c ?? (this.stepCount > 0 ? this.splitCount / this.stepCount : 1);
  }
  set detail(e) {
    this.#c = Math.min(1, Math.max(0, w(e, "detail"))), [this.#a, this.#n, this.#o] = [null, null, null], this.#m();
  }
  get triangleBudget() {
    return this.#a;
  }
  set triangleBudget(e) {
    this.#a = e === null ? null : Math.max(1, Math.floor(w(e, "triangleBudget"))), this.#x(), this.#m();
  }
  get error() {
    return this.state.shownError;
  }
  get maxError() {
    return this.#n;
  }
  set maxError(e) {
    this.#n = e === null ? null : Math.max(0, w(e, "maxError")), e !== null && (this.#o = null), this.#x(), this.#m();
  }
  get pixelError() {
    return this.#o;
  }
  set pixelError(e) {
    this.#o = e === null ? null : Math.max(0, w(e, "pixelError")), e !== null && (this.#n = null), this.#x(), this.#m(), this.dispatchEvent({ type: "change" });
  }
  get frozen() {
    return this.#f;
  }
  set frozen(e) {
    this.#f = e, this.dispatchEvent({ type: "change" });
  }
  get colouring() {
    return this.#u;
  }
  set colouring(e) {
    e !== this.#u && (this.#u === "surface" && (this.#r = this.material), this.#u = e, this.#l = !0, this.#y());
  }
  get wireframe() {
    return this.#g;
  }
  set wireframe(e) {
    this.#g = e;
    for (const t of [this.material].flat()) x(t, e);
    this.dispatchEvent({ type: "change" });
  }
  get triangleCount() {
    return this.#i.indices.length / 3;
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
    return this.#e.bytes().received;
  }
  get bytesTotal() {
    return this.#e.bytes().total ?? (this.state.streamBytes || null);
  }
  get diagonal() {
    return this.state.diagonal;
  }
  get kind() {
    return this.state.kind;
  }
  get timings() {
    const { decodeMs: e, buildMs: t, updateMs: r } = this.state;
    return { decodeMs: e, buildMs: t, updateMs: r };
  }
  /** A plain mesh that shows what this one shows: geometry and material are shared, levels are chosen here alone. */
  clone(e) {
    return new k(this.geometry, this.material).copy(this, e);
  }
  dispose() {
    this.#b || (this.#b = !0, this.#e.dispose(), this.#t.dispose(), this.geometry !== this.#t && this.geometry.dispose(), this.#h?.dispose(), this.#s?.dispose(), this.#v(new z("aborted", "the mesh was disposed of")));
  }
  /** Takes another level; called by the loader. */
  update(e) {
    this.#b || (this.state = e.state, this.#i = e, this.#t.take(e), this.#S(e), e.ticket === this.#w && (this.#p = !1, this.#M = e.settled), this.#l && this.#y(), this.dispatchEvent({ type: "change" }));
  }
  /** Nothing more comes; called by the loader. */
  end(e) {
    if (!e) {
      this.#k();
      return;
    }
    this.#v(e), this.dispatchEvent({ type: "error", error: e });
  }
  /** Shows the surface, or triangles in the colours of what draws them. */
  #S({ numbers: e, indices: t }) {
    const r = this.geometry;
    if (e && this.#u !== "surface")
      this.#s ??= new F({ vertexColors: !0, flatShading: !0, side: O, roughness: 0.9 }), x(this.#s, this.#g), this.geometry = we(this.#t.getAttribute("position")?.array ?? [], t, e), this.geometry.boundingSphere = this.#t.boundingSphere, this.geometry.boundingBox = this.#t.boundingBox, this.material = this.#s;
    else if (this.geometry !== this.#t && this.#u === "surface") {
      this.geometry = this.#t, this.material = this.#r;
      for (const i of [this.material].flat()) x(i, this.#g);
    }
    r !== this.geometry && r !== this.#t && r.dispose();
  }
  #x() {
    const e = [this.#a, this.#n, this.#o];
    this.#c = e.every((t) => t === null) ? 1 : null;
  }
  /** Sends a wish, at once or when the last one is answered. */
  #m() {
    this.#l = !0, this.#y();
  }
  #y() {
    this.#p || this.#b || (this.#l = !1, this.#p = !0, this.#_ = this.#C(), this.#e.order({ type: "show", wish: this.#_, colouring: this.#u, ticket: ++this.#w }));
  }
  #C() {
    const e = this.#A();
    return this.#o !== null ? this.#d ?? { by: "detail", value: e > 0 ? 1 : 0, limit: e } : this.#n !== null ? { by: "error", value: this.#n, limit: e } : this.#a !== null ? { by: "triangles", value: e, limit: e } : { by: "detail", value: this.#c ?? 1, limit: 0 };
  }
  /** The budget for the engine; 0 is none. */
  #A() {
    return Math.min(this.#a ?? 0, ye);
  }
  /** Follows the camera that the mesh is about to be drawn for. */
  #E(e, t, r) {
    if (this.#o === null || this.#f) return;
    const i = e.getRenderTarget();
    i ? p.set(i.width, i.height) : e.getDrawingBufferSize(p);
    const n = me(this, r, p.x, p.y);
    if (!n) return;
    const o = this.#A();
    this.#d = n.kind === "perspective" ? { by: "view", value: this.#o / n.stretch, limit: o, camera: n.numbers } : { by: "error", value: this.#o * n.unitsPerPixel, limit: o }, !(this.#M && xe(this.#d, this.#_)) && this.#y();
  }
}
function w(s, e) {
  if (Number.isNaN(Number(s))) throw new TypeError(`${e} has to be a number, not ${String(s)}`);
  return Number(s);
}
function xe(s, e) {
  const t = s.camera?.length === e.camera?.length && (s.camera ?? []).every((r, i) => r === e.camera?.[i]);
  return s.by === e.by && s.value === e.value && s.limit === e.limit && t;
}
function x(s, e) {
  "wireframe" in s && (s.wireframe = e);
}
function Me({ vertices: s }) {
  return new F({ vertexColors: s?.colors !== void 0, side: O, roughness: 0.8, metalness: 0 });
}
function ke(s = {}) {
  return {
    load: (e, t = {}) => new Ae(s, t).run(e)
  };
}
const Ee = function(s) {
  return ke(s);
};
class Ae {
  #e;
  #t;
  /** Ends everything. */
  #h = new AbortController();
  /** Ends the download alone. */
  #r = new AbortController();
  #s;
  #i;
  /** Whether the engine only sees the stream of a larger file. */
  #c = !1;
  #a = 0;
  #n = null;
  #o;
  #f;
  constructor(e, t) {
    this.#e = e, this.#t = t;
  }
  run(e) {
    const { signal: t } = this.#t;
    if (t?.aborted) return Promise.reject(u());
    const r = new Promise((n, o) => {
      this.#o = n, this.#f = o;
    }), i = () => this.#_(u());
    return t?.addEventListener("abort", i, { once: !0 }), this.#r.signal.addEventListener("abort", () => t?.removeEventListener("abort", i)), this.#u(e).catch((n) => this.#g(H(n))), r;
  }
  async #u(e) {
    const [t, r] = await Promise.all([
      V(this.#e.wasm),
      q(e, this.#t.name, this.#r.signal)
    ]);
    if (this.#h.signal.aborted) return;
    U(t), this.#n = r.length;
    const i = await ie(r);
    if (this.#h.signal.aborted) return;
    this.#n = i.byteCount, this.#c = i.isInContainer, this.#s = ue(t, this.#e.worker ?? !0, (o) => this.#w(o));
    const n = [];
    for await (const o of Q(i.pieces)) {
      if (this.#r.signal.aborted) return;
      this.#a += o.length, i.isStream ? this.#s.order({ type: "bytes", bytes: o }) : n.push(o), this.#l();
    }
    this.#r.signal.aborted || (this.#n = this.#a, i.isStream ? this.#s.order({ type: "end" }) : this.#s.order({ type: "file", bytes: R(n), name: r.name || "the file" }), this.#l());
  }
  /** The source failed: what has come of it may be something nevertheless. */
  #g(e) {
    this.#r.signal.aborted || (this.#s && e.code !== "aborted" ? this.#s.order({ type: "end", error: T(e) }) : this.#_(e));
  }
  #w(e) {
    if (!this.#h.signal.aborted)
      switch (e.type) {
        case "update":
          this.#c && (e.state.kind = "striata"), this.#i ? this.#i.update(e) : (e.indices.length > 0 || e.state.complete) && (this.#i = new ve(e, this.#t.material, this.#p()), this.#i.name = this.#t.name ?? "", this.#o(this.#i)), this.#l();
          break;
        case "building":
          this.#l("build");
          break;
        case "failed":
          this.#_(J(e.error));
          break;
        case "finished":
          this.#r.abort(u()), this.#i?.end(), this.#l();
          break;
      }
  }
  /** What the mesh needs of us. */
  #p() {
    return {
      order: (e) => this.#s?.order(e),
      bytes: () => ({ received: this.#a, total: this.#n }),
      dispose: () => this.#d()
    };
  }
  #l(e) {
    const t = this.#i?.state, r = {
      bytesReceived: this.#a,
      bytesTotal: this.#n ?? (t?.streamBytes || null),
      triangleCount: t?.triangleCount ?? 0,
      vertexCount: t?.vertexCount ?? 0,
      complete: t?.complete ?? !1,
      phase: e ?? t?.phase ?? "download"
    };
    try {
      this.#t.onProgress?.(r);
    } catch (i) {
      queueMicrotask(() => {
        throw i;
      });
    }
    this.#i?.dispatchEvent({ type: "progress", progress: r });
  }
  /** Ends loading; a mesh that is there stays, with what it has. */
  #_(e) {
    if (!this.#h.signal.aborted) {
      if (this.#i && e.code !== "aborted") {
        this.#r.abort(u()), this.#i.end(e);
        return;
      }
      this.#i?.end(e), this.#d(), this.#f(e);
    }
  }
  #d() {
    this.#h.abort(u()), this.#r.abort(u()), this.#s?.dispose();
  }
}
export {
  z as StriataError,
  Ee as StriataLoader,
  ve as StriataMesh
};
