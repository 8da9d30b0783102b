// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How a view shows the felt data.
 */
#ifndef HapticVolumeLook_h
#define HapticVolumeLook_h

class pqPipelineSource;
class pqView;
class QString;

namespace HapticVolumeLook
{

/** Whether the view renders a source as a volume, which can be seen. */
bool IsShown(pqPipelineSource* volume, pqView* view);

/**
 * Renders a source as a volume that is opaque from the skin on, where a hand meets it, in colours
 * of skin and bone at Hounsfield units (CTLook), as the explorer does.
 * `array` is the point array; if it is empty, the first one. False if there is none.
 */
bool ShowAsCT(pqPipelineSource* volume, pqView* view, const QString& array);

} // namespace HapticVolumeLook

#endif
