// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rays through a volume that need not be cast again, because nothing has changed along them.
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
 * While a hand strokes a volume and the camera rests, only what lies in front of the volume moves:
 * the stylus, arrows and rings. A mapper that casts rays on the processor casts all of them for
 * each frame, and each ray depends on nothing but the view, the volume's look, and the depth of the
 * opaque geometry at which it ends. This keeps the mapper's image from one frame to the next, and
 * has it cast again only the rays whose depth has changed. Frames are the same to the bit.
 *
 * The mapper also makes a table of shades anew for each frame. It is kept while lights, camera and
 * the volume's look are the same.
 *
 * A frame at rest, which input may interrupt, casts more rays. So the last coarse image is kept
 * beside it, and the motion goes on with that.
 *
 * The mapper draws its volume in one renderer only, which the owner of this knows.
 */
class KeptRays
{
public:
  KeptRays(vtkRenderer* renderer, vtkVolume* volume, vtkFixedPointVolumeRayCastMapper* mapper);
  ~KeptRays();
  KeptRays(const KeptRays&) = delete;
  KeptRays& operator=(const KeptRays&) = delete;

  /** Whether this is for a volume in this renderer. */
  bool Follows(vtkRenderer* renderer, vtkVolume* volume) const
  {
    return this->Renderer == renderer && this->Volume == volume;
  }
  /** Whether the image still shows the volume as it would be drawn now. */
  bool IsCurrent() const;
  ///@{
  /** Of the image: pixels between rays, and world units between samples. */
  float GetImageDistance() const { return this->ImageDistance; }
  float GetSampleDistance() const { return this->SampleDistance; }
  ///@}

  /** The next frame is given up if it would have to cast all rays, because it was to be quick. */
  void Expect() { this->IsExpected = true; }
  /** Whether the frame whose rays the mapper casts now takes all of them. */
  bool IsCastingAll() const { return this->IsWhole; }
  /** Whether all rays have been cast since the last call. */
  bool TakeWhole();

private:
  using Words = std::vector<std::uint64_t>;

  /** An image, and what it is for. */
  struct Picture
  {
    Words Look;                ///< empty: there is none
    Words Image;               ///< how its rays are spread
    std::vector<float> Depths; ///< at which they end, row by row
    std::vector<unsigned short> Pixels;
  };

  /** A part of a row whose rays are cast: its first and last one. */
  struct Run
  {
    int First;
    int Last;
  };

  void Begin();
  void End();
  /** The view and the volume's look: all that rays depend on and that is known before a frame. */
  Words DescribeLook() const;
  /** How the rays are spread. */
  Words DescribeImage() const;
  /** The memory of the mapper's image. */
  Words DescribeStorage() const;
  /** Copies the mapper's image to the coarse one, if it is coarse. */
  void StoreCoarse();
  /** Copies the coarse image to the mapper's, if it is what the mapper is to draw. */
  bool TakeCoarse(const Words& look, const Words& image);
  /** What the mapper's table of shades depends on. */
  Words DescribeShades() const;
  /** Whether the mapper draws this volume in this window now. */
  bool IsDrawn() const;
  /** Whether frames may be kept at all. */
  bool CanKeep() const;
  /** Depth at which each ray of the image in use ends, row by row. */
  void ReadDepths(std::vector<float>& depths) const;
  /** Finds the runs of rays whose depth has changed. */
  void FindChanges(const std::vector<float>& depths);
  /** Has the mapper cast the runs of one pass: the one of this number in each row. */
  void SetPass(std::size_t pass);

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkVolume> Volume;
  vtkWeakPointer<vtkFixedPointVolumeRayCastMapper> Mapper;
  vtkSmartPointer<vtkCallbackCommand> Observer;
  vtkSmartPointer<vtkDirectionEncoder> OwnDirections; ///< the mapper's own
  Words Shades; ///< that the mapper's table is for; empty: for others
  Picture Now;  ///< of the mapper, which has the pixels itself
  Words Storage;
  Picture Coarse;
  float ImageDistance = 0.0F; ///< of Now
  float SampleDistance = 0.0F;
  std::vector<float> NewDepths;
  std::vector<std::vector<Run>> Rows; ///< to be cast in this frame
  std::vector<int> OwnBounds;         ///< the mapper's own bounds of its rows
  std::size_t Passes = 0;
  bool IsCasting = false; ///< further passes of one frame
  bool IsExpected = false;
  bool IsWhole = false;
};

} // namespace VolumeHaptics

#endif
