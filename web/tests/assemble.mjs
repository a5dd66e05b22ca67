// Assembles the viewer and a model into one self-contained HTML file, as the command does.
//
// Usage: `node tests/assemble.mjs MODEL OUT.html`.

import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { viewerFolder } from './harness.mjs';

/** Returns the page with script, style, wasm and model inlined. */
export function assemble(model, name) {
  const names = readdirSync(viewerFolder);
  const named = (start, end) => names.find((name) => new RegExp(`^${start}-[0-9a-f]+\\.${end}$`).test(name));
  const [scriptName, styleName] = [named('viewer', 'js'), named('viewer', 'css')];
  const read = (file) => readFileSync(join(viewerFolder, file), 'utf8');
  const wasm = (start) => gzipSync(readFileSync(join(viewerFolder, named(start, 'wasm')))).toString('base64');
  // The code must not contain the end tag of its own element.
  const script = read(scriptName).replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
  const data = (id, attributes, text) => `<script type="text/plain" id="${id}"${attributes}>${text}</script>`;
  return read('index.html')
    .replace(new RegExp(`<script type="module"[^>]*src="[^"]*${scriptName}"[^>]*></script>`), () => `<script type="module">${script}</script>`)
    .replace(new RegExp(`<link rel="stylesheet"[^>]*href="[^"]*${styleName}"[^>]*>`), () => `<style>${read(styleName)}</style>`)
    .replace('</body>', () => `${data('striata-wasm', '', wasm('striata'))}${data('striata-builder-wasm', '', wasm('striata-encoder'))}${data('striata-model', ` data-name="${name}"`, model.toString('base64'))}</body>`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [model, out] = process.argv.slice(2);
  writeFileSync(out, assemble(readFileSync(model), basename(model)));
}
