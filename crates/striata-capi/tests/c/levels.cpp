// Prints with the C++ header what levels.c prints of levels and ranges, for tests/programs.rs to compare.

#include "striata.hpp"

#include <cstdio>

static uint32_t checksum(const std::vector<uint32_t> &numbers) {
  uint32_t sum = 2166136261u;
  for (uint32_t number : numbers) sum = (sum ^ number) * 16777619u;
  return sum;
}

int main(int argc, char **argv) {
  if (argc != 2) return 2;
  auto lod = striata::Lod::open(argv[1]);
  auto facts = lod.facts();
  std::printf("facts %u %u %u\n", facts.vertex_count, facts.triangle_count, facts.coarsest_triangle_count);
  std::vector<uint32_t> indices;
  for (double ratio : {1.0, .25, .01}) {
    auto level = lod.resolve(STRIATA_BY_RATIO, ratio);
    lod.emit(level, indices);
    std::printf("level %u %u %u %.6g %08x\n", level.step_count, level.vertex_count, level.triangle_count,
                double(level.error), checksum(indices));
  }
  auto levels = lod.halved_levels();
  levels.resize(4);
  auto made = lod.ranges(levels);
  for (auto &range : made.ranges) {
    std::printf("range %u %u %u\n", range.first_index, range.index_count, range.vertex_count);
  }
  std::printf("ranges %08x\n", checksum(made.indices));
  striata::View view(lod);
  view.emit(indices);
  std::printf("view %zu\n", indices.size() / 3);
  if (lod.targets().size() != facts.vertex_count || lod.positions().size() != 3 * facts.vertex_count) return 3;
  try {
    lod.source_vertices();
    return 4;
  } catch (const striata::Error &error) {
    std::printf("failure %d: %s\n", error.status(), error.what());
  }
  striata::Decoder decoder;
  if (decoder.state().vertex_count != 0) return 5;
  return 0;
}
