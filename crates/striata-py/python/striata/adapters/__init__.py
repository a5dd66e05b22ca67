"""Meshes of other packages; each module is imported only if one of its meshes was passed in."""
