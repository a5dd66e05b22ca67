//! The GPU device and its queue, opened once and shared by everything that is drawn.

use std::sync::{Arc, Mutex, PoisonError};

use wgpu::{Adapter, AdapterInfo, Device, Features, Queue};

use crate::gpu::gl_restart;
use crate::gpu::gpu_error::GpuError;

/// Features that a device needs for a [`FrameClock`](crate::gpu::FrameClock).
pub(crate) const TIME_STAMPS: Features =
    Features::TIMESTAMP_QUERY.union(Features::TIMESTAMP_QUERY_INSIDE_ENCODERS);

/// A wgpu device and its queue.
#[derive(Clone, Debug)]
pub struct Gpu {
    pub(crate) device: Device,
    pub(crate) queue: Queue,
    info: AdapterInfo,
    /// First error that the device has reported asynchronously since the last wait.
    reported: Arc<Mutex<Option<String>>>,
}

impl Gpu {
    /// Opens an adapter. Errors that its device reports asynchronously, out of memory above all, are returned
    /// by the next [`wait`](Self::wait).
    ///
    /// # Errors
    /// [`GpuError::NoDevice`].
    pub fn open(adapter: &Adapter) -> Result<Self, GpuError> {
        let info = adapter.get_info();
        // The adapter's own limits, so that large models fit.
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("striata"),
            required_features: adapter.features() & (Features::INDIRECT_FIRST_INSTANCE | TIME_STAMPS),
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|e| GpuError::NoDevice { adapter: info.name.clone(), reason: e.to_string() })?;
        gl_restart::enable(&device);
        let gpu = Self { device, queue, info, reported: Arc::default() };
        let reported = Arc::clone(&gpu.reported);
        // Without a handler, wgpu panics in the middle of whatever runs next.
        gpu.device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            let mut first = reported.lock().unwrap_or_else(PoisonError::into_inner);
            first.get_or_insert_with(|| one_line(&error));
        }));
        Ok(gpu)
    }

    /// The device.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// The device's queue.
    pub fn queue(&self) -> &Queue {
        &self.queue
    }

    /// The adapter's name, backend and device type.
    pub fn info(&self) -> &AdapterInfo {
        &self.info
    }

    /// The adapter's name and backend in one line.
    pub fn name(&self) -> String {
        format!("{} ({})", self.info.name, self.info.backend)
    }

    /// Waits until all submitted work is done.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device is lost or has reported an error since the last call.
    pub fn wait(&self) -> Result<(), GpuError> {
        self.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| GpuError::Failed(e.to_string()))?;
        let reported = self.reported.lock().unwrap_or_else(PoisonError::into_inner).take();
        reported.map_or(Ok(()), |report| Err(GpuError::Failed(report)))
    }

    /// Compiles compute shaders.
    pub(crate) fn compute_module(&self, label: &'static str, code: &str) -> wgpu::ShaderModule {
        let source = wgpu::ShaderSource::Wgsl(code.into());
        self.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(label), source })
    }

    /// Creates the pipeline of one pass; its layout has the bindings that the pass uses.
    pub(crate) fn compute_pipeline(
        &self,
        module: &wgpu::ShaderModule,
        entry_point: &'static str,
    ) -> wgpu::ComputePipeline {
        self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry_point),
            layout: None,
            module,
            entry_point: Some(entry_point),
            compilation_options: Default::default(),
            cache: None,
        })
    }

    /// Binds those of the buffers, listed by binding, that a pass uses.
    pub(crate) fn bind_compute(
        &self,
        pipeline: &wgpu::ComputePipeline,
        bindings: &[u32],
        buffers: &[&wgpu::Buffer],
    ) -> wgpu::BindGroup {
        let entry = |&binding: &u32| wgpu::BindGroupEntry {
            binding,
            resource: buffers[binding as usize].as_entire_binding(),
        };
        let entries: Vec<wgpu::BindGroupEntry<'_>> = bindings.iter().map(entry).collect();
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &entries,
        })
    }

    /// Creates a buffer that contains `data`, or four unused bytes if `data` is empty, since GPU buffers
    /// cannot be empty.
    pub(crate) fn buffer_of(
        &self,
        label: &'static str,
        data: &[u8],
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, GpuError> {
        let buffer = self.empty_buffer(label, data.len() as u64, usage | wgpu::BufferUsages::COPY_DST)?;
        if !data.is_empty() {
            self.queue.write_buffer(&buffer, 0, data);
        }
        Ok(buffer)
    }

    /// Creates a buffer of zeros.
    pub(crate) fn empty_buffer(
        &self,
        label: &'static str,
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
            return Err(GpuError::TooLarge { what: label, needed_bytes: bytes, limit_bytes, adapter });
        }
        Ok(self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size: bytes.max(4).next_multiple_of(4),
            usage,
            mapped_at_creation: false,
        }))
    }
}

/// Joins the lines of a wgpu error and its causes into one line.
fn one_line(error: &wgpu::Error) -> String {
    let text = error.to_string();
    text.lines().map(str::trim).filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::adapters::{AdapterKind, GpuOptions};

    fn on_processor() -> Gpu {
        let found = Gpu::new(&GpuOptions { kind: AdapterKind::Cpu, ..GpuOptions::default() });
        found.or_else(|_| Gpu::new(&GpuOptions::default())).expect("an adapter")
    }

    #[test]
    fn device_errors_are_reported_once_and_do_not_panic() {
        let gpu = on_processor();
        let buffer = gpu.empty_buffer("small", 16, wgpu::BufferUsages::COPY_DST).unwrap();
        gpu.queue.write_buffer(&buffer, 8, &[0; 16]);
        let Err(GpuError::Failed(report)) = gpu.wait() else {
            panic!("a write past the end was not reported")
        };
        assert!(!report.contains('\n') && !report.is_empty(), "{report}");
        gpu.wait().expect("the error is reported only once");
    }

    #[test]
    fn an_unknown_adapter_name_is_reported_with_the_known_names() {
        let name = on_processor().info().name.clone();
        let options = GpuOptions { adapter_name: Some("no such".into()), ..GpuOptions::default() };
        let error = Gpu::new(&options).unwrap_err();
        let GpuError::NoSuchAdapter { name: asked, known } = &error else { panic!("{error}") };
        assert!(asked == "no such" && known.contains(&name), "{error}");
        assert!(error.to_string().contains(&name), "{error}");
    }
}
