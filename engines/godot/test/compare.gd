# Runs in the engine: draws a model at several distances, with the levels of the add-on and with those that the engine makes,
# and prints triangles and pictures.
extends Node3D

const Import := preload("res://addons/striata/order_import.gd")

const DISTANCES := [2.0, 4.0, 8.0, 16.0, 32.0]
## Levels of the add-on are also drawn at these, from the coarsest one to the first whose picture is as close to the full mesh as Godot's.
const THRESHOLDS := [8.0, 5.6, 4.0, 2.8, 2.0, 1.4, 1.0, 0.7, 0.5, 0.35, 0.25, 0.18, 0.125, 0.09, 0.0625]
const FIELD_OF_VIEW := 60.0

var _camera := Camera3D.new()


func _ready() -> void:
	await get_tree().process_frame
	get_viewport().msaa_3d = Viewport.MSAA_4X
	add_child(_camera)
	_camera.fov = FIELD_OF_VIEW
	add_light()
	var path := "res://models/" + DirAccess.get_files_at("res://models")[0]
	var engine_document := GLTFDocument.new()
	var engine := parse(engine_document, path)
	# Once more, because the first time takes longer.
	var start := Time.get_ticks_msec()
	parse(GLTFDocument.new(), path)
	var parsed := Time.get_ticks_msec()
	for entry in engine.meshes:
		entry.mesh.generate_lods(60, 25, [])
	var generated := Time.get_ticks_msec()
	GLTFDocument.register_gltf_document_extension(Import.new())
	var striata_document := GLTFDocument.new()
	var striata := parse(striata_document, path)
	var imported := Time.get_ticks_msec()
	print("RESULT ", JSON.stringify({"times": {"parse": parsed - start, "generate": generated - parsed, "import": imported - generated}}))
	var scenes := {"striata": striata_document.generate_scene(striata), "godot": engine_document.generate_scene(engine)}
	for which: String in scenes:
		add_child(scenes[which])
	await get_tree().process_frame
	var box := bounds(scenes["striata"])
	for distance: float in DISTANCES:
		var full := await draw(scenes, box, distance, "striata", 0.0)
		var godot := await draw(scenes, box, distance, "godot", 1.0)
		await draw(scenes, box, distance, "striata", 1.0)
		for pixels: float in THRESHOLDS:
			var picture := await draw(scenes, box, distance, "striata", pixels)
			if difference(full, picture) <= difference(full, godot):
				break
	print("DONE")


func parse(document: GLTFDocument, path: String) -> GLTFState:
	var state := GLTFState.new()
	document.append_from_file(path, state)
	return state


func add_light() -> void:
	var light := DirectionalLight3D.new()
	light.rotation_degrees = Vector3(-40, 60, 0)
	add_child(light)
	var surroundings := WorldEnvironment.new()
	surroundings.environment = Environment.new()
	surroundings.environment.background_mode = Environment.BG_COLOR
	surroundings.environment.background_color = Color(0.13, 0.14, 0.16)
	surroundings.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	surroundings.environment.ambient_light_color = Color.WHITE
	surroundings.environment.ambient_light_energy = 0.4
	add_child(surroundings)


func bounds(root: Node) -> AABB:
	var box := AABB()
	for node in root.find_children("*", "MeshInstance3D", true, false):
		var own: AABB = node.global_transform * node.get_aabb()
		box = own if box.size == Vector3.ZERO else box.merge(own)
	return box


func difference(a: Image, b: Image) -> float:
	return a.compute_image_metrics(b, false).root_mean_squared


# Draws one case, and prints the triangles and the part of the picture that the model can cover. Returns that part.
func draw(scenes: Dictionary, box: AABB, distance: float, which: String, pixels: float) -> Image:
	for name: String in scenes:
		scenes[name].visible = name == which
	get_viewport().mesh_lod_threshold = pixels
	var radius := box.size.length() / 2
	_camera.position = box.get_center() + radius * distance * Vector3(0.45, 0.3, 0.85).normalized()
	_camera.look_at(box.get_center())
	_camera.near = radius * maxf(0.05, distance - 1.5)
	_camera.far = radius * (distance + 1.5)
	for frame in 3:
		await RenderingServer.frame_post_draw
	var drawn := RenderingServer.viewport_get_render_info(get_viewport().get_viewport_rid(), RenderingServer.VIEWPORT_RENDER_INFO_TYPE_VISIBLE, RenderingServer.VIEWPORT_RENDER_INFO_PRIMITIVES_IN_FRAME)
	var image := get_viewport().get_texture().get_image()
	var half := mini(image.get_height() / 2, ceili(image.get_height() / 2.0 / sqrt(distance * distance - 1) / tan(deg_to_rad(FIELD_OF_VIEW / 2))) + 2)
	var region := image.get_region(Rect2i(image.get_width() / 2 - half, image.get_height() / 2 - half, 2 * half, 2 * half))
	region.convert(Image.FORMAT_RGB8)
	print("RESULT ", JSON.stringify({"distance": distance, "which": which, "pixels": pixels, "drawn": drawn, "image": Marshalls.raw_to_base64(region.get_data()), "png": Marshalls.raw_to_base64(region.save_png_to_buffer())}))
	return region
