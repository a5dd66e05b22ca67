//! How long the GPU itself was at work on what an encoder recorded.

use wgpu::{Buffer, BufferUsages, CommandEncoder, Features, QuerySet};

use crate::copy_back::copy_back;
use crate::gpu::{Gpu, TIME_STAMPS};
use crate::gpu_error::GpuError;

/// Two time stamps around the commands of an encoder.
///
/// Transfers that the queue makes before an encoder's commands, of [`Queue::write_buffer`](wgpu::Queue::write_buffer), are not
/// between them.
#[derive(Debug)]
pub struct FrameClock {
    stamps: QuerySet,
    ticks: Buffer,
    secs_per_tick: f64,
}

impl FrameClock {
    /// What the device must have.
    pub const FEATURES: Features = TIME_STAMPS;

    /// A clock; none where the device has no time stamps.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`]; never, on any real device.
    pub fn new(gpu: &Gpu) -> Result<Option<Self>, GpuError> {
        if !gpu.device.features().contains(Self::FEATURES) {
            return Ok(None);
        }
        let stamps = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("frame"),
            ty: wgpu::QueryType::Timestamp,
            count: 2,
        });
        let usage = BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC;
        let ticks = gpu.empty_buffer("time stamps", 16, usage)?;
        let secs_per_tick = f64::from(gpu.queue.get_timestamp_period()) * 1e-9;
        Ok(Some(Self { stamps, ticks, secs_per_tick }))
    }

    /// Before the first command.
    pub fn start(&self, encoder: &mut CommandEncoder) {
        encoder.write_timestamp(&self.stamps, 0);
    }

    /// After the last command.
    pub fn stop(&self, encoder: &mut CommandEncoder) {
        encoder.write_timestamp(&self.stamps, 1);
    }

    /// Seconds between the two, once what was recorded is submitted; waits for it.
    ///
    /// # Errors
    /// [`GpuError::Failed`] where the device is lost.
    pub fn secs(&self, gpu: &Gpu) -> Result<f64, GpuError> {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        encoder.resolve_query_set(&self.stamps, 0..2, &self.ticks, 0);
        gpu.queue.submit([encoder.finish()]);
        let words = copy_back(gpu, &self.ticks)?;
        let (words, _) = words.as_chunks::<2>();
        let ticks =
            |at: usize| words.get(at).map_or(0, |&[low, high]| u64::from(high) << 32 | u64::from(low));
        Ok(ticks(1).saturating_sub(ticks(0)) as f64 * self.secs_per_tick)
    }
}
