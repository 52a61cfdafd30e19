// Voxels -> the faces of their cubes that can be seen, neighbours in one plane merged into rectangles, each corner with
// how much of the sky is hidden from it. A flat of a hundred thousand voxels becomes some tens of thousands of
// rectangles, which a graphics card draws in a millisecond and a processor in some tens.

/** Axis of the normal, and the two axes of the plane; right: u x v looks along +w. */
const PLANES = [
  { w: 0, u: 1, v: 2, right: true },
  { w: 1, u: 0, v: 2, right: false },
  { w: 2, u: 0, v: 1, right: true },
];
const MOST = [1024, 1024, 256]; // cells along each axis; what lies farther away is left out

/** Smallest and largest index; around the middle one where that is too far apart. */
function extent(indices) {
  const low = [0, 0, 0];
  const high = [-1, -1, -1];
  for (let i = 0; i < indices.length; ++i) {
    if (i < 3) low[i] = high[i] = indices[i];
    low[i % 3] = Math.min(low[i % 3], indices[i]);
    high[i % 3] = Math.max(high[i % 3], indices[i]);
  }
  for (const k of [0, 1, 2]) {
    if (high[k] - low[k] < MOST[k]) continue;
    const sorted = indices.filter((_, i) => i % 3 === k).sort((a, b) => a - b);
    low[k] = sorted[sorted.length >> 1] - MOST[k] / 2;
    high[k] = low[k] + MOST[k] - 1;
  }
  return [low, high];
}

/** Cells of a box with a rim of empty cells, one bit each. */
class Grid {
  constructor(indices) {
    const [low, high] = extent(indices);
    this.low = low;
    this.size = low.map((l, k) => high[k] - l + 3);
    this.stride = [1, this.size[0], this.size[0] * this.size[1]];
    this.bits = new Uint32Array(Math.ceil((this.stride[2] * this.size[2]) / 32));
    const cells = new Uint32Array(indices.length / 3);
    let count = 0;
    for (let i = 0; i < indices.length; i += 3) {
      const [x, y, z] = [indices[i] - low[0] + 1, indices[i + 1] - low[1] + 1, indices[i + 2] - low[2] + 1];
      if ([x, y, z].some((at, k) => at < 1 || at > this.size[k] - 2)) continue;
      const cell = x + y * this.stride[1] + z * this.stride[2];
      if (this.has(cell)) continue;
      this.bits[cell >>> 5] |= 1 << (cell & 31);
      cells[count++] = cell;
    }
    this.cells = cells.subarray(0, count);
  }

  has(cell) { return (this.bits[cell >>> 5] >>> (cell & 31)) & 1; }

  /** All cells in the order of w, then v, then u, as one number each. */
  ordered({ w, u, v }) {
    const { size, stride } = this;
    const keys = this.cells.map((cell) => {
      const at = [cell % size[0], Math.floor(cell / stride[1]) % size[1], Math.floor(cell / stride[2])];
      return (at[w] * size[v] + at[v]) * size[u] + at[u];
    });
    return keys.sort();
  }
}

/** Light in the corner of a face [0: dark to 3]: of two sides and what lies between them. */
const light = (a, b, between) => (a && b ? 0 : 3 - a - b - between);

/** Light of the four corners (u0 v0, u1 v0, u1 v1, u0 v1), two bits each, of a face before the free cell `front`. */
function lights(grid, front, su, sv) {
  const [left, right, below, above] = [grid.has(front - su), grid.has(front + su), grid.has(front - sv), grid.has(front + sv)];
  return light(left, below, grid.has(front - su - sv)) | (light(right, below, grid.has(front + su - sv)) << 2)
    | (light(right, above, grid.has(front + su + sv)) << 4) | (light(left, above, grid.has(front - su + sv)) << 6);
}
const alikeAlongU = (code) => (code & 3) === ((code >> 2) & 3) && ((code >> 4) & 3) === (code >> 6);
const alikeAlongV = (code) => (code & 3) === (code >> 6) && ((code >> 2) & 3) === ((code >> 4) & 3);

/** Rectangles {w, u0, u1, v0, v1, code} of the faces that look along one direction. */
function rectangles(grid, plane, keys, sign) {
  const [nu, nv] = [grid.size[plane.u], grid.size[plane.v]];
  const [su, sv, sw] = [grid.stride[plane.u], grid.stride[plane.v], grid.stride[plane.w]];
  const done = [];
  const last = new Array(nu).fill(undefined); // the newest rectangle that begins at this u
  let run;
  const close = () => {
    const before = run && last[run.u0];
    const grows = before && before.w === run.w && before.v1 === run.v0 && before.u1 === run.u1 && before.code === run.code;
    if (grows && alikeAlongV(run.code)) ++before.v1;
    else if (run) done.push((last[run.u0] = run));
  };
  for (const key of keys) {
    const u = key % nu;
    const row = Math.floor(key / nu);
    const v = row % nv;
    const w = Math.floor(row / nv);
    const front = w * sw + v * sv + u * su + sign * sw;
    if (grid.has(front)) continue;
    const code = lights(grid, front, su, sv);
    if (run && run.w === w && run.v0 === v && run.u1 === u && run.code === code && alikeAlongU(code)) {
      ++run.u1;
    } else {
      close();
      run = { w, u0: u, u1: u + 1, v0: v, v1: v + 1, code };
    }
  }
  close();
  return done;
}

/** Two triangles; the diagonal joins the brighter corners, so that a dark corner stays a corner. */
function diagonal(code, outwards) {
  const bright = (code & 3) + ((code >> 4) & 3) > ((code >> 2) & 3) + (code >> 6);
  const corners = bright ? [0, 1, 2, 0, 2, 3] : [1, 2, 3, 1, 3, 0];
  return outwards ? corners : corners.reverse();
}

/**
 * Triplets of indices -> { low: smallest index, corners: x, y, z from low and a code for each corner (light, and four
 * times the number of the direction: -x, +x, -y, +y, -z, +z), triangles: three corners each }.
 */
export function cubes(indices) {
  const grid = new Grid(indices);
  const sides = PLANES.flatMap((plane) => {
    const keys = grid.ordered(plane);
    return [-1, 1].map((sign) => ({ plane, sign, list: rectangles(grid, plane, keys, sign) }));
  });
  const count = sides.reduce((sum, side) => sum + side.list.length, 0);
  const corners = new Int16Array(16 * count);
  const triangles = new Uint32Array(6 * count);
  let [c, t] = [0, 0];
  for (const { plane, sign, list } of sides) {
    const direction = 2 * plane.w + (sign > 0 ? 1 : 0);
    for (const { w, u0, u1, v0, v1, code } of list) {
      for (const k of diagonal(code, plane.right === sign > 0)) triangles[t++] = c / 4 + k;
      for (const [k, u, v] of [[0, u0, v0], [1, u1, v0], [2, u1, v1], [3, u0, v1]]) {
        corners[c + plane.w] = w - 1 + (sign > 0 ? 1 : 0);
        corners[c + plane.u] = u - 1;
        corners[c + plane.v] = v - 1;
        corners[c + 3] = 4 * direction + ((code >> (2 * k)) & 3);
        c += 4;
      }
    }
  }
  return { low: grid.low, corners, triangles };
}
