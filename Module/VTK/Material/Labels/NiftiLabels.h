// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the tables of labels that NIfTI files have between header and samples.
 *
 * TotalSegmentator and programs of the Human Connectome Project store a header extension in XML,
 * with an element <Label Key="5" Red="1" Green="0" Blue="0" Alpha="1">liver</Label> for each label.
 * MRIcron and MRIcroGL store one line for each label, with the label, a tabulator and the name.
 * These lines are not preceded by an extension's head.
 */
#ifndef NiftiLabels_h
#define NiftiLabels_h

#include <cstddef>
#include <string_view>

namespace VolumeHaptics
{

/** Returns whether uncompressed bytes begin like a NIfTI file, version 1 or 2. */
bool IsNifti(std::string_view bytes);

/**
 * Computes from the first 540 bytes the size of everything before the samples. The result is at
 * most `most`.
 */
std::size_t GetNiftiHeadSize(std::string_view bytes, std::size_t most);

enum class NiftiTable
{
  None,
  Xml,
  Names
};

/** Finds a table between header and samples. Returns its format, and its text in `table`. */
NiftiTable FindNiftiTable(std::string_view bytes, std::string_view& table);

} // namespace VolumeHaptics

#endif
