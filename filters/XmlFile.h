#ifndef XmlFile_h
#define XmlFile_h

#include <string>

class vtkXMLReader;

namespace swellray
{

/**
 * Read a VTK file in XML, the reader's own reports beside the error kept back.
 * @param kind of the file for the error, e.g. "a VTK image (.vti)"
 * @throws std::runtime_error where there is none, it is of another kind, damaged, or has more than MostNodes nodes
 */
void readXmlFile(vtkXMLReader* reader, const std::string& path, const std::string& kind);

}

#endif
