// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticSetup
 * @brief   what a volume feels and looks like, in one file
 *
 * Saves everything that was tuned by hand to one JSON file that people can read, and brings it back
 * to the bit:
 *
 *   setup->SetVolumeHaptics(filter);
 *   setup->SetVolumeProperty(volume->GetProperty());
 *   setup->SetCamera(renderer->GetActiveCamera());
 *   setup->SetDeviceToWorld(matrix);
 *   setup->Save("liver.json");        // and later
 *   setup->Load("liver.json");        // then vtkHapticDevice::Publish
 *
 * Each of the four is optional: what is not set is neither saved nor loaded. They are kept by
 * reference, and Load changes them in place, as it does their functions.
 *
 * In the file:
 *
 *   Haptics        all settings of vtkVolumeHapticsFilter and of its vtkHapticProperty: the five
 *                  functions with midpoints and sharpness, the component, the surface side, and
 *                  whether what the VolumeProperty hides is not felt (HideInvisible)
 *   Volume         interpolation, and for each of the four components opacity, gradient opacity and
 *                  colour functions, unit distance, shading and lighting
 *   Camera         position, focal point, view up, view angle, parallel projection and scale
 *   DeviceToWorld  16 numbers, row by row
 *
 * Choices stand there by name ("Gaussian"). The volume itself, paths and the device are not saved.
 *
 * Load checks the whole file before it changes anything. What is missing in the file stays as it
 * is; keys that are not known are ignored. A file that can't be used gives one error that names the
 * file, the key and the cure, and changes nothing.
 *
 * @sa vtkVolumeHapticsFilter, vtkHapticCalibration
 */
#ifndef vtkHapticSetup_h
#define vtkHapticSetup_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkCamera;
class vtkMatrix4x4;
class vtkVolumeHapticsFilter;
class vtkVolumeProperty;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticSetup : public vtkObject
{
public:
  static vtkHapticSetup* New();
  vtkTypeMacro(vtkHapticSetup, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What is felt: the settings of the filter and of its property. Default nullptr: left out.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  ///@}

  ///@{
  /**
   * What is seen. It is also what HideInvisible attaches to vtkHapticProperty::SetVisibilityFrom; a
   * visibility from another volume property is not saved. Default nullptr: left out.
   */
  void SetVolumeProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetVolumeProperty();
  ///@}

  ///@{
  /**
   * Where it is seen from. Default nullptr: left out.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Where the device stands, as in vtkHapticDevice::SetDeviceToWorld. Default nullptr: left out.
   */
  void SetDeviceToWorld(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetDeviceToWorld();
  ///@}

  /**
   * Write the file. An existing file is replaced only after all of the new one is on the disk; if
   * that fails, it stays as it is. False, with an error, if the folder is missing, not writable or
   * full, or if a setting could not be loaded again, such as NaN.
   */
  bool Save(const char* file);

  /**
   * Read the file (16 MiB at most). False, with an error and no change, if it can't be used.
   */
  bool Load(const char* file);

protected:
  vtkHapticSetup();
  ~vtkHapticSetup() override;

  vtkSmartPointer<vtkVolumeHapticsFilter> VolumeHaptics;
  vtkSmartPointer<vtkVolumeProperty> VolumeProperty;
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkMatrix4x4> DeviceToWorld;

private:
  vtkHapticSetup(const vtkHapticSetup&) = delete;
  void operator=(const vtkHapticSetup&) = delete;
};

#endif
