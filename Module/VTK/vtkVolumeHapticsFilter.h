// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeHapticsFilter
 * @brief   what a hand feels that moves a stylus through a volume
 *
 * Implements Lundin, Ynnerman and Gudmundsson, "Proxy-based Haptic Feedback from Volumetric Density
 * Data", 2002. A proxy is tied to the stylus' tip by a spring of stiffness k. Virtual surfaces,
 * perpendicular to the gradient of the volume, hold it back; friction and drag, too. The force on the
 * hand is k (x_p - x_tip). With the material from vtkHapticProperty, a tick moves the proxy x_p from
 * x_0 to
 *
 *   N = grad V / |grad V|,  d = x_tip - x_p,  T = T_N W_d(|grad V|)
 *   x_p += N sgn(d.N) (|d.N| - T/k)      if k |d.N| > T; outward with T = 0       (eqs. 12, 13)
 *   x_p += t/|t| (|t| - mu |d.N|)        if |t| > mu |d.N|, t = d - N (d.N)       (eqs. 8 to 10)
 *   x_p += (x_0 - x_p) min(1, R / (k |x_0 - x_p|))                                (eq. 14)
 *
 * (solver PAPER), where d is taken anew in each line, k, mu and T_N belong to the value at
 * x_s = x_0 + r N and R to that at x_v = x_0 - r N (fig. 4); r is KernelRadius times the largest
 * spacing. Beyond the volume the border's value holds and there is no surface; over the last
 * KernelRadius voxels inside it surfaces fade. Where a sample is NaN or infinite there is no surface,
 * and the value of the first finite corner of the volume stands in (0 where no corner is finite). The
 * first tick of a path puts the proxy on the tip, without force.
 *
 * Solver PRECISE (default) is the same law for motions that are not small. With F = k (x_tip - x),
 *
 *   x' = 0                        while |F - q| <= R,
 *   F  = q + R x' / |x'|          else,
 *
 * along the tip's straight way, where q is what surface and friction hold of F, with N, k, mu, T and
 * R of the place x. The tip goes a quarter of a voxel (or 2 % of the spring) at a time. At one place the proxy's
 * motion exists and is unique: the drag's is the proximal map of R |m| after the surface's, both
 * convex, and friction, which is not, comes after the surface. A motion is judged at its end and drawn
 * back to the first point that holds as much as the spring pulls (there is one, since the spring gets
 * shorter); at a step of a material function, to a thousandth of a voxel on the side that holds. While
 * a surface holds, the proxy stays on the level of the smoothed value where it met it: it neither
 * drifts nor leaks. Where k rises the force stays, where it falls the stretch, so that no energy is
 * created; the array Stiffness is then the spring's own, |F| / |d|. A tick looks at 256 places at
 * most. If these do not do (a tip that jumps by tens of voxels), the proxy is where it came to, with
 * the force in balance there, the array Unfinished is 1, and the next tick goes on. GAUSSIAN is then
 * the derivative of its own smoothed value, for N to be normal to levels; CENTRAL_DIFFERENCE can't be,
 * and holds its proxy to a hundredth of a voxel only.
 *
 * Port 0: vtkImageData with point scalars (any scalar type; choose with SetInputArrayToProcess and
 * vtkHapticProperty::SetComponent). Its origin, spacing and direction matrix are honoured. It is not
 * copied.
 *
 * Port 1, optional: vtkPolyData, the path of the tip in world units. Its points are the ticks, in
 * order; with a point array "Time" (s) the path is resampled to ServoRate. A recording of
 * vtkHapticDevice is replayed tick by tick, to the bit.
 *
 * Port 2, optional: vtkPolyData, the surface that SURFACE_PROXY touches, in world units, instead of
 * the isosurface at IsoValue. Polygons and strips count; with point normals the force is shaded.
 *
 * Output: vtkPolyData, one point a tick at the proxy after the tick (world), one polyline, and the
 * point arrays
 *
 *   Time               s; of the tick
 *   Tip (3)            world; the stylus
 *   Force (3)          N, world axes; on the hand
 *   NormalForce        N; k |d.N| before the drag
 *   FrictionForce      N; k |t| before the drag
 *   DragForce          N; k times the way that the drag took the proxy back
 *   Normal (3)         unit; into the structure, as the tick used it
 *   Value              scalar; V at the output point
 *   GradientMagnitude  scalar per world unit; as the tick used it
 *   SurfaceValue       scalar; V(x_s), as the tick used it
 *   MediumValue        scalar; V(x_v), as the tick used it
 *   Stiffness          N/m; k
 *   Friction           mu
 *   Viscosity          N; R
 *   SurfaceStrength    N; T_N W_d
 *   Contact            0 free, 1 sticking, 2 sliding, 3 penetrating
 *   Energy             J; given to the hand so far, by trapezoids: what a path that ends without force
 *                      ends with is what was created (FORCE_FIELD can) or, below 0, spent
 *   Unfinished         1 where PRECISE left a tick's way to the next, else 0
 *
 * The same input gives the same output, to the bit. Without a path the output is empty. Input that
 * can't be touched gives one error that names the input and the cure, and an empty output. A long
 * path reports progress and can be aborted; the output then ends where it was aborted.
 *
 * @sa vtkHapticProperty, vtkHapticDevice
 */
#ifndef vtkVolumeHapticsFilter_h
#define vtkVolumeHapticsFilter_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::shared_ptr
#include <string> // for std::string

class vtkHapticProperty;
class vtkImageData;
class vtkInformation;
class vtkMatrix4x4;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
class HapticModel;
class HapticSurface;
struct Affine3;
struct ForceCaps;
} // namespace VolumeHaptics
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkVolumeHapticsFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkVolumeHapticsFilter* New();
  vtkTypeMacro(vtkVolumeHapticsFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The materials. Created with its defaults on first Get; nullptr goes back to those.
   */
  void SetProperty(vtkHapticProperty* property);
  vtkHapticProperty* GetProperty();
  ///@}

  enum MethodType
  {
    PROXY = 0,
    FORCE_FIELD = 1,
    SURFACE_PROXY = 2
  };

  ///@{
  /**
   * PROXY (default) is the method above. FORCE_FIELD is the general approach that the paper
   * compares itself with (eq. 1): f = -ForceFieldGain grad V - ForceFieldDamping v_tip, without a
   * proxy. Its NormalForce and DragForce are the magnitudes of the two terms. SURFACE_PROXY is the
   * polygonal surface haptics that the paper compares itself with (Ruspini et al. 1997): a sphere of
   * ProxyRadius that no triangle of the surface lets through, with stiffness and friction of the
   * material at IsoValue, and neither drag nor a limit to what the surface holds: Viscosity,
   * SurfaceStrength and GradientMagnitude are 0.
   */
  vtkSetClampMacro(Method, int, PROXY, SURFACE_PROXY);
  vtkGetMacro(Method, int);
  void SetMethodToProxy() { this->SetMethod(PROXY); }
  void SetMethodToForceField() { this->SetMethod(FORCE_FIELD); }
  void SetMethodToSurfaceProxy() { this->SetMethod(SURFACE_PROXY); }
  ///@}

  enum SolverType
  {
    PAPER = 0,
    PRECISE = 1
  };

  ///@{
  /**
   * How PROXY advances the proxy in a tick. PAPER: as published, one look at the volume where the
   * proxy is when the tick begins. PRECISE (default): the same law, in balance where the proxy ends.
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
   * Where a surface begins to hold, with PRECISE. DISTINCTNESS (default): as soon as W_d and T_N say
   * so, on a blurred edge some voxels before its middle, since x_s is r ahead. EDGE: not before
   * V(x_p) >= (V(x_s) + V(x_v)) / 2 (within 0.1 % of their difference), so that what is felt lies on
   * what is seen. On a linear ramp both are alike.
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
  /**
   * Ticks per second (Hz), 1 to 100000. Default 1000.
   */
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
  /**
   * C1 of eq. 1 (N per scalar unit per world unit), for FORCE_FIELD. Default 0.01.
   */
  vtkSetMacro(ForceFieldGain, double);
  vtkGetMacro(ForceFieldGain, double);
  ///@}

  ///@{
  /**
   * C2 of eq. 1 (N s/m), 0 or more, for FORCE_FIELD. Default 0.
   */
  vtkSetClampMacro(ForceFieldDamping, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ForceFieldDamping, double);
  ///@}

  ///@{
  /**
   * Scalar value whose isosurface SURFACE_PROXY touches, and whose material its surface has. Default 0.
   */
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /**
   * Radius of the sphere (world units) of SURFACE_PROXY, 0 to 1e9; some voxels at most, since a tick
   * looks at all triangles that it touches. Gaps narrower than its diameter are not felt.
   * 0 (default) stands for half of the smallest spacing.
   */
  vtkSetClampMacro(ProxyRadius, double, 0.0, 1e9);
  vtkGetMacro(ProxyRadius, double);
  ///@}

  ///@{
  /**
   * Turn the force of SURFACE_PROXY smoothly from triangle to triangle, by the point normals. Default on.
   */
  vtkSetMacro(ForceShading, bool);
  vtkGetMacro(ForceShading, bool);
  vtkBooleanMacro(ForceShading, bool);
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

  ///@{
  /** The path of the tip, on port 1. */
  void SetPathConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetPathData(vtkPolyData* path);
  ///@}

  ///@{
  /** The surface for SURFACE_PROXY, on port 2. */
  void SetSurfaceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  /** Includes the property and its functions. */
  vtkMTimeType GetMTime() override;

  /** Print the settings and the property, without the pipeline around them: for recordings. */
  void PrintSettings(ostream& os, vtkIndent indent);

  /**
   * MD5 of the scalars that are touched and of their shape, as a recording carries it; empty where
   * there are none.
   */
  std::string HashScalars();

#ifndef __VTK_WRAP__
  /**
   * Bring port 0 up to date and bake it, with the property and all settings, for a servo that ticks
   * at a rate (Hz) and drives a device with caps of its own. The matrix takes the servo's device
   * space (m) to the world; nullptr stands for the world scaled by MetersPerWorldUnit. Returns null
   * after an error. For vtkHapticDevice and the like; in C++ only.
   */
  std::shared_ptr<const VolumeHaptics::HapticModel> Bake(
    double rate, const VolumeHaptics::ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld);
#endif

protected:
  vtkVolumeHapticsFilter();
  ~vtkVolumeHapticsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

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
  double MaximumForce = 0.0;
  double MaximumStiffness = 0.0;

private:
#ifndef __VTK_WRAP__
  bool ReadPlacement(
    vtkMatrix4x4* deviceToWorld, VolumeHaptics::Affine3& placement, std::string& error);
  std::string CheckSettings(double rate) const;
  std::shared_ptr<const VolumeHaptics::HapticModel> BakeImage(vtkImageData* image,
    double tickPeriod, const VolumeHaptics::ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld,
    std::string& error);
  VolumeHaptics::ForceCaps Tighten(const VolumeHaptics::ForceCaps& deviceCaps) const;

  std::weak_ptr<const VolumeHaptics::HapticModel> LastBaked; // as long as somebody uses it
  vtkMTimeType LastBakedTime = 0;
  std::unique_ptr<VolumeHaptics::HapticSurface> Surfaces;
#endif

  vtkVolumeHapticsFilter(const vtkVolumeHapticsFilter&) = delete;
  void operator=(const vtkVolumeHapticsFilter&) = delete;
};

#endif
