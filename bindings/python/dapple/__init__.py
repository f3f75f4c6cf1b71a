"""Dapple: pictures into stipple drawings.

    import dapple
    from PIL import Image

    dots = dapple.stipple(Image.open("cat.jpg"), 40000, pens="cmyk")
    dots.save("cat.svg")

The same picture and settings give the same dots to the bit, as the program's, for any number of threads. What is wrong
ends in one sentence: a ValueError for a value, a TypeError for what is no such value at all, an OSError for a file.
Python's other threads go on while it draws, and Ctrl+C ends it.
"""

from __future__ import annotations

import dataclasses
import functools
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _dapple
from ._inputs import check_interpolation, floats, picture, settings_of, whole_number
from ._png import png

__all__ = [
    "Advice",
    "Dots",
    "Evenness",
    "Pen",
    "Plan",
    "Stippler",
    "analyse",
    "lights",
    "sample",
    "stipple",
    "tile_names",
    "tile_points",
    "tile_text",
    "usual_settings",
]
__version__ = _dapple.version

Interpolation = Literal["nearest", "linear"]


@dataclass(frozen=True)
class Pen:
    """Who draws some of the dots."""

    name: str
    colour: tuple[float, float, float]  #: red, green and blue, sRGB-encoded, 0 to 1


@dataclass(frozen=True)
class Advice:
    """What someone who is about to plot or print a drawing should know of it."""

    kind: str  #: "overlap"
    text: str  #: "40 % of the dots will overlap others. Use fewer dots"
    amount: float  #: that it speaks of: dots, millimetres or dots per inch; 0: none


@dataclass(frozen=True)
class Plan:
    """What settings come to on a picture, before a dot is placed."""

    dots: int  #: exactly, or about so many where none are asked for
    lowered: bool  #: more were asked for than there may be
    steps: int  #: of relaxing
    page_mm: tuple[float, float]  #: width and height, margins and all
    radius_mm: float  #: of all dots, or of the largest
    pens: list[Pen]  #: one: the ink
    # The tone as drawn, with what was chosen automatically, in the units of the settings.
    exposure: float
    black_point: float
    white_point: float
    contrast: float
    brightness: float
    gamma: float
    black: float


def _report(text: str) -> dict[str, Any]:
    """Of a plan or a drawing, with its pens and its page as they are handed out."""
    report = json.loads(text)
    pens = [Pen(pen["name"], tuple(pen["colour"])) for pen in report["pens"]]
    return {**report, "pens": pens, "page_mm": tuple(report["page_mm"])}


@dataclass(frozen=True)
class Evenness:
    """Free of the unit: distances are over the largest that so many points can all have, frequencies in units of the
    root of the number of points over the area."""

    count: int
    nearest_minimum: float
    nearest_first_percentile: float
    nearest_mean: float
    power_below_03: float  #: mean power there; white noise has 1
    power_below_05: float
    highest_bin: float  #: of the spectrum
    star_discrepancy: float
    l2_star_discrepancy: float


class Dots:
    """A drawing, which never changes. Its arrays are made when they are first asked for, and are read-only.

    It can be pickled, so that other processes may draw: with its arrays, and with what it was drawn of, from which it is
    drawn again if it is then saved.
    """

    def __init__(self, drawing: _dapple.Drawing, settings: str, source: _Source) -> None:
        self._drawing = drawing
        self._settings = settings
        self._source = source

    def __getstate__(self) -> dict[str, Any]:
        return {name: getattr(self, name) for name in ("_settings", "_source", "_report", "_arrays")}

    def __setstate__(self, state: dict[str, Any]) -> None:
        for array in state["_arrays"]:
            array.flags.writeable = False
        self.__dict__.update(state)

    def __copy__(self) -> Dots:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Dots:
        return self

    @functools.cached_property
    def _drawing(self) -> _dapple.Drawing:
        return self._source.stippler().draw(self._settings)

    @functools.cached_property
    def _report(self) -> dict[str, Any]:
        return _report(self._drawing.report())

    def __len__(self) -> int:
        return self._report["dots"]

    def __repr__(self) -> str:
        width, height = self.page_mm
        return f"<{len(self)} dots on {width:g} x {height:g} mm by {', '.join(pen.name for pen in self.pens)}>"

    @functools.cached_property
    def _arrays(self) -> tuple[NDArray[Any], ...]:
        arrays = self._drawing.arrays()
        for array in arrays:
            array.flags.writeable = False
        return arrays

    @property
    def x(self) -> NDArray[np.float32]:
        """float32, (n,): millimetres from the page's left edge."""
        return self._arrays[0]

    @property
    def y(self) -> NDArray[np.float32]:
        """float32, (n,): millimetres from the page's upper edge."""
        return self._arrays[1]

    @property
    def radius(self) -> NDArray[np.float32]:
        """float32, (n,): millimetres."""
        return self._arrays[2]

    @property
    def pen(self) -> NDArray[np.int32]:
        """int32, (n,): whose each dot is: a place in `pens`."""
        return self._arrays[3]

    @property
    def pens(self) -> list[Pen]:
        """One: the ink."""
        return list(self._report["pens"])

    @property
    def page_mm(self) -> tuple[float, float]:
        """Width and height of the page, margins and all."""
        return self._report["page_mm"]

    def pixels(self, dpi: float | None = None) -> NDArray[np.uint8]:
        """The page as uint8, (height, width, 3), sRGB-encoded; so many to the inch, or as many as the settings say."""
        return self._drawing.pixels(self._dpi if dpi is None else dpi)

    def advice(self, format: str = "svg") -> list[Advice]:
        """What to know before such a file is plotted or printed, the most important first; [] where all is well."""
        return [Advice(**each) for each in json.loads(self._drawing.findings(format))]

    def save(self, path: str | os.PathLike[str]) -> None:
        """Into a .svg, .png, .gcode, .nc, .hpgl, .plt, .dxf, .csv or .json, as `dapple render` does: with the
        settings' order, shapes, pens and resolution. The file is there once it is whole."""
        path = os.fspath(path)
        is_png = os.path.splitext(path)[1].lower() == ".png"
        part = path + ".part"
        try:
            if is_png:
                with open(part, "wb") as file:
                    file.write(png(self.pixels(), self._dpi, _dapple.settings(self._settings, "{}")[1]))
            else:
                self._drawing.save(part, path)
            os.replace(part, path)
        except OSError as error:
            raise OSError(error.errno, error.strerror, path) from None
        finally:
            if os.path.exists(part):
                os.remove(part)

    def _repr_png_(self) -> bytes:
        dpi = 25.4 * 800 / max(self.page_mm)  # as notebooks show it
        return png(self.pixels(dpi), dpi, "")

    @property
    def _dpi(self) -> float:
        return json.loads(self._settings)["saving"]["dpi"]


@dataclass(frozen=True)
class _Source:
    """What a stippler draws of, for whoever draws it again: nobody else changes the array."""

    threads: int
    pixels: NDArray[Any] | None = None
    reading: Literal["srgb", "light", "nearest", "linear"] = "srgb"
    tile: str = ""

    def stippler(self) -> _dapple.Stippler:
        stippler = _dapple.Stippler(self.threads)
        self.set_pixels(stippler)
        stippler.set_tile(self.tile)
        return stippler

    def set_pixels(self, stippler: _dapple.Stippler) -> None:
        if self.pixels is None:
            return
        if self.reading == "srgb":
            stippler.set_srgb(self.pixels)
        elif self.reading == "light":
            stippler.set_light(self.pixels)
        else:
            stippler.set_density(self.pixels, self.reading == "linear")


class Stippler:
    """Makes drawings of one picture after the other, and keeps what the next one can use again: a drawing whose
    settings differ a little takes a fraction of the first one's time.

        stippler = dapple.Stippler(picture)
        for contrast in 0, 0.1, 0.2:
            stippler.draw(tone={"contrast": contrast}).save(f"{contrast}.svg")

    `threads`: how many work; 0: one for each core. Python's threads may share one; they wait for each other.
    """

    def __init__(self, image: ArrayLike | None = None, *, linear: bool = False, threads: int = 0) -> None:
        self._source = _Source(whole_number("threads", threads, 0, 1024))
        self._stippler = self._source.stippler()
        if image is not None:
            self.set_picture(image, linear=linear)

    def __getstate__(self) -> _Source:
        return self._source

    def __setstate__(self, source: _Source) -> None:
        self._source = source
        self._stippler = source.stippler()

    def set_picture(self, image: ArrayLike, *, linear: bool = False) -> None:
        """As stipple() takes it."""
        pixels = picture(image)
        if linear and pixels.dtype != np.float32:
            raise TypeError(f"image is of {pixels.dtype}; linear light is of floats, from 0, black, to 1, paper")
        self._take(pixels, image, "light" if linear else "srgb")

    def _take(self, pixels: NDArray[Any], given: Any, reading: str) -> None:
        pixels = pixels.copy() if np.may_share_memory(pixels, given) else pixels
        source = dataclasses.replace(self._source, pixels=pixels, reading=reading)
        source.set_pixels(self._stippler)
        self._source = source

    def set_density(self, density: ArrayLike, *, interpolation: Interpolation = "nearest") -> None:
        """In place of a picture the density of the dots itself, which no tone changes: (height, width), 0 to 1, and 0
        where it is masked. `interpolation`: as sample() takes it."""
        check_interpolation(interpolation)
        self._take(floats("density", density, np.float32, "height", "width"), density, interpolation)

    def set_tile(self, text: str) -> None:
        """The text of a tile file, for all drawings from now on, whatever their settings name; "": these again."""
        self._stippler.set_tile(text)
        self._source = dataclasses.replace(self._source, tile=text)

    def plan(self, dots: int | None = None, *, settings: Mapping[str, Any] | str | None = None, **drawing: Any) -> Plan:
        """What draw() with these would come to."""
        found = _report(self._stippler.plan(settings_of(dots, settings, drawing)))
        everything = {**found.pop("tone"), **found}
        return Plan(**{field.name: everything[field.name] for field in dataclasses.fields(Plan)})

    def draw(self, dots: int | None = None, *, settings: Mapping[str, Any] | str | None = None, **drawing: Any) -> Dots:
        """As stipple() does."""
        whole = settings_of(dots, settings, drawing)
        source = self._source
        return Dots(self._stippler.draw(whole), whole, source)


def stipple(
    image: ArrayLike,
    dots: int | None = None,
    *,
    linear: bool = False,
    threads: int = 0,
    settings: Mapping[str, Any] | str | None = None,
    **drawing: Any,
) -> Dots:
    """Draws a picture.

    image: (height, width), or (height, width, channels) with 1 channel for grey, 2 for grey and alpha, 3 for red, green
        and blue, 4 for these and alpha; any strides. sRGB-encoded: uint8, uint16, bool or, from 0 to 1, floats. With
        `linear` floats are linear light, 0 black and 1 as light as paper, or lighter. What is transparent or masked
        shows white paper. PIL's images are taken as they are, of any mode that has colours or greys.
    dots: exactly so many, 1 to 10,000,000,000; usually 40,000.
    threads: how many work; 0: one for each core.
    drawing: fields of a project's "drawing" by their names, and `saving`, that of its files:
        stipple(image, pens="cmyk", tone={"contrast": 0.2}, page={"paper": "A4"}, saving={"dpi": 150}).
        usual_settings() lists them all.
    settings: a whole project, read from its JSON or as its text; what is said beside it comes on top.
    """
    stippler = Stippler(threads=threads)
    stippler.set_picture(image, linear=linear)
    return stippler.draw(dots, settings=settings, **drawing)


def sample(
    density: ArrayLike,
    n: int,
    *,
    interpolation: Interpolation = "nearest",
    relax: int = 60,
    tile: str = "kinds4096",
    threads: int = 0,
) -> NDArray[np.float32]:
    """Points, 1 to 10,000,000,000, whose density is that of an array (height, width) of numbers, 0 or more, in any unit.

    interpolation: "nearest": each number holds for all of its cell, and where it is 0 or masked there are no points.
        "linear": for the middle of its cell; between four middles the density changes evenly, as a picture's does, so
        that there are points up to half a cell beside zeros.
    relax: in so many steps, 0 to 100, they move to where sums over them come near to integrals over the density.

    Returns float32, (n, 2): x from 0 at the array's left edge to its width, y from 0 at its upper edge to its height; a
    point lies in density[int(y), int(x)].
    """
    weights = floats("density", density, np.float64, "height", "width")
    most = weights.max(initial=0)
    if not (np.isfinite(most) and weights.min(initial=0) >= 0):
        raise ValueError("density has a value that is negative or not finite")
    stippler = Stippler(threads=threads)
    stippler.set_density(weights / (most or 1), interpolation=interpolation)
    height, width = weights.shape
    edges = {"on": True, "top": 0, "right": 0, "bottom": 0, "left": 0}
    dots = stippler.draw(
        whole_number("n", n, 1, 10_000_000_000),
        relax=relax,
        settle_for="samples",
        tile=tile,
        page={"width_mm": width, "margins_mm": edges},
    )
    points = np.stack([dots.x, dots.y], axis=1)
    inside = np.nextafter(np.array([width, height], np.float32), np.float32(0))
    np.clip(points, 0, inside, out=points)
    if interpolation == "nearest":
        _leave_empty_cells(points, weights > 0)
    return points


def _leave_empty_cells(points: NDArray[np.float32], filled: NDArray[np.bool_]) -> None:
    """Where rounding to float32 has brought a point over the edge of its cell, it goes back."""

    def lies_in_empty(places: NDArray[np.float32]) -> NDArray[np.bool_]:
        column, row = places.astype(np.int64).T
        return ~filled[row, column]

    lost = np.flatnonzero(lies_in_empty(points))
    edge = np.rint(points[lost])
    last = np.float32(filled.shape[::-1])
    for across, down in (1, 0), (0, 1), (1, 1):
        # On the other side of the nearest edges.
        other = np.where(points[lost] < edge, np.minimum(edge, last - 1), np.nextafter(edge, np.float32(-1)))
        moved = np.where([across, down], np.maximum(other, 0), points[lost])
        found = ~lies_in_empty(moved)
        points[lost[found]] = moved[found]
        lost, edge = lost[~found], edge[~found]


def lights(radiance: ArrayLike, n: int = 1024, *, seed: int = 0, threads: int = 0) -> NDArray[np.void]:
    """An environment map as n small lights, 1 to 10,000,000, for renderers (Lagae & Dutré 2006, figure 7).

    radiance: (height, 2 * height, 3), linear red, green and blue, rows from straight up to straight down. What is
        masked is black.
    seed: 0: the tile as it lies; else it is turned about the up axis.

    Returns an array (n,) with the fields
        direction (3 float64): towards the light, of length 1: y is up, the middle of the map is at +z
        u, v (float64): on the map, 0 to 1, from its left and from its top
        weight (3 float64): irradiance on a surface that faces it; they sum to the map's flux
        pdf (float64): samples per steradian there, over their number
    """
    texels = floats("radiance", radiance, np.float32, "height", "width", 3)
    return _dapple.lights(
        texels,
        whole_number("n", n, 1, 10_000_000),
        whole_number("seed", seed, 0, 2**64 - 1),
        whole_number("threads", threads, 0, 1024),
    )


def analyse(points: ArrayLike, width: float = 1, height: float = 1, *, periodic: bool = True) -> Evenness:
    """How even points (n, 2) in a rectangle from 0 to width and 0 to height are, without those that are masked.
    Periodic: opposite edges meet; else nothing is known beyond the edges."""
    xy = floats("points", points, np.float64, "n", 2)
    seen = np.ascontiguousarray(xy[~np.ma.getmaskarray(points).any(axis=1)])
    return Evenness(**_dapple.evenness(seen, width, height, periodic))


def tile_names() -> list[str]:
    """The tiles that come with Dapple, as the setting `tile` takes them; the usual one is kinds4096."""
    return _dapple.tile_names()


def tile_text(name: str) -> str:
    """The text of a tile file, as Stippler.set_tile() takes it: of one that comes with Dapple, or of the paper's two
    integers, "14217,2895/16"."""
    return _dapple.tile_text(name)


def tile_points(text: str) -> NDArray[np.float64]:
    """The points of a tile of that text: float64, (kinds, n, 2), in a square from 0, 0 to 1, 1."""
    return _dapple.tile_points(text)


def usual_settings() -> dict[str, Any]:
    """All settings with their usual values: {"drawing": {...}, "saving": {...}}."""
    return json.loads(settings_of(None, None, {}))
