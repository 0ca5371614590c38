#pragma once

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

/** What an algorithm told: errors and warnings with their words, and how often it ran. */
class Listener : public vtkCommand
{
public:
  static Listener* New() { return new Listener; }

  void listenTo(vtkObject* object)
  {
    for (const unsigned long event : { ErrorEvent, WarningEvent, StartEvent, ProgressEvent })
    {
      object->AddObserver(event, this);
    }
  }

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    switch (event)
    {
    case ErrorEvent:
      this->Errors.emplace_back(static_cast<const char*>(data));
      break;
    case WarningEvent:
      this->Warnings.emplace_back(static_cast<const char*>(data));
      break;
    case StartEvent:
      ++this->Runs;
      break;
    case ProgressEvent:
      this->Progress.push_back(*static_cast<double*>(data));
      if (this->AbortAt >= 0.0 && this->Progress.back() >= this->AbortAt)
      {
        vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
      }
      break;
    default:
      break;
    }
  }

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<double> Progress;
  int Runs = 0;
  double AbortAt = -1.0; // share of the work; negative: never
};

/** Image with elevation(x, y) at columns x rows nodes from (x0, y0) on. */
inline vtkSmartPointer<vtkImageData> elevationImage(int columns, int rows, double spacing,
  const std::function<double(double, double)>& elevation, double x0 = 0.0, double y0 = 0.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  image->SetOrigin(x0, y0, 0.0);
  image->SetSpacing(spacing, spacing, 1.0);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Elevation");
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      values->InsertNextValue(elevation(x0 + column * spacing, y0 + row * spacing));
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/** A folder of its own for a test, gone when the test is over. */
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "swellray-filters-XXXXXX").string();
    this->Path = mkdtemp(name.data());
  }
  ~TemporaryFolder()
  {
    std::error_code none;
    std::filesystem::remove_all(this->Path, none);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  void operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (this->Path / name).string(); }

  std::string write(const std::string& name, const std::string& words) const
  {
    std::ofstream(this->file(name)) << words;
    return this->file(name);
  }

private:
  std::filesystem::path Path;
};
