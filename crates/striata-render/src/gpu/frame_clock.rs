//! Measures how long the GPU spends on the commands of one encoder.

use wgpu::{Buffer, BufferUsages, CommandEncoder, Features, QuerySet};

use crate::gpu::copy_back::copy_back;
use crate::gpu::device::{Gpu, TIME_STAMPS};
use crate::gpu::gpu_error::GpuError;

/// Two timestamps around the commands of an encoder.
///
/// Uploads by [`Queue::write_buffer`](wgpu::Queue::write_buffer) run before an encoder's commands and are
/// not included.
#[derive(Debug)]
pub struct FrameClock {
    stamps: QuerySet,
    ticks: Buffer,
    secs_per_tick: f64,
}

impl FrameClock {
    /// Features that the device must have.
    pub const FEATURES: Features = TIME_STAMPS;

    /// Creates a clock, or returns none if the device does not support timestamps.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`], which does not happen on real devices.
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

    /// Records the first timestamp, before the commands to measure.
    pub fn start(&self, encoder: &mut CommandEncoder) {
        encoder.write_timestamp(&self.stamps, 0);
    }

    /// Records the second timestamp, after the commands to measure.
    pub fn stop(&self, encoder: &mut CommandEncoder) {
        encoder.write_timestamp(&self.stamps, 1);
    }

    /// Seconds between the two timestamps. Call it after submitting the encoder; it waits for the GPU.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device is lost.
    pub fn secs(&self, gpu: &Gpu) -> Result<f64, GpuError> {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        encoder.resolve_query_set(&self.stamps, 0..2, &self.ticks, 0);
        gpu.queue.submit([encoder.finish()]);
        let words = copy_back(gpu, &self.ticks)?;
        let (pairs, _) = words.as_chunks::<2>();
        let ticks =
            |at: usize| pairs.get(at).map_or(0, |&[low, high]| u64::from(high) << 32 | u64::from(low));
        Ok(ticks(1).saturating_sub(ticks(0)) as f64 * self.secs_per_tick)
    }
}
