// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Table 1 of the paper as a picture: what a CT looks like and what it feels like, function by
 * function.
 */
#ifndef Evaluation_TransferPicture_h
#define Evaluation_TransferPicture_h

#include "Comparison.h"

namespace evaluation
{

/**
 * Draws FOLDER/transfer.png: the rendered CT, its visual transfer functions, and beside each the
 * haptic one of the preset "CT contrast". Without a file, of the project's phantom. Without a name,
 * after a message on stderr, if the file can't be read. Needs a display, which may be virtual.
 */
Picture DrawTransferPicture(
  const std::string& volumeFile, const Effort& effort, const std::string& folder);

} // namespace evaluation

#endif
