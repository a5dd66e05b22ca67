//! The models of one mesh: those of its file, and those that are built when they are asked for.

use std::cell::OnceCell;

use striata::file::{DecodeError, StriataFile};
use striata::mesh::{IndexedMesh, Steps};
use striata::model::{Fans, LodModel, LodStrips, ModelKind, Mts, PartBytes, Patterns, StageOptions};
use striata::strip::{StripSet, stripify};
use striata_strip::{LiveStrips, RepairOptions};

use crate::Failure;

/// A way of drawing that can be looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    List,
    LiveStrips,
    Model(ModelKind),
}

impl Kind {
    pub(super) fn parse(name: &str) -> Result<Self, Failure> {
        Ok(match name {
            "list" => Self::List,
            "live-strips" => Self::LiveStrips,
            _ => match name.parse().map_err(Failure::unsupported)? {
                ModelKind::Progressive => {
                    return Err(Failure::unsupported("a stream is shown as it is decoded"));
                }
                kind => Self::Model(kind),
            },
        })
    }

    /// Whether it is made from collapses, not from removals of any kind.
    pub(super) fn needs_collapses(self) -> bool {
        matches!(self, Self::LiveStrips | Self::Model(ModelKind::LodStrips | ModelKind::Mts))
    }
}

/// The models, each made once.
#[derive(Debug, Default)]
pub(super) struct InspectedModels {
    strips: OnceCell<StripSet>,
    lod_strips: OnceCell<LodStrips<'static>>,
    mts: OnceCell<Mts<'static>>,
    fans: OnceCell<Fans>,
    patterns: OnceCell<Patterns>,
    stored: Vec<ModelKind>,
}

impl InspectedModels {
    /// Reads the models of a file.
    pub(super) fn stored(file: &StriataFile<'_>) -> Result<Self, DecodeError> {
        Ok(Self {
            strips: cell(file.strips().transpose()?),
            lod_strips: cell(file.lod_strips().transpose()?.map(LodStrips::into_owned)),
            mts: cell(file.mts().transpose()?.map(Mts::into_owned)),
            fans: cell(file.fans().transpose()?),
            patterns: cell(file.patterns().transpose()?),
            stored: ModelKind::ALL.into_iter().filter(|&kind| file.has_model(kind)).collect(),
        })
    }

    pub(super) fn is_stored(&self, kind: Kind) -> bool {
        matches!(kind, Kind::Model(kind) if self.stored.contains(&kind))
    }

    pub(super) fn lod_strips(&self, steps: &Steps) -> Result<&LodStrips<'static>, Failure> {
        made(&self.lod_strips, || {
            let refinable = steps.collapses().ok_or_else(without_collapses)?;
            let of_level = |level: &IndexedMesh| stripify(level).map_err(Failure::corrupt);
            // As strips of a mesh in memory: good strips at every level.
            LodStrips::build_staged(refinable, self.strips(steps)?, &StageOptions::default(), of_level)
        })
    }

    pub(super) fn mts(&self, steps: &Steps) -> Result<&Mts<'static>, Failure> {
        made(&self.mts, || {
            let refinable = steps.collapses().ok_or_else(without_collapses)?;
            Mts::build(refinable, self.strips(steps)?).map_err(Failure::unsupported)
        })
    }

    pub(super) fn fans(&self, steps: &Steps) -> &Fans {
        self.fans.get_or_init(|| match steps {
            Steps::Collapses(refinable) => Fans::build(refinable),
            Steps::Fragments(fragmented) => Fans::build(fragmented),
        })
    }

    pub(super) fn patterns(&self, steps: &Steps) -> Result<&Patterns, Failure> {
        made(&self.patterns, || Patterns::build(&steps.fragments()).map_err(Failure::unsupported))
    }

    /// Strips of the full mesh, to be repaired at every step.
    pub(super) fn live_strips(&self, steps: &Steps) -> Result<LiveStrips<'static>, Failure> {
        let refinable = steps.collapses().ok_or_else(without_collapses)?;
        let (full, strips) = (refinable.sequence.step_count(), self.strips(steps)?);
        let live = LiveStrips::new(refinable, full, strips, &RepairOptions::default());
        Ok(live.map_err(Failure::corrupt)?.into_owned())
    }

    /// The strips of the file, or those of the fast stripifier.
    fn strips(&self, steps: &Steps) -> Result<&StripSet, Failure> {
        made(&self.strips, || stripify(steps.mesh()).map_err(Failure::corrupt))
    }
}

/// Size of a model, bytes.
pub(super) fn size(model: &impl LodModel) -> usize {
    model.bytes().iter().map(|&PartBytes { bytes, .. }| bytes).sum()
}

fn cell<T>(value: Option<T>) -> OnceCell<T> {
    value.map_or_else(OnceCell::new, OnceCell::from)
}

/// The value of a cell, which is made if it is empty.
fn made<T>(cell: &OnceCell<T>, make: impl FnOnce() -> Result<T, Failure>) -> Result<&T, Failure> {
    if let Some(value) = cell.get() {
        return Ok(value);
    }
    let value = make()?;
    Ok(cell.get_or_init(|| value))
}

fn without_collapses() -> Failure {
    Failure::unsupported("this model needs collapses, and the steps of the file are removals")
        .with_hint("choose fans, patterns or the list")
}
