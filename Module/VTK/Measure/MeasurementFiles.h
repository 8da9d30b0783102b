// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measurements in files, whose ending tells the format: .csv, .vtp, or .json for markups.
 */
#ifndef MeasurementFiles_h
#define MeasurementFiles_h

#include "VTK/Measure/MarkupsJson.h"
#include "VTK/Measure/Measurement.h"

#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Whole or not at all; false, with the reason and the cure, if that fails. */
bool WriteMeasurements(const std::string& file, const std::vector<Measurement>& measurements,
  const MarkupsFrame& frame, std::string& error);

/**
 * False, with the reason and the cure, if the file can't be read. The notes tell what of it was
 * left out.
 */
bool ReadMeasurements(const std::string& file, const MarkupsFrame& frame,
  std::vector<Measurement>& measurements, std::string& notes, std::string& error);

} // namespace VolumeHaptics

#endif
