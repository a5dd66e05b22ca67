// Plugin of three.js' GLTFLoader for STRIATA_order: `loader.register((parser) => new OrderPlugin(parser))`.
// Each mesh then has `userData.order` with its table of levels and `show(error)`, which draws the coarsest level whose
// error is at most `error` mesh units. All levels of a mesh share its vertex buffers, so that a switch uploads none.

import { BufferAttribute, BufferGeometry } from 'three';
import { levelIndices, rowForError } from './order.mjs';

export class OrderPlugin {
  name = 'STRIATA_order';

  constructor(parser) {
    this.parser = parser;
  }

  async afterRoot() {
    const { json, associations } = this.parser, levelsOf = new Map();
    for (const [mesh, place] of associations) {
      const primitive = mesh.isMesh && json.meshes[place.meshes]?.primitives[place.primitives ?? 0];
      const order = primitive && primitive.extensions?.[this.name];
      if (!order) continue;
      const { array: targets } = await this.parser.getDependency('accessor', order.targets);
      const full = mesh.geometry;
      if (!levelsOf.has(full)) levelsOf.set(full, new Map([[order.levels[0][0], full]]));
      const made = levelsOf.get(full);
      const level = (n) => {
        const geometry = Object.assign(new BufferGeometry(), { attributes: full.attributes, groups: full.groups });
        Object.assign(geometry, { morphAttributes: full.morphAttributes, boundingSphere: full.boundingSphere });
        geometry.morphTargetsRelative = full.morphTargetsRelative;
        return geometry.setIndex(new BufferAttribute(levelIndices(full.index.array, targets, n), 1));
      };
      const show = (error) => {
        const [n] = rowForError(order.levels, error);
        if (!made.has(n)) made.set(n, level(n));
        mesh.geometry = made.get(n);
      };
      mesh.userData.order = { levels: order.levels, show };
    }
  }
}
