// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Polylines that guide a hand, with the nearest place on them.
 *
 *   GuidePath guide({ { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 10, 0 } } }, 1.0);
 *   const GuidePlace place = guide.Find(world);
 *
 * The direction of a line turns at its corners. A proxy on the line through the nearest place rests
 * where the lag is at right angles to the line. But a tip may be outside of a corner, where no
 * segment is at right angles to the lag. So within half of the rounding from a corner the direction
 * turns steadily from one segment's to the next one's. The places stay on the polyline, so that a
 * proxy on the polyline is not drawn away from it.
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
   * Builds the guide from finite points. Leaves out repeated points and lines of one point. A line
   * that ends where it begins is closed.
   * @param rounding of corners, in the units of the points
   */
  GuidePath(const std::vector<Line>& lines, double rounding);

  bool IsEmpty() const noexcept { return this->Segments.empty(); }
  /** Returns whether another guide has the same lines and directions. */
  bool IsSame(const GuidePath& other) const noexcept;

  /**
   * Returns the place nearest to a position. The guide must not be empty. Returns any place if the
   * position is not finite.
   */
  GuidePlace Find(const Vector3& place) const noexcept;

  ///@{
  /** Return the memory that Find reads and its size in bytes. */
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
    /** Direction of the line at Begin; at a corner, between the directions of both segments. */
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
   * Returns the squared distance to box i of the tree. Its children are boxes 2 i + 1 and 2 i + 2.
   */
  double SquareDistance(std::size_t box, const Vector3& place) const noexcept;

  std::vector<Segment> Segments;
  std::vector<Box> Boxes; ///< a complete binary tree; the last boxes are the leaves
  std::size_t FirstLeaf = 0;
};

} // namespace VolumeHaptics

#endif
