// Builds the viewer page, web/viewer -> crates/striata-viewer/viewer, which the command embeds: one script with plain file names.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

const wasm = fileURLToPath(new URL('dist/striata.wasm', import.meta.url));

/** Serves striata.wasm next to the script during development, and copies it there for the build. */
function wasmNextToScript(): Plugin {
  return {
    name: 'wasm-next-to-script',
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
  plugins: [wasmNextToScript()],
  worker: { format: 'iife' },
  build: {
    // The check builds into another folder than the committed one.
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
