// The viewer of the demo page: one vertex buffer, and levels made by following collapse targets.
"use strict";

const $ = (id) => document.getElementById(id);

function decode(id, Type) {
  const text = atob($(id).textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return new Type(bytes.buffer);
}

const mesh = {
  positions: decode("positions", Float32Array), // refinement order: a level uses the first so many
  targets: decode("targets", Uint32Array), // of the vertices from the base's vertex count on
  triangles: decode("triangles", Uint32Array), // of the full mesh
  errors: decode("errors", Float32Array), // of the level at each split count
};
const vertexCount = mesh.positions.length / 3;
const stepCount = mesh.targets.length;
const baseVertexCount = vertexCount - stepCount;

// ---- levels ---------------------------------------------------------------------------------

// The triangles after so many vertex splits: plain substitution, vertices that are not there
// become what they collapse to, and triangles that lose a corner vanish.
const shown = new Uint32Array(vertexCount);
const level = new Uint32Array(mesh.triangles.length);
function makeLevel(splitCount) {
  const present = baseVertexCount + splitCount;
  for (let v = 0; v < vertexCount; v++) {
    shown[v] = v < present ? v : shown[mesh.targets[v - baseVertexCount]];
  }
  let n = 0;
  for (let i = 0; i < mesh.triangles.length; i += 3) {
    const a = shown[mesh.triangles[i]], b = shown[mesh.triangles[i + 1]], c = shown[mesh.triangles[i + 2]];
    if (a !== b && b !== c && c !== a) {
      level[n] = a; level[n + 1] = b; level[n + 2] = c;
      n += 3;
    }
  }
  return level.subarray(0, n);
}

function edgesOf(indices) {
  const lines = new Uint32Array(indices.length * 2);
  for (let i = 0, n = 0; i < indices.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      lines[n++] = indices[i + k];
      lines[n++] = indices[i + (k + 1) % 3];
    }
  }
  return lines;
}

// Normals of the full mesh serve every level: vertices are never moved.
function normalsOf(positions, triangles) {
  const normals = new Float32Array(positions.length);
  const e = new Float64Array(6);
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
    for (let k = 0; k < 3; k++) {
      e[k] = positions[b + k] - positions[a + k];
      e[3 + k] = positions[c + k] - positions[a + k];
    }
    for (let k = 0; k < 3; k++) {
      const [p, q] = [(k + 1) % 3, (k + 2) % 3];
      const n = e[p] * e[3 + q] - e[q] * e[3 + p];
      normals[a + k] += n; normals[b + k] += n; normals[c + k] += n;
    }
  }
  return normals;
}

// ---- drawing --------------------------------------------------------------------------------

const canvas = $("canvas");
const gl = canvas.getContext("webgl2", { antialias: true });
if (!gl) $("no-webgl").hidden = false;

const VERTEX = `#version 300 es
in vec3 position; in vec3 normal;
uniform mat4 clipFromMesh; uniform mat3 viewFromMesh; uniform highp vec4 line;
out vec3 n; out vec3 p;
void main() {
  n = viewFromMesh * normal; p = viewFromMesh * position;
  gl_Position = clipFromMesh * vec4(position, 1.0);
  if (line.a > 0.0) gl_Position.z -= 0.004 * gl_Position.w; // edges win against their own triangles
}`;
const FRAGMENT = `#version 300 es
precision highp float;
in vec3 n; in vec3 p;
uniform bool flatShading; uniform highp vec4 line;
out vec4 colour;
void main() {
  if (line.a > 0.0) { colour = line; return; }
  vec3 m = flatShading ? normalize(cross(dFdx(p), dFdy(p))) : normalize(gl_FrontFacing ? n : -n);
  float key = max(dot(m, normalize(vec3(-0.52, 0.58, 0.63))), 0.0);
  float fill = max(dot(m, normalize(vec3(0.86, -0.10, 0.50))), 0.0);
  vec3 light = mix(vec3(0.05), vec3(0.15, 0.16, 0.19), 0.5 + 0.5 * m.y)
    + key * vec3(1.05, 0.98, 0.88) + fill * vec3(0.16, 0.20, 0.27);
  colour = vec4(pow(vec3(0.72, 0.58, 0.44) * light, vec3(1.0 / 2.2)), 1.0);
}`;

let program, uniforms, indexBuffer, lineBuffer;
function setUp() {
  program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  uniforms = {};
  for (const name of ["clipFromMesh", "viewFromMesh", "flatShading", "line"]) {
    uniforms[name] = gl.getUniformLocation(program, name);
  }
  for (const [name, data] of [["position", mesh.positions], ["normal", normalsOf(mesh.positions, mesh.triangles)]]) {
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    const place = gl.getAttribLocation(program, name);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
  }
  indexBuffer = gl.createBuffer();
  lineBuffer = gl.createBuffer();
  gl.enable(gl.DEPTH_TEST);
}

const bounds = { min: [1e30, 1e30, 1e30], max: [-1e30, -1e30, -1e30] };
mesh.positions.forEach((x, i) => {
  bounds.min[i % 3] = Math.min(bounds.min[i % 3], x);
  bounds.max[i % 3] = Math.max(bounds.max[i % 3], x);
});
const centre = bounds.min.map((x, k) => (x + bounds.max[k]) / 2);
const radius = Math.hypot(...bounds.min.map((x, k) => bounds.max[k] - x)) / 2;
const camera = { yaw: -0.6, pitch: 0.05, distance: 3 };

// Column-major: orbit around the centre, then perspective.
function matrices() {
  const [cy, sy, cp, sp] = [Math.cos(camera.yaw), Math.sin(camera.yaw), Math.cos(camera.pitch), Math.sin(camera.pitch)];
  const right = [cy, 0, -sy], back = [sy * cp, sp, cy * cp];
  const up = [-sy * sp, cp, -cy * sp];
  const view = [right[0], up[0], back[0], right[1], up[1], back[1], right[2], up[2], back[2]];
  const shift = [right, up, back].map((axis) => -axis.reduce((sum, x, k) => sum + x * centre[k], 0));
  shift[2] -= camera.distance * radius;
  const f = 1 / Math.tan(0.33), aspect = canvas.width / canvas.height;
  // As close around the mesh as can be: depth has few bits.
  const [near, far] = [Math.max(camera.distance - 1.1, 0.02) * radius, (camera.distance + 1.1) * radius];
  const [a, b] = [(far + near) / (near - far), 2 * far * near / (near - far)];
  const clip = [];
  for (let k = 0; k < 4; k++) {
    const column = k < 3 ? view.slice(3 * k, 3 * k + 3) : shift;
    clip.push(f / aspect * column[0], f * column[1], a * column[2] + (k === 3 ? b : 0), -column[2]);
  }
  return { view, clip };
}

let indexCount = 0, queued = false;
function draw() {
  queued = false;
  const scale = Math.min(window.devicePixelRatio || 1, 2);
  const [width, height] = [Math.round(canvas.clientWidth * scale), Math.round(canvas.clientHeight * scale)];
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  const { view, clip } = matrices();
  gl.viewport(0, 0, width, height);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.uniformMatrix4fv(uniforms.clipFromMesh, false, clip);
  gl.uniformMatrix3fv(uniforms.viewFromMesh, false, view);
  gl.uniform1i(uniforms.flatShading, $("flat").checked ? 1 : 0);
  gl.uniform4f(uniforms.line, 0, 0, 0, 0);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indexBuffer);
  gl.drawElements(gl.TRIANGLES, indexCount, gl.UNSIGNED_INT, 0);
  if ($("edges").checked) {
    gl.uniform4f(uniforms.line, 0.1, 0.08, 0.06, 1);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, lineBuffer);
    gl.drawElements(gl.LINES, indexCount * 2, gl.UNSIGNED_INT, 0);
  }
}
function redraw() {
  if (gl && !queued) {
    queued = true;
    requestAnimationFrame(draw);
  }
}

// ---- controls -------------------------------------------------------------------------------

const count = (n) => n.toLocaleString("en");

function showLevel() {
  // The slider is logarithmic: each notch takes the same share of the vertices.
  const share = Number($("detail").value) / Number($("detail").max);
  const present = Math.round(baseVertexCount * (vertexCount / baseVertexCount) ** share);
  const splitCount = Math.min(Math.max(present - baseVertexCount, 0), stepCount);
  const started = performance.now();
  const indices = makeLevel(splitCount);
  const took = performance.now() - started;
  indexCount = indices.length;
  if (gl) {
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indexBuffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.DYNAMIC_DRAW);
    if ($("edges").checked) {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, lineBuffer);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, edgesOf(indices), gl.DYNAMIC_DRAW);
    }
  }
  const error = splitCount === stepCount ? 0 : mesh.errors[splitCount];
  $("triangles-now").textContent = count(indices.length / 3);
  $("vertices-now").textContent = count(baseVertexCount + splitCount);
  $("error-now").textContent = (100 * error / (2 * radius)).toFixed(3) + " %";
  $("time-now").textContent = took.toFixed(1) + " ms";
  redraw();
}

function orbit() {
  const pointers = new Map();
  const spread = () => {
    const [p, q] = [...pointers.values()];
    return Math.hypot(p.x - q.x, p.y - q.y);
  };
  const zoom = (factor) => { camera.distance = Math.min(Math.max(camera.distance * factor, 0.6), 12); };
  canvas.addEventListener("pointerdown", (e) => {
    canvas.setPointerCapture(e.pointerId);
    pointers.set(e.pointerId, { x: e.clientX, y: e.clientY });
  });
  canvas.addEventListener("pointermove", (e) => {
    const last = pointers.get(e.pointerId);
    if (!last) return;
    const before = pointers.size === 2 ? spread() : 0;
    const [dx, dy] = [e.clientX - last.x, e.clientY - last.y];
    pointers.set(e.pointerId, { x: e.clientX, y: e.clientY });
    if (pointers.size === 2) {
      zoom(before / Math.max(spread(), 1));
    } else {
      camera.yaw -= dx * 0.008;
      camera.pitch = Math.min(Math.max(camera.pitch + dy * 0.008, -1.5), 1.5);
    }
    redraw();
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (e) => pointers.delete(e.pointerId));
  }
  canvas.addEventListener("wheel", (e) => {
    e.preventDefault();
    zoom(Math.exp(e.deltaY * 0.001));
    redraw();
  }, { passive: false });
}

// From full detail to the base and back, once.
let playing = 0;
function play() {
  if (playing) {
    cancelAnimationFrame(playing);
    playing = 0;
    $("play").textContent = "Play";
    return;
  }
  const started = performance.now();
  $("play").textContent = "Stop";
  const frame = (now) => {
    const turn = (now - started) / 6000;
    $("detail").value = String(Number($("detail").max) * Math.min(Math.abs(1 - 2 * turn), 1));
    showLevel();
    if (turn < 1) playing = requestAnimationFrame(frame);
    else play();
  };
  playing = requestAnimationFrame(frame);
}

if (gl) setUp();
orbit();
$("detail").addEventListener("input", showLevel);
$("edges").addEventListener("change", showLevel);
$("flat").addEventListener("change", redraw);
$("play").addEventListener("click", play);
$("theme").addEventListener("click", () => {
  const root = document.documentElement;
  const theme = root.dataset.theme ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
  root.dataset.theme = theme === "dark" ? "light" : "dark";
});
window.addEventListener("resize", redraw);
showLevel();
