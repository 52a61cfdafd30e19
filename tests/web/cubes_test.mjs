// The merged faces of voxels against the obvious way: every face of every voxel that has no neighbour there, its
// normal, and the light in its corners.
import assert from 'node:assert/strict';
import { cubes } from '../../share/web/src/cubes.js';

/** Numbers by chance, the same every time (mulberry32). */
function chance(seed) {
  let a = seed;
  return () => {
    a = (a + 0x6d2b79f5) | 0;
    let t = Math.imul(a ^ (a >>> 15), 1 | a);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const AXES = [[1, 2], [0, 2], [0, 1]];

/** Each unit face as text -> light of its corners in the order u0 v0, u1 v0, u1 v1, u0 v1. */
function slowly(indices) {
  const full = new Set();
  for (let i = 0; i < indices.length; i += 3) full.add([...indices.slice(i, i + 3)].join());
  const faces = new Map();
  for (const text of full) {
    const cell = text.split(',').map(Number);
    for (let direction = 0; direction < 6; ++direction) {
      const axis = direction >> 1;
      const front = [...cell];
      front[axis] += direction % 2 ? 1 : -1;
      if (full.has(front.join())) continue;
      const [u, v] = AXES[axis];
      const beside = (du, dv) => {
        const at = [...front];
        at[u] += du;
        at[v] += dv;
        return full.has(at.join()) ? 1 : 0;
      };
      const light = (du, dv) => (beside(du, 0) && beside(0, dv) ? 0 : 3 - beside(du, 0) - beside(0, dv) - beside(du, dv));
      faces.set([...cell, direction].join(), [light(-1, -1), light(1, -1), light(1, 1), light(-1, 1)].join());
    }
  }
  return faces;
}

function merged(indices) {
  const { low, corners, triangles } = cubes(indices);
  const faces = new Map();
  const corner = (k) => [0, 1, 2].map((a) => corners[4 * k + a] + low[a]);
  const minus = (p, q) => p.map((x, a) => x - q[a]);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [...triangles.slice(t, t + 3)].map(corner);
    const [p, q] = [minus(b, a), minus(c, a)];
    const normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    const direction = corners[4 * triangles[t] + 3] >> 2;
    assert.ok(normal[direction >> 1] * (direction % 2 ? 1 : -1) > 0, 'each triangle is seen from outside');
  }
  for (let k = 0; k < corners.length / 4; k += 4) {
    const direction = corners[4 * k + 3] >> 2;
    const axis = direction >> 1;
    const [u, v] = AXES[axis];
    const [from, to] = [corner(k), corner(k + 2)];
    const light = [0, 1, 2, 3].map((i) => corners[4 * (k + i) + 3] & 3).join();
    for (let x = from[u]; x < to[u]; ++x) {
      for (let y = from[v]; y < to[v]; ++y) {
        const cell = [...from];
        cell[axis] -= direction % 2;
        [cell[u], cell[v]] = [x, y];
        const name = [...cell, direction].join();
        assert.ok(!faces.has(name), 'no face twice');
        faces.set(name, light);
      }
    }
  }
  return faces;
}

const sorted = (faces) => [...faces].sort(([a], [b]) => (a < b ? -1 : 1));

for (let trial = 0; trial < 60; ++trial) {
  const next = chance(trial);
  const side = 2 + Math.floor(8 * next());
  const count = Math.floor(next() * side ** 3);
  const shift = [0, 1, 2].map(() => Math.floor(200 * (next() - 0.5)));
  const indices = Int16Array.from({ length: 3 * count }, (_, i) => Math.floor(next() * side) + shift[i % 3]);
  assert.deepEqual(sorted(merged(indices)), sorted(slowly(indices)), `trial ${trial}`);
}

const wall = [];
for (let x = 0; x < 100; ++x) for (let z = 0; z < 40; ++z) wall.push(x, 7, z);
assert.equal(cubes(wall).triangles.length / 6, 6, 'a wall is six rectangles');
assert.equal(cubes([]).triangles.length, 0);
assert.equal(cubes([0, 0, 0, 0, 0, 0, 32000, -32000, 5]).triangles.length / 6, 6, 'what lies a mile away is left out');
console.log('the cubes are right');
