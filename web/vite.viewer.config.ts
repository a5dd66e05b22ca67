// Builds the viewer page, web/viewer -> crates/striata-viewer/viewer, which the command embeds: one script, and names that contain a
// hash of the contents, so that browsers may keep the files without asking again.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

/** `striata serve` recognizes names that end in a hyphen and 16 hexadecimal digits. */
const HASHED = '[name]-[hash:16]';

export default defineConfig({
  root: 'viewer',
  base: './',
  publicDir: false,
  worker: { format: 'iife' },
  // The page builds levels and reads files with the module that also saves models.
  resolve: { alias: [{ find: /^\.{1,2}\/wasm\/striata-(builder|files)\.js$/, replacement: fileURLToPath(new URL('viewer/wasm/striata-encoder.js', import.meta.url)) }] },
  server: { fs: { allow: ['..'] } },
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
        hashCharacters: 'hex',
        entryFileNames: `viewer-[hash:16].js`,
        assetFileNames: (asset) => (asset.names[0]?.endsWith('.css') ? 'viewer-[hash:16].css' : `${HASHED}[extname]`),
      },
    },
  },
});
