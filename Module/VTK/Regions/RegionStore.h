// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Stores the known facts about a large volume and its resident samples, and chooses the next region
 * to read.
 */
#ifndef RegionStore_h
#define RegionStore_h

#include "Core/Realtime/BackgroundWork.h"
#include "VTK/Regions/CoarseImage.h"
#include "VTK/Regions/Formats/LargeVolume.h"
#include "VTK/Regions/RegionPlanner.h"
#include "VTK/Regions/RegionReader.h"
#include "VTK/Regions/VolumeSurvey.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

class vtkDataArray;
class vtkImageData;

namespace VolumeHaptics
{

/** Settings of a region source that define its volume. */
struct LargeVolumeKey
{
  BoxExtent Extent{};
  int ScalarType = 0;
  std::string File;
  vtkTypeInt64 HeaderSize = 0;
  int ByteOrder = 0;
  int Version = 0;
  bool AreLabels = false;

  bool operator==(const LargeVolumeKey& other) const
  {
    return this->Extent == other.Extent && this->ScalarType == other.ScalarType &&
      this->File == other.File && this->HeaderSize == other.HeaderSize &&
      this->ByteOrder == other.ByteOrder && this->Version == other.Version &&
      this->AreLabels == other.AreLabels;
  }
};

/** Identifies the data from which the coarse level is made. Default: no coarse level. */
struct CoarseKey
{
  const void* Image = nullptr;
  vtkMTimeType Time = 0;
  Affine3 IndexToWorld{}; ///< placement of the volume in the world

  bool operator==(const CoarseKey& other) const
  {
    return this->Image == other.Image && this->Time == other.Time &&
      IsIdentical(this->IndexToWorld, other.IndexToWorld);
  }
};

/** Stores the resident region of a volume. Call it on the owner's thread. */
class RegionStore
{
public:
  RegionStore();
  ~RegionStore();

  /** Returns whether a volume exists and was made with these settings. */
  bool IsOf(const LargeVolumeKey& key) const { return this->Volume && this->Key == key; }
  /** Replaces the volume, and discards all data of the previous one. */
  void SetVolume(const LargeVolumeKey& key, std::shared_ptr<const LargeVolume> volume);
  const LargeVolume* GetVolume() const { return this->Volume.get(); }
  /** Stops the reading thread, and discards the volume and the coarse level. */
  void Clear();
  /** Sets the coarse level that stands in for late samples; null: none. */
  void SetCoarseLevel(const CoarseKey& key, std::shared_ptr<const CoarseLevel> level);
  bool HasCoarseLevel(const CoarseKey& key) const { return this->CoarseOf == key; }

  RegionPlanner& GetPlanner() { return this->Planner; }

  /**
   * Accepts a region that has arrived, if any, and orders the next region that the tip needs.
   * `time` (s) is the time of the tip. Returns whether the resident region has changed.
   */
  bool Poll(const double tip[3], double time);

  /** Sets the time (s) from a region's arrival until it can be felt. */
  void SetUseTime(double seconds) { this->UseTime = seconds; }

  /** Returns all values of the resident samples, unfilled; null before the first region. */
  vtkDataArray* GetSamples() const { return this->Samples; }
  const BoxExtent& GetRegion() const { return this->Region; }
  /** Returns whether the resident samples belong to the coarse level. */
  bool IsStandIn() const { return this->StandsIn; }
  bool IsWaiting() const { return this->Ordered.has_value(); }
  bool IsSurveyed() const { return this->Facts.has_value(); }
  /** Returns why the last read failed; empty if it succeeded. */
  const std::string& GetTrouble() const { return this->Trouble; }
  /**
   * Returns a new notice on the values that are treated as outside; empty if there is none since
   * the last call.
   */
  std::string DrainNotice() { return std::exchange(this->Notice, {}); }

  /**
   * Reads a region into a new array within this call. On failure, returns null, with the reason in
   * `error`.
   */
  vtkSmartPointer<vtkDataArray> Read(const BoxExtent& region, std::string& error);
  /**
   * Writes the known facts about the whole volume to the image. `isFilled`: whether the image's
   * outside samples have been replaced; if not, as after Read(), also writes which samples are
   * outside.
   */
  void WriteFacts(vtkImageData* image, bool isFilled) const;

private:
  bool Survey(std::string& error);
  void SetFacts(const VolumeFacts& facts);
  bool ReceiveRegion(const double tip[3], double interval);
  /** Makes a region of the coarse level if the resident region lacks samples that the tip needs. */
  bool UpdateStandIn(const double tip[3]);
  /** Returns whether a region has all samples for a hand that presses no deeper than now. */
  bool Holds(const BoxExtent& region, const double tip[3]) const;
  void Show(RegionSamples&& region, bool standsIn);
  void MeasureVelocity(const double tip[3], double time);
  void Order(const double tip[3]);

  RegionPlanner Planner;
  LargeVolumeKey Key;
  std::shared_ptr<const LargeVolume> Volume;
  std::optional<VolumeFacts> Facts;
  vtkMTimeType WholeTime = 0;
  vtkSmartPointer<vtkDataArray> Samples;
  BoxExtent Region;
  bool StandsIn = false; ///< whether Samples belong to the coarse level
  CoarseKey CoarseOf;
  std::shared_ptr<const CoarseLevel> Coarse;
  std::optional<BoxExtent> StandInOrdered;
  KeyedWork<BoxExtent, std::shared_ptr<RegionSamples>> StandIns;
  std::optional<BoxExtent> Ordered;
  vtkIdType OrderedMost = 0;  // largest allowed number of voxels when the region was ordered
  std::int64_t OrderTime = 0; // time of the order (ServoClock)
  std::int64_t LookTime = 0;  // time of the last Poll() (ServoClock)
  double UseTime = 0.0;       // s
  std::array<double, 3> Tip{};
  std::array<double, 3> Velocity{};
  double TipTime = 0.0; // s
  std::string Trouble;
  std::string Notice;
  std::unique_ptr<RegionReader> Thread; // last member, so that it is destroyed first
};

} // namespace VolumeHaptics

#endif
