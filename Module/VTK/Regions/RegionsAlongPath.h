// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Provides models of regions along a path through a large volume.
 */
#ifndef RegionsAlongPath_h
#define RegionsAlongPath_h

#include "Core/Math/Vector3.h"

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

class vtkHapticRegionSource;
class vtkImageData;

namespace VolumeHaptics
{

class HapticModel;
struct ServoState;

/**
 * Thrown if a region that a path needs can't be read or baked. Its message has the reason and the
 * cure.
 */
struct RegionLost : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/**
 * Provides for each tick a model of a region with all samples that the tick may read, so that its
 * force is bit-identical to that of the whole volume. A region is larger than its first tick needs,
 * and is used until the path leaves it.
 */
class RegionsAlongPath
{
public:
  /**
   * Function that bakes a region. It returns null and reports an error if the region can't be
   * touched.
   */
  using Baker = std::function<std::shared_ptr<const HapticModel>(vtkImageData*, std::string&)>;

  RegionsAlongPath(vtkHapticRegionSource* source, Baker bake);

  ///@{
  /** Both functions throw RegionLost. */
  /** Returns a model of a corner of the volume, to begin with. */
  std::shared_ptr<const HapticModel> Begin() const;
  /**
   * Returns a model for a tick that moves to a tip (device space): the given model if it has all
   * samples, otherwise a new one.
   */
  std::shared_ptr<const HapticModel> Find(
    std::shared_ptr<const HapticModel> model, const ServoState& state, const Vector3& tip) const;
  ///@}

private:
  std::shared_ptr<const HapticModel> Read(const int region[6]) const;

  vtkHapticRegionSource* const Source;
  const Baker Bake;
};

} // namespace VolumeHaptics

#endif
