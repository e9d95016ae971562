#pragma once

#include "core/study/elements/place_elements.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// The settings with their parts (ElementParts) looked up: the place that faces look at among the project's
/// places, the parcel among its lots, regions and places or else as readRegion() reads it, and the buildings
/// of `city` that the project's existing city lacks, if these are asked for. Error: one of them is not found.
Result<ElementSettings> findElementParts(ElementSettings elements, const Project& project, const City& city);

/// The same of a city without a project. Error: it has no proposed buildings.
Result<ElementSettings> findElementParts(ElementSettings elements, const std::vector<Place>& places,
                                         const City& city);

}  // namespace noonmark
