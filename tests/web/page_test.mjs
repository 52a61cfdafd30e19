// The page in a browser: a run that goes on, a run that is over, report.html.
// usage: node page_test.mjs PROGRAM FOLDER [SCREENSHOTS]
// Ends with 77 where there is no Chromium or no playwright-core (`npm ci` in share/web).
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, rmSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const [program, folder, pictures] = process.argv.slice(2);
const chromiumProgram = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
let chromium;
try {
  ({ chromium } = createRequire(fileURLToPath(new URL('../../share/web/', import.meta.url)))('playwright-core'));
} catch {
  console.log('playwright-core is not there: skipped');
  process.exit(77);
}
if (!chromiumProgram) {
  console.log('Chromium is not there: skipped');
  process.exit(77);
}
rmSync(join(folder, 'run'), { recursive: true, force: true }); // of the last time
mkdirSync(folder, { recursive: true });
if (pictures) mkdirSync(pictures, { recursive: true });

const children = [];
/** Starts amiss; gives the child and the address that it tells. */
async function start(...words) {
  const child = spawn(resolve(program), words, { cwd: folder, stdio: ['ignore', 'ignore', 'pipe'] });
  children.push(child);
  const ended = new Promise((done) => child.on('exit', done));
  let said = '';
  const url = await new Promise((tell, fail) => {
    child.stderr.on('data', (text) => {
      said += text;
      const address = /watch at (http:\S+)/.exec(said);
      if (address) tell(address[1]);
    });
    child.on('exit', () => fail(new Error('it ended: ' + said)));
  });
  return { child, url, ended };
}

/** A page that may say nothing on its console and ask nobody but `origin`. */
async function open(browser, url, origin, look) {
  const page = await browser.newPage(look);
  page.setDefaultTimeout(240000); // a place that was not mapped yet is mapped first
  page.complaints = [];
  page.on('console', (message) => page.complaints.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => page.complaints.push(error.stack));
  page.on('request', (request) => {
    const asked = request.url();
    if (!asked.startsWith(origin) && !/^(data|blob):/.test(asked)) page.complaints.push('asked ' + asked);
  });
  await page.goto(url);
  await page.waitForFunction(() => window.amiss?.start);
  return page;
}
const shoot = (page, name, more) => pictures && page.screenshot({ path: join(pictures, name + '.png'), ...more });
const robot = (page) => page.evaluate(() => window.amiss.state().pose.p);
const DESKTOP = { viewport: { width: 1400, height: 900 } };

async function liveRun(browser) {
  const { url, ended } = await start('tidy', '--world', 'lab_30', '--seed', '1', '--until', 'explored', '--out', 'run', '--view', '--port', '0', '--quiet', '--speed', '8');
  const page = await open(browser, url, url, DESKTOP);
  const first = await robot(page);
  await page.waitForFunction(([x, y]) => Math.hypot(window.amiss.state().pose.p[0] - x, window.amiss.state().pose.p[1] - y) > 0.5, first);
  await page.waitForFunction(() => window.amiss.state().objects.list.some((o) => o.found));
  await page.waitForSelector('#objects tbody tr');
  await page.click('#halt');
  await page.waitForFunction(() => document.getElementById('status').textContent === 'paused');
  const before = await page.evaluate(() => window.amiss.store.end);
  await page.click('#step');
  await page.waitForFunction((t) => window.amiss.store.end > t, before);
  assert.ok((await page.evaluate(() => window.amiss.store.end)) < before + 1, 'a step is short');
  await shoot(page, 'live');
  await page.selectOption('#speed', '0');
  await page.click('#halt');
  await page.waitForFunction(() => window.amiss.ended);
  assert.equal(await page.evaluate(() => window.amiss.ended.outcome), 'explored');
  assert.deepEqual(page.complaints, []);
  await page.close();
  assert.equal(await ended, 0);
}

async function chooseByClick(page) {
  await page.click('[data-look=top]');
  const at = await page.evaluate(() => {
    const mug = window.amiss.state().objects.list.find((o) => o.found);
    window.amiss.scene.camera.updateMatrixWorld();
    return window.amiss.scene.onPage([mug.p[0], mug.p[1], mug.p[2] + 0.45]);
  });
  await page.mouse.click(...at);
  await page.waitForSelector('#detail:not([hidden]) .taken[src^=blob]');
  assert.match(await page.textContent('#detail'), /Found: a segment holds \d+ % of its pixels/);
}

async function finishedRun(browser) {
  const { child, url, ended } = await start('view', 'run', '--port', '0');
  const page = await open(browser, url, url, DESKTOP);
  await page.waitForFunction(() => window.amiss.ended && document.querySelectorAll('#objects tbody tr').length === 5);
  const last = await robot(page);
  await page.focus('#scrub');
  await page.keyboard.press('Home');
  await page.waitForFunction(() => document.getElementById('now').textContent === '0.0 s');
  assert.notDeepEqual(await robot(page), last, 'the robot stands where it began');
  assert.equal(await page.evaluate(() => window.amiss.state().objects.list.filter((o) => o.found).length), 0);
  await page.evaluate(() => window.amiss.follow());
  await chooseByClick(page);
  await page.click('[data-look=fit]');
  await page.waitForTimeout(500);
  await shoot(page, 'light');
  await page.focus('#tab-objects');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'tab-regions');
  assert.deepEqual(page.complaints, []);
  await page.close();

  const dark = await open(browser, url, url, { ...DESKTOP, colorScheme: 'dark' });
  await dark.waitForFunction(() => window.amiss.ended);
  await dark.evaluate(() => window.amiss.seek(0.7 * window.amiss.store.end));
  await dark.click('#tab-run');
  await dark.waitForTimeout(1500);
  await shoot(dark, 'dark');
  assert.deepEqual(dark.complaints, []);
  await dark.close();

  const phone = await open(browser, url, url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await phone.waitForFunction(() => window.amiss.ended);
  assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing sticks out sideways');
  await phone.waitForTimeout(1500);
  await shoot(phone, 'phone');
  assert.deepEqual(phone.complaints, []);
  await phone.close();
  child.kill('SIGINT');
  assert.equal(await ended, 0);
}

async function report(browser) {
  const file = resolve(folder, 'run', 'report.html');
  assert.ok(statSync(file).size < 3e6, 'small enough to be sent');
  const url = pathToFileURL(file).href;
  const page = await open(browser, url, url, DESKTOP);
  await page.waitForFunction(() => document.querySelectorAll('#objects tbody tr').length === 5);
  assert.match(await page.textContent('#parameters pre'), /voxel/);
  assert.ok((await page.locator('.plot').count()) >= 3);
  await page.waitForTimeout(1000);
  await shoot(page, 'report', { fullPage: false });
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** A scripted run: what the script does is in the timeline, what was expected in the table of its end. */
async function scenarioRun(browser) {
  const file = fileURLToPath(new URL('../../share/scenarios/camera_fails.yaml', import.meta.url));
  rmSync(join(folder, 'scenario'), { recursive: true, force: true });
  const { url, ended } = await start('scenario', file, '--out', 'scenario', '--view', '--port', '0', '--quiet', '--speed', '20');
  const page = await open(browser, url, url, DESKTOP);
  await page.waitForFunction(() => window.amiss.store.all('script').length > 0);
  assert.match(await page.textContent('#subject'), /camera_fails/);
  await page.selectOption('#speed', '0');
  await page.waitForFunction(() => window.amiss.ended);
  assert.equal(await page.evaluate(() => window.amiss.ended.as_expected), true);
  await page.click('#tab-run');
  await page.waitForSelector('#run tbody tr');
  assert.match(await page.textContent('#run'), /as expected/);
  await page.click('#tab-events');
  assert.match(await page.textContent('#events'), /camera/);
  await page.waitForTimeout(500);
  await shoot(page, 'scenario');
  assert.deepEqual(page.complaints, []);
  await page.close();
  assert.equal(await ended, 0);
}

const browser = await chromium.launch({
  executablePath: chromiumProgram,
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
try {
  await liveRun(browser);
  await finishedRun(browser);
  await report(browser);
  await scenarioRun(browser);
  console.log('the page works');
} finally {
  await browser.close();
  for (const child of children) child.kill('SIGKILL');
}
