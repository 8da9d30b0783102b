// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticTool
 * @brief   base class of the tools that the hand can hold instead of a point
 *
 * Replaces the point with which vtkVolumeHapticsFilter touches the volume:
 *
 *   vtkNew<vtkHapticNeedle> needle;
 *   filter->SetTool(needle);
 *
 *   vtkHapticNeedle      punctures surfaces, and is then held by the tissue along its shaft
 *   vtkHapticPointShell  any closed surface, which feels force and torque
 *   vtkHapticBurr        removes the tissue that it is pressed into while it spins
 *
 * A tool turns with the stylus, if the device measures how it is held
 * (vtkHapticState::GetTipOrientation). A stylus points along its own -z. Offline, the path may have
 * the point array Orientation: w, x, y, z of unit quaternions that turn the stylus's axes to those
 * of the world. Four zeros stand for a point without an orientation. Between points, the
 * orientation is interpolated.
 *
 * @sa vtkVolumeHapticsFilter
 */
#ifndef vtkHapticTool_h
#define vtkHapticTool_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <string> // for std::string

class vtkPiecewiseFunction;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticTool : public vtkObject
{
public:
  vtkTypeMacro(vtkHapticTool, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Get the name of the tool for the user, such as "needle". */
  std::string GetText();

  /**
   * Make a tool of a kind. The name of a kind is that of its class without vtkHaptic, such as
   * "Burr". Returns nullptr if there is no such kind.
   */
  VTK_NEWINSTANCE static vtkHapticTool* Make(const char* kind);

  ///@{
  /**
   * Set a number by its name, such as "Radius", and get a function by its name, such as
   * "SpecificEnergy", for programs that show the settings of every kind. If the tool has no such
   * number or function, SetNumber returns false and GetFunction returns nullptr.
   */
  bool SetNumber(const char* name, double value);
  vtkPiecewiseFunction* GetFunction(const char* name);
  ///@}

protected:
  vtkHapticTool();
  ~vtkHapticTool() override;

private:
  vtkHapticTool(const vtkHapticTool&) = delete;
  void operator=(const vtkHapticTool&) = delete;
};

#endif
