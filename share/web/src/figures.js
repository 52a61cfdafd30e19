// The run in figures at the instant that is shown, what a scenario expected of it, and curves.
import { degrees, fixed, make, metres, percent, seconds } from './dom.js';
import { FAILS, HOLDS } from './look.js';
import { FREE, cellsOf } from './store.js';
import { plots } from './plots.js';
import { row, sentence, signed, table } from './rows.js';

const numeral = (value) => (value === null ? '–' : String(Number(value.toPrecision(4))));
const wayOf = (points) => points.reduce((sum, p, i) => (i === 0 ? 0 : sum + Math.hypot(p[0] - points[i - 1][0], p[1] - points[i - 1][1])), 0);
const voxels = (base64) => Math.floor((base64.length * 3) / 4 / 6);

const floors = new WeakMap();
function freeFloor(floor) {
  if (!floors.has(floor)) floors.set(floor, cellsOf(floor).reduce((sum, cell) => sum + (cell === FREE ? floor.resolution ** 2 : 0), 0));
  return floors.get(floor);
}

/** What holds at the instant. */
function instant(state) {
  const { pose, progress, where } = state;
  const list = [
    ['simulated time', seconds(state.time)],
    [`robot believes to be at (${where.frame})`, pose ? `${where.place(pose.p)} m, ${where.heading(pose.p[2])}` : '–'],
    ['and is off by', pose ? metres(Math.hypot(pose.p[0] - pose.true[0], pose.p[1] - pose.true[1]), 3) : '–'],
  ];
  // The report has the way by odometry, which is a little shorter or longer than that through the poses.
  if (!state.report) list.push(['driven so far', metres(wayOf(state.trail), 1)]);
  return [
    ...list,
    ['way to the next place', state.path ? metres(wayOf(state.path.points), 1) : '–'],
    ['head pan, tilt', pose ? `${degrees(pose.head[0])}, ${degrees(pose.head[1])}` : '–'],
    ['ground seen, furniture included', progress ? `${fixed(progress.seen_m2, 1)} m²` : '–'],
    ['free floor of the plan', `${fixed(freeFloor(state.start.floor), 1)} m²`],
    ['voxels that appeared, vanished', state.difference ? `${voxels(state.difference.appeared)}, ${voxels(state.difference.vanished)}` : '–'],
    [`voxels of the ${state.mapOf}`, String(state.voxelCount())],
    ['voxels of the reference', String(voxels(state.start.reference))],
    ['touches', String(state.touches.length)],
  ];
}

/** What the report of a search adds. */
const tidied = (report) => [
  ['found', `${report.objects_found} of ${report.objects_placed}`],
  ['segmentations', String(report.segmentation_actions)], ['regions', `${report.regions.detected} (${report.regions.false} false)`],
  ['driven, by odometry', metres(report.distance_m, 1)], ['seen of the floor in reach', percent(report.coverage)],
  ['localization (RMSE)', metres(report.localization.rmse_m, 3)],
  ['times real time', report.time.real_time_factor.toFixed(1)], ['digest', report.digest.slice(0, 12) + '…'],
];

/** What a scenario expects of its run, and what came. */
function expectations(report) {
  const rows = report.findings.map((f) => row([signed(f.holds ? HOLDS : FAILS, f.what), sentence(undefined, f.sentence)]));
  return make('div', {}, make('h3', {}, report.as_expected ? 'as expected' : 'not as expected'), table(['expected', 'what came'], rows, 'Nothing was expected.'));
}

export function figures(state) {
  const { report, start } = state;
  const list = instant(state);
  if (report) {
    list.push(['outcome', report.outcome]);
    if (report.findings) list.push(...Object.entries(report.numbers).map(([name, value]) => [name.replaceAll('_', ' '), numeral(value)]));
    else list.push(...tidied(report));
  }
  const [version, libraries] = start.version.split('; ');
  list.push(['world, seed, method', `${start.world}, ${start.seed}, ${start.method}`], ['amiss', version]);
  const sheet = make('dl', {}, ...list.flatMap(([term, value]) => [make('dt', {}, term), make('dd', {}, value)]));
  if (libraries) sheet.append(make('dt', { class: 'long' }, 'built with'), make('dd', { class: 'long' }, libraries));
  return make('div', {}, report?.findings ? expectations(report) : undefined, sheet, ...plots(state.store));
}
