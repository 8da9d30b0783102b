// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the methods for feeling a volume, with all their names.
 */
#ifndef HapticMethods_h
#define HapticMethods_h

#include <cstddef>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** A method and, if it has several solvers, one solver. */
struct MethodChoice
{
  static constexpr int AnySolver = -1;

  int Method;       ///< vtkVolumeHapticsFilter::MethodType
  int Solver;       ///< vtkVolumeHapticsFilter::SolverType, or AnySolver
  std::string Name; ///< the name in programs
  std::string Text; ///< the name that the user sees
  bool IsPrepared;  ///< whether a switch to it may keep the GUI thread busy for about a second
};

/** Lists all choices, in the order in which a key switches through them. */
const std::vector<MethodChoice>& MethodChoices();

/** Finds the index of a method and a solver in MethodChoices(). */
std::size_t FindMethodChoice(int method, int solver);

inline const MethodChoice& GetMethodChoice(int method, int solver)
{
  return MethodChoices()[FindMethodChoice(method, solver)];
}

} // namespace VolumeHaptics

#endif
