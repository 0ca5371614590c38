#pragma once

#include "bathymetry/Georeference.h"
#include "sim/Obstacles.h"

#include <optional>
#include <string>
#include <vector>

class vtkDataObject;

namespace swellray::cli
{

/** First number of a field data array; none where there is no such array. */
std::optional<double> fieldNumber(vtkDataObject* data, const char* name);

/** First string of a field data array; empty where there is none. */
std::string fieldText(vtkDataObject* data, const char* name);

/** Put a field data string, replacing one of that name. */
void setFieldText(vtkDataObject* data, const char* name, const std::string& text);

/** The incident wave that the field data tell of, in words; empty where they do not. */
std::string waveWords(vtkDataObject* data);

/** Georeference that the field data describe; that of a local plane where there is none. */
Georeference georeferenceOf(vtkDataObject* data);

/** Obstacles that rays carry along; none where there are none. */
std::vector<Obstacle> obstaclesOf(vtkDataObject* data);

}
