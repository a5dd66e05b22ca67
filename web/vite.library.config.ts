// Builds the library, web/src -> web/dist. three stays external; the worker is inlined as text.
import { defineConfig } from 'vite';

export default defineConfig({
  publicDir: false,
  worker: { format: 'iife' },
  build: {
    outDir: 'dist',
    // dist already contains striata.wasm.
    emptyOutDir: false,
    target: 'es2022',
    minify: 'esbuild',
    lib: {
      entry: { striata: 'src/index.ts', core: 'src/core.ts' },
      formats: ['es'],
    },
    rollupOptions: {
      external: ['three', /^three\//],
      output: { entryFileNames: '[name].js', chunkFileNames: '[name].js', manualChunks: undefined },
    },
  },
});
