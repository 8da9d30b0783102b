// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticShapedTool
 * @brief   base class of tools with a shape, which solid material pushes out
 *
 * Has the settings that vtkHapticPointShell and vtkHapticBurr share: which scalars are solid, the
 * area on which the material functions act, and the spring between the hand and the tool.
 *
 * @sa vtkHapticTool
 */
#ifndef vtkHapticShapedTool_h
#define vtkHapticShapedTool_h

#include "vtkHapticTool.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class VTKVOLUMEHAPTICS_EXPORT vtkHapticShapedTool : public vtkHapticTool
{
public:
  vtkTypeMacro(vtkHapticShapedTool, vtkHapticTool);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The area (square world units) on which the stiffness and the surface strength of the materials
   * act, more than 0. A smaller area makes what is touched feel harder. Default 25 for a
   * vtkHapticPointShell, 0.1 for a vtkHapticBurr (mm^2 if the world unit is mm).
   */
  vtkSetClampMacro(ContactArea, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ContactArea, double);
  ///@}

  ///@{
  /**
   * The stiffness of the spring between hand and tool (N/m), more than 0. Devices may cap it.
   * Default 500.
   */
  vtkSetClampMacro(CouplingStiffness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CouplingStiffness, double);
  ///@}

  enum SolidType
  {
    FROM_STRENGTH = 0,
    ABOVE = 1,
    BELOW = 2
  };

  ///@{
  /**
   * Which scalars are solid. FROM_STRENGTH (default): those beyond the value at which the surface
   * strength of vtkHapticProperty passes half of its maximum, provided that it does so once in the
   * visible range. ABOVE and BELOW: those beyond the ContactValue.
   */
  vtkSetClampMacro(Solid, int, FROM_STRENGTH, BELOW);
  vtkGetMacro(Solid, int);
  void SetSolidToFromStrength() { this->SetSolid(FROM_STRENGTH); }
  void SetSolidToAbove() { this->SetSolid(ABOVE); }
  void SetSolidToBelow() { this->SetSolid(BELOW); }
  ///@}

  ///@{
  /** The scalar at the surface of what is solid, if Solid is ABOVE or BELOW. Default 0. */
  vtkSetMacro(ContactValue, double);
  vtkGetMacro(ContactValue, double);
  ///@}

protected:
  explicit vtkHapticShapedTool(double contactArea);
  ~vtkHapticShapedTool() override;

  double ContactArea;
  double CouplingStiffness = 500.0;
  int Solid = FROM_STRENGTH;
  double ContactValue = 0.0;

private:
  vtkHapticShapedTool(const vtkHapticShapedTool&) = delete;
  void operator=(const vtkHapticShapedTool&) = delete;
};

#endif
