//! Finding an adapter that can really draw: each one is opened and tried before it is chosen.
//!
//! Drivers report features that they do not have, and lack features that every picture needs. So an adapter counts only after
//! [`Gpu::probe`] (or a trial of the caller's own) has worked on it. Vulkan, Metal and DirectX come first, then OpenGL; within
//! them discrete GPUs, integrated ones, and at last those that draw on the processor.

use wgpu::{Adapter, Backends, DeviceType, Instance};

use crate::gpu::Gpu;
use crate::gpu_error::{GpuError, RejectedAdapter};
use crate::gpu_options::GpuOptions;

/// An adapter that passed its trial.
#[derive(Clone, Debug)]
pub struct ChosenAdapter<T> {
    /// The adapter, opened.
    pub gpu: Gpu,
    /// What the trial made.
    pub made: T,
    /// The adapters that were tried before it, in order.
    pub rejected: Vec<RejectedAdapter>,
}

impl Gpu {
    /// Opens the best adapter that passes [`probe`](Self::probe); see [`choose_adapter`].
    ///
    /// # Errors
    /// As [`choose_adapter`].
    pub fn new(options: &GpuOptions) -> Result<Self, GpuError> {
        Ok(choose_adapter(options, Self::probe)?.gpu)
    }
}

/// Opens adapters in order of preference until a trial works on one of them.
///
/// The environment may narrow the search: `WGPU_BACKEND`, `WGPU_ADAPTER_NAME`.
///
/// # Errors
/// [`GpuError::NoAdapter`] if there is none, [`GpuError::NoSuchAdapter`] if none has the name asked for, and
/// [`GpuError::NoUsableAdapter`] if every one failed its trial.
pub fn choose_adapter<T>(
    options: &GpuOptions,
    mut trial: impl FnMut(&Gpu) -> Result<T, GpuError>,
) -> Result<ChosenAdapter<T>, GpuError> {
    let find = |backends: Backends| {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
        descriptor.backends &= backends;
        pollster::block_on(Instance::new(descriptor).enumerate_adapters(backends))
    };
    // OpenGL libraries are loaded only if nothing better works.
    let stages = [Backends::PRIMARY, Backends::all() - Backends::PRIMARY];
    choose_from(stages.into_iter().map(find), options, |gpu, _| trial(gpu))
}

/// [`choose_adapter`] among adapters that the caller has found, for a window's surface for example: lists in order of preference.
///
/// # Errors
/// As [`choose_adapter`].
pub fn choose_from<T>(
    found: impl Iterator<Item = Vec<Adapter>>,
    options: &GpuOptions,
    mut trial: impl FnMut(&Gpu, &Adapter) -> Result<T, GpuError>,
) -> Result<ChosenAdapter<T>, GpuError> {
    let wanted = options.wanted_name();
    let (mut known, mut rejected) = (Vec::new(), Vec::new());
    for mut adapters in found {
        adapters.sort_by_key(|adapter| rank(adapter.get_info().device_type));
        for adapter in adapters {
            let info = adapter.get_info();
            let is_wanted = match &wanted {
                Some(name) => info.name.to_lowercase().contains(name),
                None => !options.is_fallback || info.device_type == DeviceType::Cpu,
            };
            let name = format!("{} ({})", info.name, info.backend);
            known.push(info.name);
            if !is_wanted {
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
    Err(match wanted {
        Some(name) => GpuError::NoSuchAdapter { name, known },
        None => GpuError::NoAdapter { is_fallback: options.is_fallback },
    })
}

fn open_and_try<T>(
    adapter: &Adapter,
    trial: &mut impl FnMut(&Gpu, &Adapter) -> Result<T, GpuError>,
) -> Result<(Gpu, T), GpuError> {
    let gpu = Gpu::open(adapter)?;
    let made = trial(&gpu, adapter)?;
    // What the device complained of meanwhile counts, even if the trial did not notice.
    gpu.wait()?;
    Ok((gpu, made))
}

/// Quick adapters first.
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
    fn an_adapter_that_fails_its_trial_is_not_chosen_and_says_what_it_lacks() {
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
        chosen.gpu.probe().expect("it can draw");
    }

    #[test]
    fn what_a_device_reports_during_its_trial_counts_against_it() {
        let writes_past_the_end = |gpu: &Gpu| {
            let buffer = gpu.empty_buffer("small", 16, wgpu::BufferUsages::COPY_DST)?;
            gpu.queue().write_buffer(&buffer, 8, &[0; 16]);
            Ok(())
        };
        let error = choose_adapter(&GpuOptions::default(), writes_past_the_end).unwrap_err();
        assert!(matches!(error, GpuError::NoUsableAdapter { .. }), "{error}");
    }
}
