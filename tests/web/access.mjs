// What everybody needs of a page, whoever sees it how: contrast, the keyboard alone, nothing that jumps.
import assert from 'node:assert/strict';

/** Texts whose contrast with what is behind them is less than WCAG 2 AA asks (4.5; 3 if large). */
export function poorContrasts() {
  const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  const rgba = (css) => {
    canvas.clearRect(0, 0, 1, 1);
    canvas.fillStyle = css;
    canvas.fillRect(0, 0, 1, 1);
    return [...canvas.getImageData(0, 0, 1, 1).data].map((v) => v / 255);
  };
  const over = (a, b) => [0, 1, 2].map((k) => a[k] * a[3] + b[k] * (1 - a[3]));
  const behind = (element) => {
    if (!element) return [1, 1, 1];
    const own = rgba(getComputedStyle(element).backgroundColor);
    return own[3] === 1 ? own.slice(0, 3) : over(own, behind(element.parentElement));
  };
  const bright = (c) => {
    const [r, g, b] = c.map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const poor = [];
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const element = texts.currentNode.parentElement;
    const said = texts.currentNode.textContent.trim();
    if (!said || !element.checkVisibility() || /^(SCRIPT|STYLE|TITLE|OPTION)$/i.test(element.tagName)) continue;
    const style = getComputedStyle(element);
    const back = behind(element);
    const ink = over(rgba(element.namespaceURI.endsWith('svg') ? style.fill : style.color), back);
    const [low, high] = [bright(ink), bright(back)].sort((a, b) => a - b);
    const ratio = (high + 0.05) / (low + 0.05);
    const size = parseFloat(style.fontSize);
    const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    if (ratio < (large ? 3 : 4.5)) poor.push(`${said.slice(0, 30)}: ${ratio.toFixed(2)}`);
  }
  return poor;
}

/** What the focus is on; empty at the end of the page. */
const focused = (page) => page.evaluate(() => {
  const element = document.activeElement;
  if (!element || element === document.body) return '';
  const box = element.getBoundingClientRect();
  const style = getComputedStyle(element);
  return {
    name: element.id || element.getAttribute('aria-label') || element.textContent.trim().slice(0, 20) || element.parentElement.textContent.trim(),
    seen: box.width > 0 && style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2,
    named: Boolean(element.getAttribute('aria-label') || element.getAttribute('aria-labelledby') || element.textContent.trim() || element.labels?.length),
  };
});

/** Tab from the beginning to the end: everything is named, and one sees where one is. */
export async function walkByTab(page) {
  await page.evaluate(() => document.activeElement?.blur());
  const names = [];
  for (let i = 0; i < 120; ++i) {
    await page.keyboard.press('Tab');
    const at = await focused(page);
    if (!at) break;
    assert.ok(at.seen, `${at.name}: one sees that the focus is there`);
    assert.ok(at.named, `${at.name}: it has a name`);
    names.push(at.name);
  }
  return names;
}

const boxes = (page) => page.evaluate(() => ['stage', 'camera', 'tables', 'time'].map((id) => {
  const { x, y, width } = document.getElementById(id).getBoundingClientRect();
  return [id, x, y, width];
}));

/** An object is chosen, read, and left again by the keyboard alone, and nothing has moved meanwhile. */
export async function chooseByKeys(page) {
  const before = await boxes(page);
  await page.focus('#tab-objects');
  await page.keyboard.press('Tab'); // the table
  await page.keyboard.press('Tab'); // its first row
  const name = await page.evaluate(() => document.activeElement.dataset.id);
  assert.ok(name, 'the first row is a button');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#detail:not([hidden])');
  assert.match(await page.textContent('#detail h2'), new RegExp(name));
  assert.deepEqual(await boxes(page), before, 'nothing has moved');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.id), name, 'the focus stays in the table');
  await page.focus('#detail .close');
  await page.keyboard.press('Escape');
  await page.waitForSelector('#detail', { state: 'hidden' });
  assert.equal(await page.evaluate(() => document.activeElement.dataset.id), name, 'the focus is back in the table');
  assert.deepEqual(await boxes(page), before);
}

/** Arrows in the page go through time, in the scene they turn it. */
export async function keysOfTimeAndScene(page) {
  await page.evaluate(() => document.activeElement?.blur());
  const time = () => page.evaluate(() => window.amiss.time);
  const from = () => page.evaluate(() => window.amiss.scene.camera.position.toArray());
  await page.keyboard.press('End');
  const end = await time();
  await page.keyboard.press('ArrowLeft');
  assert.ok(Math.abs((await time()) - (end - 1)) < 1e-6);
  await page.keyboard.press('Shift+ArrowLeft');
  assert.ok(Math.abs((await time()) - (end - 11)) < 1e-6);
  const [before, at] = [await from(), await time()];
  await page.focus('#scene');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await time(), at, 'in the scene they are for the view');
  assert.notDeepEqual(await from(), before);
  const distance = (p) => Math.hypot(...p);
  await page.keyboard.press('0');
  const whole = await from();
  await page.keyboard.press('+');
  assert.ok(distance(await from()) < distance(whole));
  await page.keyboard.press('End');
}
