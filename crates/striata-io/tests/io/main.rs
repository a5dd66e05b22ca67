//! Tests of the readers and writers, in one program.

#[cfg(feature = "blocks")]
mod blocks;
#[cfg(all(feature = "gltf", feature = "ply", feature = "obj", feature = "off", feature = "stl"))]
mod cache_order;
mod far_positions;
mod gltf;
mod gltf_compressed;
mod gltf_morphs;
mod gltf_written;
mod gpu_instancing;
mod hostile;
mod meshes;
mod obj;
mod obj_materials;
#[cfg(feature = "pieces")]
mod pieces;
mod ply;
mod ply_textures;
mod scene_edits;
mod scene_hostile;
mod scene_writer;
mod shared_data;
mod stl_off;
#[cfg(feature = "terrain")]
mod terrain;
mod three_mf;
mod tolerance;
mod vtk;
mod written_materials;
