# Runs in the engine: imports the models with and without the add-on, and prints what became of them.
extends Node3D

const Import := preload("res://addons/striata/order_import.gd")
const LevelTable := preload("res://addons/striata/level_table.gd")
const Settings := preload("res://addons/striata/settings.gd")


# Stands for a tool that changes meshes: takes the last triangle of each surface.
class Cutter extends GLTFDocumentExtension:
	func _import_post_parse(state: GLTFState) -> Error:
		for entry in state.meshes:
			var cut := ImporterMesh.new()
			for surface in entry.mesh.get_surface_count():
				var arrays: Array = entry.mesh.get_surface_arrays(surface)
				arrays[Mesh.ARRAY_INDEX] = arrays[Mesh.ARRAY_INDEX].slice(3)
				cut.add_surface(Mesh.PRIMITIVE_TRIANGLES, arrays)
			entry.mesh = cut
		return OK


func _ready() -> void:
	await get_tree().process_frame
	var import := Import.new()
	var plain := {}
	var documents := {}
	for file in DirAccess.get_files_at("res://models"):
		documents[file] = GLTFDocument.new()
		plain[file] = parse("res://models/" + file, documents[file])
	GLTFDocument.register_gltf_document_extension(import)
	for file: String in plain:
		var document := GLTFDocument.new()
		var state := parse("res://models/" + file, document)
		result({"model": file, "meshes": state.meshes.map(func(entry: GLTFMesh) -> Dictionary: return dump(entry.mesh)),
			"kept": differences(plain[file], state), "scene": scene_of(document.generate_scene(state)), "plain_scene": scene_of(documents[file].generate_scene(plain[file]))})
	for file in DirAccess.get_files_at("res://malformed"):
		print("IMPORT ", file)
		var state := parse("res://malformed/" + file)
		result({"malformed": file, "rows": LevelTable.rows(state.meshes[0].mesh).size()})
	print("IMPORT partial")
	var part: ImporterMesh = parse("res://partial/speck.glb").meshes[0].mesh
	result({"partial": range(part.get_surface_count()).map(part.get_surface_lod_count)})
	test_settings()
	var cutter := Cutter.new()
	GLTFDocument.register_gltf_document_extension(cutter, true)
	print("IMPORT cut")
	result({"cut": LevelTable.rows(parse("res://models/spot.glb").meshes[0].mesh).size()})
	GLTFDocument.unregister_gltf_document_extension(cutter)
	for file in DirAccess.get_files_at("res://resources"):
		result({"resource": file, "rows": LevelTable.rows(load("res://resources/" + file))})
	test_plugin(import)
	await test_drawing()
	print("DONE")


func result(value: Dictionary) -> void:
	print("RESULT ", JSON.stringify(value, "", true, true))


func parse(path: String, document := GLTFDocument.new()) -> GLTFState:
	var state := GLTFState.new()
	var error := document.append_from_file(path, state)
	if error != OK:
		push_error("%s cannot be imported: %d" % [path, error])
	return state


func base64(array: Variant) -> String:
	return "" if array == null or array.is_empty() else Marshalls.raw_to_base64(array.to_byte_array())


func dump(mesh: ImporterMesh) -> Dictionary:
	var surfaces: Array = []
	for surface in mesh.get_surface_count():
		var arrays := mesh.get_surface_arrays(surface)
		var lods: Array = []
		for lod in mesh.get_surface_lod_count(surface):
			lods.append({"error": mesh.get_surface_lod_size(surface, lod), "indices": base64(mesh.get_surface_lod_indices(surface, lod))})
		var shapes := range(mesh.get_blend_shape_count()).map(func(shape: int) -> String:
			return base64(mesh.get_surface_blend_shape_arrays(surface, shape)[Mesh.ARRAY_VERTEX]))
		surfaces.append({"positions": base64(arrays[Mesh.ARRAY_VERTEX]), "uvs": base64(arrays[Mesh.ARRAY_TEX_UV]), "bones": base64(arrays[Mesh.ARRAY_BONES]),
			"indices": base64(arrays[Mesh.ARRAY_INDEX]), "lods": lods, "shapes": shapes})
	return {"name": mesh.resource_name, "surfaces": surfaces, "has_mesh": true, "rows": LevelTable.rows(mesh), "array_rows": LevelTable.rows(mesh.get_mesh())}


# Names what the add-on has changed besides the levels. It may append vertices, and a triangle without area.
func differences(plain: GLTFState, leveled: GLTFState) -> Array:
	var found: Array = []
	for index in plain.meshes.size():
		var a: ImporterMesh = plain.meshes[index].mesh
		var b: ImporterMesh = leveled.meshes[index].mesh
		var shapes := func(mesh: ImporterMesh) -> Array: return range(mesh.get_blend_shape_count()).map(mesh.get_blend_shape_name)
		var facts := func(mesh: ImporterMesh) -> Array:
			return [mesh.resource_name, mesh.get_blend_shape_mode(), mesh.get_lightmap_size_hint(), mesh.get_meta_list(), shapes.call(mesh), mesh.get_surface_count()]
		if facts.call(a) != facts.call(b):
			found.append("%s is not %s" % [facts.call(a), facts.call(b)])
			continue
		for surface in a.get_surface_count():
			var material := func(mesh: ImporterMesh) -> Array:
				var own := mesh.get_surface_material(surface)
				return [own.resource_name, own.get_class(), own.albedo_color, own.transparency, own.cull_mode, own.albedo_texture != null] if own is BaseMaterial3D else [own]
			var of_surface := func(mesh: ImporterMesh) -> Array:
				return [mesh.get_surface_name(surface), mesh.get_surface_format(surface), mesh.get_surface_primitive_type(surface), material.call(mesh)]
			if of_surface.call(a) != of_surface.call(b):
				found.append("surface %d: %s is not %s" % [surface, of_surface.call(a), of_surface.call(b)])
			if not begins(b.get_surface_arrays(surface), a.get_surface_arrays(surface)):
				found.append("the arrays of surface %d differ" % surface)
			for shape in a.get_blend_shape_count():
				if not begins(b.get_surface_blend_shape_arrays(surface, shape), a.get_surface_blend_shape_arrays(surface, shape)):
					found.append("blend shape %d of surface %d differs" % [shape, surface])
	return found


func begins(long: Array, short: Array) -> bool:
	for kind in short.size():
		if typeof(long[kind]) != typeof(short[kind]) or (short[kind] != null and long[kind].slice(0, short[kind].size()) != short[kind]):
			return false
	return true


# Nodes, skins and animations of a scene, which is freed.
func scene_of(root: Node) -> Array:
	var facts: Array = []
	var queue: Array[Node] = [root]
	while not queue.is_empty():
		var node: Node = queue.pop_front()
		queue.append_array(node.get_children())
		var fact := [str(node.name), node.get_class()]
		if node is MeshInstance3D:
			fact.append_array([str(node.skeleton), node.skin.get_bind_count() if node.skin else 0, node.mesh.get_surface_count(), node.get_blend_shape_count()])
		if node is Skeleton3D:
			fact.append(node.get_bone_count())
		if node is AnimationPlayer:
			fact.append_array(Array(node.get_animation_list()).map(func(name: StringName) -> String: return str(name)))
		facts.append(fact)
	root.free()
	return facts


# Runs the two scripts of the editor with stand-ins for its classes.
func test_plugin(import: GLTFDocumentExtension) -> void:
	GLTFDocument.unregister_gltf_document_extension(import)
	var plugin: Node = load("res://stubs/plugin.gd").new()
	add_child(plugin)
	var inspector: RefCounted = plugin.inspectors[0]
	var mesh: ImporterMesh = parse("res://models/spot.glb").meshes[0].mesh
	var instance := MeshInstance3D.new()
	instance.mesh = mesh.get_mesh()
	for object: Object in [mesh, instance.mesh, instance]:
		if inspector._can_handle(object):
			inspector._parse_begin(object)
	var handled := [MeshInstance3D.new(), BoxMesh.new(), self, StandardMaterial3D.new()].map(inspector._can_handle)
	var texts: Array = inspector.controls.map(func(control: Control) -> Array: return control.get_children().map(func(label: Label) -> String: return label.text))
	remove_child(plugin)
	result({"plugin": LevelTable.rows(mesh).size(), "tables": texts, "handles_others": handled, "left": plugin.inspectors.size(),
		"after": LevelTable.rows(parse("res://models/spot.glb").meshes[0].mesh).size(), "settings": ProjectSettings.has_setting(Settings.MAXIMUM_LEVEL_COUNT)})
	GLTFDocument.register_gltf_document_extension(import)


func test_settings() -> void:
	var cases := [
		{Settings.MAXIMUM_LEVEL_COUNT: 3},
		{Settings.MAXIMUM_TRIANGLE_RATIO: 0.3},
		{Settings.MINIMUM_TRIANGLE_COUNT: 500},
		{Settings.USE_STORED_RANGES: false},
		{Settings.KEEP_FROM_GENERATOR: false},
	]
	for changes: Dictionary in cases:
		for name: String in changes:
			ProjectSettings.set_setting(name, changes[name])
		var mesh: ImporterMesh = parse("res://models/spot-ranges.glb" if changes.has(Settings.USE_STORED_RANGES) else "res://models/spot.glb").meshes[0].mesh
		result({"setting": changes.keys()[0], "rows": LevelTable.rows(mesh)})
		for name: String in changes:
			ProjectSettings.set_setting(name, Settings.DEFAULTS[name])


# Draws Spot from several distances, the GLB file and the resource: the engine must choose the level by its error.
func test_drawing() -> void:
	var camera := Camera3D.new()
	camera.far = 200.0
	add_child(camera)
	var light := DirectionalLight3D.new()
	light.rotation_degrees = Vector3(-40, 30, 0)
	add_child(light)
	var instance := MeshInstance3D.new()
	add_child(instance)
	get_viewport().mesh_lod_threshold = 1.0
	var meshes: Array[Mesh] = [parse("res://models/spot.glb").meshes[0].mesh.get_mesh(), load("res://resources/spot.tres")]
	for distance: float in [2.0, 5.0, 20.0, 80.0]:
		camera.position = Vector3(0, 0, distance)
		var drawn: Array[int] = []
		var pictures: Array[Image] = []
		for mesh in meshes:
			instance.mesh = mesh
			for frame in 3:
				await RenderingServer.frame_post_draw
			drawn.append(RenderingServer.viewport_get_render_info(get_viewport().get_viewport_rid(), RenderingServer.VIEWPORT_RENDER_INFO_TYPE_VISIBLE, RenderingServer.VIEWPORT_RENDER_INFO_PRIMITIVES_IN_FRAME))
			pictures.append(get_viewport().get_texture().get_image())
		result({"distance": distance, "drawn": drawn, "difference": pictures[0].compute_image_metrics(pictures[1], false)})
