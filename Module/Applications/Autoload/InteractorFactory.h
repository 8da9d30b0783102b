// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meets the interactors of a program that was not built for it. VTK loads the libraries in the
 * folders that the environment variable VTK_AUTOLOAD_PATH names.
 */
#ifndef InteractorFactory_h
#define InteractorFactory_h

#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkVersion.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Hands each vtkRenderWindowInteractor to Attach() when it is made. VTK makes it as it would
 * without this factory, such as for X11.
 */
class InteractorFactory : public vtkObjectFactory
{
public:
  vtkAbstractTypeMacro(InteractorFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }

protected:
  // The factories of VTK's modules come first in the list, since this library needs them.
  InteractorFactory() { vtkObjectFactory::SetAllEnableFlags(0, Name); }

  vtkObject* CreateObject(const char* name) override
  {
    if (this->IsBusy || std::string(name) != Name)
    {
      return nullptr;
    }
    this->IsBusy = true;
    vtkRenderWindowInteractor* made = vtkRenderWindowInteractor::New();
    if (std::string(made->GetClassName()) == Name) // no other library like this one has made it
    {
      made->Delete();
      vtkObjectFactory::SetAllEnableFlags(1, Name);
      made = vtkRenderWindowInteractor::New();
      vtkObjectFactory::SetAllEnableFlags(0, Name);
    }
    this->IsBusy = false;
    this->Attach(made);
    return made;
  }
  virtual void Attach(vtkRenderWindowInteractor* made) = 0;

private:
  static constexpr const char* Name = "vtkRenderWindowInteractor";
  bool IsBusy = false;
};

} // namespace VolumeHaptics

#endif
