// The viewer page: web/viewer -> crates/striata-viewer/viewer, which the command embeds. One script, plain names.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

const wasm = fileURLToPath(new URL('dist/striata.wasm', import.meta.url));

/** Puts striata.wasm beside the script, as the built page has it, also while developing. */
function wasmBesideScript(): Plugin {
  return {
    name: 'wasm-beside-script',
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        if (!request.url?.split('?')[0]?.endsWith('/striata.wasm')) return next();
        response.setHeader('Content-Type', 'application/wasm');
        response.end(readFileSync(wasm));
      });
    },
    generateBundle() {
      this.emitFile({ type: 'asset', fileName: 'striata.wasm', source: readFileSync(wasm) });
    },
  };
}

export default defineConfig({
  root: 'viewer',
  base: './',
  publicDir: false,
  plugins: [wasmBesideScript()],
  worker: { format: 'iife' },
  build: {
    // The check builds apart from what is committed.
    outDir: process.env['STRIATA_WEB_VIEWER'] ?? '../../crates/striata-viewer/viewer',
    emptyOutDir: true,
    target: 'es2022',
    minify: 'esbuild',
    modulePreload: false,
    cssCodeSplit: false,
    assetsInlineLimit: (file) => !file.endsWith('.wasm'),
    chunkSizeWarningLimit: 2000,
    rollupOptions: {
      output: {
        inlineDynamicImports: true,
        entryFileNames: 'viewer.js',
        assetFileNames: (asset) => (asset.names[0]?.endsWith('.css') ? 'viewer.css' : '[name][extname]'),
      },
    },
  },
});
