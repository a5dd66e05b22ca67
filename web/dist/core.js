import { s as r, w as s } from "./wasm.js";
import { E as n, F as c, M as l, S as m, a as w, V as E, b as S, c as f } from "./wasm.js";
async function i(a) {
  r(await s(a));
}
export {
  n as Engine,
  c as Failure,
  l as Model,
  m as StreamPlace,
  w as StriataError,
  E as Vertices,
  S as View,
  f as asStriataError,
  i as initialise
};
