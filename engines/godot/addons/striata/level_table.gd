# The levels of a mesh with their triangles and errors. It needs no editor.
@tool
extends RefCounted


# Returns the mesh that an object is or shows, if it can have levels.
static func mesh_of(object: Object) -> Resource:
	var mesh: Variant = object.get("mesh") if object is MeshInstance3D or object is ImporterMeshInstance3D else object
	return mesh if mesh is ArrayMesh or mesh is ImporterMesh else null


# Returns a row `{triangles, error}` for each level, from the full mesh to the coarsest one. The engine chooses levels by
# their errors, so a level of a mesh has, for each surface, the coarsest list with at most its error.
static func rows(mesh: Resource) -> Array[Dictionary]:
	var surfaces: Array = []
	for index in mesh.get_surface_count():
		surfaces.append(_importer_lists(mesh, index) if mesh is ImporterMesh else _array_lists(mesh, index))
	var errors := {}
	for lists: Dictionary in surfaces:
		for error: float in lists:
			errors[error] = true
	var sorted := errors.keys()
	sorted.sort()
	var rows: Array[Dictionary] = []
	for error: float in sorted:
		var triangles := 0
		for lists: Dictionary in surfaces:
			var shown := 0.0
			for own: float in lists:
				if own <= error and own > shown:
					shown = own
			triangles += lists.get(shown, 0)
		rows.append({"triangles": triangles, "error": error})
	return rows


# Returns the table as a control.
static func control(rows: Array[Dictionary]) -> Control:
	var grid := GridContainer.new()
	grid.columns = 3
	for title: String in ["Level", "Triangles", "Error"]:
		grid.add_child(_cell(title))
	for level in rows.size():
		grid.add_child(_cell(str(level)))
		grid.add_child(_cell(str(rows[level].triangles)))
		grid.add_child(_cell(String.num(rows[level].error, 6)))
	return grid


# Triangles of the lists of a surface by their errors; that of the full surface is 0.
static func _importer_lists(mesh: ImporterMesh, surface: int) -> Dictionary:
	if mesh.get_surface_primitive_type(surface) != Mesh.PRIMITIVE_TRIANGLES:
		return {}
	var arrays := mesh.get_surface_arrays(surface)
	var lists := {0.0: _triangles(arrays)}
	for lod in mesh.get_surface_lod_count(surface):
		lists[mesh.get_surface_lod_size(surface, lod)] = mesh.get_surface_lod_indices(surface, lod).size() / 3
	return lists


static func _array_lists(mesh: ArrayMesh, surface: int) -> Dictionary:
	if mesh.surface_get_primitive_type(surface) != Mesh.PRIMITIVE_TRIANGLES:
		return {}
	var index_count := mesh.surface_get_array_index_len(surface)
	var vertex_count := mesh.surface_get_array_len(surface)
	var lists := {0.0: (index_count if index_count > 0 else vertex_count) / 3}
	var index_bytes := 2 if vertex_count <= 65536 else 4
	for lod: Dictionary in RenderingServer.mesh_get_surface(mesh.get_rid(), surface).get("lods", []):
		lists[lod.edge_length] = lod.index_data.size() / index_bytes / 3
	return lists


static func _triangles(arrays: Array) -> int:
	var indices: Variant = arrays[Mesh.ARRAY_INDEX]
	return (arrays[Mesh.ARRAY_VERTEX].size() if indices == null else indices.size()) / 3


static func _cell(text: String) -> Label:
	var label := Label.new()
	label.text = text
	label.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	return label
