// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticSetup
 * @brief   saves and loads the settings for touch and display of a volume
 *
 * Saves all settings that were tuned by hand to one readable JSON file, and restores them exactly:
 *
 *   setup->SetVolumeHaptics(filter);
 *   setup->SetVolumeProperty(volume->GetProperty());
 *   setup->SetCamera(renderer->GetActiveCamera());
 *   setup->SetDeviceToWorld(matrix);
 *   setup->Save("liver.json");        // and later
 *   setup->Load("liver.json");        // then vtkHapticDevice::Publish
 *
 * Each of the four objects is optional: an object that is not set is neither saved nor loaded. Load
 * changes the objects themselves and their functions.
 *
 * The file contains:
 *
 *   Haptics        all settings of vtkVolumeHapticsFilter and of its vtkHapticProperty: the five
 *                  functions with midpoints and sharpness, the component, the surface side, and
 *                  whether voxels that the VolumeProperty hides are not felt (HideInvisible); the
 *                  modes of PRIMITIVES and the tool with its settings; if the filter has a label
 *                  table, Labels: the table with names, colours, materials and stand-off
 *   Volume         interpolation, and for each of the four components opacity, gradient opacity and
 *                  colour functions, unit distance, shading and lighting
 *   Camera         position, focal point, view up, view angle, parallel projection and scale
 *   DeviceToWorld  16 numbers, row by row
 *
 * Choices are saved by name ("Gaussian"). The volume itself, the label image, paths and the device
 * are not saved.
 *
 * Load checks the whole file before it changes anything. Settings that the file lacks stay
 * unchanged, and so does the label table if the file has none; otherwise, the file's labels replace
 * all others. Unknown keys are ignored. If a file can't be used, one error names the file, the key
 * and the cure, and nothing is changed.
 *
 * @sa vtkVolumeHapticsFilter, vtkHapticDevice
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
  /** The filter whose settings and property are saved and loaded. Default nullptr: none. */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  ///@}

  ///@{
  /**
   * The volume property that the renderer uses. The key HideInvisible is true if this volume
   * property is that of vtkHapticProperty::SetVisibilityFrom; a visibility from another volume
   * property is not saved. Default nullptr: none.
   */
  void SetVolumeProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetVolumeProperty();
  ///@}

  ///@{
  /** The camera that is saved and loaded. Default nullptr: none. */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * The placement of the device, as in vtkHapticDevice::SetDeviceToWorld. Default nullptr: none.
   */
  void SetDeviceToWorld(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetDeviceToWorld();
  ///@}

  /**
   * Write the file. An existing file is replaced only after the whole new one is on the disk.
   * Returns false and reports an error if the folder is missing, not writable or full, if a setting
   * could not be loaded again (such as NaN), or if the file would be larger than 16 MiB (as it may
   * be with 100 000 labels).
   */
  bool Save(const char* file);

  /**
   * Read the file (16 MiB at most). If it can't be used, returns false, reports an error and
   * changes nothing.
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
