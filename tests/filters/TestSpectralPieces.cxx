// The sea at places piece by piece: what pieces have together is what one has.
#include "Observers.h"

#include "vtkSwellSeafloorReader.h"
#include "vtkSwellSpectralMap.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace
{

using Place = std::tuple<double, double>;

constexpr const char* Ghosts = "vtkGhostType";

struct Scene
{
  Scene()
  {
    this->Reader->SetFileName("plane:slope=0.02,x0=-100,x1=1000,y0=-500,y1=500");
    this->Map->SetSeafloorConnection(this->Reader->GetOutputPort());
    this->Map->SetDirectionFrom(70.0);
    this->Map->SetNumberOfFrequencies(3);
    this->Map->SetNumberOfDirections(12);
  }

  vtkSmartPointer<vtkDataSet> piece(int i, int count)
  {
    EXPECT_EQ(this->Map->UpdatePiece(i, count, 0), 1);
    vtkSmartPointer<vtkDataSet> copy;
    copy.TakeReference(vtkDataSet::SafeDownCast(this->Map->GetOutputDataObject(0))->NewInstance());
    copy->DeepCopy(this->Map->GetOutputDataObject(0));
    return copy;
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellSpectralMap> Map;
};

Place placeOf(vtkDataSet* data, vtkIdType i)
{
  return { data->GetPoint(i)[0], data->GetPoint(i)[1] };
}

// Point i of one has, number by number, what point j of the other has.
void expectSamePoint(vtkDataSet* found, vtkIdType i, vtkDataSet* expected, vtkIdType j)
{
  for (int a = 0; a < expected->GetPointData()->GetNumberOfArrays(); ++a)
  {
    const char* name = expected->GetPointData()->GetArrayName(a);
    vtkDataArray* array = found->GetPointData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    const double value = expected->GetPointData()->GetArray(a)->GetComponent(j, 0);
    EXPECT_TRUE(array->GetComponent(i, 0) == value || std::isnan(value)) << name << " of point " << j;
    EXPECT_EQ(std::isnan(array->GetComponent(i, 0)), std::isnan(value)) << name << " of point " << j;
  }
}

bool isGhost(vtkDataSet* data, vtkIdType i)
{
  vtkDataArray* ghosts = data->GetPointData()->GetArray(Ghosts);
  return ghosts && ghosts->GetComponent(i, 0) != 0.0;
}

vtkNew<vtkPoints> somePoints(int count)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < count; ++i)
  {
    points->InsertNextPoint(20.0 + 37.0 * i, 11.0 * i - 60.0, 0.0);
  }
  return points;
}

// Points dealt out in their order: own points of all pieces, one after the other, are those of the whole.
void expectPiecesMakeWhole(Scene& scene, int count)
{
  const auto whole = scene.piece(0, 1);
  vtkIdType next = 0;
  vtkIdType cells = 0;
  for (int p = 0; p < count; ++p)
  {
    const auto part = scene.piece(p, count);
    cells += part->GetNumberOfCells();
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      if (!isGhost(part, i))
      {
        ASSERT_LT(next, whole->GetNumberOfPoints());
        EXPECT_EQ(placeOf(part, i), placeOf(whole, next));
        expectSamePoint(part, i, whole, next++);
      }
    }
  }
  EXPECT_EQ(next, whole->GetNumberOfPoints());
  EXPECT_EQ(cells, whole->GetNumberOfCells());
}

TEST(SpectralPieces, blocksOfAnImageHaveTogetherWhatOneHas)
{
  Scene scene;
  vtkNew<vtkImageData> nodes;
  nodes->SetDimensions(9, 6, 1);
  nodes->SetOrigin(-50.0, -300.0, 0.0);
  nodes->SetSpacing(110.0, 90.0, 1.0);
  scene.Map->SetInputData(0, nodes);
  const auto whole = scene.piece(0, 1);
  ASSERT_EQ(whole->GetNumberOfPoints(), 54);
  for (const int count : { 2, 3, 4, 50 })
  {
    // More pieces than cells: VTK cuts some into rows of points, and some are empty.
    const bool crowded = count > whole->GetNumberOfCells();
    std::set<vtkIdType> found;
    vtkIdType cells = 0;
    for (int p = 0; p < count; ++p)
    {
      const auto part = scene.piece(p, count);
      EXPECT_TRUE(part->GetNumberOfCells() > 0 || crowded);
      EXPECT_LT(part->GetNumberOfPoints(), 54);
      cells += part->GetNumberOfCells();
      for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
      {
        const vtkIdType id = whole->FindPoint(part->GetPoint(i));
        found.insert(id);
        expectSamePoint(part, i, whole, id);
      }
    }
    EXPECT_EQ(found.size(), 54u) << count;
    EXPECT_TRUE(cells == whole->GetNumberOfCells() || crowded) << count;
  }
}

TEST(SpectralPieces, theSeafloorsOwnNodesAreSplitAndItIsWholeForAll)
{
  Scene scene;
  scene.Reader->SetResample(250.0);
  scene.Map->SetInputConnection(0, scene.Reader->GetOutputPort());
  scene.Map->SetInputConnection(1, nullptr);
  const auto whole = scene.piece(0, 1);
  for (int p = 0; p < 2; ++p)
  {
    const auto part = scene.piece(p, 2);
    EXPECT_LT(part->GetNumberOfPoints(), whole->GetNumberOfPoints());
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      expectSamePoint(part, i, whole, whole->FindPoint(part->GetPoint(i)));
    }
  }
}

TEST(SpectralPieces, stationsAreDealtOutInTheirOrder)
{
  Scene scene;
  vtkNew<vtkPolyData> stations;
  stations->SetPoints(somePoints(7));
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (int i = 0; i < 7; ++i)
  {
    numbers->InsertNextValue(100 + i);
  }
  stations->GetPointData()->AddArray(numbers);
  scene.Map->SetInputData(0, stations);
  expectPiecesMakeWhole(scene, 2);
  expectPiecesMakeWhole(scene, 3);
  expectPiecesMakeWhole(scene, 9); // some have none
  EXPECT_EQ(scene.piece(0, 2)->GetNumberOfPoints(), 3);
  EXPECT_EQ(scene.piece(0, 2)->GetPointData()->GetArray(Ghosts), nullptr);
}

TEST(SpectralPieces, oneCellOfAllStationsIsSplit)
{
  Scene scene;
  vtkNew<vtkPolyData> stations;
  stations->SetPoints(somePoints(7));
  stations->AllocateEstimate(1, 7);
  const vtkIdType ids[] = { 0, 1, 2, 3, 4, 5, 6 };
  stations->InsertNextCell(VTK_POLY_VERTEX, 7, ids);
  scene.Map->SetInputData(0, stations);
  std::set<double> depths;
  for (int p = 0; p < 3; ++p)
  {
    const auto part = scene.piece(p, 3);
    ASSERT_EQ(part->GetNumberOfCells(), 1);
    vtkNew<vtkIdList> corners;
    part->GetCellPoints(0, corners);
    EXPECT_EQ(corners->GetNumberOfIds(), part->GetNumberOfPoints());
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      depths.insert(part->GetPointData()->GetArray("Depth")->GetComponent(i, 0));
    }
  }
  EXPECT_EQ(depths.size(), 7u);
}

TEST(SpectralPieces, cellsOfAMeshComeOnceWithAllTheirPoints)
{
  Scene scene;
  vtkNew<vtkUnstructuredGrid> mesh;
  mesh->SetPoints(somePoints(8));
  mesh->AllocateEstimate(6, 3);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < 6; ++i)
  {
    const vtkIdType corners[] = { i, i + 1, i + 2 };
    mesh->InsertNextCell(VTK_TRIANGLE, 3, corners);
    numbers->InsertNextValue(static_cast<int>(i));
  }
  mesh->GetCellData()->AddArray(numbers);
  scene.Map->SetInputData(0, mesh);
  expectPiecesMakeWhole(scene, 3);
  const auto whole = scene.piece(0, 1);
  std::set<int> seen;
  int ghosts = 0;
  for (int p = 0; p < 3; ++p)
  {
    const auto part = scene.piece(p, 3);
    ASSERT_NE(part->GetPointData()->GetArray(Ghosts), nullptr);
    for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
    {
      const int number = static_cast<int>(part->GetCellData()->GetArray("Number")->GetComponent(cell, 0));
      EXPECT_TRUE(seen.insert(number).second) << number;
      vtkNew<vtkIdList> corners;
      part->GetCellPoints(cell, corners);
      ASSERT_EQ(corners->GetNumberOfIds(), 3);
      for (vtkIdType i = 0; i < 3; ++i)
      {
        EXPECT_EQ(placeOf(part, corners->GetId(i)), placeOf(whole, number + i));
        // What comes along has its values too.
        EXPECT_EQ(part->GetPointData()->GetArray("SignificantWaveHeight")->GetComponent(corners->GetId(i), 0),
          whole->GetPointData()->GetArray("SignificantWaveHeight")->GetComponent(number + i, 0));
      }
    }
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      ghosts += isGhost(part, i) ? 1 : 0;
    }
  }
  EXPECT_EQ(seen.size(), 6u);
  EXPECT_EQ(ghosts, 4); // two behind each of the first two pieces
}

TEST(SpectralPieces, aTransferFileIsForOne)
{
  Scene scene;
  vtkNew<vtkPolyData> stations;
  stations->SetPoints(somePoints(3));
  scene.Map->SetInputData(0, stations);
  scene.Map->SetTransferFileName("pieces.nc");
  vtkNew<Listener> listener;
  listener->listenTo(scene.Map);
  listener->listenTo(scene.Map->GetExecutive());
  scene.Map->UpdatePiece(0, 2, 0);
  ASSERT_FALSE(listener->Errors.empty());
  EXPECT_NE(listener->Errors.front().find("'pieces.nc' is for one piece, not one of 2"), std::string::npos);
}

}
