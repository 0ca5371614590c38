#ifndef GeoreferenceField_h
#define GeoreferenceField_h

#include "bathymetry/Georeference.h"

class vtkDataObject;
class vtkPointSet;

namespace swellray
{

/**
 * Put what maps the points back as field data: OriginX, OriginY always, CRS (WKT), OriginLongitude and
 * OriginLatitude (degrees) where they are known. On the ellipsoid the CRS is that of the Mercator map, in whose metres
 * the points are, and EarthModel is `ellipsoid`.
 */
void setGeoreference(vtkDataObject* data, const Georeference& georeference);

/** Georeference of these field data; that of a local plane where there are none. */
Georeference georeferenceOf(vtkDataObject* data);

/** Add the point arrays Longitude and Latitude (degrees) where the field data of the points say how to find them. */
void addLongitudeLatitude(vtkPointSet* points);

}

#endif
