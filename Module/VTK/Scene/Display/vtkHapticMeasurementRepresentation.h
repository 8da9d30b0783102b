// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticMeasurementRepresentation
 * @brief   draws measurements in the scene, with their names and values
 *
 * A prop that draws vtkHapticMeasurements: points as spheres, distances, angles and paths as lines,
 * and areas as patches, each with a label. The measurement in progress is white. What lies behind a
 * surface or inside a volume is drawn faintly. Labels do not overlap each other or the head-up
 * display; a label is omitted if there is no space for it.
 *
 *   representation->SetMeasurements(measurements);
 *   representation->SetHeadUpDisplay(display); // optional
 *   renderer->AddViewProp(representation);
 *
 * Needs VTK::RenderingFreeType in the application.
 *
 * @sa vtkHapticMeasurements, vtkInteractorStyleHaptic
 */
#ifndef vtkHapticMeasurementRepresentation_h
#define vtkHapticMeasurementRepresentation_h

#include "vtkProp.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr

class vtkHapticHeadUpDisplay;
class vtkHapticMeasurements;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
struct DisplayProbe;
}
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkHapticMeasurementRepresentation : public vtkProp
{
public:
  static vtkHapticMeasurementRepresentation* New();
  vtkTypeMacro(vtkHapticMeasurementRepresentation, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The measurements to show. Default nullptr: nothing is shown. */
  void SetMeasurements(vtkHapticMeasurements* measurements);
  vtkHapticMeasurements* GetMeasurements();
  ///@}

  ///@{
  /** A head-up display in the same viewport, which labels do not cover. Default nullptr. */
  void SetHeadUpDisplay(vtkHapticHeadUpDisplay* display);
  vtkHapticHeadUpDisplay* GetHeadUpDisplay();
  ///@}

  ///@{
  /** The radius of points, world units. Default 1. The thickness of lines is proportional to it. */
  vtkSetClampMacro(Radius, double, 1e-9, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /** Whether names and values are shown. Default on. */
  vtkSetMacro(LabelVisibility, bool);
  vtkGetMacro(LabelVisibility, bool);
  vtkBooleanMacro(LabelVisibility, bool);
  ///@}

  ///@{
  /** Whether measurements behind a surface or inside the volume are drawn faintly. Default on. */
  vtkSetMacro(HiddenVisibility, bool);
  vtkGetMacro(HiddenVisibility, bool);
  vtkBooleanMacro(HiddenVisibility, bool);
  ///@}

  ///@{
  /**
   * Compute the bounds of the measurements, draw them, and release their graphics resources; called
   * by the renderer.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkHapticMeasurementRepresentation();
  ~vtkHapticMeasurementRepresentation() override;

  double Radius = 1.0;
  bool LabelVisibility = true;
  bool HiddenVisibility = true;

private:
#ifndef __VTK_WRAP__
  friend struct VolumeHaptics::DisplayProbe;
#endif
  vtkHapticMeasurementRepresentation(const vtkHapticMeasurementRepresentation&) = delete;
  void operator=(const vtkHapticMeasurementRepresentation&) = delete;

  void Build();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
