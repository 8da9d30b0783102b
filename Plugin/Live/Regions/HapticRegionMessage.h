// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts a region of a volume to a message from the data server to the client, and back.
 *
 * ParaView's own messages omit the direction of images, and do not report that the other side has
 * ended.
 */
#ifndef HapticRegionMessage_h
#define HapticRegionMessage_h

#include <string>
#include <vector>

class vtkImageData;
class vtkMultiProcessController;

namespace VolumeHapticsLive
{

/** Packs the image with its scalars and its numeric field arrays. */
std::vector<char> PackRegion(vtkImageData* image);
/** Packs an error instead of an image. */
std::vector<char> PackError(const std::string& error);

/**
 * Unpacks the image of a message. Returns false, with the reason in `error`, if the message is an
 * error or contains no image.
 */
bool UnpackRegion(const std::vector<char>& message, vtkImageData* image, std::string& error);

bool SendMessage(vtkMultiProcessController* controller, const std::vector<char>& message);
/**
 * Receives a message. Returns false if the other side has ended. A message that exceeds the memory
 * is replaced by an error.
 */
bool ReceiveMessage(vtkMultiProcessController* controller, std::vector<char>& message);

} // namespace VolumeHapticsLive

#endif
