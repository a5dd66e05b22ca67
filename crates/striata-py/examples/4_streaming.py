# ---
# jupyter:
#   jupytext:
#     formats: py:percent
#   kernelspec:
#     display_name: Python 3
#     name: python3
# ---

# %% [markdown]
# # Streaming
#
# A stream is a mesh compressed from coarse to fine: every prefix of its bytes is a mesh.

# %%
import striata

points, faces = striata.shapes.terrain(200)
stream = striata.encode(points, faces)
print(f"{(points.nbytes + faces.nbytes) / len(stream):.0f} times smaller than the arrays")

# %% [markdown]
# A decoder takes bytes as they arrive, from a file or a network.

# %%
decoder = striata.StreamDecoder()
piece = len(stream) // 8 + 1
for start in range(0, len(stream), piece):
    decoder.push(stream[start : start + piece])
    print(f"{start + piece:>7} bytes: {len(decoder.faces):>6} triangles, error {decoder.error}")
assert decoder.is_complete

# %% [markdown]
# The part that has arrived has all of its levels.

# %%
decoder.lod().level(triangles=1000)

# %% [markdown]
# In a notebook, levels show themselves.

# %%
striata.build(points, faces)
