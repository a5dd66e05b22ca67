# Runs in the engine: draws rows of a mesh that recede from the camera, with the table of its levels, as the inspector shows it.
extends Node3D

const Import := preload("res://addons/striata/order_import.gd")
const LevelTable := preload("res://addons/striata/level_table.gd")

const COLUMNS := 5
const ROWS := 20


func _ready() -> void:
	await get_tree().process_frame
	get_viewport().msaa_3d = Viewport.MSAA_4X
	GLTFDocument.register_gltf_document_extension(Import.new())
	var state := GLTFState.new()
	GLTFDocument.new().append_from_file("res://models/nefertiti.glb", state)
	var mesh: ArrayMesh = state.meshes[0].mesh.get_mesh()
	var box := mesh.get_aabb()
	var material := StandardMaterial3D.new()
	material.albedo_color = Color(0.85, 0.72, 0.55)
	material.roughness = 0.7
	for row in ROWS:
		for column in COLUMNS:
			var instance := MeshInstance3D.new()
			instance.mesh = mesh
			instance.material_override = material
			instance.scale = Vector3.ONE / box.size.y
			instance.position = Vector3(1.1 * (column - (COLUMNS - 1) / 2.0), 0, -1.8 * row) - box.get_center() / box.size.y
			add_child(instance)
	var camera := Camera3D.new()
	add_child(camera)
	camera.fov = 40
	camera.position = Vector3(-1.6, 1.5, 5.0)
	camera.look_at(Vector3(-1.9, -0.1, -3))
	add_light()
	add_table(LevelTable.rows(mesh))
	for pixels: float in [0.0, 1.0]:
		get_viewport().mesh_lod_threshold = pixels
		for frame in 3:
			await RenderingServer.frame_post_draw
		var drawn := RenderingServer.viewport_get_render_info(get_viewport().get_viewport_rid(), RenderingServer.VIEWPORT_RENDER_INFO_TYPE_VISIBLE, RenderingServer.VIEWPORT_RENDER_INFO_PRIMITIVES_IN_FRAME)
		print("RESULT ", JSON.stringify({"pixels": pixels, "drawn": drawn, "picture": Marshalls.raw_to_base64(get_viewport().get_texture().get_image().save_jpg_to_buffer(0.85))}))
	print("DONE")


func add_light() -> void:
	var light := DirectionalLight3D.new()
	light.rotation_degrees = Vector3(-35, -40, 0)
	add_child(light)
	var surroundings := WorldEnvironment.new()
	surroundings.environment = Environment.new()
	surroundings.environment.background_mode = Environment.BG_COLOR
	surroundings.environment.background_color = Color(0.13, 0.14, 0.16)
	surroundings.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	surroundings.environment.ambient_light_color = Color.WHITE
	surroundings.environment.ambient_light_energy = 0.35
	add_child(surroundings)


func add_table(rows: Array[Dictionary]) -> void:
	var panel := PanelContainer.new()
	var margin := MarginContainer.new()
	for side: String in ["left", "right", "top", "bottom"]:
		margin.add_theme_constant_override("margin_" + side, 10)
	panel.add_child(margin)
	var table := LevelTable.control(rows)
	table.custom_minimum_size.x = 230
	margin.add_child(table)
	panel.position = Vector2(12, 12)
	var background := StyleBoxFlat.new()
	background.bg_color = Color(0.2, 0.22, 0.25)
	panel.add_theme_stylebox_override("panel", background)
	add_child(panel)
