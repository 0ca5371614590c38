#include "PlacesPiece.h"

#include "RayArrays.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace swellray
{

namespace
{

bool isVertex(int cellType)
{
  return cellType == VTK_VERTEX || cellType == VTK_POLY_VERTEX;
}

/** Points of a piece: a range of those of the whole, and after it others that its cells need. */
class PiecePoints
{
public:
  PiecePoints(vtkIdType count, int piece, int pieces)
    : First(count * piece / pieces)
    , Last(count * (piece + 1) / pieces)
  {
    for (vtkIdType i = this->First; i < this->Last; ++i)
    {
      this->Kept->InsertNextId(i);
    }
  }

  bool owns(vtkIdType id) const { return id >= this->First && id < this->Last; }

  vtkIdType add(vtkIdType id)
  {
    if (this->owns(id))
    {
      return id - this->First;
    }
    const auto [entry, isNew] = this->Others.emplace(id, this->Kept->GetNumberOfIds());
    if (isNew)
    {
      this->Kept->InsertNextId(id);
    }
    return entry->second;
  }

  vtkIdList* ids() const { return this->Kept; }
  vtkIdType ownCount() const { return this->Last - this->First; }

private:
  vtkIdType First;
  vtkIdType Last;
  vtkNew<vtkIdList> Kept;
  std::unordered_map<vtkIdType, vtkIdType> Others;
};

// The cells of the piece; true where any of the whole is more than vertices.
template <typename Data>
bool dealCells(Data* whole, Data* part, PiecePoints& points)
{
  bool isMesh = false;
  part->AllocateEstimate(whole->GetNumberOfCells(), 1);
  part->GetCellData()->CopyAllOn();
  part->GetCellData()->CopyAllocate(whole->GetCellData());
  vtkNew<vtkIdList> corners;
  vtkNew<vtkIdList> kept;
  for (vtkIdType cell = 0; cell < whole->GetNumberOfCells(); ++cell)
  {
    const int type = whole->GetCellType(cell);
    if (type == VTK_POLYHEDRON)
    {
      throw std::invalid_argument("places with polyhedra cannot be split into pieces; ask for one piece");
    }
    isMesh = isMesh || !isVertex(type);
    whole->GetCellPoints(cell, corners);
    kept->Reset();
    const bool mine = corners->GetNumberOfIds() > 0 && points.owns(corners->GetId(0));
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = corners->GetId(i);
      if (isVertex(type) ? points.owns(id) : mine)
      {
        kept->InsertNextId(points.add(id));
      }
    }
    if (kept->GetNumberOfIds() > 0)
    {
      const vtkIdType id = part->InsertNextCell(type, kept);
      part->GetCellData()->CopyData(whole->GetCellData(), cell, id);
    }
  }
  return isMesh;
}

template <typename Data>
vtkSmartPointer<vtkDataSet> dealPoints(Data* whole, int piece, int pieces)
{
  const auto part = vtkSmartPointer<Data>::New();
  PiecePoints points(whole->GetNumberOfPoints(), piece, pieces);
  const bool isMesh = dealCells(whole, part.Get(), points);
  vtkNew<vtkPoints> positions;
  if (whole->GetPoints())
  {
    positions->SetDataType(whole->GetPoints()->GetDataType());
  }
  const vtkIdType count = points.ids()->GetNumberOfIds();
  positions->SetNumberOfPoints(count);
  vtkPointData* values = part->GetPointData();
  values->CopyAllOn();
  values->CopyAllocate(whole->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType from = points.ids()->GetId(i);
    positions->SetPoint(i, whole->GetPoint(from));
    values->CopyData(whole->GetPointData(), from, i);
  }
  part->SetPoints(positions);
  if (isMesh)
  {
    unsigned char* ghosts = addArray<vtkUnsignedCharArray>(values, vtkDataSetAttributes::GhostArrayName(), count);
    std::fill_n(ghosts, points.ownCount(), static_cast<unsigned char>(0));
    std::fill(ghosts + points.ownCount(), ghosts + count, vtkDataSetAttributes::DUPLICATEPOINT);
  }
  part->GetFieldData()->PassData(whole->GetFieldData());
  return part;
}

}

vtkSmartPointer<vtkDataSet> pieceOf(vtkDataSet* places, const int* extent, int piece, int pieces)
{
  if (auto* lines = vtkPolyData::SafeDownCast(places))
  {
    return dealPoints(lines, piece, pieces);
  }
  if (auto* cells = vtkUnstructuredGrid::SafeDownCast(places))
  {
    return dealPoints(cells, piece, pieces);
  }
  if (!extent ||
    !(vtkImageData::SafeDownCast(places) || vtkRectilinearGrid::SafeDownCast(places) ||
      vtkStructuredGrid::SafeDownCast(places)))
  {
    throw std::invalid_argument(
      std::string("places of the class ") + places->GetClassName() + " cannot be split into pieces; ask for one piece");
  }
  const auto part = vtkSmartPointer<vtkDataSet>::Take(places->NewInstance());
  if (extent[0] <= extent[1] && extent[2] <= extent[3] && extent[4] <= extent[5])
  {
    part->ShallowCopy(places);
    part->Crop(extent);
  }
  return part;
}

}
