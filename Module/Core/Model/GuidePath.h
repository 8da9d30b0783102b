// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Polylines that guide a hand. Finds the nearest place on them.
 *
 *   GuidePath guide({ { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 10, 0 } } }, 1.0);
 *   const GuidePlace place = guide.Find(world);
 *
 * The direction of a polyline changes at its corners. A proxy on the line through the nearest place
 * comes to rest where the lag is perpendicular to the line. But a tip may be outside a corner,
 * where no segment is perpendicular to the lag. Within half of the rounding from a corner, the
 * direction therefore turns steadily from one segment's to the next one's. Places stay on the
 * polyline, so that a proxy on it is not drawn away.
 */
#ifndef GuidePath_h
#define GuidePath_h

#include "Core/Math/Vector3.h"

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

/** The place on the guide that is nearest to a point. */
struct GuidePlace
{
  Vector3 Nearest;
  Vector3 Direction; ///< unit vector along the line
  bool IsNearEnd = false;
  ///@{
  /** End of the line, if the place is on the first or last segment of an open line. */
  Vector3 End;
  Vector3 Outward; ///< unit vector along the line at End, away from the line
  ///@}
};

/** Polylines in a tree of boxes. Immutable. */
class GuidePath
{
public:
  using Line = std::vector<Vector3>;

  /**
   * Makes the guide from finite points. Drops repeated points, and lines of one point. A line that
   * ends where it begins is closed.
   * @param rounding length over which corners are rounded, in the units of the points
   */
  GuidePath(const std::vector<Line>& lines, double rounding);

  bool IsEmpty() const noexcept { return this->Segments.empty(); }
  bool IsSame(const GuidePath& other) const noexcept;

  /**
   * Returns the place nearest to a position. The guide must not be empty. If the position is not
   * finite, the result may be any place.
   */
  GuidePlace Find(const Vector3& place) const noexcept;

  ///@{
  /** Return the addresses and sizes (bytes) of the memory that Find() reads. */
  const void* GetSegments() const noexcept { return this->Segments.data(); }
  std::size_t GetSegmentsSize() const noexcept { return this->Segments.size() * sizeof(Segment); }
  const void* GetBoxes() const noexcept { return this->Boxes.data(); }
  std::size_t GetBoxesSize() const noexcept { return this->Boxes.size() * sizeof(Box); }
  ///@}

private:
  struct Segment
  {
    Vector3 Begin;
    Vector3 Direction; ///< unit vector
    double Length = 0.0;
    /**
     * Direction of the line at Begin. At a corner, it is halfway between the directions of both
     * segments.
     */
    Vector3 AtBegin;
    Vector3 AtEnd;
    double Turn = 0.0; ///< length from a corner over which the direction turns
    bool BeginsLine = false;
    bool EndsLine = false;
  };
  struct Box
  {
    Vector3 Low;
    Vector3 High;
  };
  static constexpr std::size_t SegmentsOfALeaf = 4;

  void AddLine(const Line& line, double rounding);
  void MakeBoxes();
  /**
   * Returns the squared distance to box i of the tree, whose children are boxes 2 i + 1 and 2 i +
   * 2.
   */
  double SquareDistance(std::size_t box, const Vector3& place) const noexcept;

  std::vector<Segment> Segments;
  std::vector<Box> Boxes; ///< a complete binary tree; the last boxes are the leaves
  std::size_t FirstLeaf = 0;
};

} // namespace VolumeHaptics

#endif
