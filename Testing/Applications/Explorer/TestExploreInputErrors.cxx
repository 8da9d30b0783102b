// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects one message with the fault and its remedy for every input that can't be explored.
#include "Applications/Explorer/Live/ToolFile.h"
#include "Applications/Explorer/Options.h"
#include "Applications/Explorer/Record/DemoScript.h"
#include "Applications/Explorer/Report/ReportFiles.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeSeries.h"

#include "vtkAppendFilter.h"
#include "vtkCell.h"
#include "vtkExtractVOI.h"
#include "vtkHapticProperty.h"
#include "vtkMath.h"
#include "vtkMetaImageWriter.h"
#include "vtkNIFTIImageWriter.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSTLWriter.h"
#include "vtkSphereSource.h"
#include "vtkStructuredPointsWriter.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <vtksys/SystemTools.hxx>

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>
#include <zlib.h>

#include <sys/stat.h>

namespace
{
void WriteBytes(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string ReadText(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
}

std::string Image(const std::string& name, vtkImageData* image)
{
  const std::string path = folder + "/" + name;
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
  return path;
}

/// Returns the message of the exception, or "nothing" if the action succeeds.
template <typename Action>
std::string TellRefusal(const Action& action)
{
  try
  {
    action();
    return "nothing";
  }
  catch (const Explore::InputError& error)
  {
    return error.what();
  }
}

void ExpectRefusal(const std::string& path, const std::string& fault)
{
  const std::string message =
    TellRefusal([&] { Explore::ExploreVolume(Explore::LoadVolume(path), Explore::Settings()); });
  if (message.find(fault) == std::string::npos || message.find("Cure: ") == std::string::npos ||
    message.find(path) == std::string::npos)
  {
    std::cerr << path << " should say '" << fault << "', but said: " << message << "\n";
    ++failures;
  }
}

/// Expects that a complete file is read, and that a file is refused if its end is missing or, for
/// compressed files (`isPacked`), if one byte differs. `lost` contains the numbers of bytes to cut
/// off.
void ExpectWhole(const std::string& path, const std::string& part,
  const std::vector<std::size_t>& lost, bool isPacked)
{
  Explore::LoadVolume(path);
  const std::string whole = ReadText(part);
  for (const std::size_t size : lost)
  {
    WriteBytes(part, whole.substr(0, whole.size() - size));
    ExpectRefusal(path, "Cure: ");
  }
  WriteBytes(part, whole.substr(0, whole.size() / 2));
  ExpectRefusal(path, "Cure: ");
  for (const std::size_t place : { whole.size() - 3, whole.size() / 2 })
  {
    std::string other = whole;
    other[place] = static_cast<char>(other[place] ^ 16);
    WriteBytes(part, other);
    isPacked ? ExpectRefusal(path, "Cure: ") : void();
  }
  WriteBytes(part, whole);
  Explore::LoadVolume(path);
}

/// Truncates files of VTK's writers and of gzip. For a truncated file, VTK's readers return
/// uninitialized samples.
void ExpectCutOff()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(0, 19, 0, 17, 0, 15);
  const auto write = [&wavelet](auto&& writer, const std::string& name)
  {
    const std::string path = folder + "/" + name;
    writer->SetInputConnection(wavelet->GetOutputPort());
    writer->SetFileName(path.c_str());
    writer->Write();
    return path;
  };
  const auto appended = [](auto&& writer)
  {
    writer->SetCompressorTypeToNone();
    writer->EncodeAppendedDataOff();
    return writer;
  };
  const std::vector<std::size_t> ends = { 1, 4, 8, 9 };
  const std::string meta = write(vtkSmartPointer<vtkMetaImageWriter>::New(), "cut.mha");
  ExpectWhole(meta, meta, ends, true);
  const std::string nifti = write(vtkSmartPointer<vtkNIFTIImageWriter>::New(), "cut.nii.gz");
  ExpectWhole(nifti, nifti, ends, true);
  const std::string image =
    write(appended(vtkSmartPointer<vtkXMLImageDataWriter>::New()), "cut.vti");
  ExpectWhole(image, image, { 20, 100 }, false);
  const auto oldWriter = vtkSmartPointer<vtkStructuredPointsWriter>::New();
  oldWriter->SetFileTypeToBinary();
  const std::string old = write(oldWriter, "cut.vtk");
  ExpectWhole(old, old, { 40, 100 }, false); // the bytes after the samples are not read
  // Write a NRRD file with the same samples.
  const vtkSmartPointer<vtkImageData> samples = wavelet->GetOutput();
  const std::string packed = folder + "/cut.nrrd";
  WriteBytes(packed,
    "NRRD0004\ntype: float\ndimension: 3\nsizes: 20 18 16\nencoding: gzip\nendian: little\n\n");
  const gzFile gzip = gzopen(packed.c_str(), "ab");
  gzwrite(gzip, samples->GetScalarPointer(), 20 * 18 * 16 * sizeof(float));
  gzclose(gzip);
  ExpectWhole(packed, packed, ends, true);
  // Write a grid, and a file that refers to the grid's file.
  const auto grid = appended(vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New());
  vtkNew<vtkAppendFilter> cells;
  cells->SetInputConnection(wavelet->GetOutputPort());
  grid->SetInputConnection(cells->GetOutputPort());
  const std::string cut = folder + "/cut.vtu";
  grid->SetFileName(cut.c_str());
  grid->Write();
  ExpectWhole(cut, cut, { 20, 60, 1000 }, false);
  const std::string blocks = WriteText("cut.vtm",
    "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>"
    "<DataSet index=\"0\" file=\"cut.vtu\"/></vtkMultiBlockDataSet></VTKFile>");
  ExpectWhole(blocks, cut, { 20, 60, 1000 }, false);
}

Explore::Options ParseNewtons(std::string newtons)
{
  std::string words[] = { "explore", "head.vti", "--newtons", std::move(newtons) };
  char* arguments[] = { &words[0][0], &words[1][0], &words[2][0], &words[3][0] };
  return Explore::ParseOptions(4, arguments);
}

/// Returns the volume of a closed surface of triangles that face outwards, by the divergence
/// theorem.
double ComputeVolume(vtkPolyData* surface)
{
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    double x[3][3];
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(surface->GetCell(cell)->GetPointId(i), x[i]);
    }
    volume += vtkMath::Determinant3x3(x[0], x[1], x[2]) / 6.0;
  }
  return volume;
}

/// Tests which file names --write-volume accepts.
void ExpectWrittenVolumes()
{
  const auto answer = [](const std::string& file)
  {
    std::string words[] = { "explore", "head.vti", "--write-volume", file };
    char* arguments[] = { &words[0][0], &words[1][0], &words[2][0], &words[3][0] };
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 2, 2);
    image->AllocateScalars(VTK_SHORT, 1);
    return TellRefusal(
      [&] { Explore::WriteImage(image, Explore::ParseOptions(4, arguments).WrittenVolume); });
  };
  Expect(answer("head.vtk").find("use one that ends in .vti") != std::string::npos,
    "a volume is written as .vti only");
  Expect(answer(folder + "/missing/head.vti").find("cannot be written") != std::string::npos,
    "a folder that is missing is told");
  Expect(answer(folder + "/written.VTI") == "nothing", "a volume is written");
}

/// Tests which surface files --tool accepts.
void ExpectTools()
{
  const auto expectError = [](const std::string& tool, bool isRead, const std::string& fault)
  {
    std::string words[] = { "explore", "head.vti", "--tool", tool };
    char* arguments[] = { &words[0][0], &words[1][0], &words[2][0], &words[3][0] };
    std::string message = "nothing";
    try
    {
      const Explore::Options options = Explore::ParseOptions(4, arguments);
      message = "the tool " + options.Tool;
      isRead ? void(Explore::ReadToolFile(options.Tool)) : void();
    }
    catch (const Explore::InputError& error)
    {
      message = error.what();
    }
    Expect(message.find(fault) != std::string::npos, "--tool " + tool + " gives " + message);
  };
  expectError("needle", false, "the tool needle");
  expectError("burr", false, "the tool burr");
  expectError("spoon", false, "use needle, burr, or point, or a surface that ends in .stl");
  expectError("tool.step", false, "is not known");
  expectError(folder + "/missing.stl", true, "there is no such file");
  expectError(WriteText("none.stl", "solid none\nendsolid none\n"), true, "Cure: use the closed");
  // Write a tetrahedron beside the origin. After reading, its bounding box is centred at the
  // origin.
  const auto write = [](const char* name, int count, const std::string& faces)
  {
    return WriteText(name,
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\nelement face " +
        std::to_string(count) +
        "\nproperty list uchar int vertex_indices\nend_header\n"
        "10 0 0\n13 0 0\n10 4 0\n10 0 5\n" +
        faces);
  };
  expectError(
    write("open.ply", 3, "3 0 2 1\n3 0 1 3\n3 1 2 3\n"), true, "it is open: 3 edges have a");
  const std::string file = write("tool.ply", 4, "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  const vtkSmartPointer<vtkPolyData> tool = Explore::ReadToolFile(file);
  const double* const bounds = tool->GetBounds();
  Expect(tool->GetNumberOfPolys() == 4, "a tetrahedron has four faces");
  Expect(bounds[0] == -1.5 && bounds[1] == 1.5 && bounds[3] == 2.0 && bounds[5] == 2.5,
    "a tool that does not have the origin is put around it");
  // VTK's readers of binary files ignore a missing end.
  vtkNew<vtkSphereSource> sphere;
  const std::string cut = folder + "/cut.stl", cutXml = folder + "/cut.vtp";
  vtkNew<vtkSTLWriter> writer;
  vtkNew<vtkXMLPolyDataWriter> xml;
  writer->SetInputConnection(sphere->GetOutputPort());
  xml->SetInputConnection(sphere->GetOutputPort());
  writer->SetFileName(cut.c_str());
  xml->SetFileName(cutXml.c_str());
  writer->SetFileTypeToBinary();
  xml->SetCompressorTypeToNone();
  xml->EncodeAppendedDataOff();
  writer->Write();
  xml->Write();
  for (const std::string& path : { cut, cutXml })
  {
    const std::string whole = ReadText(path);
    const vtkIdType faces = Explore::ReadToolFile(path)->GetNumberOfPolys();
    for (const std::size_t lost : { 20, 50, 100 })
    {
      WriteBytes(path, whole.substr(0, whole.size() - lost));
      expectError(path, true, "it can't be read");
    }
    WriteBytes(path, whole);
    Expect(Explore::ReadToolFile(path)->GetNumberOfPolys() == faces, path + " is read again");
  }
  // The volume is 3 * 4 * 5/6, regardless of the orientation of the file's triangles.
  const std::string inward = write("inward.ply", 4, "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 0 2 3\n");
  for (const std::string& name : { file, inward })
  {
    Expect(std::abs(ComputeVolume(Explore::ReadToolFile(name)) - 10.0) < 1e-5,
      "the triangles of " + name + " face outwards");
  }
}

/// Tests --newtons, a stick's force along its two axes, with valid and invalid texts.
void ExpectNewtons()
{
  const auto isRead = [](const char* text, double x, double y)
  {
    const std::array<double, 2> newtons = ParseNewtons(text).Device.Newtons;
    if (newtons[0] != x || newtons[1] != y)
    {
      std::cerr << "--newtons " << text << " is " << newtons[0] << ", " << newtons[1] << "\n";
      ++failures;
    }
  };
  isRead("2.5", 2.5, 2.5);
  isRead("2.5,0", 2.5, 0.0);
  isRead("-3,4", -3.0, 4.0);
  for (const char* const wrong : { "", "2,", ",2", "1,2,3", "101", "1,nan", "strong" })
  {
    const std::string message = TellRefusal([&] { ParseNewtons(wrong); });
    if (message.find("as in 2.5,0 for a wheel") == std::string::npos)
    {
      std::cerr << "--newtons '" << wrong << "' said: " << message << "\n";
      ++failures;
    }
  }
}
/// Tests the options for demonstrations and for files that the window writes: option, value,
/// expected error.
void ExpectWindowFiles()
{
  const auto isRefused = [](std::string option, std::string value, const std::string& wanted)
  {
    std::string words[] = { "explore", "head.vti", std::move(option), std::move(value) };
    char* arguments[] = { &words[0][0], &words[1][0], &words[2][0], &words[3][0] };
    const std::string message = TellRefusal([&] { Explore::ParseOptions(4, arguments); });
    if (message.find(wanted) == std::string::npos || message.find("Cure: ") == std::string::npos)
    {
      std::cerr << words[2] << " '" << words[3] << "' said: " << message << "\n";
      ++failures;
    }
  };
  isRefused("--measurements", "head.txt", "ends in .csv, .vtp or .mrk.json");
  isRefused("--measurements", "head.txt", "has an unknown extension");
  isRefused("--movie", "head.mp4", "ends in .ogv");
  isRefused("--script", folder + "/missing.txt", "check its path");
  isRefused("--script", "/dev/zero", "zero is a device or a socket, not a file");
  const auto isNoScript = [&isRefused](const std::string& text, const std::string& wanted)
  { isRefused("--script", WriteText("demo.txt", text), wanted); };
  isNoScript("0.5 move 0.5 0.5\n\n0.4 key t\n", "line 3: '0.4' is not a time");
  isNoScript("soon key t\n", "line 1: 'soon' is not a time");
  isNoScript("1 jump\n", "'jump' is not an event");
  isNoScript("1 move 0.5\n", "two fractions of the window");
  isNoScript("1 move 0.5 1.5\n", "two fractions of the window");
  isNoScript("1 stroke 0.5 0.5\n", "a duration in seconds");
  isNoScript("1 wheel 1.5\n", "a whole number of steps");
  isNoScript("# a comment\n1 key\n", "line 2: it has no valid event");
  isNoScript("1 press middle\n", "takes left or right");
  isNoScript("1 key t now\n", "'now' is one word too many");
  const std::vector<Explore::DemoEvent> events = Explore::ReadDemoScript(WriteText(
    "demo.txt", "# t\n0.5 move 0.25 0.5 # here\n\n2 wheel -3\n2 stroke 1 0 1.5\n9 key q\n"));
  using Kind = Explore::DemoEvent::Kind;
  if (events.size() != 4 || events[0].Time != 0.5 || events[0].Place[0] != 0.25 ||
    events[1].What != Kind::Wheel || events[1].Steps != -3 || events[2].Duration != 1.5 ||
    events[3].What != Kind::Key || events[3].Name != "q")
  {
    std::cerr << "A script was read wrongly.\n";
    ++failures;
  }
}
/// Tests a user's preset file, and files that are not presets.
void ExpectPresetFiles(vtkImageData* head)
{
  const std::string volume = Image("preset.vti", head);
  vtkNew<vtkHapticProperty> own;
  own->ApplyPreset("CT contrast");
  own->GetStiffness()->RemoveAllPoints();
  own->GetStiffness()->AddPoint(0.0, 321.0);
  const std::string file = folder + "/own.json";
  own->WritePreset(file.c_str());
  Explore::Settings settings;
  settings.Preset = file;
  const Explore::Exploration explored =
    Explore::ExploreVolume(Explore::LoadVolume(volume), settings);
  if (explored.Filter->GetProperty()->GetStiffness()->GetValue(100.0) != 321.0 ||
    explored.Materials != file)
  {
    std::cerr << "--preset " << file << " is not what is felt.\n";
    ++failures;
  }
  for (const auto& [wrong, words] :
    { std::pair<std::string, const char*>{ folder + "/missing.json", "Choose a file that exists" },
      { WriteText("cut.json", "{\"Format\": \"VTK Volume Haptics preset\","), "not JSON" },
      { "no preset", "or a file that ends in .json" } })
  {
    settings.Preset = wrong;
    const std::string message =
      TellRefusal([&] { Explore::ExploreVolume(Explore::LoadVolume(volume), settings); });
    if (message.find(words) == std::string::npos || message.find("Cure: ") == std::string::npos ||
      message.find("--preset") != 0)
    {
      std::cerr << "--preset '" << wrong << "' said: " << message << "\n";
      ++failures;
    }
  }
}

/// Expects a note about the component that is used: the brightness of colours, otherwise the first
/// component.
void ExpectComponents(int type, int components, const std::string& told, double first)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(6, 6, 6);
  image->AllocateScalars(type, components);
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  for (vtkIdType p = 0; p < values->GetNumberOfTuples(); ++p)
  {
    for (int c = 0; c < components; ++c)
    {
      values->SetComponent(p, c, p == 0 ? 50.0 * (c + 1) : 7.0);
    }
  }
  const Explore::Volume volume = Explore::LoadVolume(Image("components.vti", image));
  vtkDataArray* const used = volume.Image->GetPointData()->GetScalars();
  bool isTold = false;
  for (const std::string& note : volume.Notes)
  {
    isTold = isTold || note.find(told) != std::string::npos;
  }
  Expect(isTold, "'" + told + "' is not told");
  Expect(used->GetNumberOfComponents() == 1 && used->GetComponent(0, 0) == first,
    told + ", but the first value is " + std::to_string(used->GetComponent(0, 0)));
}

/// Passes a pipe, which would block a reader for ever, and an endless device wherever a file can be
/// named, also inside another file. ctest's time limit fails this test if either is opened.
void ExpectPipesAreRefused()
{
  const std::string pipes = folder + "/pipes";
  vtksys::SystemTools::RemoveADirectory(pipes);
  vtksys::SystemTools::MakeDirectory(pipes);
  const auto makePipe = [](const std::string& path)
  {
    vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetFilenamePath(path));
    if (mkfifo(path.c_str(), 0600) != 0)
    {
      std::cerr << path << " can't be made.\n";
      ++failures;
    }
    return path;
  };
  const auto refuse = [](const std::string& path, const std::string& fault)
  {
    const std::string message = TellRefusal([&] { Explore::LoadVolumes({ path }, false); });
    if (message.find(fault) == std::string::npos || message.find("Cure: ") == std::string::npos)
    {
      std::cerr << path << " should say '" << fault << "', but said: " << message << "\n";
      ++failures;
    }
  };
  for (const char* const ending : { ".nii", ".nii.gz", ".hdr", ".img", ".mha", ".mhd", ".nrrd",
         ".nhdr", ".vti", ".vtu", ".vtm", ".vtk", ".pvd", ".tif", ".dcm", ".case", ".foam", ".h5" })
  {
    refuse(makePipe(pipes + "/pipe" + ending), "is a pipe, not a file");
    const std::string device = pipes + "/zero" + ending;
    vtksys::SystemTools::CreateSymlink("/dev/zero", device);
    refuse(device, "is a device or a socket, not a file");
  }
  const auto write = [&pipes](const std::string& name, const std::string& text)
  {
    const std::string path = pipes + "/" + name;
    vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetFilenamePath(path));
    WriteBytes(path, text);
    return path;
  };
  const std::string meta =
    "NDims = 3\nDimSize = 8 8 8\nElementType = MET_UCHAR\nElementDataFile = ";
  makePipe(pipes + "/meta/pipe.raw");
  refuse(write("meta/one.mhd", meta + "pipe.raw\n"), "pipe.raw is a pipe");
  refuse(write("meta/list.mhd", meta + "LIST\npipe.raw\n"), "pipe.raw is a pipe");
  refuse(
    write("meta/one.nhdr",
      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 8 8 8\nencoding: raw\ndata file: pipe.raw\n"),
    "regular file");
  // Replace each of the two files by the pipe.
  vtkNew<vtkRTAnalyticSource> wavelet;
  vtkNew<vtkNIFTIImageWriter> nifti;
  nifti->SetInputConnection(wavelet->GetOutputPort());
  nifti->SetFileName(write("pair/one.img", "").c_str());
  nifti->Write();
  vtksys::SystemTools::RemoveFile(pipes + "/pair/one.img");
  makePipe(pipes + "/pair/one.img");
  refuse(pipes + "/pair/one.hdr", "one.img is a pipe");
  vtksys::SystemTools::RemoveFile(pipes + "/pair/one.hdr");
  write("pair/other.img", std::string(512, ' '));
  makePipe(pipes + "/pair/other.hdr");
  refuse(pipes + "/pair/other.img", "other.hdr is a pipe");
  makePipe(pipes + "/xml/pipe.vti");
  refuse(write("xml/one.pvd",
           "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" file=\"pipe.vti\"/>"
           "</Collection></VTKFile>"),
    "is a pipe");
  refuse(write("xml/one.vtm",
           "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>"
           "<DataSet index=\"0\" file=\"pipe.vti\"/></vtkMultiBlockDataSet></VTKFile>"),
    "pipe.vti is a pipe");
  makePipe(pipes + "/ensight/pipe.geo");
  refuse(write("ensight/one.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: pipe.geo\n"),
    "pipe.geo is a pipe");
  makePipe(pipes + "/foam/system/controlDict");
  refuse(write("foam/one.foam", ""), "controlDict is a pipe");
  makePipe(pipes + "/slices/1.dcm");
  makePipe(pipes + "/named/2");
  refuse(pipes + "/slices", "is a folder without DICOM slices, but 1.dcm is a pipe");
  refuse(pipes + "/named", "is a folder without DICOM slices, but 2 is a pipe");
  makePipe(pipes + "/stack/1.tif");
  makePipe(pipes + "/stack/2.tif");
  refuse(pipes + "/stack", ".tif is no regular file");
  write("one.zarr/.zarray",
    R"({"zarr_format": 2, "shape": [8, 8, 8], "chunks": [8, 8, 8], "dtype": "|u1", "order": "C",
        "compressor": null, "filters": null, "fill_value": 0})");
  makePipe(pipes + "/one.zarr/0.0.0");
  refuse(pipes + "/one.zarr", "0.0.0 is no regular file");
}
} // namespace

int TestExploreInputErrors(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "ExploreInputErrors");
  vtksys::SystemTools::MakeDirectory(folder + "/empty");
  const vtkSmartPointer<vtkImageData> head = LoadHead(argc, argv);

  ExpectNewtons();
  ExpectWrittenVolumes();
  ExpectWindowFiles();
  ExpectTools();
  ExpectCutOff();
  ExpectPresetFiles(head);
  // 0.30 red + 0.59 green + 0.11 blue = 15 + 59 + 16.5 = 90.5, which a byte stores as 90.
  ExpectComponents(VTK_UNSIGNED_CHAR, 3, "colours: their brightness is used", 90.0);
  ExpectComponents(VTK_UNSIGNED_CHAR, 4, "colours: their brightness is used", 90.0);
  ExpectComponents(VTK_SHORT, 2, "2 components per voxel: component 0 used", 50.0);
  ExpectPipesAreRefused();
  ExpectRefusal(folder + "/missing.vti", "no such file");
  ExpectRefusal(folder + "/empty", "without DICOM slices");
  ExpectRefusal(WriteText("notes.txt", "hello"), "unknown extension");
  ExpectRefusal(WriteText("slice.dcm", "hello"), "is not a DICOM slice");
  ExpectRefusal(WriteText("nothing.nrrd", ""), "is empty");
  for (const char* name : { "text.vti", "text.mha", "text.nii", "text.nii.gz", "text.nrrd" })
  {
    ExpectRefusal(WriteText(name, "this is not an image\n"), "whatever its name says");
  }
  const std::string header = "ObjectType = Image\nNDims = 3\nDimSize = 9 9 9\nElementType = "
                             "MET_SHORT\nElementSpacing = 1 1 1\nElementDataFile = ";
  ExpectRefusal(WriteText("headless.mhd", header + "missing.raw\n"), "is missing");
  ExpectRefusal(WriteText("short.mha", header + "LOCAL\nxyz"), "ends before the last voxel");
  ExpectRefusal(WriteText("short.nrrd",
                  "NRRD0004\ntype: short\ndimension: 3\nsizes: 9 9 9\nencoding: raw\n"
                  "endian: little\n\nxyz"),
    "ends before the last voxel");

  vtkNew<vtkImageData> bare;
  bare->CopyStructure(head);
  ExpectRefusal(Image("bare.vti", bare), "has no scalars");
  vtkNew<vtkImageData> uniform;
  uniform->DeepCopy(head);
  uniform->GetPointData()->GetScalars()->Fill(7.0);
  ExpectRefusal(Image("uniform.vti", uniform), "is uniform");
  vtkNew<vtkExtractVOI> slice;
  slice->SetInputData(head);
  slice->SetVOI(0, 63, 0, 63, 30, 30);
  slice->Update();
  ExpectRefusal(Image("slice.vti", slice->GetOutput()), "single slice (64 x 64 x 1 voxels)");
  slice->SetVOI(0, 63, 0, 63, 30, 32);
  slice->Update();
  ExpectRefusal(Image("thin.vti", slice->GetOutput()), "too thin");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
