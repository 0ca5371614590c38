#pragma once

#include "Panel.h"

#include <vtkContextItem.h>

#include <string>
#include <vector>

class vtkContext2D;

namespace swellray::view
{

/** A line of words; a label alone is a heading. */
struct PanelLine
{
  std::string label;
  std::string value;
};

/** Paints the panel, what is known of the waves, and the help. */
class PanelItem : public vtkContextItem
{
public:
  static PanelItem* New();
  vtkTypeMacro(PanelItem, vtkContextItem)

  /** The panel that is painted; it must outlive this. */
  void setPanel(const Panel* panel) { this->Shown = panel; }

  void setTitle(const std::string& title) { this->Title = title; }
  void setLines(std::vector<PanelLine> lines) { this->Lines = std::move(lines); }
  void setStatus(const std::string& status) { this->Status = status; }

  /** Lines over the view; empty: none. */
  void setHelp(std::vector<PanelLine> help) { this->Help = std::move(help); }

  bool Paint(vtkContext2D* painter) override;

private:
  enum class Align
  {
    Left,
    Center,
    Right,
  };
  void text(vtkContext2D* painter, const std::string& words, double x, double y, double size, Align align,
    bool bold = false, double room = 0.0);
  void paintCompass(vtkContext2D* painter);
  void paintSliders(vtkContext2D* painter);
  void paintLines(vtkContext2D* painter);
  void paintColors(vtkContext2D* painter);
  void paintHelp(vtkContext2D* painter);

  const Panel* Shown = nullptr;
  std::string Title;
  std::string Status;
  std::vector<PanelLine> Lines;
  std::vector<PanelLine> Help;
};

}
