// tri_stripper, as bundled with OpenSceneGraph behind TriStripVisitor. Triangles that it leaves as a list
// become strips of one triangle.
#include "list.hpp"

#include <osg/Geometry>
#include <osg/PrimitiveSet>
#include <osgUtil/TriStripVisitor>

int main(int argc, char **argv) {
  if (argc != 3) return 1;
  const TriangleList list = read_list(argv[1]);
  osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array;
  for (std::size_t v = 0; v < list.vertex_count(); ++v) {
    const float *p = &list.positions[3 * v];
    positions->push_back(osg::Vec3(p[0], p[1], p[2]));
  }
  auto build = [&] {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(positions.get());
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, unsigned(list.corners.size()), list.corners.data()));
    return geometry;
  };
  std::vector<std::uint32_t> indices;
  const double ms = best_ms(build, [&](osg::ref_ptr<osg::Geometry> &geometry) {
    osgUtil::TriStripVisitor visitor;
    visitor.setIndexMesh(false);  // vertices are welded already
    visitor.stripify(*geometry);
    indices.clear();
    for (unsigned set = 0; set < geometry->getNumPrimitiveSets(); ++set) {
      const osg::PrimitiveSet *primitives = geometry->getPrimitiveSet(set);
      const unsigned length = primitives->getMode() == GL_TRIANGLE_STRIP ? primitives->getNumIndices() : 3;
      if (primitives->getMode() != GL_TRIANGLE_STRIP && primitives->getMode() != GL_TRIANGLES) {
        std::fprintf(stderr, "primitives of mode %x are not counted\n", unsigned(primitives->getMode()));
        continue;
      }
      for (unsigned first = 0; first + length <= primitives->getNumIndices(); first += length) {
        if (!indices.empty()) indices.push_back(kRestart);
        for (unsigned i = 0; i < length; ++i) indices.push_back(primitives->index(first + i));
      }
    }
  });
  write_strips(argv[2], ms, indices);
}
