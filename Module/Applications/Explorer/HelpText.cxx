// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/HelpText.h"

#include "Applications/Explorer/Exploration/ModeChoice.h"

#include "vtkHapticProperty.h"
#include "vtkHapticRegionSource.h"
#include "vtkStringArray.h"
#include "vtkVolumeHapticsFilter.h"

namespace
{
/// Returns the names in the form ", first, second". `quote` is written on both sides of each name.
std::string List(vtkStringArray* names, const std::string& quote)
{
  std::string list;
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    list += ", " + quote + names->GetValue(i) + quote;
  }
  return list;
}
} // namespace

namespace Explore
{
std::string HelpText()
{
  const std::string presets = List(vtkHapticProperty::GetPresetNames(), "\"");
  const std::string methods = List(vtkVolumeHapticsFilter::GetMethodNames(), "").substr(2);
  return R"(Usage: volumehaptics-explore VOLUME [options]

Explores a volume by touch: presses a tip into the outer surface, drags it, presses through to the dense
inside, drags it there, and reports what a hand would feel. Then, if there is a display, it opens a window
in which the mouse, or a device, touches the volume. Without a display, or with --pictures, it writes
pictures, the trace and a summary.

VOLUME   .vti .nii .nii.gz .hdr .img; a DICOM slice, for its series; a folder of DICOM slices or of folders of
         them, or its DICOMDIR; a folder of .tif slices; or )" +
    std::string(vtkHapticRegionSource::GetFileEndings()) + R"(,
         which may be larger than memory unless they are compressed as a whole: they are then felt from the file, and
         the window shows a coarse level. A moving volume is several of these files, in this order; a folder of them,
         or of folders of slices, in the order of the numbers in their names; a .pvd file with times (s); or a NIfTI
         file with several times. The window plays it: space pauses, the arrows go from frame to frame, comma and
         period change the speed. Files without times are 1/10 s apart. Grids (.vtu .vtr .vts .vtm .vtmb .vtk,
         OpenFOAM's .foam, EnSight's .case) are resampled; if they have vectors, the flow is followed

  --pictures DIR    write these files to DIR instead of opening a window (default explore-pictures):
                    explore.png force.png trace.vtp trace.csv summary.txt
  --device ID       window: virtual (default, the mouse), replay:FILE, or a real one, such as falcon: see
                    volumehaptics-device list. Given twice: one in each hand; --tool and the measuring keys
                    are for the first
  --firmware FILE   firmware image for a Novint Falcon that has none
  --newtons X[,Y]   a stick's force at full scale along its axes, N (100): measure it, most have much
                    less; Y is 0 if only the first axis has a motor, as a wheel has
  --setup FILE      window: set-up, loaded if the file exists, saved when the window is closed
  --measurements FILE
                    window: points, distances, angles, paths and areas that you measure by touch (keys 1 to 5;
                    Ctrl+S saves). Loaded if the file exists, saved when the window is closed: .csv, .vtp, or
                    .mrk.json for 3D Slicer. Work that was not saved when a window closed, such as tissue that
                    a burr removed or edited functions, is offered by the next window on the volume (key F11)
  --movie FILE.ogv  window: records a movie of all of it, 20 pictures a second. In the window, key F9 starts and stops
                    a movie, F10 a recording of the touch, and F12 takes a picture
  --replay FILE.vtp window: shows a recording of key F10 with a time slider. F5 plays and pauses, F6 and F7 go back
                    and forward
  --script FILE     window: plays a demonstration, lines with a time (s) and an event, such as
                    "1.0 key t", "1.5 wheel 3", "2.0 stroke 0.7 0.5 1.5", "9 key q": see
                    Documentation/recording.md
  --stereo MODE     window: anaglyph, crystal-eyes, red-blue, interlaced, checkerboard,
                    split-viewport, dresden, left, right, fake, emulate
  --slices          window: three slices through the tip beside the volume (key s). A click goes there and
                    touches, the wheel moves across them, the right button sets window and level
  --cut NAME        window: starts cut open by a plane or a box (default: not cut). The mouse drags the handles;
                    keys: x plane, box, none; e swaps the kept and the hidden part; z feels the cut faces
  --tool NAME       window: what the hand holds: point (default); needle, which punctures surfaces and is held and
                    rubs in tissue; burr, which removes tissue while the left button, or the device's, is
                    pressed. Keys: w next tool; Ctrl+E saves the needle's track, or the removed tissue; Ctrl+Z
                    undoes a stroke of the burr, Ctrl+Y redoes it
  --tool FILE.stl   the closed surface of a tool, also .ply, .obj or .vtp, in the volume's units: its shape is
                    felt where it meets the outer surface. Alt + mouse turns it; key w: next tool
  --sound           window: plays what is touched, a click where a surface is touched or pierced, and noise while
                    the tip slides, brighter on harder surfaces
  --sound FILE.wav  writes the sound along the path to a file
  --preset NAME     materials: auto (default: "CT contrast" for Hounsfield units, else propose), propose
                    (what the volume's own edges suggest), histogram)" +
    presets + R"(,
                    or a .json file saved with key F8 in the window
  --array NAME      the point array that is shown and felt: its values, or the magnitude of its vectors
                    (default: the active scalars, or else the first array)
  --displacements NAME
                    moving volume: the point array of vectors from the material of a frame to where it is in the
                    next one. Surfaces then move from frame to frame, however far, and carry along a hand that
                    sticks to them
  --series N        which series of a DICOM folder with several (default: the one with most pixels; the
                    summary and key F3 of the window list them), which segment of a segmentation (default:
                    all), which volume along the fourth axis of a NIfTI file (default: all, as times), or which
                    channel, time or component of another file (default: the first); of each file if several
                    are named. Key F2, or dropping a file on the window, opens another volume
  --labels FILE     a segmentation of the volume, .seg.nrrd .nrrd .nii .nii.gz .mgz .mnc .mhd .mha .vti .dcm, or
                    a folder with a mask for each organ: its labels have names in the window, and materials of
                    their own
  --as-labels       the volume is a label map: its values are label numbers, which have colours, and
                    the names that the file has for them. The window asks if it looks like one (key F4)
  --materials FILE  a table of what the labels feel like, such as a CSV with the columns label, name,
                    stiffness, friction, viscosity, strength; several of these options add up
  --method NAME     method of the path, and the first one in the window: )" +
    methods + R"(
                    (default proxy, or primitives for the vectors of a grid; the others for comparison; primitives feels the modes)
  --mode NAME[:ARRAY]
                    a mode of the method primitives, which this chooses, too: )" +
    ListModes() + R"(;
                    ARRAY has its vectors or tensors (default: the first that fits). Several of these options
                    add up; without any, the vectors are followed, else the tensors. NAME may also say what
                    you want: )" +
    ListModePresets() + R"(
  --guide FILE      leads the hand along the lines of a file, or on its surface, as a mode of primitives, with
                    2 N: .vtp .vtk .stl .ply .obj, in the volume's coordinates; or along the paths that you
                    measured (--measurements: .csv .mrk.json .vtp), or a trace. The modes of --mode are felt,
                    too; without any, the window offers them (key j)
  --estimator NAME  gradient: central, gaussian (default), bspline
  --size PX         width of the picture (default 900)
  --mapper NAME     volume rendering: auto (default), gpu, cpu; auto uses the
                    processor in a window if OpenGL runs on it, too
  --front AXIS      the direction in which a face looks: -y (default), +y, +x, -x, +z, -z
  --up AXIS         the direction of the top: +z (default), ...
  --inspect         no window: print what the file has, what was guessed, and what can be felt of it
  --json            with --inspect: print JSON, for programs
  --write-volume FILE.vti
                    no window: write the volume alone, with the values, axes and lengths that are felt (of a moving
                    volume, the first frame)
  --live            run the same path through the servo loop, too, at 1 kHz in real time; what was felt
                    there is recorded in live.vtp and shown in the pictures
  --large           read a file that may be larger than memory around the hand only (default: if it takes
                    more than half of the free memory)
  --check-display   only test whether the display can draw pictures: exit status 0 if it can;
                    if not, VTK may crash
  --help            this text

Exit status: 0 success, 1 the computation failed, 2 the input or an option is wrong, 3 no display.
)";
}
} // namespace Explore
