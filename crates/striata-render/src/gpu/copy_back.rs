//! Reads buffers back from the GPU, waiting until it is done.

use wgpu::BufferUsages;

use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;

/// Maps a buffer created with `MAP_READ` and returns its bytes.
pub(crate) fn read_buffer(gpu: &Gpu, buffer: &wgpu::Buffer) -> Result<Vec<u8>, GpuError> {
    let failed = |e: &dyn std::fmt::Display| GpuError::Failed(e.to_string());
    let (sender, receiver) = std::sync::mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |result| {
        // The receiver is gone only if the wait below has failed, and that error is reported there.
        let _ = sender.send(result);
    });
    gpu.wait()?;
    receiver.recv().map_err(|e| failed(&e))?.map_err(|e| failed(&e))?;
    let bytes = buffer.get_mapped_range(..).map_err(|e| failed(&e))?.to_vec();
    buffer.unmap();
    Ok(bytes)
}

/// Returns the 32-bit words of a buffer created with `COPY_SRC`.
pub(crate) fn copy_back(gpu: &Gpu, buffer: &wgpu::Buffer) -> Result<Vec<u32>, GpuError> {
    let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
    let copy = gpu.empty_buffer("copy", buffer.size(), usage)?;
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, buffer.size());
    gpu.queue.submit([encoder.finish()]);
    let bytes = read_buffer(gpu, &copy)?;
    Ok(bytes.as_chunks().0.iter().map(|&word| u32::from_le_bytes(word)).collect())
}
