// Where things are said to be: in the world, as the command line and report.json have it, if a run tells how its map lies
// there; else in its map. Events and the scene are in the map frame throughout.
import { degrees, fixed } from './dom.js';

/** v turned by the quaternion x, y, z, w. */
function turned([x, y, z], [qx, qy, qz, qw]) {
  const [tx, ty, tz] = [2 * (qy * z - qz * y), 2 * (qz * x - qx * z), 2 * (qx * y - qy * x)];
  return [x + qw * tx + qy * tz - qz * ty, y + qw * ty + qz * tx - qx * tz, z + qw * tz + qx * ty - qy * tx];
}

export class Where {
  /** T_world_map as x y z and the quaternion x y z w, if it is known. */
  constructor(T_world_map) {
    const [x, y, z, ...turn] = T_world_map ?? [0, 0, 0, 0, 0, 0, 1];
    this.frame = T_world_map ? 'world' : 'map frame';
    this.offset = [x, y, z];
    this.turn = turn;
    this.column = `x, y (${this.frame}) [m]`;
  }

  point([x, y, z = 0]) { return turned([x, y, z], this.turn).map((value, k) => value + this.offset[k]); }
  /** "1.20, 3.40" */
  place(p) { return this.point(p).slice(0, 2).map((value) => fixed(value, 2)).join(', '); }
  /** "1.20, 3.40 m (world)" */
  sentence(p) { return `${this.place(p)} m (${this.frame})`; }
  heading(yaw) {
    const [x, y] = turned([Math.cos(yaw), Math.sin(yaw), 0], this.turn);
    return degrees(Math.atan2(y, x));
  }
}
