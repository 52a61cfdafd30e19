// Chromium, programs that serve pages, and pages that may say nothing on the console and ask nobody else.
// Ends with 77 where there is no Chromium or no playwright-core (`npm ci` in share/web).
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

function skip(why) {
  console.log(`${why} is not there: skipped`);
  process.exit(77);
}

const SOFTWARE = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
export const NO_3D = ['--disable-3d-apis'];

export async function launch(graphics = SOFTWARE) {
  const executablePath = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
  if (!executablePath) skip('Chromium');
  let playwright;
  try {
    playwright = createRequire(fileURLToPath(new URL('../../share/web/', import.meta.url)))('playwright-core');
  } catch {
    skip('playwright-core');
  }
  return playwright.chromium.launch({ executablePath, args: ['--no-sandbox', ...graphics] });
}

export class Programs {
  constructor(program, folder) {
    this.program = resolve(program);
    this.folder = folder;
    this.children = [];
  }

  /** Starts amiss; gives the child and the address that it tells. */
  async start(...words) {
    const child = spawn(this.program, words, { cwd: this.folder, stdio: ['ignore', 'ignore', 'pipe'] });
    this.children.push(child);
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

  kill() { for (const child of this.children) child.kill('SIGKILL'); }
}

/** A page that may say nothing on its console and ask nobody but `origin`. */
export async function open(browser, url, origin, look) {
  const page = await browser.newPage({ reducedMotion: 'reduce', ...look });
  page.setDefaultTimeout(120000); // a place that was not mapped yet is mapped first
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

/** Saves screenshots into a folder, if there is one. */
export function photographer(folder) {
  if (folder) mkdirSync(folder, { recursive: true });
  return (page, name, more) => folder && page.screenshot({ path: join(folder, name + '.png'), ...more });
}

export const DESKTOP = { viewport: { width: 1440, height: 900 } };
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
