//! Calls with valid and with hostile arguments.

use std::ffi::{CStr, CString, c_void};
use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};

use striata::file::WriteOptions;
use striata::mesh::{IndexedMesh, shapes};
use striata::{Lod, LodOptions, Target};
use striata_capi::*;

type Handle<T> = Option<Box<T>>;

fn message() -> String {
    // SAFETY: the text is valid until the next call of this thread.
    unsafe { CStr::from_ptr(striata_last_error()) }.to_str().expect("UTF-8").to_owned()
}

fn arrays_of(mesh: &IndexedMesh) -> StriataMeshArrays {
    StriataMeshArrays {
        vertex_count: mesh.vertex_count(),
        positions: mesh.positions.as_ptr().cast(),
        index_count: 3 * mesh.triangle_count(),
        indices: mesh.triangles.as_ptr().cast(),
        ..StriataMeshArrays::default()
    }
}

/// Makes a handle, or returns the status and the message.
fn made<T>(call: impl FnOnce(&mut MaybeUninit<Handle<T>>) -> i32) -> Result<Box<T>, (i32, String)> {
    let mut to = MaybeUninit::uninit();
    let status = call(&mut to);
    // SAFETY: the functions write the handle first.
    let handle = unsafe { to.assume_init() };
    assert_eq!(handle.is_some(), status == STRIATA_OK);
    handle.ok_or_else(|| (status, message()))
}

fn build_with(
    arrays: &StriataMeshArrays,
    options: &StriataBuildOptions,
) -> Result<Box<StriataLod>, (i32, String)> {
    // SAFETY: the arrays of the tests are as long as they say, or refused before they are read.
    made(|to| unsafe { striata_lod_build(Some(arrays), Some(options), Some(to)) })
}

fn build(arrays: &StriataMeshArrays) -> Result<Box<StriataLod>, (i32, String)> {
    build_with(arrays, &StriataBuildOptions::default())
}

/// Asks for a count, then for the elements.
fn filled<T: Copy + Default>(mut call: impl FnMut(*mut T, usize) -> i64) -> Result<Vec<T>, (i64, String)> {
    let count = call(null_mut(), 0);
    if count < 0 {
        return Err((count, message()));
    }
    let mut elements = vec![T::default(); count as usize];
    if count > 0 {
        assert_eq!(call(elements.as_mut_ptr(), count as usize - 1), i64::from(STRIATA_TOO_SMALL));
        assert!(message().contains(&format!("{count} are needed")), "{}", message());
    }
    let written = call(elements.as_mut_ptr(), count as usize);
    if written < 0 { Err((written, message())) } else { Ok(elements) }
}

fn resolve(lod: &StriataLod, kind: i32, value: f64) -> Result<StriataLevel, (i32, String)> {
    let mut level = MaybeUninit::uninit();
    match striata_lod_resolve(Some(lod), kind, value, Some(&mut level)) {
        // SAFETY: the call has succeeded.
        STRIATA_OK => Ok(unsafe { level.assume_init() }),
        status => Err((status, message())),
    }
}

fn emit(lod: &StriataLod, level: &StriataLevel) -> Result<Vec<u32>, (i64, String)> {
    // SAFETY: the memory is as large as stated.
    filled(|to, capacity| unsafe { striata_lod_emit(Some(lod), Some(level), to, capacity) })
}

fn facts(lod: &StriataLod) -> StriataFacts {
    let mut facts = MaybeUninit::uninit();
    assert_eq!(striata_lod_facts(Some(lod), Some(&mut facts)), STRIATA_OK);
    // SAFETY: the call has succeeded.
    unsafe { facts.assume_init() }
}

fn camera(distance: f32) -> StriataCamera {
    let mut camera = StriataCamera { width: 800, height: 800, ..StriataCamera::default() };
    for at in [0, 5, 10, 15] {
        camera.view[at] = 1.0;
    }
    camera.view[14] = -distance;
    for (at, number) in [(0, 2.0), (5, 2.0), (10, -1.0), (11, -1.0), (14, -1.0)] {
        camera.projection[at] = number;
    }
    camera
}

#[test]
fn interleaved_vertices_become_levels_with_attributes() {
    let mesh = shapes::two_material_sphere(12, 16);
    let normal = |p: &[f32; 3]| p.map(|x| x / 3.0);
    // Positions, normals, and colors in four bytes.
    let vertices: Vec<u8> = (mesh.positions.iter())
        .flat_map(|p| {
            [
                p.map(f32::to_ne_bytes).concat(),
                normal(p).map(f32::to_ne_bytes).concat(),
                vec![9, 99, 199, 255],
            ]
            .concat()
        })
        .collect();
    // An odd address, which attributes and positions may have.
    let memory: Vec<u8> = [0].into_iter().chain(vertices).collect();
    let at = |offset: usize| memory[1 + offset..].as_ptr();
    let attribute = |kind, number_type, components, offset| StriataAttribute {
        kind,
        number_type,
        components,
        set: 0,
        stride: 28,
        data: at(offset).cast(),
    };
    let attributes =
        [attribute(STRIATA_NORMAL, STRIATA_F32, 3, 12), attribute(STRIATA_COLOR, STRIATA_U8, 4, 24)];
    let groups: Vec<u32> = mesh.groups.iter().map(|group| group.count).collect();
    let arrays = StriataMeshArrays {
        positions: at(0).cast(),
        position_stride: 28,
        attribute_count: 2,
        attributes: attributes.as_ptr(),
        group_count: groups.len(),
        group_triangle_counts: groups.as_ptr(),
        ..arrays_of(&mesh)
    };
    let lod = build(&arrays).expect("levels");
    let facts = facts(&lod);
    assert_eq!((facts.group_count, facts.has_source_vertices), (groups.len() as u32, 1));
    // SAFETY: the memory is as large as stated, here and below.
    let sources = filled(|to, n| unsafe { striata_lod_source_vertices(Some(&lod), to, n) }).expect("sources");
    // SAFETY: as above.
    let positions = filled(|to, n| unsafe { striata_lod_positions(Some(&lod), to, n) }).expect("positions");
    // SAFETY: as above.
    let normals = filled(|to, n| unsafe { striata_lod_attribute(Some(&lod), STRIATA_NORMAL, 0, to, n) });
    // SAFETY: as above.
    let colors = filled(|to, n| unsafe { striata_lod_attribute(Some(&lod), STRIATA_COLOR, 0, to, n) });
    let (normals, colors) = (normals.expect("normals"), colors.expect("colors"));
    for (vertex, &source) in sources.iter().enumerate() {
        let expected = mesh.positions[source as usize];
        assert_eq!(positions[3 * vertex..][..3], expected);
        assert_eq!(normals[3 * vertex..][..3], normal(&expected));
        assert_eq!(colors[4 * vertex..][..4], [9.0f32, 99.0, 199.0, 255.0].map(|x| x / 255.0));
    }
    // SAFETY: as above.
    let missing = filled(|to, n| unsafe { striata_lod_attribute(Some(&lod), STRIATA_TEXCOORD, 1, to, n) });
    let text = "the mesh has no layer texcoord_1".to_owned();
    assert_eq!(missing.unwrap_err(), (i64::from(STRIATA_UNAVAILABLE), text));

    let level = resolve(&lod, STRIATA_BY_RATIO, 0.5).expect("a level");
    let indices = emit(&lod, &level).expect("indices");
    // SAFETY: as above.
    let ranges = filled(|to, n| unsafe { striata_lod_emit_groups(Some(&lod), Some(&level), to, n) });
    let ranges = ranges.expect("groups");
    assert_eq!(ranges.iter().map(|range| range.index_count).sum::<u32>(), indices.len() as u32);
    let request = |group| StriataRangeRequest { levels: &raw const level, level_count: 1, group };
    for (group, range) in ranges.iter().enumerate() {
        let request = request(group as i32);
        // SAFETY: as above.
        let found =
            filled(|to, n| unsafe { striata_lod_ranges(Some(&lod), Some(&request), null_mut(), to, n) });
        assert_eq!(found.expect("a range").len(), range.index_count as usize);
    }
    let mut view = made(|to| striata_view_new(Some(&lod), Some(to))).expect("a view");
    assert_eq!(striata_view_update(Some(&mut view), Some(&camera(9.0)), 1.0, 0, None), STRIATA_OK);
    // SAFETY: as above.
    let shown = filled(|to, n| unsafe { striata_view_groups(Some(&view), to, n) }).expect("groups");
    // SAFETY: as above.
    let count = unsafe { striata_view_emit(Some(&view), null_mut(), 0) };
    assert_eq!(shown.iter().map(|range| i64::from(range.index_count)).sum::<i64>(), count);
    striata_view_free(Some(view));
    striata_lod_free(Some(lod));
}

#[test]
fn levels_are_those_of_the_library() {
    let mesh = shapes::terrain(30, 7);
    let expected = Lod::build(&mesh, &LodOptions::default()).expect("levels");
    let lod = build(&arrays_of(&mesh)).expect("levels");
    let count = mesh.triangle_count();
    for (kind, value, target) in [
        (STRIATA_BY_TRIANGLES, 300.0, Target::Triangles(300)),
        (STRIATA_BY_TRIANGLES, 1e300, Target::Triangles(usize::MAX)),
        (STRIATA_BY_VERTICES, 99.5, Target::Vertices(99)),
        (STRIATA_BY_RATIO, 0.1, Target::Triangles(count / 10)),
        (STRIATA_BY_ERROR, 0.05, Target::Error(0.05)),
        (STRIATA_BY_DETAIL, 0.5, Target::Detail(0.5)),
        (STRIATA_BY_STEPS, 10.0, Target::SplitCount(10)),
        (STRIATA_BY_TRIANGLES, 0.0, Target::Triangles(0)),
    ] {
        let (level, expected) = (resolve(&lod, kind, value).expect("a level"), expected.level(target));
        assert_eq!(emit(&lod, &level).expect("indices"), expected.indices(), "{target:?}");
        assert_eq!((level.vertex_count as usize, level.error), (expected.vertex_count(), expected.error()));
    }
    let reasons = [0.0, 300.0, 1e9].map(|n| resolve(&lod, STRIATA_BY_TRIANGLES, n).expect("one").stop_reason);
    assert_eq!(reasons, [STRIATA_COARSEST_REACHED, STRIATA_TARGET_REACHED, STRIATA_FULL_REACHED]);
}

#[test]
fn a_handle_is_shared_by_threads() {
    let mesh = shapes::icosphere(4, 1.0);
    let lod = build(&arrays_of(&mesh)).expect("levels");
    let level = resolve(&lod, STRIATA_BY_RATIO, 0.3).expect("a level");
    let lists = std::thread::scope(|scope| {
        let workers = [(); 4].map(|()| scope.spawn(|| emit(&lod, &level).expect("indices")));
        workers.map(|worker| worker.join().expect("a list"))
    });
    assert!(lists.iter().all(|list| *list == lists[0]));
}

#[test]
fn hostile_arrays_are_refused() {
    let mesh = shapes::icosphere(1, 1.0);
    let arrays = arrays_of(&mesh);
    let refused = |arrays: StriataMeshArrays, status: i32, text: &str| {
        let (found, message) = build(&arrays).expect_err(text);
        assert_eq!(found, status, "{message}");
        assert!(message.contains(text), "{message}, not {text}");
    };
    let argument = |arrays, text| refused(arrays, STRIATA_BAD_ARGUMENT, text);
    refused(StriataMeshArrays { positions: null(), ..arrays }, STRIATA_NULL, "arrays.positions is null");
    refused(StriataMeshArrays { indices: null(), ..arrays }, STRIATA_NULL, "arrays.indices is null");
    refused(StriataMeshArrays { attribute_count: 1, ..arrays }, STRIATA_NULL, "arrays.attributes is null");
    refused(StriataMeshArrays { group_count: 1, ..arrays }, STRIATA_NULL, "arrays.group_triangle_counts");
    argument(StriataMeshArrays { index_count: 4, ..arrays }, "arrays.index_count: 4 is no multiple of 3");
    argument(StriataMeshArrays { index_count: usize::MAX, ..arrays }, "arrays.indices: the length");
    argument(StriataMeshArrays { vertex_count: usize::MAX, ..arrays }, "arrays.vertex_count");
    argument(StriataMeshArrays { position_stride: 11, ..arrays }, "arrays.positions: a stride of 11 bytes");
    argument(StriataMeshArrays { position_stride: usize::MAX, ..arrays }, "arrays.positions: the length");
    argument(
        StriataMeshArrays { indices: arrays.indices.wrapping_byte_add(1), ..arrays },
        "arrays.indices: the address is no multiple of 4",
    );
    argument(StriataMeshArrays { positions_f64: arrays.positions.cast(), ..arrays }, "both positions");
    refused(StriataMeshArrays { vertex_count: 3, ..arrays }, STRIATA_BAD_MESH, "but there are 3 vertices");
    let mut broken = mesh.clone();
    broken.positions[5][1] = f32::NAN;
    refused(arrays_of(&broken), STRIATA_BAD_MESH, "vertex 5 has the coordinate NaN on axis 1");
    let mut doubles: Vec<[f64; 3]> = mesh.positions.iter().map(|p| p.map(f64::from)).collect();
    doubles[2][0] = f64::INFINITY;
    let of_doubles =
        StriataMeshArrays { positions: null(), positions_f64: doubles.as_ptr().cast(), ..arrays };
    refused(of_doubles, STRIATA_BAD_MESH, "arrays.positions_f64: vertex 2");
    let counts = [3];
    let groups = StriataMeshArrays { group_count: 1, group_triangle_counts: counts.as_ptr(), ..arrays };
    argument(groups, "the groups have 3 triangles, but the mesh has 80");

    let normals = vec![[0.0f32, 0.0, f32::NAN]; mesh.vertex_count()];
    let normal = StriataAttribute {
        kind: STRIATA_NORMAL,
        number_type: STRIATA_F32,
        components: 3,
        set: 0,
        stride: 0,
        data: normals.as_ptr().cast(),
    };
    let attribute = |attribute: StriataAttribute, status, text| {
        let attributes = [attribute];
        let list = StriataMeshArrays { attribute_count: 1, attributes: attributes.as_ptr(), ..arrays };
        refused(list, status, text);
    };
    attribute(normal, STRIATA_BAD_MESH, "arrays.attributes[0]: vertex 0 has a number that is not finite");
    attribute(StriataAttribute { data: null(), ..normal }, STRIATA_NULL, "arrays.attributes[0] is null");
    attribute(StriataAttribute { kind: 77, ..normal }, STRIATA_BAD_ARGUMENT, "77 is no kind of attribute");
    attribute(StriataAttribute { number_type: -1, ..normal }, STRIATA_BAD_ARGUMENT, "-1 is no type");
    attribute(StriataAttribute { components: 0, ..normal }, STRIATA_BAD_ARGUMENT, "0 components");
    attribute(StriataAttribute { components: 255, ..normal }, STRIATA_BAD_ARGUMENT, "255 components");
    // SAFETY: a null pointer is refused, here and below.
    assert_eq!(unsafe { striata_lod_build(None, None, None) }, STRIATA_NULL);
    assert_eq!(message(), "to is null");
    // SAFETY: as above.
    let (status, message) = made(|to| unsafe { striata_lod_build(None, None, Some(to)) }).unwrap_err();
    assert_eq!((status, message.as_str()), (STRIATA_NULL, "arrays is null"));
}

#[test]
fn options_are_checked_and_calls_can_be_canceled() {
    let mesh = shapes::terrain(100, 1);
    let arrays = arrays_of(&mesh);
    let default = StriataBuildOptions::default();
    for (options, text) in [
        (StriataBuildOptions { keep_seams: 2, ..default }, "options.keep_seams: 2 is neither 0 nor 1"),
        (StriataBuildOptions { topology: 9, ..default }, "options.topology: 9 is no topology rule"),
        (StriataBuildOptions { max_error: f64::NAN, ..default }, "max_error is NaN"),
        (StriataBuildOptions { thread_count: u32::MAX, ..default }, "options.thread_count: 4294967295"),
        (StriataBuildOptions { max_error: -1.0, ..default }, "max_error is -1"),
    ] {
        let (status, message) = build_with(&arrays, &options).unwrap_err();
        assert_eq!(status, STRIATA_BAD_ARGUMENT);
        assert!(message.contains(text), "{message}");
    }
    extern "C" fn cancel(user: *mut c_void, done: u64, total: u64) -> i32 {
        assert!(done <= total);
        // SAFETY: the test passes a counter.
        let calls = unsafe { &mut *user.cast::<u32>() };
        *calls += 1;
        1
    }
    let mut calls = 0u32;
    for thread_count in [0, 2] {
        calls = 0;
        let user = (&raw mut calls).cast();
        let options = StriataBuildOptions { thread_count, progress: Some(cancel), user, ..default };
        assert_eq!(build_with(&arrays, &options).unwrap_err().0, STRIATA_CANCELED);
    }
    assert_eq!(calls, 1);
    let options = StriataBuildOptions {
        lock_boundary: 1,
        coarsest_triangle_count: 500,
        thread_count: 1,
        guaranteed_errors: 1,
        ..default
    };
    let lod = build_with(&arrays, &options).expect("levels");
    assert!(facts(&lod).coarsest_triangle_count >= 480 && facts(&lod).has_guaranteed_errors == 1);
}

#[test]
fn empty_meshes_have_empty_levels() {
    let lod = build(&StriataMeshArrays::default()).expect("levels");
    assert_eq!(facts(&lod), StriataFacts { group_count: 1, ..StriataFacts::default() });
    let level = resolve(&lod, STRIATA_BY_RATIO, 1.0).expect("a level");
    assert_eq!(emit(&lod, &level), Ok(Vec::new()));
    // SAFETY: the memory is as large as stated.
    let levels = unsafe { striata_lod_halved_levels(Some(&lod), null_mut(), 0) };
    assert_eq!(levels, 1);
    let mut view = made(|to| striata_view_new(Some(&lod), Some(to))).expect("a view");
    assert_eq!(striata_view_update(Some(&mut view), Some(&camera(3.0)), 1.0, 0, None), STRIATA_OK);
}

#[test]
fn hostile_targets_levels_and_requests_are_refused() {
    let mesh = shapes::icosphere(2, 1.0);
    let lod = build(&arrays_of(&mesh)).expect("levels");
    for (kind, value) in [
        (STRIATA_BY_TRIANGLES, f64::NAN),
        (STRIATA_BY_ERROR, -1.0),
        (STRIATA_BY_ERROR, f64::INFINITY),
        (STRIATA_BY_RATIO, 1.5),
        (STRIATA_BY_DETAIL, 2.0),
        (0, 1.0),
        (i32::MIN, 1.0),
    ] {
        assert_eq!(resolve(&lod, kind, value).unwrap_err().0, STRIATA_BAD_ARGUMENT, "{kind} {value}");
    }
    assert_eq!(striata_lod_resolve(Some(&lod), 1, 1.0, None), STRIATA_NULL);
    assert_eq!(message(), "level is null");
    let level = resolve(&lod, STRIATA_BY_RATIO, 0.5).expect("a level");
    for wrong in [
        StriataLevel { step_count: u32::MAX, ..level },
        StriataLevel { step_count: level.step_count + 1, ..level },
        StriataLevel { triangle_count: u32::MAX, ..level },
        StriataLevel { triangle_count: 0, ..level },
    ] {
        assert_eq!(emit(&lod, &wrong).unwrap_err().0, i64::from(STRIATA_BAD_ARGUMENT), "{wrong:?}");
        let request = StriataRangeRequest { levels: &raw const wrong, level_count: 1, group: -1 };
        // SAFETY: nothing is written.
        let count = unsafe { striata_lod_ranges(Some(&lod), Some(&request), null_mut(), null_mut(), 0) };
        assert_eq!(count, i64::from(STRIATA_BAD_ARGUMENT));
    }
    let rising = [resolve(&lod, STRIATA_BY_RATIO, 0.1).expect("a level"), level];
    for (levels, level_count, group, status, text) in [
        (rising.as_ptr(), 2, -1, STRIATA_BAD_ARGUMENT, "finer than the one before"),
        (null(), 1, -1, STRIATA_NULL, "request.levels is null"),
        (rising.as_ptr(), usize::MAX, -1, STRIATA_BAD_ARGUMENT, "request.levels: the length"),
        (rising.as_ptr(), 1, 1, STRIATA_BAD_ARGUMENT, "there is no group 1 of 1"),
        (rising.as_ptr(), 1, -2, STRIATA_BAD_ARGUMENT, "there is no group -2 of 1"),
    ] {
        let request = StriataRangeRequest { levels, level_count, group };
        // SAFETY: nothing is written, and lengths are those of the levels or refused.
        let count = unsafe { striata_lod_ranges(Some(&lod), Some(&request), null_mut(), null_mut(), 0) };
        assert_eq!(count, i64::from(status));
        assert!(message().contains(text), "{}", message());
    }
    let mut room = [0u32; 8];
    let odd = room.as_mut_ptr().wrapping_byte_add(1);
    // SAFETY: wrong addresses and lengths are refused before anything is written.
    assert_eq!(unsafe { striata_lod_targets(Some(&lod), odd, 1) }, i64::from(STRIATA_BAD_ARGUMENT));
    assert_eq!(message(), "to: the address is no multiple of 4");
    // SAFETY: as above.
    let count = unsafe { striata_lod_targets(Some(&lod), room.as_mut_ptr(), usize::MAX) };
    assert_eq!(count, i64::from(STRIATA_BAD_ARGUMENT));
    // SAFETY: as above.
    assert_eq!(unsafe { striata_lod_targets(None, null_mut(), 0) }, i64::from(STRIATA_NULL));
}

#[test]
fn hostile_cameras_are_refused() {
    let lod = build(&arrays_of(&shapes::icosphere(2, 1.0))).expect("levels");
    let mut view = made(|to| striata_view_new(Some(&lod), Some(to))).expect("a view");
    let good = camera(3.0);
    let cameras = [
        StriataCamera::default(),
        StriataCamera { width: 0, ..good },
        StriataCamera { view: [f32::NAN; 16], ..good },
        StriataCamera { projection: [1.0; 16], ..good },
    ];
    let mut level = MaybeUninit::uninit();
    for camera in &cameras {
        assert_eq!(striata_view_update(Some(&mut view), Some(camera), 1.0, 0, None), STRIATA_BAD_ARGUMENT);
        assert!(message().starts_with("camera: "), "{}", message());
        let status = striata_lod_resolve_for_camera(Some(&lod), Some(camera), 1.0, Some(&mut level));
        assert_eq!(status, STRIATA_BAD_ARGUMENT);
    }
    for pixels in [f32::NAN, -1.0, f32::INFINITY] {
        let status = striata_view_update(Some(&mut view), Some(&good), pixels, 0, None);
        assert_eq!(status, STRIATA_BAD_ARGUMENT);
        assert!(message().starts_with("pixels: "), "{}", message());
    }
    assert_eq!(striata_view_update(None, Some(&good), 1.0, 0, None), STRIATA_NULL);
    assert_eq!(striata_view_update(Some(&mut view), None, 1.0, 0, None), STRIATA_NULL);
    assert_eq!(message(), "camera is null");
}

#[test]
fn views_stay_within_a_limit_and_outlive_their_mesh() {
    let lod = build(&arrays_of(&shapes::icosphere(5, 1.0))).expect("levels");
    let mut view = made(|to| striata_view_new(Some(&lod), Some(to))).expect("a view");
    striata_lod_free(Some(lod));
    let mut update = |camera: &StriataCamera, limit| {
        let mut update = MaybeUninit::uninit();
        assert_eq!(
            striata_view_update(Some(&mut view), Some(camera), 0.5, limit, Some(&mut update)),
            STRIATA_OK
        );
        // SAFETY: the call has succeeded.
        unsafe { update.assume_init() }
    };
    let (far, near) = (update(&camera(50.0), 0), update(&camera(2.0), 0));
    assert!(near.triangle_count > far.triangle_count && near.is_complete == 1, "{near:?} {far:?}");
    assert_eq!(near.index_count, 3 * near.triangle_count);
    let limited = update(&camera(2.0), 400);
    assert!(limited.triangle_count <= 400 && limited.is_complete == 0, "{limited:?}");
    assert!(limited.coarsened_count > 0);
}

#[test]
fn changes_are_those_since_they_were_written() {
    let lod = build(&arrays_of(&shapes::icosphere(4, 1.0))).expect("levels");
    let mut view = made(|to| striata_view_new(Some(&lod), Some(to))).expect("a view");
    let mut uploaded: Vec<u32> = Vec::new();
    for distance in [9.0, 5.0, 4.9, 4.9, 2.0, 30.0] {
        assert_eq!(striata_view_update(Some(&mut view), Some(&camera(distance)), 1.0, 0, None), STRIATA_OK);
        let view = &mut *view;
        // SAFETY: the memory is as large as stated, here and below.
        let shown = unsafe { striata_view_emit(Some(view), null_mut(), 0) };
        // SAFETY: as above.
        let spans = filled(|to, n| unsafe { striata_view_changes(Some(view), 0, to, n) }).expect("spans");
        // SAFETY: as above.
        let all = filled(|to, n| unsafe { striata_view_placed(Some(view), 0, None, to, n) });
        let all = all.expect("indices");
        assert_eq!(spans.is_empty(), uploaded == all);
        uploaded.resize(all.len(), u32::MAX);
        for span in spans {
            // SAFETY: as above.
            let part = filled(|to, n| unsafe { striata_view_placed(Some(view), 0, Some(&span), to, n) });
            let range = span.first_index as usize..(span.first_index + span.index_count) as usize;
            uploaded[range].copy_from_slice(&part.expect("a part"));
        }
        assert_eq!(uploaded, all);
        assert_eq!(3 * uploaded.as_chunks::<3>().0.iter().filter(|[a, b, _]| a != b).count() as i64, shown);
    }
    let beyond = StriataSpan { first_index: u32::MAX, index_count: u32::MAX };
    // SAFETY: nothing is written, here and below.
    let part = unsafe { striata_view_placed(Some(&mut view), 0, Some(&beyond), null_mut(), 0) };
    assert_eq!(part, i64::from(STRIATA_BAD_ARGUMENT));
    // SAFETY: as above.
    let part = unsafe { striata_view_placed(Some(&mut view), 1, None, null_mut(), 0) };
    assert_eq!((part, message().as_str()), (STRIATA_BAD_ARGUMENT.into(), "group: there is no group 1 of 1"));
    // SAFETY: as above.
    assert_eq!(unsafe { striata_view_changes(None, 0, null_mut(), 0) }, i64::from(STRIATA_NULL));
}

#[test]
fn files_round_trip_and_broken_ones_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("sphere.striata");
    let text = CString::new(path.to_str().expect("UTF-8")).expect("no zero");
    let mesh = shapes::icosphere(2, 1.0);
    let lod = build(&arrays_of(&mesh)).expect("levels");
    // SAFETY: the text ends with a zero, here and below.
    assert_eq!(unsafe { striata_lod_save(Some(&lod), text.as_ptr()) }, STRIATA_OK);
    // SAFETY: as above.
    let opened = made(|to| unsafe { striata_lod_open(text.as_ptr(), Some(to)) }).expect("levels");
    let level = resolve(&opened, STRIATA_BY_RATIO, 0.5).expect("a level");
    assert_eq!(emit(&opened, &level), emit(&lod, &level));
    assert_eq!(facts(&opened).has_source_vertices, 0);
    // SAFETY: nothing is written.
    let sources = unsafe { striata_lod_source_vertices(Some(&opened), null_mut(), 0) };
    assert_eq!(sources, i64::from(STRIATA_UNAVAILABLE));

    let open = |bytes: &[u8]| {
        // SAFETY: the slice is as long as stated.
        made(|to| unsafe { striata_lod_open_bytes(bytes.as_ptr(), bytes.len(), Some(to)) }).map(drop)
    };
    let bytes = std::fs::read(&path).expect("the file");
    assert!(open(&bytes).is_ok());
    for length in 0..bytes.len() {
        assert_eq!(open(&bytes[..length]).unwrap_err().0, STRIATA_BAD_BYTES, "{length}");
    }
    for at in (0..bytes.len()).step_by(3) {
        let mut flipped = bytes.clone();
        flipped[at] ^= 1 << (at % 8);
        let _ = open(&flipped);
    }
    let missing = c"/no/such/folder/a.striata".as_ptr();
    // SAFETY: as above.
    let (status, message) = made(|to| unsafe { striata_lod_open(missing, Some(to)) }).unwrap_err();
    assert!(status == STRIATA_IO && message.starts_with("/no/such/folder/a.striata: "), "{message}");
    // SAFETY: as above.
    assert_eq!(unsafe { striata_lod_save(Some(&lod), missing) }, STRIATA_IO);
    // SAFETY: as above.
    let status = unsafe { striata_lod_save(Some(&lod), c"\xff".as_ptr()) };
    assert_eq!(status, STRIATA_BAD_ARGUMENT);
    // SAFETY: null is refused.
    assert_eq!(made(|to| unsafe { striata_lod_open(null(), Some(to)) }).unwrap_err().0, STRIATA_NULL);
    // SAFETY: null is refused.
    let status = made(|to| unsafe { striata_lod_open_bytes(null(), 5, Some(to)) }).unwrap_err().0;
    assert_eq!(status, STRIATA_NULL);
}

#[test]
fn streams_grow_and_broken_ones_are_refused() {
    let built = striata::simplify::build_batches(&shapes::icosphere(3, 1.0), &Default::default());
    let built = built.expect("batches");
    let stream = striata_stream::encode_stream(&built.built.refinable, &built.batches, &Default::default());
    let stream = stream.expect("a stream").bytes;
    let new = || made(|to| striata_decoder_new(Some(to))).expect("a decoder");
    let state = |decoder: &StriataDecoder| {
        let mut state = MaybeUninit::uninit();
        assert_eq!(striata_decoder_state(Some(decoder), Some(&mut state)), STRIATA_OK);
        // SAFETY: the call has succeeded.
        unsafe { state.assume_init() }
    };
    let push = |decoder: &mut StriataDecoder, bytes: &[u8]| {
        // SAFETY: the slice is as long as stated.
        unsafe { striata_decoder_push(Some(decoder), bytes.as_ptr(), bytes.len()) }
    };
    let mut decoder = new();
    assert_eq!(state(&decoder), StriataStreamState::default());
    let early = made(|to| striata_decoder_lod(Some(&decoder), Some(to))).unwrap_err();
    assert_eq!(early.0, STRIATA_INCOMPLETE);
    let mut last = 0;
    for piece in stream.chunks(100) {
        assert_eq!(push(&mut decoder, piece), STRIATA_OK);
        let now = state(&decoder);
        assert!(now.vertex_count >= last);
        // SAFETY: the memory is as large as stated.
        let more = filled(|to, n| unsafe { striata_decoder_positions(Some(&decoder), last as usize, to, n) });
        assert_eq!(more.expect("positions").len(), 3 * (now.vertex_count - last) as usize);
        last = now.vertex_count;
    }
    let whole = state(&decoder);
    assert_eq!((whole.is_complete, whole.byte_count), (1, stream.len() as u64));
    assert_eq!(
        (whole.vertex_count, whole.triangle_count),
        (whole.full_vertex_count, whole.full_triangle_count)
    );
    let lod = made(|to| striata_decoder_lod(Some(&decoder), Some(to))).expect("levels");
    assert_eq!(facts(&lod).triangle_count, whole.triangle_count);
    // SAFETY: nothing is written.
    let beyond = unsafe { striata_decoder_positions(Some(&decoder), usize::MAX, null_mut(), 0) };
    assert_eq!(beyond, i64::from(STRIATA_BAD_ARGUMENT));
    assert_eq!(push(&mut decoder, b"more"), STRIATA_BAD_BYTES);
    assert_eq!(state(&decoder).triangle_count, whole.triangle_count, "the mesh stays");
    // SAFETY: null is refused.
    assert_eq!(unsafe { striata_decoder_push(Some(&mut decoder), null(), 1) }, STRIATA_NULL);
    // SAFETY: without bytes, the pointer may be null.
    assert_eq!(unsafe { striata_decoder_push(Some(&mut new()), null(), 0) }, STRIATA_OK);
    for at in 0..stream.len() {
        let (mut flipped, mut decoder) = (stream.clone(), new());
        flipped[at] ^= 1 << (at % 8);
        let _ = push(&mut decoder, &flipped);
        // SAFETY: the memory is as large as stated.
        let indices = filled(|to, n| unsafe { striata_decoder_indices(Some(&decoder), to, n) });
        let vertex_count = state(&decoder).vertex_count;
        assert!(indices.expect("indices").iter().all(|&index| index < vertex_count));
    }
    striata_decoder_free(Some(decoder));
}

#[test]
fn null_handles_are_freed_without_effect() {
    striata_lod_free(None);
    striata_view_free(None);
    striata_decoder_free(None);
    assert_eq!(
        made(|to| striata_view_new(None, Some(to))).unwrap_err(),
        (STRIATA_NULL, "lod is null".to_owned())
    );
    assert_eq!(striata_decoder_new(None), STRIATA_NULL);
    assert_eq!(striata_abi(), STRIATA_ABI);
    // SAFETY: the texts end with a zero.
    let texts = [striata_version(), striata_status_name(STRIATA_IO), striata_status_name(5)]
        .map(|text| unsafe { CStr::from_ptr(text) }.to_str().expect("UTF-8"));
    assert_eq!(texts, [env!("CARGO_PKG_VERSION"), "input or output failed", "unknown status"]);
}

#[test]
fn files_with_guaranteed_errors_and_streams_are_opened() {
    let lod = Lod::build(&shapes::icosphere(2, 1.0), &LodOptions::default().with_guaranteed_errors(true));
    let bytes = lod.expect("levels").to_striata(&WriteOptions::default()).expect("a file");
    // SAFETY: the slice is as long as stated.
    let opened = made(|to| unsafe { striata_lod_open_bytes(bytes.as_ptr(), bytes.len(), Some(to)) });
    assert_eq!(facts(&opened.expect("levels")).has_guaranteed_errors, 1);
}
