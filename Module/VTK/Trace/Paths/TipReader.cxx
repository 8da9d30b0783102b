// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/Paths/TipReader.h"

#include <cmath>

namespace VolumeHaptics
{

TipReader::TipReader(const TipPaths& paths, std::size_t path)
  : Paths(paths)
  , Members(paths, path)
{
  if (paths.HaveTimes() && this->Members.GetSize() > 0)
  {
    this->Start = this->TimeAt(0);
  }
}

Vector3 TipReader::FindPoint()
{
  const vtkIdType last = this->Members.GetSize() - 1;
  const double snap = TipPaths::SnapShare * this->Paths.GetPeriod();
  const double time = this->GetTime();
  while (this->Before < last && this->TimeAt(this->Before + 1) <= time + snap)
  {
    ++this->Before;
  }
  const Vector3 a = this->PointAt(this->Before);
  const double share = this->FindShare();
  return share == 0.0 ? a : a + share * (this->PointAt(this->Before + 1) - a);
}

double TipReader::FindShare() const
{
  const vtkIdType before = this->Before;
  const double since = this->GetTime() - this->TimeAt(before);
  const double snap = TipPaths::SnapShare * this->Paths.GetPeriod();
  return before == this->Members.GetSize() - 1 || std::abs(since) <= snap
    ? 0.0
    : since / (this->TimeAt(before + 1) - this->TimeAt(before));
}

Quaternion TipReader::FindOrientation() const
{
  const auto at = [this](vtkIdType i) -> const Quaternion&
  { return this->Paths.GetOrientation(this->Members.At(i)); };
  if (!this->Paths.HaveTimes())
  {
    return at(this->Tick);
  }
  const Quaternion& a = at(this->Before);
  const double share = this->FindShare();
  if (share == 0.0)
  {
    return a;
  }
  const Quaternion& b = at(this->Before + 1);
  if (IsIdentical(a, NoOrientation) || IsIdentical(b, NoOrientation))
  {
    return NoOrientation;
  }
  // Interpolates the shorter way round: q and -q are the same orientation.
  const double side = a.W * b.W + a.X * b.X + a.Y * b.Y + a.Z * b.Z < 0.0 ? -share : share;
  const double rest = 1.0 - share;
  const Quaternion mixed{ rest * a.W + side * b.W, rest * a.X + side * b.X, rest * a.Y + side * b.Y,
    rest * a.Z + side * b.Z };
  return (1.0 / std::sqrt(SquaredNorm(mixed))) * mixed;
}

} // namespace VolumeHaptics
