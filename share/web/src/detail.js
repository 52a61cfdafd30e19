// What was chosen: its picture, its numbers, and why it got its verdict.
import { badge, fixed, make, metres, percent, seconds } from './dom.js';
import { REGION, objectLook } from './look.js';

function sheet(title, look, why, rows, picture) {
  const list = make('dl', {}, ...rows.flatMap(([term, value]) => [make('dt', {}, term), make('dd', {}, value)]));
  const head = make('h2', {}, badge(look), ' ', title);
  return [head, make('p', { class: 'verdict' }, why), picture, list].filter(Boolean);
}

function pictureOf(examined, source, words) {
  if (!examined) return undefined;
  const image = make('img', { alt: words, class: 'taken' });
  source.picture(examined.picture).then((address) => {
    if (address) image.src = address;
    else image.remove();
  });
  return make('figure', {}, image, make('figcaption', {}, words));
}

function whyObject(object, limits, over) {
  const cover = `holds ${percent(object.cover)} of its pixels (${percent(limits.min_cover)} are needed) and is to ${percent(object.purity)} this object (${percent(limits.min_purity)})`;
  const near = `its middle lies ${metres(object.error, 3)} from the true one (at most ${metres(limits.max_error_m)})`;
  if (object.found) return `Found: a segment ${cover}, and ${near}.`;
  const verdict = over ? 'Not found' : 'Not found yet';
  if (object.covered) return `${verdict}: a segment ${cover}, but ${near}.`;
  if (object.cover > 0) return `${verdict}: the segment that shows most of it ${cover}.`;
  return over ? 'Not found: no segment of any examination shows it.' : 'Not found yet: no examination has shown it.';
}

export function objectDetail(object, state, source) {
  const examined = state.store.examinationOf(object);
  return sheet(object.name, objectLook(object, state.over), whyObject(object, state.start.referee, state.over), [
    ['kind', object.kind || 'of the world'],
    ['lies at', state.where.sentence(object.p)],
    ['found after', seconds(object.found_at)],
    ['error', metres(object.error, 3)],
    ['region', examined?.region ? String(examined.region) : '–'],
  ], pictureOf(examined, source, examined && `as it was segmented after ${seconds(examined.t)}, segments outlined`));
}

function whyRegion(region, segments) {
  if (region.state === 'withdrawn') return 'Withdrawn: looked at again, and the map no longer differs from the reference there.';
  const seen = `${region.voxels} voxels are occupied where the reference is free`;
  if (region.state === 'open') return `To be examined: ${seen}.`;
  return `Examined: ${seen}; ${segments.length === 0 ? 'nothing could be told from the floor there' : `${segments.length} ${segments.length === 1 ? 'thing was' : 'things were'} segmented`}.`;
}

export function regionDetail(region, state, source) {
  const examined = state.examined.findLast((e) => e.region === region.id);
  const segments = examined?.segments ?? [];
  const rows = [
    ['middle', state.where.sentence(region.p)],
    ['radius', metres(region.radius)],
    ['height', `${fixed(region.z[0], 2)} to ${metres(region.z[1])}`],
    ['first seen', seconds(region.first_seen)],
    ['examined', seconds(region.examined_at)],
    ...segments.map((s, i) => [`segment ${i + 1}`, `${s.size.map((v) => (100 * v).toFixed(0)).join(' × ')} cm, ${s.points} points${s.cut ? ', cut off' : ''}`]),
  ];
  return sheet(`region ${region.id}`, REGION[region.state], whyRegion(region, segments), rows,
    pictureOf(examined, source, examined && `examined after ${seconds(examined.t)}, segments outlined`));
}
