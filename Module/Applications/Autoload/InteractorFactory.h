// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Attaches to the interactors of a program that was not built for it. VTK loads the libraries in
 * the folders that the environment variable VTK_AUTOLOAD_PATH names.
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
 * Calls Attach() for each new vtkRenderWindowInteractor. VTK still chooses the interactor's class
 * as it would without this factory, for example that for X11.
 */
class InteractorFactory : public vtkObjectFactory
{
public:
  vtkAbstractTypeMacro(InteractorFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }

protected:
  // The factories of VTK's modules are registered earlier, because this library depends on these
  // modules.
  InteractorFactory() { vtkObjectFactory::SetAllEnableFlags(0, Name); }

  vtkObject* CreateObject(const char* name) override
  {
    if (this->IsBusy || std::string(name) != Name)
    {
      return nullptr;
    }
    this->IsBusy = true;
    vtkRenderWindowInteractor* made = vtkRenderWindowInteractor::New();
    // no other factory has made an interactor of a subclass
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
