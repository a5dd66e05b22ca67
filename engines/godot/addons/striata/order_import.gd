# Imports the levels of ordered GLB files (extension STRIATA_order): each mesh gets `lods`, from which the engine chooses by the
# size on the screen. A mesh whose extension is malformed, or that the importer has changed, stays as it is, at full
# detail, with an error or a warning that names it.
#
# Outside of the editor: `GLTFDocument.register_gltf_document_extension(preload("order_import.gd").new())`.
@tool
extends GLTFDocumentExtension

const Order := preload("order.gd")
const Settings := preload("settings.gd")


func _get_supported_extensions() -> PackedStringArray:
	return [Order.NAME]


func _import_post_parse(state: GLTFState) -> Error:
	var meshes: Array = state.json.get("meshes", [])
	for index in mini(meshes.size(), state.meshes.size()):
		var order := Order.new(state, meshes[index])
		if order.primitives.is_empty():
			continue
		var place := "mesh %d (\"%s\") of %s" % [index, meshes[index].get("name", ""), state.filename]
		if not order.problem.is_empty():
			push_error("STRIATA_order of %s is malformed and was ignored: %s" % [place, order.problem])
			continue
		var builder := Builder.new(order, state.meshes[index].mesh, meshes[index].primitives.size())
		if not builder.problem.is_empty():
			push_warning("The levels of %s were left out: %s" % [place, builder.problem])
			continue
		var all: Array = meshes[index].primitives
		var lacking := all.filter(func(primitive: Dictionary) -> bool: return primitive.get("mode", 4) == 4).size() - order.primitives.size()
		if lacking > 0:
			push_warning("%d surfaces of %s have no STRIATA_order, and stay at full detail while the others have levels" % [lacking, place])
		var mesh := builder.build()
		if Settings.value(Settings.KEEP_FROM_GENERATOR):
			# The editor makes its own levels only for meshes without this.
			mesh.get_mesh()
		state.meshes[index].mesh = mesh
	return OK


# Makes a mesh with levels from the one that Godot has imported and the lists of the file.
#
# The importer keeps in each surface only the vertices that its triangles use, in their order. A level may need others:
# where two materials meet, a vertex may collapse to one that only the other surface has. These are appended.
class Builder:
	## Why the mesh cannot have levels. It is empty if nothing is wrong.
	var problem := ""

	var _order: Order
	var _full: ImporterMesh
	# Vertices of the file in each surface, sorted; what is appended is in `_appended`.
	var _used := {}
	var _appended := {}
	# Numbers in each surface of the vertices of the file; -1 for those that it lacks. Surfaces that have all vertices have none.
	var _numbers := {}
	# A surface that has each vertex of the file, or -1.
	var _owner := PackedInt32Array()

	func _init(order: Order, full: ImporterMesh, primitive_count: int) -> void:
		_order = order
		_full = full
		if full.get_surface_count() != primitive_count:
			problem = "the importer made %d surfaces of %d primitives" % [full.get_surface_count(), primitive_count]
			return
		_owner.resize(order.vertex_count)
		_owner.fill(-1)
		for surface in order.primitives:
			_read_surface(surface)
		for surface in order.primitives:
			if problem.is_empty():
				_append_missing(surface)

	# Compares a surface with the file.
	func _read_surface(surface: int) -> void:
		var arrays := _full.get_surface_arrays(surface)
		var list: PackedInt32Array = _order.lists[surface][0]
		var count: int = arrays[Mesh.ARRAY_VERTEX].size()
		var used := PackedInt32Array(range(count)) if count == _order.vertex_count else Builder.distinct(list)
		_used[surface] = used
		for vertex in used:
			_owner[vertex] = surface
		var is_same: bool = count == used.size() and arrays[Mesh.ARRAY_INDEX] is PackedInt32Array and arrays[Mesh.ARRAY_INDEX] == _local(surface, list)
		if not is_same and problem.is_empty():
			problem = "the importer changed the vertices or triangles of surface %d (%d vertices instead of %d)" % [surface, count, used.size()]

	func _append_missing(surface: int) -> void:
		_appended[surface] = PackedInt32Array()
		if _used[surface].size() == _order.vertex_count:
			return
		var needed := PackedInt32Array()
		for list: PackedInt32Array in _order.lists[surface].slice(1):
			needed.append_array(list)
		var missing := PackedInt32Array()
		for vertex in Builder.distinct(needed):
			if not Builder.has(_used[surface], vertex):
				missing.append(vertex)
				if _owner[vertex] < 0:
					problem = "a level of surface %d uses vertex %d, which no surface has" % [surface, vertex]
					return
				if not _has_same_arrays(surface, _owner[vertex]):
					problem = "a level of surface %d needs vertices of surface %d, which has other attributes" % [surface, _owner[vertex]]
					return
		_appended[surface] = missing
		_numbers.erase(surface)

	func _has_same_arrays(a: int, b: int) -> bool:
		var kinds := [_full.get_surface_arrays(a), _full.get_surface_arrays(b)].map(func(arrays: Array) -> Array:
			return arrays.map(func(array: Variant) -> int: return typeof(array)))
		var flags := Mesh.ARRAY_FLAG_USE_8_BONE_WEIGHTS
		return kinds[0] == kinds[1] and (_full.get_surface_format(a) & flags) == (_full.get_surface_format(b) & flags)

	# Returns the mesh with levels.
	func build() -> ImporterMesh:
		var mesh := ImporterMesh.new()
		mesh.resource_name = _full.resource_name
		mesh.set_lightmap_size_hint(_full.get_lightmap_size_hint())
		mesh.set_blend_shape_mode(_full.get_blend_shape_mode())
		for meta in _full.get_meta_list():
			mesh.set_meta(meta, _full.get_meta(meta))
		var shapes := range(_full.get_blend_shape_count())
		for shape: int in shapes:
			mesh.add_blend_shape(_full.get_blend_shape_name(shape))
		for surface in _full.get_surface_count():
			var arrays := _full.get_surface_arrays(surface)
			var shape_arrays: Array[Array] = []
			for shape: int in shapes:
				shape_arrays.append(_full.get_surface_blend_shape_arrays(surface, shape))
			var lods := {}
			if _used.has(surface):
				arrays = _extended(surface, arrays, func(owner: int) -> Array: return _full.get_surface_arrays(owner))
				for shape: int in shapes:
					shape_arrays[shape] = _extended(surface, shape_arrays[shape], func(owner: int) -> Array: return _full.get_surface_blend_shape_arrays(owner, shape))
				lods = _lods(surface, arrays)
			mesh.add_surface(_full.get_surface_primitive_type(surface), arrays, shape_arrays, lods, _full.get_surface_material(surface), _full.get_surface_name(surface), _full.get_surface_format(surface))
		return mesh

	# Returns the levels of a surface: indices by error. May append a triangle to the full list in `arrays`.
	func _lods(surface: int, arrays: Array) -> Dictionary:
		var lods := {}
		var full: PackedInt32Array = arrays[Mesh.ARRAY_INDEX]
		var last := full
		for level in _order.errors.size():
			var list := _local(surface, _order.lists[surface][level + 1])
			if list.is_empty():
				# The engine refuses empty levels: a triangle without area shows as little.
				list = PackedInt32Array([full[0], full[0], full[0]])
			if list == last:
				continue
			if list.size() == full.size():
				# No triangle has vanished, but vertices have moved. The engine refuses levels that are no shorter than the full list.
				arrays[Mesh.ARRAY_INDEX] = full + PackedInt32Array([full[0], full[0], full[0]])
			lods[_order.errors[level]] = list
			last = list
		return lods

	# Returns arrays of a surface with its appended vertices.
	func _extended(surface: int, arrays: Array, arrays_of: Callable) -> Array:
		var appended: PackedInt32Array = _appended[surface]
		if appended.is_empty():
			return arrays
		var extended := arrays.duplicate()
		var count: int = _used[surface].size()
		for kind in arrays.size():
			if kind == Mesh.ARRAY_INDEX or arrays[kind] == null:
				continue
			var width: int = arrays[kind].size() / count
			var longer: Variant = arrays[kind].duplicate()
			for vertex in appended:
				var owner := _owner[vertex]
				var first: int = width * _used[owner].bsearch(vertex)
				longer.append_array(arrays_of.call(owner)[kind].slice(first, first + width))
			extended[kind] = longer
		return extended

	# Returns a list with the numbers of vertices in a surface instead of those of the file.
	func _local(surface: int, list: PackedInt32Array) -> PackedInt32Array:
		if _used[surface].size() == _order.vertex_count:
			return list
		if not _numbers.has(surface):
			var numbers := PackedInt32Array()
			numbers.resize(_order.vertex_count)
			numbers.fill(-1)
			var vertices: PackedInt32Array = _used[surface] + _appended.get(surface, PackedInt32Array())
			for number in vertices.size():
				numbers[vertices[number]] = number
			_numbers[surface] = numbers
		var map: PackedInt32Array = _numbers[surface]
		var local := list.duplicate()
		for i in local.size():
			local[i] = map[local[i]]
		return local

	static func distinct(list: PackedInt32Array) -> PackedInt32Array:
		var sorted := list.duplicate()
		sorted.sort()
		var kept := PackedInt32Array()
		for i in sorted.size():
			if i == 0 or sorted[i] != sorted[i - 1]:
				kept.append(sorted[i])
		return kept

	static func has(sorted: PackedInt32Array, value: int) -> bool:
		var place := sorted.bsearch(value)
		return place < sorted.size() and sorted[place] == value
