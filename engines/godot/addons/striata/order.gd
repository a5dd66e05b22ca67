# The levels of one mesh of a glTF file by the extension STRIATA_order: reads the extension, checks all of it, and makes the
# index lists of the levels. Indices are those of the file, with the winding of Godot (clockwise).
@tool
extends RefCounted

const Settings := preload("settings.gd")

const NAME := "STRIATA_order"
const UNSIGNED_INT := 5125
const INDEX_BYTES := {5121: 1, 5123: 2, UNSIGNED_INT: 4}
## Godot refuses levels with an error of 0.
const LEAST_ERROR := 1e-20

## Why the extension cannot be used. It is empty if nothing is wrong.
var problem := ""
## Vertices of the mesh, which all its primitives share.
var vertex_count := 0
## Primitives that have the extension, by their places in the mesh.
var primitives: Array[int] = []
## Errors of the levels after the full one; they rise.
var errors: Array[float] = []
## Index lists by primitive: the full one, then one for each error.
var lists := {}

var _state: GLTFState
var _targets: PackedInt32Array


# Reads the extension of a mesh, a dictionary of the file.
func _init(state: GLTFState, mesh: Dictionary) -> void:
	_state = state
	var all: Array = mesh.get("primitives", [])
	for index in all.size():
		var extensions: Variant = all[index].get("extensions")
		if extensions is Dictionary and extensions.has(NAME):
			primitives.append(index)
	if primitives.is_empty():
		return
	var orders: Array = primitives.map(func(index: int) -> Variant: return all[index].extensions[NAME])
	for order: Variant in orders:
		_expect(order is Dictionary and _is_number(order.get("targets")), "it has no targets")
		_expect(order is Dictionary and _is_table(order.get("levels"), 3), "its levels are no rows of [vertices, triangles, error]")
	if problem.is_empty():
		_read_targets(orders, all)
	if problem.is_empty():
		_check_levels(orders)
	if problem.is_empty():
		_read_lists(orders, all)


func _expect(holds: bool, otherwise: String) -> bool:
	if not holds and problem.is_empty():
		problem = otherwise
	return holds


static func _is_number(value: Variant) -> bool:
	return (value is float or value is int) and value >= 0


static func _is_table(table: Variant, width: int) -> bool:
	return table is Array and not table.is_empty() and table.all(func(row: Variant) -> bool:
		return row is Array and row.size() == width and row.all(_is_number))


func _read_targets(orders: Array, all: Array) -> void:
	var positions: Variant = all[primitives[0]].get("attributes", {}).get("POSITION")
	vertex_count = int(_accessor(positions).get("count", 0))
	for index in orders.size():
		_expect(orders[index].targets == orders[0].targets, "its primitives have different targets")
		_expect(all[primitives[index]].get("attributes", {}).get("POSITION") == positions, "its primitives have different vertices")
		_expect(all[primitives[index]].get("mode", 4) == 4, "a primitive with the extension is no list of triangles")
	if not problem.is_empty():
		return
	_expect(_accessor(orders[0].targets).get("componentType") == UNSIGNED_INT, "its targets are no unsigned 32-bit integers")
	_targets = _integers(orders[0].targets, "targets")
	if not _expect(_targets.size() == vertex_count, "it has %d targets for %d vertices" % [_targets.size(), vertex_count]):
		return
	for vertex in vertex_count:
		var target := _targets[vertex]
		if target > vertex or target < 0:
			_expect(false, "the target of vertex %d is %d" % [vertex, target])
			return


func _check_levels(orders: Array) -> void:
	var rows: Array = orders[0].levels
	_expect(rows[0][0] == vertex_count, "its first level has %d of %d vertices" % [rows[0][0], vertex_count])
	for index in range(1, rows.size()):
		_expect(rows[index][0] < rows[index - 1][0], "the vertices of its levels do not fall")
		_expect(rows[index][2] >= rows[index - 1][2], "the errors of its levels fall")
	for order: Dictionary in orders:
		_expect(order.levels.size() == rows.size(), "its primitives have different levels")
		for index in mini(rows.size(), order.levels.size()):
			var row: Array = order.levels[index]
			_expect(row[0] == rows[index][0] and row[2] == rows[index][2], "its primitives have different levels")
	var last := int(rows[-1][0])
	for vertex in range(last, vertex_count):
		if _targets[vertex] == vertex:
			_expect(false, "vertex %d is not in its coarsest level and has no target" % vertex)
			return


# Makes the full list and those of all levels that the settings ask for.
func _read_lists(orders: Array, all: Array) -> void:
	for index in orders.size():
		_expect(all[primitives[index]].has("indices"), "a primitive has no indices")
		if not problem.is_empty():
			return
		var full := _clockwise(_integers(all[primitives[index]].indices, "indices"))
		_check_list(full, orders[index].levels[0], vertex_count)
		lists[primitives[index]] = [full]
	if not problem.is_empty():
		return
	if Settings.value(Settings.USE_STORED_RANGES) and orders.any(func(order: Dictionary) -> bool: return order.has("ranges")):
		_read_ranges(orders)
		return
	var identity := PackedInt32Array(range(vertex_count))
	var finer := vertex_count
	for row in _chosen_rows(orders):
		var n := int(orders[0].levels[row][0])
		var map := level_map(_targets, n, finer, identity)
		_add_level(orders, row, primitives.map(func(index: int) -> PackedInt32Array: return level_indices(lists[index][-1], map)))
		finer = n


func _read_ranges(orders: Array) -> void:
	var buffers: Array[PackedInt32Array] = []
	var count: int = orders.map(func(order: Dictionary) -> int: return order.get("ranges", []).size()).max()
	for order: Dictionary in orders:
		_expect(_is_table(order.get("ranges"), 4), "its ranges are no rows of [first index, index count, vertices, error]")
		_expect(_is_number(order.get("indices")), "its ranges have no indices")
		if not problem.is_empty():
			return
		_expect(order.ranges.size() == count and count <= order.levels.size(), "its ranges are not the first levels")
		for row in mini(count, order.levels.size()):
			var range_row: Array = order.ranges[mini(row, order.ranges.size() - 1)]
			var level: Array = order.levels[row]
			_expect(range_row[2] == level[0] and range_row[1] == 3 * level[1] and range_row[3] == level[2], "its ranges are not the first levels")
		buffers.append(_integers(order.indices, "indices of ranges"))
	if not problem.is_empty():
		return
	for row in range(1, count):
		var level: Array = []
		for index in orders.size():
			var first := int(orders[index].ranges[row][0])
			var list := _clockwise(buffers[index].slice(first, first + int(orders[index].ranges[row][1])))
			_check_list(list, orders[index].levels[row], int(orders[index].levels[row][0]))
			level.append(list)
		_add_level(orders, row, level)


# Adds one level, a list for each primitive. Of levels with the same error, the coarsest one stays.
func _add_level(orders: Array, row: int, level: Array) -> void:
	var error := maxf(orders[0].levels[row][2], LEAST_ERROR)
	var replaces := not errors.is_empty() and errors[-1] == error
	if not replaces:
		errors.append(error)
	for index in orders.size():
		_check_list(level[index], orders[index].levels[row])
		if replaces:
			lists[primitives[index]][-1] = level[index]
		else:
			lists[primitives[index]].append(level[index])


# Returns the rows of the table that become levels by the settings.
func _chosen_rows(orders: Array) -> Array[int]:
	var chosen: Array[int] = []
	var triangles := func(row: int) -> float:
		return orders.reduce(func(sum: float, order: Dictionary) -> float: return sum + order.levels[row][1], 0.0)
	var last: float = triangles.call(0)
	for row in range(1, orders[0].levels.size()):
		var count: float = triangles.call(row)
		if chosen.size() + 1 >= Settings.value(Settings.MAXIMUM_LEVEL_COUNT) or count < Settings.value(Settings.MINIMUM_TRIANGLE_COUNT):
			break
		if count <= last * Settings.value(Settings.MAXIMUM_TRIANGLE_RATIO):
			chosen.append(row)
			last = count
	return chosen


# Checks the number of triangles of a list, and unless the list was made by the rule, that its vertices are below a limit.
func _check_list(list: PackedInt32Array, level: Array, limit := -1) -> void:
	_expect(list.size() == 3 * int(level[1]), "the level of %d vertices has %d triangles instead of %d" % [level[0], list.size() / 3, level[1]])
	if limit >= 0 and not list.is_empty():
		var sorted := list.duplicate()
		sorted.sort()
		_expect(sorted[0] >= 0 and sorted[-1] < limit, "the level of %d vertices uses vertex %d" % [level[0], sorted[-1]])


# The rule of the extension: the vertex that stands for each vertex in the level with `n` vertices. Only the first `finer`
# vertices are in use. `identity` maps each vertex to itself.
static func level_map(targets: PackedInt32Array, n: int, finer: int, identity: PackedInt32Array) -> PackedInt32Array:
	var map := identity.duplicate()
	for i in range(n, finer):
		map[i] = map[targets[i]]
	return map


# The triangles of a list, the full one or that of any finer level, that are left in a level.
static func level_indices(indices: PackedInt32Array, map: PackedInt32Array) -> PackedInt32Array:
	var level := indices.duplicate()
	var count := 0
	for i in range(0, indices.size(), 3):
		var a := map[indices[i]]
		var b := map[indices[i + 1]]
		var c := map[indices[i + 2]]
		if a != b and b != c and c != a:
			level[count] = a
			level[count + 1] = b
			level[count + 2] = c
			count += 3
	level.resize(count)
	return level


static func _clockwise(indices: PackedInt32Array) -> PackedInt32Array:
	for i in range(0, indices.size() - 2, 3):
		var second := indices[i + 1]
		indices[i + 1] = indices[i + 2]
		indices[i + 2] = second
	return indices


func _accessor(index: Variant) -> Dictionary:
	var all: Array = _state.json.get("accessors", [])
	return all[int(index)] if _is_number(index) and index < all.size() else {}


# Returns the integers of an accessor. Whatever does not fit is a problem.
func _integers(index: Variant, what: String) -> PackedInt32Array:
	var accessor := _accessor(index)
	var views: Array = _state.json.get("bufferViews", [])
	var view_index: Variant = accessor.get("bufferView")
	var is_plain: bool = accessor.get("type") == "SCALAR" and not accessor.has("sparse") and INDEX_BYTES.has(int(accessor.get("componentType", 0)))
	if not _expect(is_plain and _is_number(view_index) and view_index < views.size(), "the accessor of its %s is missing or of the wrong type" % what):
		return PackedInt32Array()
	var view: Dictionary = views[int(view_index)]
	var width: int = INDEX_BYTES[int(accessor.componentType)]
	var offset := int(accessor.get("byteOffset", 0))
	var count := int(accessor.get("count", 0))
	var buffer := int(view.get("buffer", -1))
	var start := int(view.get("byteOffset", 0)) + offset
	var is_inside: bool = buffer >= 0 and buffer < _state.buffers.size() and offset >= 0 and count >= 0 and int(view.get("byteStride", width)) == width \
		and offset + width * count <= int(view.get("byteLength", 0)) and start + width * count <= _state.buffers[buffer].size()
	if not _expect(is_inside, "the accessor of its %s does not fit into the file" % what):
		return PackedInt32Array()
	var bytes: PackedByteArray = _state.buffers[buffer].slice(start, start + width * count)
	if width == 4:
		return bytes.to_int32_array()
	var integers := PackedInt32Array()
	integers.resize(count)
	for i in count:
		integers[i] = bytes.decode_u16(2 * i) if width == 2 else bytes[i]
	return integers
