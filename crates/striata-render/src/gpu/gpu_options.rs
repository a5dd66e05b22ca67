//! Options for choosing an adapter.

/// Constraints on the adapter to open.
#[derive(Clone, Debug, Default)]
pub struct GpuOptions {
    /// Whether to accept only CPU adapters (llvmpipe, WARP, SwiftShader). Default: false, which picks the
    /// fastest adapter.
    pub is_fallback: bool,
    /// Text that the adapter's name must contain, ignoring case. Default: the value of
    /// `WGPU_ADAPTER_NAME`, or else any name.
    pub adapter_name: Option<String>,
}

impl GpuOptions {
    /// The requested name in lower case; none for CPU adapters.
    pub(crate) fn requested_name(&self) -> Option<String> {
        let named = self.adapter_name.clone().or_else(|| std::env::var("WGPU_ADAPTER_NAME").ok())?;
        (!named.is_empty() && !self.is_fallback).then(|| named.to_lowercase())
    }
}
