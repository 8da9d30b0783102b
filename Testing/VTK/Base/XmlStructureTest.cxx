// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests modified files in VTK's XML formats. Unless such files are refused first, VTK's own reader
 * would end the program, or write outside its memory.
 */

#include "Rigs/TemporaryFolder.h"

#include "VTK/Base/XmlFiles.h"
#include "VTK/Base/XmlStructure.h"

#include <gtest/gtest.h>
#include <vtkBitArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

namespace
{

constexpr int Modes[] = { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended };

std::string Load(const std::string& file)
{
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void Save(const std::string& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary) << bytes;
}

class XmlStructure : public testing::Test
{
protected:
  XmlStructure()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(6);
    sphere->SetPhiResolution(5);
    sphere->Update();
    this->Shape->DeepCopy(sphere->GetOutput());
    vtkNew<vtkStringArray> names;
    names->SetName("Names");
    for (vtkIdType i = 0; i < this->Shape->GetNumberOfPoints(); ++i)
    {
      names->InsertNextValue("point " + std::to_string(i));
    }
    this->Shape->GetPointData()->AddArray(names);
    vtkNew<vtkBitArray> bits;
    bits->SetName("Bits");
    for (vtkIdType i = 0; i < this->Shape->GetNumberOfPoints(); ++i)
    {
      bits->InsertNextValue(static_cast<int>(i % 2));
    }
    this->Shape->GetPointData()->AddArray(bits);
    vtkNew<vtkStringArray> settings;
    settings->SetName("Settings");
    settings->InsertNextValue("Stiffness: 300 <N/m> & more\n");
    this->Shape->GetFieldData()->AddArray(settings);
  }

  std::string Write(vtkXMLWriter* writer, vtkDataObject* data, int mode, const char* ending)
  {
    std::string file = TemporaryPath("file") + ending;
    writer->SetFileName(file.c_str());
    writer->SetInputData(data);
    writer->SetDataMode(mode);
    writer->Write();
    return file;
  }
  std::string WriteShape(int mode, int compressor = vtkXMLWriter::ZLIB)
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetCompressorType(compressor);
    writer->SetBlockSize(64); // makes several blocks per array
    return this->Write(writer, this->Shape, mode, ".vtp");
  }
  std::string WriteImage(int mode)
  {
    vtkNew<vtkRTAnalyticSource> wave;
    wave->SetWholeExtent(-2, 2, 0, 3, 5, 7);
    wave->Update();
    vtkNew<vtkXMLImageDataWriter> writer;
    return this->Write(writer, wave->GetOutput(), mode, ".vti");
  }
  /// Reads a file as the readers of replays, paths, measurements and removed tissue do.
  static bool Read(const std::string& file)
  {
    if (file.back() == 'i')
    {
      vtkNew<vtkXMLImageDataReader> reader;
      return VolumeHaptics::ReadXmlFile(reader, file);
    }
    bool hasFailed = false;
    VolumeHaptics::ReadXmlPolyData(file, hasFailed);
    return !hasFailed;
  }
  /// Changes the file, and expects its refusal before VTK's reader opens it.
  void Refuse(const std::string& file, const std::string& from, const std::string& to)
  {
    SCOPED_TRACE(from + " -> " + to);
    const std::string good = Load(file);
    std::string text = good;
    ASSERT_NE(text.find(from), std::string::npos);
    text.replace(text.find(from), from.size(), to);
    Save(file, text);
    EXPECT_FALSE(VolumeHaptics::DetectFalseXml(file).empty());
    EXPECT_FALSE(Read(file));
    Save(file, good);
  }

  vtkNew<vtkPolyData> Shape;
};

} // namespace

TEST_F(XmlStructure, OfWhatVtkWritesIsTrue)
{
  for (const int mode : Modes)
  {
    for (const int compressor : { static_cast<int>(vtkXMLWriter::NONE),
           static_cast<int>(vtkXMLWriter::ZLIB), static_cast<int>(vtkXMLWriter::LZ4) })
    {
      const std::string file = this->WriteShape(mode, compressor);
      EXPECT_EQ(VolumeHaptics::DetectFalseXml(file), "") << mode << " " << compressor;
      bool hasFailed = false;
      const auto shape = VolumeHaptics::ReadXmlPolyData(file, hasFailed);
      EXPECT_FALSE(hasFailed);
      EXPECT_EQ(shape->GetNumberOfPolys(), this->Shape->GetNumberOfPolys());
    }
    EXPECT_EQ(VolumeHaptics::DetectFalseXml(this->WriteImage(mode)), "") << mode;
  }
}

TEST_F(XmlStructure, ThatLiesIsRefused)
{
  for (const int mode : Modes)
  {
    const std::string shape = this->WriteShape(mode);
    this->Refuse(shape, "NumberOfPoints=\"", "NumberOfPoints=\"-");
    this->Refuse(shape, "NumberOfPoints=\"", "NumberOfPoints=\"9");
    this->Refuse(shape, "NumberOfPolys=\"", "NumberOfPolys=\"999999999");
    this->Refuse(shape, "type=\"Float32\" Name=\"Normals\"", "type=\"String\" Name=\"Normals\"");
    this->Refuse(shape, "type=\"Float32\" Name=\"Points\"", "type=\"String\" Name=\"Points\"");
    this->Refuse(shape, "NumberOfComponents=\"3\"", "NumberOfComponents=\"4294967297\"");
    this->Refuse(shape, "NumberOfTuples=\"1\"", "NumberOfTuples=\"2\"");
    this->Refuse(shape, "type=\"PolyData\"", "type=\"ImageData\"");
    this->Refuse(shape, "</PolyData>", "");
    this->Refuse(shape, "<VTKFile", "<!DOCTYPE a [<!ENTITY b \"c\">]><VTKFile");
    const std::string image = this->WriteImage(mode);
    this->Refuse(image, "Extent=\"-2 2 ", "Extent=\"-2 99999 ");
    this->Refuse(image, "Piece Extent=\"-2 2 ", "Piece Extent=\"-2 99999 ");
    this->Refuse(image, "Piece Extent=\"-2 2 ", "Piece Extent=\"-2 1 ");
  }
  const std::string file = this->WriteShape(vtkXMLWriter::Binary);
  this->Refuse(file, "header_type=\"UInt32\"", "header_type=\"UInt64\"");
  this->Refuse(file, "LittleEndian", "BigEndian");
  this->Refuse(file, "type=\"Float32\" Name=\"Points\"", "type=\"Float64\" Name=\"Points\"");
  const std::string plain = this->WriteShape(vtkXMLWriter::Binary, vtkXMLWriter::NONE);
  this->Refuse(
    plain, "header_type=\"UInt32\"", "header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"");
}

/// The environment variable VOLUME_HAPTICS_XML_FILES sets the number of damaged files; 1000000
/// files take minutes.
TEST_F(XmlStructure, ThatIsDamagedEndsNothing)
{
  std::vector<std::string> good;
  std::vector<std::string> endings;
  for (const int mode : Modes)
  {
    for (const std::string& file : { this->WriteShape(mode, vtkXMLWriter::NONE),
           this->WriteShape(mode), this->WriteImage(mode) })
    {
      good.push_back(Load(file));
      endings.push_back(file.substr(file.size() - 4));
    }
  }
  const std::vector<std::string> words = { "-1", "0", "1", "3", "99999999", "4294967295", "nan",
    "Int8", "UInt64", "Float64", "String", "ascii", "binary", "appended", "", "offsets",
    "connectivity", "Strips", "Points", "Names" };
  std::mt19937 random(7);
  const auto below = [&random](std::size_t count) { return random() % count; };
  const char* const wanted = std::getenv("VOLUME_HAPTICS_XML_FILES");
  const int count = wanted ? std::atoi(wanted) : 3000;
  int read = 0;
  vtkObject::GlobalWarningDisplayOff(); // hides warnings about unknown information keys
  for (int i = 0; i < count; ++i)
  {
    const std::size_t which = below(good.size());
    std::string bytes = good[which];
    for (std::size_t changes = 1 + below(3) * below(2); changes > 0; --changes)
    {
      const std::size_t at = below(bytes.size());
      const std::size_t size = std::min<std::size_t>(1 + below(60), bytes.size() - at);
      const std::size_t open = bytes.find("=\"", at);
      const std::size_t shut = open == std::string::npos ? open : bytes.find('"', open + 2);
      switch (below(5))
      {
        case 0:
          bytes[at] = static_cast<char>(random());
          break;
        case 1:
          bytes.erase(at, size);
          break;
        case 2:
          bytes.insert(below(bytes.size()), bytes.substr(at, size));
          break;
        default:
          shut == std::string::npos
            ? void()
            : void(bytes.replace(open + 2, shut - open - 2, words[below(words.size())]));
      }
    }
    const std::string file = TemporaryPath("damaged") + endings[which];
    Save(file, bytes);
    read += Read(file);
  }
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_GT(read, count / 50) << "some changes are of no consequence";
  EXPECT_LT(read, count);
}
