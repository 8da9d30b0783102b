// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_CoarseFrames_h
#define Explore_CoarseFrames_h

class vtkGPUVolumeRayCastMapper;
class vtkRenderWindow;

namespace Explore
{
/// From now on, the mapper casts one ray for each pixel in still frames. In frames for which the
/// window wants a rate it takes every second sample, and only as many rays as that rate allows. (By
/// itself it would save samples but no rays, which is too little for a software renderer.)
void DrawCoarselyInMotion(vtkRenderWindow* window, vtkGPUVolumeRayCastMapper* mapper);
} // namespace Explore

#endif
