#include "ViewWindow.h"

#include "apps/drawing/Scale.h"

#include <fmt/format.h>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkInteractorStyleTerrain.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <chrono>
#include <cmath>

namespace swellray::view
{

namespace
{

constexpr unsigned long FrameTime = 16; // ms between timer events

// A press and a release this near to each other are a click, pixels.
constexpr double ClickReach = 3.0;

constexpr double ZoomStep = 1.15;

// Characters of a line of words on the panel.
constexpr std::size_t WordsWidth = 36;

// Events of ours go before those of the style.
constexpr float First = 1.0F;

double clockNow()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Words broken into lines.
std::vector<std::string> wrapped(const std::string& words)
{
  std::vector<std::string> lines(1);
  std::size_t at = 0;
  while (at < words.size())
  {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    const std::string word = words.substr(at, end - at);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > WordsWidth)
    {
      lines.emplace_back();
    }
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines;
}

std::vector<PanelLine> helpLines()
{
  return { { "Keys and mouse", "" }, { "drag", "turn the scene; sliders and the compass set the wave" },
    { "wheel", "nearer or farther; over a slider one step" }, { "middle drag", "move the scene" },
    { "click", "depth, waves and the ray at a place" }, { "space", "stop the sea, or let it move" },
    { "1 2 3 4", "rays, crests, sea surface, seafloor on or off" }, { "t  p", "from above, or aslant" },
    { "s", "picture of the window, .png" }, { "m", "begin or end a movie, .ogv" }, { "h", "show or hide this" },
    { "q", "close the window" } };
}

}

ViewWindow::ViewWindow(const ViewSetup& setup)
  : Title(setup.title)
  , Place(setup.georeference)
  , Model(setup.model)
  , Controls(setup.controls, setup.ranges)
  , Scene(setup.model.seafloor)
  , Record(this->Window, setup.folder, setup.name)
{
  this->Scene.setWaterLevel(setup.controls.waterLevel);
  this->Item->setPanel(&this->Controls);
  this->Item->setTitle(this->Title);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(this->Item);
  this->Overlay->SetLayer(1);
  this->Overlay->InteractiveOff();
  this->Overlay->PreserveDepthBufferOn(); // tells where the mouse points
  this->Overlay->AddActor(actor);
  this->Window->SetNumberOfLayers(2);
  // Smooth edges by a pass over the picture: drivers in software take many times as long for several samples a pixel.
  this->Window->SetMultiSamples(0);
  this->Scene.renderer()->UseFXAAOn();
  this->Window->AddRenderer(this->Scene.renderer());
  this->Window->AddRenderer(this->Overlay);
  this->Window->SetWindowName(("Swellray: " + this->Title).c_str());
  this->Window->SetSize(setup.size[0], setup.size[1]);
  this->Interactor->SetRenderWindow(this->Window);
  vtkNew<vtkInteractorStyleTerrain> style;
  style->SetDefaultRenderer(this->Scene.renderer());
  this->Interactor->SetInteractorStyle(style);
  // From a press on, the style takes all events for itself until it says that it is done.
  style->AddObserver(vtkCommand::EndInteractionEvent, this, &ViewWindow::onTurned);

  this->Interactor->AddObserver(vtkCommand::LeftButtonPressEvent, this, &ViewWindow::onPress, First);
  this->Interactor->AddObserver(vtkCommand::MouseMoveEvent, this, &ViewWindow::onMove, First);
  this->Interactor->AddObserver(vtkCommand::LeftButtonReleaseEvent, this, &ViewWindow::onRelease, First);
  this->Interactor->AddObserver(vtkCommand::MouseWheelForwardEvent, this, &ViewWindow::onWheel, First);
  this->Interactor->AddObserver(vtkCommand::MouseWheelBackwardEvent, this, &ViewWindow::onWheel, First);
  this->Interactor->AddObserver(vtkCommand::KeyPressEvent, this, &ViewWindow::onKey, First);
  this->Interactor->AddObserver(vtkCommand::CharEvent, this, &ViewWindow::onCharacter, First);
  this->Interactor->AddObserver(vtkCommand::TimerEvent, this, &ViewWindow::onTimer, First);
  this->Model.setControls(setup.controls);
  this->writeLines();
}

ViewWindow::~ViewWindow() = default;

void ViewWindow::run()
{
  this->draw();
  this->Interactor->Initialize();
  this->Interactor->CreateRepeatingTimer(FrameTime);
  this->Drawn = clockNow();
  this->Interactor->Start();
  this->Record.end();
}

void ViewWindow::onTimer(vtkObject*, unsigned long, void*)
{
  const double now = clockNow();
  const double seconds = now - this->Drawn;
  this->Drawn = now;
  this->tick(seconds);
}

bool ViewWindow::isSeaMoving() const
{
  return this->Playing && this->Scene.isShown(SceneView::Part::Surface) && this->Model.surface().surface;
}

void ViewWindow::tick(double seconds)
{
  const WaveModel::News news = this->Model.poll();
  if (news.waves)
  {
    this->takeWaves();
  }
  if (news.surface)
  {
    this->SurfaceAsked = false;
    this->Scene.setSurface(this->Model.surface().surface);
    this->writeLines();
  }
  if (news.wavesAt)
  {
    this->takePlace();
  }
  const bool shown = this->Scene.isShown(SceneView::Part::Surface);
  if (this->Playing && shown)
  {
    // A movie has every frame at its time, however long that takes.
    this->Time += !this->Record.isRecording() ? seconds : this->SurfaceAsked ? 0.0 : 1.0 / Recorder::Rate;
  }
  const bool stale = !this->Model.surface().surface || this->Model.surface().time != this->Time || news.waves;
  if (shown && stale && !this->SurfaceAsked && this->Model.isRefined())
  {
    this->Model.requestSurface(this->Time);
    this->SurfaceAsked = true;
  }
  // Crests stand where they are at time 0.
  this->Scene.show(SceneView::Part::Crests, this->ShowsCrests && !(shown && this->Time != 0.0));
  if (news || this->Changed)
  {
    this->draw();
  }
  if (this->Record.isRecording() && (news.surface || !(this->Playing && shown)) && !this->Record.addFrame())
  {
    this->Status = this->Record.end();
  }
}

void ViewWindow::takeWaves()
{
  const TracedWaves& waves = this->Model.waves();
  this->SurfaceAsked = false;
  this->Scene.setWaterLevel(waves.controls.waterLevel);
  this->Scene.setRays(waves.rays, waves.controls.height);
  this->Scene.setCrests(waves.crests);
  if (waves.coarseness > 1 || !waves.rays)
  {
    this->Scene.setSurface(nullptr);
  }
  if (const auto& at = this->Model.wavesAt())
  {
    this->Model.requestWavesAt(at->x, at->y);
    this->Scene.setMark(at->x, at->y, waves.controls.waterLevel, nullptr, -1);
  }
  this->writeLines();
}

void ViewWindow::takePlace()
{
  const WavesAt& at = *this->Model.wavesAt();
  const double level = this->Model.waves().controls.waterLevel;
  const double z = std::isfinite(at.elevation) ? std::max(at.elevation, level) : level;
  this->Scene.setMark(at.x, at.y, z, this->Model.waves().rays, at.ray);
  this->writeLines();
}

void ViewWindow::writeLines()
{
  this->Lines.clear();
  const TracedWaves& waves = this->Model.waves();
  if (!waves.failure.empty())
  {
    this->Lines.push_back({ "No waves", "" });
    for (const std::string& line : wrapped(waves.failure))
    {
      this->Lines.push_back({ line, " " });
    }
  }
  else if (waves.rays)
  {
    this->Lines.push_back({ waves.coarseness == 1 ? "Rays" : "Rays, being refined", "" });
    this->Lines.push_back({ fmt::format("{} traced in", waves.rays->GetNumberOfCells()),
      waves.seconds < 1.0 ? fmt::format("{:.0f} ms", 1000.0 * waves.seconds)
                          : fmt::format("{:.1f} s", waves.seconds) });
    if (!this->Model.surface().failure.empty() && this->Scene.isShown(SceneView::Part::Surface))
    {
      for (const std::string& line : wrapped(this->Model.surface().failure))
      {
        this->Lines.push_back({ line, " " });
      }
    }
  }
  if (this->Scene.exaggeration() != 1.0)
  {
    this->Lines.push_back({ "Heights are shown", drawing::shortNumber(this->Scene.exaggeration()) + " x" });
  }
  if (const auto& at = this->Model.wavesAt())
  {
    const auto add = [&](const char* label, double value, const char* unit, int digits)
    {
      if (std::isfinite(value))
      {
        this->Lines.push_back({ label, fmt::format("{:.{}g}{}", value, digits, unit) });
      }
    };
    this->Lines.push_back({ "Where you clicked", "" });
    const glm::dvec2 file = this->Place.toFile({ at->x, at->y });
    const bool geographic = this->Place.kind() == GeoreferenceKind::Geographic;
    this->Lines.push_back({ geographic ? "lon, lat" : "x, y",
      fmt::format("{:.{}f}, {:.{}f}", file.x, geographic ? 5 : 1, file.y, geographic ? 5 : 1) });
    if (std::isfinite(at->depth) && at->depth < 0.0)
    {
      add("Height of the ground", -at->depth, " m", 3);
    }
    else
    {
      add("Depth", at->depth, " m", 4);
    }
    add("Wave height", at->height, " m", 3);
    if (std::isfinite(at->directionFrom))
    {
      this->Lines.push_back({ "Waves from", fmt::format("{:.0f}\u00b0", at->directionFrom) });
    }
    add("Period", at->period, " s", 4);
    add("Wavelength", at->wavelength, " m", 3);
    if (at->ray >= 0)
    {
      this->Lines.push_back({ fmt::format("The ray that came: {}", at->ray), "" });
      add("Refraction", at->refraction, "", 3);
      add("Shoaling", at->shoaling, "", 3);
      add("Time in the scene", at->travelTime, " s", 3);
    }
    else if (waves.rays && !(at->depth < 0.0))
    {
      this->Lines.push_back({ "No ray came", " " });
    }
  }
  this->Changed = true;
}

void ViewWindow::fit()
{
  const int* size = this->Window->GetSize();
  this->Controls.resize(size[0], size[1]);
  const double left = std::min(0.9, this->Controls.width() / size[0]);
  this->Scene.renderer()->SetViewport(left, 0.0, 1.0, 1.0);
}

void ViewWindow::draw()
{
  this->fit();
  this->Item->setLines(this->Lines);
  this->Item->setStatus(this->Status);
  this->Item->setHelp(this->Help ? helpLines() : std::vector<PanelLine>());
  this->Scene.renderer()->ResetCameraClippingRange();
  this->Window->Render();
  this->Changed = false;
}

Pixel ViewWindow::mouse() const
{
  const int* at = this->Interactor->GetEventPosition();
  return { static_cast<double>(at[0]), static_cast<double>(at[1]) };
}

void ViewWindow::setControls()
{
  this->Model.setControls(this->Controls.values());
  this->Changed = true;
}

bool ViewWindow::onPress(vtkObject*, unsigned long, void*)
{
  this->fit();
  const Pixel at = this->mouse();
  if (!this->Controls.press(at))
  {
    this->Pressed = true;
    this->PressedAt = at;
    return false;
  }
  if (this->Controls.drag(at))
  {
    this->setControls();
  }
  this->Changed = true;
  return true;
}

bool ViewWindow::onMove(vtkObject*, unsigned long, void*)
{
  if (!this->Controls.held())
  {
    return false;
  }
  if (this->Controls.drag(this->mouse()))
  {
    this->setControls();
  }
  return true;
}

bool ViewWindow::onRelease(vtkObject*, unsigned long, void*)
{
  if (this->Controls.release())
  {
    this->Changed = true;
    return true;
  }
  return false;
}

void ViewWindow::onTurned(vtkObject*, unsigned long, void*)
{
  const Pixel at = this->mouse();
  double place[3];
  if (this->Pressed && std::hypot(at.x - this->PressedAt.x, at.y - this->PressedAt.y) <= ClickReach &&
    this->Scene.placeAt(static_cast<int>(at.x), static_cast<int>(at.y), place))
  {
    this->Model.requestWavesAt(place[0], place[1]);
  }
  this->Pressed = false;
  this->Changed = true;
}

bool ViewWindow::onWheel(vtkObject*, unsigned long event, void*)
{
  const int steps = event == vtkCommand::MouseWheelForwardEvent ? 1 : -1;
  if (this->Controls.turnWheel(this->mouse(), steps))
  {
    this->setControls();
  }
  else
  {
    this->zoom(std::pow(ZoomStep, steps));
  }
  return true;
}

void ViewWindow::zoom(double factor)
{
  this->Scene.renderer()->GetActiveCamera()->Dolly(factor);
  this->Changed = true;
}

void ViewWindow::toggle(SceneView::Part part)
{
  this->Scene.show(part, !this->Scene.isShown(part));
}

bool ViewWindow::onCharacter(vtkObject*, unsigned long, void*)
{
  return true; // the style has keys of its own for these
}

bool ViewWindow::onKey(vtkObject*, unsigned long, void*)
{
  const char* name = this->Interactor->GetKeySym();
  const std::string key = name ? name : "";
  if (key == "h" || key == "H" || key == "question")
  {
    this->Help = !this->Help;
  }
  else if (key == "space")
  {
    this->Playing = !this->Playing;
  }
  else if (key == "1")
  {
    this->toggle(SceneView::Part::Rays);
  }
  else if (key == "2")
  {
    this->ShowsCrests = !this->ShowsCrests;
  }
  else if (key == "3")
  {
    this->toggle(SceneView::Part::Surface);
  }
  else if (key == "4")
  {
    this->toggle(SceneView::Part::Seafloor);
  }
  else if (key == "t")
  {
    this->Scene.lookDown();
  }
  else if (key == "p")
  {
    this->Scene.lookAslant();
  }
  else if (key == "s")
  {
    this->draw();
    this->Status = this->Record.takePicture();
  }
  else if (key == "m")
  {
    this->draw();
    this->Status = this->Record.isRecording() ? this->Record.end() : this->Record.begin();
  }
  else if (key == "q" || key == "Escape")
  {
    this->Interactor->TerminateApp();
  }
  this->Changed = true;
  return true;
}

}
