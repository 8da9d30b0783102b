// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/View/ViewFrame.h"

#include "VTK/Reading/InputError.h"

#include "vtkMath.h"

#include <cmath>

namespace
{
constexpr double AZIMUTH = 38.0;   // degrees, angle from the front to the left side
constexpr double ELEVATION = 20.0; // degrees above the horizon

vtkVector3d ParseAxis(const std::string& option, const std::string& text)
{
  vtkVector3d axis(0.0, 0.0, 0.0);
  const bool sign = text.size() == 2 && (text[0] == '+' || text[0] == '-');
  const char letter = sign ? text[1] : 0;
  if (letter < 'x' || letter > 'z')
  {
    throw Explore::InputError(
      option + " '" + text + "'", "is not an axis", "use one of +x -x +y -y +z -z");
  }
  axis[letter - 'x'] = text[0] == '+' ? 1.0 : -1.0;
  return axis;
}
} // namespace

namespace Explore
{
vtkVector3d ViewFrame::Direction(double right, double up) const
{
  const double a = vtkMath::RadiansFromDegrees(right), b = vtkMath::RadiansFromDegrees(up);
  return std::cos(b) * (std::cos(a) * this->Toward + std::sin(a) * this->Right) +
    std::sin(b) * this->Up;
}

ViewFrame MakeViewFrame(const double centre[3], const std::string& front, const std::string& up)
{
  const vtkVector3d forward = ParseAxis("--front", front);
  const vtkVector3d top = ParseAxis("--up", up);
  const vtkVector3d side = top.Cross(forward);
  if (side.Norm() < 0.5)
  {
    throw InputError("--front " + front + " --up " + up, "are the same axis",
      "the front and the top must be at right angles");
  }
  // The camera looks at the front from AZIMUTH to the side and ELEVATION above. `side` points to
  // the right of the picture.
  const double a = vtkMath::RadiansFromDegrees(AZIMUTH);
  const double e = vtkMath::RadiansFromDegrees(ELEVATION);
  ViewFrame frame;
  frame.Centre = vtkVector3d(centre[0], centre[1], centre[2]);
  frame.Toward = std::cos(e) * (std::cos(a) * forward + std::sin(a) * side) + std::sin(e) * top;
  frame.Right = top.Cross(frame.Toward).Normalized();
  frame.Up = frame.Toward.Cross(frame.Right);
  return frame;
}
} // namespace Explore
