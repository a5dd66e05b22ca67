import { d as C, p as L, S as I, l as P, e as j, a as E, f as R, s as z, E as D, g as w, c as N, w as $, o as G, i as H, h as V } from "./wasm.js";
import { BufferGeometry as U, Vector3 as c, Box3 as q, Sphere as Q, BufferAttribute as p, Color as J, SRGBColorSpace as K, Matrix4 as X, Mesh as Z, MeshStandardMaterial as F, DoubleSide as B, Vector2 as Y } from "three";
const ee = [137, 83, 84, 82], v = [..."STRIATA\0"].map((s) => s.charCodeAt(0)), te = 65536;
async function re(s) {
  const e = new ne(s.pieces);
  if (await e.grow(v.length), e.startsWith(ee))
    return { isStream: !0, isInContainer: !1, pieces: e.all(), byteCount: s.length };
  if (e.startsWith(v)) {
    const t = await ie(e);
    if (t) return se(s, e, t);
  }
  return { isStream: !1, isInContainer: !1, pieces: e.all(), byteCount: s.length };
}
async function se(s, e, { offset: t, length: r }) {
  const i = e.bytes.length;
  return i < t && s.range && t - i > te ? (await e.drop(), { isStream: !0, isInContainer: !0, pieces: await s.range(t, t + r), byteCount: r }) : { isStream: !0, isInContainer: !0, pieces: P(j(e.all(), t), r), byteCount: r };
}
async function ie(s) {
  for (; ; ) {
    const e = I.find(s.bytes), { needed: t, offset: r, length: i } = e;
    if (e.free(), t > s.bytes.length) {
      if (!await s.grow(t)) return;
      continue;
    }
    return i > 0 ? { offset: r, length: i } : void 0;
  }
}
class ne {
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
      this.bytes = C([this.bytes, t.value]);
    }
    return !0;
  }
  startsWith(e) {
    return e.every((t, r) => this.bytes[r] === t);
  }
  all() {
    return L(this.bytes, this.#e);
  }
  async drop() {
    await this.#e.return?.();
  }
}
const T = '(function(){"use strict";class ${static __wrap(e){const t=Object.create($.prototype);return t.__wbg_ptr=e,ze.register(t,t.__wbg_ptr,t),t}__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,ze.unregister(this),e}free(){const e=this.__destroy_into_raw();o.__wbg_failure_free(e,0)}get code(){let e,t;try{const n=o.failure_code(this.__wbg_ptr);return e=n[0],t=n[1],N(n[0],n[1])}finally{o.__wbindgen_free(e,t,1)}}get hint(){const e=o.failure_hint(this.__wbg_ptr);let t;return e[0]!==0&&(t=N(e[0],e[1]),o.__wbindgen_free(e[0],e[1]*1,1)),t}get message(){let e,t;try{const n=o.failure_message(this.__wbg_ptr);return e=n[0],t=n[1],N(n[0],n[1])}finally{o.__wbindgen_free(e,t,1)}}}Symbol.dispose&&($.prototype[Symbol.dispose]=$.prototype.free);class I{static __wrap(e){const t=Object.create(I.prototype);return t.__wbg_ptr=e,ge.register(t,t.__wbg_ptr,t),t}__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,ge.unregister(this),e}free(){const e=this.__destroy_into_raw();o.__wbg_model_free(e,0)}bounds(){const e=o.model_bounds(this.__wbg_ptr);var t=q(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}build(){const e=o.model_build(this.__wbg_ptr);if(e[1])throw j(e[0])}color_fans(){const e=o.model_color_fans(this.__wbg_ptr);var t=ie(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}color_strips(){const e=o.model_color_strips(this.__wbg_ptr);if(e[3])throw j(e[2]);var t=ie(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}get diagonal(){return o.model_diagonal(this.__wbg_ptr)}finish(){const e=o.model_finish(this.__wbg_ptr);if(e[1])throw j(e[0])}static from_file(e,t,n){let i,s,_,a;try{i=Fe(e,o.__wbindgen_malloc),s=D,_=Ye(t,o.__wbindgen_malloc,o.__wbindgen_realloc),a=D}catch(f){throw _&&o.__wbindgen_free(_,a*1,1),i&&o.__wbindgen_free(i,s*1,1),f}const l=o.model_from_file(i,s,_,a,n);if(l[2])throw j(l[1]);return I.__wrap(l[0])}get full_triangle_count(){return o.model_full_triangle_count(this.__wbg_ptr)>>>0}get full_vertex_count(){return o.model_full_vertex_count(this.__wbg_ptr)>>>0}get group_count(){return o.model_group_count(this.__wbg_ptr)>>>0}group_counts(){const e=o.model_group_counts(this.__wbg_ptr);var t=ie(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}indices(){const e=o.model_indices(this.__wbg_ptr);var t=ie(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}get is_built(){return o.model_is_built(this.__wbg_ptr)!==0}get is_complete(){return o.model_is_complete(this.__wbg_ptr)!==0}get is_ready(){return o.model_is_ready(this.__wbg_ptr)!==0}get kind(){let e,t;try{const n=o.model_kind(this.__wbg_ptr);return e=n[0],t=n[1],N(n[0],n[1])}finally{o.__wbindgen_free(e,t,1)}}constructor(){const e=o.model_new();return this.__wbg_ptr=e,ge.register(this,this.__wbg_ptr,this),this}push(e){const t=Fe(e,o.__wbindgen_malloc),n=D,i=o.model_push(this.__wbg_ptr,t,n);if(i[1])throw j(i[0])}show_detail(e){o.model_show_detail(this.__wbg_ptr,e)}show_error(e){o.model_show_error(this.__wbg_ptr,e)}show_triangles(e){o.model_show_triangles(this.__wbg_ptr,e)}show_view(e){je(e,ne);const t=o.model_show_view(this.__wbg_ptr,e.__wbg_ptr);if(t[2])throw j(t[1]);return t[0]!==0}get shown_error(){return o.model_shown_error(this.__wbg_ptr)}get shown_split_count(){return o.model_shown_split_count(this.__wbg_ptr)>>>0}smooth_normals(){const e=o.model_smooth_normals(this.__wbg_ptr);var t=q(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}get step_count(){return o.model_step_count(this.__wbg_ptr)>>>0}get stream_bytes(){return o.model_stream_bytes(this.__wbg_ptr)}get triangle_count(){return o.model_triangle_count(this.__wbg_ptr)>>>0}get vertex_count(){return o.model_vertex_count(this.__wbg_ptr)>>>0}vertices(e){const t=o.model_vertices(this.__wbg_ptr,e);return Y.__wrap(t)}}Symbol.dispose&&(I.prototype[Symbol.dispose]=I.prototype.free);class Y{static __wrap(e){const t=Object.create(Y.prototype);return t.__wbg_ptr=e,Ee.register(t,t.__wbg_ptr,t),t}__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,Ee.unregister(this),e}free(){const e=this.__destroy_into_raw();o.__wbg_vertices_free(e,0)}take_colors(){const e=o.vertices_take_colors(this.__wbg_ptr);let t;return e[0]!==0&&(t=Pe(e[0],e[1]).slice(),o.__wbindgen_free(e[0],e[1]*1,1)),t}take_normals(){const e=o.vertices_take_normals(this.__wbg_ptr);let t;return e[0]!==0&&(t=q(e[0],e[1]).slice(),o.__wbindgen_free(e[0],e[1]*4,4)),t}take_positions(){const e=o.vertices_take_positions(this.__wbg_ptr);var t=q(e[0],e[1]).slice();return o.__wbindgen_free(e[0],e[1]*4,4),t}take_uvs(){const e=o.vertices_take_uvs(this.__wbg_ptr);let t;return e[0]!==0&&(t=q(e[0],e[1]).slice(),o.__wbindgen_free(e[0],e[1]*4,4)),t}}Symbol.dispose&&(Y.prototype[Symbol.dispose]=Y.prototype.free);class ne{__destroy_into_raw(){const e=this.__wbg_ptr;return this.__wbg_ptr=0,xe.unregister(this),e}free(){const e=this.__destroy_into_raw();o.__wbg_view_free(e,0)}get pixels(){return o.__wbg_get_view_pixels(this.__wbg_ptr)}get triangle_limit(){return o.__wbg_get_view_triangle_limit(this.__wbg_ptr)>>>0}set pixels(e){o.__wbg_set_view_pixels(this.__wbg_ptr,e)}set triangle_limit(e){o.__wbg_set_view_triangle_limit(this.__wbg_ptr,e)}constructor(e,t,n){const i=+t,s=+n,_=Ve(e,o.__wbindgen_malloc),a=D,l=o.view_new(_,a,i,s);if(l[2])throw j(l[1]);return this.__wbg_ptr=l[0],xe.register(this,this.__wbg_ptr,this),this}}Symbol.dispose&&(ne.prototype[Symbol.dispose]=ne.prototype.free);function Ie(){return{__proto__:null,"./striata_web_bg.js":{__proto__:null,__wbg___wbindgen_throw_4c88d8bf264fd984:function(e,t){throw new Error(N(e,t))},__wbg_failure_new:function(e){return $.__wrap(e)},__wbg_report_581358a93077c908:function(e,t,n,i){e.report(N(t,n),i)},__wbindgen_init_externref_table:function(){const e=o.__wbindgen_externrefs;e.set(0,void 0),e.set(1024,void 0),e.set(1025,null),e.set(1026,!0),e.set(1027,!1)}}}}const ze=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(r=>o.__wbg_failure_free(r,1)),ge=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(r=>o.__wbg_model_free(r,1));typeof FinalizationRegistry>"u"||new FinalizationRegistry(r=>o.__wbg_streamplace_free(r,1));const Ee=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(r=>o.__wbg_vertices_free(r,1)),xe=typeof FinalizationRegistry>"u"?{register:()=>{},unregister:()=>{}}:new FinalizationRegistry(r=>o.__wbg_view_free(r,1));function je(r,e){if(!(r instanceof e))throw new Error(`expected instance of ${e.name}`)}function q(r,e){return r=r>>>0,Le().subarray(r/4,r/4+e)}function ie(r,e){return r=r>>>0,Ne().subarray(r/4,r/4+e)}function Pe(r,e){return r=r>>>0,V().subarray(r/1,r/1+e)}let H=null;function Le(){return(H===null||H.byteLength===0)&&(H=new Float32Array(o.memory.buffer)),H}let X=null;function $e(){return(X===null||X.byteLength===0)&&(X=new Float64Array(o.memory.buffer)),X}function N(r,e){return r=r>>>0,He(V().subarray(r,r+e))}let G=null;function Ne(){return(G===null||G.byteLength===0)&&(G=new Uint32Array(o.memory.buffer)),G}let J=null;function V(){return(J===null||J.byteLength===0)&&(J=new Uint8Array(o.memory.buffer)),J}function Fe(r,e){const t=e(r.length*1,1)>>>0;return V().set(r,t/1),D=r.length,t}function Ve(r,e){const t=e(r.length*8,8)>>>0;return $e().set(r,t/8),D=r.length,t}function Ye(r,e,t){if(t===void 0){const a=K.encode(r),l=e(a.length,1)>>>0;return V().subarray(l,l+a.length).set(a),D=a.length,l}let n=r.length,i=e(n,1)>>>0;const s=V();let _=0;for(;_<n;_++){const a=r.charCodeAt(_);if(a>127)break;s[i+_]=a}if(_!==n){_!==0&&(r=r.slice(_)),i=t(i,n,n=_+r.length*3,1)>>>0;const a=V().subarray(i+_,i+n),l=K.encodeInto(r,a);_+=l.written,i=t(i,n,_,1)>>>0}return D=_,i}function j(r){const e=o.__wbindgen_externrefs.get(r);return o.__externref_table_dealloc(r),e}let se=new TextDecoder("utf-8",{ignoreBOM:!0});se.decode();const qe=2146435072;let we=0;function He(r){return we+=r.length,we>=qe&&(se=new TextDecoder("utf-8",{ignoreBOM:!0}),se.decode(),we=r.length),se.decode(r)}const K=new TextEncoder;"encodeInto"in K||(K.encodeInto=function(r,e){const t=K.encode(r);return e.set(t),{read:r.length,written:t.length}});let D=0,o;function Xe(r,e){return o=r.exports,H=null,X=null,G=null,J=null,o.__wbindgen_start(),o}function Ge(r){if(o!==void 0)return o;r!==void 0&&(Object.getPrototypeOf(r)===Object.prototype?{module:r}=r:console.warn("using deprecated parameters for `initSync()`; pass a single object instead"));const e=Ie();r instanceof WebAssembly.Module||(r=new WebAssembly.Module(r));const t=new WebAssembly.Instance(r,e);return Xe(t)}class k extends Error{code;hint;constructor(e,t,n){super(t),this.name="StriataError",this.code=e,this.hint=n}}function pe(r){if(r instanceof k)return r;if(r instanceof $){const t=new k(r.code,r.message,r.hint);return r.free(),t}if(r instanceof WebAssembly.RuntimeError||r instanceof RangeError)return new k("too-large","the model took more memory than the page has","close other pages, or load a stream with fewer triangles");if(r instanceof DOMException&&r.name==="AbortError")return Je();const e=r instanceof Error?r.message:String(r);return new k("network",e)}function Je(){return new k("aborted","loading was aborted")}function ve(r){return{code:r.code,message:r.message,hint:r.hint}}var Ke=ArrayBuffer,v=Uint8Array,oe=Uint16Array,Qe=Int16Array,_e=Int32Array,ye=function(r,e,t){if(v.prototype.slice)return v.prototype.slice.call(r,e,t);(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length);var n=new v(t-e);return n.set(r.subarray(e,t)),n},ae=function(r,e,t,n){if(v.prototype.fill)return v.prototype.fill.call(r,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>r.length)&&(n=r.length);t<n;++t)r[t]=e;return r},Ze=function(r,e,t,n){if(v.prototype.copyWithin)return v.prototype.copyWithin.call(r,e,t,n);for((t==null||t<0)&&(t=0),(n==null||n>r.length)&&(n=r.length);t<n;)r[e++]=r[t++]},er=["invalid zstd data","window size too large (>2046MB)","invalid block type","FSE accuracy too high","match distance too far back","unexpected EOF"],p=function(r,e,t){var n=new Error(e||er[r]);if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,p),!t)throw n;return n},Se=function(r,e,t){for(var n=0,i=0;n<t;++n)i|=r[e++]<<(n<<3);return i},rr=function(r,e){return(r[e]|r[e+1]<<8|r[e+2]<<16|r[e+3]<<24)>>>0},tr=function(r,e){var t=r[0]|r[1]<<8|r[2]<<16;if(t==3126568&&r[3]==253){var n=r[4],i=n>>5&1,s=n>>2&1,_=n&3,a=n>>6;n&8&&p(0);var l=6-i,f=_==3?4:_,d=Se(r,l,f);l+=f;var g=a?1<<a:i,y=Se(r,l,g)+(a==1&&256),b=y;if(!i){var E=1<<10+(r[5]>>3);b=E+(E>>3)*(r[5]&7)}b>2145386496&&p(1);var u=new v(b+12);return u[0]=1,u[4]=4,u[8]=8,{b:l+g,y:0,l:0,d,w:e&&e!=1?e:u.subarray(12),e:b,o:new _e(u.buffer,0,3),u:y,c:s,m:Math.min(131072,b)}}else if((t>>4|r[3]<<20)==25481893)return rr(r,4)+8;p(0)},P=function(r){for(var e=0;1<<e<=r;++e);return e-1},Q=function(r,e,t){var n=(e<<3)+4,i=(r[e]&15)+5;i>t&&p(3);for(var s=1<<i,_=s,a=-1,l=-1,f=-1,d=s,g=new Ke(512+(s<<2)),y=new Qe(g,0,256),b=new oe(g,0,256),E=new oe(g,512,s),u=512+(s<<1),m=new v(g,u,s),R=new v(g,u+s);a<255&&_>0;){var z=P(_+1),A=n>>3,B=(1<<z+1)-1,M=(r[A]|r[A+1]<<8|r[A+2]<<16)>>(n&7)&B,c=(1<<z)-1,x=B-_-1,T=M&c;if(T<x?(n+=z,M=T):(n+=z+1,M>c&&(M-=x)),y[++a]=--M,M==-1?(_+=M,m[--d]=a):_-=M,!M)do{var C=n>>3;l=(r[C]|r[C+1]<<8)>>(n&7)&3,n+=2,a+=l}while(l==3)}(a>255||_)&&p(0);for(var F=0,U=(s>>1)+(s>>3)+3,W=s-1,O=0;O<=a;++O){var w=y[O];if(w<1){b[O]=-w;continue}for(f=0;f<w;++f){m[F]=O;do F=F+U&W;while(F>=d)}}for(F&&p(0),f=0;f<s;++f){var h=b[m[f]]++,S=R[f]=i-P(h);E[f]=(h<<S)-s}return[n+7>>3,{b:i,s:m,n:R,t:E}]},nr=function(r,e){var t=0,n=-1,i=new v(292),s=r[e],_=i.subarray(0,256),a=i.subarray(256,268),l=new oe(i.buffer,268);if(s<128){var f=Q(r,e+1,6),d=f[0],g=f[1];e+=s;var y=d<<3,b=r[e];b||p(0);for(var E=0,u=0,m=g.b,R=m,z=(++e<<3)-8+P(b);z-=m,!(z<y);){var A=z>>3;if(E+=(r[A]|r[A+1]<<8)>>(z&7)&(1<<m)-1,_[++n]=g.s[E],z-=R,z<y)break;A=z>>3,u+=(r[A]|r[A+1]<<8)>>(z&7)&(1<<R)-1,_[++n]=g.s[u],m=g.n[E],E=g.t[E],R=g.n[u],u=g.t[u]}++n>255&&p(0)}else{for(n=s-127;t<n;t+=2){var B=r[++e];_[t]=B>>4,_[t+1]=B&15}++e}var M=0;for(t=0;t<n;++t){var c=_[t];c>11&&p(0),M+=c&&1<<c-1}var x=P(M)+1,T=1<<x,C=T-M;for(C&C-1&&p(0),_[n++]=P(C)+1,t=0;t<n;++t){var c=_[t];++a[_[t]=c&&x+1-c]}var F=new v(T<<1),U=F.subarray(0,T),W=F.subarray(T);for(l[x]=0,t=x;t>0;--t){var O=l[t];ae(W,t,O,l[t-1]=O+a[t]*(1<<x-t))}for(l[0]!=T&&p(0),t=0;t<n;++t){var w=_[t];if(w){var h=l[w];ae(U,t,h,l[w]=h+(1<<x-w))}}return[e,{n:W,b:x,s:U}]},ir=Q(new v([81,16,99,140,49,198,24,99,12,33,196,24,99,102,102,134,70,146,4]),0,6)[1],sr=Q(new v([33,20,196,24,99,140,33,132,16,66,8,33,132,16,66,8,33,68,68,68,68,68,68,68,68,36,9]),0,6)[1],or=Q(new v([32,132,16,66,102,70,68,68,68,68,36,73,2]),0,5)[1],Te=function(r,e){for(var t=r.length,n=new _e(t),i=0;i<t;++i)n[i]=e,e+=1<<r[i];return n},me=new v(new _e([0,0,0,0,16843009,50528770,134678020,202050057,269422093]).buffer,0,36),_r=Te(me,0),be=new v(new _e([0,0,0,0,0,0,0,0,16843009,50528770,117769220,185207048,252579084,16]).buffer,0,53),ar=Te(be,3),Z=function(r,e,t){var n=r.length,i=e.length,s=r[n-1],_=(1<<t.b)-1,a=-t.b;s||p(0);for(var l=0,f=t.b,d=(n<<3)-8+P(s)-f,g=-1;d>a&&g<i;){var y=d>>3,b=(r[y]|r[y+1]<<8|r[y+2]<<16)>>(d&7);l=(l<<f|b)&_,e[++g]=t.s[l],d-=f=t.n[l]}(d!=a||g+1!=i)&&p(0)},lr=function(r,e,t){var n=6,i=e.length,s=i+3>>2,_=s<<1,a=s+_;Z(r.subarray(n,n+=r[0]|r[1]<<8),e.subarray(0,s),t),Z(r.subarray(n,n+=r[2]|r[3]<<8),e.subarray(s,_),t),Z(r.subarray(n,n+=r[4]|r[5]<<8),e.subarray(_,a),t),Z(r.subarray(n),e.subarray(a),t)},hr=function(r,e,t){var n,i=e.b,s=r[i],_=s>>1&3;e.l=s&1;var a=s>>3|r[i+1]<<5|r[i+2]<<13,l=(i+=3)+a;if(_==1)return i>=r.length?void 0:(e.b=i+1,ae(new v(a),r[i]));if(!(l>r.length)){if(_==0)return e.b=l,ye(r,i,l);if(_==2){var f=r[i],d=f&3,g=f>>2&3,y=f>>4,b=0,E=0;d<2?g&1?y|=r[++i]<<4|(g&2&&r[++i]<<12):y=f>>3:(E=g,g<2?(y|=(r[++i]&63)<<4,b=r[i]>>6|r[++i]<<2):g==2?(y|=r[++i]<<4|(r[++i]&3)<<12,b=r[i]>>2|r[++i]<<6):(y|=r[++i]<<4|(r[++i]&63)<<12,b=r[i]>>6|r[++i]<<2|r[++i]<<10)),++i;var u=new v(e.m),m=u.length-y;if(d==0)u.set(r.subarray(i,i+=y),m);else if(d==1)ae(u,r[i++],m);else{var R=e.h;if(d==2){var z=nr(r,i);b+=i-(i=z[0]),e.h=R=z[1]}else R||p(0);(E?lr:Z)(r.subarray(i,i+=b),u.subarray(m),R)}var A=r[i++];if(A){A==255?A=(r[i++]|r[i++]<<8)+32512:A>127&&(A=A-128<<8|r[i++]);var B=r[i++];B&3&&p(0);for(var M=[sr,or,ir],c=2;c>-1;--c){var x=B>>(c<<1)+2&3;if(x==1){var T=new v([0,0,r[i++]]);M[c]={s:T.subarray(2,3),n:T.subarray(0,1),t:new oe(T.buffer,0,1),b:0}}else x==2?(n=Q(r,i,9-(c&1)),i=n[0],M[c]=n[1]):x==3&&(e.t||p(0),M[c]=e.t[c])}var C=e.t=M,F=C[0],U=C[1],W=C[2],O=r[l-1];O||p(0);var w=(l<<3)-8+P(O)-W.b,h=w>>3,S=0,le=(r[h]|r[h+1]<<8)>>(w&7)&(1<<W.b)-1;h=(w-=U.b)>>3;var he=(r[h]|r[h+1]<<8)>>(w&7)&(1<<U.b)-1;h=(w-=F.b)>>3;var ce=(r[h]|r[h+1]<<8)>>(w&7)&(1<<F.b)-1;for(++A;--A;){var Ae=W.s[le],Ue=W.n[le],Me=F.s[ce],We=F.n[ce],ke=U.s[he],De=U.n[he];h=(w-=ke)>>3;var Be=1<<ke,L=Be+((r[h]|r[h+1]<<8|r[h+2]<<16|r[h+3]<<24)>>>(w&7)&Be-1);h=(w-=be[Me])>>3;var ee=ar[Me]+((r[h]|r[h+1]<<8|r[h+2]<<16)>>(w&7)&(1<<be[Me])-1);h=(w-=me[Ae])>>3;var ue=_r[Ae]+((r[h]|r[h+1]<<8|r[h+2]<<16)>>(w&7)&(1<<me[Ae])-1);if(h=(w-=Ue)>>3,le=W.t[le]+((r[h]|r[h+1]<<8)>>(w&7)&(1<<Ue)-1),h=(w-=We)>>3,ce=F.t[ce]+((r[h]|r[h+1]<<8)>>(w&7)&(1<<We)-1),h=(w-=De)>>3,he=U.t[he]+((r[h]|r[h+1]<<8)>>(w&7)&(1<<De)-1),L>3)e.o[2]=e.o[1],e.o[1]=e.o[0],e.o[0]=L-=3;else{var fe=L-(ue!=0);fe?(L=fe==3?e.o[0]-1:e.o[fe],fe>1&&(e.o[2]=e.o[1]),e.o[1]=e.o[0],e.o[0]=L):L=e.o[0]}for(var c=0;c<ue;++c)u[S+c]=u[m+c];S+=ue,m+=ue;var re=S-L;if(re<0){var te=-re,Sr=e.e+re;te>ee&&(te=ee);for(var c=0;c<te;++c)u[S+c]=e.w[Sr+c];S+=te,ee-=te,re=0}for(var c=0;c<ee;++c)u[S+c]=u[re+c];S+=ee}if(S!=m)for(;m<u.length;)u[S++]=u[m++];else S=u.length;u=ye(u,0,S)}else{var c;m&&(u=ye(u,m))}return e.b=l,u}p(2)}},Oe=function(r,e){if(r.length==1)return r[0];for(var t=new v(e),n=0,i=0;n<r.length;++n){var s=r[n];t.set(s,i),i+=s.length}return t},cr=(function(){function r(e){this.ondata=e,this.c=[],this.l=0,this.z=0}return r.prototype.push=function(e,t){if(typeof this.s=="number"){var n=Math.min(e.length,this.s);e=e.subarray(n),this.s-=n}var i=e.length,s=i+this.l;if(!this.s){if(t){if(!s){this.ondata(new v(0),!0);return}s<5&&p(5)}else if(s<18){this.c.push(e),this.l=s;return}if(this.l&&(this.c.push(e),e=Oe(this.c,s),this.c=[],this.l=0),typeof(this.s=tr(e))=="number")return this.push(e,t)}if(typeof this.s!="number"){if(s<(this.z||3)){t&&p(5),this.c.push(e),this.l=s;return}if(this.l&&(this.c.push(e),e=Oe(this.c,s),this.c=[],this.l=0),!this.z&&s<(this.z=e[this.s.b]&2?4:3+(e[this.s.b]>>3|e[this.s.b+1]<<5|e[this.s.b+2]<<13))){t&&p(5),this.c.push(e),this.l=s;return}else this.z=0;for(;;){var _=hr(e,this.s);if(_)this.ondata(_,!1),Ze(this.s.w,0,_.length),this.s.w.set(_,this.s.w.length-_.length);else{t&&p(5);var a=e.subarray(this.s.b);this.s.b=0,this.c.push(a),this.l+=a.length;return}if(this.s.l){var l=e.subarray(this.s.b);this.s=this.s.c*4,this.push(l,t);return}}}else t&&p(5)},r})();function ur(r){if(r.length===1)return r[0];const e=new Uint8Array(r.reduce((n,i)=>n+i.length,0));let t=0;for(const n of r)e.set(n,t),t+=n.length;return e}const fr=3,gr=1<<30,wr=64<<20,pr=2e3;async function vr(r,e){for(let t=0;t<fr;t++){const n=yr(r);if(!n)break;const i=new dr(Math.min(gr,Math.max(wr,r.length*pr)),e);try{await(n==="gzip"?mr(r,i):br(r,i))}catch(s){throw s instanceof k?s:new k("corrupt",`${e}: the ${n} data are damaged or cut off: ${s instanceof Error?s.message:String(s)}`)}r=ur(i.all),e=e.replace(/\\.(gz|zst)$/i,"")}return{bytes:r,name:e}}function yr(r){const e=(...t)=>t.every((n,i)=>r[i]===n);return e(31,139,8)?"gzip":e(40,181,47,253)?"zstd":void 0}async function mr(r,e){const n=new Blob([r]).stream().pipeThrough(new DecompressionStream("gzip")).getReader();for(;;){const{done:i,value:s}=await n.read();if(i)return;e.push(s)}}function br(r,e){let t=!1;const n=new cr((s,_)=>{e.push(s),t||=_===!0}),i=1<<20;for(let s=0;s<r.length;s+=i)n.push(r.subarray(s,s+i),s+i>=r.length);if(!t)throw new Error("they end too early")}class dr{constructor(e,t){this.most=e,this.name=t}all=[];#r=0;push(e){if(this.#r+=e.length,this.#r>this.most)throw new k("too-large",`${this.name}: grows past ${this.most} bytes, more than a mesh can`);this.all.push(e.slice())}}const de=8192,Ar=60,Mr=4;function zr(){return new Promise(r=>{const{port1:e,port2:t}=new MessageChannel;e.onmessage=()=>{e.close(),r()},t.postMessage(null)})}class Er{#r;#g;#e=new I;#t=[];#s;#l=!1;#n=!1;#w={by:"detail",value:1,limit:0};#a="surface";#i="download";#p=0;#v=!1;#y=-1;#h=0;#c=0;#u=0;#m=0;#o={vertices:0,triangles:0,steps:0,bytes:0};constructor(e,t){this.#r=e,this.#g=t}take(e){if(!this.#n)switch(e.type){case"bytes":this.#t.push(e.bytes),this.#b();break;case"end":this.#s=e.error?{error:e.error}:{},this.#b();break;case"file":this.#z(e.bytes,e.name);break;case"show":this.#w=e.wish,this.#a=e.colouring,this.#e.is_ready&&this.#f(()=>this.#_(e.ticket));break}}dispose(){this.#n=!0,this.#t=[],this.#e.free()}async#b(){if(!this.#l){for(this.#l=!0;this.#t.length>0&&!this.#n;){this.#i="decode";const e=this.#d();if(e){this.#t=[],this.#s={error:ve(e)};break}this.#e.is_ready&&performance.now()>=this.#m&&this.#f(()=>this.#_(0)),await zr()}this.#l=!1,this.#s&&!this.#n&&this.#A(this.#s.error)}}#d(){const e=performance.now();try{for(;performance.now()-e<this.#g;){const t=this.#t.shift();if(!t)break;this.#e.push(t.subarray(0,de)),t.length>de&&this.#t.unshift(t.subarray(de))}return}catch(t){return pe(t)}finally{this.#h+=performance.now()-e}}#A(e){let t=e;try{if(!t&&!this.#e.is_complete&&(t={code:"corrupt",message:"the stream ends before the mesh does",hint:"was the file copied whole?"}),(t?.code!=="corrupt"||!e)&&this.#M(),!this.#e.is_ready)throw new k("corrupt","the stream ends before there is anything to draw");this.#E(),this.#i="build",this.#_(0),this.#r({type:"building",share:0});const n=performance.now();this.#e.build(),this.#c=performance.now()-n,this.#i="done",this.#_(0)}catch(n){t??=ve(pe(n))}this.#s=void 0,this.#r(t?{type:"failed",error:t}:{type:"finished"})}#M(){const e=performance.now();try{this.#e.finish()}finally{this.#h+=performance.now()-e}}async#z(e,t){this.#i="build";const n=performance.now(),i={report:(a,l)=>this.#r({type:"building",share:l})};let s,_;try{s=await vr(e,t)}catch(a){_=a}this.#n||this.#f(()=>{if(!s)throw _;const a=I.from_file(s.bytes,s.name,i);this.#e.free(),this.#e=a,this.#c=performance.now()-n,this.#i="done",this.#_(0),this.#r({type:"finished"})})}#f(e){try{e()}catch(t){this.#n=!0,this.#r({type:"failed",error:ve(pe(t))})}}#E(){const e=this.#e;this.#o={vertices:e.full_vertex_count,triangles:e.full_triangle_count,steps:e.step_count,bytes:e.stream_bytes}}#_(e){const t=performance.now(),n=this.#x(),i=this.#F(),s=this.#S(),_=this.#T(),a=this.#e,[l,f]=[a.indices(),a.group_counts()];this.#u=performance.now()-t,this.#m=performance.now()+Math.max(Ar,Mr*this.#u);const g={type:"update",state:this.#O(),vertices:s,smoothNormals:_,indices:l,groupCounts:f,numbers:i,settled:n,ticket:e};this.#r(g)}#x(){const{by:e,value:t,limit:n,camera:i}=this.#w,s=this.#e;if(e==="view"&&s.is_built&&i){const a=new ne(Float64Array.from(i),t,n);try{return s.show_view(a)}finally{a.free()}}e==="triangles"?s.show_triangles(t):e==="error"?s.show_error(t):s.show_detail(e==="detail"?t:1);const _=s.group_counts().reduce((a,l)=>a+l,0);return n>0&&_>n&&s.show_triangles(n),!0}#F(){if(this.#a==="strips")return this.#e.color_strips();if(this.#a==="fans")return this.#e.color_fans();if(this.#a==="surface")return;const e=this.#e.group_counts().reduce((t,n)=>t+n,0);return Uint32Array.from({length:e},(t,n)=>n)}#S(){const e=this.#p;if(this.#e.vertex_count===e)return;const t=this.#e.vertices(e);try{const n=t.take_normals();return this.#v=n!==void 0,this.#p=this.#e.vertex_count,{first:e,positions:t.take_positions(),normals:n,colors:t.take_colors(),uvs:t.take_uvs()}}finally{t.free()}}#T(){if(!(this.#v||this.#y===this.#e.vertex_count))return this.#y=this.#e.vertex_count,this.#e.smooth_normals()}#O(){const e=this.#e;return{kind:e.kind,phase:this.#i,complete:e.is_complete,built:e.is_built,vertexCount:e.vertex_count,triangleCount:e.triangle_count,fullVertexCount:this.#o.vertices||e.full_vertex_count,fullTriangleCount:this.#o.triangles||e.full_triangle_count,stepCount:this.#o.steps||e.step_count,streamBytes:this.#o.bytes||e.stream_bytes,bounds:e.bounds(),diagonal:e.diagonal,shownSplitCount:e.shown_split_count,shownError:e.shown_error,decodeMs:this.#h,buildMs:this.#c,updateMs:this.#u}}}function xr(r){if(r.type!=="update")return[];const{vertices:e,indices:t,groupCounts:n,numbers:i,smoothNormals:s}=r,_=[t,n,i,s];return e&&_.push(e.positions,e.normals,e.colors,e.uvs),_.flatMap(a=>a?[a.buffer]:[])}const Fr=30,Re=self;let Ce;Re.onmessage=({data:r})=>{r instanceof WebAssembly.Module?(Ge({module:r}),Ce=new Er(e=>Re.postMessage(e,xr(e)),Fr)):Ce?.take(r)}})();\n', x = typeof self < "u" && self.Blob && new Blob([T], { type: "text/javascript;charset=utf-8" });
function oe(s) {
  let e;
  try {
    if (e = x && (self.URL || self.webkitURL).createObjectURL(x), !e) throw "";
    const t = new Worker(e, {
      name: s?.name
    });
    return t.addEventListener("error", () => {
      (self.URL || self.webkitURL).revokeObjectURL(e);
    }), t;
  } catch {
    return new Worker(
      "data:text/javascript;charset=utf-8," + encodeURIComponent(T),
      {
        name: s?.name
      }
    );
  } finally {
    e && (self.URL || self.webkitURL).revokeObjectURL(e);
  }
}
const ae = 6;
function he(s, e, t) {
  return e && le(s, t) || ue(s, t);
}
function le(s, e) {
  let t;
  try {
    t = new oe(), t.postMessage(s);
  } catch {
    return;
  }
  return t.onmessage = ({ data: r }) => e(r), t.onerror = (r) => {
    r.preventDefault();
    const i = r.message || "the worker could not start", n = new E("unsupported", `the worker failed: ${i}`, "try the option worker: false");
    e({ type: "failed", error: R(n) });
  }, {
    // Bytes are copied: a piece may be a part of a buffer that others still read.
    order: (r) => t.postMessage(r),
    dispose: () => t.terminate()
  };
}
function ue(s, e) {
  z(s);
  let t = !1;
  const r = (n) => queueMicrotask(() => void (t || n())), i = new D((n) => r(() => e(n)), ae);
  return {
    order: (n) => r(() => i.take(n)),
    dispose: () => {
      t = !0, i.dispose();
    }
  };
}
const ce = 1024;
class _e extends U {
  /** Smallest and largest coordinates. */
  bounds = [];
  #e = 0;
  #t = !1;
  computeBoundingBox() {
    const [e, t] = [0, 3].map((r) => new c().fromArray(this.bounds.length === 6 ? Array.from(this.bounds) : new Array(6).fill(0), r));
    this.boundingBox = new q(e, t);
  }
  computeBoundingSphere() {
    this.computeBoundingBox(), this.boundingSphere = this.boundingBox.getBoundingSphere(new Q());
  }
  /** Takes what an update brings. */
  take({ state: e, vertices: t, smoothNormals: r, indices: i, groupCounts: n }, o) {
    if (this.bounds = e.bounds, this.#i(e.vertexCount, e.fullVertexCount), t) {
      const { first: a, positions: h, normals: l, colors: u, uvs: _ } = t;
      this.#r("position", h, 3, a), l && this.#r("normal", l, 3, a), u && this.#r("color", u, 4, a), _ && this.#r("uv", _, 2, a);
    }
    if (r && this.#r("normal", r, 3, 0), this.#s(i, 3 * e.fullTriangleCount), this.clearGroups(), o) {
      let a = 0;
      n.forEach((h, l) => {
        this.addGroup(a, 3 * h, l), a += 3 * h;
      });
    }
    this.computeBoundingSphere(), this.#t = !1;
  }
  #i(e, t) {
    e <= this.#e || (this.#e = M(this.#e, e, t), this.#t = !0, this.dispose());
  }
  /** Writes numbers of vertices from one on. */
  #r(e, t, r, i) {
    let n = this.getAttribute(e);
    if (!n || this.#t && n.count !== this.#e) {
      const o = t instanceof Uint8Array ? new Uint8Array(this.#e * r) : new Float32Array(this.#e * r);
      n && o.set(n.array.subarray(0, i * r)), n = new p(o, r, t instanceof Uint8Array), this.setAttribute(e, n);
    } else
      n.addUpdateRange(i * r, t.length);
    n.array.set(t, i * r), n.needsUpdate = !0;
  }
  #s(e, t) {
    let r = this.index;
    if (!r || r.count < e.length) {
      r && this.dispose();
      const i = new Uint32Array(M(r?.count ?? 0, e.length, t));
      r = new p(i, 1), this.setIndex(r);
    } else
      r.addUpdateRange(0, e.length);
    r.array.set(e), r.needsUpdate = !0, this.setDrawRange(0, e.length);
  }
}
function M(s, e, t) {
  const r = Math.max(ce, 2 * s, e);
  return t >= e ? Math.min(r, t) : r;
}
const b = 1024, fe = 2654435761, ge = pe();
function de(s, e, t) {
  const r = { positions: new Float32Array(3 * e.length), colors: new Uint8Array(4 * e.length) };
  for (let n = 0; n < e.length; n++) {
    const o = 3 * e[n], a = 3 * (Math.imul(t[n / 3 | 0], fe) >>> 22);
    for (let h = 0; h < 3; h++)
      r.positions[3 * n + h] = s[o + h], r.colors[4 * n + h] = ge[a + h];
    r.colors[4 * n + 3] = 255;
  }
  const i = new U();
  return i.setAttribute("position", new p(r.positions, 3)), i.setAttribute("color", new p(r.colors, 4, !0)), i;
}
function pe() {
  const s = new Uint8Array(3 * b), e = new J();
  for (let t = 0; t < b; t++)
    e.setHSL(t / b, 0.62, 0.5 + 0.1 * (t % 3), K), [e.r, e.g, e.b].forEach((r, i) => s[3 * t + i] = Math.round(255 * r));
  return s;
}
const f = new X(), [k, S, A, m] = [new c(), new c(), new c(), new c()];
function we(s, e, t, r) {
  if (!(t >= 1 && r >= 1)) return;
  m.setFromMatrixScale(s.matrixWorld);
  const [i, n] = [Math.min(...m.toArray()), Math.max(...m.toArray())];
  if (!(i > 0)) return;
  if (e.isOrthographicCamera) {
    const { top: _, bottom: O, zoom: W } = e;
    return { kind: "orthographic", unitsPerPixel: Math.abs(_ - O) / (W * r * n) };
  }
  if (!e.isPerspectiveCamera) return;
  f.copy(s.matrixWorld).invert(), k.setFromMatrixPosition(e.matrixWorld).applyMatrix4(f), S.set(0, 0, -1).applyMatrix4(e.matrixWorld).applyMatrix4(f), A.setFromMatrixColumn(e.matrixWorld, 1).transformDirection(f);
  const o = e.projectionMatrix.elements, a = [(1 + Math.abs(o[8])) / o[0], (1 + Math.abs(o[9])) / o[5]], h = r * o[5] * a[1], l = [Math.max(1, Math.round(h * a[0] / a[1])), Math.max(1, Math.round(h))], u = [...k.toArray(), ...S.toArray(), ...A.toArray(), a[1], ...l];
  if (u.every(Number.isFinite))
    return { kind: "perspective", numbers: u, stretch: n / i };
}
const g = new Y();
class be extends Z {
  isStriataMesh = !0;
  finished;
  state;
  #e;
  #t;
  /** Made here, and freed here. */
  #i;
  #r;
  #s;
  #f;
  #h = 1;
  #n = null;
  #a = null;
  #o = null;
  #d = !1;
  #l = "surface";
  #g = !1;
  /** The request that has not been answered yet, and whether another has to follow it. */
  #p = 0;
  #u = !1;
  #c = !1;
  #_ = { by: "detail", value: 1, limit: 0 };
  /** The last camera, as a wish; for views a wish is made when the mesh is drawn. */
  #w;
  #M = !0;
  #b = !1;
  #k;
  #v;
  constructor(e, t, r) {
    const i = new _e(), n = t ? void 0 : ye(e);
    super(i, t ?? n), this.#t = i, this.#r = this.material, this.#i = n, this.#e = r, this.state = e.state, this.#f = e, this.finished = new Promise((o, a) => {
      this.#k = o, this.#v = a;
    }), this.finished.catch(() => {
    }), this.onBeforeRender = (o, a, h) => this.#C(o, a, h), this.update(e);
  }
  get detail() {
    return this.#h ?? (this.stepCount > 0 ? this.splitCount / this.stepCount : 1);
  }
  set detail(e) {
    this.#h = Math.min(1, Math.max(0, d(e, "detail"))), [this.#n, this.#a, this.#o] = [null, null, null], this.#m();
  }
  get triangleBudget() {
    return this.#n;
  }
  set triangleBudget(e) {
    this.#n = e === null ? null : Math.max(1, Math.floor(d(e, "triangleBudget"))), this.#x(), this.#m();
  }
  get error() {
    return this.state.shownError;
  }
  get maxError() {
    return this.#a;
  }
  set maxError(e) {
    this.#a = e === null ? null : Math.max(0, d(e, "maxError")), e !== null && (this.#o = null), this.#x(), this.#m();
  }
  get pixelError() {
    return this.#o;
  }
  set pixelError(e) {
    this.#o = e === null ? null : Math.max(0, d(e, "pixelError")), e !== null && (this.#a = null), this.#x(), this.#m(), this.dispatchStriata({ type: "change" });
  }
  get frozen() {
    return this.#d;
  }
  set frozen(e) {
    this.#d = e, this.dispatchStriata({ type: "change" });
  }
  get colouring() {
    return this.#l;
  }
  set colouring(e) {
    e !== this.#l && (this.#l === "surface" && (this.#r = this.material), this.#l = e, this.#c = !0, this.#y());
  }
  get wireframe() {
    return this.#g;
  }
  set wireframe(e) {
    this.#g = e;
    for (const t of [this.material].flat()) y(t, e);
    this.dispatchStriata({ type: "change" });
  }
  get triangleCount() {
    return this.#f.indices.length / 3;
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
  dispose() {
    this.#b || (this.#b = !0, this.#e.dispose(), this.#t.dispose(), this.geometry !== this.#t && this.geometry.dispose(), this.#i?.dispose(), this.#s?.dispose(), this.#v(new E("aborted", "the mesh was disposed of")));
  }
  /** Takes another level; called by the loader. */
  update(e) {
    this.#b || (this.state = e.state, this.#f = e, this.#t.take(e, Array.isArray(this.#r)), this.#S(e), e.ticket === this.#p && (this.#u = !1, this.#M = e.settled), this.#c && this.#y(), this.dispatchStriata({ type: "change" }));
  }
  /** Nothing more comes; called by the loader. */
  end(e) {
    if (!e) {
      this.#k();
      return;
    }
    this.#v(e), this.dispatchStriata({ type: "error", error: e });
  }
  /** Shows the surface, or triangles in the colours of what draws them. */
  #S({ numbers: e, indices: t }) {
    const r = this.geometry;
    if (e && this.#l !== "surface")
      this.#s ??= new F({ vertexColors: !0, flatShading: !0, side: B, roughness: 0.9 }), y(this.#s, this.#g), this.geometry = de(this.#t.getAttribute("position").array, t, e), this.geometry.boundingSphere = this.#t.boundingSphere, this.geometry.boundingBox = this.#t.boundingBox, this.material = this.#s;
    else if (this.geometry !== this.#t && this.#l === "surface") {
      this.geometry = this.#t, this.material = this.#r;
      for (const i of [this.material].flat()) y(i, this.#g);
    }
    r !== this.geometry && r !== this.#t && r.dispose();
  }
  #x() {
    const e = [this.#n, this.#a, this.#o];
    this.#h = e.every((t) => t === null) ? 1 : null;
  }
  /** Sends a wish, at once or when the last one is answered. */
  #m() {
    this.#c = !0, this.#y();
  }
  #y() {
    this.#u || this.#b || (this.#c = !1, this.#u = !0, this.#_ = this.#A(), this.#e.order({ type: "show", wish: this.#_, colouring: this.#l, ticket: ++this.#p }));
  }
  #A() {
    const e = this.#n ?? 0;
    return this.#o !== null ? this.#w ?? { by: "detail", value: e > 0 ? 1 : 0, limit: e } : this.#a !== null ? { by: "error", value: this.#a, limit: e } : this.#n !== null ? { by: "triangles", value: this.#n, limit: e } : { by: "detail", value: this.#h ?? 1, limit: 0 };
  }
  /** Follows the camera that the mesh is about to be drawn for. */
  #C(e, t, r) {
    if (this.#o === null || this.#d) return;
    const i = e.getRenderTarget();
    i ? g.set(i.width, i.height) : e.getDrawingBufferSize(g);
    const n = we(this, r, g.x, g.y);
    if (!n) return;
    const o = this.#n ?? 0;
    this.#w = n.kind === "perspective" ? { by: "view", value: this.#o / n.stretch, limit: o, camera: n.numbers } : { by: "error", value: this.#o * n.unitsPerPixel, limit: o }, !(!this.state.built && this.#_.by === this.#w.by) && (this.#M && me(this.#w, this.#_) || this.#y());
  }
  /** three's types know no events but their own. */
  dispatchStriata(e) {
    this.dispatchEvent(e);
  }
}
function d(s, e) {
  if (Number.isNaN(Number(s))) throw new TypeError(`${e} has to be a number, not ${String(s)}`);
  return Number(s);
}
function me(s, e) {
  const t = s.camera?.length === e.camera?.length && (s.camera ?? []).every((r, i) => r === e.camera?.[i]);
  return s.by === e.by && s.value === e.value && s.limit === e.limit && t;
}
function y(s, e) {
  "wireframe" in s && (s.wireframe = e);
}
function ye({ vertices: s }) {
  return new F({ vertexColors: s?.colors !== void 0, side: B, roughness: 0.8, metalness: 0 });
}
function ve(s = {}) {
  return {
    load: (e, t = {}) => new xe(s, t).run(e)
  };
}
const Se = function(s) {
  return ve(s);
};
class xe {
  #e;
  #t;
  #i = new AbortController();
  #r;
  #s;
  /** Whether the engine only sees the stream of a larger file. */
  #f = !1;
  #h = 0;
  #n = null;
  #a;
  #o;
  constructor(e, t) {
    this.#e = e, this.#t = t;
  }
  run(e) {
    const { signal: t } = this.#t;
    if (t?.aborted) return Promise.reject(w());
    const r = new Promise((n, o) => {
      this.#a = n, this.#o = o;
    }), i = () => this.#c(w());
    return t?.addEventListener("abort", i, { once: !0 }), this.#i.signal.addEventListener("abort", () => t?.removeEventListener("abort", i)), this.#d(e).catch((n) => this.#l(N(n))), r;
  }
  async #d(e) {
    const [t, r] = await Promise.all([
      $(this.#e.wasm),
      G(e, this.#t.name, this.#i.signal)
    ]);
    if (this.#i.signal.aborted) return;
    z(t), this.#n = r.length;
    const i = await re(r);
    if (this.#i.signal.aborted) return;
    this.#n = i.byteCount, this.#f = i.isInContainer, this.#r = he(t, this.#e.worker ?? !0, (o) => this.#g(o));
    const n = [];
    for await (const o of H(i.pieces)) {
      if (this.#i.signal.aborted) return;
      this.#h += o.length, i.isStream ? this.#r.order({ type: "bytes", bytes: o }) : n.push(o), this.#u();
    }
    this.#i.signal.aborted || (this.#n = this.#h, i.isStream ? this.#r.order({ type: "end" }) : this.#r.order({ type: "file", bytes: C(n), name: r.name }), this.#u());
  }
  /** The source failed: what has come of it may be something nevertheless. */
  #l(e) {
    this.#r && e.code !== "aborted" ? this.#r.order({ type: "end", error: R(e) }) : this.#c(e);
  }
  #g(e) {
    if (!this.#i.signal.aborted)
      switch (e.type) {
        case "update":
          this.#f && (e.state.kind = "striata"), this.#s ? this.#s.update(e) : (e.indices.length > 0 || e.state.complete) && (this.#s = new be(e, this.#t.material, this.#p()), this.#s.name = this.#t.name ?? "", this.#a(this.#s)), this.#u();
          break;
        case "building":
          this.#u("build");
          break;
        case "failed":
          this.#c(V(e.error));
          break;
        case "finished":
          this.#s?.end(), this.#u();
          break;
      }
  }
  /** What the mesh needs of us. */
  #p() {
    return {
      order: (e) => this.#r?.order(e),
      bytes: () => ({ received: this.#h, total: this.#n }),
      dispose: () => this.#_()
    };
  }
  #u(e) {
    const t = this.#s?.state, r = {
      bytesReceived: this.#h,
      bytesTotal: this.#n ?? (t?.streamBytes || null),
      triangleCount: t?.triangleCount ?? 0,
      vertexCount: t?.vertexCount ?? 0,
      complete: t?.complete ?? !1,
      phase: e ?? t?.phase ?? "download"
    };
    this.#t.onProgress?.(r), this.#s?.dispatchStriata({ type: "progress", progress: r });
  }
  /** Ends loading; a mesh that is there stays, with what it has. */
  #c(e) {
    if (!this.#i.signal.aborted) {
      if (this.#s && e.code !== "aborted") {
        this.#s.end(e);
        return;
      }
      this.#s?.end(e), this.#_(), this.#o(e);
    }
  }
  #_() {
    this.#i.abort(w()), this.#r?.dispose();
  }
}
export {
  E as StriataError,
  Se as StriataLoader,
  be as StriataMesh
};
