# Settings of the import, which lie in the project settings under "striata/import".
@tool
extends RefCounted

## Import the index ranges that a file stores (`striata build --ranges N`), as they are. The settings below apply to files without.
const USE_STORED_RANGES := "striata/import/use_stored_ranges"
## Largest number of levels, the full mesh included.
const MAXIMUM_LEVEL_COUNT := "striata/import/maximum_level_count"
## A level has at most this share of the triangles of the level before it.
const MAXIMUM_TRIANGLE_RATIO := "striata/import/maximum_triangle_ratio"
## Levels with fewer triangles are left out.
const MINIMUM_TRIANGLE_COUNT := "striata/import/minimum_triangle_count"
## Keep the editor from replacing the levels with its own. If this is off, turn off "Generate LODs" in the Import dock.
const KEEP_FROM_GENERATOR := "striata/import/keep_from_generator"

const DEFAULTS := {
	USE_STORED_RANGES: true,
	MAXIMUM_LEVEL_COUNT: 16,
	MAXIMUM_TRIANGLE_RATIO: 0.75,
	MINIMUM_TRIANGLE_COUNT: 12,
	KEEP_FROM_GENERATOR: true,
}

const RANGES := {
	MAXIMUM_LEVEL_COUNT: "1,64",
	MAXIMUM_TRIANGLE_RATIO: "0.05,1,0.05",
	MINIMUM_TRIANGLE_COUNT: "0,10000,1,or_greater",
}


static func value(name: String) -> Variant:
	return ProjectSettings.get_setting(name, DEFAULTS[name])


# Makes the settings visible in the dialog of the project settings.
static func add_to_project() -> void:
	for name: String in DEFAULTS:
		if not ProjectSettings.has_setting(name):
			ProjectSettings.set_setting(name, DEFAULTS[name])
		ProjectSettings.set_initial_value(name, DEFAULTS[name])
		var info := {"name": name, "type": typeof(DEFAULTS[name])}
		if RANGES.has(name):
			info.merge({"hint": PROPERTY_HINT_RANGE, "hint_string": RANGES[name]})
		ProjectSettings.add_property_info(info)
