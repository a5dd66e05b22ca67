//! Converts one mesh file into another: `cargo run --example convert -- in.obj out.glb`.

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, output] = &arguments[..] else {
        eprintln!("usage: convert IN OUT");
        return ExitCode::from(1);
    };
    match convert(input, output) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(1)
        }
    }
}

fn convert(input: &str, output: &str) -> Result<(), Box<dyn std::error::Error>> {
    let mesh = striata_io::read(input)?;
    striata_io::write(output, &mesh, &striata_io::WriteOptions::default())?;
    eprintln!("{} vertices, {} triangles", mesh.vertex_count(), mesh.triangle_count());
    Ok(())
}
