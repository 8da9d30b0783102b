// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticNeedle
 * @brief   a needle that feels layers, friction along its shaft, and the loss of resistance
 *
 * Punctures tissue. Outside, the needle's point feels surfaces as the hand does without a tool; a
 * needle that is pushed through them is inserted, and feels layers:
 *
 *   vtkNew<vtkHapticNeedle> needle;
 *   filter->SetTool(needle);
 *   filter->SetLabelTable(table);
 *   table->SetSurfaceStrength(7, 1.2); // N, to puncture the ligament
 *   table->SetViscosity(7, 0.8);       // N, to cut it
 *   table->SetShaftFriction(7, 60.0);  // N per metre of the shaft in it
 *
 * - **the layer around its point** resists while the needle is pushed: with the viscosity of its
 *   label, or else with the CuttingForce;
 * - **boundaries** hold the point until they are punctured: those of labels that have a surface
 *   strength, and where a label has none, the surfaces of the scalars;
 * - **its shaft** is held by all tissues along the track, against any motion, in and out: by the
 *   shaft friction of each label, or else by ShaftFriction;
 * - **perpendicular to its axis** the tissue holds it with the LateralStrength.
 *
 * Where a tissue ends, its resistance is lost: the loss of resistance. The equations are in
 * Documentation/method.md, "The needle". The spring keeps the stiffness of the surface that was
 * punctured until the needle is out. The metres in N per metre are those of the hand's space.
 *
 * The needle's axis is the axis of the stylus. If the device measures no orientation, it is the
 * direction of the hand's motion at the puncture, over the last millimetre, and stays until the
 * needle is out.
 *
 * It needs the method PROXY, and a volume that does not move. In the trace, Depth is the length
 * that is inserted (world units; 0: none), ShaftForce is the most that the tissue along the shaft
 * holds (N), and there is an array that only this tool has:
 *
 *   ForbiddenTouches  how often a forbidden label has stopped this insertion
 *
 * MakeTrack() converts a trace to the track through the tissue; vtkHapticState::GetNeedleTrack()
 * writes the track of a needle in the hand.
 *
 * @sa vtkHapticTool vtkHapticLabelTable
 */
#ifndef vtkHapticNeedle_h
#define vtkHapticNeedle_h

#include "vtkHapticTool.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkPiecewiseFunction;
class vtkPolyData;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticNeedle : public vtkHapticTool
{
public:
  static vtkHapticNeedle* New();
  vtkTypeMacro(vtkHapticNeedle, vtkHapticTool);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The friction tau of the shaft (N per metre of it) against the scalar value, for tissue whose
   * label has no shaft friction. A function without points is 0. Created on first Get; nullptr
   * restores the default.
   */
  void SetShaftFriction(vtkPiecewiseFunction* friction);
  vtkPiecewiseFunction* GetShaftFriction();
  ///@}

  ///@{
  /**
   * The force R with which the point cuts (N) against the scalar value, for tissue whose label has
   * no viscosity. A function without points (default) stands for the viscosity of
   * vtkHapticProperty. Created on first Get; nullptr restores the default. That viscosity is equal
   * for all soft tissues in the presets for CT; ApplyPreset() sets a force for each tissue.
   */
  void SetCuttingForce(vtkPiecewiseFunction* force);
  vtkPiecewiseFunction* GetCuttingForce();
  ///@}

  /**
   * Fill CuttingForce, in place, for one of the presets of vtkHapticProperty for Hounsfield units
   * ("CT contrast", ...): 0.04 N in lung, 0.1 N in fat and 0.3 N from muscle on, the layers of
   * Documentation/method.md. For any other name, reports an error, returns false and changes
   * nothing.
   */
  bool ApplyPreset(const char* name);

  ///@{
  /**
   * The force (N) with which tissue holds the inserted needle perpendicular to its axis, 0 or more.
   * Full from a hand depth of 1 mm on. Default 1.
   */
  vtkSetClampMacro(LateralStrength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LateralStrength, double);
  ///@}

  /**
   * Compute the track of the last insertion in a trace that vtkVolumeHapticsFilter made with a
   * needle: a polyline through the positions where the point entered a new tissue, ending at the
   * deepest position. The point array Depth (world units) has the distance along the needle. The
   * cell arrays Label and Length (world units) have a value for each stretch of the track. Field
   * arrays, one number each: Depth, the greatest depth; Angle (degrees), between the track and the
   * surface's normal at the entry, or -1 if there is no normal; and ForbiddenTouches, if the trace
   * has it. Returns false if the trace has no needle; the track is empty then, and emits the error.
   * Trace and track must be different objects.
   */
  static bool MakeTrack(vtkPolyData* trace, vtkPolyData* track);

  /** Returns the latest modification time of this tool and its functions. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticNeedle();
  ~vtkHapticNeedle() override;

  vtkSmartPointer<vtkPiecewiseFunction> ShaftFriction;
  vtkSmartPointer<vtkPiecewiseFunction> CuttingForce;
  double LateralStrength = 1.0;

private:
  vtkHapticNeedle(const vtkHapticNeedle&) = delete;
  void operator=(const vtkHapticNeedle&) = delete;
};

#endif
