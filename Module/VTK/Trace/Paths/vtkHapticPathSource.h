// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticPathSource
 * @brief   makes the path of a stylus's tip for vtkVolumeHapticsFilter
 *
 * Makes the path of a stylus's tip: a line, a circle, a spiral, a press followed by a slide and a
 * lift, or the contents of a file:
 *
 *   path->SetShapeToCircle();
 *   path->SetRadius(10.0); // world units
 *   filter->SetPathConnection(path->GetOutputPort());
 *
 * The output is one polyline with one point per tick, at equal distances of at most Speed /
 * PointsPerSecond. The point array Time (s) advances by 1 / PointsPerSecond from point to point. If
 * the filter's ServoRate differs, it resamples the path, so that the hand's speed stays the same.
 *
 * If settings make no path (a line of no length, a radius of 0, numbers that are not finite, an
 * unusable file), the output is empty, and an error names the settings and the cure.
 *
 * @sa vtkVolumeHapticsFilter
 */
#ifndef vtkHapticPathSource_h
#define vtkHapticPathSource_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <string> // for std::string

class VTKVOLUMEHAPTICS_EXPORT vtkHapticPathSource : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticPathSource* New();
  vtkTypeMacro(vtkHapticPathSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShapeType
  {
    LINE = 0,
    CIRCLE = 1,
    SPIRAL = 2,
    PRESS_AND_SLIDE = 3,
    FROM_FILE = 4
  };

  ///@{
  /**
   * LINE (default): from Point1 to Point2. CIRCLE: around Center, perpendicular to Normal. SPIRAL:
   * in the same plane, from Center out to Radius. PRESS_AND_SLIDE: comes down on a face of the box,
   * presses in, slides across and lifts. FROM_FILE: a .vtp or .csv, such as a recording of a haptic
   * device. CIRCLE makes Turns turns at the distance Radius from Center, counterclockwise as seen
   * from where Normal points to. SPIRAL moves outwards by the same distance in each of its Turns.
   * See also PressDirection and FileName.
   */
  vtkSetClampMacro(Shape, int, LINE, FROM_FILE);
  vtkGetMacro(Shape, int);
  void SetShapeToLine() { this->SetShape(LINE); }
  void SetShapeToCircle() { this->SetShape(CIRCLE); }
  void SetShapeToSpiral() { this->SetShape(SPIRAL); }
  void SetShapeToPressAndSlide() { this->SetShape(PRESS_AND_SLIDE); }
  void SetShapeToFromFile() { this->SetShape(FROM_FILE); }
  ///@}

  ///@{
  /**
   * Speed of the hand (world units per second), more than 0. Default 100: 0.1 m/s if a unit is a
   * millimetre.
   */
  vtkSetMacro(Speed, double);
  vtkGetMacro(Speed, double);
  ///@}

  ///@{
  /**
   * Points for each second, 1 to 100000. Default 1000: one for each tick of a servo of 1 kHz.
   */
  vtkSetClampMacro(PointsPerSecond, double, 1.0, 1e5);
  vtkGetMacro(PointsPerSecond, double);
  ///@}

  ///@{
  /** The start of the LINE. Default (-50, 0, 0). All positions are in world units. */
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  ///@}

  ///@{
  /** The end of the LINE. Default (50, 0, 0). */
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  ///@}

  ///@{
  /** The centre of the CIRCLE or the SPIRAL. Default (0, 0, 0). */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * The normal of the plane of the CIRCLE or the SPIRAL, of any length but 0. Default (0, 0, 1).
   */
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * The radius of the CIRCLE, or the largest radius of the SPIRAL (world units), more than 0.
   * Default 20.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * The number of turns of the CIRCLE or the SPIRAL, more than 0 and up to 10000; it may be a
   * fraction. Default 3.
   */
  vtkSetMacro(Turns, double);
  vtkGetMacro(Turns, double);
  ///@}

  ///@{
  /**
   * The corner of the box with the least coordinates. Default (-25, -25, -25). PRESS_AND_SLIDE
   * presses into this box.
   */
  vtkSetVector3Macro(BoxCorner, double);
  vtkGetVector3Macro(BoxCorner, double);
  ///@}

  ///@{
  /** The size of the box along x, y and z, 0 or more. Default (50, 50, 50). */
  vtkSetVector3Macro(BoxSize, double);
  vtkGetVector3Macro(BoxSize, double);
  ///@}

  ///@{
  /** Set BoxCorner and BoxSize from the bounds (x0, x1, y0, y1, z0, z1). */
  void SetBoxBounds(double x0, double x1, double y0, double y1, double z0, double z1);
  void SetBoxBounds(const double bounds[6]);
  ///@}

  enum PressDirectionType
  {
    PLUS_X = 0,
    MINUS_X = 1,
    PLUS_Y = 2,
    MINUS_Y = 3,
    PLUS_Z = 4,
    MINUS_Z = 5
  };

  ///@{
  /**
   * The direction of the press. With -Z (default) the hand comes down on the face of the box with
   * the largest z, and slides along the longer side of that face. MINUS_Z begins Clearance above
   * that face, presses Depth into the box, slides from one end to the other through the middle of
   * the shorter side, and lifts to the height at which it began.
   */
  vtkSetClampMacro(PressDirection, int, PLUS_X, MINUS_Z);
  vtkGetMacro(PressDirection, int);
  ///@}

  ///@{
  /** The depth of the press into the box, 0 or more world units. Default 3. */
  vtkSetMacro(Depth, double);
  vtkGetMacro(Depth, double);
  ///@}

  ///@{
  /**
   * The height above the box at which the hand begins and ends, 0 or more world units. Default 10.
   */
  vtkSetMacro(Clearance, double);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * The file for FROM_FILE. A .vtp is passed on unchanged, so that a recording of vtkHapticDevice
   * is replayed to the bit. A .csv has a line for each point, with the columns "Tip x", "Tip y" and
   * "Tip z", as in the project's own traces, or "Points:0" to "Points:2", as ParaView exports, or
   * "x", "y" and "z", all in world units; and optionally "Time" (s). If it is a recording that was
   * made with labels (the file .csv.json beside it says so), vtkVolumeHapticsFilter accepts it only
   * with the same label image; a .csv.json that can't be read is an error. Default: none.
   */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}

protected:
  vtkHapticPathSource();
  ~vtkHapticPathSource() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Shape = LINE;
  double Speed = 100.0;
  double PointsPerSecond = 1000.0;
  double Point1[3] = { -50.0, 0.0, 0.0 };
  double Point2[3] = { 50.0, 0.0, 0.0 };
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  double Radius = 20.0;
  double Turns = 3.0;
  double BoxCorner[3] = { -25.0, -25.0, -25.0 };
  double BoxSize[3] = { 50.0, 50.0, 50.0 };
  int PressDirection = MINUS_Z;
  double Depth = 3.0;
  double Clearance = 10.0;
  std::string FileName;

private:
  std::string CheckSettings() const;
  std::string GiveOutFile(vtkPolyData* output) const;
  std::string GiveOutShape(vtkPolyData* output) const;

  vtkHapticPathSource(const vtkHapticPathSource&) = delete;
  void operator=(const vtkHapticPathSource&) = delete;
};

#endif
