//! Passes over a finished glTF document: quantization, and compression with meshoptimizer or Draco.
//!
//! A pass takes any document as JSON and binary data, whoever wrote it, and changes what it understands.
//! Data that are damaged, or that an unknown extension may refer to, stay as they are, so a pass never
//! fails. All passes read through a snapshot of the document with the accessors of the reader, collect new
//! accessors and views in `additions`, put references to them into the document, and finally let `compact`
//! drop what nothing refers to any more.
//!
//! - `quantize`: floats become small integers (`KHR_mesh_quantization`).
//! - `meshopt`: buffer views are compressed (`EXT_meshopt_compression`), after vertices and triangles have
//!   been put into a better order.
//! - `draco`: primitives are compressed (`KHR_draco_mesh_compression`).
//! - `gather`: views of one kind are joined if there are many.
//!
//! The `references` and `extensions` of the reader know where documents refer to accessors and buffer views,
//! and which extensions add no other places.

mod additions;
mod compact;
mod draco;
mod elements;
mod extensions;
mod gather;
mod meshopt;
mod parts;
mod primitives;
mod quantize;
#[cfg(test)]
mod tests;

use crate::WriteOptions;
use crate::error::Refusal;
use crate::report::Warnings;
use draco::draco;
#[cfg(feature = "draco")]
pub use draco::encode_draco;
use gather::gather;
use meshopt::meshopt;
pub(crate) use parts::{GltfParts, WrittenArray};
use quantize::{Texcoords, quantize};

impl GltfParts {
    /// Runs the passes that the options ask for, and warns if rounding makes many vertices fall on others.
    ///
    /// # Errors
    /// If the options contradict each other, or this build lacks a compression.
    pub(crate) fn apply(&mut self, options: &WriteOptions, warnings: &mut Warnings) -> Result<(), Refusal> {
        if options.draco && options.meshopt {
            let reason = "it cannot be compressed with both Draco and meshoptimizer".to_owned();
            return Err(Refusal::Unsupported(reason));
        }
        for (is_wanted, is_on, feature) in [
            (options.meshopt, cfg!(feature = "meshopt"), "meshopt"),
            (options.draco, cfg!(feature = "draco"), "draco"),
        ] {
            if is_wanted && !is_on {
                let reason = format!("this build cannot compress it: the feature `{feature}` is off");
                return Err(Refusal::Unsupported(reason));
            }
        }
        if options.draco || options.quantize.is_some() || options.meshopt {
            self.parse_written()?;
        }
        if options.draco {
            // Draco quantizes by itself.
            draco(self, options.quantize.as_ref(), warnings);
            return Ok(());
        }
        if let Some(quantization) = &options.quantize {
            let texcoords = if options.meshopt { Texcoords::Floats } else { Texcoords::Integers };
            quantize(self, quantization, texcoords, warnings);
        }
        if options.meshopt {
            meshopt(self, options.quantize.as_ref());
        }
        gather(self)
    }
}
