// Draco's MeshStripifier. Building its corner table is timed too, since the library does not accept one.
#include "list.hpp"

#include <draco/mesh/mesh.h>
#include <draco/mesh/mesh_stripifier.h>

#include <iterator>
#include <memory>

int main(int argc, char **argv) {
  if (argc != 3) return 1;
  const TriangleList list = read_list(argv[1]);
  draco::Mesh mesh;
  mesh.set_num_points(std::uint32_t(list.vertex_count()));
  mesh.SetNumFaces(list.triangle_count());
  for (std::size_t t = 0; t < list.triangle_count(); ++t) {
    const std::uint32_t *c = &list.corners[3 * t];
    mesh.SetFace(draco::FaceIndex(std::uint32_t(t)),
                 {draco::PointIndex(c[0]), draco::PointIndex(c[1]), draco::PointIndex(c[2])});
  }
  draco::GeometryAttribute position;
  position.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
  const int id = mesh.AddAttribute(position, true, std::uint32_t(list.vertex_count()));
  for (std::size_t v = 0; v < list.vertex_count(); ++v) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(std::uint32_t(v)), &list.positions[3 * v]);
  }
  std::vector<std::uint32_t> indices;
  bool is_done = true;
  const double ms = best_ms([] { return 0; }, [&](int) {
    indices.clear();
    draco::MeshStripifier stripifier;
    is_done &= stripifier.GenerateTriangleStripsWithPrimitiveRestart(mesh, kRestart, std::back_inserter(indices));
  });
  if (!is_done) {
    std::fprintf(stderr, "Draco does not take %s\n", argv[1]);
    return 1;
  }
  write_strips(argv[2], ms, indices);
}
