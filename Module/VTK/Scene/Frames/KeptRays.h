// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps rays through a volume while nothing changes along them, so that they need not be cast
 * again.
 */
#ifndef KeptRays_h
#define KeptRays_h

#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkCallbackCommand;
class vtkDirectionEncoder;

namespace VolumeHaptics
{

/**
 * While a hand strokes a volume and the camera rests, only the stylus, arrows and rings move. A
 * mapper on the processor nevertheless casts all rays for each frame. Each ray depends only on the
 * view, the volume's look, and the depth of the opaque geometry at which it ends. This class keeps
 * the mapper's image from one frame to the next, and makes the mapper cast again only the rays
 * whose depth has changed. Frames are the same to the bit.
 *
 * The mapper also makes a new table of shades for each frame. The table is kept while lights,
 * camera and the volume's look are the same.
 *
 * A frame at rest casts more rays, and input may interrupt it. So the last coarse image is kept,
 * too, and the next motion continues with it.
 *
 * The mapper must draw its volume in one renderer only; the owner of this object checks that.
 */
class KeptRays
{
public:
  KeptRays(vtkRenderer* renderer, vtkVolume* volume, vtkFixedPointVolumeRayCastMapper* mapper);
  ~KeptRays();
  KeptRays(const KeptRays&) = delete;
  KeptRays& operator=(const KeptRays&) = delete;

  /** Returns whether this object is for a volume in this renderer. */
  bool Follows(vtkRenderer* renderer, vtkVolume* volume) const
  {
    return this->Renderer == renderer && this->Volume == volume;
  }
  /** Returns whether the image still shows the current state of the volume. */
  bool IsCurrent() const;
  ///@{
  /** Return the distance between rays (pixels) or between samples (world units) in the image. */
  float GetImageDistance() const { return this->ImageDistance; }
  float GetSampleDistance() const { return this->SampleDistance; }
  ///@}

  /** Says that the next frame has to be quick: it is given up if it would have to cast all rays. */
  void Expect() { this->IsExpected = true; }
  /** Returns whether the current frame casts all rays. */
  bool IsCastingAll() const { return this->IsWhole; }
  /** Returns whether all rays have been cast since the last call. */
  bool DrainWhole();

private:
  using Words = std::vector<std::uint64_t>;

  /** An image, and the conditions under which it was made. */
  struct Picture
  {
    Words Look;                ///< view and look of the image; empty: there is no image
    Words Image;               ///< how its rays are spread
    std::vector<float> Depths; ///< the depth where each ray ends, row by row
    std::vector<unsigned short> Pixels;
  };

  /** A part of a row whose rays are cast: its first and last ray. */
  struct Run
  {
    int First;
    int Last;
  };

  void Begin();
  void End();
  /**
   * Describes the view and the volume's look: all conditions of rays that are known before a frame.
   */
  Words DescribeLook() const;
  /** Describes how the rays are spread over the image. */
  Words DescribeImage() const;
  /** Describes where the pixels of the mapper's image are in memory. */
  Words DescribeStorage() const;
  /** Copies the mapper's image to the coarse image, if the mapper's image is coarse. */
  void StoreCoarse();
  /**
   * Copies the coarse image to the mapper's image, if it has the conditions that the mapper is to
   * draw. Returns whether it was copied.
   */
  bool CopyCoarse(const Words& look, const Words& image);
  /** Describes the inputs of the mapper's table of shades. */
  Words DescribeShades() const;
  /** Returns whether the mapper draws this volume in this window now. */
  bool IsDrawn() const;
  /** Returns whether rays may be kept at all in this window and with this mapper. */
  bool CanKeep() const;
  /** Reads the depths where the rays of the image in use end, row by row. */
  void ReadDepths(std::vector<float>& depths) const;
  /** Collects the runs of rays whose depth has changed. */
  void CollectChanges(const std::vector<float>& depths);
  /** Makes the mapper cast run number `pass` of each row. */
  void SetPass(std::size_t pass);

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkVolume> Volume;
  vtkWeakPointer<vtkFixedPointVolumeRayCastMapper> Mapper;
  vtkSmartPointer<vtkCallbackCommand> Observer;
  vtkSmartPointer<vtkDirectionEncoder> OwnDirections; ///< encoder that the mapper came with
  Words Shades; ///< conditions of the mapper's table of shades; empty: not known
  Picture Now;  ///< the mapper's current image; the mapper owns its pixels
  Words Storage;
  Picture Coarse;
  float ImageDistance = 0.0F; ///< distances of Now
  float SampleDistance = 0.0F;
  std::vector<float> NewDepths;
  std::vector<std::vector<Run>> Rows; ///< runs to cast in this frame
  std::vector<int> OwnBounds; ///< bounds of the image's rows as the mapper has computed them
  std::size_t Passes = 0;
  bool IsCasting = false; ///< whether further passes of the frame follow
  bool IsExpected = false;
  bool IsWhole = false;
};

} // namespace VolumeHaptics

#endif
