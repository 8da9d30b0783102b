// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeHapticsFilter
 * @brief   the forces on a hand that moves a stylus through a volume
 *
 * Implements Lundin, Ynnerman and Gudmundsson, "Proxy-based Haptic Feedback from Volumetric Density
 * Data", 2002. A proxy is tied to the stylus' tip by a spring of stiffness k. Virtual surfaces,
 * perpendicular to the gradient of the volume, hold it back; friction and drag, too. The force on
 * the hand is k (x_p - x_tip). With the material from vtkHapticProperty, a tick moves the proxy x_p
 * from x_0 to
 *
 *   N = grad V / |grad V|,  d = x_tip - x_p,  T = T_N W_d(|grad V|)
 *   x_p += N sgn(d.N) (|d.N| - T/k)      if k |d.N| > T; outward with T = 0       (eqs. 12, 13)
 *   x_p += t/|t| (|t| - mu |d.N|)        if |t| > mu |d.N|, t = d - N (d.N)       (eqs. 8 to 10)
 *   x_p += (x_0 - x_p) min(1, R / (k |x_0 - x_p|))                                (eq. 14)
 *
 * (solver PAPER). d is computed again in each line; k, mu and T_N belong to the value at x_s = x_0
 * + r N and R to that at x_v = x_0 - r N (fig. 4); r is KernelRadius times the largest spacing (all
 * but PAPER: KernelRadius voxels along N).
 * Beyond the volume the border's value continues and there is no surface; over the last
 * KernelRadius voxels inside the volume surfaces fade. A sample that is NaN or infinite makes no
 * surface; if one is in a corner, or a number for missing values, all are felt as the least value.
 * The first tick of a path puts the proxy on the tip, without force.
 *
 * Solver PRECISE (default) is the same law for motions that are not small. With F = k (x_tip - x),
 *
 *   x' = 0                        while |F - q| <= R,
 *   F  = q + R x' / |x'|          else,
 *
 * along the tip's straight path. q is the part of F that surface and friction hold, with N, k, mu,
 * T and R at the position x. The tip moves in steps of a quarter of a voxel (or 2 % of the spring).
 * For one material point the proxy's motion exists and is unique: the drag's is the proximal map of
 * R |m| after the surface's, both convex, and friction, which is not, comes after the surface. A
 * motion is judged at its end and drawn back to the first point that holds as much as the spring
 * pulls. There is such a point, because the spring gets shorter; at a step of a material function,
 * it is found to a thousandth of a voxel, on the side that holds. While a surface holds, the proxy
 * stays on the level of the smoothed value at which it met the surface: it neither drifts nor
 * leaks.
 *
 * If k rises, the force stays as it is; if k falls, the stretch stays. So no energy is created. The
 * array Stiffness is the spring's own, |F| / |d|. A tick takes 256 samples at most. If more are
 * needed (a tip that jumps by tens of voxels), the proxy stays at the point that it has reached,
 * with the force in balance there, the array Unfinished is 1, and the next tick goes on. With
 * PRECISE, GAUSSIAN is the derivative of its own smoothed value: N is normal to that value's
 * levels. CENTRAL_DIFFERENCE has no such value: it keeps the proxy on its level to a hundredth of a
 * voxel only.
 *
 * Port 0: vtkImageData with point scalars (any scalar type; choose with SetInputArrayToProcess and
 * vtkHapticProperty::SetComponent). Its origin, spacing and direction matrix are honoured. It is
 * not copied. It may be a region of a larger volume, as vtkHapticRegionFilter makes it: it then
 * feels like the whole, to the bit. If the region lacks data that a tick needs, the force fades
 * within 50 ms and the proxy is put on the tip; force comes back in the same way. With a
 * vtkHapticRegionSource, which reads the regions by itself, ticks along a path wait for their data
 * instead.
 *
 * Any other vtkDataSet with cells (rectilinear, structured or unstructured), and a
 * vtkCompositeDataSet of such, is resampled where the path or the hand is, by a
 * vtkHapticRegionSource of this filter's own: see its OpenDataSet(), which an application calls
 * itself for a spacing of its choice. Point and cell arrays can be touched and be those of modes.
 *
 * If the source of port 0 has several time steps, or the components of the touched array are frames
 * (SetFramesToComponents), the volume moves. The steps that the path needs are requested one after
 * the other and kept, and blended linearly between their times. The data time is the first step's
 * at the path's time 0, goes on by TimeUnitsPerSecond, and stops at the last step's. A surface that
 * comes pushes a tip that rests, with T_N W_d at most: before each tick the proxy is carried along
 * the gradient to where its level has gone. What moves along a surface is not felt, since values do
 * not tell it. Blended edges are edges as long as an edge moves by no more than twice its width
 * from step to step. Neither holds if the steps have an array that tells where their material goes
 * (DisplacementArrayName): it is blended, and felt, along its way. Without it, edges that move by
 * more than that get a warning, once for each source.
 *
 * Port 1, optional: vtkPolyData, the path of the tip in world units. Its points are the ticks, in
 * order; with a point array "Time" (s) the path is resampled to ServoRate. It may be one polyline,
 * segments (lines of two points) that continue one another, or points without lines: then all
 * points are one path, in the order in which they are stored. A line that joins them in another
 * order is an error. A recording of vtkHapticDevice is replayed tick by tick, to the bit. One from
 * before SetMaterialPlacement() has the materials of the kernel and the contact alignment that it
 * was made with, whatever is set.
 *
 * Several polylines are several paths, as if each were felt alone, to the bit: each begins with the
 * proxy on the tip, at its own first time, and goes through its points in the order of its cell.
 * Paths may share points, and a line of one point is a path of one tick. If all lines are segments
 * and one stroke can't draw them, those that continue the one before are one path with it. Points
 * of no line are not felt, and neither are vertices. The paths are felt in parallel, by
 * vtkSMPTools.
 *
 * Port 2, optional: vtkPolyData, the surface that SURFACE_PROXY touches, in world units, instead of
 * the isosurface at IsoValue. Polygons and strips count; with point normals the force is shaded.
 *
 * Port 3, optional: vtkImageData, the labels of a segmentation, with a geometry of its own: origin,
 * spacing, direction and size may differ from those of port 0. The labels are its point scalars, of
 * any integer type or whole numbers of a floating-point type. SetLabelTable gives them materials:
 * k, mu and T_N at x_s are those of the label there, R at x_v is that of the label there. A label
 * without an entry in the table, and all that lies outside the label image, has the material of the
 * transfer functions. From one label to the next, materials go over within a voxel of the label
 * image, by the trilinear shares of the labels of the eight voxels around. If no label at a place
 * has a material, forces are the same as without labels, to the bit. The methods SURFACE_PROXY and
 * LOCAL_SURFACE have one material, that of IsoValue, and FORCE_FIELD has none: labels don't change
 * them. The whole label image has to be in memory, also if port 0 has a region of a larger volume.
 *
 * Output: vtkPolyData, one point a tick at the proxy after the tick (world), one polyline for each
 * path, in the order of the paths, and the point arrays, of which SetTraceArrays() chooses some,
 *
 *   Time               s; of the tick
 *   Tip (3)            world; the stylus
 *   Force (3)          N, world axes; on the hand
 *   NormalForce        N; k |d.N| before the drag
 *   FrictionForce      N; k |t| before the drag
 *   DragForce          N; k times the distance by which the drag moved the proxy back
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
 *   Energy             J; given to the hand so far by the force, and by the torque of a tool with a
 *                      shape, by trapezoids. If a path ends without force, the last value is the
 *                      energy that was created (FORCE_FIELD can) or, below 0, spent
 *   Unfinished         1 if PRECISE spent its budget, and the next tick does the rest; else 0
 *   Label              at the output point plus r Normal, just inside the surface: the label of the
 *                      nearest voxel, 0 beyond the label image. Only with a label image on port 3
 *   DataTime           of the source; at this tick. Only of a volume that moves
 *   ModeForce_i (3)    N, world axes; of mode i on the hand, before MaximumForce. Only with the
 *                      method PRIMITIVES, for all of its modes
 *   Orientation (4)    of the stylus in the world: w, x, y, z; all 0: none. Only with a tool
 *   Torque (3)         N m, world axes; on the hand about the tip. Only with a tool
 *   Depth              world units; of a vtkHapticNeedle that is inserted, else 0. Only with a tool
 *   ShaftForce         N; the most that the tissue along its shaft holds. Only with a tool
 *   ToolOrientation (4)  of a vtkHapticPointShell in the world: w, x, y, z. Its origin is the
 *                      output point. Only with one
 *   RemovedVolume      mm^3 of the hand's space; by a vtkHapticBurr in this tick. Only with one
 *   ForbiddenTouches   how often a forbidden label has stopped this insertion of a vtkHapticNeedle.
 *                      Only with one
 *   Renewed            1 if LOCAL_SURFACE got a new surface from its slow loop; else 0
 *
 * The same input gives the same output, to the bit, on any number of threads. Without a path the
 * output is empty, and input is only checked; a mesh that takes long is then left to the
 * background. Input that can't be touched gives one error that names the input and the cure, and an
 * empty output. Long paths report progress and can be aborted; each then ends where it was aborted.
 *
 * A path is felt as a whole: if the output is requested in pieces, for example on several ranks,
 * piece 0 requests the whole image and is the whole trace; the others request nothing and are
 * empty.
 *
 * @sa vtkVolumeHapticsAlgorithm, vtkHapticProperty, vtkHapticDevice, vtkHapticRegionFilter,
 * vtkHapticRegionSource
 */
#ifndef vtkVolumeHapticsFilter_h
#define vtkVolumeHapticsFilter_h

#include "vtkSmartPointer.h" // for ivars
#include "vtkVolumeHapticsAlgorithm.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::shared_ptr
#include <string> // for std::string

class vtkHapticLabelTable;
class vtkHapticRemoval;
class vtkHapticRegionSource;
class vtkImageData;
class vtkInformation;
class vtkMatrix4x4;
class vtkPlane;
class vtkPlaneCollection;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
class ArrayHash;
class BakePreparation;
class FastMotionWarning;
class HapticBaker;
class HapticModel;
class RegionSeries;
class ResampledInput;
struct BakedVolume;
struct HapticCut;
} // namespace VolumeHaptics
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkVolumeHapticsFilter : public vtkVolumeHapticsAlgorithm
{
public:
  static vtkVolumeHapticsFilter* New();
  vtkTypeMacro(vtkVolumeHapticsFilter, vtkVolumeHapticsAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

  ///@{
  /**
   * The label image, on port 3. SetInputArrayToProcess(1, 3, 0,
   * vtkDataObject::FIELD_ASSOCIATION_POINTS, name) chooses another array than its point scalars.
   */
  void SetLabelConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(3, output); }
  void SetLabelData(vtkImageData* labels);
  ///@}

  ///@{
  /** The materials of the labels. Default: none, so that no label has a material. */
  void SetLabelTable(vtkHapticLabelTable* table);
  vtkHapticLabelTable* GetLabelTable();
  ///@}

  ///@{
  /**
   * Planes in world units that cut parts of the volume away: what lies on the negative side of one
   * is not felt, as vtkAbstractMapper::SetClippingPlanes does not show it. A mapper's own planes
   * can be given; moving them moves the cut. Default: none. Points of the image that are blanked
   * (HIDDENPOINT), or have blanked cells only, are cut away, too, halfway to the next shown point.
   * Over the last voxel in front of a cut, surfaces and drag fade; SURFACE_PROXY and LOCAL_SURFACE
   * end at it. Gradients are those of the whole volume, so that a cut makes no edge of its own. The
   * wall in front of a forbidden label, guides and what another port feels are not cut.
   */
  void SetClippingPlanes(vtkPlaneCollection* planes);
  vtkPlaneCollection* GetClippingPlanes();
  void AddClippingPlane(vtkPlane* plane);
  void RemoveClippingPlane(vtkPlane* plane);
  void RemoveAllClippingPlanes();
  ///@}

  ///@{
  /** Regions that are cut away, as by the mappers' vtkVolumeMapper::SetCropping. Default: off. */
  void SetCropping(bool cropping);
  bool GetCropping();
  vtkBooleanMacro(Cropping, bool);
  ///@}

  ///@{
  /**
   * Two planes for each axis of the image, xmin, xmax, ymin and so on, world units without the
   * image's direction matrix, between which the 27 regions of SetCroppingRegionFlags lie. Default:
   * (0, 1, 0, 1, 0, 1).
   */
  void SetCroppingRegionPlanes(const double planes[6]) VTK_SIZEHINT(planes, 6);
  void SetCroppingRegionPlanes(
    double xmin, double xmax, double ymin, double ymax, double zmin, double zmax);
  double* GetCroppingRegionPlanes() VTK_SIZEHINT(6);
  ///@}

  ///@{
  /**
   * The regions that are felt: bit x + 3 y + 9 z, with x = 0 below xmin, 1 up to xmax, 2 above, and
   * so on; VTK_CROP_SUBVOLUME and its like. Default: VTK_CROP_SUBVOLUME, the one in the middle.
   */
  void SetCroppingRegionFlags(int flags);
  int GetCroppingRegionFlags();
  ///@}

  ///@{
  /**
   * Whether the faces of a cut hold like the material behind them: with k, mu and T_N of the value
   * one voxel behind the face, from outside, over half a voxel. So a cut bone is hard and a cut
   * muscle is soft, and where T_N is zero nothing holds. For the method PROXY. Default: off, so
   * that a hand goes through a face without a force.
   */
  void SetFeelCutFaces(bool feel);
  bool GetFeelCutFaces();
  vtkBooleanMacro(FeelCutFaces, bool);
  ///@}

  ///@{
  /**
   * What a vtkHapticBurr has removed from the volume. Every tool feels it; a path feels what was
   * left when the filter ran, so that Modified() is needed after the hand has removed more. nullptr
   * makes a new one, of all tissue. Default: one of this filter's own.
   */
  void SetRemoval(vtkHapticRemoval* removal);
  vtkHapticRemoval* GetRemoval();
  ///@}

  /**
   * Includes the property, its functions, the label table, the clipping planes, and the settings of
   * the removal.
   */
  vtkMTimeType GetMTime() override;

  /**
   * MD5 of the touched scalars and of their shape, as a recording carries it; empty if there are
   * none.
   */
  std::string HashScalars();

  /** The same of the labels on port 3. */
  std::string HashLabels();

  /**
   * The image that is touched: that on port 0, or of other data there the region that was resampled
   * last, after an update of port 0; nullptr if there is none.
   */
  vtkImageData* GetTouchedImage();
  /** What reads regions if port 0 has no image: its source, or one that resamples; else nullptr. */
  vtkHapticRegionSource* GetRegionSource();

protected:
  vtkVolumeHapticsFilter();
  ~vtkVolumeHapticsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
#ifndef __VTK_WRAP__
  friend class VolumeHaptics::HapticBaker;

  int TouchPath(vtkImageData* image, vtkPolyData* path, vtkPolyData* output, vtkIdType& ticks);

  std::weak_ptr<const VolumeHaptics::BakedVolume> LastBaked; // valid while anything uses it
  vtkMTimeType LastBakedTime = 0;
  std::unique_ptr<VolumeHaptics::BakePreparation> Preparation;
  std::unique_ptr<VolumeHaptics::ResampledInput> Resampled;
  std::unique_ptr<VolumeHaptics::FastMotionWarning> MotionWarning;
  std::unique_ptr<VolumeHaptics::RegionSeries> Regions;
  std::unique_ptr<VolumeHaptics::ArrayHash[]> Hashes; // of scalars and labels
  vtkSmartPointer<vtkHapticLabelTable> LabelTable;
  vtkSmartPointer<vtkHapticRemoval> Removal;
  std::unique_ptr<VolumeHaptics::HapticCut> Cut;
#endif

  vtkVolumeHapticsFilter(const vtkVolumeHapticsFilter&) = delete;
  void operator=(const vtkVolumeHapticsFilter&) = delete;
};

#ifndef __VTK_WRAP__
/**
 * Update() of a vtkVolumeHapticsFilter, for Python's ctypes: while it calls a function, other
 * threads of Python run. VTK's own wrappers let them from VTK 9.4 on, and only in some builds.
 */
extern "C" VTKVOLUMEHAPTICS_EXPORT void vtkVolumeHapticsFilterUpdate(vtkObjectBase* filter);
#endif

#endif
