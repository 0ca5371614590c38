#include "ItemPicture.h"

#include "apps/drawing/VirtualDisplay.h"

#include <vtkAbstractContextItem.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

namespace swellray::cli
{

int enlargementOf(int width, int height)
{
  constexpr int enlargement = 2;
  constexpr int largest = 4000;
  return std::max(width, height) <= largest ? enlargement : 1;
}

vtkSmartPointer<vtkImageData> drawItem(vtkAbstractContextItem* item, int width, int height)
{
  const int factor = enlargementOf(width, height);
  const drawing::VirtualDisplay display;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetShowWindow(false);
  window->SetMultiSamples(8);
  window->SetSize(width * factor, height * factor);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(renderer);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(item);
  renderer->AddActor(actor);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(grab->GetOutputPort());
  shrink->SetShrinkFactors(factor, factor, 1);
  shrink->MeanOn();
  shrink->Update();
  return shrink->GetOutput();
}

}
