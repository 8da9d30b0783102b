// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets any bytes as a file with a table of labels.
 */
#ifndef TouchLabels_h
#define TouchLabels_h

#include <cstddef>
#include <cstdint>

/**
 * Passes the bytes to the reader of each format, and to the reader of a segmentation's samples.
 * Aborts if a refusal has no reason or changes the table, if a name is not UTF-8, if a colour or a
 * material is out of its range, or if writing a table as CSV and reading it back changes it.
 */
void TouchLabels(const std::uint8_t* bytes, std::size_t size);

#endif
