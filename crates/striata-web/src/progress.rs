//! Reports the progress of long operations to a JavaScript object.

use std::ops::ControlFlow;

use striata::Progress;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    /// A JavaScript object with a method `report(phase: string, share: number)`.
    #[wasm_bindgen(typescript_type = "{ report(phase: string, share: number): void }")]
    pub type Sink;

    #[wasm_bindgen(method, structural)]
    fn report(this: &Sink, phase: &str, share: f64);
}

/// Returns a callback that reports each new percentage to a sink.
pub(crate) fn reporter(sink: &Sink) -> impl FnMut(Progress) -> ControlFlow<()> + '_ {
    let mut last = (None, 0);
    move |progress| {
        let share = progress.done as f64 / progress.total.max(1) as f64;
        let step = (Some(progress.phase), (share * 100.0) as u32);
        if step != last {
            last = step;
            sink.report(progress.phase, share.min(1.0));
        }
        ControlFlow::Continue(())
    }
}
