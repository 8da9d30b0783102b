// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TipReader.h"

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
  const vtkIdType before = this->Before;
  const Vector3 a = this->PointAt(before);
  if (before == last || std::abs(time - this->TimeAt(before)) <= snap)
  {
    return a;
  }
  const double share =
    (time - this->TimeAt(before)) / (this->TimeAt(before + 1) - this->TimeAt(before));
  return a + share * (this->PointAt(before + 1) - a);
}

} // namespace VolumeHaptics
