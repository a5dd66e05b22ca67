// Reads triangle lists and writes strips: the two simple formats that the peers share with `strips_table`.
//
// NAME.triangles: u32 vertex count, u32 triangle count, three f32 per vertex, three u32 per triangle.
// NAME.TOOL.strips: f64 milliseconds, u32 index count, u32 indices with 0xFFFFFFFF between strips.
// All little-endian, like every machine that these libraries are packaged for.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

constexpr std::uint32_t kRestart = 0xFFFFFFFFu;

struct TriangleList {
  std::vector<float> positions;
  std::vector<std::uint32_t> corners;
  std::size_t vertex_count() const { return positions.size() / 3; }
  std::size_t triangle_count() const { return corners.size() / 3; }
};

inline TriangleList read_list(const char *path) {
  std::ifstream file(path, std::ios::binary);
  std::uint32_t counts[2] = {0, 0};
  file.read(reinterpret_cast<char *>(counts), sizeof counts);
  TriangleList list;
  if (file) {
    list.positions.resize(3 * std::size_t(counts[0]));
    list.corners.resize(3 * std::size_t(counts[1]));
    file.read(reinterpret_cast<char *>(list.positions.data()), 4 * list.positions.size());
    file.read(reinterpret_cast<char *>(list.corners.data()), 4 * list.corners.size());
  }
  if (!file) {
    std::fprintf(stderr, "%s is not a triangle list, or is truncated\n", path);
    std::exit(1);
  }
  return list;
}

inline void write_strips(const char *path, double ms, const std::vector<std::uint32_t> &indices) {
  std::ofstream file(path, std::ios::binary);
  const std::uint32_t count = std::uint32_t(indices.size());
  file.write(reinterpret_cast<const char *>(&ms), sizeof ms);
  file.write(reinterpret_cast<const char *>(&count), sizeof count);
  file.write(reinterpret_cast<const char *>(indices.data()), 4 * indices.size());
  if (!file) {
    std::fprintf(stderr, "%s cannot be written\n", path);
    std::exit(1);
  }
}

// Appends a strip, with a restart before it unless it is the first.
inline void push_strip(std::vector<std::uint32_t> &indices, const std::vector<std::uint32_t> &strip) {
  if (!indices.empty()) indices.push_back(kRestart);
  indices.insert(indices.end(), strip.begin(), strip.end());
}

// Fastest of up to five runs, within ten seconds in total. `prepare` creates the input that `work` consumes and is not
// timed.
template <class Prepare, class Work>
double best_ms(Prepare prepare, Work work) {
  double best = 1e300, all = 0;
  for (int run = 0; run < 5 && all < 1e4; ++run) {
    auto made = prepare();
    const auto start = std::chrono::steady_clock::now();
    work(made);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    all += took.count();
    if (took.count() < best) best = took.count();
  }
  return best;
}
