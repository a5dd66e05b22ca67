//! Options for choosing an adapter.

/// Constraints on the adapter to open.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct GpuOptions {
    /// Whether to accept only CPU adapters (llvmpipe, WARP, SwiftShader). Default: false, which picks the
    /// fastest adapter.
    pub is_fallback: bool,
    /// Text that the adapter's name must contain, ignoring case. Default: the value of
    /// `WGPU_ADAPTER_NAME`, or else any name.
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

    /// The requested name in lower case; none for CPU adapters.
    pub(crate) fn requested_name(&self) -> Option<String> {
        let named = self.adapter_name.clone().or_else(|| std::env::var("WGPU_ADAPTER_NAME").ok())?;
        (!named.is_empty() && !self.is_fallback).then(|| named.to_lowercase())
    }
}
