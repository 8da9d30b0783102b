// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Any bytes as an image, a property and a tip path, touched by both solvers.
 */
#ifndef TouchAnything_h
#define TouchAnything_h

#include <cstddef>
#include <cstdint>

/**
 * Bytes choose everything: type, size, spacing and samples (NaN and infinities, too), estimator,
 * solver, side, functions with steps, a path with jumps and tips that are not numbers, and if they
 * want, a label image of any type, size and direction with a table of materials and forbidden
 * labels. Aborts if a force or a proxy is not finite, a force exceeds what the material holds, or a
 * state can't be stored and taken up again.
 */
void TouchAnything(const std::uint8_t* bytes, std::size_t size);

#endif
