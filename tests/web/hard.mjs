// What a page has to bear: no WebGL, no JavaScript, a connection that is lost, reports of runs of many kinds.
import assert from 'node:assert/strict';
import { cpSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { DESKTOP, PHONE, open } from './browser.mjs';

/** Tables, timeline, camera, drawer and curves without a scene, which says that it is not there. */
export async function withoutScene(browser, url, shoot) {
  const page = await open(browser, url, url, DESKTOP);
  await page.waitForFunction(() => window.amiss.ended && document.querySelectorAll('#objects tbody tr').length === 5);
  assert.match(await page.innerText('#stage'), /no 3D scene here/);
  assert.equal(await page.isVisible('#layers'), false);
  await page.waitForSelector('#colour[src]');
  await page.click('#objects tbody button');
  await page.waitForSelector('#detail:not([hidden]) .taken[src]');
  await shoot(page, 'no_3d');
  for (const key of ['0', 't', 'f', '+', 'Escape', 'Home']) await page.keyboard.press(key);
  await page.waitForFunction(() => document.getElementById('now').textContent === '0.0 s');
  await page.click('#theme');
  await page.click('#tab-run');
  await page.waitForSelector('#run .plot');
  assert.ok((await page.locator('#lanes circle').count()) > 5);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** A sentence instead of an empty page. */
export async function withoutScript(browser, url) {
  const page = await browser.newPage({ ...DESKTOP, javaScriptEnabled: false });
  await page.goto(url);
  assert.match(await page.innerText('body'), /JavaScript, which is switched off here/);
  assert.doesNotMatch(await page.innerText('body'), /loading/);
  await page.close();
}

/** The report `from` with its run changed. */
function altered(from, to, change) {
  const html = readFileSync(from, 'utf8');
  const [whole, head, text] = /(<script type="application\/json" id="run">)(.*?)<\/script>/s.exec(html);
  const run = JSON.parse(text);
  change(run);
  writeFileSync(to, html.replace(whole, () => `${head}${JSON.stringify(run).replaceAll('<', '\\u003c')}</script>`));
  return pathToFileURL(to).href;
}

const log = (t, text) => ({ e: 'log', t, text });

/** As of a long run whose place in the world is not known, with much in its log. */
function longRun(run) {
  const [start, ...rest] = run.events;
  delete start.place.T_world_map;
  const voxels = rest.filter((e) => e.e === 'voxels');
  const merged = { e: 'voxels', t: 0, on: voxels.map((e) => e.on).join(''), off: '', merged: true };
  const others = rest.filter((e) => e.e !== 'voxels');
  others.findLast((e) => e.e === 'pose').head = [-0.001, 0.001];
  const notes = Array.from({ length: 300 }, (_, i) => log(1 + i / 1000, `note ${i} <b>of</b> a recording, with so many words that they do not fit into one line of the table`));
  const told = [log(2, 'waits: camera silent'), log(3, 'goes on'), log(4, 'the same'), log(4.5, 'the same'), log(4.6, 'plan 1'), log(4.7, 'found mug')];
  const touch = { e: 'collision', t: 3.5, link: 'base_link', body: 'chair', p: [1, -0.0001, 0.1] };
  run.events = [start, merged, ...[...others, ...notes, ...told, touch].sort((a, b) => (a.e === 'end') - (b.e === 'end') || a.t - b.t)];
}

/** Texts that need more than a line. */
const wrapped = (page, selector) => page.$$eval(selector, (elements) => elements.filter((element) => {
  const text = document.createRange();
  text.selectNodeContents(element);
  return new Set([...text.getClientRects()].map((box) => Math.round(box.top))).size > 1;
}).map((element) => element.textContent));

/** Badges and words of the rows of the events' table. */
const eventRows = (page) => page.$$eval('#events tbody tr', (rows) => rows.map((row) => [row.querySelector('.badge')?.textContent ?? '', row.querySelector('td').textContent]));

export async function longReport(browser, file, shoot) {
  const url = altered(file, file.replace('report.html', 'long.html'), longRun);
  const page = await open(browser, url, url, DESKTOP);
  await page.waitForSelector('#run .plot');
  assert.match(await page.textContent('#run'), /voxels of the map at the end/);
  assert.equal(await page.textContent('[data-layer=current] > span'), 'map at the end');
  assert.match(await page.textContent('#objects thead'), /x, y \(map frame\) \[m\]/);
  assert.doesNotMatch(await page.textContent('body > main'), /-0°|-0\.0+[ ,]/);
  assert.match(await page.textContent('#events'), /The newest 200 of \d+ up to this instant/);
  const lanes = await page.$$eval('#lanes text', (names) => names.map((name) => name.textContent));
  for (const name of ['notes', 'faults', 'recovered']) assert.ok(lanes.includes(name), `${name} have a lane: ${lanes}`);
  const titles = await page.$$eval('#lanes circle', (marks) => marks.map((mark) => mark.textContent));
  assert.ok(titles.some((title) => /^1\.0 s: note 0 .*\n.*and \d+ more$/s.test(title)), 'what lies on one another is one mark');
  await page.evaluate(() => window.amiss.seek(5));
  await page.waitForFunction(() => document.getElementById('now').textContent === '5.0 s');
  const rows = await eventRows(page);
  const letter = (text) => rows.find(([, said]) => said.includes(text))?.[0];
  assert.equal(letter('waits: camera silent'), '!');
  assert.equal(letter('base_link touched chair at 1.00, 0.00 m (map frame)'), '!');
  assert.equal(letter('goes on'), 'R');
  assert.equal(letter('the same (2 times)'), 'i');
  assert.ok(!rows.some(([, said]) => /plan 1$|found mug/.test(said)), 'the log does not repeat what events tell');
  assert.match(await page.textContent('#run'), /voxels of the map at the end/, 'at every instant');
  const sideways = () => page.evaluate(() => [...document.querySelectorAll('[role=tabpanel]')].filter((panel) => panel.scrollWidth > panel.clientWidth).map((panel) => panel.id));
  assert.deepEqual(await sideways(), [], 'long notes wrap');
  await shoot(page, 'long_report', { fullPage: true });
  await page.setViewportSize(PHONE.viewport);
  await page.waitForTimeout(300);
  assert.equal((await sideways()).includes('events'), false);
  assert.deepEqual(await wrapped(page, '#events tbody button'), []);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** No value of the figures needs a second line, and what is long is folded. */
export async function isCompact(page) {
  assert.deepEqual(await wrapped(page, '#run dd:not(.long)'), []);
  assert.equal(await page.locator('#parameters details[open]').count(), 0);
  await page.click('#parameters summary');
  assert.ok(await page.isVisible('#parameters pre'));
  await page.click('#parameters summary');
}

/** A server that is there, but takes no more sockets. */
async function isRefused(browser, url) {
  const page = await browser.newPage(DESKTOP);
  await page.routeWebSocket(/events/, (socket) => socket.close());
  await page.goto(url);
  await page.waitForFunction(() => /lets no further page watch/.test(document.getElementById('status').textContent));
  await page.close();
}

const ofTheNetwork = (complaint) => /WebSocket|ERR_CONNECTION/.test(complaint);

/** A run that nobody finished: its connection breaks and comes again, then its server goes. */
export async function lostConnection(browser, programs, folder, shoot) {
  const cut = join(folder, 'cut');
  rmSync(cut, { recursive: true, force: true });
  cpSync(join(folder, 'run'), cut, { recursive: true });
  const lines = readFileSync(join(cut, 'timeline.jsonl'), 'utf8').trimEnd().split('\n').slice(0, -1);
  writeFileSync(join(cut, 'timeline.jsonl'), lines.join('\n') + '\n');
  const { child, url } = await programs.start('view', 'cut', '--port', '0');
  const alone = isRefused(browser, url);
  const page = await open(browser, url, url, DESKTOP);
  const told = () => page.waitForFunction((count) => window.amiss.store.count === count, lines.length);
  await told();
  const sees = await page.evaluate(() => {
    window.before = window.amiss.store;
    window.amiss.seek(3);
    window.amiss.source.socket.close();
    return window.amiss.state().pose.p;
  });
  await page.waitForFunction(() => window.amiss.store !== window.before);
  await told();
  assert.deepEqual(await page.evaluate(() => window.amiss.state().pose.p), sees, 'at the same instant');
  await page.waitForFunction(() => document.getElementById('status').textContent === 'as far as it was written');
  assert.deepEqual(page.complaints, []);

  await alone;
  child.kill('SIGKILL');
  await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('connection lost'));
  await page.waitForFunction(() => document.getElementById('status').textContent === 'the run is gone');
  assert.match(await page.textContent('#objects'), /found/, 'what was heard stays');
  await shoot(page, 'gone');
  assert.deepEqual(page.complaints.filter((complaint) => !ofTheNetwork(complaint)), []);
  await page.close();
}
