// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Path/TipPathPlanner.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using Explore::SurfaceMap;

// The hand's movements, in metres, seconds and degrees.
constexpr double HOVER = 0.015;        // height above the surface at the beginning and the end
constexpr double OUTER_PRESS = 0.0025; // depth below the outer surface
constexpr double DEEP_PRESS = 0.0015;  // depth below the deep surface
constexpr double TOP_SPEED = 0.1;
constexpr double SHORTEST = 0.6; // shortest duration of a movement
constexpr double REST = 0.15;    // pause between movements
constexpr double HALF_ARC = 28.0;
constexpr double ARC_DISTANCE = -20.0; // angle from the deep stroke up to the outer stroke
// desired height of the outer stroke above the centre of the picture
constexpr double WANTED_UP = 20.0;

/// Position of the strokes, given by the angles of the centre of the outer stroke.
struct Stroke
{
  double Right = 0.0;
  double Up = WANTED_UP;
};

/// Returns a cost that grows with roughness, with uncertainty, and with the distance from the
/// desired position.
double Badness(const SurfaceMap& map, const Stroke& stroke)
{
  double badness = 0.0;
  const double step = 4.0;
  for (double a = -HALF_ARC; a <= HALF_ARC; a += step)
  {
    for (const bool deep : { false, true })
    {
      const double up = deep ? stroke.Up - ARC_DISTANCE : stroke.Up;
      const auto distance = [&](double right)
      { return deep ? map.Deep(stroke.Right + right, up) : map.Outer(stroke.Right + right, up); };
      const double bend = distance(a - step) - 2.0 * distance(a) + distance(a + step);
      badness += std::abs(bend) / std::max(distance(a), 1e-9) * 40.0;
      badness += 2.0 * (1.0 - map.Quality(stroke.Right + a, up));
    }
  }
  const double aside = stroke.Right / 10.0, above = (stroke.Up - WANTED_UP) / 10.0;
  return badness + aside * aside + above * above;
}

Stroke ChooseStroke(const SurfaceMap& map)
{
  Stroke best;
  double least = Badness(map, best);
  for (double up = -24.0; up <= 36.0; up += 4.0)
  {
    for (double right = -24.0; right <= 24.0; right += 4.0)
    {
      const Stroke stroke{ right, up };
      const double badness = Badness(map, stroke);
      if (badness < least)
      {
        least = badness;
        best = stroke;
      }
    }
  }
  return best;
}

/// Rises smoothly from 0 to 1, without a jerk at either end.
double Ease(double t)
{
  return t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

double Mix(double from, double to, double t)
{
  return from + (to - from) * t;
}

using Curve = std::function<vtkVector3d(double)>;

/// A curve parametrised by its length, so that the timing alone sets the hand's speed.
class Walk
{
public:
  explicit Walk(const Curve& curve)
    : Points(curve)
    , Lengths{ 0.0 }
  {
    for (int i = 1; i <= PIECES; ++i)
    {
      const double step = (this->At(i) - this->At(i - 1)).Norm();
      this->Lengths.push_back(this->Lengths.back() + step);
    }
  }

  double Length() const { return this->Lengths.back(); }

  /// Returns the position at a fraction (0 to 1) of the length.
  vtkVector3d Place(double fraction) const
  {
    const double length = fraction * this->Length();
    const auto end = std::lower_bound(this->Lengths.begin() + 1, this->Lengths.end() - 1, length);
    const double before = *(end - 1), piece = *end - before;
    const double index = static_cast<double>(end - 1 - this->Lengths.begin());
    return this->At(index + (piece > 0.0 ? (length - before) / piece : 0.0));
  }

private:
  static constexpr int PIECES = 1000;

  vtkVector3d At(double index) const { return this->Points(index / PIECES); }

  Curve Points;
  std::vector<double> Lengths;
};

/// Collects the ticks of consecutive movements.
class Recorder
{
public:
  Recorder(double metersPerWorldUnit, double ticksPerSecond)
    : MetersPerWorldUnit(metersPerWorldUnit)
    , TicksPerSecond(ticksPerSecond)
  {
    // with float, rounding would make the positions jerk by micrometres
    this->Points->SetDataTypeToDouble();
  }

  void Move(const std::string& name, const Curve& curve)
  {
    // The largest speed of an eased movement is 15/8 of the mean speed.
    const Walk walk(curve);
    const double length = walk.Length() * this->MetersPerWorldUnit;
    const double duration = std::max(SHORTEST, 1.875 * length / TOP_SPEED);
    const auto ticks = static_cast<vtkIdType>(std::ceil(duration * this->TicksPerSecond));
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < ticks; ++i)
    {
      this->Add(walk.Place(Ease(static_cast<double>(i) / ticks)));
    }
    const auto rest = static_cast<vtkIdType>(REST * this->TicksPerSecond);
    for (vtkIdType i = 0; i < rest; ++i)
    {
      this->Add(walk.Place(1.0));
    }
    this->Result.Phases.push_back({ name, first, this->Points->GetNumberOfPoints() });
  }

  Explore::TipPath Finish()
  {
    const vtkIdType count = this->Points->GetNumberOfPoints();
    vtkNew<vtkCellArray> line;
    line->InsertNextCell(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      line->InsertCellPoint(i);
    }
    this->Result.Path = vtkSmartPointer<vtkPolyData>::New();
    this->Result.Path->SetPoints(this->Points);
    this->Result.Path->SetLines(line);
    return this->Result;
  }

private:
  void Add(const vtkVector3d& point) { this->Points->InsertNextPoint(point.GetData()); }

  double MetersPerWorldUnit;
  double TicksPerSecond;
  vtkNew<vtkPoints> Points;
  Explore::TipPath Result;
};
} // namespace

namespace Explore
{
TipPath PlanTipPath(
  const SurfaceMap& map, const ViewFrame& view, double metersPerWorldUnit, double ticksPerSecond)
{
  const Stroke stroke = ChooseStroke(map);
  const double from = stroke.Right - HALF_ARC, to = stroke.Right + HALF_ARC;
  const double outerUp = stroke.Up, deepUp = stroke.Up - ARC_DISTANCE;
  const double hover = HOVER / metersPerWorldUnit;
  const double outerPress = OUTER_PRESS / metersPerWorldUnit;
  const double deepPress = DEEP_PRESS / metersPerWorldUnit;
  const auto place = [&](double right, double up, double distance)
  { return view.Centre + distance * view.Direction(right, up); };
  const auto outer = [&](double right, double up, double below)
  { return place(right, up, map.Outer(right, up) - below); };

  Recorder recorder(metersPerWorldUnit, ticksPerSecond);
  recorder.Move("approach", [&](double t) { return outer(from, outerUp, Mix(-hover, 0.0, t)); });
  recorder.Move("press", [&](double t) { return outer(from, outerUp, Mix(0.0, outerPress, t)); });
  recorder.Move(
    "slide outside", [&](double t) { return outer(Mix(from, to, t), outerUp, outerPress); });
  const double through = map.Outer(to, outerUp) - map.Deep(to, outerUp) + deepPress;
  recorder.Move(
    "press through", [&](double t) { return outer(to, outerUp, Mix(outerPress, through, t)); });
  recorder.Move("slide inside",
    [&](double t)
    {
      const double right = Mix(to, from, t);
      // During its first half, the return stroke turns away from the first stroke.
      const double up = Mix(outerUp, deepUp, Ease(std::min(1.0, 2.0 * t)));
      return place(right, up, map.Deep(right, up) - deepPress);
    });
  const double back = map.Outer(from, deepUp) - map.Deep(from, deepUp) + deepPress;
  recorder.Move("retract", [&](double t) { return outer(from, deepUp, Mix(back, -hover, t)); });
  return recorder.Finish();
}
} // namespace Explore
