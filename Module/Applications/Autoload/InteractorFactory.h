// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Attaches this library to the interactors of a program that was not built with it. VTK loads all
 * libraries in the folders that the environment variable VTK_AUTOLOAD_PATH names.
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
 * Calls Attach() for each new vtkRenderWindowInteractor. VTK still chooses the class of the
 * interactor, such as the class for X11.
 */
class InteractorFactory : public vtkObjectFactory
{
public:
  vtkAbstractTypeMacro(InteractorFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }

protected:
  // Disable this factory for interactors of the other factories: they are registered earlier,
  // because this library depends on their modules.
  InteractorFactory() { vtkObjectFactory::SetAllEnableFlags(0, Name); }

  vtkObject* CreateObject(const char* name) override
  {
    if (this->IsBusy || std::string(name) != Name)
    {
      return nullptr;
    }
    this->IsBusy = true;
    vtkRenderWindowInteractor* made = vtkRenderWindowInteractor::New();
    // no other factory has made a subclass
    if (std::string(made->GetClassName()) == Name)
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
