# Levels of STRIATA_order (docs/STRIATA_order.md) in Godot 4: meshes are imported with `lods`.
# This is the rule in a few lines: the add-on in engines/godot also checks the extension, and gives levels to meshes of
# several materials, whose vertices Godot's importer distributes. Register it in a plugin: GLTFDocument.register_gltf_document_extension(preload("order.gd").new())
extends GLTFDocumentExtension

func _get_supported_extensions() -> PackedStringArray:
	return ["STRIATA_order"]

static func level_indices(indices: PackedInt32Array, targets: PackedInt32Array, n: int) -> PackedInt32Array:
	var map := PackedInt32Array()
	map.resize(targets.size())
	for i in targets.size():
		map[i] = i if i < n else map[targets[i]]
	var level := PackedInt32Array()
	for i in range(0, indices.size(), 3):
		var a := map[indices[i]]
		var b := map[indices[i + 1]]
		var c := map[indices[i + 2]]
		if a != b and b != c and c != a:
			level.append_array([a, b, c])
	return level

func _import_post_parse(state: GLTFState) -> Error:
	for index in state.json.get("meshes", []).size():
		var primitives: Array = state.json.meshes[index].primitives
		var full: ImporterMesh = state.meshes[index].mesh
		var leveled := ImporterMesh.new()
		for shape in full.get_blend_shape_count():
			leveled.add_blend_shape(full.get_blend_shape_name(shape))
		for surface in full.get_surface_count():
			var arrays := full.get_surface_arrays(surface)
			var order: Dictionary = primitives[surface].get("extensions", {}).get("STRIATA_order", {})
			var lods := {}
			for row in order.get("levels", []).slice(1):
				# A guard: the importer must have kept the vertices.
				if row[1] > 0 and row[2] > 0.0 and arrays[Mesh.ARRAY_VERTEX].size() == order.levels[0][0]:
					lods[row[2]] = level_indices(arrays[Mesh.ARRAY_INDEX], targets_of(state, order.targets), row[0])
			var shapes := range(full.get_blend_shape_count()).map(func(i): return full.get_surface_blend_shape_arrays(surface, i))
			leveled.add_surface(full.get_surface_primitive_type(surface), arrays, shapes, lods, full.get_surface_material(surface), full.get_surface_name(surface), full.get_surface_format(surface))
		state.meshes[index].mesh = leveled
	return OK

func targets_of(state: GLTFState, index: int) -> PackedInt32Array:
	var accessor: Dictionary = state.json.accessors[index]
	var view: Dictionary = state.json.bufferViews[accessor.bufferView]
	var start := int(view.get("byteOffset", 0)) + int(accessor.get("byteOffset", 0))
	return state.buffers[view.buffer].slice(start, start + 4 * int(accessor.count)).to_int32_array()
