// Assembles the viewer and a model into one self-contained HTML file, as the command does.
//
// Usage: `node tests/assemble.mjs MODEL OUT.html`.

import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { viewerFolder } from './harness.mjs';

/** Returns the page with script, style, wasm and model inlined. */
export function assemble(model, name) {
  const read = (file) => readFileSync(join(viewerFolder, file), 'utf8');
  const wasm = readFileSync(join(viewerFolder, 'striata.wasm')).toString('base64');
  // The code must not contain the end tag of its own element.
  const script = read('viewer.js').replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
  const style = existsSync(join(viewerFolder, 'viewer.css')) ? read('viewer.css') : '';
  const data = (id, attributes, text) => `<script type="text/plain" id="${id}"${attributes}>${text}</script>`;
  return read('index.html')
    .replace(/<script type="module"[^>]*src="[^"]*viewer\.js"[^>]*><\/script>/, () => `<script type="module">${script}</script>`)
    .replace(/<link rel="stylesheet"[^>]*href="[^"]*viewer\.css"[^>]*>/, () => `<style>${style}</style>`)
    .replace('</body>', () => `${data('striata-wasm', '', wasm)}${data('striata-model', ` data-name="${name}"`, model.toString('base64'))}</body>`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [model, out] = process.argv.slice(2);
  writeFileSync(out, assemble(readFileSync(model), basename(model)));
}
