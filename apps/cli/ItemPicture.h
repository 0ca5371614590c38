#pragma once

#include <vtkSmartPointer.h>

class vtkAbstractContextItem;
class vtkImageData;

namespace swellray::cli
{

/** How many times larger than its picture of this size an item is drawn, to be averaged down: smooth edges on any driver. */
int enlargementOf(int width, int height);

/**
 * An item of two dimensions as a picture, off screen.
 * @param width, height of the picture, pixels
 * @param item laid out for a picture that is enlargementOf() times larger
 */
vtkSmartPointer<vtkImageData> drawItem(vtkAbstractContextItem* item, int width, int height);

}
