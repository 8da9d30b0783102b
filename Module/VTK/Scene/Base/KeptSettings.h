// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A copy of a filter's settings at one moment.
 */
#ifndef KeptSettings_h
#define KeptSettings_h

#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

class KeptSettings
{
public:
  /** Copies the filter's settings, its property and its label table. */
  explicit KeptSettings(vtkVolumeHapticsFilter* filter);

  /**
   * Copies the settings to a filter. The filter keeps the objects of its property and its label
   * table, so that an editor keeps editing the same functions.
   */
  void Apply(vtkVolumeHapticsFilter* filter) const;

  vtkNew<vtkHapticProperty> Property;

private:
  std::vector<double> Values;
  std::vector<std::string> Texts;
  vtkSmartPointer<vtkHapticLabelTable> Labels; ///< null without a table
};

} // namespace VolumeHaptics

#endif
