// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reuses rays through a volume while nothing changes along them.
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
 * view, the volume's appearance, and the depth of the opaque geometry at which it ends. This class
 * reuses the mapper's image from one frame to the next, and makes the mapper cast only the rays
 * whose depth has changed. Frames are bit-identical to those without this class.
 *
 * The mapper also computes a table of shades for each frame. This class reuses the table while
 * lights, camera and the volume's appearance are unchanged.
 *
 * A frame at rest casts more rays, and input may interrupt it. The last coarse image is therefore
 * stored, too, and the next motion continues with it.
 *
 * The mapper must draw its volume in only one renderer; the owner of this object checks that.
 */
class KeptRays
{
public:
  KeptRays(vtkRenderer* renderer, vtkVolume* volume, vtkFixedPointVolumeRayCastMapper* mapper);
  ~KeptRays();
  KeptRays(const KeptRays&) = delete;
  KeptRays& operator=(const KeptRays&) = delete;

  /** Returns whether this object belongs to a volume in this renderer. */
  bool Follows(vtkRenderer* renderer, vtkVolume* volume) const
  {
    return this->Renderer == renderer && this->Volume == volume;
  }
  /** Returns whether the image shows the current state of the volume. */
  bool IsCurrent() const;
  ///@{
  /**
   * Return the distance of the image's rays (pixels), or of the samples along them (world units).
   */
  float GetImageDistance() const { return this->ImageDistance; }
  float GetSampleDistance() const { return this->SampleDistance; }
  ///@}

  /** Requires the next frame to be quick: it is abandoned if it would have to cast all rays. */
  void Expect() { this->IsExpected = true; }
  /** Returns whether this frame casts all rays. */
  bool IsCastingAll() const { return this->IsWhole; }
  /** Returns whether all rays have been cast since the last call of this function. */
  bool DrainWhole();

private:
  using Words = std::vector<std::uint64_t>;

  /** An image with the conditions that it was made under. */
  struct Picture
  {
    Words Look;                ///< view and appearance of the volume; empty without an image
    Words Image;               ///< distribution of the rays
    std::vector<float> Depths; ///< depth where each ray ends, row by row
    std::vector<unsigned short> Pixels;
  };

  /** First and last ray of a part of a row that has to be cast again. */
  struct Run
  {
    int First;
    int Last;
  };

  void Begin();
  void End();
  /**
   * Describes the view and the volume's appearance: all conditions of rays that are known before a
   * frame.
   */
  Words DescribeLook() const;
  /** Describes the distribution of rays over the image. */
  Words DescribeImage() const;
  /** Describes the location of the mapper's pixels in memory. */
  Words DescribeStorage() const;
  /** Copies the mapper's image to the coarse image if it is coarse. */
  void StoreCoarse();
  /**
   * Copies the coarse image to the mapper's image, if it was made under the given conditions.
   * Returns whether it was copied.
   */
  bool CopyCoarse(const Words& look, const Words& image);
  /** Describes everything that the mapper's table of shades depends on. */
  Words DescribeShades() const;
  /** Returns whether the mapper is drawing this volume in this window now. */
  bool IsDrawn() const;
  /** Returns whether rays can be reused at all in this window and with this mapper. */
  bool CanKeep() const;
  /** Reads the depth where each ray of the used part of the image ends, row by row. */
  void ReadDepths(std::vector<float>& depths) const;
  /** Collects the runs of rays whose depth has changed. */
  void CollectChanges(const std::vector<float>& depths);
  /** Makes the mapper cast the run with index `pass` in each row. */
  void SetPass(std::size_t pass);

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkVolume> Volume;
  vtkWeakPointer<vtkFixedPointVolumeRayCastMapper> Mapper;
  vtkSmartPointer<vtkCallbackCommand> Observer;
  vtkSmartPointer<vtkDirectionEncoder> OwnDirections; ///< the mapper's original encoder
  Words Shades; ///< conditions of the mapper's table of shades; empty: unknown
  Picture Now;  ///< the mapper's current image, whose pixels the mapper owns
  Words Storage;
  Picture Coarse;
  float ImageDistance = 0.0F; ///< distances in Now
  float SampleDistance = 0.0F;
  std::vector<float> NewDepths;
  std::vector<std::vector<Run>> Rows; ///< runs to cast in this frame, by row
  std::vector<int> OwnBounds;         ///< row bounds as the mapper has computed them
  std::size_t Passes = 0;
  bool IsCasting = false; ///< whether more passes of this frame follow
  bool IsExpected = false;
  bool IsWhole = false;
};

} // namespace VolumeHaptics

#endif
