// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the lines and fronts near a place on which a model's modes hold the hand, so that they can
 * be drawn.
 *
 * They are made from the primitives that a tick reads (ModePrimitives.h), so that the hand feels
 * the shapes that are drawn:
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
 * A line is described by one of its points and its direction there. The caller traces it with
 * FollowedShapes::Turn() and Return(). These classes are for the GUI thread, because they allocate.
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
  int Mode = 0;   ///< number of the shape's mode
  Vector3 Centre; ///< a point (m) of the line or front
  /**
   * Unit vector along the line, or normal of the front. If a front has a free side, the normal
   * points to it.
   */
  Vector3 Direction;
  Matrix3 Tensor; ///< tensor in world axes, divided by its first eigenvalue, which must be positive
};

class FollowedShapes
{
public:
  /** Ignores the tip and the friction of surfaces. The model must outlive this object. */
  explicit FollowedShapes(const HapticModel& model);
  FollowedShapes(const FollowedShapes&) = delete;
  FollowedShapes& operator=(const FollowedShapes&) = delete;

  /**
   * Returns the shapes at a place (m). Modes without a force there have no shapes, nor do methods
   * other than Primitives.
   */
  std::vector<FollowedShape> Collect(const Vector3& place);

  /**
   * Replaces `direction` by the unit vector along a mode's line at a place. Of the two possible
   * directions, the result is the one closer to `direction`. Returns false if there is no line.
   */
  bool Turn(int mode, const Vector3& place, Vector3& direction);
  /**
   * Moves a place near a mode's line back to the line if the line has its own anchor, because a
   * step along the direction leaves the line. Returns false if the line ends there.
   */
  bool Return(int mode, Vector3& place);

private:
  void CollectOf(int mode, const Vector3& place, std::vector<FollowedShape>& shapes);
  void AddTensor(int mode, const Vector3& place, std::vector<FollowedShape>& shapes) const;
  ModeKind KindOf(int mode) const;
  /** Reads the primitives of a mode. Returns false if none of them exerts a force. */
  bool Read(int mode, const Vector3& place);
  /** Returns the front among the primitives that were read, or null if there is none. */
  const Primitive* FindFront(ModeKind kind) const;
  /**
   * Returns the line among the primitives that were read, or null. For a vortex, it is the core,
   * wherever the hand is.
   */
  const Primitive* FindLine(ModeKind kind) const;
  /** Returns the first primitive of a kind whose strength exceeds `strength`. */
  const Primitive* FindPrimitive(PrimitiveKind kind, double strength) const;
  /** Moves a place to a mode's line. Returns false if there is no line. */
  bool FindStart(int mode, Vector3& place);

  const HapticModel& Model;
  const double Voxel; ///< length of a voxel (m)
  LabelMemory Memory;
  const ModeField Modes;
  PrimitiveSet Set;
};

} // namespace VolumeHaptics

#endif
