/* Reads a .striata file and prints its levels, each with half of the triangles of the one before.
 *
 *   level bunny.striata */

#include "striata.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
  StriataLod *lod;
  if (argc != 2 || striata_lod_open(argv[1], &lod) != STRIATA_OK) {
    fprintf(stderr, "%s\n", argc == 2 ? striata_last_error() : "usage: level FILE.striata");
    return 1;
  }
  StriataLevel levels[32];
  int64_t count = striata_lod_halved_levels(lod, levels, 32);
  for (int64_t i = 0; i < count; i++) {
    printf("%9u triangles over the first %9u vertices, error %g\n", levels[i].triangle_count,
           levels[i].vertex_count, (double)levels[i].error);
  }
  if (count > 1) {
    /* The indices of the second level, to draw over the vertices in refinement order. */
    size_t index_count = (size_t)levels[1].triangle_count * 3;
    uint32_t *indices = malloc(index_count * sizeof *indices + 1);
    if (!indices || striata_lod_emit(lod, &levels[1], indices, index_count) < 0) return 1;
    printf("first triangle of the second level: %u %u %u\n", indices[0], indices[1], indices[2]);
    free(indices);
  }
  striata_lod_free(lod);
  return 0;
}
