// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The methods for feeling a volume, with all their names.
 */
#ifndef HapticMethods_h
#define HapticMethods_h

#include <cstddef>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** A method and, if it has several solvers, one of them. */
struct MethodChoice
{
  static constexpr int AnySolver = -1;

  int Method;       ///< vtkVolumeHapticsAlgorithm::MethodType
  int Solver;       ///< vtkVolumeHapticsAlgorithm::SolverType, or AnySolver
  const char* Name; ///< as programs use it
  std::string Text; ///< as the user sees it
  bool IsPrepared;  ///< whether it may take a second of preparation, on the GUI thread
};

/** All of them, in the order in which a key switches through them. */
const std::vector<MethodChoice>& MethodChoices();

/** The index of a method and a solver in MethodChoices(). */
std::size_t FindMethodChoice(int method, int solver);

/** The choice for a method and a solver. */
inline const MethodChoice& GetMethodChoice(int method, int solver)
{
  return MethodChoices()[FindMethodChoice(method, solver)];
}

} // namespace VolumeHaptics

#endif
