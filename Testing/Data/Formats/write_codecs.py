# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes DICOM with pixels compressed by JPEG, JPEG-LS, JPEG 2000 and their successors: imagecodecs packs the pixels,
and pydicom the file."""

import imagecodecs
import numpy as np
from cases import case
from pydicom.encaps import encapsulate, encapsulate_extended
from pydicom.uid import (
    HTJ2KLossless,
    JPEG2000,
    JPEG2000Lossless,
    JPEGBaseline8Bit,
    JPEGLossless,
    JPEGLosslessSV1,
    JPEGLSLossless,
    JPEGLSNearLossless,
)
from write_dicom import GRID, enhanced, save, save_all, slices

BITS = 12


def stored(data):
    """Returns the stored pixels of a slice, or of all frames."""
    kind = f"<{'i' if data.PixelRepresentation else 'u'}{data.BitsAllocated // 8}"
    size = (data.Rows, data.Columns) if data.get("NumberOfFrames", 1) == 1 else (-1, data.Rows, data.Columns)
    return np.frombuffer(data.PixelData, kind).reshape(size)


def pack(data, syntax, packed, is_lossy=False):
    data.file_meta.TransferSyntaxUID = syntax
    data.PixelData = encapsulate([packed] if isinstance(packed, bytes) else packed)
    data["PixelData"].VR = "OB"
    data["PixelData"].is_undefined_length = True
    if is_lossy:
        data.LossyImageCompression = "01"


def packed_case(name, syntax, encode, signed=False, is_lossy=False, **facts):
    """Registers a case with slices of 12 bits, or of 16 bits if signed."""

    @case(f"dicom-{name}", **facts)
    def write(folder):
        sets = slices(GRID, intercept=0.0, signed=True) if signed else slices(GRID)
        for data in sets:
            if not signed:
                data.BitsStored, data.HighBit = BITS, BITS - 1
            pack(data, syntax, bytes(encode(stored(data))), is_lossy)
        return save_all(folder, sets)


def jpeg2000(pixels, **options):
    return imagecodecs.jpeg2k_encode(pixels, codecformat="j2k", **{"reversible": True, "bitspersample": BITS, **options})


def as_unsigned(pixels):
    return np.ascontiguousarray(pixels).view(np.uint16)


packed_case("jpeg-lossless", JPEGLosslessSV1, lambda pixels: imagecodecs.ljpeg_encode(pixels, bitspersample=BITS),
            source="PS3.5 A.4.1: process 14, selection value 1; most PACS")
packed_case("jpeg-lossless-process-14", JPEGLossless, lambda pixels: imagecodecs.ljpeg_encode(pixels, bitspersample=BITS),
            source="PS3.5 A.4.1: process 14")
packed_case("jpeg-2000", JPEG2000Lossless, jpeg2000, source="PS3.5 A.4.4")
packed_case("jpeg-2000-signed", JPEG2000Lossless, lambda pixels: jpeg2000(pixels, bitspersample=16), signed=True,
            source="PS3.5 A.4.4: the codestream says that samples are signed")
packed_case("jpeg-2000-with-a-wrong-sign", JPEG2000Lossless, lambda pixels: jpeg2000(as_unsigned(pixels), bitspersample=16),
            signed=True, source="pydicom#1204: the codestream says unsigned, PixelRepresentation signed")
packed_case("jpeg-2000-lossy", JPEG2000, lambda pixels: jpeg2000(pixels, level=70, reversible=False), is_lossy=True,
            tolerance=20.0, source="PS3.5 A.4.4")
packed_case("jpeg-2000-in-a-file-format", JPEG2000Lossless, lambda pixels: imagecodecs.jpeg2k_encode(
    pixels, codecformat="jp2", reversible=True, bitspersample=BITS), source="PS3.5 8.2.4: no JP2 header; some writers have one")
packed_case("jpeg-ls", JPEGLSLossless, imagecodecs.jpegls_encode, source="PS3.5 A.4.3")
packed_case("jpeg-ls-signed", JPEGLSLossless, lambda pixels: imagecodecs.jpegls_encode(as_unsigned(pixels)), signed=True,
            source="PS3.5 8.2.3: the standard of JPEG-LS has no sign; PixelRepresentation tells it")
packed_case("jpeg-ls-near-lossless", JPEGLSNearLossless, lambda pixels: imagecodecs.jpegls_encode(pixels, level=2),
            is_lossy=True, tolerance=3.1, source="PS3.5 A.4.3")
packed_case("high-throughput-jpeg-2000", HTJ2KLossless, lambda pixels: imagecodecs.htj2k_encode(pixels, reversible=True),
            refused="High-Throughput JPEG 2000|HTJ2K", source="PS3.5 A.4.4")


@case("dicom-jpeg-xl", refused="JPEG XL", source="PS3.5 A.4.12, of 2024, whose name pydicom does not know yet")
def jpeg_xl(folder):
    sets = slices(GRID)
    for data in sets:
        pack(data, HTJ2KLossless, imagecodecs.jpegxl_encode(stored(data), lossless=True))
    save_all(folder, sets)
    for path in folder.iterdir():
        path.write_bytes(path.read_bytes().replace(HTJ2KLossless.encode(), b"1.2.840.10008.1.2.4.110"))
    return folder


@case("dicom-jpeg-8-bits", source="PS3.5 A.4.1: process 1", scale=0.2, offset=210.0, tolerance=8.0,
      options=("--preset", "histogram"))
def jpeg_8_bits(folder):
    sets = slices(GRID, sampled=np.round(0.2 * GRID.sample(float) + 210.0), intercept=0.0, bits=8)
    for data in sets:
        pack(data, JPEGBaseline8Bit, imagecodecs.jpeg8_encode(stored(data), level=98), is_lossy=True)
    return save_all(folder, sets)


def frames_case(name, encapsulated, **facts):
    @case(f"dicom-enhanced-{name}", **facts)
    def write(folder):
        data = enhanced(GRID, range(GRID.size[2]))
        data.BitsStored, data.HighBit = BITS, BITS - 1
        frames = [jpeg2000(frame) for frame in stored(data)]
        pack(data, JPEG2000Lossless, frames)
        encapsulated(data, frames)
        return save(folder, data, "enhanced.dcm")


def in_fragments(data, frames):
    data.PixelData = encapsulate(frames, fragments_per_frame=3)


def without_offsets(data, frames):
    data.PixelData = encapsulate(frames, has_bot=False)


def with_extended_offsets(data, frames):
    data.PixelData, offsets, lengths = encapsulate_extended(frames)
    data.ExtendedOffsetTable, data.ExtendedOffsetTableLengths = offsets, lengths


frames_case("jpeg-2000-in-fragments", in_fragments, source="PS3.5 A.4: a frame may have several fragments")
frames_case("jpeg-2000-without-offsets", without_offsets, source="PS3.5 A.4: the table of offsets may be empty")
frames_case("jpeg-2000-extended-offsets", with_extended_offsets, source="PS3.3 C.7.6.3.1.8")
