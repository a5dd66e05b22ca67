// Geometry for the tests, independent of the library: distances to triangles, and pixels at a point.

/** Grid cells along the longest side of the bounds. */
const CELLS = 48;

/** Distance of each point to the nearest triangle. */
export function distancesTo(points, { positions, triangles }) {
  const grid = new Grid(positions, triangles);
  const distances = new Float64Array(points.length / 3);
  for (let point = 0; point < distances.length; point += 1) {
    distances[point] = grid.distance([points[3 * point], points[3 * point + 1], points[3 * point + 2]]);
  }
  return distances;
}

/** Number of pixels that one unit covers at a point, perpendicular to the view direction; `null` outside the picture. */
export function pixelsAt([x, y, z], { view, fov, aspect, height }) {
  const at = (row) => view[row] * x + view[row + 4] * y + view[row + 8] * z + view[row + 12];
  const depth = -at(2);
  const slope = Math.tan((fov * Math.PI) / 360);
  if (depth <= 0 || Math.abs(at(1)) > depth * slope || Math.abs(at(0)) > depth * slope * aspect) return null;
  return height / (2 * depth * slope);
}

class Grid {
  constructor(positions, triangles) {
    const corner = (index) => [positions[3 * index], positions[3 * index + 1], positions[3 * index + 2]];
    this.cells = new Map();
    this.low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const index of triangles) {
      corner(index).forEach((x, axis) => {
        this.low[axis] = Math.min(this.low[axis], x);
        high[axis] = Math.max(high[axis], x);
      });
    }
    this.size = Math.max(...high.map((x, axis) => x - this.low[axis])) / CELLS;
    this.high = this.cell(high);
    for (let first = 0; first < triangles.length; first += 3) {
      const corners = [corner(triangles[first]), corner(triangles[first + 1]), corner(triangles[first + 2])];
      this.add(corners);
    }
  }

  cell(point) {
    return point.map((x, axis) => Math.floor((x - this.low[axis]) / this.size));
  }

  add(corners) {
    const from = this.cell([0, 1, 2].map((axis) => Math.min(...corners.map((point) => point[axis]))));
    const to = this.cell([0, 1, 2].map((axis) => Math.max(...corners.map((point) => point[axis]))));
    forEachCell(from, to, (key) => {
      const list = this.cells.get(key);
      if (list) list.push(corners);
      else this.cells.set(key, [corners]);
    });
  }

  /** Searches rings of cells around the point until no nearer triangle is possible. */
  distance(point) {
    const center = this.cell(point);
    let nearest = Infinity;
    for (let ring = 0; ring <= 2 * CELLS; ring += 1) {
      forEachCell(center.map((x) => x - ring), center.map((x) => x + ring), (key, cell) => {
        if (Math.max(...cell.map((x, axis) => Math.abs(x - center[axis]))) < ring) return;
        for (const corners of this.cells.get(key) ?? []) nearest = Math.min(nearest, distanceToTriangle(point, corners));
      });
      if (nearest <= ring * this.size) return nearest;
    }
    return nearest;
  }
}

function forEachCell(from, to, visit) {
  for (let x = from[0]; x <= to[0]; x += 1) {
    for (let y = from[1]; y <= to[1]; y += 1) for (let z = from[2]; z <= to[2]; z += 1) visit(`${x} ${y} ${z}`, [x, y, z]);
  }
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

function distanceToTriangle(point, [a, b, c]) {
  const normal = cross(minus(b, a), minus(c, a));
  const area = dot(normal, normal);
  const isInside = area > 0 && [[a, b], [b, c], [c, a]].every(([from, to]) => dot(cross(minus(to, from), minus(point, from)), normal) >= 0);
  if (isInside) return Math.abs(dot(minus(point, a), normal)) / Math.sqrt(area);
  return Math.min(distanceToEdge(point, a, b), distanceToEdge(point, b, c), distanceToEdge(point, c, a));
}

function distanceToEdge(point, from, to) {
  const edge = minus(to, from);
  const length = dot(edge, edge);
  const t = length > 0 ? Math.min(Math.max(dot(minus(point, from), edge) / length, 0), 1) : 0;
  const off = minus(point, [from[0] + t * edge[0], from[1] + t * edge[1], from[2] + t * edge[2]]);
  return Math.sqrt(dot(off, off));
}
