# ---
# jupyter:
#   jupytext:
#     formats: py:percent
#   kernelspec:
#     display_name: Python 3
#     name: python3
# ---

# %% [markdown]
# # Simplify with point data
#
# Points and faces are arrays. Whatever belongs to the points follows the ones that remain.

# %%
import numpy as np
import striata

points, faces = striata.shapes.terrain(100)
temperature = 20 - 30 * points[:, 2] + np.tanh(60 * (points[:, 0] - 0.5))
label = np.digitize(points[:, 2], [-0.1, 0.0, 0.1])

# %%
small = striata.simplify(
    points, faces, ratio=0.05, attributes={"temperature": temperature, "label": label}
)
print(len(faces), "->", len(small.faces), "triangles, error", small.error)
assert np.array_equal(small.attributes["label"], label[small.vertices])

# %% [markdown]
# The front in the middle is a step of the temperature on smooth hills. With a weight, it counts in the cost,
# so more points are kept there.

# %%
weighted = striata.simplify(
    points,
    faces,
    ratio=0.05,
    attributes={"temperature": temperature},
    weights={"temperature": 0.05},
)


def share_near_the_front(mesh):
    return np.mean(np.abs(mesh.points[:, 0] - 0.5) < 0.05)


print(f"near the front: {share_near_the_front(small):.0%} of the points, with a weight {share_near_the_front(weighted):.0%}")
assert share_near_the_front(weighted) > share_near_the_front(small)

# %% [markdown]
# Meshes of other packages come back as they are, with everything attached to them.

# %%
import trimesh

mesh = trimesh.Trimesh(points, faces, process=False)
mesh.vertex_attributes["label"] = label
striata.simplify(mesh, triangles=1000).vertex_attributes["label"]
