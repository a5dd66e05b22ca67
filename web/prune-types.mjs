// Removes type declarations that users cannot reach from the entry points of the package: node prune-types.mjs

import { existsSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = fileURLToPath(new URL('dist/types', import.meta.url));
const IMPORTED = /(?:from|import\()\s*['"](\.[^'"]+)['"]/g;

const reached = new Set();
const reach = (file) => {
  if (reached.has(file) || !existsSync(file)) return;
  reached.add(file);
  for (const [, path] of readFileSync(file, 'utf8').matchAll(IMPORTED)) {
    reach(join(dirname(file), `${path.replace(/\.[jt]s$/, '')}.d.ts`));
  }
};
['index', 'core'].forEach((entry) => reach(join(folder, `${entry}.d.ts`)));

for (const name of readdirSync(folder, { recursive: true })) {
  if (name.endsWith('.d.ts') && !reached.has(join(folder, name))) rmSync(join(folder, name));
}
