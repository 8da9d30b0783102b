// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Reads DICOM slices of 8 bits, grey and coloured, uncompressed and as baseline JPEG. The values
// are ramps. Luminance and colour differences follow PS3.3, section C.7.6.3.1.2.
#include "Expectations.h"
#include "HeadExploration.h"
#include "PackDicom.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeSeries.h"

#include "vtkImageData.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{
constexpr int SIDE = 64, SLICES = 5; // pixels; JPEG has blocks of 8

std::string Element(unsigned group, unsigned element, const char* type, std::string value)
{
  const auto number = [](std::size_t n) {
    return std::string{ char(n & 0xff), char(n >> 8 & 0xff) };
  };
  const bool isText = type[0] != 'O' && type != std::string("UI");
  value += value.size() % 2 == 0 ? "" : isText ? " " : std::string(1, '\0');
  const std::size_t size = value.size();
  const std::string length =
    type[0] == 'O' ? number(0) + number(size & 0xffff) + number(size >> 16) : number(size);
  return number(group) + number(element) + type + length + value;
}

std::string Whole(int number)
{
  return { char(number & 0xff), char(number >> 8 & 0xff) };
}

/// Computes the colour (0 to 255) of a sample. A grey sample has the value of the red component.
void ColourAt(int i, int j, int k, double rgb[3])
{
  rgb[0] = 3.0 * i + 5.0 * k;
  rgb[1] = 2.0 * j + 40.0;
  rgb[2] = 200.0 - i - j;
}

std::string EncodeSlice(int k, const std::string& meaning)
{
  const bool isGrey = meaning == "MONOCHROME2";
  std::string pixels;
  for (int j = 0; j < SIDE; ++j)
  {
    for (int i = 0; i < SIDE; ++i)
    {
      double rgb[3];
      ColourAt(i, j, k, rgb);
      double out[3] = { rgb[0], rgb[1], rgb[2] };
      if (meaning == "YBR_FULL")
      {
        out[0] = 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
        out[1] = -0.1687 * rgb[0] - 0.3313 * rgb[1] + 0.5 * rgb[2] + 128.0;
        out[2] = 0.5 * rgb[0] - 0.4187 * rgb[1] - 0.0813 * rgb[2] + 128.0;
      }
      for (int c = 0; c < (isGrey ? 1 : 3); ++c)
      {
        pixels += static_cast<char>(std::lround(out[c]));
      }
    }
  }
  const std::string uid = "1.2.7." + std::to_string(k + 1);
  const std::string meta = Element(2, 0x0002, "UI", "1.2.840.10008.5.1.4.1.1.7") +
    Element(2, 0x0003, "UI", uid) + Element(2, 0x0010, "UI", "1.2.840.10008.1.2.1");
  const std::string size = Whole(static_cast<int>(meta.size()));
  return std::string(128, '\0') + "DICM" + Element(2, 0, "UL", size + std::string(2, '\0')) + meta +
    Element(8, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.7") + Element(8, 0x0018, "UI", uid) +
    Element(8, 0x0060, "CS", "US") + Element(0x20, 0x000e, "UI", "1.2.7") +
    Element(0x20, 0x0032, "DS", "0\\0\\" + std::to_string(2 * k)) +
    Element(0x20, 0x0037, "DS", "1\\0\\0\\0\\1\\0") +
    Element(0x28, 0x0002, "US", Whole(isGrey ? 1 : 3)) + Element(0x28, 0x0004, "CS", meaning) +
    (isGrey ? std::string() : Element(0x28, 0x0006, "US", Whole(0))) +
    Element(0x28, 0x0010, "US", Whole(SIDE)) + Element(0x28, 0x0011, "US", Whole(SIDE)) +
    Element(0x28, 0x0030, "DS", "1\\1") + Element(0x28, 0x0100, "US", Whole(8)) +
    Element(0x28, 0x0101, "US", Whole(8)) + Element(0x28, 0x0102, "US", Whole(7)) +
    Element(0x28, 0x0103, "US", Whole(0)) + Element(0x7fe0, 0x0010, "OB", pixels);
}

/// Expects the brightness of the colour ramps in a folder's volume, or the grey ramp if `isGrey`.
/// JPEG may deviate by a few grey levels (`allowed`).
void ExpectRamps(const std::string& name, bool isGrey, double allowed)
{
  const Explore::Volume volume = Explore::LoadVolumes({ folder + "/" + name });
  int size[3];
  volume.Image->GetDimensions(size);
  Expect(size[0] == SIDE && size[1] == SIDE && size[2] == SLICES &&
      volume.Image->GetNumberOfScalarComponents() == 1,
    name + " has another size");
  double worst = 0.0;
  for (int k = 0; k < std::min(size[2], SLICES); ++k)
  {
    for (int j = 0; j < std::min(size[1], SIDE); ++j)
    {
      for (int i = 0; i < std::min(size[0], SIDE); ++i)
      {
        double rgb[3];
        ColourAt(i, j, k, rgb);
        const double expected = isGrey ? rgb[0] : 0.30 * rgb[0] + 0.59 * rgb[1] + 0.11 * rgb[2];
        const double value = volume.Image->GetScalarComponentAsDouble(i, j, k, 0);
        worst = std::max(worst, std::abs(value - expected));
      }
    }
  }
  Expect(worst <= allowed, name + " is off by " + std::to_string(worst));
}

/// Writes slices and reads them back. `how` is empty for uncompressed slices; PackDicom() lists the
/// other values.
void ExpectColourSlices(
  const std::string& name, const std::string& meaning, const std::string& how, double allowed)
{
  vtksys::SystemTools::MakeDirectory(folder + "/" + name);
  for (int k = 0; k < SLICES; ++k)
  {
    const std::string at = folder + "/" + name + "/I" + std::to_string(k);
    const std::string plain =
      WriteText(how.empty() ? name + "/I" + std::to_string(k) : "plain", EncodeSlice(k, meaning));
    Expect(how.empty() || PackDicom(plain, at, how, 0.0), at + " is not written");
  }
  ExpectRamps(name, meaning == "MONOCHROME2", allowed);
}
} // namespace

int TestExploreDicomColours(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "TestExploreDicomColours");
  vtksys::SystemTools::RemoveADirectory(folder);
  vtksys::SystemTools::MakeDirectory(folder);
  ExpectColourSlices("grey", "MONOCHROME2", "", 0.0);
  // The tolerances allow for the brightness, which is truncated, and for luminance and colour
  // differences, which were rounded before.
  ExpectColourSlices("rgb", "RGB", "", 1.0);
  ExpectColourSlices("ybr", "YBR_FULL", "", 2.5);
  ExpectColourSlices("grey-jpeg", "MONOCHROME2", "baseline", 2.0);
  ExpectColourSlices("rgb-jpeg", "RGB", "baseline", 4.0);
  ExpectColourSlices("ybr-jpeg", "YBR_FULL", "baseline", 4.0);
  ExpectColourSlices("ybr-422-jpeg", "RGB", "baseline-422", 4.0);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
