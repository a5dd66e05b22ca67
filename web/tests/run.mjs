// Runs the browser tests and prints a summary. `node tests/run.mjs [NAME]` runs only tests whose name contains NAME.
//
//   STRIATA_BIN    the command, default target/debug/striata
//   CHROMIUM       the browser, default /usr/bin/chromium
//   STRIATA_SHOTS  a folder for screenshots; none by default

import { spawn } from 'node:child_process';
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { temporaryFolder } from './harness.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const notes = temporaryFolder('notes');
const words = ['--test', '--test-reporter=spec', '--test-timeout=7200000'];
if (process.argv[2]) words.push(`--test-name-pattern=${process.argv[2]}`);
words.push(join(here, 'suite.test.mjs'));
const environment = { ...process.env, STRIATA_NOTES: join(notes, 'notes.txt') };
const child = spawn(process.execPath, words, { stdio: 'inherit', cwd: join(here, '..'), env: environment });
for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => child.kill(signal));
child.on('exit', (code) => {
  if (existsSync(environment.STRIATA_NOTES)) {
    process.stdout.write(`\nmeasured in the browser:\n${readFileSync(environment.STRIATA_NOTES, 'utf8')}`);
  }
  rmSync(notes, { recursive: true, force: true });
  process.exitCode = code ?? 1;
});
