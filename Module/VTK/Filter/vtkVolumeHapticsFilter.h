// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVolumeHapticsFilter
 * @brief   the forces on a hand that moves a stylus through a volume
 *
 * Computes the forces on a stylus that moves through a volume: along a path or, with a
 * vtkHapticDevice, in a hand. A spring ties a proxy to the stylus's tip, and virtual surfaces in
 * the volume hold the proxy back:
 *
 *   filter->SetInputConnection(reader->GetOutputPort());   // the volume
 *   filter->SetPathConnection(path->GetOutputPort());      // such as a vtkHapticPathSource
 *   filter->GetProperty()->ApplyPreset("CT contrast");     // the materials
 *   filter->Update();                                      // the trace: proxy and forces by tick
 *
 * Documentation/method.md has the equations, figures, and the choices beyond the paper that it
 * implements (Lundin, Ynnerman and Gudmundsson, "Proxy-based Haptic Feedback from Volumetric
 * Density Data", 2002).
 *
 * **Port 0, the volume**: vtkImageData with point scalars of any type. SetInputArrayToProcess and
 * vtkHapticProperty::SetComponent choose others. Origin, spacing and direction matrix count. The
 * array is not copied. A sample that is NaN or infinite makes no surface; if such a sample, or a
 * number for missing values, is in a corner, all of them are felt as the least value. The volume
 * may also be:
 *
 * - a region of a larger volume, made by vtkHapticRegionFilter. It feels like the whole, to the
 *   bit. If the region lacks data that a tick needs, the force fades within 50 ms and the proxy is
 *   put on the tip; the force returns as gradually. A vtkHapticRegionSource reads regions by
 *   itself; ticks along a path then wait for their data;
 * - any other vtkDataSet with cells, or a vtkCompositeDataSet of such data sets. A
 *   vtkHapticRegionSource of this filter resamples its point and cell arrays around the path or the
 *   hand. To choose the spacing, call vtkHapticRegionSource::OpenDataSet();
 * - a volume that moves: a source with several time steps, or an array whose components are time
 *   steps. See SetTimeUnitsPerSecond.
 *
 * **Port 1, the path** (optional): vtkPolyData. See SetPathConnection.
 *
 * **Port 2, the surface** (optional): vtkPolyData that SURFACE_PROXY touches. See
 * SetSurfaceConnection.
 *
 * **Port 3, the labels** (optional): the vtkImageData of a segmentation. See SetLabelConnection.
 *
 * **Output, the trace**: vtkPolyData with one point for each tick, at the proxy after the tick
 * (world), and one polyline for each path, in the order of the paths. It has these point arrays,
 * unless SetTraceArrays() leaves some out (the symbols are those of Documentation/method.md):
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
 *   Renewed            1 if LOCAL_SURFACE got a new surface from its slow loop; else 0
 *
 * The classes of tools list the arrays that only their traces have.
 *
 * The same input gives the same output, to the bit, on any number of threads. Without a path the
 * output is empty, and input is only checked; a mesh that takes long is then left to the
 * background. Input that can't be touched gives one error, which names the input and the cure, and
 * an empty output. Long paths report progress and can be aborted; each path then ends where it was
 * aborted. If the output is requested in pieces, for example on several ranks, piece 0 is the whole
 * trace, and the others are empty.
 *
 * @sa vtkHapticProperty, vtkHapticDevice, vtkHapticRegionFilter, vtkHapticRegionSource
 */
#ifndef vtkVolumeHapticsFilter_h
#define vtkVolumeHapticsFilter_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class vtkHapticLabelTable;
class vtkHapticMode;
class vtkHapticProperty;
class vtkHapticRegionSource;
class vtkHapticRemoval;
class vtkHapticTool;
class vtkImageData;
class vtkInformation;
class vtkPlane;
class vtkPlaneCollection;
class vtkStringArray;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
class ArrayHash;
class HapticBaker;
struct HapticCut;
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
   * Set the path of the tip, on port 1, in world units. Its points are the ticks, in order; with a
   * point array "Time" (s) the path is resampled to ServoRate. The first tick puts the proxy on the
   * tip, without force.
   *
   * A path may be one polyline, segments (lines of two points) that continue one another, or points
   * without lines: then all points are one path, in the order in which they are stored. A line that
   * joins them in another order is an error.
   *
   * Several polylines are several paths, each felt as if it were alone, to the bit: it begins with
   * the proxy on the tip, at its own first time, and goes through its points in the order of its
   * cell. Paths may share points, and a line of one point is a path of one tick. If all lines are
   * segments and one stroke can't draw them, each segment that continues the one before it belongs
   * to the same path. Points outside all lines, and vertices, are not felt. vtkSMPTools computes
   * the paths in parallel.
   *
   * A recording of vtkHapticDevice is replayed tick by tick, to the bit. A recording from before
   * SetMaterialPlacement() is replayed with the materials of the kernel and the contact alignment
   * that it was made with, whatever is set.
   */
  void SetPathConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetPathData(vtkPolyData* path);
  ///@}

  ///@{
  /**
   * Set the surface that SURFACE_PROXY touches instead of the isosurface at IsoValue, on port 2, in
   * world units. Polygons and strips are used; point normals make the force smooth from triangle to
   * triangle.
   */
  void SetSurfaceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /**
   * Set the label image, on port 3. Its labels are its point scalars, of any integer type or whole
   * numbers of a floating-point type; SetInputArrayToProcess(1, 3, 0,
   * vtkDataObject::FIELD_ASSOCIATION_POINTS, name) chooses another array. Its origin, spacing,
   * direction and size may differ from those of port 0. The whole label image has to be in memory,
   * even if port 0 has a region of a larger volume.
   */
  void SetLabelConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(3, output); }
  void SetLabelData(vtkImageData* labels);
  ///@}

  ///@{
  /**
   * The materials of the labels. Default: none, so that no label has a material.
   *
   * A label without an entry in the table, and everything outside the label image, has the material
   * of the transfer functions. Between labels, materials change gradually within a voxel of the
   * label image. If no label at a position has a material, forces are bit-identical to those
   * without labels. Labels don't change SURFACE_PROXY and LOCAL_SURFACE, which have one material,
   * that of IsoValue, nor FORCE_FIELD, which has none.
   */
  void SetLabelTable(vtkHapticLabelTable* table);
  vtkHapticLabelTable* GetLabelTable();
  ///@}

  ///@{
  /**
   * Planes in world units that cut parts of the volume away: the negative side of a plane is not
   * felt, as it is not shown with vtkAbstractMapper::SetClippingPlanes. Pass a mapper's own planes
   * to cut where the picture is cut; moving them moves the cut. Default: none. Points of the image
   * that are blanked (HIDDENPOINT), or whose cells are all blanked, are also cut away, halfway to
   * the next visible point. Over the last voxel in front of a cut, surfaces and drag fade;
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
   * The regions that are felt, as in vtkVolumeMapper: bit x + 3 y + 9 z, with x = 0 below xmin, 1
   * from xmin to xmax and 2 above xmax, and likewise y and z. Default: VTK_CROP_SUBVOLUME, the
   * middle region.
   */
  void SetCroppingRegionFlags(int flags);
  int GetCroppingRegionFlags();
  ///@}

  ///@{
  /**
   * Whether the faces of a cut hold like the material behind them: with k, mu and T_N of the value
   * one voxel behind the face, from outside, over half a voxel. A cut bone is thus hard and a cut
   * muscle soft, and a face where T_N is zero does not hold. For the method PROXY. Default: off: a
   * hand passes through a face without a force.
   */
  void SetFeelCutFaces(bool feel);
  bool GetFeelCutFaces();
  vtkBooleanMacro(FeelCutFaces, bool);
  ///@}

  ///@{
  /**
   * The tissue that a vtkHapticBurr has removed from the volume. Every tool feels the remaining
   * tissue; a path feels the tissue that remained when the filter ran, so call Modified() after the
   * hand has removed more. nullptr creates a new removal, with all tissue present. Default: a
   * removal of this filter's own.
   */
  void SetRemoval(vtkHapticRemoval* removal);
  vtkHapticRemoval* GetRemoval();
  ///@}

  ///@{
  /**
   * The materials. Created with default settings on the first Get; nullptr restores the default
   * settings.
   */
  void SetProperty(vtkHapticProperty* property);
  vtkHapticProperty* GetProperty();
  ///@}

  enum MethodType
  {
    PROXY = 0,
    FORCE_FIELD = 1,
    SURFACE_PROXY = 2,
    LOCAL_SURFACE = 3,
    PRIMITIVES = 4
  };

  ///@{
  /**
   * PROXY (default): a proxy held back by virtual surfaces everywhere in the volume, eqs. 2 to
   * 14. The others are for comparison. FORCE_FIELD, eq. 1: the gradient pushes, -C1 grad V - C2
   * v, without a proxy. SURFACE_PROXY: a small ball that no triangle of the isosurface at the
   * IsoValue (or of the surface) lets through. LOCAL_SURFACE: a slow loop fits a plane or a
   * quadric to that isosurface near the proxy, and the servo touches that. PRIMITIVES: modes,
   * which hold the hand by the vectors, tensors or lines in the volume.
   *
   * C1 is ForceFieldGain and C2 ForceFieldDamping; NormalForce and DragForce are then the
   * magnitudes of the two terms. SURFACE_PROXY is polygonal surface haptics (Ruspini et al. 1997)
   * with a ball of ProxyRadius. LOCAL_SURFACE is an intermediate representation (Mark et al.
   * 1996): the hand falls through a surface that it meets before the slow loop has looked.
   *
   * Both surfaces have the stiffness and friction of the material at IsoValue, no drag, and no
   * limit to what they hold: Viscosity, SurfaceStrength and GradientMagnitude are 0. If one of
   * these methods is chosen while a servo runs and the hand is inside the isosurface, its depth
   * counts. Up to three kernel radii deep, both hold the hand from outside. Deeper, SURFACE_PROXY
   * holds it from inside, and LOCAL_SURFACE does not hold it.
   *
   * PRIMITIVES feels the modes of AddMode(), with a spring of the CouplingStiffness; without modes
   * the hand is free. The scalars are felt if there is a mode of the kind SURFACE. NormalForce is
   * the magnitude of the whole force, along Normal; the arrays of materials are 0, but Stiffness.
   */
  vtkSetClampMacro(Method, int, PROXY, PRIMITIVES);
  vtkGetMacro(Method, int);
  void SetMethodToProxy() { this->SetMethod(PROXY); }
  void SetMethodToForceField() { this->SetMethod(FORCE_FIELD); }
  void SetMethodToSurfaceProxy() { this->SetMethod(SURFACE_PROXY); }
  void SetMethodToLocalSurface() { this->SetMethod(LOCAL_SURFACE); }
  void SetMethodToPrimitives() { this->SetMethod(PRIMITIVES); }
  ///@}

  ///@{
  /**
   * The modes of the method PRIMITIVES, at most eight, which are felt together. Adding a mode again
   * has no effect. All active modes have eight primitives at most: shear, ridge and one-sided front
   * one each; follow, two-sided front and guide two; vortex, tensor and surface three.
   */
  void AddMode(vtkHapticMode* mode);
  void RemoveMode(vtkHapticMode* mode);
  void RemoveAllModes();
  int GetNumberOfModes();
  ///@}

  /**
   * Get a mode by its index, which counts from 0 as in the array ModeForce_i; nullptr if there is
   * none.
   */
  vtkHapticMode* GetMode(int mode);

  /**
   * Set the method to PRIMITIVES, and replace all modes by those of a named way to feel:
   *
   * - "Follow the flow": held perpendicular to vectors, free along them.
   * - "Drift with the flow": held perpendicular to vectors, and pushed along them with a quarter of
   *   the strength.
   * - "Feel wave fronts": held along vectors, free perpendicular to them.
   * - "Find a vortex": held in around a vortex, and, more gently, along its axis.
   * - "Feel where a flow stretches": free along the direction that stretches most.
   * - "Slide along fibres", "Slide along fibres and sheets": tensors.
   * - "Follow a vessel", "Follow a dark vessel": ridges of the scalars, bright or dark.
   * - "Follow the flow and touch surfaces": with the material of the property, too.
   *
   * Strengths suit the image (vtkHapticMode::ProposeFromImage). Without active vectors or tensors,
   * the modes are about the first array that fits. If the image is nullptr, strengths are 2 N.
   * Reports an error, changes nothing and returns false if there is no such name, or if the image
   * has nothing to feel in this way.
   */
  bool ApplyModePreset(const char* name, vtkImageData* image);

  /** Get the names that ApplyModePreset accepts. */
  static vtkStringArray* GetModePresetNames();

  ///@{
  /**
   * The tool in the hand, such as a vtkHapticNeedle; nullptr (default) stands for a point. It may
   * change while a hand feels it: after the next vtkHapticDevice::Publish(), a force that would
   * jump rises gradually. A tool of a class outside this module is refused with an error.
   */
  void SetTool(vtkHapticTool* tool);
  vtkHapticTool* GetTool();
  ///@}

  enum SolverType
  {
    PAPER = 0,
    PRECISE = 1
  };

  ///@{
  /**
   * How the method PROXY moves the proxy in a tick. PAPER: as published, with one look at the
   * volume, at the proxy's position before the tick. PRECISE (default): the same law, in balance
   * at the proxy's position after it; it neither drifts off curved walls nor leaks out of
   * cavities.
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
   * Where a surface begins to hold, with the solver PRECISE. DISTINCTNESS: as soon as distinctness
   * and strength suffice; on a blurred edge, this is some voxels before its middle. EDGE (default):
   * not before the middle of the edge, so that what is felt lies on what is seen.
   *
   * At the middle, V(x_p) >= (V(x_s) + V(x_v)) / 2, within 0.1 % of their difference. On a linear
   * ramp both settings are alike.
   */
  vtkSetClampMacro(ContactAlignment, int, DISTINCTNESS, EDGE);
  vtkGetMacro(ContactAlignment, int);
  void SetContactAlignmentToDistinctness() { this->SetContactAlignment(DISTINCTNESS); }
  void SetContactAlignmentToEdge() { this->SetContactAlignment(EDGE); }
  ///@}

  enum MaterialPlacementType
  {
    KERNEL = 0,
    FAR_SIDE = 1
  };

  ///@{
  /**
   * Which values the materials of a surface belong to, with the solver PRECISE. KERNEL: those a
   * kernel radius to either side of the proxy, as in the paper. FAR_SIDE (default): the values at
   * both ends of a blurred edge, so that skin feels like the tissue behind it from the first touch
   * on.
   *
   * FAR_SIDE follows the normal to the first plateau on either side, 3 KernelRadius voxels at most.
   * Along a surface in contact, the values change over 2.5 voxels of the proxy's path, and the
   * medium's value over 8, so that no material changes in a step. The arrays SurfaceValue and
   * MediumValue are the values that were read.
   */
  vtkSetClampMacro(MaterialPlacement, int, KERNEL, FAR_SIDE);
  vtkGetMacro(MaterialPlacement, int);
  void SetMaterialPlacementToKernel() { this->SetMaterialPlacement(KERNEL); }
  void SetMaterialPlacementToFarSide() { this->SetMaterialPlacement(FAR_SIDE); }
  ///@}

  enum GeometryType
  {
    FROM_SCALARS = 0,
    FROM_LABELS = 1,
    FROM_BOTH = 2
  };

  ///@{
  /**
   * Which image makes the surfaces of the method PROXY. FROM_SCALARS (default): the volume.
   * FROM_LABELS: the label image, with walls between its labels. FROM_BOTH: the volume, and walls
   * between labels where it has no distinct surface.
   *
   * A wall is where two labels have equal shares of the voxels around, weighted by a Gaussian of
   * 0.355 (KernelRadius + 2) voxels of the label image (1.4 by default); its normal is the shares'
   * gradient. On a ball of R voxels, the wall lies inside by the square of this width over R;
   * sheets thinner than 1.35 times this width have no wall. The structure of a wall is the harder
   * label: a label with an entry in the label table before one without; then the label with more
   * surface strength, then with more stiffness, then with the higher number. With
   * vtkHapticProperty::SetSurfaceSideToLower() it is the softer label. Labels that are not felt
   * have no walls between them. A wall holds as firmly as the surface strength says; neither
   * distinctness nor ContactAlignment changes this. Walls fade over the last KernelRadius + 1
   * voxels inside the label image. With FROM_BOTH, a wall replaces the surface of the volume where
   * that surface has a distinctness below one half.
   */
  vtkSetClampMacro(Geometry, int, FROM_SCALARS, FROM_BOTH);
  vtkGetMacro(Geometry, int);
  void SetGeometryFromScalars() { this->SetGeometry(FROM_SCALARS); }
  void SetGeometryFromLabels() { this->SetGeometry(FROM_LABELS); }
  void SetGeometryFromBoth() { this->SetGeometry(FROM_BOTH); }
  ///@}

  enum GradientEstimatorType
  {
    CENTRAL_DIFFERENCE = 0,
    GAUSSIAN = 1,
    CUBIC_BSPLINE = 2
  };

  ///@{
  /**
   * How gradients are estimated. CENTRAL_DIFFERENCE: of six trilinear samples KernelRadius voxels
   * away. GAUSSIAN (default): the derivative of a Gaussian, which noise disturbs least; its
   * standard deviation after its cut is about 1.0 voxel at KernelRadius 2 and 1.4 at 3.
   * CUBIC_BSPLINE: the analytic derivative of a smoothing cubic B-spline over 64 voxels. Values are
   * trilinear with the first two and B-spline values with the third.
   */
  vtkSetClampMacro(GradientEstimator, int, CENTRAL_DIFFERENCE, CUBIC_BSPLINE);
  vtkGetMacro(GradientEstimator, int);
  void SetGradientEstimatorToCentralDifference() { this->SetGradientEstimator(CENTRAL_DIFFERENCE); }
  void SetGradientEstimatorToGaussian() { this->SetGradientEstimator(GAUSSIAN); }
  void SetGradientEstimatorToCubicBSpline() { this->SetGradientEstimator(CUBIC_BSPLINE); }
  ///@}

  ///@{
  /**
   * Radius of the gradient kernel in voxels, 1 to 16. The distance r from the proxy at which
   * materials are read (fig. 4) is this number of voxels along the normal (with the solver Paper,
   * times the largest spacing). A larger kernel gives a smoother feel with less detail. Default 2.
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
   * Metres of hand motion for one world unit, 1e-12 to 1e12. The default 0.001 means life-size
   * for data in millimetres; 0.002 means twice life-size, and no stiffer.
   */
  vtkSetClampMacro(MetersPerWorldUnit, double, 1e-12, 1e12);
  vtkGetMacro(MetersPerWorldUnit, double);
  ///@}

  ///@{
  /**
   * The data time that passes in a second of the hand, -1e9 to 1e9, in the units of the image's
   * source: time steps per second if their times are whole numbers. A negative number plays
   * backwards. With 0, the volume does not move: only the time step that the pipeline requests is
   * felt. Default 1.
   *
   * At the path's time 0, the data time is the first step's time; it stops at the last step's time.
   * The time steps that the path needs are requested one after the other and kept, and blended
   * linearly between their times. If an edge moves by more than twice its width from step to step,
   * the filter warns, unless the steps have an array that says where their material moves
   * (DisplacementArrayName).
   */
  vtkSetClampMacro(TimeUnitsPerSecond, double, -1e9, 1e9);
  vtkGetMacro(TimeUnitsPerSecond, double);
  ///@}

  enum FramesType
  {
    TIME_STEPS = 0,
    COMPONENTS = 1
  };
  ///@{
  /**
   * Where the time steps of a volume that moves come from. TIME_STEPS (default): from the image's
   * source, if it has several. COMPONENTS: each component of the touched array is a time step,
   * FrameSpacing after the one before it; nothing is copied.
   *
   * vtkNIFTIImageReader gives a 4-D image such components:
   *
   *   reader->TimeAsVectorOn();
   *   reader->Update();
   *   filter->SetFramesToComponents();
   *   filter->SetFrameSpacing(reader->GetTimeSpacing());
   *
   * With COMPONENTS, time steps of the source are ignored, and data time begins at 0.
   * vtkHapticProperty::Component then counts only if TimeUnitsPerSecond is 0. DisplacementArrayName
   * does not apply to them.
   */
  vtkSetClampMacro(Frames, int, TIME_STEPS, COMPONENTS);
  vtkGetMacro(Frames, int);
  void SetFramesToTimeSteps() { this->SetFrames(TIME_STEPS); }
  void SetFramesToComponents() { this->SetFrames(COMPONENTS); }
  ///@}

  ///@{
  /**
   * The data time from one component of the touched array to the next, if the components are time
   * steps: 1e-12 to 1e12, in any unit. Default 1.
   */
  vtkSetClampMacro(FrameSpacing, double, 1e-12, 1e12);
  vtkGetMacro(FrameSpacing, double);
  ///@}

  ///@{
  /**
   * The name of a point array of each time step: the displacement of the material until the next
   * time step, three components in world units along the world's axes. Surfaces then move with
   * their material from step to step, however far, and take along a hand that friction holds. Empty
   * (default): the steps are blended in place.
   *
   * Registration gives such arrays, and so do simulations that move a mesh. The last time step
   * needs no such array. In any other step, a missing array, a wrong number of components, or
   * numbers that are not finite are errors. nullptr stands for the empty name.
   */
  void SetDisplacementArrayName(const char* name);
  std::string GetDisplacementArrayName();
  ///@}

  ///@{
  /**
   * One stiffness everywhere, the CouplingStiffness, instead of the stiffness of the material. A
   * hand that strokes with a constant force then feels the shape that it sees; materials are told
   * apart by surface strength, friction and drag. Default off.
   *
   * Off, a constant force f presses in by f/k, so that a change of the stiffness from k1 to k2 is
   * felt as a step of f (1/k1 - 1/k2): 3.8 mm for 1 N from 150 to 350 N/m. On, the material's
   * stiffness only decides what is felt: material without stiffness (0.001 N/m or less) is not
   * felt. The stiffness of labels is replaced likewise.
   */
  vtkSetMacro(SameShape, bool);
  vtkGetMacro(SameShape, bool);
  vtkBooleanMacro(SameShape, bool);
  ///@}

  ///@{
  /**
   * The stiffness (N/m) with SameShape, and of the method PRIMITIVES, 0 or more. MaximumStiffness
   * and the limits of a device cap it, too. Default 500.
   */
  vtkSetClampMacro(CouplingStiffness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CouplingStiffness, double);
  ///@}

  ///@{
  /**
   * C1 of eq. 1 (N per scalar unit per world unit), for the method FORCE_FIELD. Default 0.01.
   */
  vtkSetMacro(ForceFieldGain, double);
  vtkGetMacro(ForceFieldGain, double);
  ///@}

  ///@{
  /**
   * C2 of eq. 1 (N s/m), 0 or more, for the method FORCE_FIELD. Default 0.
   */
  vtkSetClampMacro(ForceFieldDamping, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ForceFieldDamping, double);
  ///@}

  ///@{
  /**
   * Scalar value whose isosurface the methods SURFACE_PROXY and LOCAL_SURFACE touch, and whose
   * material it has. Default 0.
   */
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /**
   * Radius of the ball (world units) of the method SURFACE_PROXY, 0 to 1e9; some voxels at most.
   * Gaps narrower than its diameter are not felt. 0 (default) stands for half of the smallest
   * spacing. A tick looks at all triangles that the ball touches: a radius that is too large for
   * the surface is an error.
   */
  vtkSetClampMacro(ProxyRadius, double, 0.0, 1e9);
  vtkGetMacro(ProxyRadius, double);
  ///@}

  ///@{
  /**
   * Turn the force of the method SURFACE_PROXY smoothly from triangle to triangle, by the point
   * normals. Default on.
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
   * The shape that the method LOCAL_SURFACE fits: the tangent PLANE (default), or the QUADRIC that
   * also bends as the normal does over KernelRadius voxels to either side. A plane stays where the
   * slow loop last fitted it: sliding over a convex surface costs work, and sliding over a concave
   * one returns some. Both are fitted to the isosurface at IsoValue; the gradient is exactly normal
   * to it only with CUBIC_BSPLINE.
   */
  vtkSetClampMacro(LocalSurfaceShape, int, PLANE, QUADRIC);
  vtkGetMacro(LocalSurfaceShape, int);
  void SetLocalSurfaceShapeToPlane() { this->SetLocalSurfaceShape(PLANE); }
  void SetLocalSurfaceShapeToQuadric() { this->SetLocalSurfaceShape(QUADRIC); }
  ///@}

  ///@{
  /**
   * How often the slow loop of the method LOCAL_SURFACE looks (Hz), 1 to 1000; 30 to 100 are
   * usual. Its result comes one period later. Default 60. With a device the loop has a thread of
   * its own; offline it runs in simulated time.
   */
  vtkSetClampMacro(LocalSurfaceRate, double, 1.0, 1000.0);
  vtkGetMacro(LocalSurfaceRate, double);
  ///@}

  ///@{
  /**
   * Time constant (s) with which the force changes when the proxy leaps, for example where a
   * surface gives way, 0 to 1. During this time, the force changes by at most 150 N/s. 0: it
   * changes at once. Default 0.005. For the solver PRECISE with materials of the FAR_SIDE.
   */
  vtkSetClampMacro(ReleaseTime, double, 0.0, 1.0);
  vtkGetMacro(ReleaseTime, double);
  ///@}

  ///@{
  /**
   * Time (s) in which the force of the method LOCAL_SURFACE changes over from one surface to the
   * next, 0 to 10. Longer times feel smoother and react later. Default 0.015.
   */
  vtkSetClampMacro(RecoveryTime, double, 0.0, 10.0);
  vtkGetMacro(RecoveryTime, double);
  ///@}

  ///@{
  /** The largest force (N) in the trace; larger forces are scaled down. 0 (default): no limit. */
  vtkSetClampMacro(MaximumForce, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumForce, double);
  ///@}

  ///@{
  /**
   * Cap on the stiffness (N/m), whatever the material says: what a device and its tick rate can
   * render without becoming unstable. 0 (default): no cap.
   */
  vtkSetClampMacro(MaximumStiffness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumStiffness, double);
  ///@}

  ///@{
  /**
   * The point arrays of the trace, by their names, with commas or spaces between them. Default
   * "all". "none" leaves the points, the proxy, alone. Arrays that are not chosen take neither time
   * nor memory; forces do not depend on the choice. The class documentation lists the arrays under
   * Output.
   *
   * nullptr stands for all. If no array has one of the names, returns false, with an error that
   * lists the arrays, and keeps the choice.
   */
  bool SetTraceArrays(const char* names);
  bool SetTraceArrays(vtkStringArray* names);
  std::string GetTraceArrays();
  ///@}

  ///@{
  /**
   * Switch arrays of the trace on or off one by one. An array that does not exist has the status 0.
   */
  int GetNumberOfTraceArrays();
  const char* GetTraceArrayName(int array);
  int GetTraceArrayStatus(const char* name);
  void SetTraceArrayStatus(const char* name, int status);
  ///@}

  /**
   * Get the names of all combinations of Method and Solver, for menus and command lines, in the
   * order of NextMethod(): "proxy" (PROXY with PRECISE), "paper" (PROXY with PAPER), "force-field",
   * "surface-proxy", "local-surface", "primitives".
   */
  static vtkStringArray* GetMethodNames();

  /**
   * Choose a method by one of GetMethodNames(). For any other name, reports an error that lists the
   * names and returns false.
   */
  bool SetMethodByName(const char* name);
  std::string GetMethodName();

  /** Get the name of the method and solver as users see it, such as "Proxy, PRECISE". */
  std::string GetMethodText();

  /**
   * Switch to the next of GetMethodNames(), and from the last to the first. "primitives" is skipped
   * if there are no modes.
   */
  void NextMethod();

#ifndef __VTK_WRAP__
  /** Get what is wrong with names for SetTraceArrays, with the cure; empty if they are valid. */
  static std::string CheckTraceArrays(const std::string& names);
#endif

  /**
   * Returns the latest modification time of this filter and of everything that affects its forces:
   * the property, the modes, the tool, their functions, the label table, the clipping planes, and
   * the settings of the removal.
   */
  vtkMTimeType GetMTime() override;

  /** Print the settings and the property without the rest of the pipeline, for recordings. */
  void PrintSettings(ostream& os, vtkIndent indent);

  /**
   * Compute the MD5 of the touched scalars and of their shape, as recordings store it; empty if
   * there are none.
   */
  std::string HashScalars();

  /** Compute the MD5 of the labels on port 3 in the same way. */
  std::string HashLabels();

  /**
   * Get the touched image: the image on port 0, or, for other data, the region that was resampled
   * last, after an update of port 0; nullptr if there is none.
   */
  vtkImageData* GetTouchedImage();
  /**
   * Get the source of regions: the source of port 0, or the source that resamples port 0's data;
   * else nullptr.
   */
  vtkHapticRegionSource* GetRegionSource();

  /**
   * Pass a source of regions the settings of this filter that it needs to plan and fill regions.
   * The filter and vtkHapticDevice call this for the source on port 0.
   */
  void ConfigureSource(vtkHapticRegionSource* source);

#ifndef __VTK_WRAP__
  ///@{
  /**
   * Returns the object that bakes models, for other classes of the module such as vtkHapticDevice.
   */
  VolumeHaptics::HapticBaker& GetBaker()
  {
    return *this->Baker;
  }
  const std::vector<vtkSmartPointer<vtkHapticMode>>& GetModes() const
  {
    return this->Modes;
  }
  /** Returns the array chosen by SetInputArrayToProcess, and its association (points or cells). */
  vtkDataArray* GetChosenArray(int index, vtkDataObject* data, int& association)
  {
    return this->GetInputArrayToProcess(index, data, association);
  }
  const VolumeHaptics::HapticCut* GetCut() const
  {
    return this->Cut.get();
  }
  ///@}
#endif

protected:
  vtkVolumeHapticsFilter();
  ~vtkVolumeHapticsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  unsigned long long TraceArrays; // a TraceArrayChoice

  vtkSmartPointer<vtkHapticProperty> Property;
  std::vector<vtkSmartPointer<vtkHapticMode>> Modes;
  vtkSmartPointer<vtkHapticTool> Tool;
  int Method = PROXY;
  int Solver = PRECISE;
  int ContactAlignment = EDGE;
  int MaterialPlacement = FAR_SIDE;
  int Geometry = FROM_SCALARS;
  int GradientEstimator = GAUSSIAN;
  int KernelRadius = 2;
  double ServoRate = 1000.0;
  double MetersPerWorldUnit = 0.001;
  double TimeUnitsPerSecond = 1.0;
  int Frames = TIME_STEPS;
  double FrameSpacing = 1.0;
  std::string DisplacementArrayName;
  bool SameShape = false;
  double CouplingStiffness = 500.0;
  double ForceFieldGain = 0.01;
  double ForceFieldDamping = 0.0;
  double IsoValue = 0.0;
  double ProxyRadius = 0.0;
  bool ForceShading = true;
  int LocalSurfaceShape = PLANE;
  double LocalSurfaceRate = 60.0;
  double RecoveryTime = 0.015;
  double ReleaseTime = 0.005;
  double MaximumForce = 0.0;
  double MaximumStiffness = 0.0;

private:
#ifndef __VTK_WRAP__
  void Choose(std::size_t choice);
  bool ChooseTraceArrays(const std::vector<std::string>& names);

  std::unique_ptr<VolumeHaptics::HapticBaker> Baker;
  std::unique_ptr<VolumeHaptics::ArrayHash[]> Hashes; // cached hashes of scalars and labels
  vtkSmartPointer<vtkHapticLabelTable> LabelTable;
  vtkSmartPointer<vtkHapticRemoval> Removal;
  std::unique_ptr<VolumeHaptics::HapticCut> Cut;
#endif

  vtkVolumeHapticsFilter(const vtkVolumeHapticsFilter&) = delete;
  void operator=(const vtkVolumeHapticsFilter&) = delete;
};

#ifndef __VTK_WRAP__
/**
 * Calls Update() of a vtkVolumeHapticsFilter through Python's ctypes, which releases Python's
 * global lock, so that other threads of Python run meanwhile. VTK's own wrappers do this only since
 * VTK 9.4, in some builds.
 */
extern "C" VTKVOLUMEHAPTICS_EXPORT void vtkVolumeHapticsFilterUpdate(vtkObjectBase* filter);
#endif

#endif
