// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_CoarseFrames_h
#define Explore_CoarseFrames_h

class vtkGPUVolumeRayCastMapper;
class vtkRenderWindow;

namespace Explore
{
/// From now on, the mapper casts one ray a pixel in still frames; in those that the window wants at
/// a rate it takes every second sample of only as many rays as that rate allows. (By itself it
/// would spare samples, but no rays, which is too little for a renderer in software.)
void DrawCoarselyInMotion(vtkRenderWindow* window, vtkGPUVolumeRayCastMapper* mapper);
} // namespace Explore

#endif
