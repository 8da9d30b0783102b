// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackDicom_h
#define PackDicom_h

#include <string>

/// Writes a DICOM file anew with compressed samples, by GDCM's own writer: "lossless" JPEG,
/// JPEG-LS's "prediction", or JPEG 2000's "wavelets", none of which loses anything; or "baseline"
/// JPEG of 8 bits and the best quality, also as "baseline-422", with the name that other writers
/// give its colours. GDCM's JPEG 2000 can't write images of a few pixels. `step`
/// is that between frames, in mm.
bool PackDicom(
  const std::string& plain, const std::string& packed, const std::string& how, double step);

#endif
