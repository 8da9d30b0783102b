// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticSetup
 * @brief   the feel and the look of a volume, in one file
 *
 * Saves all settings that were tuned by hand to one readable JSON file, and restores them to the
 * bit:
 *
 *   setup->SetVolumeHaptics(filter);
 *   setup->SetVolumeProperty(volume->GetProperty());
 *   setup->SetCamera(renderer->GetActiveCamera());
 *   setup->SetDeviceToWorld(matrix);
 *   setup->Save("liver.json");        // and later
 *   setup->Load("liver.json");        // then vtkHapticDevice::Publish
 *
 * Each of the four objects is optional: an object that is not set is neither saved nor loaded. They
 * are kept by reference, and Load changes them and their functions in place.
 *
 * The file contains:
 *
 *   Haptics        all settings of vtkVolumeHapticsFilter and of its vtkHapticProperty: the five
 *                  functions with midpoints and sharpness, the component, the surface side, and
 *                  whether voxels that the VolumeProperty hides are not felt (HideInvisible); if
 *                  the filter has a label table, Labels: the table with names, colours, materials
 *                  and stand-off
 *   Volume         interpolation, and for each of the four components opacity, gradient opacity and
 *                  colour functions, unit distance, shading and lighting
 *   Camera         position, focal point, view up, view angle, parallel projection and scale
 *   DeviceToWorld  16 numbers, row by row
 *
 * Choices are saved by name ("Gaussian"). The volume itself, the label image, paths and the device
 * are not saved.
 *
 * Load checks the whole file before it changes anything. Settings that the file lacks stay
 * unchanged, also the label table; if the file has one, its labels replace all others. Unknown keys
 * are ignored. A file that can't be used gives one error that names the file, the key and the cure,
 * and changes nothing.
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
   * The filter, whose settings and property decide what is felt. Default nullptr: left out.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  ///@}

  ///@{
  /**
   * The volume property that is seen. HideInvisible attaches it to
   * vtkHapticProperty::SetVisibilityFrom; a visibility from another volume property is not saved.
   * Default nullptr: left out.
   */
  void SetVolumeProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetVolumeProperty();
  ///@}

  ///@{
  /**
   * The camera. Default nullptr: left out.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * The placement of the device, as in vtkHapticDevice::SetDeviceToWorld. Default nullptr: left
   * out.
   */
  void SetDeviceToWorld(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetDeviceToWorld();
  ///@}

  /**
   * Write the file. An existing file is replaced only after the whole new one is on the disk; if
   * that fails, the old one stays. False, with an error, if the folder is missing, not writable or
   * full, if a setting could not be loaded again (such as NaN), or if the file would be larger than
   * 16 MiB (a label table of 100 000 labels may be).
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
