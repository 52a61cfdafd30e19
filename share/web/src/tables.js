// The tables: everything that the scene shows, in words and numbers, at the instant that is shown.
import { badge, make, metres, place, seconds, several } from './dom.js';
import { BODY, FAILS, FAULT, HOLDS, OBJECT, REGION, SCRIPT, SEGMENT, VIEW, objectLook } from './look.js';
import { FREE, cellsOf } from './store.js';
import { faults, finds, stepText, steps } from './lanes.js';
import { plots } from './plots.js';

const degrees = (radians) => `${((radians * 180) / Math.PI).toFixed(0)}°`;

function table(columns, rows, empty) {
  if (rows.length === 0) return make('p', { class: 'empty' }, empty);
  return make('table', {},
    make('thead', {}, make('tr', {}, ...columns.map((name) => make('th', { scope: 'col' }, name)))),
    make('tbody', {}, ...rows));
}

function row(cells, { act, chosen, id } = {}) {
  const [first, ...rest] = cells;
  const head = act ? make('button', { type: 'button', onclick: act, 'data-id': id }, first) : first;
  return make('tr', { 'aria-selected': chosen ? 'true' : undefined }, make('th', { scope: 'row' }, head), ...rest.map((cell) => make('td', {}, cell)));
}

const signed = (look, text) => {
  const cell = make('span', { class: 'signed' });
  cell.append(badge(look), ' ', text);
  return cell;
};

function objects(state, app) {
  const rows = (state.objects?.list ?? []).map((o) => row(
    [signed(objectLook(o, state.over), o.name), objectLook(o, state.over).verdict, seconds(o.found_at), metres(o.error, 3), place(o.p)],
    { act: () => app.choose({ kind: 'object', id: o.name }), chosen: state.chosen?.id === o.name, id: o.name }));
  const placed = table(['object', 'verdict', 'after', 'error', 'x, y [m]'], rows, 'No object was placed.');
  if (state.bodies.length === 0) return placed;
  const others = state.bodies.map((b) => row([signed(BODY, b.name), seconds(b.t), place(b.pose)], { act: () => app.goTo(b.pose) }));
  return make('div', {}, placed, make('h3', {}, 'what else moves or was moved'), table(['thing', 'there since', 'x, y [m]'], others, ''));
}

function segments(state, app) {
  const rows = state.examined.flatMap((e) => e.segments.map((s) => row(
    [signed(SEGMENT, e.region ? `of region ${e.region}` : 'of a frame'), s.size.map((v) => (100 * v).toFixed(0)).join(' × '), String(s.points), seconds(e.t), place(s.p)],
    { act: () => app.goTo(s.p) })));
  return table(['segment', 'size [cm]', 'points', 'at', 'x, y [m]'], rows, 'Nothing was segmented yet.');
}

function regions(state, app) {
  const rows = (state.regions?.list ?? []).map((r) => row(
    [signed(REGION[r.state], `region ${r.id}`), r.state, String(r.voxels), metres(r.radius), place(r.p)],
    { act: () => app.choose({ kind: 'region', id: r.id }), chosen: state.chosen?.kind === 'region' && state.chosen.id === r.id, id: r.id }));
  return table(['region', 'state', 'voxels', 'radius', 'x, y [m]'], rows, 'The map does not differ from the reference.');
}

function plan(state, app) {
  const from = state.step && state.plan && state.step.t >= state.plan.t ? state.step.step : 0;
  const steps = (state.plan?.steps ?? []).map((s, i) => row(
    [`${i + 1}. ${stepText(s)}`, i < from ? 'done' : i === from ? 'now' : '', place(s.p), degrees(s.p[2])],
    { act: () => app.goTo([s.p[0], s.p[1], 0]), chosen: i === from }));
  const views = (state.views?.list ?? []).map((v) => row(
    [signed(VIEW[v.state], `view ${v.id}`), v.state, place(v.p), degrees(v.p[2])], { act: () => app.goTo([v.p[0], v.p[1], 0]) }));
  return make('div', {}, make('h3', {}, state.plan ? `plan ${state.plan.number}, made at ${seconds(state.plan.t)}` : 'plan'),
    table(['step', '', 'x, y [m]', 'heading'], steps, 'No plan yet.'),
    make('h3', {}, 'view triangles'), table(['view', 'state', 'x, y [m]', 'heading'], views, 'None yet.'));
}

function happened(store, time) {
  const list = [
    ...store.until('plan', time).map((e) => ({ t: e.t, text: `plan ${e.number}: ${several(e.steps.filter((s) => s.action === 'goto').length, 'place')}` })),
    ...steps(store).filter((e) => e.t <= time),
    ...(store.latest('regions', time)?.list ?? []).map((r) => ({ t: r.first_seen, text: `region ${r.id} detected`, look: REGION.open })),
    ...store.until('examined', time).map((e) => ({ t: e.t, text: `${e.region ? `region ${e.region}` : 'frame'} examined: ${several(e.segments.length, 'segment')}`, look: SEGMENT })),
    ...finds(store).filter((o) => o.found_at <= time).map((o) => ({ t: o.found_at, text: `${o.name} found`, look: OBJECT.found })),
    ...store.until('script', time).map((e) => ({ ...e, look: SCRIPT })),
    ...faults(store).filter((e) => e.t <= time).map((e) => ({ ...e, look: FAULT })),
  ];
  return list.sort((a, b) => b.t - a.t);
}

function events(state, app) {
  const rows = happened(state.store, state.time).slice(0, 200)
    .map((e) => row([seconds(e.t), e.look ? signed(e.look, e.text) : e.text], { act: () => app.seek(e.t) }));
  return table(['at', 'what'], rows, 'Nothing yet.');
}

const tidied = (report) => [
  ['found', `${report.objects_found} of ${report.objects_placed}`],
  ['segmentations', String(report.segmentation_actions)], ['regions', `${report.regions.detected} (${report.regions.false} false)`],
  ['driven', metres(report.distance_m, 1)], ['localization (RMSE)', metres(report.localization.rmse_m, 3)],
  ['times real time', report.time.real_time_factor.toFixed(1)], ['digest', report.digest.slice(0, 16) + '…'],
];

const numeral = (value) => (value === null ? '–' : String(Number(value.toPrecision(4))));

/** What a scenario expects of its run, and what came. */
function expectations(report) {
  const rows = report.findings.map((f) => row([signed(f.holds ? HOLDS : FAILS, f.what), make('span', { class: 'sentence' }, f.sentence)]));
  return make('div', {}, make('h3', {}, report.as_expected ? 'as expected' : 'not as expected'), table(['expected', 'what came'], rows, 'Nothing was expected.'));
}

function figures(state) {
  const { pose, progress, report } = state;
  const list = [
    ['simulated time', seconds(state.time)],
    ['robot believes to be at', pose ? `${place(pose.p)} m, ${degrees(pose.p[2])}` : '–'],
    ['and is off by', pose ? metres(Math.hypot(pose.p[0] - pose.true[0], pose.p[1] - pose.true[1]), 3) : '–'],
    ['driven so far', metres(wayOf(state.trail), 1)],
    ['way to the next place', state.path ? metres(wayOf(state.path.points), 1) : '–'],
    ['head pan, tilt', pose ? `${degrees(pose.head[0])}, ${degrees(pose.head[1])}` : '–'],
    ['floor seen', progress ? `${progress.seen_m2.toFixed(1)} m²` : '–'],
    ['voxels that appeared, vanished', state.difference ? `${voxels(state.difference.appeared)}, ${voxels(state.difference.vanished)}` : '–'],
    ['voxels of the map now, of the reference', `${state.voxelCount()}, ${state.start ? voxels(state.start.reference) : '–'}`],
    ['free floor of the plan', state.start ? `${freeFloor(state.start.floor).toFixed(1)} m²` : '–'],
    ['touches', String(state.touches.length)],
  ];
  if (report) {
    list.push(['outcome', report.outcome]);
    if (report.findings) list.push(...Object.entries(report.numbers).map(([name, value]) => [name.replaceAll('_', ' '), numeral(value)]));
    else list.push(...tidied(report));
  }
  if (state.start) list.push(['world, seed, method', `${state.start.world}, ${state.start.seed}, ${state.start.method}`], ['amiss', state.start.version]);
  const sheet = make('dl', {}, ...list.flatMap(([term, value]) => [make('dt', {}, term), make('dd', {}, value)]));
  return make('div', {}, report?.findings ? expectations(report) : undefined, sheet, ...plots(state.store));
}

const wayOf = (points) => points.reduce((sum, p, i) => (i === 0 ? 0 : sum + Math.hypot(p[0] - points[i - 1][0], p[1] - points[i - 1][1])), 0);

const floors = new WeakMap();
function freeFloor(floor) {
  if (!floors.has(floor)) floors.set(floor, cellsOf(floor).reduce((sum, cell) => sum + (cell === FREE ? floor.resolution ** 2 : 0), 0));
  return floors.get(floor);
}

const voxels = (base64) => Math.floor((base64.length * 3) / 4 / 6);

/** Name, title, what it holds, and what it depends on. */
const TABS = [
  ['objects', 'Objects', objects, (s) => [s.objects?.t, s.over, s.chosen?.id, s.bodies.map((b) => b.t)]],
  ['regions', 'Regions', regions, (s) => [s.regions?.t, s.chosen?.id]],
  ['segments', 'Segments', segments, (s) => [s.examined.length]],
  ['plan', 'Plan', plan, (s) => [s.plan?.t, s.step?.t, s.views?.t]],
  ['events', 'Events', events, (s) => [Math.floor(s.time), s.store.count]],
  ['run', 'Run', figures, (s) => [s.time.toFixed(1), s.over]],
];

export class Tables {
  constructor(host, app, still) {
    this.app = app;
    this.list = host.querySelector('[role=tablist]');
    this.panels = new Map();
    this.shown = {};
    for (const [name, title] of [...TABS, ['parameters', 'Parameters']]) {
      const tab = make('button', { type: 'button', role: 'tab', id: 'tab-' + name, 'aria-controls': name, onclick: () => this.open(name), onkeydown: (e) => this.walk(e) }, title);
      const panel = make('div', { role: 'tabpanel', id: name, 'aria-labelledby': 'tab-' + name, tabindex: '0' });
      if (still) panel.dataset.title = title;
      this.list.append(tab);
      host.append(panel);
      this.panels.set(name, { tab, panel });
    }
    this.all = still; // a report shows them all, one below the other
    this.open('objects');
  }

  open(name) {
    this.current = name;
    for (const [other, { tab, panel }] of this.panels) {
      tab.setAttribute('aria-selected', String(other === name));
      tab.tabIndex = other === name ? 0 : -1;
      panel.hidden = !this.all && other !== name;
    }
    if (this.state) this.update(this.state);
    if (name === 'parameters' || this.all) this.loadParameters();
  }

  walk(event) {
    const names = [...this.panels.keys()];
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    event.stopPropagation();
    this.open(names[(names.indexOf(this.current) + by + names.length) % names.length]);
    this.panels.get(this.current).tab.focus();
  }

  async loadParameters() {
    const { panel } = this.panels.get('parameters');
    if (panel.firstChild) return;
    const text = make('pre', {}, 'loading');
    panel.append(text, make('h3', {}, 'Software of others'), make('pre', {}, (await this.app.text('licences.txt')) ?? ''));
    text.textContent = (await this.app.text('params.yaml')) ?? 'The parameters cannot be read.';
  }

  update(state) {
    this.state = state;
    for (const [name, , fill, depends] of TABS) {
      if (!this.all && name !== this.current) continue;
      const key = JSON.stringify(depends(state));
      if (this.shown[name] === key) continue;
      this.shown[name] = key;
      const { panel } = this.panels.get(name);
      const focused = panel.contains(document.activeElement) ? [...panel.querySelectorAll('button')].indexOf(document.activeElement) : -1;
      panel.replaceChildren(fill(state, this.app));
      if (focused >= 0) panel.querySelectorAll('button')[focused]?.focus({ preventScroll: true });
    }
  }
}
