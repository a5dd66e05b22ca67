/* striata: continuous level of detail for triangle meshes.
 *
 * A `StriataLod` has all levels of one mesh. Its vertices are in refinement order: a level uses the first ones, and all
 * levels draw from one vertex buffer. `striata_lod_source_vertices` has the order, to put your own buffers into.
 *
 * Results: a function returns a status (`STRIATA_OK` or a negative number) or, as `int64_t`, a count, which is negative if
 * it is a status. `striata_last_error` describes the last failure of the thread and names the argument.
 *
 * Memory: arrays belong to the caller, and are used by the call only. Functions with `to` and `capacity`, which count
 * elements, write nothing if `to` is NULL and return the count that is needed; a capacity that is too small is a failure.
 * Handles are freed by their own function, which accepts NULL. If a function that makes a handle fails, the handle is NULL.
 *
 * Threads: any number of threads may use a `StriataLod` at the same time, as long as none frees it. A `StriataView` and a
 * `StriataDecoder` belong to one thread at a time. Building and the first use of a level may use the threads of rayon.
 *
 * A struct whose bytes are all zero has the default of each field.
 */


#ifndef STRIATA_H
#define STRIATA_H

/* Written by cbindgen from the Rust source: `cargo test -p striata-capi --test capi` checks it. */

#include <stddef.h>
#include <stdint.h>

// Number of the binary interface: libraries and headers with the same number fit together.
#define STRIATA_ABI 1

// Floats of 32 bits.
#define STRIATA_F32 0

// Bytes, of which 255 stands for 1.
#define STRIATA_U8 1

// Integers of 16 bits, of which 65,535 stands for 1.
#define STRIATA_U16 2

// The topology may change, so that every level is reached.
#define STRIATA_TOPOLOGY_CHANGE 0

// The topology may change, but each connected part keeps a triangle.
#define STRIATA_TOPOLOGY_KEEP_PARTS 1

// The topology stays.
#define STRIATA_TOPOLOGY_KEEP 2

// Unit normals, 3 components.
#define STRIATA_NORMAL 1

// Unit tangents with handedness, 4 components.
#define STRIATA_TANGENT 2

// Texture coordinates, 2 components.
#define STRIATA_TEXCOORD 3

// Colors, 3 or 4 components.
#define STRIATA_COLOR 4

// At most this many triangles.
#define STRIATA_BY_TRIANGLES 1

// At most this many vertices.
#define STRIATA_BY_VERTICES 2

// At most this share of the triangles, from 0 to 1.
#define STRIATA_BY_RATIO 3

// The coarsest level with at most this error, in units of the mesh.
#define STRIATA_BY_ERROR 4

// This share of all steps, from 0, the coarsest level, to 1, full detail.
#define STRIATA_BY_DETAIL 5

// Exactly this many steps above the coarsest level.
#define STRIATA_BY_STEPS 6

// The level is less than one step from the target.
#define STRIATA_TARGET_REACHED 0

// The target is below the coarsest level.
#define STRIATA_COARSEST_REACHED 1

// The target is above full detail.
#define STRIATA_FULL_REACHED 2

// All groups of a mesh.
#define STRIATA_ALL_GROUPS -1

// Success.
#define STRIATA_OK 0

// A pointer is null that must not be.
#define STRIATA_NULL -1

// An argument is outside of its range.
#define STRIATA_BAD_ARGUMENT -2

// The mesh is inconsistent.
#define STRIATA_BAD_MESH -3

// Bytes are not a file or stream of striata, or they are damaged.
#define STRIATA_BAD_BYTES -4

// The memory of the caller is too small. The message has the size that is needed.
#define STRIATA_TOO_SMALL -5

// A file cannot be read or written.
#define STRIATA_IO -6

// The progress function canceled the call.
#define STRIATA_CANCELED -7

// The object does not have this data.
#define STRIATA_UNAVAILABLE -8

// More bytes have to arrive first.
#define STRIATA_INCOMPLETE -9

// The library failed, which is a bug.
#define STRIATA_INTERNAL -10

// A stream of which bytes arrive. One thread at a time may use it.
typedef struct StriataDecoder StriataDecoder;

// Every level of detail of one mesh. Immutable: threads may share it, as long as none of them frees it.
typedef struct StriataLod StriataLod;

// An instance of a mesh that follows a camera: fine where errors would be visible, coarse elsewhere. One thread at a time
// may use it.
typedef struct StriataView StriataView;

// An attribute of the vertices in memory of the caller.
typedef struct {
  // `STRIATA_NORMAL`, `STRIATA_TANGENT`, `STRIATA_TEXCOORD` or `STRIATA_COLOR`.
  int32_t kind;
  // `STRIATA_F32`, `STRIATA_U8` or `STRIATA_U16`.
  int32_t number_type;
  // Numbers of a vertex, from 1 to 4: 3 for normals, 4 for tangents, 2 for texture coordinates, 3 or 4 for colors.
  uint8_t components;
  // Number of the set of texture coordinates or colors, from 0.
  uint8_t set;
  // Bytes from one vertex to the next; 0 if they follow each other.
  size_t stride;
  // The numbers of the first vertex. They need no alignment.
  const void *data;
} StriataAttribute;

// Triangles and vertices in memory of the caller, which is read by the call only. Zero is a default for all fields that a
// mesh does not need.
typedef struct {
  // Number of vertices.
  size_t vertex_count;
  // Three coordinates of the first vertex. Set either these or `positions_f64`.
  const float *positions;
  // Three coordinates of the first vertex in double precision, for coordinates such as those of surveys. Positions are
  // then relative to an origin, which `striata_lod_facts` has.
  const double *positions_f64;
  // Bytes from one position to the next; 0 if they follow each other.
  size_t position_stride;
  // Number of indices, three for each triangle.
  size_t index_count;
  // The vertices of the triangles, counterclockwise as seen from outside.
  const uint32_t *indices;
  // Number of attributes.
  size_t attribute_count;
  // Attributes of the vertices.
  const StriataAttribute *attributes;
  // Number of groups of triangles, such as materials or submeshes; 0 for one of all triangles.
  size_t group_count;
  // Number of triangles of each group: together all triangles, in order.
  const uint32_t *group_triangle_counts;
} StriataMeshArrays;

// A function that is called from time to time with the amount of work that is done, and that of the current phase. A
// result other than 0 cancels the call. With a `thread_count`, it is called on another thread.
typedef int32_t (*StriataProgressFn)(void *user, uint64_t done, uint64_t total);

// How levels are built. Zero is the default of every field.
typedef struct {
  // 1 for errors that are guaranteed bounds, which makes building several times slower; 0 for estimates.
  int32_t guaranteed_errors;
  // 1 if vertices of the boundary stay, as borders of tiles and modular parts must.
  int32_t lock_boundary;
  // 1 if vertices on seams of attributes move only along the seam.
  int32_t keep_seams;
  // `STRIATA_TOPOLOGY_CHANGE`, `STRIATA_TOPOLOGY_KEEP_PARTS` or `STRIATA_TOPOLOGY_KEEP`.
  int32_t topology;
  // Triangles at which the coarsest level may stop.
  size_t coarsest_triangle_count;
  // Largest error of the coarsest level, in units of the mesh; 0 for no limit.
  double max_error;
  // Number of threads; 0 for those of the process, which rayon starts on first use.
  uint32_t thread_count;
  // Called with the progress, or null.
  StriataProgressFn progress;
  // Passed to the progress function.
  void *user;
} StriataBuildOptions;

// Sizes of a stream, and of the mesh that has arrived.
typedef struct {
  // Vertices that have arrived.
  uint32_t vertex_count;
  // Triangles of the level that has arrived.
  uint32_t triangle_count;
  // Vertices of the whole stream; 0 until its head has arrived.
  uint32_t full_vertex_count;
  // Triangles of the whole stream; 0 until its head has arrived.
  uint32_t full_triangle_count;
  // Bytes of the whole stream; 0 until its head has arrived.
  uint64_t byte_count;
  // Largest distance of the full mesh from the level that has arrived, in units of the mesh.
  float error;
  // 1 if the whole stream has arrived.
  int32_t is_complete;
  // Point that positions are relative to.
  double origin[3];
} StriataStreamState;

// Sizes of a mesh and of its coarsest level.
typedef struct {
  // Vertices at full detail. Equal vertices of the input are one, and vertices without triangles are left out.
  uint32_t vertex_count;
  // Triangles at full detail. Those of the input with two equal corners are left out.
  uint32_t triangle_count;
  // Steps between the coarsest level and full detail.
  uint32_t step_count;
  // Vertices of the coarsest level.
  uint32_t coarsest_vertex_count;
  // Triangles of the coarsest level.
  uint32_t coarsest_triangle_count;
  // Groups of triangles, such as materials; 1 if the mesh has none.
  uint32_t group_count;
  // 1 if errors are guaranteed bounds, 0 if they are estimates.
  int32_t has_guaranteed_errors;
  // 1 if `striata_lod_source_vertices` has the vertices of the input, 0 if the levels come from a file or a stream.
  int32_t has_source_vertices;
  // Error of the coarsest level, in units of the mesh.
  float coarsest_error;
  // Smallest coordinates, relative to the origin; 0 for an empty mesh.
  float min[3];
  // Largest coordinates, relative to the origin; 0 for an empty mesh.
  float max[3];
  // Point that positions are relative to: 0 unless the coordinates are too large for single precision.
  double origin[3];
} StriataFacts;

// A uniform level: its sizes and its error.
typedef struct {
  // Steps above the coarsest level, which identify the level.
  uint32_t step_count;
  // Vertices: the level uses this many from the start of the vertex buffer.
  uint32_t vertex_count;
  // Triangles: a third of the number of indices.
  uint32_t triangle_count;
  // Largest distance of full detail from the level, in units of the mesh.
  float error;
  // `STRIATA_TARGET_REACHED`, `STRIATA_COARSEST_REACHED` or `STRIATA_FULL_REACHED`.
  int32_t stop_reason;
} StriataLevel;

// A camera: the two matrices that a vertex shader gets, and the size of the screen.
//
// Matrices are lists of columns, as in OpenGL, Vulkan and WebGPU. Perspective projections of any convention work, also
// off-center, reversed and infinite ones, and orthographic ones.
typedef struct {
  // From the space of the mesh to the space of the view: the view matrix times the matrix of the object.
  float view[16];
  // From the space of the view to clip space.
  float projection[16];
  // Width of the screen, in pixels.
  uint32_t width;
  // Height of the screen, in pixels.
  uint32_t height;
} StriataCamera;

// A range of an index buffer: a level, or a group of one.
typedef struct {
  // First index of the range.
  uint32_t first_index;
  // Number of indices.
  uint32_t index_count;
  // Vertices that the indices refer to, from the start of the vertex buffer.
  uint32_t vertex_count;
  // Largest distance of full detail from the level, in units of the mesh.
  float error;
} StriataRange;

// Levels that become ranges of one index buffer.
typedef struct {
  // The levels, finer ones first, as `striata_lod_halved_levels` writes them.
  const StriataLevel *levels;
  // Number of levels.
  size_t level_count;
  // Group whose triangles are listed, from 0, or `STRIATA_ALL_GROUPS`.
  int32_t group;
} StriataRangeRequest;

// Sizes of a view, and the work of its last update.
typedef struct {
  // Triangles that the view shows.
  uint32_t triangle_count;
  // Number of indices, three for each triangle.
  uint32_t index_count;
  // Steps that were refined.
  uint32_t refined_count;
  // Steps that were coarsened. If both numbers are 0, the indices are those of the frame before.
  uint32_t coarsened_count;
  // 1 if no error exceeds the tolerance; 0 if the triangle limit kept some.
  int32_t is_complete;
} StriataViewUpdate;

// A part of the placed indices of a view.
typedef struct {
  // First index of the part.
  uint32_t first_index;
  // Number of indices.
  uint32_t index_count;
} StriataSpan;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Returns the version of the library, such as "0.1.0".
const char *striata_version(void);

// Returns the number of the binary interface of the library, to compare with `STRIATA_ABI` of the header.
uint32_t striata_abi(void);

// Builds all levels of a mesh, and writes a handle to `to`, which `striata_lod_free` frees. The options may be null.
int32_t striata_lod_build(const StriataMeshArrays *arrays,
                          const StriataBuildOptions *options,
                          StriataLod **to);

// Creates a decoder without bytes, and writes a handle to `to`, which `striata_decoder_free` frees.
int32_t striata_decoder_new(StriataDecoder **to);

// Decodes the next bytes of a stream (`.stri`), as many as have arrived. After a failure, the decoder accepts no more bytes,
// but keeps the mesh so far.
int32_t striata_decoder_push(StriataDecoder *decoder,
                             const uint8_t *bytes,
                             size_t byte_count);

// Writes the sizes of a stream.
int32_t striata_decoder_state(const StriataDecoder *decoder, StriataStreamState *state);

// Writes the positions of the vertices that have arrived, three numbers each, and returns the number of numbers. Vertices
// keep their places, so that only those from `first_vertex` on need to be copied.
int64_t striata_decoder_positions(const StriataDecoder *decoder,
                                  size_t first_vertex,
                                  float *to,
                                  size_t capacity);

// Writes the indices of the level that has arrived, three for each triangle, and returns their number.
int64_t striata_decoder_indices(const StriataDecoder *decoder, uint32_t *to, size_t capacity);

// Makes all levels of the mesh that has arrived, and writes a handle to `to`, which `striata_lod_free` frees. Its vertices
// are those of the decoder.
int32_t striata_decoder_lod(const StriataDecoder *decoder,
                            StriataLod **to);

// Frees a decoder. Null is allowed.
void striata_decoder_free(StriataDecoder *decoder);

// Writes the sizes of a mesh.
int32_t striata_lod_facts(const StriataLod *lod, StriataFacts *facts);

// Writes for each vertex the vertex of the input that it came from, and returns their number. Copy vertex `to[i]` of your
// vertex buffer to place `i` of a new one, and all levels draw from it.
int64_t striata_lod_source_vertices(const StriataLod *lod,
                                    uint32_t *to,
                                    size_t capacity);

// Writes for each vertex the vertex that it collapses to, and returns their number. Targets have smaller numbers; the
// vertices of the coarsest level have themselves. At a level of `n` vertices, follow the targets of a vertex until it is
// below `n`.
int64_t striata_lod_targets(const StriataLod *lod,
                            uint32_t *to,
                            size_t capacity);

// Writes the positions of all vertices, three numbers each, relative to the origin, and returns the number of numbers.
int64_t striata_lod_positions(const StriataLod *lod,
                              float *to,
                              size_t capacity);

// Writes an attribute of all vertices as floats, and returns the number of numbers, which is a multiple of the number of
// vertices. Integers that stand for fractions become numbers from 0 to 1. `kind` is `STRIATA_NORMAL`, `STRIATA_TANGENT`,
// `STRIATA_TEXCOORD` or `STRIATA_COLOR`; `set` is the number of the texture coordinates or colors.
int64_t striata_lod_attribute(const StriataLod *lod,
                              int32_t kind,
                              uint8_t set,
                              float *to,
                              size_t capacity);

// Reads a `.striata` file, also one that contains a stream, and writes a handle to `to`. The path is UTF-8.
int32_t striata_lod_open(const char *path, StriataLod **to);

// Reads the bytes of a `.striata` file like `striata_lod_open`. The bytes are not needed after the call.
int32_t striata_lod_open_bytes(const uint8_t *bytes, size_t byte_count, StriataLod **to);

// Writes a `.striata` file with all levels. It is complete or not there at all. The path is UTF-8.
int32_t striata_lod_save(const StriataLod *lod, const char *path);

// Frees a mesh with its levels. Views of it stay valid. Null is allowed.
void striata_lod_free(StriataLod *lod);

// Finds the most detailed level that does not exceed a target, or the coarsest one within an error. Takes less than a
// microsecond, so that a frame can choose a level and list its triangles only if it is another one.
int32_t striata_lod_resolve(const StriataLod *lod,
                            int32_t kind,
                            double value,
                            StriataLevel *level);

// Finds the coarsest level whose error covers at most a number of pixels of the screen of a camera, anywhere on the mesh. If
// the camera is within the bounding sphere, that is full detail: use a view there.
int32_t striata_lod_resolve_for_camera(const StriataLod *lod,
                                       const StriataCamera *camera,
                                       float pixels,
                                       StriataLevel *level);

// Writes full detail and levels with half as many triangles each, down to the coarsest: as many as there is room for.
// Returns the number written, or, if `to` is null, the number of levels.
int64_t striata_lod_halved_levels(const StriataLod *lod,
                                  StriataLevel *to,
                                  size_t capacity);

// Writes the indices of a level, three for each triangle, and returns their number. They refer to the vertices in
// refinement order, sorted by group. If `to` is null, nothing is written.
int64_t striata_lod_emit(const StriataLod *lod,
                         const StriataLevel *level,
                         uint32_t *to,
                         size_t capacity);

// Writes the range of each group in the indices of a level, and returns the number of groups, which is at least 1. Takes
// as long as `striata_lod_emit`.
int64_t striata_lod_emit_groups(const StriataLod *lod,
                                const StriataLevel *level,
                                StriataRange *to,
                                size_t capacity);

// Makes levels as ranges of one index buffer, each in an order for the vertex cache. Writes the indices to `to`, a range
// for each level to `ranges` unless that is null, and returns the number of indices. If `to` is null, nothing is written
// to it; with `STRIATA_ALL_GROUPS`, the ranges are then known without making the levels.
int64_t striata_lod_ranges(const StriataLod *lod,
                           const StriataRangeRequest *request,
                           StriataRange *ranges,
                           uint32_t *to,
                           size_t capacity);

// Returns the message of the last call of this thread that failed; empty if none has. The text is valid until the next
// call of the thread.
const char *striata_last_error(void);

// Returns the name of a status, such as "too small"; "unknown status" for other numbers.
const char *striata_status_name(int32_t status);

// Creates an instance that shows the coarsest level, and writes a handle to `to`, which `striata_view_free` frees. The
// mesh may be freed before its views.
int32_t striata_view_new(const StriataLod *lod,
                         StriataView **to);

// Refines whatever the camera sees until no error covers more than this number of pixels of its screen, and coarsens the rest.
// With a triangle limit other than 0, the view shows at most that many triangles, or the coarsest level. `update` may be
// null.
int32_t striata_view_update(StriataView *view,
                            const StriataCamera *camera,
                            float pixels,
                            uint32_t triangle_limit,
                            StriataViewUpdate *update);

// Writes the indices of a view, three for each triangle, and returns their number. They refer to the vertices in refinement
// order, sorted by group.
int64_t striata_view_emit(const StriataView *view,
                          uint32_t *to,
                          size_t capacity);

// Writes the range of each group in the indices of a view, and returns the number of groups, which is at least 1. Their
// vertex count is that of the mesh, and their error is 0, because a view has no uniform one.
int64_t striata_view_groups(const StriataView *view,
                            StriataRange *to,
                            size_t capacity);

// Updates the placed indices of a group to what the view shows, and writes the parts that have changed since they were
// last written. Returns the number of parts: none if nothing has changed.
//
// `striata_view_emit` lists triangles one after another, so that one more moves all those after it. In the placed indices,
// a triangle stays where it is, and new ones take the places of those that have gone. Free places have three equal
// indices, which draw nothing; there are never more than a quarter of them. Groups are counted from 0; a mesh without
// groups has one.
int64_t striata_view_changes(StriataView *view,
                             uint32_t group,
                             StriataSpan *to,
                             size_t capacity);

// Writes a part of the placed indices of a group, which `striata_view_changes` has updated, or all of them if `span` is
// null. Returns the number of indices; that of all is the number to draw.
int64_t striata_view_placed(StriataView *view,
                            uint32_t group,
                            const StriataSpan *span,
                            uint32_t *to,
                            size_t capacity);

// Frees a view. Null is allowed.
void striata_view_free(StriataView *view);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* STRIATA_H */
