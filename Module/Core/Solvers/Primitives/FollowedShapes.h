// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The lines and fronts on which the modes of a model hold the hand, near a place, to be drawn.
 *
 * They are made of the primitives that a tick reads (ModePrimitives.h), so that what is seen is
 * what is felt:
 *
 * | mode          | shape                                                     |
 * | ------------- | --------------------------------------------------------- |
 * | VectorFollow  | the stream line through the place                         |
 * | VectorFront   | the front through the place, and where its free side is   |
 * | TwoSidedFront | the same                                                  |
 * | VortexTube    | the core line of the vortex around the place              |
 * | Shear         | the line through the place, along the largest stretch     |
 * | TensorFollow  | the fibre through the place; or its sheet; and the tensor |
 * | Ridge, Guide  | the line that the hand is drawn to                        |
 * | GuideSurface  | its tangent plane, as a front                             |
 * | Surface       | nothing: the volume shows it                              |
 *
 * A line is given by one of its points and its direction there. The caller traces it with
 * FollowedShapes::Turn() and Return(). For the GUI thread: this allocates.
 */
#ifndef FollowedShapes_h
#define FollowedShapes_h

#include "Core/Model/LabelMemory.h"
#include "Core/Solvers/Primitives/ModePrimitives.h"

#include <vector>

namespace VolumeHaptics
{

enum class FollowedForm
{
  Line,
  Front,
  Tensor
};

struct FollowedShape
{
  FollowedForm Form = FollowedForm::Line;
  int Mode = 0;   ///< number of the mode
  Vector3 Centre; ///< m; on the line
  /** A unit vector along the line, or normal to the front: to its free side, if it has one. */
  Vector3 Direction;
  Matrix3 Tensor; ///< in world axes: divided by its first eigenvalue, which is positive
};

class FollowedShapes
{
public:
  /** Borrows the model. Ignores friction of surfaces, and the tip. */
  explicit FollowedShapes(const HapticModel& model);
  FollowedShapes(const FollowedShapes&) = delete;
  FollowedShapes& operator=(const FollowedShapes&) = delete;

  /**
   * Returns the shapes at a place (m). None for modes that hold nothing there, and for methods
   * other than Primitives.
   */
  std::vector<FollowedShape> Collect(const Vector3& place);

  /**
   * Replaces `direction` by the unit vector along a mode's line at a place, in the sense that is
   * closer to `direction`. Returns false if there is no line.
   */
  bool Turn(int mode, const Vector3& place, Vector3& direction);
  /**
   * Moves a place near a mode's line back to the line, if the line has its own anchor, since a step
   * along the direction leaves the line. Returns false if the line ends there.
   */
  bool Return(int mode, Vector3& place);

private:
  void CollectOf(int mode, const Vector3& place, std::vector<FollowedShape>& shapes);
  void AddTensor(int mode, const Vector3& place, std::vector<FollowedShape>& shapes) const;
  ModeKind KindOf(int mode) const;
  /** Reads the primitives of a mode; returns false if no primitive holds. */
  bool Read(int mode, const Vector3& place);
  /** Returns the front among the primitives that were read; null if there is none. */
  const Primitive* FindFront(ModeKind kind) const;
  /**
   * Returns the line among the primitives that were read. For a vortex, returns the core, wherever
   * the hand is.
   */
  const Primitive* FindLine(ModeKind kind) const;
  /** Returns the first primitive of a kind whose strength is larger than a number. */
  const Primitive* FindPrimitive(PrimitiveKind kind, double strength) const;
  /** Moves a place to a mode's line; returns false if there is no line. */
  bool FindStart(int mode, Vector3& place);

  const HapticModel& Model;
  const double Voxel; ///< m
  LabelMemory Memory;
  const ModeField Modes;
  PrimitiveSet Set;
};

} // namespace VolumeHaptics

#endif
