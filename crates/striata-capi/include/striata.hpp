// striata for C++17: handles that free themselves, vectors, and exceptions. See striata.h for what the functions do.

#ifndef STRIATA_HPP
#define STRIATA_HPP

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "striata.h"

namespace striata {

/// A call that failed, with its status and message.
class Error : public std::runtime_error {
public:
  explicit Error(std::int64_t status) : std::runtime_error(striata_last_error()), status_(int32_t(status)) {}
  int32_t status() const { return status_; }

private:
  int32_t status_;
};

/// Throws if a result is a failure.
inline std::int64_t check(std::int64_t result) {
  if (result < 0) throw Error(result);
  return result;
}

/// Asks for a count, then for the elements: `call(to, capacity)` is one of the functions that write to memory.
template <typename T, typename Call>
void fill(std::vector<T> &to, Call call) {
  to.resize(std::size_t(check(call(static_cast<T *>(nullptr), std::size_t(0)))));
  if (!to.empty()) check(call(to.data(), to.size()));
}

template <typename T, typename Call>
std::vector<T> filled(Call call) {
  std::vector<T> elements;
  fill(elements, call);
  return elements;
}

struct Free {
  void operator()(StriataLod *lod) const { striata_lod_free(lod); }
  void operator()(StriataView *view) const { striata_view_free(view); }
  void operator()(StriataDecoder *decoder) const { striata_decoder_free(decoder); }
};

/// Ranges of one index buffer.
struct Ranges {
  std::vector<StriataRange> ranges;
  std::vector<uint32_t> indices;
};

/// Every level of detail of one mesh.
class Lod {
public:
  explicit Lod(StriataLod *lod) : lod_(lod) {}

  static Lod build(const StriataMeshArrays &arrays, const StriataBuildOptions &options = {}) {
    return make([&](StriataLod **to) { return striata_lod_build(&arrays, &options, to); });
  }
  static Lod open(const std::string &path) {
    return make([&](StriataLod **to) { return striata_lod_open(path.c_str(), to); });
  }
  static Lod open(const uint8_t *bytes, std::size_t count) {
    return make([&](StriataLod **to) { return striata_lod_open_bytes(bytes, count, to); });
  }

  void save(const std::string &path) const { check(striata_lod_save(get(), path.c_str())); }
  StriataFacts facts() const {
    StriataFacts facts;
    check(striata_lod_facts(get(), &facts));
    return facts;
  }
  /// The vertex of the input for each vertex of the new vertex buffer.
  std::vector<uint32_t> source_vertices() const {
    return filled<uint32_t>([&](auto to, auto n) { return striata_lod_source_vertices(get(), to, n); });
  }
  /// The vertex that each vertex collapses to.
  std::vector<uint32_t> targets() const {
    return filled<uint32_t>([&](auto to, auto n) { return striata_lod_targets(get(), to, n); });
  }
  std::vector<float> positions() const {
    return filled<float>([&](auto to, auto n) { return striata_lod_positions(get(), to, n); });
  }
  std::vector<float> attribute(int32_t kind, uint8_t set = 0) const {
    return filled<float>([&](auto to, auto n) { return striata_lod_attribute(get(), kind, set, to, n); });
  }

  /// The level for a target, such as `resolve(STRIATA_BY_TRIANGLES, 5000)`.
  StriataLevel resolve(int32_t kind, double value) const {
    StriataLevel level;
    check(striata_lod_resolve(get(), kind, value, &level));
    return level;
  }
  StriataLevel resolve(const StriataCamera &camera, float pixels) const {
    StriataLevel level;
    check(striata_lod_resolve_for_camera(get(), &camera, pixels, &level));
    return level;
  }
  /// Writes the indices of a level to a vector, whose memory is used again.
  void emit(const StriataLevel &level, std::vector<uint32_t> &indices) const {
    indices.resize(std::size_t(level.triangle_count) * 3);
    check(striata_lod_emit(get(), &level, indices.data(), indices.size()));
  }
  std::vector<StriataRange> groups(const StriataLevel &level) const {
    return filled<StriataRange>([&](auto to, auto n) { return striata_lod_emit_groups(get(), &level, to, n); });
  }
  std::vector<StriataLevel> halved_levels() const {
    return filled<StriataLevel>([&](auto to, auto n) { return striata_lod_halved_levels(get(), to, n); });
  }
  /// Levels as ranges of one index buffer, finer ones first.
  Ranges ranges(const std::vector<StriataLevel> &levels, int32_t group = STRIATA_ALL_GROUPS) const {
    StriataRangeRequest request = {levels.data(), levels.size(), group};
    Ranges made{std::vector<StriataRange>(levels.size()), {}};
    fill(made.indices, [&](auto to, auto n) {
      return striata_lod_ranges(get(), &request, made.ranges.data(), to, n);
    });
    return made;
  }

  StriataLod *get() const { return lod_.get(); }

private:
  template <typename Call>
  static Lod make(Call call) {
    StriataLod *lod = nullptr;
    check(call(&lod));
    return Lod(lod);
  }
  std::unique_ptr<StriataLod, Free> lod_;
};

/// An instance that follows a camera.
class View {
public:
  explicit View(const Lod &lod) {
    StriataView *view = nullptr;
    check(striata_view_new(lod.get(), &view));
    view_.reset(view);
  }
  StriataViewUpdate update(const StriataCamera &camera, float pixels, uint32_t triangle_limit = 0) {
    StriataViewUpdate update;
    check(striata_view_update(get(), &camera, pixels, triangle_limit, &update));
    return update;
  }
  void emit(std::vector<uint32_t> &indices) const {
    fill(indices, [&](auto to, auto n) { return striata_view_emit(get(), to, n); });
  }
  std::vector<StriataRange> groups() const {
    return filled<StriataRange>([&](auto to, auto n) { return striata_view_groups(get(), to, n); });
  }
  /// Updates the placed indices of a group, and returns the parts that have changed.
  std::vector<StriataSpan> changes(uint32_t group = 0) {
    return filled<StriataSpan>([&](auto to, auto n) { return striata_view_changes(get(), group, to, n); });
  }
  /// The placed indices of a group.
  void placed(std::vector<uint32_t> &indices, uint32_t group = 0) const {
    fill(indices, [&](auto to, auto n) { return striata_view_placed(get(), group, nullptr, to, n); });
  }
  StriataView *get() const { return view_.get(); }

private:
  std::unique_ptr<StriataView, Free> view_;
};

/// A stream of which bytes arrive.
class Decoder {
public:
  Decoder() {
    StriataDecoder *decoder = nullptr;
    check(striata_decoder_new(&decoder));
    decoder_.reset(decoder);
  }
  void push(const uint8_t *bytes, std::size_t count) { check(striata_decoder_push(get(), bytes, count)); }
  StriataStreamState state() const {
    StriataStreamState state;
    check(striata_decoder_state(get(), &state));
    return state;
  }
  std::vector<float> positions(std::size_t first_vertex = 0) const {
    return filled<float>([&](auto to, auto n) { return striata_decoder_positions(get(), first_vertex, to, n); });
  }
  void indices(std::vector<uint32_t> &indices) const {
    fill(indices, [&](auto to, auto n) { return striata_decoder_indices(get(), to, n); });
  }
  Lod lod() const {
    StriataLod *lod = nullptr;
    check(striata_decoder_lod(get(), &lod));
    return Lod(lod);
  }
  StriataDecoder *get() const { return decoder_.get(); }

private:
  std::unique_ptr<StriataDecoder, Free> decoder_;
};

}  // namespace striata

#endif
