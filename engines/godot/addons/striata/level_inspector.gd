# Lists the levels of a mesh at the top of the inspector.
@tool
extends EditorInspectorPlugin

const LevelTable := preload("level_table.gd")


func _can_handle(object: Object) -> bool:
	return LevelTable.mesh_of(object) != null


func _parse_begin(object: Object) -> void:
	var rows := LevelTable.rows(LevelTable.mesh_of(object))
	if rows.size() > 1:
		add_custom_control(LevelTable.control(rows))
