// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gives tests access to what the function editor lists and where it draws it.
 */
#ifndef EditorProbe_h
#define EditorProbe_h

#include "vtkVolumeHapticsModule.h" // for export macro

#include <optional>
#include <vector>

class vtkHapticFunctionEditor;

namespace VolumeHaptics
{

/**
 * Positions are in pixels of the display, after a render. Functions return false if the part is not
 * shown.
 */
struct VTKVOLUMEHAPTICS_EXPORT EditorProbe
{
  enum LabelPart
  {
    LabelName,
    LabelFelt,
    LabelForbidden
  };

  /** Returns the labels in the list, in ascending order. */
  static std::vector<int> ListLabels(vtkHapticFunctionEditor* editor);
  ///@{
  /** Return the label or tissue whose material has sliders. */
  static std::optional<int> GetSelectedLabel(vtkHapticFunctionEditor* editor);
  static std::optional<int> GetSelectedTissue(vtkHapticFunctionEditor* editor);
  ///@}
  /** Selects a tissue by its index in the property. Returns false if there is none. */
  static bool SelectTissue(vtkHapticFunctionEditor* editor, int tissue);

  /** Computes the position of a data value and function value on the chart. */
  static void GetPosition(
    vtkHapticFunctionEditor* editor, double value, double functionValue, double position[2]);
  static bool GetLabelPosition(
    vtkHapticFunctionEditor* editor, int label, LabelPart part, double position[2]);
  static bool GetTissuePosition(vtkHapticFunctionEditor* editor, int tissue, double position[2]);
  /** Computes the position of a value on a slider, from STIFFNESS to SURFACE_STRENGTH. */
  static bool GetSliderPosition(
    vtkHapticFunctionEditor* editor, int function, double value, double position[2]);
};

} // namespace VolumeHaptics

#endif
