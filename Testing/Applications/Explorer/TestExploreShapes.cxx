// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects the refusal of shapes and recordings whose files declare more data than they contain, or
// whose cells refer to missing points. VTK's readers and filters crash with such files. The files
// are written byte by byte, .ply after paulbourke.net/dataformats/ply, .obj after
// paulbourke.net/dataformats/obj, and the others after "VTK File Formats" (docs.vtk.org).
#include "Applications/Explorer/Exploration/ShapeFile.h"
#include "Applications/Explorer/Live/LiveRun.h"
#include "Applications/Explorer/Live/TouchReplay.h"
#include "Expectations.h"
#include "TouchedHead.h"
#include "VTK/Reading/InputError.h"

#include <stdexcept>

namespace
{
const std::string Solid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 ";

std::string Ply(const std::string& format, const std::string& points, const std::string& faces)
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + points +
    "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
    "\nproperty list uchar int vertex_indices\nend_header\n";
}

/// Returns a .vtp file with one triangle and the arrays of a recording.
std::string Vtp(
  const std::string& points, const std::string& ids, const std::string& axes, const char* force)
{
  return "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData><Piece "
         "NumberOfPoints=\"" +
    points +
    "\" NumberOfPolys=\"1\"><PointData><DataArray type=\"Float64\" Name=\"Time\" format=\"ascii\">"
    "0 1 2</DataArray><DataArray type=\"Float64\" Name=\"Force\" NumberOfComponents=\"" +
    axes + "\" format=\"ascii\">" + force +
    "</DataArray><DataArray type=\"Float64\" Name=\"Tip\" NumberOfComponents=\"3\" "
    "format=\"ascii\">0 0 0 0 0 0 0 0 0</DataArray></PointData><Points><DataArray "
    "type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray>"
    "</Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
    ids +
    "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
    "</Polys></Piece></PolyData></VTKFile>\n";
}

/// Reads a file. Expects success if `fault` is empty, otherwise a message that contains `fault`.
void ExpectShape(const std::string& name, const std::string& content, const std::string& fault)
{
  const std::string path = WriteText(name, content);
  std::string message;
  try
  {
    Explore::ReadShapeFile("--tool", path, "take another one");
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  const bool isAsExpected = fault.empty() ? message.empty()
                                          : message.find(fault) != std::string::npos &&
      message.find("Cure: take another one") != std::string::npos;
  Expect(isAsExpected, name + " says \"" + fault + "\", but says \"" + message + "\"");
}

void ExpectRecording(
  TouchedHead& head, const std::string& name, const std::string& content, const std::string& fault)
{
  const std::string path = WriteText(name, content);
  std::string message;
  try
  {
    Explore::TouchReplay(head.Touch, head.Interactor, path);
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  const bool isAsExpected =
    fault.empty() ? message.empty() : message.find(fault) != std::string::npos;
  Expect(isAsExpected, name + " says \"" + fault + "\", but says \"" + message + "\"");
}
} // namespace

int TestExploreShapes(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "ExploreShapes");
  const std::string absent = "point that does not exist", promise = "announces more elements";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string zeros(40, '\0'); // 36 bytes for three points, 4 for empty faces
  ExpectShape("good.obj", Solid + "3\n", "");
  ExpectShape("points.obj", Solid + "999999999\n", absent);
  ExpectShape("good.ply", Ply("ascii", "3", "1") + points + "3 0 1 2\n", "");
  ExpectShape("points.ply", Ply("ascii", "3", "1") + points + "3 0 1 7\n", absent);
  ExpectShape("lines.ply", Ply("ascii", "3", "2") + points + "3 0 1 2\n", promise);
  ExpectShape("words.ply", Ply("ascii", "3", "1") + points + "9 0 1 2\n", promise);
  ExpectShape("goodlittle.ply", Ply("binary_little_endian", "3", "4") + zeros, "");
  ExpectShape("short.ply", Ply("binary_little_endian", "3", "5") + zeros, promise);
  ExpectShape("list.ply", Ply("binary_big_endian", "3", "1") + zeros.substr(0, 36) + "\7", promise);
  ExpectShape("huge.ply", Ply("binary_little_endian", "2000000000", "1") + zeros, promise);
  const std::string vtk = "# vtk DataFile Version 3.0\nshape\nASCII\nDATASET POLYDATA\n";
  ExpectShape(
    "points.vtk", vtk + "POINTS 3 float\n" + points + "POLYGONS 1 4\n3 0 1 99999999\n", absent);
  ExpectShape("huge.vtk", vtk + "POINTS 900000000000 float\n" + points, "can't be read: ");
  const char* const forces = "0 0 0 0 0 0 0 0 0";
  ExpectShape("huge.vtp", Vtp("900000000000", "0 1 2", "3", forces), "can't be read: ");

  TouchedHead head(argc, argv, Explore::MapperChoice::CPU);
  ExpectRecording(head, "good.vtp", Vtp("3", "0 1 2", "3", forces), "");
  ExpectRecording(head, "points.vtp", Vtp("3", "0 1 99999999", "3", forces), absent);
  ExpectRecording(head, "wide.vtp",
    Vtp("3", "0 1 2", "9", "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0"),
    "is not a recording");
  ExpectRecording(
    head, "huge.vtp", Vtp("900000000000", "0 1 2", "3", forces), "is not a recording of a touch (");

  // Saving a recording as a table is refused, because the explorer can't read a table again.
  std::string message;
  try
  {
    Explore::RunLive(head.Exploration, folder + "/live.csv");
  }
  catch (const std::runtime_error& error)
  {
    message = error.what();
  }
  Expect(message.find("live.csv can't be read") != std::string::npos, "live: " + message);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
