#ifndef PlacesPiece_h
#define PlacesPiece_h

#include <vtkSmartPointer.h>

class vtkDataSet;

namespace swellray
{

/**
 * One of the pieces that share the points of a data set.
 *
 * An image, a rectilinear or a structured grid is cut to the extent. The points of poly-data and of unstructured grids are dealt
 * out in their order, as many to each piece, and vertices with them. Any other cell goes where its first point goes: where it has
 * points of other pieces these come along at the end, marked by vtkGhostType as DUPLICATEPOINT; all pieces of such data have that array.
 * @param extent of the piece, 6 numbers, of structured data
 * @param piece 0 to pieces - 1
 * @throws std::invalid_argument where the data set is of another kind, or has polyhedra
 */
vtkSmartPointer<vtkDataSet> pieceOf(vtkDataSet* places, const int* extent, int piece, int pieces);

}

#endif
