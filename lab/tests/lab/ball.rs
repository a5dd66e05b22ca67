//! A test fixture: a ball and the model built from it.

use striata::file::{FileModel, WriteOptions, to_striata};
use striata::model::LodStrips;
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::stripify;

use crate::workbench::{Workbench, sphere};

impl Workbench {
    /// A folder with `sphere.obj`, a ball of 512 triangles, and `ball.striata` built from it.
    pub(crate) fn with_ball() -> Self {
        let bench = Self::new();
        bench.write("sphere.obj", sphere(16, 16));
        let mesh = striata_io::read(bench.path("sphere.obj")).expect("a mesh");
        let built = build_sequence(&mesh, &SequenceOptions::default()).expect("a sequence");
        let refinable = &built.refinable;
        let strips = stripify(&refinable.mesh).expect("strips");
        let model = LodStrips::build(refinable, &strips).expect("a model");
        let bytes =
            to_striata(refinable, &[FileModel::LodStrips(&model)], &WriteOptions::default()).expect("a file");
        bench.write("ball.striata", bytes);
        bench
    }
}
