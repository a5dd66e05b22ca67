// The viewer as one html file that needs nothing else, put together as the command does it.
//
// As a program: `node tests/assemble.mjs MODEL OUT.html`.

import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { viewerFolder } from './harness.mjs';

/** The page with script, style, wasm and model inside. */
export function assemble(model, name) {
  const read = (file) => readFileSync(join(viewerFolder, file), 'utf8');
  const wasm = readFileSync(join(viewerFolder, 'striata.wasm')).toString('base64');
  // A script's end must not be found inside of it.
  const script = read('viewer.js').replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
  const style = existsSync(join(viewerFolder, 'viewer.css')) ? read('viewer.css') : '';
  const data = (id, more, text) => `<script type="text/plain" id="${id}"${more}>${text}</script>`;
  return read('index.html')
    .replace(/<script type="module"[^>]*src="[^"]*viewer\.js"[^>]*><\/script>/, () => `<script type="module">${script}</script>`)
    .replace(/<link rel="stylesheet"[^>]*href="[^"]*viewer\.css"[^>]*>/, () => `<style>${style}</style>`)
    .replace('</body>', () => `${data('striata-wasm', '', wasm)}${data('striata-model', ` data-name="${name}"`, model.toString('base64'))}</body>`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [model, out] = process.argv.slice(2);
  writeFileSync(out, assemble(readFileSync(model), basename(model)));
}
