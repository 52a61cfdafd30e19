// All events of a run by kind, each kind in the order of time; any instant of the run can be asked for.

/** Index of the last element with t <= time, or -1. */
export function lastBefore(events, time) {
  let low = 0;
  let high = events.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (events[middle].t <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export class Store {
  constructor() {
    this.kinds = new Map();
    this.end = 0;
    this.voxels = new VoxelLog();
    this.count = 0;
    this.merged = false;
  }

  add(event) {
    ++this.count;
    if (event.e === 'voxels') {
      this.voxels.add(event);
      this.merged ||= event.merged === true; // a long report holds the map of the end alone
    }
    const list = this.all(event.e);
    list.push(event);
    if (event.t > this.end) this.end = event.t;
  }

  all(kind) {
    let list = this.kinds.get(kind);
    if (!list) this.kinds.set(kind, (list = []));
    return list;
  }
  first(kind) { return this.all(kind)[0]; }
  latest(kind, time) { return this.all(kind)[lastBefore(this.all(kind), time)]; }
  until(kind, time) { return this.all(kind).slice(0, lastBefore(this.all(kind), time) + 1); }

  /** Pose of the base and the head, between two events where there are two. */
  poseAt(time) {
    const poses = this.all('pose');
    const i = lastBefore(poses, time);
    if (i < 0) return poses[0];
    const a = poses[i];
    const b = poses[i + 1];
    if (!b || b.t - a.t > 2) return a;
    const part = (time - a.t) / (b.t - a.t);
    const between = (x, y) => x + part * (y - x);
    const turn = (x, y) => x + part * Math.atan2(Math.sin(y - x), Math.cos(y - x));
    const pose = (p, q) => [between(p[0], q[0]), between(p[1], q[1]), turn(p[2], q[2])];
    return { t: time, p: pose(a.p, b.p), true: pose(a.true, b.true), head: a.head.map((h, k) => between(h, b.head[k])) };
  }

  /** What moves or was moved, where it is at that time: the newest pose of each name that is not gone. */
  bodiesAt(time) {
    const bodies = new Map();
    for (const event of this.until('bodies', time)) {
      for (const body of event.list) bodies.set(body.name, { ...body, t: event.t });
      for (const name of event.gone) bodies.delete(name);
    }
    return [...bodies.values()];
  }

  /** Where each object stood with the referee, and the examination that found it. */
  examinationOf(object) {
    if (!object.found) return undefined;
    return this.latest('examined', object.found_at + 1e-3);
  }
}

export function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

export const FREE = 1;
export const OCCUPIED = 2;

/** What each cell of a floor plan is, row by row from the south-west. */
export function cellsOf(floor) {
  const packed = bytesOf(floor.cells);
  return Uint8Array.from({ length: floor.width * floor.height }, (_, i) => (packed[i >> 2] >> (2 * (i & 3))) & 3);
}

/** Triplets of voxel indices. */
export function voxelsOf(base64) {
  return new Int16Array(bytesOf(base64).buffer);
}

/** When each voxel of the robot's map was occupied. */
class VoxelLog {
  constructor() {
    this.entries = []; // x, y, z, from, until
    this.open = new Map();
    this.changes = 0;
  }
  static key(x, y, z) { return ((x + 32768) * 65536 + (y + 32768)) * 65536 + (z + 32768); }

  add(event) {
    ++this.changes;
    const on = voxelsOf(event.on);
    for (let i = 0; i < on.length; i += 3) {
      const entry = [on[i], on[i + 1], on[i + 2], event.t, Infinity];
      this.open.set(VoxelLog.key(entry[0], entry[1], entry[2]), entry);
      this.entries.push(entry);
    }
    const off = voxelsOf(event.off);
    for (let i = 0; i < off.length; i += 3) {
      const key = VoxelLog.key(off[i], off[i + 1], off[i + 2]);
      const entry = this.open.get(key);
      if (entry) entry[4] = event.t;
      this.open.delete(key);
    }
  }
  at(time) {
    const triplets = [];
    for (const [x, y, z, from, until] of this.entries) {
      if (from <= time && time < until) triplets.push(x, y, z);
    }
    return triplets;
  }
}
