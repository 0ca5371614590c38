#include "FrameSheet.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

constexpr int Between = 4;                // pixels
constexpr double LabelShare = 1.0 / 18.0; // of the height of a picture
constexpr int SmallestLabel = 11;         // pixels

// White words with a dark edge, in the upper left corner of a picture whose lower left pixel is at x, y of the sheet.
void writeLabel(vtkImageData* sheet, int x, int y, int height, const std::string& words)
{
  const int size = std::max(SmallestLabel, static_cast<int>(LabelShare * height));
  vtkNew<vtkTextProperty> style;
  style->SetFontFamilyToArial();
  style->SetFontSize(size);
  style->SetBold(true);
  style->SetColor(1.0, 1.0, 1.0);
  style->ShadowOff();
  vtkNew<vtkImageData> glyphs;
  int extent[2] = { 0, 0 };
  constexpr int dpi = 72;
  if (!vtkTextRenderer::GetInstance()->RenderString(style, vtkStdString(words), glyphs, extent, dpi))
  {
    return;
  }
  const int* dims = glyphs->GetDimensions();
  const int left = x + size / 2;
  const int bottom = y + height - size / 2 - extent[1];
  const int edge = std::max(1, size / 16);
  const int* sheetSize = sheet->GetDimensions();
  const auto blend = [&](int dx, int dy, double shade)
  {
    for (int v = 0; v < dims[1]; ++v)
    {
      for (int u = 0; u < dims[0]; ++u)
      {
        const int px = left + u + dx;
        const int py = bottom + v + dy;
        if (px < 0 || py < 0 || px >= sheetSize[0] || py >= sheetSize[1])
        {
          continue;
        }
        const double opacity = static_cast<unsigned char*>(glyphs->GetScalarPointer(u, v, 0))[3] / 255.0;
        auto* pixel = static_cast<unsigned char*>(sheet->GetScalarPointer(px, py, 0));
        for (int c = 0; c < 3; ++c)
        {
          pixel[c] = static_cast<unsigned char>(std::lround(pixel[c] + opacity * (255.0 * shade - pixel[c])));
        }
      }
    }
  };
  for (int dy = -edge; dy <= edge; ++dy)
  {
    for (int dx = -edge; dx <= edge; ++dx)
    {
      blend(dx, dy, 0.15);
    }
  }
  blend(0, 0, 1.0);
}

}

std::array<int, 2> FrameSheet::frameSize(const std::array<int, 2>& sheet, std::size_t count, std::size_t columns)
{
  const auto across = static_cast<int>(std::min(count, columns));
  const int rows = (static_cast<int>(count) + across - 1) / across;
  return { std::max(1, (sheet[0] + Between) / across - Between), std::max(1, (sheet[1] + Between) / rows - Between) };
}

FrameSheet::FrameSheet(std::size_t count, std::size_t columns)
  : Count(count)
  , Columns(std::min(count, columns))
{
}

void FrameSheet::add(vtkImageData* picture, const std::string& label)
{
  if (this->Next >= this->Count)
  {
    throw std::logic_error("a sheet has no room for another picture");
  }
  const int* size = picture->GetDimensions();
  const int width = size[0];
  const int height = size[1];
  const auto columns = static_cast<int>(this->Columns);
  const int rows = (static_cast<int>(this->Count) + columns - 1) / columns;
  if (!this->Sheet)
  {
    this->Sheet = vtkSmartPointer<vtkImageData>::New();
    this->Sheet->SetDimensions(columns * (width + Between) - Between, rows * (height + Between) - Between, 1);
    this->Sheet->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    const int* all = this->Sheet->GetDimensions();
    std::memset(
      this->Sheet->GetScalarPointer(), 255, 3 * static_cast<std::size_t>(all[0]) * static_cast<std::size_t>(all[1]));
  }
  const int x = static_cast<int>(this->Next) % columns * (width + Between);
  // Rows of an image count from below.
  const int y = (rows - 1 - static_cast<int>(this->Next) / columns) * (height + Between);
  for (int row = 0; row < height; ++row)
  {
    std::memcpy(this->Sheet->GetScalarPointer(x, y + row, 0), picture->GetScalarPointer(0, row, 0),
      3 * static_cast<std::size_t>(width));
  }
  writeLabel(this->Sheet, x, y, height, label);
  ++this->Next;
}

}
