// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Replaces VTK's class of this name in the module RenderingOpenXR, if VTK is built without that
 * module. It contains only the function that is used. VTK's API documentation for 9.2 to 9.6
 * defines the signature and the arguments: the name of an action of the manifest, the hand (0 left,
 * 1 right), the amplitude (0 to 1), the duration (ns) and the frequency (Hz; 0: any). Calls are
 * recorded instead of making a controller vibrate.
 */
#ifndef vtkOpenXRRenderWindowInteractor_h
#define vtkOpenXRRenderWindowInteractor_h

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor3D.h>

#include <chrono>
#include <string>
#include <vector>

class vtkOpenXRRenderWindowInteractor : public vtkRenderWindowInteractor3D
{
public:
  static vtkOpenXRRenderWindowInteractor* New()
  {
    VTK_STANDARD_NEW_BODY(vtkOpenXRRenderWindowInteractor);
  }
  vtkTypeMacro(vtkOpenXRRenderWindowInteractor, vtkRenderWindowInteractor3D);

  bool ApplyVibration(const std::string& actionName, int hand, float amplitude = 0.5,
    float duration = 25000000.0, float frequency = 0.0)
  {
    this->Calls.push_back(
      { actionName, hand, amplitude, duration, frequency, std::chrono::steady_clock::now() });
    return this->Accepts;
  }

  struct Call
  {
    std::string Action;
    int Hand;
    float Amplitude;
    float Duration;
    float Frequency;
    std::chrono::steady_clock::time_point At;
  };
  std::vector<Call> Calls;
  bool Accepts = true; ///< false: the manifest lacks the action
  double PhysicalScale = 1.0;
  double GetPhysicalScale() override { return this->PhysicalScale; }
};

#endif
