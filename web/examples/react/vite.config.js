import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  esbuild: { jsx: 'automatic' },
  // One copy of three.js for everybody, also for packages that are linked.
  resolve: { dedupe: ['three', 'react', 'react-dom'] },
  // The development server must not move striata.js away from its wasm file.
  optimizeDeps: { exclude: ['striata'] },
  build: { target: 'es2022', chunkSizeWarningLimit: 2000 },
});
