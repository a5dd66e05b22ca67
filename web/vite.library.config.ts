// Builds the library, web/src -> web/dist. three stays external; the worker is inlined as text.
import { defineConfig, transformWithEsbuild } from 'vite';

export default defineConfig({
  publicDir: false,
  // Vite keeps the white space of libraries, a fifth of their size.
  plugins: [{
    name: 'minify',
    enforce: 'post',
    renderChunk: (code, { fileName }) => transformWithEsbuild(code, fileName, { minify: true, format: 'esm', target: 'es2022', sourcemap: false }),
  }],
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
