//! A ball that was built before a test begins.

use crate::workbench::{Workbench, sphere};

impl Workbench {
    /// A folder with `sphere.obj`, a ball of 512 triangles, and `ball.striata` built from it.
    pub(crate) fn with_ball() -> Self {
        let bench = Self::new();
        bench.write("sphere.obj", sphere(16, 16));
        bench.run("build sphere.obj -o ball.striata --quiet").success();
        bench
    }
}
