# ---
# jupyter:
#   jupytext:
#     formats: py:percent
#   kernelspec:
#     display_name: Python 3
#     name: python3
# ---

# %% [markdown]
# # Every level of a scan
#
# `build` removes one point after another and keeps the order. Every level of detail is then a lookup.

# %%
import numpy as np
import striata

points, faces = striata.shapes.torus(200, 100)  # or striata.build("scan.ply")
points += np.random.default_rng(0).normal(scale=0.002, size=points.shape).astype(np.float32)
lod = striata.build(points, faces, guaranteed=True)
lod

# %%
for error in ("0.1%", "0.5%", "2%"):
    level = lod.level(max_error=error)
    print(f"{error} of the diagonal: {level.triangle_count} triangles, at most {level.error:.4f} away")

# %% [markdown]
# The errors of all levels, over the number of triangles.

# %%
import matplotlib

matplotlib.use("Agg")
striata.plot.error(lod)

# %% [markdown]
# Labels from a coarse level go back to every point of the scan.

# %%
level = lod.level(triangles=500)
prediction = np.zeros(len(points), dtype=int)
prediction[level.vertices] = points[level.vertices, 0] > 0
everywhere = prediction[lod.fine_to_coarse(level)]
print(f"{np.mean(everywhere == (points[:, 0] > 0)):.1%} of the points have the right label")
assert np.mean(everywhere == (points[:, 0] > 0)) > 0.9

# %% [markdown]
# The sequence of collapses, for analysis and training.

# %%
sequence = lod.sequence
sequence.removed[:5], sequence.target[:5], sequence.error[:5]
