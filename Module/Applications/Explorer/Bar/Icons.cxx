// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Bar/Icons.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// Icons are drawn on a grid of 24 x 24 units, with y downwards.
constexpr double GRID = 24.0;
constexpr double HALF_STROKE = 0.95;

/// Returns the shapes of an icon as text: L is a line through points, P a filled polygon, O a
/// circle and D a disc, each of the latter with its centre and radius.
const char* FindShapes(Explore::Icon icon)
{
  switch (icon)
  {
    case Explore::Icon::Menu:
      return "L 4 6.5 20 6.5 L 4 12 20 12 L 4 17.5 20 17.5";
    case Explore::Icon::Open:
      return "L 3 19 3 5.5 9 5.5 11 8 19 8 19 11 L 3 19 6.5 11 22 11 18.5 19 3 19";
    case Explore::Icon::Touch: // a stylus on a round surface
      return "L 2 21 5 18.8 8.5 17.5 12 17 15.5 17.5 19 18.8 22 21 P 11.5 16.5 13 11.5 19.5 2.5 22 "
             "4.3 15.5 13.3";
    case Explore::Icon::Hold: // a pin
      return "L 8 3.5 16 3.5 P 9.3 3.5 14.7 3.5 15 10 18 14 6 14 9 10 L 12 14 12 21.5";
    case Explore::Icon::Method: // a spring between two walls
      return "L 3 6 3 18 L 3 12 6 12 8 7 11 17 14 7 16.5 17 18.5 12 21 12 L 21 6 21 18";
    case Explore::Icon::Preset: // sliders
      return "L 3 6.5 21 6.5 D 9 6.5 2.8 L 3 12 21 12 D 15.5 12 2.8 L 3 17.5 21 17.5 D 7 17.5 2.8";
    case Explore::Icon::Tool: // a syringe
      return "L 2.5 21.5 8 16 P 6.5 13.5 10.5 17.5 18 10 14 6 L 12.5 4.5 19.5 11.5 L 16 8 20 4 L "
             "17.7 1.7 22.3 6.3";
    case Explore::Icon::Cut: // scissors
      return "O 5.5 6 2.7 O 5.5 18 2.7 L 7.7 7.7 21 18 L 7.7 16.3 21 6";
    case Explore::Icon::Slices: // three sheets
      return "L 3 8 12 3.5 21 8 12 12.5 3 8 L 3 12.3 12 16.8 21 12.3 L 3 16.5 12 21 21 16.5";
    case Explore::Icon::Measure: // a ruler
      return "L 2.5 16.5 16.5 2.5 21.5 7.5 7.5 21.5 2.5 16.5 L 6.3 12.7 8.5 14.9 L 9.6 9.4 12.8 "
             "12.6 L 12.9 6.1 15.1 8.3";
    case Explore::Icon::Record:
      return "O 12 12 9 D 12 12 5";
    case Explore::Icon::Play:
      return "P 6.5 3.5 20.5 12 6.5 20.5";
    case Explore::Icon::Look: // an eye
      return "L 1.8 12 4.5 8.6 8 6.5 12 5.8 16 6.5 19.5 8.6 22.2 12 19.5 15.4 16 17.5 12 18.2 8 "
             "17.5 4.5 15.4 1.8 12 D 12 12 3.3";
    default:
      return "";
  }
}

struct Point
{
  double X, Y;
};

struct Shape
{
  char Kind;
  std::vector<Point> Points; // for O and D only the centre
  double Radius = 0.0;
};

std::vector<Shape> ReadShapes(const std::string& text)
{
  std::vector<Shape> shapes;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    if (std::isalpha(static_cast<unsigned char>(word[0])) != 0)
    {
      shapes.push_back({ word[0], {} });
      continue;
    }
    Shape& shape = shapes.back();
    const double x = std::stod(word);
    if (shape.Kind != 'L' && shape.Kind != 'P' && !shape.Points.empty())
    {
      shape.Radius = x;
      continue;
    }
    double y = 0.0;
    words >> y;
    shape.Points.push_back({ x, y });
  }
  return shapes;
}

double DistanceToSegment(const Point& p, const Point& a, const Point& b)
{
  const double dx = b.X - a.X, dy = b.Y - a.Y;
  const double length2 = dx * dx + dy * dy;
  const double along = length2 > 0.0 ? ((p.X - a.X) * dx + (p.Y - a.Y) * dy) / length2 : 0.0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.X - a.X - t * dx, p.Y - a.Y - t * dy);
}

/// Returns the distance to the edge of a shape, negative inside.
double Distance(const Point& p, const Shape& shape)
{
  const std::vector<Point>& points = shape.Points;
  if (shape.Kind == 'O' || shape.Kind == 'D')
  {
    const double radial = std::hypot(p.X - points[0].X, p.Y - points[0].Y) - shape.Radius;
    return shape.Kind == 'D' ? radial : std::abs(radial) - HALF_STROKE;
  }
  double least = std::numeric_limits<double>::max();
  bool isInside = false;
  const bool isPolygon = shape.Kind == 'P';
  for (std::size_t i = isPolygon ? 0 : 1; i < points.size(); ++i)
  {
    const Point& a = points[i == 0 ? points.size() - 1 : i - 1];
    const Point& b = points[i];
    least = std::min(least, DistanceToSegment(p, a, b));
    if ((a.Y > p.Y) != (b.Y > p.Y) && p.X < a.X + (p.Y - a.Y) / (b.Y - a.Y) * (b.X - a.X))
    {
      isInside = !isInside;
    }
  }
  return !isPolygon ? least - HALF_STROKE : isInside ? -least : least;
}
} // namespace

namespace Explore
{
void DrawIcon(vtkImageData* image, Icon icon, int x, int y, int size, const RGB& colour)
{
  const std::vector<Shape> shapes = ReadShapes(FindShapes(icon));
  const int* const extent = image->GetDimensions();
  const double unit = GRID / size; // grid units per pixel
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      if (x + column < 0 || x + column >= extent[0] || y + row < 0 || y + row >= extent[1])
      {
        continue;
      }
      const Point p{ (column + 0.5) * unit, GRID - (row + 0.5) * unit };
      double least = GRID;
      for (const Shape& shape : shapes)
      {
        least = std::min(least, Distance(p, shape));
      }
      const double cover = std::clamp(0.5 - least / unit, 0.0, 1.0);
      auto* const pixel =
        static_cast<unsigned char*>(image->GetScalarPointer(x + column, y + row, 0));
      for (std::size_t c = 0; c < 3 && cover > 0.0; ++c)
      {
        const double mixed = (1.0 - cover) * pixel[c] + cover * 255.0 * colour[c];
        pixel[c] = static_cast<unsigned char>(std::lround(mixed));
      }
    }
  }
}
} // namespace Explore
