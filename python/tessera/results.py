"""Results of `tessera collage`: pieces, job, manifest and quality card (docs/result-format.md says what they hold)."""

import json
import os
import tomllib
from dataclasses import dataclass, field

import numpy

from ._tessera import Error, Similarity

_MOST_BYTES = 512 << 20


@dataclass(frozen=True)
class Piece:
    """A placed piece. Lengths are in px of the canvas; y points down."""

    index: int  # 0, 1, 2, ... in order of placement
    shape: str  # name in the library
    canvas_from_shape: Similarity  # from the shape's frame (Library.outline) to the canvas; a mirrored piece is mirrored first
    mirrored: bool
    polygon: list[numpy.ndarray]  # of the shape (N, 2): the outer ring, then the holes; the first point is not repeated
    properties: dict = field(repr=False)  # all properties that pieces.geojson has for it

    @property
    def scale_px(self) -> float:
        """The square root of the piece's area."""
        return self.canvas_from_shape.scale


@dataclass(frozen=True)
class Result:
    """The files of a result's folder, without its pictures."""

    folder: str
    pieces: list[Piece] = field(repr=False)
    job: dict = field(repr=False)  # every key of the job with its value
    manifest: dict = field(repr=False)
    card: dict | None = field(repr=False)  # None where the run was interrupted before it made one

    @property
    def finished(self) -> bool:
        return self.manifest.get("state") == "finished"


def read_result(folder) -> Result:
    """Reads a folder that `tessera collage` has made. Raises Error, which names the file that is missing or damaged."""
    folder = os.fspath(folder)
    manifest = _read_json(os.path.join(folder, "manifest.json"), "the folder of a result")
    pieces_file = os.path.join(folder, "pieces.geojson")
    pieces = _read_json(pieces_file, "a whole result")
    card_file = os.path.join(folder, "card.json")
    return Result(
        folder=folder,
        pieces=_pieces_of(pieces, pieces_file),
        job=_parsed(os.path.join(folder, "job.toml"), "a whole result", tomllib.loads),
        manifest=manifest,
        card=read_card(card_file) if os.path.exists(card_file) else None,
    )


def read_card(path) -> dict:
    """Reads a quality card: the file card.json, or the folder of a result. Its sections and keys stand in
    docs/result-format.md, their units too. Raises Error, which names the file."""
    path = os.fspath(path)
    return _read_json(os.path.join(path, "card.json") if os.path.isdir(path) else path, "a card.json or its folder")


def _read_json(path: str, allowed: str) -> dict:
    content = _parsed(path, allowed, json.loads)
    if not isinstance(content, dict):
        raise Error(f"{path}: found {type(content).__name__}, allowed: an object with keys")
    return content


def _parsed(path: str, allowed: str, parse):
    try:
        if not os.path.isfile(path):
            raise Error(f"{path}: not found; allowed: {allowed}")
        if os.path.getsize(path) > _MOST_BYTES:
            raise Error(f"{path}: found {os.path.getsize(path)} bytes, allowed: {_MOST_BYTES} or fewer")
        with open(path, encoding="utf-8") as file:
            return parse(file.read())
    except OSError as error:
        raise Error(f"{path}: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        if isinstance(error, Error):
            raise
        raise Error(f"{path}: damaged: {error}") from error


def _pieces_of(collection: dict, path: str) -> list[Piece]:
    features = collection.get("features")
    if not isinstance(features, list):
        raise Error(f"{path}: damaged: no list of features")
    return [_piece_of(feature, f"{path}: piece {index}") for index, feature in enumerate(features)]


def _piece_of(feature: dict, name: str) -> Piece:
    try:
        properties = feature["properties"]
        a, b, x, y = (float(number) for number in properties["canvas_from_shape"])
        rings = [numpy.array(ring, dtype=float)[:-1] for ring in feature["geometry"]["coordinates"]]
        if not rings or any(ring.ndim != 2 or ring.shape[1] != 2 for ring in rings):
            raise ValueError("a polygon without rings of [x, y]")
        if not all(numpy.isfinite(numbers).all() for numbers in ([a, b, x, y], *rings)):
            raise ValueError("a number that is not finite")
        return Piece(
            index=int(properties["index"]),
            shape=str(properties["shape"]),
            canvas_from_shape=Similarity(a, b, x, y),
            mirrored=bool(properties["mirrored"]),
            polygon=rings,
            properties=properties,
        )
    except (KeyError, TypeError, ValueError, IndexError, OverflowError) as error:
        raise Error(f"{name}: damaged: {error!r}") from error
