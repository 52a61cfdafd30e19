// share/web/dist is, byte for byte, what its sources give.
// Ends with 77 where there is no esbuild (`npm ci` in share/web).
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const web = fileURLToPath(new URL('../../share/web/', import.meta.url));
if (!existsSync(join(web, 'node_modules/esbuild'))) {
  console.log('esbuild is not there: skipped');
  process.exit(77);
}
const made = mkdtempSync(join(tmpdir(), 'amiss-bundle-'));
try {
  const { status, stderr } = spawnSync(process.execPath, [join(web, 'build.mjs'), made], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  assert.deepEqual(readdirSync(join(web, 'dist')).sort(), readdirSync(made).sort());
  for (const name of readdirSync(made)) {
    assert.ok(readFileSync(join(made, name)).equals(readFileSync(join(web, 'dist', name))), `${name} was not made from its sources`);
  }
  console.log('dist is what its sources give');
} finally {
  rmSync(made, { recursive: true });
}
