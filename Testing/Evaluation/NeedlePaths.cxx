// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NeedlePaths.h"

#include "Shapes.h"

#include "vtkImageData.h"

#include <algorithm>
#include <optional>

namespace evaluation
{
namespace
{
constexpr double TickStep = 0.1;   // mm a tick: 0.1 m/s
constexpr double SearchStep = 1.0; // mm
constexpr double Outside = 5.0;    // mm, from which the needle comes
constexpr double Longest = 150.0;  // mm
constexpr double Safety = 3.0;     // mm
constexpr double AirValue = -300.0;
constexpr double BoneValue = 200.0;
constexpr double AirGap = 15.0; // mm of air that end the body
constexpr double Same = 0.01;   // N

/** The nearest voxels of an image. */
class Voxels
{
public:
  explicit Voxels(vtkImageData* image)
    : Image(image)
  {
    image->GetDimensions(this->Size);
  }

  std::optional<double> At(const Vector3& world) const
  {
    const double x[3] = { world.X, world.Y, world.Z };
    double index[3];
    this->Image->TransformPhysicalPointToContinuousIndex(x, index);
    int at[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = static_cast<int>(std::lround(index[axis]));
      if (at[axis] < 0 || at[axis] >= this->Size[axis])
      {
        return {};
      }
    }
    return this->Image->GetScalarComponentAsDouble(at[0], at[1], at[2], 0);
  }

private:
  vtkImageData* const Image;
  int Size[3];
};

/** A scan with labels, as a needle meets it. */
struct Body
{
  Voxels Values;
  Voxels Labels;
  const NeedleLabels& Sorted;

  bool IsOf(const std::set<int>& labels, const Vector3& at) const
  {
    const auto label = this->Labels.At(at);
    return label && labels.count(static_cast<int>(*label)) > 0;
  }

  bool IsBone(const Vector3& at) const
  {
    const auto value = this->Values.At(at);
    return this->IsOf(this->Sorted.Bone, at) || (value && *value > BoneValue);
  }

  /** Whether the needle may pass here, and what is around it is no bone. */
  bool IsFree(const Vector3& at, const Vector3& side, const Vector3& up) const
  {
    if (this->IsOf(this->Sorted.Others, at) || this->IsBone(at))
    {
      return false;
    }
    const Vector3 around[] = { side, -1.0 * side, up, -1.0 * up };
    return std::none_of(std::begin(around), std::end(around),
      [&](const Vector3& way) { return this->IsBone(at + Safety * way); });
  }

  /** How far (mm) the skin is from a target along a way that is free; none without such. */
  std::optional<double> FindSkin(const Vector3& target, const Vector3& way) const
  {
    Vector3 side = Cross(way, std::abs(way.Z) < 0.9 ? Vector3{ 0, 0, 1 } : Vector3{ 1, 0, 0 });
    side = (1.0 / Norm(side)) * side;
    const Vector3 up = Cross(way, side);
    double skin = 0.0;
    for (double length = 0.0; length < Longest + AirGap; length += SearchStep)
    {
      const Vector3 at = target + length * way;
      const auto value = this->Values.At(at);
      if (!value)
      {
        return {}; // the scan ends inside the body
      }
      if (*value > AirValue)
      {
        skin = length;
        if (!this->IsFree(at, side, up))
        {
          return {};
        }
      }
      if (length - skin > AirGap)
      {
        return skin > 0.0 ? std::optional<double>(skin) : std::nullopt;
      }
    }
    return {};
  }
};

/** The centres of all voxels of some labels. */
std::vector<Vector3> FindVoxels(vtkImageData* labels, const std::set<int>& wanted)
{
  std::vector<Vector3> found;
  int n[3];
  labels->GetDimensions(n);
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        if (wanted.count(static_cast<int>(labels->GetScalarComponentAsDouble(i, j, k, 0))) > 0)
        {
          double x[3];
          labels->TransformIndexToPhysicalPoint(i, j, k, x);
          found.push_back({ x[0], x[1], x[2] });
        }
      }
    }
  }
  return found;
}

bool Holds(const std::string& name, std::initializer_list<const char*> words)
{
  return std::any_of(words.begin(), words.end(),
    [&](const char* word) { return name.find(word) != std::string::npos; });
}
} // namespace

NeedleLabels SortLabels(const LabelNames& names)
{
  NeedleLabels sorted;
  for (const auto& [label, name] : names)
  {
    if (name == "liver")
    {
      sorted.Liver.insert(label);
    }
    else if (Holds(name,
               { "rib_", "vertebrae", "sternum", "sacrum", "scapula", "clavicula", "humerus",
                 "hip_", "femur", "skull", "costal_cartilages" }))
    {
      sorted.Bone.insert(label);
    }
    else if (Holds(name, { "lung_", "heart" }))
    {
      sorted.Others.insert(label);
    }
  }
  return sorted;
}

std::vector<Path> PlanNeedlePaths(vtkImageData* image, vtkImageData* labels,
  const NeedleLabels& sorted, std::size_t count, unsigned seed)
{
  const Body body{ Voxels(image), Voxels(labels), sorted };
  const std::vector<Vector3> targets = FindVoxels(labels, sorted.Liver);
  std::mt19937 random(seed);
  Uniform uniform(random);
  std::vector<Path> paths;
  for (std::size_t attempt = 0; attempt < 1000 * count && paths.size() < count && !targets.empty();
       ++attempt)
  {
    const double share = uniform(0.0, 1.0) * static_cast<double>(targets.size());
    const Vector3 target = targets[std::min(static_cast<std::size_t>(share), targets.size() - 1)];
    const double up = uniform(-1.0, 1.0);
    const double around = uniform(0.0, TwoPi);
    const double flat = std::sqrt(1.0 - up * up);
    const Vector3 way = { flat * std::cos(around), flat * std::sin(around), up };
    if (const auto skin = body.FindSkin(target, way))
    {
      Path path = { target + (*skin + Outside) * way };
      MoveTo(path, target, TickStep);
      paths.push_back(std::move(path));
    }
  }
  return paths;
}

ForceError CompareForces(const std::vector<Trace>& some, const std::vector<Trace>& others)
{
  ForceError error;
  std::size_t ticks = 0;
  for (std::size_t path = 0; path < some.size(); ++path)
  {
    double squares = 0.0;
    for (std::size_t i = 0; i < some[path].size(); ++i)
    {
      const double off = Norm(some[path][i].Force - others[path][i].Force);
      squares += off * off;
      error.Largest = std::max(error.Largest, off);
      error.Affected += off > Same ? 1.0 : 0.0;
      ++ticks;
    }
    error.RootMeanSquare += std::sqrt(squares / std::max<double>(1.0, some[path].size()));
  }
  error.RootMeanSquare /= std::max<double>(1.0, some.size());
  error.Affected *= 100.0 / std::max<double>(1.0, ticks);
  return error;
}

} // namespace evaluation
