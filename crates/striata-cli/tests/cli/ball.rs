//! A workbench that contains a mesh and a .striata file built from it.

use crate::workbench::{Workbench, sphere};

impl Workbench {
    /// Creates a folder with `sphere.obj`, a ball of 512 triangles, and `ball.striata` built from it.
    pub(crate) fn with_ball() -> Self {
        let bench = Self::new();
        bench.write("sphere.obj", sphere(16, 16));
        bench.run("build sphere.obj -o ball.striata --quiet").success();
        bench
    }
}
