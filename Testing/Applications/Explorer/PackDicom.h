// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackDicom_h
#define PackDicom_h

#include <string>

/// Writes a copy of a DICOM file with compressed samples by means of GDCM. `how` is "lossless"
/// (JPEG), "prediction" (lossless JPEG-LS), "wavelets" (lossless JPEG 2000), "baseline" (JPEG of 8
/// bits at the best quality) or "baseline-422" (the same data with the photometric interpretation
/// that other writers set). GDCM's JPEG 2000 can't write images of a few pixels. `step` is the
/// distance between frames in mm.
bool PackDicom(
  const std::string& plain, const std::string& packed, const std::string& how, double step);

#endif
