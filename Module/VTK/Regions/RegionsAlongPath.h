// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The models of the regions along a path through a large volume.
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

/** A region that a path needs can't be had; the text tells why, and the cure. */
struct RegionLost : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/**
 * Gives each tick a model of a region that has all samples which the tick can read, so that its
 * force is that of the whole volume, to the bit. A region is larger than its first tick needs: it
 * lasts until the path leaves it.
 */
class RegionsAlongPath
{
public:
  /** Bakes a region. Null, with an error, if it can't be touched. */
  using Baker = std::function<std::shared_ptr<const HapticModel>(vtkImageData*, std::string&)>;

  RegionsAlongPath(vtkHapticRegionSource* source, Baker bake);

  ///@{
  /** Throw RegionLost. */
  /** A model of a corner of the volume. */
  std::shared_ptr<const HapticModel> Begin() const;
  /** The model for a tick to a tip (device): the given one, if it has all samples. */
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
