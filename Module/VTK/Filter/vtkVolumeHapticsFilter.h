// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeHapticsFilter
 * @brief   the forces on a hand that moves a stylus through a volume
 *
 * Computes the forces on a stylus that moves through a volume, along a path or, with a
 * vtkHapticDevice, in a hand:
 *
 *   filter->SetInputConnection(reader->GetOutputPort());   // the volume
 *   filter->SetPathConnection(path->GetOutputPort());      // such as a vtkHapticPathSource
 *   filter->GetProperty()->ApplyPreset("CT contrast");
 *   filter->Update();                                      // the trace: proxy and forces by tick
 *
 * It implements Lundin, Ynnerman and Gudmundsson, "Proxy-based Haptic Feedback from Volumetric
 * Density Data", 2002. A proxy is tied to the stylus' tip by a spring of stiffness k. Virtual
 * surfaces, perpendicular to the gradient of the volume, hold the proxy back, as do friction and
 * drag. The force on the hand is k (x_p - x_tip). With the material from vtkHapticProperty, a tick
 * moves the proxy x_p from x_0 to
 *
 *   N = grad V / |grad V|,  d = x_tip - x_p,  T = T_N W_d(|grad V|)
 *   x_p += N sgn(d.N) (|d.N| - T/k)      if k |d.N| > T; outward with T = 0       (eqs. 12, 13)
 *   x_p += t/|t| (|t| - mu |d.N|)        if |t| > mu |d.N|, t = d - N (d.N)       (eqs. 8 to 10)
 *   x_p += (x_0 - x_p) min(1, R / (k |x_0 - x_p|))                                (eq. 14)
 *
 * (solver PAPER). d is computed again in each line; k, mu and T_N belong to the value at x_s = x_0
 * + r N, and R to the value at x_v = x_0 - r N (fig. 4); r is KernelRadius times the largest
 * spacing (all but PAPER: KernelRadius voxels along N). Beyond the volume the border's value
 * continues and there is no surface; over the last KernelRadius voxels inside the volume surfaces
 * fade. A sample that is NaN or infinite makes no surface; if such a sample, or a number for
 * missing values, is in a corner, all of them are felt as the least value. The first tick of a path
 * puts the proxy on the tip, without force.
 *
 * Solver PRECISE (default) is the same law for motions that are not small. With F = k (x_tip - x),
 *
 *   x' = 0                        while |F - q| <= R,
 *   F  = q + R x' / |x'|          else,
 *
 * along the tip's straight path. q is the part of F that surface and friction hold, with N, k, mu,
 * T and R at the position x. The tip moves in steps of a quarter of a voxel (or 2 % of the spring).
 * For one material point the proxy's motion exists and is unique: the drag's motion is the proximal
 * map of R |m| after the surface's map, both convex; friction, which is not convex, comes after the
 * surface. A motion is checked at its end and drawn back to the first point that holds as much as
 * the spring pulls. Such a point exists, because the spring gets shorter; at a step of a material
 * function, it is found to a thousandth of a voxel, on the side that holds. While a surface holds,
 * the proxy stays on the level of the smoothed value at which it met the surface: it neither drifts
 * nor leaks.
 *
 * If k rises, the force stays as it is; if k falls, the stretch stays. So no energy is created. The
 * array Stiffness is the stiffness of this spring, |F| / |d|. A tick takes 256 samples at most. If
 * more are needed (a tip that jumps by tens of voxels), the proxy stays at the point that it has
 * reached, with the force in balance there, the array Unfinished is 1, and the next tick continues.
 * With PRECISE, GAUSSIAN is the derivative of its own smoothed value: N is normal to that value's
 * levels. CENTRAL_DIFFERENCE has no such value: it keeps the proxy on its level only to a hundredth
 * of a voxel.
 *
 * Port 0: vtkImageData with point scalars (any scalar type; choose with SetInputArrayToProcess and
 * vtkHapticProperty::SetComponent). Its origin, spacing and direction matrix are honoured. It is
 * not copied. It may be a region of a larger volume, as vtkHapticRegionFilter makes it: it then
 * feels like the whole, to the bit. If the region lacks data that a tick needs, the force fades
 * within 50 ms and the proxy is put on the tip; the force returns as gradually. With a
 * vtkHapticRegionSource, which reads the regions by itself, ticks along a path wait for their data
 * instead.
 *
 * Any other vtkDataSet with cells (rectilinear, structured or unstructured), and a
 * vtkCompositeDataSet of such data sets, is resampled where the path or the hand is, by a
 * vtkHapticRegionSource that belongs to this filter: see its OpenDataSet(), which an application
 * calls itself for a spacing of its choice. Point and cell arrays can be touched and be the arrays
 * of modes.
 *
 * If the source of port 0 has several time steps, or the components of the touched array are frames
 * (SetFramesToComponents), the volume moves. The steps that the path needs are requested one after
 * the other and kept, and blended linearly between their times. At the path's time 0, the data time
 * is the first step's time; it advances by TimeUnitsPerSecond, and stops at the last step's time. A
 * surface that approaches a resting tip pushes it, with T_N W_d at most: before each tick the proxy
 * is carried along the gradient to where its level has moved. Motion along a surface is not felt,
 * since values do not show it. Blended edges stay edges as long as an edge moves by at most twice
 * its width from step to step. Neither limit holds if the steps have an array that says where their
 * material moves (DisplacementArrayName): the material is then blended and felt along its way.
 * Without such an array, edges that move by more than twice their width get a warning, once for
 * each source.
 *
 * Port 1, optional: vtkPolyData, the path of the tip in world units. Its points are the ticks, in
 * order; with a point array "Time" (s) the path is resampled to ServoRate. It may be one polyline,
 * segments (lines of two points) that continue one another, or points without lines: then all
 * points are one path, in the order in which they are stored. A line that joins them in another
 * order is an error. A recording of vtkHapticDevice is replayed tick by tick, to the bit. A
 * recording from before SetMaterialPlacement() is replayed with the materials of the kernel and the
 * contact alignment that it was made with, whatever is set.
 *
 * Several polylines are several paths, as if each were felt alone, to the bit: each begins with the
 * proxy on the tip, at its own first time, and goes through its points in the order of its cell.
 * Paths may share points, and a line of one point is a path of one tick. If all lines are segments
 * and one stroke can't draw them, each segment that continues the one before it belongs to the same
 * path. Points outside all lines, and vertices, are not felt. The paths are computed in parallel,
 * by vtkSMPTools.
 *
 * Port 2, optional: vtkPolyData, the surface that SURFACE_PROXY touches, in world units, instead of
 * the isosurface at IsoValue. Polygons and strips count; with point normals the force is shaded.
 *
 * Port 3, optional: vtkImageData, the labels of a segmentation, with a geometry of its own: origin,
 * spacing, direction and size may differ from those of port 0. The labels are its point scalars, of
 * any integer type or whole numbers of a floating-point type. SetLabelTable gives them materials:
 * k, mu and T_N are those of the label at x_s, and R is that of the label at x_v. A label without
 * an entry in the table, and all that lies outside the label image, has the material of the
 * transfer functions. Between labels, materials change gradually within a voxel of the label image,
 * by the trilinear weights of the labels of the eight voxels around. If no label at a position has
 * a material, forces are the same as without labels, to the bit. The methods SURFACE_PROXY and
 * LOCAL_SURFACE have one material, that of IsoValue, and FORCE_FIELD has none: labels don't change
 * them. The whole label image has to be in memory, also if port 0 has a region of a larger volume.
 *
 * Output: vtkPolyData, one point a tick at the proxy after the tick (world), one polyline for each
 * path, in the order of the paths, and these point arrays, unless SetTraceArrays() leaves some out:
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
 * empty output. Long paths report progress and can be aborted; each path then ends where it was
 * aborted.
 *
 * A path is felt as a whole: if the output is requested in pieces, for example on several ranks,
 * piece 0 requests the whole image and is the whole trace; the other pieces request nothing and are
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
  /** Set the path of the tip, on port 1. */
  void SetPathConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetPathData(vtkPolyData* path);
  ///@}

  ///@{
  /** Set the surface for SURFACE_PROXY, on port 2. */
  void SetSurfaceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /**
   * Set the label image, on port 3. SetInputArrayToProcess(1, 3, 0,
   * vtkDataObject::FIELD_ASSOCIATION_POINTS, name) chooses an array other than its point scalars.
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
   * Planes in world units that cut parts of the volume away: what lies on the negative side of a
   * plane is not felt, as vtkAbstractMapper::SetClippingPlanes does not show it. Pass a mapper's
   * own planes to cut where the picture is cut; moving them moves the cut. Default: none. Points of
   * the image that are blanked (HIDDENPOINT), or have blanked cells only, are cut away, too,
   * halfway to the next shown point. Over the last voxel in front of a cut, surfaces and drag fade;
   * SURFACE_PROXY and LOCAL_SURFACE end at it. Gradients are those of the whole volume, so that a
   * cut makes no edge of its own. The wall in front of a forbidden label, guides, and data on other
   * ports are not cut.
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
   * The tissue that a vtkHapticBurr has removed from the volume. Every tool feels the rest; a path
   * feels what was left when the filter ran, so call Modified() after the hand has removed more.
   * nullptr creates a new removal, with all tissue left. Default: a removal of this filter's own.
   */
  void SetRemoval(vtkHapticRemoval* removal);
  vtkHapticRemoval* GetRemoval();
  ///@}

  /**
   * Includes the change times of the property, its functions, the label table, the clipping planes,
   * and the settings of the removal.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Compute the MD5 of the touched scalars and of their shape, as recordings store it; empty if
   * there are none.
   */
  std::string HashScalars();

  /** Compute the MD5 of the labels on port 3 likewise. */
  std::string HashLabels();

  /**
   * Get the image that is touched: the image on port 0, or, for other data there, the region that
   * was resampled last, after an update of port 0; nullptr if there is none.
   */
  vtkImageData* GetTouchedImage();
  /**
   * Get the source of regions: the source of port 0, or the source that resamples port 0's data;
   * else nullptr.
   */
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

  std::weak_ptr<const VolumeHaptics::BakedVolume> LastBaked; // valid while anything uses the volume
  vtkMTimeType LastBakedTime = 0;
  std::unique_ptr<VolumeHaptics::BakePreparation> Preparation;
  std::unique_ptr<VolumeHaptics::ResampledInput> Resampled;
  std::unique_ptr<VolumeHaptics::FastMotionWarning> MotionWarning;
  std::unique_ptr<VolumeHaptics::RegionSeries> Regions;
  std::unique_ptr<VolumeHaptics::ArrayHash[]> Hashes; // hashes of scalars and labels
  vtkSmartPointer<vtkHapticLabelTable> LabelTable;
  vtkSmartPointer<vtkHapticRemoval> Removal;
  std::unique_ptr<VolumeHaptics::HapticCut> Cut;
#endif

  vtkVolumeHapticsFilter(const vtkVolumeHapticsFilter&) = delete;
  void operator=(const vtkVolumeHapticsFilter&) = delete;
};

#ifndef __VTK_WRAP__
/**
 * Calls Update() of a vtkVolumeHapticsFilter, for Python's ctypes: while ctypes calls a function,
 * other threads of Python run. VTK's own wrappers allow this only from VTK 9.4 on, in some builds.
 */
extern "C" VTKVOLUMEHAPTICS_EXPORT void vtkVolumeHapticsFilterUpdate(vtkObjectBase* filter);
#endif

#endif
