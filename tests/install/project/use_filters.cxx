#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSwellContours.h>

#include <cstdio>

// A plane beach, 0 to 10 m deep, has one contour line at 5 m.
int main()
{
  constexpr int Nodes = 11;
  vtkNew<vtkDoubleArray> elevation;
  elevation->SetName("Elevation");
  for (int j = 0; j < Nodes; ++j)
  {
    for (int i = 0; i < Nodes; ++i)
    {
      elevation->InsertNextValue(-1.0 * i);
    }
  }
  vtkNew<vtkImageData> seafloor;
  seafloor->SetDimensions(Nodes, Nodes, 1);
  seafloor->SetSpacing(10.0, 10.0, 1.0);
  seafloor->GetPointData()->SetScalars(elevation);

  vtkNew<vtkSwellContours> contours;
  contours->SetInputData(seafloor);
  contours->AddLevel(5.0);
  contours->Update();
  const vtkIdType lines = contours->GetOutput()->GetNumberOfCells();
  std::printf("%d contour line\n", static_cast<int>(lines));
  return lines == 1 ? 0 : 1;
}
