//! Which adapter is to be opened.

/// Which adapter to take.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct GpuOptions {
    /// Only one that draws on the processor (llvmpipe, WARP, SwiftShader). Default: false, the quickest there is.
    pub is_fallback: bool,
    /// Only one whose name holds this, in any letters. Default: what `WGPU_ADAPTER_NAME` says, or else any.
    pub adapter_name: Option<String>,
}

impl GpuOptions {
    /// Sets [`is_fallback`](Self::is_fallback).
    #[must_use]
    pub fn with_fallback(mut self, is_fallback: bool) -> Self {
        self.is_fallback = is_fallback;
        self
    }

    /// Sets [`adapter_name`](Self::adapter_name).
    #[must_use]
    pub fn with_adapter_name(mut self, adapter_name: Option<String>) -> Self {
        self.adapter_name = adapter_name;
        self
    }

    /// The name asked for, in small letters, unless the processor is to draw.
    pub(crate) fn wanted_name(&self) -> Option<String> {
        let named = self.adapter_name.clone().or_else(|| std::env::var("WGPU_ADAPTER_NAME").ok())?;
        (!named.is_empty() && !self.is_fallback).then(|| named.to_lowercase())
    }
}
