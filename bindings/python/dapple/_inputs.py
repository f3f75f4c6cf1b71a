"""What people give, as the module in C++ takes it."""

from __future__ import annotations

import json
import operator
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _dapple


def whole_number(name: str, value: Any, least: int, most: int) -> int:
    if isinstance(value, (bool, np.bool_)) or not hasattr(value, "__index__"):
        raise TypeError(f"{name} is {value!r}; give a whole number")
    number = operator.index(value)
    if not least <= number <= most:
        raise ValueError(f"{name} is {number}; give a whole number from {least} to {most}")
    return number


def floats(name: str, values: ArrayLike, dtype: Any, *shape: str | int) -> NDArray[Any]:
    """As a contiguous array of that shape, where a name stands for any number. What is masked is 0."""
    array = np.ma.filled(values, 0) if np.ma.isMaskedArray(values) else np.asarray(values)
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{name} is of {array.dtype}; give an array of numbers")
    fits = len(array.shape) == len(shape) and all(
        isinstance(want, str) or want == have for want, have in zip(shape, array.shape)
    )
    if not fits:
        raise ValueError(f"{name} has the shape {array.shape}; give ({', '.join(map(str, shape))})")
    with np.errstate(over="ignore"):  # what becomes infinite so is refused as that
        return np.ascontiguousarray(array, dtype=dtype)


# What numpy makes of PIL's other modes are the pixels that they show.
_AS_PIL = {"P": "RGBA", "PA": "RGBA", "RGBa": "RGBA", "La": "LA"} | dict.fromkeys(
    ["CMYK", "YCbCr", "LAB", "HSV", "RGBX"], "RGB"
)


def picture(image: Any) -> NDArray[Any]:
    """(height, width, channels), contiguous, uint8, uint16 or float32. What is masked is white and opaque."""
    mode = getattr(image, "mode", None)
    if mode is not None and hasattr(image, "convert"):
        see_through = {"1": "LA", "L": "LA", "RGB": "RGBA"} if "transparency" in image.info else {}
        if as_mode := see_through.get(mode) or _AS_PIL.get(mode):
            image = image.convert(as_mode)
    pixels = np.asarray(image)
    if np.ma.isMaskedArray(image):
        masked = np.ma.getmaskarray(image)
        if pixels.ndim == 3:  # a pixel with one of its channels
            masked = masked.any(axis=2, keepdims=True)
        white = np.iinfo(pixels.dtype).max if pixels.dtype.kind == "u" else 1
        pixels = np.where(masked, pixels.dtype.type(white), pixels)
    if pixels.ndim == 2:
        pixels = pixels[..., None]
    if mode == "I" and pixels.size and 0 <= pixels.min() and pixels.max() < 2**16:
        pixels = pixels.astype(np.uint16)  # that is how PIL opens them
    kind, size = pixels.dtype.kind, pixels.dtype.itemsize
    if kind == "b":
        pixels = pixels * np.uint8(255)
    elif kind != "f" and not (kind == "u" and size <= 2):
        raise TypeError(f"image is of {pixels.dtype}; give uint8, uint16 or floats, of a file what PIL opens")
    if pixels.ndim != 3 or not 1 <= pixels.shape[2] <= 4:
        raise ValueError(
            f"image has the shape {np.shape(image)}; give (height, width), or 1 to 4 channels as a third axis"
        )
    with np.errstate(over="ignore"):
        return np.ascontiguousarray(pixels, dtype=np.float32 if kind == "f" else pixels.dtype.newbyteorder("="))


def check_interpolation(interpolation: str) -> None:
    if interpolation not in ("nearest", "linear"):
        raise ValueError(f"interpolation is {interpolation!r}; give 'nearest' or 'linear'")


def settings_of(dots: int | None, settings: Mapping[str, Any] | str | None, drawing: dict[str, Any]) -> str:
    """All settings, as their JSON: the usual ones, changed by `settings`, by `drawing`, and to so many dots."""
    given = "{}" if settings is None else settings if isinstance(settings, str) else _json(settings)
    if dots is not None:
        drawing = {**drawing, "count": whole_number("dots", dots, 1, 10_000_000_000)}
    saving = {"saving": drawing.pop("saving")} if "saving" in drawing else {}
    return _dapple.settings(given, _json({"drawing": drawing, **saving}))[0]


def _json(value: Any) -> str:
    def plain(other: Any) -> Any:
        if isinstance(other, (np.generic, np.ndarray)):
            return other.tolist()
        raise TypeError(f"settings: {other!r} cannot be written as JSON")

    try:
        return json.dumps(value, default=plain, allow_nan=False)
    except ValueError:
        raise ValueError("settings: a number is infinite, or none at all; give finite ones") from None
