// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The ways to feel a volume, under all the names that they have.
 */
#ifndef HapticMethods_h
#define HapticMethods_h

#include <cstddef>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** A method and, where that makes a difference, its solver. */
struct MethodChoice
{
  static constexpr int AnySolver = -1;

  int Method;       ///< vtkVolumeHapticsAlgorithm::MethodType
  int Solver;       ///< vtkVolumeHapticsAlgorithm::SolverType, or AnySolver
  const char* Name; ///< for programs
  std::string Text; ///< for people
  bool IsPrepared;  ///< whether it may take a second to get ready, on the GUI thread
};

/** All of them, in the order in which one switches from each to the next. */
const std::vector<MethodChoice>& MethodChoices();

/** The place of a method and a solver in MethodChoices(). */
std::size_t FindMethodChoice(int method, int solver);

/** The one of a method and a solver. */
inline const MethodChoice& GetMethodChoice(int method, int solver)
{
  return MethodChoices()[FindMethodChoice(method, solver)];
}

} // namespace VolumeHaptics

#endif
