# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each error text of the C++ sources that names a cure is tried by a test, or is listed as a cure that no program can
apply."""

import ast
import re
import shutil
import subprocess
from pathlib import Path

import TestBakingCures
import TestCallCures
import TestCures
import TestExplorerCures
import TestFileCures
import TestFilterCures
import TestLargeCures
import TestRegionCures
import TestSceneCures
import TestShownAndTold
import volumehaptics
from vtkmodules import all as vtk

ROOT = Path(__file__).resolve().parents[2]

# Tests that provoke an error and then apply the remedy in its text: words of the remedy, and words that the test must
# contain.
TRIED = {
    "Python/TestInspect.py": {"is a format of what --inspect finds": "add --inspect"},
    "VTK/Baking/BadScalarsTest.cxx": {
        "Give it values for all components, for example with SetArray": "Give it values for all components",
    },
    "VTK/Filter/LabelsTest.cxx": {"keep fewer labels, or resample it to cubic voxels": "walls between labels are stairs"},
    "VTK/Filter/FilterShiftTest.cxx": {"of the input image can't be a CT in Hounsfield units": "can't be a CT"},
    "VTK/Material/PresetsTest.cxx": {"those of vtkHapticProperty that begin with": "GetCuttingForce()"},
    "VTK/Filter/MemoryTest.cxx": {
        "Use a smaller image, or a region of it": "SURFACE_PROXY",
        "or an image of it, which vtkResampleToImage makes": "which vtkResampleToImage makes",
        "VTK can't run it again: connect a new source": "connect a new source",
        "VTK can't run it again after this": "connect a new source",
        "Give the path in pieces, or lower ServoRate": "in pieces",
    },
    "VTK/Device/LifeTest.cxx": {
        f"take it from vtkHapticDevice::{part}(), and keep the device": f"take it from vtkHapticDevice::{part}()"
        for part in ("GetPlayback", "GetRecorder", "GetVirtualHand")
    },
    "VTK/Device/Recording/RecordingFailureTest.cxx": {
        "Choose another one, or change its permissions": "Choose another one",
        "Make room, or choose a folder on another disk": "Make room",
        "Change its permissions, or give another name": "permissions",
        "to a file of your choice": "vtkHapticRecorder::Recover",
    },
    "VTK/Device/Recording/JournalTest.cxx": {"can't be written over itself: give the recording another name": "over itself"},
    "VTK/Device/Recording/TamperedTest.cxx": {"it was changed, or made with another volume. Record again": "Record again"},
    "VTK/Trace/Paths/PathSourceFilesTest.cxx": {"holds no tip positions. Record again": "no tip positions"},
    "VTK/Experimental/XRActionsTest.cxx": {
        "with the files of its bindings beside it": "can't be read: it", "…: … Give VTK's": "is no manifest of actions",
        "Name one that you may write": "can't be made", "has a binding without a binding_url": "has a binding without a binding_url",
    },
    "VTK/Emulated/PhantomConfirmTest.cxx": {
        "CalibrateForce() is for an open real device": "Open() it and Stop() it first",
    },
    "VTK/Scene/Interaction/StyleVolumesTest.cxx": {
        "Cure: TouchVolume() with the vtkMultiVolume": "Cure: TouchVolume() with the vtkMultiVolume, or",
        "Cure: SetMapper() of the vtkVolume, and SetInputData()": "Cure: SetMapper() of the vtkVolume",
        "TouchVolume() of the interactor style with a vtkVolume that is there": "Cure: TouchVolume() of the interactor style",
    },
    "VTK/Scene/Interaction/HapticWidgetTest.cxx": {
        "with the window's vtkRenderWindowInteractor before On()": "SetInteractor()",
        "add a visible vtkVolume whose mapper has an input": "add a visible vtkVolume",
        "The widget is off. Cure: On()": "Cure: On()", "needs a device. Cure:": "needs a device",
        "needs a filter, which says how volumes feel": "needs a filter",
        "of a renderer of the window, and VisibilityOn()": "of a renderer of the window",
        "DrawHaptics() of this style 60 times a second": "Cure: call DrawHaptics()",
    },
    "VTK/Scene/Interaction/StyleMeasureTest.cxx": {"touch the volume where you want to measure": "Nothing is touched"},
    "VTK/Device/RegionTest.cxx": {
        "Connect the whole volume to the filter, Publish() it": "can't be recorded",
        "Stop() the recorder first": "Stop() the recorder first",
    },
    "VTK/Device/TwoHandsTest.cxx": {"Record the hand with the tool, or put the tool away with SetTool(nullptr)": "SetTool(nullptr)"},
    "VTK/Scene/Interaction/StyleSecondHandTest.cxx": {
        "Open() another vtkHapticDevice for the other hand": "Open() another vtkHapticDevice",
        "Touch a moving volume with one device": "Touch a moving volume with one device",
    },
    "VTK/Device/ObserversTest.cxx": {"replaced while it was being started: Start() again": "Start() again"},
    "VTK/Device/AttentionTest.cxx": {"longer than AttentionTime. Arm() again": "Arm() again"},
    "VTK/Device/StatusTest.cxx": {"leave it, or press deeper": "feels soft"},
    "Applications/Explorer/TestTouchKept.cxx": {
        "the measurements of this window first, then F11": "the measurements of this window first, then F11",
    },
    "Data/Formats/write_images.py": {
        "Copy all files of the stack into one folder": "is missing", "Write all slices alike": "pages of several sizes or types",
        ", which has …. Check that its copy is complete": "names page",
        "has … components, and none with the number …": "and none with the number", "has tracts, which": "has tracts",
    },
    "Data/Formats/write_brain.py": {
        "is no file of FreeSurfer, whatever its name says": "no file of FreeSurfer",
        "its header is damaged or cut off. Check that": "header is damaged or cut off",
        "it is no MINC file, whatever its name says": "it is no MINC file", "it has no image, and is no MINC": "it has no image",
        "the dimensions xspace, yspace and zspace": "does not have the dimensions xspace",
    },
    "Data/Formats/write_dicom.py": {
        "has … segments, and none with the number …": "and none with the number",
        "voxels are in several segments: they belong to the one with the highest number": "voxels are in several segments",
    },
    "Data/Formats/write_odd.py": {
        "instead of values in …export it again as grey values": "PALETTE COLOR", "has a NumPy array": "NumPy array",
        "is a MATLAB file": "MATLAB file", "is a density map (MRC)": "density map",
        "is a microscope's own format": "microscope's own format", "has no header: neither": "has no header",
        "is HDF5, of which only VTKHDF": "is HDF5", "is a CIFTI file, whose": "CIFTI",
        "Write it with these axes last": "as the last ones", "and the first page has its own. Take that page away": "the first page has its own",
    },
    "Applications/Explorer/TestExploreInputErrors.cxx": {
        "put a file in its place, or choose another folder": "is a folder without DICOM slices, but",
    },
    "Data/Formats/write_nifti.py": {"has … volumes along its fourth axis, and none with the number": "and none with the number"},
    "Data/Formats/write_threads.py": {
        "it is a collection of …": "collection of", "masks, and none with the number": "masks, and none with the number",
        "has a different grid from the mask": "has a different grid from the mask",
        "is not a mask, unlike the others in its folder": "is not a mask, unlike the others",
    },
    "Data/Formats/TestFormats.py": {
        "is one of several files, and has …": "is one of several files, and has ",
        "is one of several files, and is a moving volume itself": "is a moving volume itself", "is for files with arrays": "is for files with arrays",
    },
    "Python/TestLabels.py": {
        "write the volume that you mean into its own file": "into its own file",
        "There is no file name. Cure: set FileName": "set FileName",
    },
    "Python/TestExplorerCures.py": {"run the program as 'xvfb-run -a": "run the program as"},
    "Python/TestLargeCures.py": {
        "and none with the number …. Take Series = 1 to Series = ": "Take Series = 1 to Series = ",
        "it has one volume only, which needs no number. Leave Series out": "which needs no number. Leave Series out",
        "Close it there; if its writer has ended, run h5clear -s FILE": "run h5clear -s FILE",
        "Convert it with h5repack --high=2 IN OUT": "--high=",
    },
    "Python/TestRegionCures.py": {
        "Read a smaller one": "Read a smaller one", "bytes. Lower MemoryLimit": "bytes. Lower MemoryLimit",
    },
    "VTK/Material/Labels/SegmentationReaderTest.cxx": {"damaged or truncated. Check that the file is complete": "Check that the file is complete"},
    "VTK/Regions/RegionSourceTest.cxx": {'Give the path more points, or a point array "Time"': "jumps so far"},
    "Devices/Common/DeviceMemoryTest.cxx": {
        "Remove the line, then confirm and calibrate": "of the file of devices", "Check that it is a text file of at most 1 MiB": "at most 1 MiB",
    },
    "Devices/Kinds/DeviceRegistryTest.cxx": {
        "already. Choose another name": "Choose another name", "Use letters only": "Use letters only",
    },
    "Devices/Guard/GuardedDeviceTest.cxx": {
        "Open() it before or after, not in both": "forked", "Copy the file to a folder of your own": "belongs to another user",
        "Run: chmod go-w": "others may write",
    },
    "Devices/Emulated/FalconSleepTest.cxx": {"and the hand may have moved. Home() and Arm() again": "asleep"},
    "Devices/Emulated/FalconFirmwareTest.cxx": {
        "%s. Home() to try again": "Home()", "switch the device off and on, and Home() to try again": "Home()",
    },
    "Devices/Emulated/FalconFaultTest.cxx": {
        "they have lost counts. Home() and Arm() again": "out of its reach",
        "its encoders have lost counts. Home() and Arm() again": "jumped",
        "Check its cable and its power supply, then %s": "does not answer",
        "(a stall). Home() and Arm() again": "stall",
    },
    "Devices/Common/DeviceReturnTest.cxx": {"is back with other limits than before. Open() and Start() it": "other limits"},
    "Devices/Emulated/FalconUnplugTest.cxx": {"Plug it in again: it is opened by itself, and waits for Arm()": "Plug it in again"},
    "Devices/Emulated/FalconGuardTest.cxx": {"Enter the time namespace first, then start the program": "time namespace"},
    "Devices/Emulated/FalconGuardEndsTest.cxx": {"watch the device. Close(), Open(), Start() and Arm() it again": "guard process"},
    "Devices/Haply/HaplySessionTest.cxx": {
        "is not calibrated: put its handle into the inkwell, or": "is not calibrated", 'Open it as "haply"': "haply",
        "update Haply's Inverse service, and start it again": "does not report its origin",
        ", whose axes are not known here. Choose …": "whose axes are not known here",
    },
    "Devices/Haply/HaplyFaultTest.cxx": {
        "closed the connection. Start it: the device is then opened by itself": "the Inverse service ended or closed the connection",
        "Set its scale to 1 in Haply's Hub": "has a scaled workspace",
        "Home() connects again": "goes on without the Inverse service's warnings",
        "does not answer. Start it again, then Home() and Arm() again": "the Inverse service does not answer",
        'give "haply", or "haply:ID"': "is not a device id", "Give the ports of the Inverse service": "Give the ports",
    },
    "Devices/Xr/XrDeviceTest.cxx": {'give "vibration:xr", which has no number': 'is not a device id: give "vibration:xr"'},
    "Devices/Hfab/HfabSessionTest.cxx": {
        "put the arm into its pose for calibration, hold it still, and press Home()": "needs to know where its arm is",
        "press the button of its controller, and press Home()": "press the button of its controller",
        "or give its port, such as \"hfab:…\".…Several": "No hfab controller is plugged in",
        "Give the port of the controller, and check its firmware": "an hfab controller does not send",
        "drives another arm now. Open() it again": "says that it drives another arm now",
        "drives another arm than before. Open() and Start() it": "drives another arm than before",
        "Press Home() and put the arm into its pose for calibration": "a jump of its arm that no hand can make",
        'give "hfab" or "hfab:PORT"': "is not a device id",
        "in use by another program or device. Close it there": "in use by another program",
        "Give the board's port, such as /dev/ttyACM0": "not a serial port",
    },
    "Devices/Vibration/VibrationSessionTest.cxx": {
        "Give the port of bHaptics' Player": "Give the port of bHaptics' Player",
        "Give the port of WEART's middleware": "Give the port of WEART's middleware",
        "Switch it on and pair it in the Player": "is connected to bHaptics' Player",
        "has ended. Start it: the device is then opened by itself": "bHaptics' Player has ended",
        "connected to bHaptics' Player. Switch it on: it is then opened by itself": "is no longer connected to bHaptics' Player",
        "or reads no more. Start it: the device is then opened by itself": "WEART's middleware has ended",
        "connected to WEART's middleware. Switch it on: it is then opened by itself": "is no longer connected to WEART's middleware",
        "Switch it on and connect it there": "for the hand ", "is not a device id. Give one of": "Give one of",
        'give "vibration:weart"': 'give "vibration:weart"', "give the address of a Hapbeat": "give the address of a Hapbeat",
        "connect it to your network by Hapbeat Studio": "No Hapbeat answers at ",
    },
    "Devices/Emulated/PadFaultTest.cxx": {
        "No gamepad is plugged in. Plug one in": "No gamepad is plugged in", "Use a pad with motors": "can't vibrate",
        "such as Steam, has grabbed it. Close it there": "in use: another program, such as Steam",
    },
    "Devices/Emulated/PidFaultTest.cxx": {"has not said yet where it is: move it a little": "move it a little"},
    "Devices/Emulated/HidClaimTest.cxx": {
        "Choose a device that EnumerateDevices() lists": "can't be used",
        "or give an id that EnumerateDevices() lists": "No device with these numbers is plugged in",
        'give "pid", or "pid:VVVV:PPPP"': 'give "pid", or "pid:VVVV:PPPP"',
        "Close it where it is open, in this program": "is in use. Close it where it is open",
        "Plug in a WoodenHaptics instead": "Plug in a WoodenHaptics instead",
    },
    "Devices/Emulated/WheelTest.cxx": {"End other programs that use it, plug it in again, and open it again": "does not accept a constant force"},
    "VTK/Emulated/PhantomFalconTest.cxx": {"the device was lost, and is back. Arm() again": "is back. Arm() again"},
    "Devices/Emulated/HidTogetherTest.cxx": {"was unplugged. Plug it in, then Open() and Start() it": "was unplugged"},
    "Devices/Emulated/WoodenFaultTest.cxx": {
        "put the arm into its rest pose, hold it still, and press Home()": "needs to know where its arm is",
        "hold the arm still in its rest pose, and press Home() again": "did not accept the pose of its arm",
    },
    "Devices/Vendor/VendorLoaderTest.cxx": {
        "as it is relative. Name the whole path": "Name the whole path",
        'give "vendor:PLUGIN" or "vendor:PLUGIN:N"': "is not a device id",
        "no folder is searched. Name the plug-in's folder": "no folder is searched",
        "Count from 0, as EnumerateDevices() does": "has no device",
    },
    "Devices/Vendor/VendorDriverTest.cxx": {
        "Press less for some seconds": "so that its motors don't get warm",
        "is in use by this program. Close() it there": "in use by this program",
    },
    "Applications/DeviceTool/ToolOptionsTest.cxx": {
        "takes either --weight GRAMS or --scale. Try --help": "either --weight GRAMS or --scale",
        "there is nothing to feel. Try monitor": "monitor", "are for calibrate. Try --help": "are for calibrate", "No command was given. Try --help": "No command was given",
        'There is no option "…". Try --help': "There is no option \"",
        ", and a file named .vtp or .csv…. Try --help": "a file named .vtp or .csv",
    },
    "ParaView/TestLabels.py": {"four numbers, 0 or more, or -1 to use the functions": "Label Materials"},
    "ParaView/TestShell.py": {"Choose closed polygons as Surface": "Choose closed polygons as Surface"},
    "ParaView/Live/TestLiveModes.py": {
        "Name it in this row, or leave Array empty": "Name it in this row",
        "Choose polygons or lines as Surface": "Choose polygons or lines as Surface",
        "Give the kind Guide, or choose polygons as Surface": "choose polygons as Surface",
    },
    "ParaView/Live/TestLiveArrays.py": {"Choose a point array of another type than bits": "bits"},
    "ParaView/Live/TestLiveLarge.py": {"an Input whose file is there, and arm again": "no image"},
    "ParaView/Live/TestLiveLost.py": {
        "Connect to a server again, and open the data there": "Connect",
        "Choose a RecordingFile in a folder that you may write to": "Choose a RecordingFile in a folder that you may write to",
    },
    "Devices/Vendor/OpenHapticsTest.cxx": {"lost its force: it": "lost its force: it"},
    "ParaView/Gui/session.py": {
        "is neither an image nor another grid, so it can't be felt. Select a volume in the": "can't be felt. Select a volume",
        "where the server can't read it: open it on the server": "is on this computer",
        "Nothing can be felt yet: attach a device first": "Nothing can be felt yet: attach a device first",
        "There is nothing to save yet: attach a device first": "There is nothing to save yet: attach a device first",
        "press Show as CT volume, or choose": "press Show as CT volume, or choose",
    },
    "ParaView/Live/TestLiveMemory.py": {
        "The server could not cut out what is around the tip (…). Lower MaximumRegionVoxels":
            "The server could not cut out what is around the tip (",
        "This computer has no memory for the region around the tip. Lower MaximumRegionVoxels": "This computer has no memory",
        "The server has no memory for the region around the tip. Lower MaximumRegionVoxels": "The server has no memory",
    },
    "ParaView/TestRanks.py": {"Attach the device to a render view of paraview or pvpython": "a path can be felt anywhere"},
    "ParaView/Live/TestLiveCures.py": {
        "has no kind of mode. Give one of": "has no kind of mode. Give one of", "Leave it empty": "Leave it empty",
        'Give one, or pairs such as "0 0, 0.5 2"': 'Give one, or pairs such as "0 0, 0.5 2"',
        "There is no tool": "There is no tool", "Give a number, or pairs of a scalar and a number": "Give a number, or pairs",
        "No file is chosen. Set FileName": "No file is chosen. Set FileName",
        "Set it to one whose Input is the volume": "Touch does not name a Volume Haptics filter",
        "there is nothing left to touch: set Touch": "there is nothing left to touch: set Touch",
        "was deleted. Set Touch, and Running, again": "was deleted. Set Touch, and Running, again",
        "Set View to a render view, such as GetActiveView()": "Set View to a render view",
        "Another device is attached to this view. Detach that one first": "Detach that one first",
        "Attach again when it is done": "Attach again when it is done",
        "The haptic device was deleted. Attach again with another one": "Attach again with another one",
        "The view was closed. Attach the device to another one": "Attach the device to another one",
    },
}

# Remedies that no program can apply: actions of a hand on a device, and actions outside the program. Only the names in
# these texts are checked, by test_names_in_cures_exist.
OUTSIDE = {
    "what ParaView's view, dock and panel show is looked at instead (View.two_hands, Gui)": (
        "Make another Haptic Device", "There is no first hand in this view", "choose a device and press Attach",
        "Open() and Start() it", "Open() it again", "UseToolOff() of this device"),
    "a hand plugs in, switches on, or leads a device": (
        "devices have its serial number now. Open() and Start() the one that you mean",
        "put its handle into the inkwell…available", "has no Inverse3, Inverse3x or Minverse. Plug one in",
        "is being calibrated: hold its arm still", "Plug the controller in, or give its port",
        "The DualSense is no longer connected. Plug it in", "Press its PS button", "Check its cable or battery", "Check its cable, then Home()", "Check its cable and its firmware",
        "Check its cable and firmware", "Check its cable and its power, then", "Check its power, its encoders",
        "no longer connected. Plug it in, or switch it on", "can't be used: …. Plug it in again",
        "plug it in again, then Open() and Start() it", "No SpaceMouse is plugged in. Plug it in, or its receiver",
        "It may be a model that is not known yet. Plug it in again", "unplugged. Plug it in again",
        "is no longer plugged in. Plug it in and open it again", "Plug it in again, then open it",
        "Plug it in, or give the port that it has", "it is no longer plugged in. Plug it in again",
        "Unplug it, plug it in again, and look into the system's log", "is plugged in. Plug it in, and switch its power on",
        "Hold the handle in the middle of the workspace", "Put a kitchen scale", "Take your hand away, and keep the weight",
        "Take your hand away, and see that it stands", "Put the scale under it",
        "hold it loosely and keep the hand still. For about ten seconds", "is gone. Plug it in, Open() and Start() it",
        "Hold the device loosely and keep the hand still, then Arm() again", "Check the image and the device, then Arm() again",
        "Take the stylus, then Arm() again", "Check its battery and the network", "Check its axes, lower the stiffness, then Arm() again",
        ": hold it loosely and keep the hand still. The volume is not felt yet",
    ),
    "a program of others, which Debian does not have or which reads what is not written here": (
        "convert it to NIfTI with 3dAFNItoNIFTI", "convert it to NIfTI with dcm2niix", "with nibabel: nib.save(", "mri_convert in.mgz out.mgz",
        "mincconvert in.mnc out.mnc", "mincresample in.mnc out.mnc", "convert them to NIfTI with dcm2niix", "export the series again without compression",
        "convert it to labels first, e.g. with plastimatch convert or 3D Slicer", "write it as a DICOM SEG, or as .seg.nrrd",
        "resample it on the grid of its volume, e.g. in 3D Slicer", "export it again from the planning system",
        "a segmentation (SEG) that ends before its pixels…copy or export it again",
        "a damaged or truncated DICOM file…copy or export it again",
    ),
    "another program, or the system, is started, ended or set up": (
        "does not list the connected devices. Update it", "WEART's middleware closed the connection. Start it again",
        "does not list its devices. Start it again", "Haply's Inverse service …. Start it again",
        "is in use by another program. Close that program", "service closed the connection. Start it again",
        "to whose user the system gives game controllers", "sudo usermod -a -G dialout", "then run \"sudo udevadm control --reload\"",
        "or opened a second time by this one. Close it there", "Start the one of your headset",
        "Check its permissions", "Check the permissions of its folder and the space on its disk",
        "Close other programs that need memory", "Record to a local disk, with less else running",
        "three of them are needed. Use a smaller image", "Close what else is open, or set the functions by hand",
        "Crop it, or free some memory", "Cure: free some, or read it by regions", "check that the disk is not full and that you may write to the folder", "check that the disk is not full, the folder exists",
        "Make room on its disk, or choose a RecordingFile on another one", "check the space on the disk",
        "start PulseAudio or PipeWire", "make it readable, or copy or export the series again",
        "no longer exists…choose the folder of its series", "crop the data to feel more",
        "End other programs, or raise the limits of threads and memory",
        "check the disk that it is on", "check that it may be read by you", "can't be renamed (…). Remove it",
        "can't be read (…). Remove it", "is of the process that this one was forked from: stop it there",
        "it changed while it was read. Read it again", "install rtkit or raise the user's rtprio limit",
        "log in at the computer itself or raise the user's rtprio limit", "raise the user's memlock limit",
        "End threads of this program, or raise its limits (ulimit -u)", "Close files or end threads of this program",
        "set HOME, or VOLUMEHAPTICS_DEVICES to the name of a file",
    ),
    "the system is Windows": (
        "Take the right to write it from them (Properties, Security)", "Give the board's port, such as COM3",
        "convert it to NIfTI or NRRD, e.g. with dcm2niix or 3D Slicer",
    ),
    "something is built or installed": (
        "Build it with -D…=ON", "Update its firmware to 1.16.5 or later",
        "Build one against the vendor's SDK", "Install the vendor's SDK", "Build it again with the VendorPlugin.h",
        ". Build it (Examples/Vendor)", "Link VTK::RenderingContextOpenGL2",
        "build it with a VTK that has the module IOOggTheora", "build it from its sources with the package libpulse-dev",
        "build it with GDCM (package libgdcm-dev)", "Build it with c-blosc (package libblosc-dev)", "Build it with zstd (package libzstd-dev)", "convert it to NIfTI, e.g. with dcm2niix", "Update VTK Volume Haptics",
        "Load VolumeHapticsPlugin on the server, too", "Load the same VolumeHapticsPlugin there as here",
        "Use a client and a server of the same version",
        "derive it from one of the module's tools",
        "Give the interactor the manifest that WriteActions() makes", "this library with that VTK and -DVolumeHaptics_USE_OPENXR=ON",
    ),
}

# Texts that the scan mistakes for remedies.
NONE = (
    "HapticTouch…Touch with the mouse", "Loads functions from a file", "Saves what is felt now to a file", "HapticShowAsCT…Show as CT volume",
    "Load a preset…Presets", "Save the preset…Presets", "Record to…Traces", "no active scalars: point array",
    ": ….\\n  Cure: ….", "A is kept. Change something", "Arm with an hfab controller, if it is one", "Put the pointer on the volume and press", "The hand is outside the view",
    "choose one of them", "propose functions; take them",
    # Commands of the explorer's bar and menu, and the file dialog.
    "Touch…t…touch what is under the pointer", "RemoveLast…Delete…", "Record…Record a movie", "kdialog…--title",
    "Touch…hold the hand where it is", "…hold: click where the hand", "Tool…save the track", "File…save measurements",
    "Preset…save the materials", "File…open a file", "File…show as labels",
)

# Splits a source into texts: the string literals between semicolons and braces form one text.
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"((?:\\.|[^"\\\n])*)"|\'(?:\\.|[^\'\\])+\'|[;{}]|\S', re.S)
# Verbs that begin a remedy, after a sentence that describes the fault.
CURE = re.compile(
    r"Cure: |([.;:)] |\u2026 ?)(update|make|give|set|call|use|take|name|write|choose|convert|check|pass|close|replace|remove|add"
    r"|correct|run|save|open|copy|connect|put|end|read|start|stop|smooth|turn|raise|lower|plug|change|leave|resample"
    r"|extract|show|load|attach|detach|record|build|derive|touch|crop|hold|home|arm|link|log|move|point|switch|unplug"
    r"|try|wait|enter|press|export|install|increase|reduce|startrecording)[ :(]", re.IGNORECASE)


def texts_of(source):
    parts = []
    for token in TOKEN.finditer(source):
        word = token.group(0)
        if word in (";", "{", "}"):
            yield "".join(parts)
            parts = []
        elif token.group(1) is not None:
            parts.append(token.group(1).replace('\\"', '"'))
        elif not word.startswith(("//", "/*")) and parts and parts[-1] != "\u2026":
            parts.append("\u2026")


def find_cures(root, folder):
    """Yields each text that names a cure, with its file."""
    for file in sorted((root / folder).rglob("*")):
        if file.suffix in (".cxx", ".h") and not file.stem.endswith(("Settings", "SettingLists")):
            for text in texts_of(file.read_text(encoding="utf-8")):
                if CURE.search(text):
                    yield file.relative_to(root).as_posix(), text


MODULES = TestCallCures, TestBakingCures, TestFileCures, TestRegionCures, TestSceneCures
FOLDERS = ("Module/Core", "Module/VTK", "Module/Devices", "Module/Applications", "Plugin")
TEXTS = [one for folder in FOLDERS for one in find_cures(ROOT, folder)]


def test_each_cure_is_tried():
    tried = [word for module in (TestFilterCures, TestBakingCures) for word in module.case]
    tried += [word for words in TestLargeCures.FILES for word in words] + list(TestLargeCures.CONVERTED)
    tried += [*TestFileCures.TABLES, *TestSceneCures.SHOWN, *TestShownAndTold.TOLD]
    tried += [word for module in MODULES for words in module.result for word in words]
    tried += [words for _, words, _ in (*TestExplorerCures.OPTIONS, *TestExplorerCures.COMMANDS)
              if not words.endswith(("is not an option", "needs a value"))]  # help is the cure of these errors
    tried += [word for tests in TRIED.values() for word in tests]
    tried += [word for words in OUTSIDE.values() for word in words] + [*NONE]
    found, left = set(), []
    for file, text in TEXTS:
        entries = [word for word in tried if word in text]
        found.update(entries)
        if not entries:
            left.append(f"{file}: {text}")
    assert not set(tried) - found, ("no error has these words", set(tried) - found)
    assert not left, "try it above, or say why it can't be tried"


def strings_of(file):
    if file.suffix == ".py":
        return [file.read_text(encoding="utf-8")]
    return [part for text in texts_of(file.read_text(encoding="utf-8")) for part in text.split("…")]


def test_tests_look_for_what_is_tried():
    """Each named test looks for the words of the error text, or for words around them."""
    for test, tried in TRIED.items():
        strings = strings_of(ROOT / "Testing" / test)
        for words, looked_for in tried.items():
            assert any(looked_for in string for string in strings), (test, looked_for)
            assert any(words in text and looked_for in text for _, text in TEXTS), (words, looked_for)


# Names that are defined elsewhere: an array, a header and a module of VTK, and a function of ParaView's Python; options
# of other programs; files.
ELSEWHERE = "vtkGhostType", "vtkRenderingContext2DModule", "vtkRenderingContextOpenGL2", "GetActiveView"
OTHERS = {"--high": "h5repack", "--reload": "udevadm", "LD_LIBRARY_PATH": "ld.so"}
FILES = ("Data/udev/70-volume-haptics.rules", "Module/Devices/Vendor/VendorPlugin.h", "Examples/Vendor", "Examples/explore.sh",
         "Documentation/devices.md")


def test_names_in_cures_exist():
    """Classes, methods, options and variables that error texts name exist."""
    sources = "".join(file.read_text(encoding="utf-8") for suffix in ("*.h", "*.cxx", "*.xml") for folder in ("Module", "Plugin")
                      for file in (ROOT / folder).rglob(suffix))
    words = set(re.findall(r"\w+", re.sub(r'"(\\.|[^"\\\n])*"', '""', sources)))
    quoted = set(re.findall(r'"([-A-Z_a-z]+)"', sources))
    classes = [one for module in (vtk, volumehaptics) for one in vars(module).values() if isinstance(one, type)]
    unknown = set()
    for file, text in TEXTS:
        for name in re.findall(r"\bvtk[A-Z]\w+|\b[A-Z]\w+(?=\()|(?<=::)\w+", text):
            if name not in words and name not in ELSEWHERE and not any(hasattr(one, name) for one in (vtk, *classes)):
                unknown.add((name, file))
        for name in re.findall(r"(?<![\w-])--[a-z][\w-]+|\bVOLUMEHAPTICS_\w+|\bLD_\w+", text):
            if name not in quoted and name not in OTHERS:
                unknown.add((name, file))
    assert not unknown
    texts = " ".join(text for _, text in TEXTS)
    for file in FILES:
        assert (ROOT / file).exists() and file.rpartition("/")[2] in texts, file


# Packages of Debian 12 in the texts, with the programs that the texts name (checked with `dpkg --contents`), and
# projects of PyPI (checked with `pip index versions`).
DEBIAN = {"libpulse-dev": (), "libblosc-dev": (), "libzstd-dev": (), "libgdcm-dev": (), "dcm2niix": ("dcm2niix", ),
          "python3-numpy": (), "rtkit": (), "hdf5-tools": ("h5repack", "h5clear"), "xvfb": ("xvfb-run", ), "passwd": ("usermod", ),
          "udev": ("udevadm", )}
PYPI = {"numpy", "pyvista", "zarr", "h5py", "vtk", "trame", "trame-vuetify", "trame-rca", "nest_asyncio2"}
# Packages that the texts mention by a program, or without the word "package".
UNTOLD = {"rtkit", "hdf5-tools", "xvfb", "passwd", "udev"}, {"h5py"}


def test_packages_in_cures_exist():
    python = [text for file in sorted(Path(volumehaptics.__file__).parent.glob("*.py"))
              for text in TestCures.texts_of(ast.parse(file.read_text(encoding="utf-8")))]
    texts = "\n".join([text for _, text in TEXTS] + python)
    named = re.findall(r"\((?:package )?([a-z][a-z0-9.+-]+)\)|with the package ([a-z][a-z0-9.+-]+)", texts)
    debian = {name for names in named for name in names if name in DEBIAN or "-" in name and "volumehaptics" not in name}
    debian |= {name.rstrip(".") for names in re.findall(r"apt-get install ([\w.+ -]+)", texts) for name in names.split()}
    pypi = {name for names in re.findall(r"pip install ([\w -]+)", texts) for name in names.split()}
    assert debian == set(DEBIAN) - UNTOLD[0] and pypi == PYPI - UNTOLD[1]
    for word in (*UNTOLD[1], *(UNTOLD[0] & {"rtkit"}), *(program for programs in DEBIAN.values() for program in programs)):
        assert re.search(rf"\b{word}\b", texts), word
    release = Path("/etc/debian_version")
    if release.exists() and release.read_text(encoding="ascii").startswith("12.") and shutil.which("apt-cache"):
        found = subprocess.run(["apt-cache", "pkgnames"], capture_output=True, text=True, check=True).stdout.split()
        # Without downloaded package lists, apt-cache knows the installed packages only.
        assert "paraview-dev" not in found or set(DEBIAN) <= set(found), set(DEBIAN) - set(found)
