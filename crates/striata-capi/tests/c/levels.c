/* Prints counts and checksums of all that the library makes of a mesh, for tests/programs.rs to compare.
 *
 * levels ARRAYS FILE STREAM, where ARRAYS has two 32-bit counts (vertices, indices), positions and indices. */

#include "striata.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void fail(const char *what) {
  fprintf(stderr, "%s: %s\n", what, striata_last_error());
  exit(1);
}

static void check(int64_t result, const char *what) {
  if (result < 0) fail(what);
}

static void *memory(size_t count, size_t size) {
  void *made = malloc(count * size + 1);
  if (!made) exit(2);
  return made;
}

static uint8_t *read_all(const char *path, size_t *count) {
  FILE *file = fopen(path, "rb");
  if (!file) exit(2);
  fseek(file, 0, SEEK_END);
  *count = (size_t)ftell(file);
  rewind(file);
  uint8_t *bytes = memory(*count, 1);
  if (fread(bytes, 1, *count, file) != *count) exit(2);
  fclose(file);
  return bytes;
}

static uint32_t checksum(const void *numbers, int64_t count) {
  uint32_t sum = 2166136261u, number;
  for (int64_t i = 0; i < count; i++) {
    memcpy(&number, (const char *)numbers + 4 * i, 4);
    sum = (sum ^ number) * 16777619u;
  }
  return sum;
}

static void print_level(const StriataLod *lod, const StriataLevel *level) {
  int64_t count = striata_lod_emit(lod, level, NULL, 0);
  check(count, "emit");
  uint32_t *indices = memory((size_t)count, 4);
  check(striata_lod_emit(lod, level, indices, (size_t)count), "emit");
  printf("level %u %u %u %.6g %08x\n", level->step_count, level->vertex_count, level->triangle_count,
         (double)level->error, checksum(indices, count));
  free(indices);
}

static void print_targets(const StriataLod *lod) {
  const int32_t kinds[] = {STRIATA_BY_TRIANGLES, STRIATA_BY_VERTICES, STRIATA_BY_RATIO,
                           STRIATA_BY_ERROR,     STRIATA_BY_DETAIL,   STRIATA_BY_STEPS};
  const double values[] = {100, 100, .25, .01, .5, 7};
  for (int i = 0; i < 6; i++) {
    StriataLevel level;
    check(striata_lod_resolve(lod, kinds[i], values[i], &level), "resolve");
    print_level(lod, &level);
  }
}

static void print_ranges(const StriataLod *lod) {
  StriataLevel levels[4];
  StriataRange ranges[4];
  int64_t level_count = striata_lod_halved_levels(lod, levels, 4);
  check(level_count, "halved levels");
  StriataRangeRequest request = {levels, (size_t)level_count, STRIATA_ALL_GROUPS};
  int64_t count = striata_lod_ranges(lod, &request, NULL, NULL, 0);
  check(count, "ranges");
  uint32_t *indices = memory((size_t)count, 4);
  check(striata_lod_ranges(lod, &request, ranges, indices, (size_t)count), "ranges");
  for (int64_t i = 0; i < level_count; i++) {
    printf("range %u %u %u\n", ranges[i].first_index, ranges[i].index_count, ranges[i].vertex_count);
  }
  printf("ranges %08x\n", checksum(indices, count));
  free(indices);
}

static void print_view(const StriataLod *lod) {
  /* Looks along -z from (0, 0, 3), with a tangent of .5 for half the field of view. */
  StriataCamera camera = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -3, 1},
                          {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1, -1, 0, 0, -1, 0},
                          800,
                          800};
  StriataView *view;
  StriataViewUpdate update;
  check(striata_view_new(lod, &view), "view");
  check(striata_view_update(view, &camera, 2, 0, &update), "update");
  uint32_t *indices = memory(update.index_count, 4);
  check(striata_view_emit(view, indices, update.index_count), "view");
  printf("view %u %08x\n", update.triangle_count, checksum(indices, update.index_count));
  StriataSpan spans[4];
  printf("changes %d", (int)striata_view_changes(view, 0, spans, 4));
  check(striata_view_placed(view, 0, &spans[0], indices, update.index_count), "placed");
  printf(" %08x", checksum(indices, update.index_count));
  check(striata_view_update(view, &camera, 2, 0, NULL), "update");
  printf(" %d\n", (int)striata_view_changes(view, 0, spans, 4));
  striata_view_free(view);
  free(indices);
  StriataLevel level;
  check(striata_lod_resolve_for_camera(lod, &camera, 2, &level), "resolve for a camera");
  print_level(lod, &level);
}

static void print_stream(const char *path) {
  size_t byte_count;
  uint8_t *bytes = read_all(path, &byte_count);
  StriataDecoder *decoder;
  StriataStreamState state;
  check(striata_decoder_new(&decoder), "decoder");
  for (size_t at = 0; at < byte_count; at += 500) {
    check(striata_decoder_push(decoder, bytes + at, byte_count - at < 500 ? byte_count - at : 500), "push");
  }
  check(striata_decoder_state(decoder, &state), "state");
  uint32_t *indices = memory(state.triangle_count, 12);
  float *positions = memory(state.vertex_count, 12);
  check(striata_decoder_indices(decoder, indices, 3 * (size_t)state.triangle_count), "indices");
  check(striata_decoder_positions(decoder, 0, positions, 3 * (size_t)state.vertex_count), "positions");
  printf("stream %d %u %u %08x %08x\n", state.is_complete, state.vertex_count, state.triangle_count,
         checksum(indices, 3 * (int64_t)state.triangle_count),
         checksum(positions, 3 * (int64_t)state.vertex_count));
  StriataLod *lod;
  check(striata_decoder_lod(decoder, &lod), "levels of a stream");
  print_targets(lod);
  striata_lod_free(lod);
  striata_decoder_free(decoder);
  free(bytes);
  free(indices);
  free(positions);
}

static void check_failures(const StriataLod *lod) {
  StriataLevel level = {1, 2, 3, 0, 0};
  uint32_t room[2];
  if (striata_lod_emit(NULL, &level, NULL, 0) != STRIATA_NULL) fail("null");
  if (striata_lod_emit(lod, &level, NULL, 0) != STRIATA_BAD_ARGUMENT) fail("a level of another mesh");
  check(striata_lod_resolve(lod, STRIATA_BY_RATIO, 1, &level), "resolve");
  if (striata_lod_emit(lod, &level, room, 2) != STRIATA_TOO_SMALL) fail("too small");
  printf("failure %s: %s\n", striata_status_name(STRIATA_TOO_SMALL), striata_last_error());
}

int main(int argc, char **argv) {
  if (argc != 4) return 2;
  size_t byte_count;
  uint8_t *bytes = read_all(argv[1], &byte_count);
  uint32_t counts[2];
  memcpy(counts, bytes, 8);
  StriataMeshArrays arrays = {0};
  arrays.vertex_count = counts[0];
  arrays.positions = (const float *)(bytes + 8);
  arrays.index_count = counts[1];
  arrays.indices = (const uint32_t *)(bytes + 8 + 12 * (size_t)counts[0]);
  StriataLod *lod;
  check(striata_lod_build(&arrays, NULL, &lod), "build");
  StriataFacts facts;
  check(striata_lod_facts(lod, &facts), "facts");
  printf("facts %u %u %u\n", facts.vertex_count, facts.triangle_count, facts.coarsest_triangle_count);
  uint32_t *sources = memory(facts.vertex_count, 4);
  check(striata_lod_source_vertices(lod, sources, facts.vertex_count), "source vertices");
  printf("sources %08x", checksum(sources, facts.vertex_count));
  check(striata_lod_targets(lod, sources, facts.vertex_count), "targets");
  printf(" %08x\n", checksum(sources, facts.vertex_count));
  free(sources);
  free(bytes);
  print_targets(lod);
  print_ranges(lod);
  print_view(lod);
  check_failures(lod);
  striata_lod_free(lod);
  check(striata_lod_open(argv[2], &lod), "open");
  print_targets(lod);
  striata_lod_free(lod);
  print_stream(argv[3]);
  return 0;
}
