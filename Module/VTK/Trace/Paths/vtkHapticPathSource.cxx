// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticPathSource.h"

#include "Core/Math/Vector3.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Trace/HapticTraceFiles.h"
#include "VTK/Trace/Paths/HapticPathSettings.h"
#include "VTK/Trace/RecordedLabels.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * A curve along which a hand moves at constant speed: its length, and the position at each distance
 * from its start (0 to Length).
 */
struct HapticCurve
{
  double Length = 0.0;
  std::function<Vector3(double)> Place;
};

/** Two unit vectors that form a right-handed frame with the normal. */
struct Plane
{
  explicit Plane(const Vector3& normal)
  {
    const Vector3 n = (1.0 / Norm(normal)) * normal;
    // For a normal along z, make the vectors those of x and y, as users expect.
    const Vector3 aside = std::abs(n.Z) > 0.5 ? Vector3{ 1, 0, 0 } : Vector3{ 0, 0, 1 };
    const Vector3 u = aside - Dot(aside, n) * n;
    this->U = (1.0 / Norm(u)) * u;
    this->V = Cross(n, this->U);
  }

  Vector3 At(double radius, double angle) const
  {
    return radius * std::cos(angle) * this->U + radius * std::sin(angle) * this->V;
  }

  Vector3 U;
  Vector3 V;
};

/** Computes the length of the spiral r = phi from the centre to an angle. */
double SpiralLength(double angle)
{
  return 0.5 * (angle * std::sqrt(1.0 + angle * angle) + std::asinh(angle));
}

/**
 * Computes the angle at a length of the spiral with Newton's method, which never overshoots,
 * because the length is convex.
 */
double SpiralAngle(double length)
{
  double angle = std::sqrt(2.0 * length);
  for (int i = 0; i < 60; ++i)
  {
    const double step = (SpiralLength(angle) - length) / std::sqrt(1.0 + angle * angle);
    angle -= step;
    if (std::abs(step) <= 1e-15 * (1.0 + angle))
    {
      break;
    }
  }
  return std::max(angle, 0.0);
}

/** Makes a polyline through at least two corners. */
HapticCurve MakePolygonCurve(const std::vector<Vector3>& corners)
{
  std::vector<double> ways = { 0.0 };
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    ways.push_back(ways.back() + Norm(corners[i] - corners[i - 1]));
  }
  const double length = ways.back();
  return { length,
    [corners, ways](double way)
    {
      const auto end = std::lower_bound(ways.begin() + 1, ways.end() - 1, way);
      const auto i = static_cast<std::size_t>(end - ways.begin());
      const double side = ways[i] - ways[i - 1];
      const double fraction = side > 0.0 ? std::min((way - ways[i - 1]) / side, 1.0) : 1.0;
      return (1.0 - fraction) * corners[i - 1] + fraction * corners[i];
    } };
}

/**
 * Makes a circle around a centre, in the plane perpendicular to a non-zero normal, counterclockwise
 * as seen from the normal's tip.
 */
HapticCurve MakeCircleCurve(
  const Vector3& center, const Vector3& normal, double radius, double turns)
{
  return { 2.0 * vtkMath::Pi() * radius * turns,
    [center, plane = Plane(normal), radius](double way)
    { return center + plane.At(radius, way / radius); } };
}

/** Makes the spiral of Archimedes, from the centre outwards to the radius. */
HapticCurve MakeSpiralCurve(
  const Vector3& center, const Vector3& normal, double radius, double turns)
{
  const double step = radius / (2.0 * vtkMath::Pi() * turns); // outward step per radian
  return { step * SpiralLength(2.0 * vtkMath::Pi() * turns),
    [center, plane = Plane(normal), step](double way)
    {
      const double angle = SpiralAngle(way / step);
      return center + plane.At(step * angle, angle);
    } };
}

} // namespace
} // namespace VolumeHaptics

vtkStandardNewMacro(vtkHapticPathSource);

namespace
{
using VolumeHaptics::Vector3;

/**
 * Largest number of points in a path. More would come from a wrong unit, and would not fit into
 * memory.
 */
constexpr double MostPoints = 1e8;

Vector3 ToVector(const double x[3])
{
  return { x[0], x[1], x[2] };
}

/**
 * Writes one point per tip, and a polyline through them. Writes the array Time only if `times` is
 * not empty.
 */
void Write(const std::vector<Vector3>& tips, const std::vector<double>& times, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(tips.size()));
  for (const Vector3& tip : tips)
  {
    line->InsertCellPoint(points->InsertNextPoint(tip.X, tip.Y, tip.Z));
  }
  output->SetPoints(points);
  output->SetLines(line);
  if (!times.empty())
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("Time");
    for (const double time : times)
    {
      array->InsertNextValue(time);
    }
    output->GetPointData()->AddArray(array);
  }
}

/**
 * Makes a curve that comes down on a face, presses in, slides across the centre of the face, and
 * lifts out again.
 */
VolumeHaptics::HapticCurve MakePressAndSlide(
  const double corner[3], const double size[3], int direction, double depth, double clearance)
{
  const int press = direction / 2;
  const double sign = direction % 2 == 0 ? 1.0 : -1.0;
  int slide = (press + 1) % 3;
  const int other = (press + 2) % 3;
  slide = size[other] > size[slide] ? other : slide;
  const auto at = [&](double fraction, double below)
  {
    double x[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = corner[axis] + (axis == slide ? fraction : 0.5) * size[axis];
    }
    x[press] = corner[press] + (sign > 0.0 ? 0.0 : size[press]) + sign * below;
    return ToVector(x);
  };
  return VolumeHaptics::MakePolygonCurve(
    { at(0.0, -clearance), at(0.0, depth), at(1.0, depth), at(1.0, -clearance) });
}
} // namespace

//------------------------------------------------------------------------------
vtkHapticPathSource::vtkHapticPathSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHapticPathSource::~vtkHapticPathSource() = default;

//------------------------------------------------------------------------------
void vtkHapticPathSource::SetBoxBounds(
  double x0, double x1, double y0, double y1, double z0, double z1)
{
  this->SetBoxCorner(x0, y0, z0);
  this->SetBoxSize(x1 - x0, y1 - y0, z1 - z0);
}

//------------------------------------------------------------------------------
void vtkHapticPathSource::SetBoxBounds(const double bounds[6])
{
  if (!bounds)
  {
    vtkErrorMacro(
      "SetBoxBounds() needs six numbers, but got a null pointer; the box stays as it was.");
    return;
  }
  this->SetBoxBounds(bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5]);
}

//------------------------------------------------------------------------------
std::string vtkHapticPathSource::CheckSettings() const
{
  const std::string shape = VolumeHaptics::PathSettingRows::ShapeNames[this->Shape].Name;
  const bool isRound = this->Shape == CIRCLE || this->Shape == SPIRAL;
  const bool isBox = this->Shape == PRESS_AND_SLIDE;
  const std::pair<const char*, const double*> places[] = { { "Point1", this->Point1 },
    { "Point2", this->Point2 }, { "Center", this->Center }, { "Normal", this->Normal },
    { "BoxCorner", this->BoxCorner }, { "BoxSize", this->BoxSize } };
  for (const auto& [name, place] : places)
  {
    if (!IsFinite(ToVector(place)))
    {
      return std::string("The setting ") + name +
        " of the haptic path is not finite. Set it to three numbers.";
    }
  }
  const auto is = [&](const char* name, const char* what)
  { return "The setting " + std::string(name) + " of the haptic path has to be " + what + "."; };
  if (!(this->Speed > 0.0) || !std::isfinite(this->Speed))
  {
    return is("Speed", "more than 0 world units per second");
  }
  if (isRound && (!(this->Radius > 0.0) || !std::isfinite(this->Radius)))
  {
    return is("Radius", "more than 0 world units");
  }
  if (isRound && !(this->Turns > 0.0 && this->Turns <= 1e4))
  {
    return is("Turns", "more than 0 and at most 10000");
  }
  if (isRound && !(Norm(ToVector(this->Normal)) > 0.0))
  {
    return is("Normal", "a direction, not (0, 0, 0)");
  }
  if (isBox && !(this->BoxSize[0] >= 0.0 && this->BoxSize[1] >= 0.0 && this->BoxSize[2] >= 0.0))
  {
    return is("BoxSize", "0 or more along each axis: give the smaller bound first");
  }
  if (isBox && !(this->Depth >= 0.0 && std::isfinite(this->Depth)))
  {
    return is("Depth", "0 or more world units");
  }
  if (isBox && !(this->Clearance >= 0.0 && std::isfinite(this->Clearance)))
  {
    return is("Clearance", "0 or more world units");
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkHapticPathSource::GiveOutFile(vtkPolyData* output) const
{
  std::string error;
  VolumeHaptics::RecordedTips tips;
  if (!VolumeHaptics::ReadPathFile(this->FileName, tips, error))
  {
    return error;
  }
  if (VolumeHaptics::GetTraceEnding(this->FileName) == ".vtp")
  {
    // Keep all arrays of the file, because an exact replay needs them.
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->FileName.c_str());
    reader->Update();
    output->ShallowCopy(reader->GetOutput());
    return {};
  }
  std::string settings;
  if (!VolumeHaptics::ReadSettingsBeside(this->FileName, settings, error))
  {
    return error;
  }
  Write(tips.Tips, tips.Times, output);
  if (!settings.empty())
  {
    VolumeHaptics::SetRecordedSettings(output, settings);
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkHapticPathSource::GiveOutShape(vtkPolyData* output) const
{
  using namespace VolumeHaptics;

  std::string error = this->CheckSettings();
  if (!error.empty())
  {
    return error;
  }
  const Vector3 center = ToVector(this->Center);
  const Vector3 normal = ToVector(this->Normal);
  const HapticCurve curve = this->Shape == LINE
    ? MakePolygonCurve({ ToVector(this->Point1), ToVector(this->Point2) })
    : this->Shape == CIRCLE ? MakeCircleCurve(center, normal, this->Radius, this->Turns)
    : this->Shape == SPIRAL ? MakeSpiralCurve(center, normal, this->Radius, this->Turns)
                            : MakePressAndSlide(this->BoxCorner, this->BoxSize,
                                this->PressDirection, this->Depth, this->Clearance);
  if (!(curve.Length > 0.0))
  {
    return this->Shape == LINE
      ? "The haptic path has no length: Point1 and Point2 are the same. Move one of them."
      : "The haptic path has no length. Set Depth, Clearance or BoxSize to more than 0.";
  }
  // Do not count a last step that results only from rounding.
  const double steps = std::ceil(curve.Length / this->Speed * this->PointsPerSecond - 1e-6);
  if (!(steps < MostPoints))
  {
    return "The haptic path would have more than 1e8 points. Raise Speed (world units per second) "
           "or lower PointsPerSecond.";
  }
  const int last = std::max(1, static_cast<int>(steps));
  std::vector<Vector3> tips;
  std::vector<double> times;
  for (int i = 0; i <= last; ++i)
  {
    tips.push_back(curve.Place(curve.Length * (static_cast<double>(i) / last)));
    times.push_back(i / this->PointsPerSecond);
  }
  Write(tips, times, output);
  return {};
}

//------------------------------------------------------------------------------
int vtkHapticPathSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputs);
  std::string error;
  try
  {
    error = this->Shape == FROM_FILE ? this->GiveOutFile(output) : this->GiveOutShape(output);
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    error = "There is not enough memory for the haptic path. " +
      (this->Shape == FROM_FILE
          ? "Use a shorter one than that in " + this->FileName + "."
          : std::string("Raise Speed or lower PointsPerSecond: a point takes 72 bytes."));
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< VolumeHaptics::Printable(error));
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticPathSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::PathSettings);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::PathVectors);
  os << indent << "FileName: " << (this->FileName.empty() ? "(none)" : this->FileName) << "\n";
}
