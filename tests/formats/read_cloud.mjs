// usage: node read_cloud.mjs FILE.ply|FILE.pcd
// What three.js' own loader makes of a cloud: number of points, sums of coordinates and colours, names of attributes.
// Ends with 77 where three is not there (`npm ci` in share/web).
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const file = process.argv[2];
const require = createRequire(new URL('../../share/web/', import.meta.url));
let loaders;
try {
  const of = (name) => import(require.resolve(`three/examples/jsm/loaders/${name}.js`));
  loaders = { ply: (await of('PLYLoader')).PLYLoader, pcd: (await of('PCDLoader')).PCDLoader };
} catch {
  process.exit(77);
}
const bytes = readFileSync(file);
const read = new loaders[file.slice(-3)]().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const geometry = read.geometry ?? read;
const sum = (name) => {
  const attribute = geometry.getAttribute(name);
  const sums = [0, 0, 0];
  for (let i = 0; attribute && i < attribute.count; ++i) {
    sums[0] += attribute.getX(i);
    sums[1] += attribute.getY(i);
    sums[2] += attribute.getZ(i);
  }
  return sums.map((value) => value.toFixed(3)).join(' ');
};
console.log(`points ${geometry.getAttribute('position').count}`);
console.log(`position ${sum('position')}`);
console.log(`normal ${sum('normal')}`);
console.log(`coloured ${geometry.getAttribute('color') !== undefined}`);
