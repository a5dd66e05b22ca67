//! Vertices that the shader blends have the positions computed on the CPU: equal pictures at every blend
//! and frame.

mod support;

use striata::mesh::{AttributeLayer, ColorSpace, IndexedMesh, Random, RefinableMesh, Semantic, shapes};
use striata::model::{FanInstance, FanMorphs, Fans, Geomorph, LodModel};
use striata::simplify::build_sequence;
use striata_gpu::{
    Canvas, Drawing, Gpu, GpuIndices, GpuMorph, GpuVertices, Look, Painter, Picture, Scene, Viewpoint, wgpu,
};
use support::{differing_pixels, drawn_pixels, gpu};

const SIZE: [u32; 2] = [240, 200];

/// Builds a mesh with normals and colors as layers, so that the CPU can blend them, too.
fn with_layers(mut mesh: IndexedMesh) -> RefinableMesh {
    let bounds = mesh.bounds().unwrap();
    let middle: [f32; 3] = std::array::from_fn(|k| (bounds.min[k] + bounds.max[k]) / 2.0);
    let normals = mesh.positions.iter().enumerate().flat_map(|(v, p)| {
        // Strongly tilted, so that a wrong normal is visible.
        let tilt = [(v % 7) as f32 / 4.0 - 0.75, (v % 5) as f32 / 3.0 - 0.6, 0.3];
        let out: [f32; 3] =
            std::array::from_fn(|k| p[k] - middle[k] + tilt[k] * bounds.diagonal() as f32 / 4.0);
        let length = out.iter().map(|x| x * x).sum::<f32>().sqrt().max(1e-9);
        out.map(|x| x / length)
    });
    let normals = normals.collect();
    let colors = (0..mesh.vertex_count())
        .flat_map(|v| [0.2 + 0.7 * (v % 3) as f32 / 2.0, 0.3 + 0.6 * (v % 4) as f32 / 3.0, 0.5]);
    let colors = colors.collect();
    // Colors are blended as light.
    mesh.appearance.color_space = ColorSpace::Linear;
    mesh.layers = vec![
        AttributeLayer::from_f32(Semantic::Normal, 3, normals),
        AttributeLayer::from_f32(Semantic::Color(0), 3, colors),
    ];
    build_sequence(&mesh, &Default::default()).unwrap().refinable
}

/// Blends on the CPU and the GPU, and draws both.
struct MorphTest<'a> {
    gpu: &'a Gpu,
    painter: &'a Painter,
    canvas: Canvas,
    refinable: &'a RefinableMesh,
    fans: Fans,
    vertices: GpuVertices,
    scene: Scene,
    view: Viewpoint,
    morph: GpuMorph,
    /// The full mesh with its vertices blended on the CPU.
    blended: IndexedMesh,
    normals: Vec<f32>,
    colors: Vec<f32>,
}

const LOOK: fn() -> Look = || Look::default().with_groups(false);

impl<'a> MorphTest<'a> {
    fn new(gpu: &'a Gpu, painter: &'a Painter, refinable: &'a RefinableMesh) -> Self {
        let vertices = GpuVertices::upload(gpu, &refinable.mesh).unwrap();
        let view = Viewpoint::portrait(&refinable.mesh.bounds().unwrap(), 0.7, 0.35, 0.6);
        Self {
            scene: painter.scene(gpu, &vertices, (&view, SIZE), &LOOK()).unwrap(),
            morph: GpuMorph::new(gpu, painter, &vertices).unwrap(),
            canvas: Canvas::new(gpu, SIZE, 1).unwrap(),
            fans: Fans::build(refinable),
            blended: refinable.mesh.clone(),
            normals: plain(&refinable.mesh, 0),
            colors: plain(&refinable.mesh, 1),
            gpu,
            painter,
            refinable,
            vertices,
            view,
        }
    }

    /// Draws an instance with vertices blended by the shader and by the CPU, and compares the pictures.
    fn compare(&mut self, drawn: &FanInstance, what: &str) -> Picture {
        self.blended.layers[0] = AttributeLayer::from_f32(Semantic::Normal, 3, self.normals.clone());
        self.blended.layers[1] = AttributeLayer::from_f32(Semantic::Color(0), 3, self.colors.clone());
        let mut indices = Vec::new();
        drawn.indices_into(&self.fans, &mut indices);
        let whole = 0..indices.len() as u32;
        let indices = GpuIndices::upload(self.gpu, &indices).unwrap();
        let list = Drawing::List { indices: &indices, groups: std::slice::from_ref(&whole) };
        let background = LOOK().background;
        let paint =
            |p: &mut wgpu::RenderPass<'_>| self.painter.draw_morphing(p, &self.scene, &self.morph, list);
        let by_shader = self.canvas.paint(self.gpu, background, paint).unwrap();
        let vertices = GpuVertices::upload(self.gpu, &self.blended).unwrap();
        let scene = self.painter.scene(self.gpu, &vertices, (&self.view, SIZE), &LOOK()).unwrap();
        let paint = |p: &mut wgpu::RenderPass<'_>| self.painter.draw(p, &scene, &vertices, list);
        let by_cpu = self.canvas.paint(self.gpu, background, paint).unwrap();
        assert!(drawn_pixels(&by_shader) > 2000, "{what}: too little was drawn");
        // The GPU rounds colors to bytes before blending, the CPU after.
        let differing = differing_pixels(&by_shader, &by_cpu, 6);
        // Overlapping triangles in one plane are ordered by the last bit of their depth.
        assert!(differing <= 20, "{what}: {differing} pixels differ");
        by_shader
    }

    fn between(&mut self, from: &FanInstance, to: &FanInstance, what: &str) {
        let (sequence, mesh) = (&self.refinable.sequence, &self.refinable.mesh);
        let morph = Geomorph::between(sequence, from, to);
        self.morph.begin(self.gpu, &morph).unwrap();
        let mut seen = Vec::new();
        for blend in [0.0, 0.2, 0.5, 0.85, 1.0] {
            self.morph.set_blend(self.gpu, blend);
            self.blended.positions.clone_from(&mesh.positions);
            morph.blend_into(blend, &mesh.positions, &mut self.blended.positions);
            self.normals = plain(mesh, 0);
            morph.blend_layer_into(blend, &mesh.layers[0], &mut self.normals);
            self.colors = plain(mesh, 1);
            morph.blend_layer_into(blend, &mesh.layers[1], &mut self.colors);
            seen.push(self.compare(morph.drawn(), what));
        }
        let ends = differing_pixels(&seen[0], &seen[4], 6);
        assert!(ends > 1000, "{what}: nothing moves, {ends} pixels");
    }
}

fn plain(mesh: &IndexedMesh, layer: usize) -> Vec<f32> {
    let layer = &mesh.layers[layer];
    (0..mesh.vertex_count()).flat_map(|v| (0..3).map(move |k| layer.get(v, k))).collect()
}

/// A cylinder curved in both directions: on a straight one, moving triangles lie in one plane and hide
/// each other.
fn vase() -> IndexedMesh {
    let mut mesh = shapes::uv_cylinder(40, 12);
    for p in &mut mesh.positions {
        let bulge = 1.0 + 0.3 * (4.0 * (p[0] + p[1] + p[2])).sin();
        *p = [p[0] * bulge, p[1], p[2] * bulge];
    }
    mesh
}

fn meshes() -> [(&'static str, IndexedMesh); 3] {
    [("sphere", shapes::icosphere(4, 1.0)), ("torus", shapes::torus(24, 40, 2.0, 0.8)), ("vase", vase())]
}

#[test]
fn morphs_between_levels_match_the_cpu() {
    let gpu = gpu();
    let painter = Painter::new(&gpu, Canvas::FORMAT, 1);
    for (name, mesh) in meshes() {
        let refinable = with_layers(mesh);
        let mut test = MorphTest::new(&gpu, &painter, &refinable);
        let step_count = test.fans.step_count();
        let level = |share: usize| FanInstance::uniform(&test.fans, step_count * share / 100);
        let [coarse, middle, fine] = [level(10), level(40), level(100)];
        test.between(&coarse, &fine, name);
        test.between(&fine, &middle, name);
        // Two sets of steps of which neither contains the other, so that some vertices appear and some
        // vanish.
        let mut random = Random::new(7);
        let mut other = middle.clone();
        for _ in 0..step_count / 6 {
            let step = random.below(step_count as u32);
            match random.below(2) {
                0 => other.collapse(&test.fans, step),
                _ => other.split(&test.fans, step),
            };
        }
        let morph = Geomorph::between(&refinable.sequence, &middle, &other);
        assert!(!morph.appearing().is_empty() && !morph.vanishing().is_empty());
        test.between(&middle, &other, name);
        assert!(test.morph.uploaded_bytes() < 200 * test.vertices.vertex_count() as u64);
    }
}

#[test]
fn morphs_that_follow_a_view_match_the_cpu() {
    let gpu = gpu();
    let painter = Painter::new(&gpu, Canvas::FORMAT, 1);
    for (name, mesh) in meshes() {
        let refinable = with_layers(mesh);
        let (sequence, mesh) = (&refinable.sequence, &refinable.mesh);
        let mut test = MorphTest::new(&gpu, &painter, &refinable);
        let step_count = test.fans.step_count();
        let mut morphs = FanMorphs::new(&FanInstance::uniform(&test.fans, step_count / 8), 5);
        let mut longest_chain = 0;
        for frame in 0..26usize {
            // Reverses in the middle of motions; jumps once.
            let share = [60, 100, 20, 45, 5][frame / 3 % 5];
            let goal = FanInstance::uniform(&test.fans, step_count * share / 100);
            if frame == 19 {
                morphs.jump_to(&test.fans, &goal);
            } else {
                morphs.advance(&test.fans, &goal);
            }
            morphs.positions_into(sequence, &mesh.positions, &mut test.blended.positions);
            morphs.layer_into(sequence, &mesh.layers[0], &mut test.normals);
            morphs.layer_into(sequence, &mesh.layers[1], &mut test.colors);
            test.morph.follow(&gpu, &morphs, sequence).unwrap();
            let mut chain = std::collections::BTreeMap::new();
            for moving in morphs.moving(sequence) {
                let length = 1 + chain.get(&moving.target).copied().unwrap_or(0);
                chain.insert(moving.vertex, length);
                longest_chain = longest_chain.max(length);
            }
            test.compare(morphs.drawn(), &format!("{name}, frame {frame}"));
        }
        assert!(longest_chain >= 4, "{name}: chains of {longest_chain} only");
        // Starting a morph between levels brings all moving vertices to rest.
        let [a, b] = [30, 70].map(|share| FanInstance::uniform(&test.fans, step_count * share / 100));
        test.between(&a, &b, name);
    }
}
