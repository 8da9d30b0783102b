// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeHapticsAlgorithm
 * @brief   the settings of volume haptics
 *
 * Superclass of vtkVolumeHapticsFilter, which says what they mean together.
 */
#ifndef vtkVolumeHapticsAlgorithm_h
#define vtkVolumeHapticsAlgorithm_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

#include <string> // for std::string

class vtkHapticProperty;
class vtkStringArray;

class VTKVOLUMEHAPTICS_EXPORT vtkVolumeHapticsAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkVolumeHapticsAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The materials. Created with its defaults on first Get; nullptr goes back to those. */
  void SetProperty(vtkHapticProperty* property);
  vtkHapticProperty* GetProperty();
  ///@}

  enum MethodType
  {
    PROXY = 0,
    FORCE_FIELD = 1,
    SURFACE_PROXY = 2,
    LOCAL_SURFACE = 3
  };

  ///@{
  /**
   * PROXY (default): what vtkVolumeHapticsFilter describes. FORCE_FIELD, eq. 1 of the paper, which
   * compares itself with this and the next two: f = -ForceFieldGain grad V - ForceFieldDamping
   * v_tip, without a proxy; NormalForce and DragForce are the magnitudes of the two terms.
   * SURFACE_PROXY, polygonal surface haptics (Ruspini et al. 1997): a sphere of ProxyRadius that no
   * triangle of the surface lets through. LOCAL_SURFACE, an intermediate representation (Mark et
   * al. 1996): a slow loop fits a plane or a quadric to the isosurface near the proxy, and the
   * servo touches that; what the hand meets before the slow loop has looked, it falls through. Both
   * surfaces have stiffness and friction of the material at IsoValue, and neither drag nor a limit
   * to what they hold: Viscosity, SurfaceStrength and GradientMagnitude are 0. Chosen while a servo
   * runs, they hold a hand that is up to three kernel radii inside the isosurface from outside; one
   * that is deeper SURFACE_PROXY holds from within, and LOCAL_SURFACE not at all.
   */
  vtkSetClampMacro(Method, int, PROXY, LOCAL_SURFACE);
  vtkGetMacro(Method, int);
  void SetMethodToProxy() { this->SetMethod(PROXY); }
  void SetMethodToForceField() { this->SetMethod(FORCE_FIELD); }
  void SetMethodToSurfaceProxy() { this->SetMethod(SURFACE_PROXY); }
  void SetMethodToLocalSurface() { this->SetMethod(LOCAL_SURFACE); }
  ///@}

  enum SolverType
  {
    PAPER = 0,
    PRECISE = 1
  };

  ///@{
  /**
   * How PROXY advances the proxy in a tick. PAPER: as published, one look at the volume where the
   * proxy is when the tick begins. PRECISE (default): the same law, in balance where the proxy
   * ends.
   */
  vtkSetClampMacro(Solver, int, PAPER, PRECISE);
  vtkGetMacro(Solver, int);
  void SetSolverToPaper() { this->SetSolver(PAPER); }
  void SetSolverToPrecise() { this->SetSolver(PRECISE); }
  ///@}

  enum ContactAlignmentType
  {
    DISTINCTNESS = 0,
    EDGE = 1
  };

  ///@{
  /**
   * Where a surface begins to hold, with PRECISE. DISTINCTNESS (default): as soon as W_d and T_N
   * say so, on a blurred edge some voxels before its middle, since x_s is r ahead. EDGE: not before
   * V(x_p) >= (V(x_s) + V(x_v)) / 2 (within 0.1 % of their difference), so that what is felt lies
   * on what is seen. On a linear ramp both are alike.
   */
  vtkSetClampMacro(ContactAlignment, int, DISTINCTNESS, EDGE);
  vtkGetMacro(ContactAlignment, int);
  void SetContactAlignmentToDistinctness() { this->SetContactAlignment(DISTINCTNESS); }
  void SetContactAlignmentToEdge() { this->SetContactAlignment(EDGE); }
  ///@}

  enum GradientEstimatorType
  {
    CENTRAL_DIFFERENCE = 0,
    GAUSSIAN = 1,
    CUBIC_BSPLINE = 2
  };

  ///@{
  /**
   * How gradients are estimated: CENTRAL_DIFFERENCE of six trilinear samples KernelRadius voxels
   * away; GAUSSIAN (default), the derivative of a Gaussian of scale 0.53 KernelRadius voxels, which
   * noise disturbs least; CUBIC_BSPLINE, the analytic derivative of a smoothing cubic B-spline over
   * 64 voxels. Values are trilinear with the first two and B-spline values with the third.
   */
  vtkSetClampMacro(GradientEstimator, int, CENTRAL_DIFFERENCE, CUBIC_BSPLINE);
  vtkGetMacro(GradientEstimator, int);
  void SetGradientEstimatorToCentralDifference() { this->SetGradientEstimator(CENTRAL_DIFFERENCE); }
  void SetGradientEstimatorToGaussian() { this->SetGradientEstimator(GAUSSIAN); }
  void SetGradientEstimatorToCubicBSpline() { this->SetGradientEstimator(CUBIC_BSPLINE); }
  ///@}

  ///@{
  /**
   * Radius of the gradient kernel in voxels, 1 to 16. Times the largest spacing it is the distance
   * r from the proxy at which materials are picked. Default 2.
   */
  vtkSetClampMacro(KernelRadius, int, 1, 16);
  vtkGetMacro(KernelRadius, int);
  ///@}

  ///@{
  /** Ticks per second (Hz), 1 to 100000. Default 1000. */
  vtkSetClampMacro(ServoRate, double, 1.0, 1e5);
  vtkGetMacro(ServoRate, double);
  ///@}

  ///@{
  /**
   * Metres of hand motion for one world unit, 1e-12 or more. The default 0.001 means life-size for
   * data in millimetres; 0.002 means twice life-size, and no stiffer.
   */
  vtkSetClampMacro(MetersPerWorldUnit, double, 1e-12, 1e12);
  vtkGetMacro(MetersPerWorldUnit, double);
  ///@}

  ///@{
  /** C1 of eq. 1 (N per scalar unit per world unit), for FORCE_FIELD. Default 0.01. */
  vtkSetMacro(ForceFieldGain, double);
  vtkGetMacro(ForceFieldGain, double);
  ///@}

  ///@{
  /** C2 of eq. 1 (N s/m), 0 or more, for FORCE_FIELD. Default 0. */
  vtkSetClampMacro(ForceFieldDamping, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ForceFieldDamping, double);
  ///@}

  ///@{
  /**
   * Scalar value whose isosurface SURFACE_PROXY and LOCAL_SURFACE touch, and whose material it has.
   * Default 0.
   */
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /**
   * Radius of the sphere (world units) of SURFACE_PROXY, 0 to 1e9; some voxels at most, since a
   * tick looks at all triangles that it touches: a radius that is too large for the surface is an
   * error. Gaps narrower than its diameter are not felt. 0 (default) stands for half of the
   * smallest spacing.
   */
  vtkSetClampMacro(ProxyRadius, double, 0.0, 1e9);
  vtkGetMacro(ProxyRadius, double);
  ///@}

  ///@{
  /**
   * Turn the force of SURFACE_PROXY smoothly from triangle to triangle, by the point normals.
   * Default on.
   */
  vtkSetMacro(ForceShading, bool);
  vtkGetMacro(ForceShading, bool);
  vtkBooleanMacro(ForceShading, bool);
  ///@}

  enum LocalSurfaceShapeType
  {
    PLANE = 0,
    QUADRIC = 1
  };

  ///@{
  /**
   * What LOCAL_SURFACE fits: the tangent PLANE (default), or the QUADRIC that also bends as the
   * normal does over KernelRadius voxels to either side. A hand that slides over a plane is where
   * the surface was at the last look: over a convex one that costs work, over a concave one it
   * gives some. Both are found where V is IsoValue; only with CUBIC_BSPLINE is the gradient's
   * direction exactly across that.
   */
  vtkSetClampMacro(LocalSurfaceShape, int, PLANE, QUADRIC);
  vtkGetMacro(LocalSurfaceShape, int);
  void SetLocalSurfaceShapeToPlane() { this->SetLocalSurfaceShape(PLANE); }
  void SetLocalSurfaceShapeToQuadric() { this->SetLocalSurfaceShape(QUADRIC); }
  ///@}

  ///@{
  /**
   * How often LOCAL_SURFACE's slow loop looks (Hz), 1 to 1000; 30 to 100 are usual. Its answer
   * comes one period later: with a device from a thread of its own, offline in simulated time.
   * Default 60.
   */
  vtkSetClampMacro(LocalSurfaceRate, double, 1.0, 1000.0);
  vtkGetMacro(LocalSurfaceRate, double);
  ///@}

  ///@{
  /**
   * Time (s) in which LOCAL_SURFACE's force goes over from one surface to the next, 0 to 10: longer
   * ones are smoother, and follow later. Default 0.015.
   */
  vtkSetClampMacro(RecoveryTime, double, 0.0, 10.0);
  vtkGetMacro(RecoveryTime, double);
  ///@}

  ///@{
  /**
   * Longest force (N) that the trace shows; longer ones are shortened. 0 (default) does not limit.
   */
  vtkSetClampMacro(MaximumForce, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumForce, double);
  ///@}

  ///@{
  /**
   * Cap on the stiffness (N/m) whatever the material says: what a device and its sampling can hold
   * stable. 0 (default) does not cap.
   */
  vtkSetClampMacro(MaximumStiffness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumStiffness, double);
  ///@}

  /**
   * Method and Solver as one choice, for menus and command lines, in the order of NextMethod():
   * "proxy" (PROXY with PRECISE), "paper" (PROXY with PAPER), "force-field", "surface-proxy",
   * "local-surface".
   */
  static vtkStringArray* GetMethodNames();

  /** One of GetMethodNames(); false, with an error that lists them, for any other name. */
  bool SetMethodByName(const char* name);
  std::string GetMethodName();

  /** What is felt, for people, such as "Proxy, PRECISE". */
  std::string GetMethodText();

  /** Go on to the next of GetMethodNames(), and from the last to the first. */
  void NextMethod();

  /** Includes the property and its functions. */
  vtkMTimeType GetMTime() override;

  /** Print the settings and the property, without the pipeline around them: for recordings. */
  void PrintSettings(ostream& os, vtkIndent indent);

protected:
  vtkVolumeHapticsAlgorithm();
  ~vtkVolumeHapticsAlgorithm() override;

#ifndef __VTK_WRAP__
  /**
   * What is wrong with the settings for a servo that ticks at a rate (Hz), and the cure; or
   * nothing.
   */
  std::string CheckSettings(double rate) const;
#endif

  vtkSmartPointer<vtkHapticProperty> Property;
  int Method = PROXY;
  int Solver = PRECISE;
  int ContactAlignment = DISTINCTNESS;
  int GradientEstimator = GAUSSIAN;
  int KernelRadius = 2;
  double ServoRate = 1000.0;
  double MetersPerWorldUnit = 0.001;
  double ForceFieldGain = 0.01;
  double ForceFieldDamping = 0.0;
  double IsoValue = 0.0;
  double ProxyRadius = 0.0;
  bool ForceShading = true;
  int LocalSurfaceShape = PLANE;
  double LocalSurfaceRate = 60.0;
  double RecoveryTime = 0.015;
  double MaximumForce = 0.0;
  double MaximumStiffness = 0.0;

private:
  void Choose(std::size_t choice);

  vtkVolumeHapticsAlgorithm(const vtkVolumeHapticsAlgorithm&) = delete;
  void operator=(const vtkVolumeHapticsAlgorithm&) = delete;
};

#endif
