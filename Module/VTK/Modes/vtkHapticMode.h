// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticMode
 * @brief   a way to feel the vectors, tensors or lines in a volume
 *
 * Makes a feature of a volume felt with the method PRIMITIVES of vtkVolumeHapticsFilter:
 *
 *   vtkNew<vtkHapticVectorFollowMode> stream;
 *   stream->SetArrayName("velocity");
 *   stream->GetStrength()->AddPoint(0.0, 0.0); // m/s, N
 *   stream->GetStrength()->AddPoint(0.5, 2.0);
 *   filter->AddMode(stream);
 *   filter->SetMethodToPrimitives();
 *
 * Each mode holds the hand back in some directions, and lets it go in others. The spring between
 * proxy and tip has the CouplingStiffness of the filter. A mode holds with its Strength at most: if
 * the hand pulls more, the proxy gives way, at that force. The modes of a filter are felt together,
 * and the force is never more than the sum of their strengths.
 *
 *   vtkHapticVectorFollowMode  free along a flow, held across it; and, if wanted, pushed along
 *   vtkHapticVectorFrontMode   surfaces across a field, such as wave fronts or equipotentials
 *   vtkHapticVortexMode        held in around the axis of a vortex
 *   vtkHapticShearMode         free in the direction in which a flow stretches
 *   vtkHapticTensorFollowMode  free along fibres, or within sheets
 *   vtkHapticRidgeMode         drawn to the middle of vessels in the scalars, free along them
 *   vtkHapticGuideMode         drawn to a polyline, a mesh or a distance field, free along it
 *   vtkHapticSurfaceMode       the surfaces of the scalars, with the material of the property
 *
 * Vectors and tensors are interpolated by cubic B-splines; eigenvectors never are. Over the last
 * two voxels before the border of the volume, strengths fade. Where a vector is 0 or a sample is
 * not finite, nothing holds.
 *
 * @sa vtkVolumeHapticsAlgorithm
 */
#ifndef vtkHapticMode_h
#define vtkHapticMode_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

#include <string> // for std::string

class vtkImageData;
class vtkPiecewiseFunction;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticMode : public vtkObject
{
public:
  vtkTypeMacro(vtkHapticMode, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The point array of the touched image that the mode is about: vectors of 3 components, or
   * tensors of 6 (XX, YY, ZZ, XY, YZ, XZ) or 9. Empty (default): the active vectors or tensors, or
   * else the active scalars, if they have as many components.
   *
   * nullptr stands for the empty name. Modes that are not about an array ignore it.
   */
  void SetArrayName(const char* name);
  std::string GetArrayName();
  ///@}

  ///@{
  /**
   * The largest force with which the mode holds (N), as a function of a quantity of the kind of
   * mode, such as the magnitude of the vector. A function without points is 2 N everywhere. Created
   * on first Get; nullptr restores the default.
   */
  void SetStrength(vtkPiecewiseFunction* strength);
  vtkPiecewiseFunction* GetStrength();
  ///@}

  /**
   * Set the Strength to one that suits an image. It depends on |v|, vorticity, rate of stretch, or
   * how tubular the scalars are: it is 0 up to a tenth of the value that counts as large in this
   * image, and 2 N from half of that value on. 95 % of the positions with a positive value lie
   * below the large one; for vessels, 99.5 %. For a tensor, the Strength is 0 up to the anisotropy
   * 0.15 and 2 N from 0.4 on; for a guide, it is the default. Returns false, with an error and no
   * change, if the image has nothing for this mode.
   */
  bool ProposeFromImage(vtkImageData* image);

  ///@{
  /**
   * Whether the mode is felt. Default on. It may change while a hand feels it: after the next
   * vtkHapticDevice::Publish(), force that would leap comes softly.
   */
  vtkSetMacro(Active, bool);
  vtkGetMacro(Active, bool);
  vtkBooleanMacro(Active, bool);
  ///@}

  enum AxesType
  {
    WORLD = 0,
    IMAGE = 1
  };

  ///@{
  /**
   * The axes along which the components of the array stand. WORLD (default): those of the world, as
   * ParaView takes them. IMAGE: those of the image, turned by its direction matrix.
   * With a negative spacing an axis points to where the index grows.
   */
  vtkSetClampMacro(Axes, int, WORLD, IMAGE);
  vtkGetMacro(Axes, int);
  void SetAxesToWorld() { this->SetAxes(WORLD); }
  void SetAxesToImage() { this->SetAxes(IMAGE); }
  ///@}

  /** Get a description for the user, such as "vector follow, velocity". */
  std::string GetText();

  /** Includes the change times of the functions. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticMode();
  ~vtkHapticMode() override;

  ///@{
  /** The second function of kinds that have one. */
  void SetSecondStrength(vtkPiecewiseFunction* strength);
  vtkPiecewiseFunction* GetSecondStrength();
  ///@}

  std::string ArrayName;
  vtkSmartPointer<vtkPiecewiseFunction> Strength;
  vtkSmartPointer<vtkPiecewiseFunction> SecondStrength;
  bool Active = true;
  int Axes = WORLD;

private:
  vtkHapticMode(const vtkHapticMode&) = delete;
  void operator=(const vtkHapticMode&) = delete;
};

#endif
