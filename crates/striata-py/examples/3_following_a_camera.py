# ---
# jupyter:
#   jupytext:
#     formats: py:percent
#   kernelspec:
#     display_name: Python 3
#     name: python3
# ---

# %% [markdown]
# # Following a camera in PyVista
#
# A view refines the mesh where errors would be visible, and coarsens the rest. All views share the points.

# %%
import numpy as np
import striata

points, faces = striata.shapes.terrain(300)
lod = striata.build(points, faces)
view = lod.view()

# %%
for height in (0.2, 0.5, 2.0):
    view.update(eye=(0.5, -height, height), target=(0.5, 0.5, 0.0), fov=30, pixels=1.0, screen=(1024, 768))
    print(f"from {height}: {view.triangle_count} of {lod.face_count} triangles")

# %% [markdown]
# PyVista draws the points once; each frame only replaces the faces.

# %%
try:
    import pyvista as pv
except ImportError:
    print("PyVista is not installed")
else:
    camera = pv.Camera()
    camera.position, camera.focal_point, camera.up = (0.5, -0.3, 0.3), (0.5, 0.5, 0.0), (0, 0, 1)
    mesh = pv.PolyData.from_regular_faces(lod.points, faces[:1])

    def follow(camera, screen=(1024, 768)):
        view.update(
            eye=camera.position,
            target=camera.focal_point,
            up=camera.up,
            fov=camera.view_angle,
            screen=screen,
        )
        mesh.regular_faces = np.asarray(view.faces)

    follow(camera)
    print(mesh.n_cells, "cells")
    # In a window:
    # plotter = pv.Plotter(); plotter.add_mesh(mesh)
    # plotter.add_on_render_callback(lambda p: follow(p.camera, p.window_size)); plotter.show()
