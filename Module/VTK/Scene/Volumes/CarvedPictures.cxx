// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/CarvedPictures.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkImageData.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolume.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{

void CarvedPictures::Find(
  vtkRenderer* renderer, const CarvedArray& array, std::vector<std::unique_ptr<CarvedPicture>>& now)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    auto* const volume = vtkVolume::SafeDownCast(prop);
    auto* const mapper = volume ? vtkVolumeMapper::SafeDownCast(volume->GetMapper()) : nullptr;
    // Null if the mapper has a picture's copy, or shows something else.
    vtkDataArray* const shown = FindShownArray(mapper, array.Array);
    const auto isKnown = [mapper, shown, &array](const std::unique_ptr<CarvedPicture>& one)
    {
      return one && one->GetMapper() == mapper && one->GetArray().IsSame(array) &&
        (!shown || shown == one->GetShown());
    };
    if (!mapper || std::any_of(now.begin(), now.end(), isKnown))
    {
      continue;
    }
    const auto known = std::find_if(this->All.begin(), this->All.end(), isKnown);
    if (known != this->All.end())
    {
      now.push_back(std::move(*known));
    }
    else if (shown)
    {
      now.push_back(std::make_unique<CarvedPicture>(mapper, array, shown));
    }
  }
}

bool CarvedPictures::Update(vtkRenderer* renderer, const std::vector<CarvedArray>& arrays)
{
  std::vector<std::unique_ptr<CarvedPicture>> now;
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  vtkRendererCollection* const renderers = window ? window->GetRenderers() : nullptr;
  for (const CarvedArray& array : arrays)
  {
    if (!renderers)
    {
      this->Find(renderer, array, now);
      continue;
    }
    vtkCollectionSimpleIterator it;
    renderers->InitTraversal(it);
    while (vtkRenderer* one = renderers->GetNextRenderer(it))
    {
      this->Find(one, array, now);
    }
  }
  // The end of a picture changes the shown tissue, too.
  bool isNew = std::any_of(this->All.begin(), this->All.end(),
    [](const std::unique_ptr<CarvedPicture>& one) { return one != nullptr; });
  this->All = std::move(now);
  for (const std::unique_ptr<CarvedPicture>& one : this->All)
  {
    isNew = one->Update() || isNew;
  }
  return isNew;
}

vtkAlgorithmOutput* CarvedPictures::FindInput(vtkVolumeMapper* mapper) const
{
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  vtkDataObject* const shown = mapper->GetInputDataObject(0, 0);
  const auto picture = std::find_if(this->All.begin(), this->All.end(),
    [mapper, shown](const std::unique_ptr<CarvedPicture>& one)
    { return one->GetMapper() == mapper && one->IsCopy(shown); });
  return picture == this->All.end() ? mapper->GetInputConnection(0, 0) : (*picture)->GetReplaced();
}

vtkImageData* CarvedPictures::FindImage(vtkVolumeMapper* mapper) const
{
  vtkAlgorithmOutput* const input = this->FindInput(mapper);
  return input
    ? vtkImageData::SafeDownCast(input->GetProducer()->GetOutputDataObject(input->GetIndex()))
    : nullptr;
}

} // namespace VolumeHaptics
