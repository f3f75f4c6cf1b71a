"""PNG, as `dapple render` writes it."""

from __future__ import annotations

import struct
import zlib

import numpy as np
from numpy.typing import NDArray


def png(pixels: NDArray[np.uint8], dpi: float, settings: str) -> bytes:
    """Of pixels (height, width, 3), sRGB-encoded, with their size on paper, and the settings for who opens it again."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    height, width, _ = pixels.shape
    per_metre = round(dpi / 0.0254)
    rows = np.zeros((height, 1 + 3 * width), np.uint8)  # each after the name of its filter: none
    rows[:, 1:] = pixels.reshape(height, 3 * width)
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        [
            chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)),
            chunk(b"sRGB", b"\0"),
            chunk(b"pHYs", struct.pack(">IIB", per_metre, per_metre, 1)),
            chunk(b"tEXt", b"dapple\0" + settings.encode("latin-1")) if settings else b"",
            chunk(b"IDAT", zlib.compress(rows.data)),
            chunk(b"IEND", b""),
        ]
    )
