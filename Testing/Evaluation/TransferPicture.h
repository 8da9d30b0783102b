// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Table 1 of the paper as a picture: each visual function of a CT beside the haptic function.
 */
#ifndef Evaluation_TransferPicture_h
#define Evaluation_TransferPicture_h

#include "Comparison.h"

namespace evaluation
{

/**
 * Draws FOLDER/transfer.png: the rendered CT, its visual transfer functions, and beside each of
 * them the corresponding haptic function of the preset "CT contrast". Without a file, draws the
 * project's phantom. If the file can't be read, prints a message on stderr and returns a picture
 * without a name. Needs a display, possibly a virtual one.
 */
Picture DrawTransferPicture(
  const std::string& volumeFile, const Effort& effort, const std::string& folder);

} // namespace evaluation

#endif
