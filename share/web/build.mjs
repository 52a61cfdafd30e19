// Bundles src/ into dist/: one script, one style sheet, one page, the licences of what is inside. The first line of
// app.js holds the SHA-256 of all sources, so that a test can tell whether dist/ is theirs.
// usage: npm ci && node build.mjs [FOLDER]
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync, mkdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import * as esbuild from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const dist = resolve(process.argv[2] ?? join(here, 'dist'));

/** What dist/ is made of; tests/page/bundle_test.cpp hashes the same files in the same order. */
const sources = ['build.mjs', 'package-lock.json', ...readdirSync(join(here, 'src')).map((name) => 'src/' + name)].sort();
const hash = createHash('sha256');
for (const name of sources) hash.update(name + '\n').update(readFileSync(join(here, name)));
const stamp = 'amiss sources sha256 ' + hash.digest('hex');

const shared = { bundle: true, minify: true, legalComments: 'none', target: 'es2022', absWorkingDir: here, logLevel: 'warning' };
mkdirSync(dist, { recursive: true });
const script = await esbuild.build({
  ...shared, entryPoints: ['src/main.js'], outfile: join(dist, 'app.js'), format: 'iife', metafile: true,
  banner: { js: `/* ${stamp} */` },
});
await esbuild.build({ ...shared, entryPoints: ['src/style.css'], outfile: join(dist, 'app.css') });
writeFileSync(join(dist, 'index.html'), readFileSync(join(here, 'src/index.html')));

const inside = new Set();
for (const input of Object.keys(script.metafile.inputs)) {
  const found = /^node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input);
  if (found) inside.add(found[1]);
}
let licences = 'Software of others in the page of amiss\n';
for (const name of [...inside].sort()) {
  const folder = join(here, 'node_modules', name);
  const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json')));
  if (license !== 'MIT') throw new Error(`${name} is under ${license}, not MIT`);
  licences += `\n${name} ${version}\n\n${readFileSync(join(folder, 'LICENSE'), 'utf8').trim()}\n`;
}
writeFileSync(join(dist, 'LICENSES.txt'), licences);
const bytes = (name) => readFileSync(join(dist, name)).length;
console.log(`app.js ${bytes('app.js')} bytes, app.css ${bytes('app.css')} bytes; inside: ${[...inside].join(', ')}`);
