// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets any bytes as a file of a format, or as a folder of files, for vtkHapticVolumeReader. A
 * volume must be complete and finite; a refusal must state its remedy.
 *
 * A folder is packed into one buffer: "PACK", then for each file the length of its name (a byte),
 * the name, the size of its contents (2 bytes, the lower one first) and the contents. A buffer that
 * ends early shortens the last file.
 */
#ifndef TouchFiles_h
#define TouchFiles_h

#include <cstddef>
#include <cstdint>

void TouchDicom(const std::uint8_t* bytes, std::size_t size);
void TouchBrain(const std::uint8_t* bytes, std::size_t size);
/** Reads VTK's grids. The first byte selects the format. */
void TouchGrid(const std::uint8_t* bytes, std::size_t size);
void TouchHdf(const std::uint8_t* bytes, std::size_t size);
void TouchMetaImage(const std::uint8_t* bytes, std::size_t size);
void TouchNifti(const std::uint8_t* bytes, std::size_t size);
void TouchNrrd(const std::uint8_t* bytes, std::size_t size);
void TouchTiff(const std::uint8_t* bytes, std::size_t size);
void TouchVti(const std::uint8_t* bytes, std::size_t size);
void TouchZarr(const std::uint8_t* bytes, std::size_t size);
/** Reads tables according to their extensions, and label images with the names of their labels. */
void TouchLabelFile(const std::uint8_t* bytes, std::size_t size);

#endif
