//! placeholder until merge
use super::options::*;
use crate::ProgressFn;
use crate::mesh::Welded;
pub(super) fn simplify_optimal(
    _: &Welded,
    _: &SimplifyOptions,
    _: &mut ProgressFn<'_>,
) -> Result<Simplified, SimplifyError> {
    unreachable!()
}
