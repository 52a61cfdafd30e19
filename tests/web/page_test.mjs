// The page in a browser: a run that goes on, a run that is over, report.html, and what is hard to bear.
// usage: node page_test.mjs PROGRAM FOLDER [SCREENSHOTS]
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chooseByKeys, keysOfTimeAndScene, poorContrasts, walkByTab } from './access.mjs';
import { DESKTOP, NO_3D, PHONE, Programs, launch, open, photographer } from './browser.mjs';
import { isCompact, longReport, lostConnection, withoutScene, withoutScript } from './hard.mjs';
import { looksLikeItsLegend, saysWhereInTheWorld, sliderIsUnderTheCursor, staysBesideTheLegend } from './look.mjs';

const [program, folder, pictures] = process.argv.slice(2);
rmSync(join(folder, 'run'), { recursive: true, force: true }); // of the last time
mkdirSync(folder, { recursive: true });
const programs = new Programs(program, folder);
const shoot = photographer(pictures);
const robot = (page) => page.evaluate(() => window.amiss.state().pose.p);

async function liveRun(browser) {
  const { url, ended } = await programs.start('tidy', '--world', 'lab_30', '--seed', '1', '--until', 'explored', '--out', 'run', '--view', '--port', '0', '--quiet', '--speed', '2');
  const page = await open(browser, url, url, DESKTOP);
  const first = await robot(page);
  await page.waitForFunction(([x, y]) => Math.hypot(window.amiss.state().pose.p[0] - x, window.amiss.state().pose.p[1] - y) > 0.5, first);
  await page.waitForFunction(() => window.amiss.state().objects.list.some((o) => o.found));
  await page.waitForSelector('#objects tbody tr');
  const verdicts = await page.$$eval('#objects tbody tr', (rows) => rows.map((row) => row.cells[1].textContent));
  assert.ok(verdicts.includes('not found yet') && !verdicts.includes('not found'), `while it goes on nothing is missed: ${verdicts}`);
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

/** Clicks the letter over an object that was found; gives its name. */
async function chooseByClick(page) {
  await page.click('[data-look=top]');
  const [name, at] = await page.evaluate(() => {
    const mug = window.amiss.state().objects.list.find((o) => o.found);
    window.amiss.scene.camera.updateMatrixWorld();
    return [mug.name, window.amiss.scene.onPage([mug.p[0], mug.p[1], mug.p[2] + 0.45])];
  });
  await page.mouse.click(...at);
  await page.waitForSelector('#detail:not([hidden]) .taken[src]');
  assert.match(await page.textContent('#detail h2'), new RegExp(name));
  assert.match(await page.textContent('#detail'), /Found: a segment holds \d+ % of its pixels/);
  return name;
}

/** Milliseconds of one picture of the scene, drawn to its end. */
const frameTime = (page) => page.evaluate(() => {
  const { renderer, world, camera } = window.amiss.scene;
  const gl = renderer.getContext();
  const times = Array.from({ length: 5 }, () => {
    const begun = performance.now();
    renderer.render(world, camera);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return performance.now() - begun;
  });
  return Math.min(...times);
});

async function scrubbedAndClicked(browser, url) {
  const page = await open(browser, url, url, DESKTOP);
  await page.waitForFunction(() => window.amiss.ended && document.querySelectorAll('#objects tbody tr').length === 5);
  const last = await robot(page);
  await page.focus('#scrub');
  await page.keyboard.press('Home');
  await page.waitForFunction(() => document.getElementById('now').textContent === '0.0 s');
  assert.notDeepEqual(await robot(page), last, 'the robot stands where it began');
  assert.equal(await page.evaluate(() => window.amiss.state().objects.list.filter((o) => o.found).length), 0);
  await page.evaluate(() => window.amiss.follow());
  await saysWhereInTheWorld(page, JSON.parse(readFileSync(join(folder, 'run', 'report.json'), 'utf8')));
  await chooseByClick(page);
  await shoot(page, 'clicked');
  await page.keyboard.press('Escape');
  await page.waitForSelector('#detail', { state: 'hidden' });
  await staysBesideTheLegend(page);
  await sliderIsUnderTheCursor(page);
  const lanes = await page.locator('#lanes').boundingBox();
  await page.mouse.click(lanes.x + 0.5 * lanes.width, lanes.y + lanes.height - 4);
  const part = await page.evaluate(() => window.amiss.time / window.amiss.store.end);
  assert.ok(part > 0.35 && part < 0.55, 'a click into the timeline goes there');
  await page.click('[data-look=fit]');
  await page.waitForTimeout(500);
  await shoot(page, 'light');
  const ms = await frameTime(page);
  console.log(`a picture of the scene takes ${ms.toFixed(0)} ms without a graphics card`);
  assert.ok(ms < 2000);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

async function byKeyboard(browser, url) {
  const page = await open(browser, url, url, DESKTOP);
  await page.waitForFunction(() => window.amiss.ended && document.querySelectorAll('#objects tbody tr').length === 5);
  const walk = await walkByTab(page);
  for (const name of ['theme', 'help', 'scene', 'tab-objects', 'play', 'scrub', 'cut']) assert.ok(walk.includes(name), `Tab comes to ${name}: ${walk}`);
  await chooseByKeys(page);
  await keysOfTimeAndScene(page);
  await page.focus('#tab-objects');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'tab-regions');
  await page.focus('#help');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#keys', { state: 'visible' });
  await page.keyboard.press('Escape');
  await page.waitForSelector('#keys', { state: 'hidden' });
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** All tables, with something chosen, in both schemes. */
async function isRead(browser, url) {
  for (const colorScheme of ['light', 'dark']) {
    const page = await open(browser, url, url, { ...DESKTOP, colorScheme });
    await page.waitForFunction(() => window.amiss.ended);
    await page.evaluate(() => window.amiss.seek(0.7 * window.amiss.store.end));
    await page.evaluate(() => window.amiss.choose({ kind: 'region', id: window.amiss.state().regions.list[0].id }));
    await page.waitForSelector('#detail:not([hidden])');
    for (const tab of await page.locator('[role=tab]').all()) {
      await tab.click();
      await page.waitForTimeout(300);
      assert.deepEqual(await page.evaluate(poorContrasts), [], `${colorScheme}, ${await tab.textContent()}`);
    }
    await looksLikeItsLegend(page);
    await page.click('#tab-run');
    await page.waitForTimeout(500);
    await shoot(page, colorScheme === 'dark' ? 'dark' : 'region');
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
}

async function onPhone(browser, url) {
  const phone = await open(browser, url, url, PHONE);
  await phone.waitForFunction(() => window.amiss.ended);
  const fits = () => phone.evaluate(() => document.documentElement.scrollWidth <= innerWidth);
  assert.ok(await fits(), 'nothing sticks out sideways');
  await phone.waitForTimeout(1500);
  await shoot(phone, 'phone');
  await phone.tap('#layers > summary');
  await phone.tap('.meanings > summary');
  assert.ok(await phone.isVisible('.meanings li:has-text("region that was examined")'), 'letters are explained to a finger');
  await shoot(phone, 'phone_legend');
  await phone.tap('#layers > summary');
  await phone.tap('#objects tbody button');
  await phone.waitForSelector('#detail:not([hidden])');
  const sheet = await phone.locator('#detail').boundingBox();
  assert.ok(sheet.y > 0.3 * 844 && sheet.y + sheet.height <= 845, 'the sheet lies at the bottom and leaves the scene free');
  assert.ok(await fits());
  await phone.waitForTimeout(500);
  await shoot(phone, 'phone_clicked');
  await phone.tap('#detail .close');
  await phone.waitForSelector('#detail', { state: 'hidden' });
  assert.deepEqual(phone.complaints, []);
  await phone.close();
}

async function finishedRun(browser) {
  const { child, url, ended } = await programs.start('view', 'run', '--port', '0');
  await scrubbedAndClicked(browser, url);
  await byKeyboard(browser, url);
  await isRead(browser, url);
  await onPhone(browser, url);
  await withoutScript(browser, url);
  const plain = await launch(NO_3D);
  await withoutScene(plain, url, shoot);
  await longReport(plain, resolve(folder, 'run', 'report.html'), shoot);
  await plain.close();
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
  await isCompact(page);
  await shoot(page, 'report', { fullPage: false });
  const seen = await page.getAttribute('#colour', 'alt');
  await page.evaluate(() => window.amiss.seek(0.5 * window.amiss.store.end));
  await page.waitForFunction((alt) => document.getElementById('colour').alt !== alt, seen);
  await page.evaluate(() => window.amiss.follow());
  await chooseByClick(page);
  assert.deepEqual(await page.evaluate(poorContrasts), []);
  await walkByTab(page);
  assert.deepEqual(page.complaints, []);
  await page.close();
  await withoutScript(browser, url);
}

/** A scripted run: what the script does is in the timeline, what was expected in the table of its end. */
async function scenarioRun(browser) {
  const file = fileURLToPath(new URL('../../share/scenarios/camera_fails.yaml', import.meta.url));
  rmSync(join(folder, 'scenario'), { recursive: true, force: true });
  const { url, ended } = await programs.start('scenario', file, '--out', 'scenario', '--view', '--port', '0', '--quiet', '--speed', '20');
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
  const badges = await page.$$eval('#events tbody tr', (rows) => Object.fromEntries(rows.map((row) => [row.cells[1].textContent, row.querySelector('.badge')?.textContent])));
  assert.ok(badges['! waits: camera silent'] && badges['R goes on'], `a fault and the recovery from it: ${Object.keys(badges)}`);
  await page.waitForTimeout(500);
  await shoot(page, 'scenario');
  assert.deepEqual(page.complaints, []);
  await page.close();
  assert.equal(await ended, 0);
}

/** A scripted run in which furniture is moved: the scene shows where, and a table says so. */
async function movedRun(browser) {
  const file = fileURLToPath(new URL('../scenarios/furniture_nudged.yaml', import.meta.url));
  rmSync(join(folder, 'moved'), { recursive: true, force: true });
  const { url, ended } = await programs.start('scenario', file, '--out', 'moved', '--view', '--port', '0', '--quiet');
  const page = await open(browser, url, url, DESKTOP);
  await page.waitForFunction(() => window.amiss.ended);
  await page.waitForFunction(() => /chair_dining_1/.test(document.getElementById('objects').textContent));
  await page.click('#tab-events');
  await page.waitForFunction(() => /go to view/.test(document.getElementById('events').textContent));
  await page.click('#tab-objects');
  await page.waitForTimeout(500);
  await shoot(page, 'moved');
  assert.deepEqual(page.complaints, []);
  await page.close();
  assert.equal(await ended, 0);
}

const browser = await launch();
try {
  await liveRun(browser);
  await finishedRun(browser);
  await report(browser);
  await lostConnection(browser, programs, folder, shoot);
  await scenarioRun(browser);
  await movedRun(browser);
  console.log('the page works');
} finally {
  await browser.close();
  programs.kill();
}
