// What is where on the page, and in which colours: legend, scene, timeline and tables must agree.
import assert from 'node:assert/strict';

/** The table, the drawer and the pointer give the places of report.json. */
export async function saysWhereInTheWorld(page, report) {
  assert.match(await page.textContent('#objects thead'), /x, y \(world\) \[m\]/);
  const rows = await page.$$eval('#objects tbody tr', (list) => list.map((row) => [row.querySelector('button').dataset.id, row.cells[4].textContent]));
  for (const { name, position } of report.objects) {
    const [x, y] = rows.find(([id]) => id === name)[1].split(', ').map(Number);
    assert.ok(Math.hypot(x - position[0], y - position[1]) < 0.015, `${name}: ${x}, ${y} is where report.json says, ${position}`);
  }
  await page.click('[data-look=top]');
  const [at, said] = await page.evaluate(() => {
    const { name, p } = window.amiss.state().objects.list[0];
    window.amiss.scene.camera.updateMatrixWorld();
    return [window.amiss.scene.onPage([p[0], p[1], p[2] + 0.45]), `${name} at ${window.amiss.where.place(p)} m (world)`];
  });
  await page.mouse.move(...at);
  await page.waitForFunction(() => document.getElementById('scene').title);
  assert.equal(await page.getAttribute('#scene', 'title'), said);
  await page.click('#objects tbody button');
  await page.waitForSelector('#detail:not([hidden])');
  assert.match(await page.textContent('#detail'), /lies at-?\d+\.\d\d, -?\d+\.\d\d m \(world\)/);
  await page.keyboard.press('Escape');
}

/** Seen from above, no part of the place lies under the legend. */
export async function staysBesideTheLegend(page) {
  await page.click('[data-look=top]');
  const [legend, stage, corners] = await page.evaluate(() => {
    const { scene } = window.amiss;
    scene.camera.updateMatrixWorld();
    const [west, south, east, north] = scene.layers.floor.bounds();
    const box = (id) => document.getElementById(id).getBoundingClientRect().toJSON();
    return [box('layers'), box('stage'), [[west, south], [west, north], [east, south], [east, north]].map(([x, y]) => scene.onPage([x, y, 0]))];
  });
  for (const [x, y] of corners) {
    assert.ok(x > legend.right && x < stage.right && y > stage.top && y < stage.bottom, `a corner is seen: ${x}, ${y}`);
  }
}

/** A click on the slider below the cursor of the timeline sets the time of the cursor. */
export async function sliderIsUnderTheCursor(page) {
  const slider = await page.locator('#scrub').boundingBox();
  for (const part of [0.02, 0.5, 0.98]) {
    const [x, pixel] = await page.evaluate((p) => {
      const { lanes, store } = window.amiss;
      const { left, width } = lanes.host.getBoundingClientRect();
      return [left + lanes.x(p * store.end, store.end, width), store.end / (width - 70)];
    }, part);
    await page.mouse.click(x, slider.y + slider.height / 2);
    const [time, end] = await page.evaluate(() => [window.amiss.time, window.amiss.store.end]);
    assert.ok(Math.abs(time - part * end) < 2 * pixel + 0.1, `${time} s is where the cursor stands, at ${part * end} s`);
  }
}

/** Ways have the colour of the legend, in the scheme that is shown and after a change to the other one and back. */
export async function looksLikeItsLegend(page) {
  const pairs = () => page.evaluate(() => {
    const hex = (css) => '#' + css.match(/\d+/g).slice(0, 3).map((v) => Number(v).toString(16).padStart(2, '0')).join('');
    const sign = (layer) => hex(getComputedStyle(document.querySelector(`[data-layer=${layer}] > i`)).backgroundColor);
    const drawn = (layer) => '#' + window.amiss.scene.layers.groups[layer].children[0].material.color.getHexString();
    return ['path', 'trail'].map((layer) => [layer, sign(layer), drawn(layer)]);
  });
  for (let i = 0; i < 3; ++i) {
    for (const [layer, sign, drawn] of await pairs()) assert.equal(drawn, sign, `${layer}, change ${i}`);
    if (i === 2) break;
    await page.click('#theme');
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }
  const signs = (layer) => page.$$eval(`[data-layer=${layer}] > :is(i, .badge)`, (list) => list.map((sign) => sign.title));
  assert.deepEqual((await signs('difference')).map((title) => title.split(':')[0]), ['appeared', 'vanished']);
  assert.equal((await signs('regions')).length, 3);
}
