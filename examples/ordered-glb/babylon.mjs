// Loader extension of Babylon.js for STRIATA_order: `registerOrder()` before a file is loaded. Each mesh gets levels with
// `addLODLevel` over its own vertex buffers, at the share of the screen at which their errors cover `PIXELS` pixels.

import { Mesh } from '@babylonjs/core/Meshes/mesh.js';
import { GLTFLoader, registerGLTFExtension } from '@babylonjs/loaders/glTF/2.0/index.js';
import { levelIndices } from './order.mjs';

const PIXELS = 1;

class OrderExtension {
  name = 'STRIATA_order';
  enabled = true;

  constructor(loader) {
    this.loader = loader;
  }

  dispose() {}

  _loadMeshPrimitiveAsync(context, name, node, mesh, primitive, assign) {
    return GLTFLoader.LoadExtensionAsync(context, primitive, this.name, async (place, { targets, levels }) => {
      // The loader expects its mesh before anything is awaited.
      const loading = this.loader._loadMeshPrimitiveAsync(context, name, node, mesh, primitive, assign);
      const accessor = this.loader.gltf.accessors[targets];
      const numbers = await this.loader._loadAccessorAsync(`/accessors/${targets}`, accessor, Uint32Array);
      const full = await loading;
      if (full.isAnInstance) return full;
      const indices = Uint32Array.from(full.getIndices()), scene = full.getScene();
      const radius = full.getBoundingInfo().boundingSphere.radius;
      full.useLODScreenCoverage = true;
      for (const [n, triangles, error] of levels.slice(1).filter((row) => row[1] > 0)) {
        const level = new Mesh(`${full.name}_${triangles}`, scene);
        for (const kind of full.getVerticesDataKinds()) level.setVerticesBuffer(full.getVertexBuffer(kind), false);
        level.setIndices(levelIndices(indices, numbers, n), full.getTotalVertices());
        level.setBoundingInfo(full.getBoundingInfo());
        [level.skeleton, level.morphTargetManager, level.material] = [full.skeleton, full.morphTargetManager, full.material];
        // The sphere covers this share of the screen when the error covers that many pixels.
        const area = scene.getEngine().getRenderWidth() * scene.getEngine().getRenderHeight();
        full.addLODLevel(Math.min(1, (Math.PI * (radius * PIXELS / error) ** 2) / area), level);
      }
      return full;
    });
  }
}

export const registerOrder = () => registerGLTFExtension('STRIATA_order', true, (loader) => new OrderExtension(loader));
