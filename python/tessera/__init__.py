"""Matching of shapes by the Pyramid of Arclength Descriptor (PAD), and libraries and results of Tessera.

>>> import tessera
>>> a, b = tessera.read_drawing("a.svg"), tessera.read_drawing("b.svg")
>>> tessera.match(a, b)
[<tessera.Match: score 0.656, 67.4 % of A, 63.7 % of B>]

Points are NumPy arrays of the shape (N, 2), in any unit of length. Values that are of no use raise
tessera.Error, a ValueError; arguments of another type raise TypeError.
Functions that compute for long let other threads of Python run; those that read a Library do not.
"""

from ._tessera import (
    CurvePart,
    Descriptor,
    Error,
    KnownOutlines,
    Library,
    Match,
    MatchedRun,
    Outline,
    Pads,
    Recognised,
    Similarity,
    __version__,
    distance_matrix,
    match,
    pad_descriptor,
    pads,
    read_drawing,
)
from .results import Piece, Result, read_card, read_result

__all__ = [
    "CurvePart",
    "Descriptor",
    "Error",
    "KnownOutlines",
    "Library",
    "Match",
    "MatchedRun",
    "Outline",
    "Pads",
    "Piece",
    "Recognised",
    "Result",
    "Similarity",
    "__version__",
    "distance_matrix",
    "match",
    "pad_descriptor",
    "pads",
    "read_card",
    "read_drawing",
    "read_result",
]
