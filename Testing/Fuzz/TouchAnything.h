// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets any bytes as an image, a property and a tip path, and touches the image with both
 * solvers.
 */
#ifndef TouchAnything_h
#define TouchAnything_h

#include <cstddef>
#include <cstdint>

/**
 * Chooses everything from the bytes: type, size, spacing and samples (including NaN and
 * infinities), estimator, solver, side, functions with steps, and a path with jumps and with tips
 * that are not finite. Some bytes also choose a label image of any type, size and direction with a
 * table of materials and forbidden labels. Aborts if a force or a proxy is not finite, if a force
 * exceeds what the material allows, or if a state can't be stored and restored.
 */
void TouchAnything(const std::uint8_t* bytes, std::size_t size);

#endif
