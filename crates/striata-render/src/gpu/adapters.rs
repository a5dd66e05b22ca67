//! Chooses an adapter that can really draw: each one is opened and tried before it is accepted.
//!
//! Drivers report features that they do not have and lack features that every picture needs, so an adapter
//! is accepted only after [`Gpu::probe`] (or the caller's own trial) has succeeded on it. Vulkan, Metal and
//! DirectX come first, then OpenGL; within each, discrete GPUs come first, then integrated ones, and CPU
//! adapters last.

use wgpu::{Adapter, Backends, DeviceType, Instance};

use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::{GpuError, RejectedAdapter};

/// Constraints on the adapter to open.
#[derive(Clone, Debug, Default)]
pub struct GpuOptions {
    /// Kind of adapters to accept. Default: all, of which the fastest is picked.
    pub kind: AdapterKind,
    /// Text that the adapter's name must contain, ignoring case. Default: the value of
    /// `WGPU_ADAPTER_NAME`, or else any name.
    pub adapter_name: Option<String>,
}

/// Kind of adapters that may be opened; a requested name goes before [`Any`](Self::Any) and [`Gpu`](Self::Gpu).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AdapterKind {
    /// All adapters.
    #[default]
    Any,
    /// Hardware.
    Gpu,
    /// Drivers that draw on the CPU: llvmpipe, WARP, SwiftShader.
    Cpu,
}

impl AdapterKind {
    fn words(self) -> &'static str {
        match self {
            Self::Any => "graphics adapter",
            Self::Gpu => "GPU",
            Self::Cpu => "CPU graphics adapter",
        }
    }
}

impl GpuOptions {
    /// The requested name in lower case; none for CPU adapters.
    fn requested_name(&self) -> Option<String> {
        let named = self.adapter_name.clone().or_else(|| std::env::var("WGPU_ADAPTER_NAME").ok())?;
        (!named.is_empty() && self.kind != AdapterKind::Cpu).then(|| named.to_lowercase())
    }
}

/// An adapter that passed its trial.
#[derive(Clone, Debug)]
pub struct ChosenAdapter<T> {
    /// The opened adapter.
    pub gpu: Gpu,
    /// Value returned by the trial.
    pub made: T,
    /// Adapters that were tried before this one and failed, in order.
    pub rejected: Vec<RejectedAdapter>,
}

impl Gpu {
    /// Opens the best adapter that passes [`probe`](Self::probe); see [`choose_adapter`].
    ///
    /// # Errors
    /// Fails like [`choose_adapter`].
    pub fn new(options: &GpuOptions) -> Result<Self, GpuError> {
        Ok(choose_adapter(options, Self::probe)?.gpu)
    }
}

/// Opens adapters in order of preference until the trial succeeds on one of them.
///
/// The environment variables `WGPU_BACKEND` and `WGPU_ADAPTER_NAME` narrow the search.
///
/// # Errors
/// [`GpuError::NoAdapter`] if none was found, [`GpuError::NoSuchAdapter`] if none has the requested name,
/// and [`GpuError::NoUsableAdapter`] if every candidate failed its trial.
pub fn choose_adapter<T>(
    options: &GpuOptions,
    mut trial: impl FnMut(&Gpu) -> Result<T, GpuError>,
) -> Result<ChosenAdapter<T>, GpuError> {
    let find = |&backends: &Backends| {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
        descriptor.backends &= backends;
        pollster::block_on(Instance::new(descriptor).enumerate_adapters(backends))
    };
    // OpenGL libraries are loaded only if nothing better works.
    let stages = [Backends::PRIMARY, Backends::all() - Backends::PRIMARY];
    let requested = options.requested_name();
    let (mut known, mut rejected) = (Vec::new(), Vec::new());
    for mut adapters in stages.iter().map(find) {
        adapters.sort_by_key(|adapter| rank(adapter.get_info().device_type));
        for adapter in adapters {
            let info = adapter.get_info();
            let is_requested = match &requested {
                Some(name) => info.name.to_lowercase().contains(name),
                None => match options.kind {
                    AdapterKind::Any => true,
                    AdapterKind::Gpu => info.device_type != DeviceType::Cpu,
                    AdapterKind::Cpu => info.device_type == DeviceType::Cpu,
                },
            };
            let name = format!("{} ({})", info.name, info.backend);
            known.push(info.name);
            if !is_requested {
                continue;
            }
            match open_and_try(&adapter, &mut trial) {
                Ok((gpu, made)) => return Ok(ChosenAdapter { gpu, made, rejected }),
                Err(error) => rejected.push(RejectedAdapter { name, reason: error.reason() }),
            }
        }
    }
    if !rejected.is_empty() {
        return Err(GpuError::NoUsableAdapter { rejected });
    }
    known.sort();
    known.dedup();
    Err(match requested {
        Some(name) => GpuError::NoSuchAdapter { name, known },
        None => GpuError::NoAdapter { wanted: options.kind.words() },
    })
}

fn open_and_try<T>(
    adapter: &Adapter,
    trial: &mut impl FnMut(&Gpu) -> Result<T, GpuError>,
) -> Result<(Gpu, T), GpuError> {
    let gpu = Gpu::open(adapter)?;
    let made = trial(&gpu)?;
    // Errors that the device reported asynchronously count as a failed trial.
    gpu.wait()?;
    Ok((gpu, made))
}

/// Sort key of an adapter: faster kinds first.
fn rank(kind: DeviceType) -> u8 {
    match kind {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        DeviceType::Other => 3,
        DeviceType::Cpu => 4,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fails<T>(_: &Gpu) -> Result<T, GpuError> {
        Err(GpuError::Failed("wgpu error: Downlevel flags DownlevelFlags(VIEW_FORMATS) are required".into()))
    }

    #[test]
    fn a_failed_trial_rejects_the_adapter_and_names_the_missing_feature() {
        let error = choose_adapter(&GpuOptions::default(), fails::<()>).unwrap_err();
        let GpuError::NoUsableAdapter { rejected } = &error else { panic!("{error}") };
        assert!(!rejected.is_empty());
        assert!(rejected.iter().all(|r| r.reason == "it lacks VIEW_FORMATS"), "{rejected:?}");
        assert!(error.to_string().contains(&rejected[0].name), "{error}");
    }

    #[test]
    fn the_next_adapter_is_tried_after_one_that_fails() {
        let count = |options: &GpuOptions| match choose_adapter(options, fails::<()>) {
            Err(GpuError::NoUsableAdapter { rejected }) => rejected.len(),
            other => panic!("{other:?}"),
        };
        let all = count(&GpuOptions::default());
        let mut tries = 0;
        let chosen = choose_adapter(&GpuOptions::default(), |gpu| {
            tries += 1;
            if tries < all { fails(gpu) } else { Ok(tries) }
        })
        .expect("the last one passes");
        assert_eq!((chosen.made, chosen.rejected.len()), (all, all - 1));
        chosen.gpu.probe().expect("the chosen adapter can draw");
    }

    #[test]
    fn device_errors_during_the_trial_reject_the_adapter() {
        let writes_past_the_end = |gpu: &Gpu| {
            let buffer = gpu.empty_buffer("small", 16, wgpu::BufferUsages::COPY_DST)?;
            gpu.queue().write_buffer(&buffer, 8, &[0; 16]);
            Ok(())
        };
        let error = choose_adapter(&GpuOptions::default(), writes_past_the_end).unwrap_err();
        assert!(matches!(error, GpuError::NoUsableAdapter { .. }), "{error}");
    }
}
