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

/** A method of the filter, with one solver if the method has several. */
struct MethodChoice
{
  static constexpr int AnySolver = -1;

  int Method;       ///< vtkVolumeHapticsFilter::MethodType
  int Solver;       ///< vtkVolumeHapticsFilter::SolverType, or AnySolver
  std::string Name; ///< name in programs and on command lines
  std::string Text; ///< name that the user sees
  bool IsPrepared;  ///< whether switching to it may keep the GUI thread busy for about a second
};

/** Returns all choices, in the order in which a key switches through them. */
const std::vector<MethodChoice>& MethodChoices();

/** Returns the index of a method and a solver in MethodChoices(). */
std::size_t FindMethodChoice(int method, int solver);

inline const MethodChoice& GetMethodChoice(int method, int solver)
{
  return MethodChoices()[FindMethodChoice(method, solver)];
}

} // namespace VolumeHaptics

#endif
