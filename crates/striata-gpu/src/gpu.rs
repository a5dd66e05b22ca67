//! The device: found once, shared by all that is drawn.

use std::sync::{Arc, Mutex, PoisonError};

use wgpu::{Adapter, AdapterInfo, Device, Features, Queue};

use crate::gl_restart;
use crate::gpu_error::GpuError;

/// What a device must have for a [`FrameClock`](crate::FrameClock).
pub(crate) const TIME_STAMPS: Features =
    Features::TIMESTAMP_QUERY.union(Features::TIMESTAMP_QUERY_INSIDE_ENCODERS);

/// A device and the queue that feeds it.
#[derive(Clone, Debug)]
pub struct Gpu {
    pub(crate) device: Device,
    pub(crate) queue: Queue,
    info: AdapterInfo,
    /// What the device reported beside results, the first of it.
    reported: Arc<Mutex<Option<String>>>,
}

impl Gpu {
    /// Opens an adapter, with those of the [`optional features`](Self::optional_features) that it has. What its device reports
    /// apart from results, no memory above all, is reported by the next [`wait`](Self::wait).
    ///
    /// # Errors
    /// [`GpuError::NoDevice`].
    pub fn open(adapter: &Adapter) -> Result<Self, GpuError> {
        let info = adapter.get_info();
        let descriptor = Self::device_descriptor(adapter);
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|e| GpuError::NoDevice { adapter: info.name.clone(), reason: e.to_string() })?;
        let gpu = Self::from_device(info, device, queue);
        let reported = Arc::clone(&gpu.reported);
        // Unheard, it would be a panic in the middle of whatever is done next.
        gpu.device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            let mut first = reported.lock().unwrap_or_else(PoisonError::into_inner);
            first.get_or_insert_with(|| one_line(&error));
        }));
        Ok(gpu)
    }

    /// A device that a window has opened already, best by [`device_descriptor`](Self::device_descriptor).
    pub fn from_device(info: AdapterInfo, device: Device, queue: Queue) -> Self {
        gl_restart::enable(&device);
        Self { device, queue, info, reported: Arc::default() }
    }

    /// What to ask an adapter for: its own limits, so that large models fit, and the optional features that it has.
    pub fn device_descriptor(adapter: &Adapter) -> wgpu::DeviceDescriptor<'static> {
        wgpu::DeviceDescriptor {
            label: Some("striata"),
            required_features: adapter.features() & Self::optional_features(),
            required_limits: adapter.limits(),
            ..Default::default()
        }
    }

    /// Features that are used where they are there.
    pub fn optional_features() -> Features {
        Features::INDIRECT_FIRST_INSTANCE | TIME_STAMPS
    }

    /// The device.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// Its queue.
    pub fn queue(&self) -> &Queue {
        &self.queue
    }

    /// The adapter: its name, backend and kind.
    pub fn info(&self) -> &AdapterInfo {
        &self.info
    }

    /// The adapter in one line: its name and its backend.
    pub fn name(&self) -> String {
        format!("{} ({})", self.info.name, self.info.backend)
    }

    /// Waits until all that was submitted is done.
    ///
    /// # Errors
    /// [`GpuError::Failed`] where the device is lost, or has reported an error since the last time.
    pub fn wait(&self) -> Result<(), GpuError> {
        self.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| GpuError::Failed(e.to_string()))?;
        let reported = self.reported.lock().unwrap_or_else(PoisonError::into_inner).take();
        reported.map_or(Ok(()), |report| Err(GpuError::Failed(report)))
    }

    /// A buffer that holds a slice; an empty one holds four unused bytes, since a GPU knows no empty buffers.
    pub(crate) fn buffer_of(
        &self,
        what: &'static str,
        data: &[u8],
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, GpuError> {
        let buffer = self.empty_buffer(what, data.len() as u64, usage | wgpu::BufferUsages::COPY_DST)?;
        if !data.is_empty() {
            self.queue.write_buffer(&buffer, 0, data);
        }
        Ok(buffer)
    }

    /// A buffer of zeros.
    pub(crate) fn empty_buffer(
        &self,
        what: &'static str,
        bytes: u64,
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, GpuError> {
        let limits = self.device.limits();
        let limit_bytes = if usage.contains(wgpu::BufferUsages::STORAGE) {
            limits.max_buffer_size.min(limits.max_storage_buffer_binding_size)
        } else {
            limits.max_buffer_size
        };
        if bytes > limit_bytes {
            let adapter = self.info.name.clone();
            return Err(GpuError::TooLarge { what, needed_bytes: bytes, limit_bytes, adapter });
        }
        Ok(self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(what),
            size: bytes.max(4).next_multiple_of(4),
            usage,
            mapped_at_creation: false,
        }))
    }
}

/// An error and what it comes from, which wgpu tells in several lines.
fn one_line(error: &wgpu::Error) -> String {
    let text = error.to_string();
    text.lines().map(str::trim).filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu_options::GpuOptions;

    fn on_processor() -> Gpu {
        let found = Gpu::new(&GpuOptions::default().with_fallback(true));
        found.or_else(|_| Gpu::new(&GpuOptions::default())).expect("an adapter")
    }

    #[test]
    fn what_a_device_reports_is_an_error_once_and_no_panic() {
        let gpu = on_processor();
        let buffer = gpu.empty_buffer("small", 16, wgpu::BufferUsages::COPY_DST).unwrap();
        gpu.queue.write_buffer(&buffer, 8, &[0; 16]);
        let Err(GpuError::Failed(report)) = gpu.wait() else {
            panic!("a write past the end was not reported")
        };
        assert!(!report.contains('\n') && !report.is_empty(), "{report}");
        gpu.wait().expect("it was told once, and nothing else is wrong");
    }

    #[test]
    fn a_name_that_no_adapter_has_is_told_with_those_that_there_are() {
        let name = on_processor().info().name.clone();
        let error = Gpu::new(&GpuOptions::default().with_adapter_name(Some("no such".into()))).unwrap_err();
        let GpuError::NoSuchAdapter { name: asked, known } = &error else { panic!("{error}") };
        assert!(asked == "no such" && known.contains(&name), "{error}");
        assert!(error.to_string().contains(&name), "{error}");
    }
}
