"""Plots of levels with matplotlib, which is imported only here."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._lod import Lod


def error(lod: Lod[Any], *, ax: Any = None, relative: bool = True) -> Any:
    """Draw the error of all levels over their number of faces.

    Parameters
    ----------
    lod : Lod
        The levels.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default a new figure.
    relative : bool
        Whether errors are shares of the diagonal instead of mesh units.

    Returns
    -------
    matplotlib.axes.Axes
        The axes.
    """
    if ax is None:
        try:
            import matplotlib.pyplot as plt
        except ImportError:
            raise ImportError("striata.plot needs matplotlib: pip install 'striata[plot]'") from None
        _, ax = plt.subplots()
    sequence = lod.sequence
    scale = 100.0 / lod.diagonal if relative and lod.diagonal > 0 else 1.0
    shown = sequence.error > 0
    ax.plot(sequence.faces[shown], np.asarray(sequence.error)[shown] * scale)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel("triangles")
    ax.set_ylabel("error (% of the diagonal)" if relative else "error (mesh units)")
    return ax
