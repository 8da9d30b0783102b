// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticMeasurements
 * @brief   points, distances, angles, paths and areas that were measured by touch
 *
 * Stores a list of measurements. Each has a name, points in the world, and a value computed from
 * the points. Neither a window nor a device is needed:
 *
 *   measurements->AddDistance(a, b);
 *   measurements->GetValue(0);                // 42.5
 *   measurements->WriteFile("head.mrk.json"); // for 3D Slicer
 *
 * | kind | points | value |
 * | --- | --- | --- |
 * | POINT | 1 | the value of the surface that was felt there, if any (the volume's unit) |
 * | DISTANCE | 2 | the length of the straight line between them |
 * | ANGLE | 3 | the angle at the second point (degrees) |
 * | PATH | any | the length of the line through them |
 * | AREA | any, of triangles | the total area of the triangles |
 *
 * Lengths and areas are in the unit of the world if that is mm, um, cm, m, nm or km, otherwise in
 * mm.
 *
 * With vtkInteractorStyleHaptic::SetMeasurements, a user fills the list by keys;
 * vtkHapticMeasurementRepresentation shows it. Points placed by hand are positions of the proxy,
 * which a surface holds, not of the tip, which is inside. At a sharp edge, as in CT, the solver
 * PRECISE holds the proxy halfway up the edge, within a tenth of a voxel; at a gradual transition,
 * it holds the proxy up to a kernel radius in front of what is felt. PAPER holds the proxy some
 * voxels in front of an edge, and SURFACE_PROXY holds it at its radius (SetProxyRadius) in front of
 * the isosurface. The distance between opposite sides of a body is too long by twice this gap.
 *
 * Each point may include what was felt there: the time (s), the force on the hand (N, world axes)
 * and the value at the surface.
 *
 * The extension of a file selects its format. ReadFile reads all formats (a .mrk.json omits
 * quantities that are not known at every point):
 *
 * - .csv: one line per point; the first line names the columns. Only x, y and z are required;
 * - .vtp: see CopyToPolyData;
 * - .mrk.json: markups of 3D Slicer, by its published schema 1.0.3: Fiducial, Line, Angle and
 *   Curve, and an area as a ClosedCurve along its border, with its triangles in a member
 *   volumeHaptics. What was felt is in the measurements of a markup, as controlPointValues. A
 *   ClosedCurve of another program becomes a path; planes and regions of interest are left out,
 *   with a warning.
 *
 * Every change invokes vtkCommand::ModifiedEvent, and can be undone.
 *
 * @sa vtkHapticMeasurementRepresentation, vtkInteractorStyleHaptic
 */
#ifndef vtkHapticMeasurements_h
#define vtkHapticMeasurements_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkImageData;
class vtkPolyData;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticMeasurements : public vtkObject
{
public:
  static vtkHapticMeasurements* New();
  vtkTypeMacro(vtkHapticMeasurements, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum KindType
  {
    POINT = 0,
    DISTANCE = 1,
    ANGLE = 2,
    PATH = 3,
    AREA = 4
  };
  enum CoordinateSystemType
  {
    LPS = 0,
    RAS = 1
  };

  ///@{
  /**
   * Append a measurement. Without a name, it gets the next free name, such as "Distance 2". Returns
   * its index. If the points do not make a valid measurement, returns -1 and reports an error.
   *
   * AddMeasurement reads the points of a shape in their order, or for AREA its polygons, and the
   * point arrays Time, Force (three components) and SurfaceValue, if the shape has them. A trace of
   * vtkVolumeHapticsFilter can be added as a PATH.
   */
  vtkIdType AddPoint(const double x[3], const char* name = nullptr) VTK_SIZEHINT(x, 3);
  vtkIdType AddDistance(const double a[3], const double b[3], const char* name = nullptr)
    VTK_SIZEHINT(a, 3) VTK_SIZEHINT(b, 3);
  vtkIdType AddAngle(const double a[3], const double corner[3], const double b[3],
    const char* name = nullptr) VTK_SIZEHINT(a, 3) VTK_SIZEHINT(corner, 3) VTK_SIZEHINT(b, 3);
  vtkIdType AddMeasurement(int kind, vtkPolyData* shape, const char* name = nullptr);
  ///@}

  /**
   * Append the area that a brush paints on the isosurface of the active point scalars of a 3D
   * image. A point of the isosurface is painted if its straight-line distance (not the distance
   * along the surface) to the brush's line is below the radius (world units, above 0). The brush's
   * line joins the points of the surface that are nearest to the positions of the path; positions
   * farther away than the radius plus three voxels are skipped. Parts that no painted surface
   * connects with that line, such as the far side of a thin wall, are left out. A single position
   * on a plane or sphere paints pi r^2. Returns -1 and reports an error if an argument is unusable
   * or nothing is painted.
   */
  vtkIdType AddPaintedArea(vtkImageData* image, double isoValue, vtkPolyData* path, double radius,
    const char* name = nullptr);

  ///@{
  /**
   * Read and edit the list. For an index out of range, reports an error and returns 0, false or an
   * empty text.
   */
  vtkIdType GetNumberOfMeasurements();
  int GetKind(vtkIdType index);
  static const char* GetKindName(int kind);
  std::string GetName(vtkIdType index);
  bool SetName(vtkIdType index, const char* name);
  bool Remove(vtkIdType index);
  void RemoveAll();
  ///@}

  ///@{
  /**
   * Get the value (NaN for a point where nothing was felt), its unit in UCUM ("mm", "mm2", "deg" or
   * empty), or a text with name and value for users, such as "Distance 1: 42.5 mm".
   */
  double GetValue(vtkIdType index);
  std::string GetUnit(vtkIdType index);
  std::string GetText(vtkIdType index);
  ///@}

  ///@{
  /** Get the points of a measurement (world): their number, and each point. */
  vtkIdType GetNumberOfPoints(vtkIdType index);
  void GetPoint(vtkIdType index, vtkIdType point, double x[3]) VTK_SIZEHINT(x, 3);
  ///@}

  /**
   * Get the shape of a measurement, with the arrays Time, Force and SurfaceValue if something was
   * felt: a vertex, a line or triangles.
   */
  void GetShape(vtkIdType index, vtkPolyData* shape);

  ///@{
  /**
   * Undo the last change of the list, or redo the last undone one. Return false if there is nothing
   * to undo or redo. The last 100 changes are kept.
   */
  bool Undo();
  bool Redo();
  ///@}

  ///@{
  /**
   * Set the points, path or area of the measurement in progress, for displays. It is neither in the
   * list nor in files, and Undo ignores it; nullptr ends it. The text shows the value so far and
   * what is missing, such as "Distance: 1 of 2 points".
   */
  void SetUnfinished(int kind, vtkPolyData* shape);
  void GetUnfinished(vtkPolyData* shape);
  int GetUnfinishedKind();
  std::string GetUnfinishedText();
  ///@}

  ///@{
  /**
   * Copy all measurements to polydata: vertices, lines and triangles with the cell array
   * Measurement (the index); the point arrays Time, Force and SurfaceValue, NaN for unknown values;
   * and the field arrays MeasurementName, MeasurementKind, MeasurementValue and MeasurementUnit.
   * ReadPolyData replaces the list with the measurements of such polydata. For any other polydata,
   * it returns false, reports an error and changes nothing.
   */
  void CopyToPolyData(vtkPolyData* data);
  bool ReadPolyData(vtkPolyData* data);
  ///@}

  ///@{
  /**
   * Write the list to a file, or replace it with the list from a file. An existing file is replaced
   * only after the whole new file is on the disk. On failure, these return false, report an error
   * and change nothing.
   */
  bool WriteFile(VTK_FILEPATH const char* path);
  bool ReadFile(VTK_FILEPATH const char* path);
  ///@}

  ///@{
  /**
   * The directions of the world's axes, for files of 3D Slicer. LPS (default): to a patient's left,
   * posterior and superior. RAS: to the right, anterior and superior.
   */
  vtkSetClampMacro(CoordinateSystem, int, LPS, RAS);
  vtkGetMacro(CoordinateSystem, int);
  void SetCoordinateSystemToLPS() { this->SetCoordinateSystem(LPS); }
  void SetCoordinateSystemToRAS() { this->SetCoordinateSystem(RAS); }
  ///@}

  ///@{
  /** Metres per world unit, 1e-12 to 1e12. Default 0.001. */
  vtkSetClampMacro(MetersPerWorldUnit, double, 1e-12, 1e12);
  vtkGetMacro(MetersPerWorldUnit, double);
  ///@}

  ///@{
  /**
   * The distance between the samples of a path that is measured in a scene (world units, 0 or
   * more). Default 0: each tick is a sample.
   */
  vtkSetClampMacro(PathSpacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PathSpacing, double);
  ///@}

  ///@{
  /**
   * The radius of the brush that paints areas in a scene (world units, 0 or more). Default 0: four
   * times the smallest spacing of the image.
   */
  vtkSetClampMacro(BrushRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(BrushRadius, double);
  ///@}

protected:
  vtkHapticMeasurements();
  ~vtkHapticMeasurements() override;

  int CoordinateSystem = LPS;
  double MetersPerWorldUnit = 0.001;
  double PathSpacing = 0.0;
  double BrushRadius = 0.0;

private:
  vtkHapticMeasurements(const vtkHapticMeasurements&) = delete;
  void operator=(const vtkHapticMeasurements&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
