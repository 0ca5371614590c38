#pragma once

#include "Panel.h"
#include "PanelItem.h"
#include "Recorder.h"
#include "SceneView.h"
#include "WaveModel.h"

#include "bathymetry/Georeference.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <array>
#include <filesystem>
#include <string>

namespace swellray::view
{

/** What a window opens with. */
struct ViewSetup
{
  WaveModel::Setup model;
  WaveControls controls;
  ControlRanges ranges;
  Georeference georeference;
  std::string title;
  std::array<int, 2> size{ 1280, 800 }; ///< pixels
  std::filesystem::path folder;         ///< where pictures and movies go
  std::string name = "swellray";        ///< of pictures and movies, without ending
};

/**
 * The interactive window: a panel of controls beside the scene.
 *
 * Events of the interactor change the controls of the model; a timer takes its results over and draws them. It needs
 * a display; without one VTK ends the process, so ask drawing::VirtualDisplay::answers() before.
 */
class ViewWindow
{
public:
  explicit ViewWindow(const ViewSetup& setup);
  ~ViewWindow();
  ViewWindow(const ViewWindow&) = delete;
  ViewWindow& operator=(const ViewWindow&) = delete;

  /** Show the window and work until it is closed. */
  void run();

  /** What the timer does after so many seconds: take over results, move the sea on, draw. */
  void tick(double seconds);

  vtkRenderWindowInteractor* interactor() const { return this->Interactor; }
  vtkRenderWindow* window() const { return this->Window; }
  const WaveModel& model() const { return this->Model; }
  const Panel& panel() const { return this->Controls; }
  SceneView& scene() { return this->Scene; }

  /** Lines beside the scene, as they are shown. */
  const std::vector<PanelLine>& lines() const { return this->Lines; }
  const std::string& status() const { return this->Status; }
  double time() const { return this->Time; } ///< of the sea surface, s

private:
  bool onPress(vtkObject*, unsigned long, void*);
  bool onMove(vtkObject*, unsigned long, void*);
  bool onRelease(vtkObject*, unsigned long, void*);
  void onTurned(vtkObject*, unsigned long, void*);
  bool onWheel(vtkObject*, unsigned long event, void*);
  bool onKey(vtkObject*, unsigned long, void*);
  bool onCharacter(vtkObject*, unsigned long, void*);
  void onTimer(vtkObject*, unsigned long, void*);

  Pixel mouse() const;
  void fit();
  void draw();
  void setControls();
  void takeWaves();
  void takePlace();
  void writeLines();
  void zoom(double factor);
  void toggle(SceneView::Part part);
  bool isSeaMoving() const;

  std::string Title;
  Georeference Place;
  WaveModel Model;
  Panel Controls;
  SceneView Scene;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkRenderer> Overlay;
  vtkNew<PanelItem> Item;
  Recorder Record;
  std::vector<PanelLine> Lines;
  std::string Status = "h: keys";
  bool Playing = true;
  bool Help = false;
  bool ShowsCrests = true;
  bool SurfaceAsked = false;
  bool Changed = true; // since it was drawn
  bool Pressed = false;
  Pixel PressedAt;
  double Time = 0.0;
  double Drawn = 0.0; // clock of the last timer event, s
};

}
