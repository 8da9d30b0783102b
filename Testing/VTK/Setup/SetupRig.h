// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture with all objects whose settings a setup saves, and with its files. */
#ifndef SetupRig_h
#define SetupRig_h

#include "Rigs/ApiRig.h"
#include "Rigs/TemporaryFolder.h"

#include <vtkCamera.h>
#include <vtkHapticSetup.h>
#include <vtkMatrix4x4.h>
#include <vtkVolumeProperty.h>

#include <fstream>
#include <sstream>

namespace setuptest
{
using namespace apitest;

inline std::string File(const char* name)
{
  return TemporaryPath(name);
}

inline std::string Read(const std::string& file)
{
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// A filter, a volume property, a camera, a matrix, and a setup that saves and loads them.
struct Scene
{
  Scene()
  {
    this->Setup->SetVolumeHaptics(this->Filter);
    this->Setup->SetVolumeProperty(this->Volume);
    this->Setup->SetCamera(this->Camera);
    this->Setup->SetDeviceToWorld(this->Matrix);
  }

  std::vector<vtkPiecewiseFunction*> Materials()
  {
    vtkHapticProperty* const p = this->Filter->GetProperty();
    return { p->GetStiffness(), p->GetFriction(), p->GetViscosity(), p->GetSurfaceStrength(),
      p->GetDistinctness() };
  }

  vtkNew<vtkVolumeHapticsFilter> Filter;
  vtkNew<vtkVolumeProperty> Volume;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkNew<vtkHapticSetup> Setup;
  MessageLog Log{ this->Setup };
};
} // namespace setuptest

#endif
