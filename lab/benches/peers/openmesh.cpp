// OpenMesh's StripifierT. Building the half-edge mesh is not timed.
#include "list.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Utils/StripifierT.hh>

#include <memory>

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

int main(int argc, char **argv) {
  if (argc != 3) return 1;
  const TriangleList list = read_list(argv[1]);
  omerr().disable();  // it logs every triangle that it drops; the table counts them
  std::vector<std::uint32_t> indices;
  auto build = [&] {
    auto mesh = std::make_unique<Mesh>();
    std::vector<Mesh::VertexHandle> vertices;
    for (std::size_t v = 0; v < list.vertex_count(); ++v) {
      const float *p = &list.positions[3 * v];
      vertices.push_back(mesh->add_vertex(Mesh::Point(p[0], p[1], p[2])));
    }
    for (std::size_t t = 0; t < list.triangle_count(); ++t) {
      const std::uint32_t *c = &list.corners[3 * t];
      mesh->add_face(vertices[c[0]], vertices[c[1]], vertices[c[2]]);
    }
    return mesh;
  };
  const double ms = best_ms(build, [&](std::unique_ptr<Mesh> &mesh) {
    OpenMesh::StripifierT<Mesh> stripifier(*mesh);
    stripifier.stripify();
    indices.clear();
    for (const auto &strip : stripifier) push_strip(indices, strip);
  });
  write_strips(argv[2], ms, indices);
}
