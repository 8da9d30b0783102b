// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticMode
 * @brief   a way to feel the vectors, tensors or lines in a volume
 *
 * Makes a feature of a volume felt with the method PRIMITIVES of vtkVolumeHapticsFilter:
 *
 *   vtkNew<vtkHapticMode> stream;
 *   stream->SetKindToVectorFollow();
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
 *   VECTOR_FOLLOW  free along a flow, held perpendicular to it; the second strength pushes along
 *   VECTOR_FRONT   surfaces perpendicular to a field, such as wave fronts or equipotentials
 *   VORTEX         held in around the axis of a vortex; the second strength, on lines along it
 *   SHEAR          free in the direction in which a flow stretches
 *   TENSOR_FOLLOW  free along fibres; the second strength holds within sheets
 *   RIDGE          drawn to the middle of vessels in the scalars, free along them
 *   GUIDE          drawn to a polyline, a mesh or a distance field: see vtkHapticGuideMode
 *   SURFACE        the surfaces of the scalars, with the material of the property
 *
 * Vectors and tensors are interpolated by cubic B-splines; eigenvectors never are. Over the last
 * two voxels before the border of the volume, strengths fade. Where a vector is 0 or a sample is
 * not finite, nothing holds.
 *
 * @sa vtkHapticGuideMode, vtkVolumeHapticsFilter
 */
#ifndef vtkHapticMode_h
#define vtkHapticMode_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

#include <string> // for std::string

class vtkDataSet;
class vtkImageData;
class vtkPiecewiseFunction;
class vtkStringArray;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticMode : public vtkObject
{
public:
  static vtkHapticMode* New();
  vtkTypeMacro(vtkHapticMode, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum KindType
  {
    VECTOR_FOLLOW = 0,
    VECTOR_FRONT = 1,
    VORTEX = 2,
    SHEAR = 3,
    TENSOR_FOLLOW = 4,
    RIDGE = 5,
    GUIDE = 6,
    SURFACE = 7
  };

  ///@{
  /**
   * The feature of the volume that is felt, and how it is felt. Default VECTOR_FOLLOW. GUIDE is the
   * kind of every vtkHapticGuideMode, and of no other mode: setting another kind there, or GUIDE
   * here, is an error without an effect.
   *
   * - VECTOR_FOLLOW: the hand moves freely along the vectors, as if on a rail, and is held
   *   perpendicular to them with the Strength, a function of the magnitude of the vector. The proxy
   *   follows the field line, however it turns, without drift. Let the strength be 0 where the
   *   magnitude is 0, since a zero vector has no direction.
   * - VECTOR_FRONT: the hand is held, wherever it is, on a surface perpendicular to the vectors,
   *   with the Strength, a function of their magnitude, and slides along this surface. If it pushes
   *   with more, it moves on to the next surface, at that force. See TwoSided.
   * - VORTEX: the curl omega of the vectors is the axis of their rotation. The hand moves freely
   *   towards the axis, along it and around it; if it moves away from the axis, it is held back
   *   with the Strength, a function of the magnitude of omega (per world unit). Within a tenth of a
   *   voxel of the core line, on which the flow does not turn, it rests on the line itself.
   * - SHEAR: the hand moves freely in the direction in which the flow of the vectors stretches
   *   most, the first eigenvector of (J + J^T)/2 with J the Jacobian. Perpendicular to it, the hand
   *   is held with the Strength, a function of the rate of stretching (the eigenvalue, per world
   *   unit).
   * - TENSOR_FOLLOW: with l_1 >= l_2 >= l_3 the eigenvalues of the tensor, negative ones taken as
   *   0, c_l = (l_1 - l_2)/l_1 measures how clear one direction is (diffusion along fibres), and
   *   c_p = (l_2 - l_3)/l_1 how clear one plane is (sheets). The hand moves freely along the first
   *   eigenvector, and is held perpendicular to it with the Strength, a function of c_l, from 0 to
   *   1. Let the strength be 0 where c_l is 0: the default of 2 N holds there, too, in an arbitrary
   *   direction. If tensors have 9 components (row by row), their symmetric part counts.
   * - RIDGE: the hand is drawn to the middle of a vessel or nerve, where the touched scalars fall
   *   to all sides but along one direction, and moves freely along it. With |h_1| <= |h_2| <= |h_3|
   *   the eigenvalues of the scalars' Hessian, the Strength is a function of |h_2| - |h_1| (scalar
   *   units per square world unit). Noise has small ridges everywhere: let the strength be 0 there.
   *   The filter's gradient estimator smooths the scalars; a KernelRadius of about the radius of
   *   the vessels suits best. See Polarity and SnapDistance.
   * - SURFACE: the surfaces of the scalars are felt, with the law of the method PROXY: the material
   *   functions of vtkHapticProperty, or the label table, give surface strength, friction and drag,
   *   while the stiffness is the CouplingStiffness. A material without stiffness is not felt. As
   *   with the solver PAPER, surfaces begin where their distinctness begins, and materials are read
   *   a kernel radius to either side. Other settings of the method PROXY don't count, nor do
   *   ArrayName, Strength and Axes.
   */
  void SetKind(int kind);
  vtkGetMacro(Kind, int);
  void SetKindToVectorFollow() { this->SetKind(VECTOR_FOLLOW); }
  void SetKindToVectorFront() { this->SetKind(VECTOR_FRONT); }
  void SetKindToVortex() { this->SetKind(VORTEX); }
  void SetKindToShear() { this->SetKind(SHEAR); }
  void SetKindToTensorFollow() { this->SetKind(TENSOR_FOLLOW); }
  void SetKindToRidge() { this->SetKind(RIDGE); }
  void SetKindToSurface() { this->SetKind(SURFACE); }
  ///@}

  /**
   * Get the names of all kinds in the order of their numbers, as setup files use them, such as
   * "VectorFollow".
   */
  static vtkStringArray* GetKindNames();

  ///@{
  /**
   * The point array of the touched image that the mode reads: vectors of 3 components, or tensors
   * of 6 (XX, YY, ZZ, XY, YZ, XZ) or 9. Empty (default): the active vectors or tensors, or else the
   * active scalars, if they have as many components.
   *
   * nullptr stands for the empty name. RIDGE, GUIDE and SURFACE ignore it.
   */
  void SetArrayName(const char* name);
  std::string GetArrayName();
  ///@}

  ///@{
  /**
   * The largest force with which the mode holds (N), as a function of a quantity that depends on
   * the kind of mode, such as the magnitude of the vector. A function without points is 2 N
   * everywhere. Created on first Get; nullptr restores the default.
   */
  void SetStrength(vtkPiecewiseFunction* strength);
  vtkPiecewiseFunction* GetStrength();
  ///@}

  ///@{
  /**
   * A second force (N), for three kinds of modes. VECTOR_FOLLOW: pushes the hand along the vectors,
   * and so does work on it; a function of the same quantity as Strength. VORTEX: holds the hand on
   * lines along the axis; a function of the same quantity as Strength. TENSOR_FOLLOW: holds the
   * hand within the plane of the first two eigenvectors; a function of c_p. A function without
   * points is 0 everywhere, the default; with points it is an error for the other kinds.
   */
  void SetSecondStrength(vtkPiecewiseFunction* strength);
  vtkPiecewiseFunction* GetSecondStrength();
  ///@}

  /** Get whether the kind has a SecondStrength. */
  bool HasSecondStrength();

  ///@{
  /**
   * For VECTOR_FRONT: whether the hand is also held when it moves along the vectors, so that it
   * snaps to a front. Off (default): the hand is held only when it moves against the vectors.
   */
  vtkSetMacro(TwoSided, bool);
  vtkGetMacro(TwoSided, bool);
  vtkBooleanMacro(TwoSided, bool);
  ///@}

  enum PolarityType
  {
    BRIGHT = 0,
    DARK = 1
  };

  ///@{
  /**
   * For RIDGE: whether the vessels are BRIGHT (default), brighter than their surroundings, or DARK.
   */
  vtkSetClampMacro(Polarity, int, BRIGHT, DARK);
  vtkGetMacro(Polarity, int);
  void SetPolarityToBright() { this->SetPolarity(BRIGHT); }
  void SetPolarityToDark() { this->SetPolarity(DARK); }
  ///@}

  ///@{
  /**
   * For RIDGE: the distance from the ridge up to which the full strength draws the hand (voxels),
   * 0.1 to 16. Beyond twice this distance the hand is free. Default 3.
   */
  vtkSetClampMacro(SnapDistance, double, 0.1, 16.0);
  vtkGetMacro(SnapDistance, double);
  ///@}

  /**
   * Set a Strength that suits an image, as a function of |v|, vorticity, rate of stretch, or how
   * tubular the scalars are: 0 up to a tenth of a large value of the image, and 2 N from half of
   * the large value on. The large value is the 95th percentile of the positive values; for vessels,
   * the 99.5th. For a tensor, the Strength is 0 up to the anisotropy 0.15 and 2 N from 0.4 on; for
   * a guide, it is the default. If the image has nothing for this mode, reports an error, returns
   * false and changes nothing.
   */
  bool ProposeFromImage(vtkImageData* image);

  ///@{
  /**
   * Whether the mode is felt. Default on. It may change while a hand feels the mode: after the next
   * vtkHapticDevice::Publish(), a force that would jump rises gradually.
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
   * The axes that the components of the array refer to. WORLD (default): the world's axes, as
   * ParaView takes them. IMAGE: the image's axes, turned by its direction matrix. With a negative
   * spacing, an image axis points to where the index grows.
   */
  vtkSetClampMacro(Axes, int, WORLD, IMAGE);
  vtkGetMacro(Axes, int);
  void SetAxesToWorld() { this->SetAxes(WORLD); }
  void SetAxesToImage() { this->SetAxes(IMAGE); }
  ///@}

  /** Get a description of the mode for the user, such as "vector follow, velocity". */
  std::string GetText();

  ///@{
  /**
   * GetArrayText returns which point arrays the kind can read, such as "vectors (a point array of 3
   * components)"; empty if it reads none. FindArrayName returns the name of the first such array in
   * some data; empty if there is none.
   */
  std::string GetArrayText();
  std::string FindArrayName(vtkDataSet* data);
  ///@}

  /** Returns the latest modification time of this mode and its functions. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticMode();
  ~vtkHapticMode() override;

  int Kind = VECTOR_FOLLOW;
  std::string ArrayName;
  vtkSmartPointer<vtkPiecewiseFunction> Strength;
  vtkSmartPointer<vtkPiecewiseFunction> SecondStrength;
  bool Active = true;
  int Axes = WORLD;
  bool TwoSided = false;
  int Polarity = BRIGHT;
  double SnapDistance = 3.0;

private:
  vtkHapticMode(const vtkHapticMode&) = delete;
  void operator=(const vtkHapticMode&) = delete;
};

#endif
