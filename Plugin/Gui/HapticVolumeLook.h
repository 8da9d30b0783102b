// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The look of the felt data in a view.
 */
#ifndef HapticVolumeLook_h
#define HapticVolumeLook_h

class pqPipelineSource;
class pqView;
class QString;

namespace HapticVolumeLook
{

/** Whether the view renders a source visibly as a volume. */
bool IsShown(pqPipelineSource* volume, pqView* view);

/**
 * Renders a source as a volume that is opaque from the skin on, where a hand meets it. Colours are
 * those of skin and bone by Hounsfield units (CTLook), as in the explorer. `array` is the point
 * array; if it is empty, the first one. False if there is none.
 */
bool ShowAsCT(pqPipelineSource* volume, pqView* view, const QString& array);

} // namespace HapticVolumeLook

#endif
