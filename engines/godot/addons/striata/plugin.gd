# Adds the import of levels and the inspector's table to the editor.
@tool
extends EditorPlugin

const Settings := preload("settings.gd")

var _import: GLTFDocumentExtension = preload("order_import.gd").new()
var _inspector: EditorInspectorPlugin = preload("level_inspector.gd").new()


func _enter_tree() -> void:
	Settings.add_to_project()
	GLTFDocument.register_gltf_document_extension(_import)
	add_inspector_plugin(_inspector)


func _exit_tree() -> void:
	remove_inspector_plugin(_inspector)
	GLTFDocument.unregister_gltf_document_extension(_import)
