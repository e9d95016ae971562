#pragma once

#include <string>

#include "app/input/load_city.h"
#include "core/study/elements/place_elements.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// Whether the file is a project, by its ending or its content. Reads only files that are databases.
bool isProjectFile(const std::string& file);

/// The project's existing city, with the warnings of reading its files. `file`: the path of the project.
LoadedCity loadProjectCity(const Project& project, const std::string& file);

/// Starts a project with a city: every building gets a unique id. The sample Central Park South includes the
/// park and the lots of its case study.
Project projectOf(const LoadedCity& loaded);

/// The settings with their parts (ElementParts) looked up: the place that faces look at among the project's
/// places, the parcel among its lots, regions and places or else as readRegion() reads it, and the buildings
/// of `city` that the project's existing city lacks, if these are asked for, and where the IFC of windows was
/// placed: as a proposal of that file name in `city`, else as the meshes of the existing city. Error: one of
/// them is not found.
Result<ElementSettings> findElementParts(ElementSettings elements, const Project& project, const City& city);

/// The same of a city without a project. Error: it has no proposed buildings.
Result<ElementSettings> findElementParts(ElementSettings elements, const std::vector<Place>& places,
                                         const ReadSettings& reading, const City& city);

}  // namespace noonmark
