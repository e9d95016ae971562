#pragma once

#include <filesystem>
#include <string>

#include "core/io/citygml/citygml_load.h"

namespace noonmark {

/// A reference system as CityGML names it, as parseCrs() (core/geo/crs.h) takes it: the names of
/// the German surveys ("urn:adv:crs:ETRS89_UTM33*DE_DHHN2016_NH") become EPSG's; others are unchanged.
std::string translateReference(const std::string& stated);

/// Whether its coordinates are degrees. False for unknown systems.
bool isGeographicReference(const std::string& stated);

/// Brings the vertices into the order easting or longitude first, and `city.crs` into the form that
/// parseCrs() takes; empty if the one of `settings` is to be used. The order is that of the system's
/// authority if it is named by a URN or address, else easting or longitude first, unless only the other order
/// puts the buildings into the system's area, or into the model's envelope. Error: no system is stated, or it
/// is unknown and the settings have none.
Result<void> settleReference(CityGmlData& data, const ReadSettings& settings,
                             const std::filesystem::path& file);

}  // namespace noonmark
