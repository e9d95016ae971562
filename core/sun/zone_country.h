#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/units.h"
#include "core/base/warnings.h"
#include "core/geo/frame.h"
#include "core/sun/period.h"

namespace noonmark {

/// The country of a time zone by the system's tz database, as ISO 3166-1 code: "FR" of "Europe/Paris". Empty
/// where the database states none, as for UTC. Reads a file of 20 kB.
std::string countryOfZone(std::string_view zone);

/// The nearest of the cities that time zones are named after (some 400), by the same database.
struct ZoneTown {
    std::string name;      ///< "Amsterdam"
    std::string country;   ///< "NL"
    double distanceM = 0;  ///< from the place, along a great circle
};

/// Nothing where the database is missing. Reads a file of 20 kB.
std::optional<ZoneTown> findNearestZoneTown(LonLat place);

/// A city of the gazetteer GeoNames.
struct Town {
    LonLat place;
    std::string name;     ///< "Monaco"
    std::string country;  ///< ISO 3166 code: "MC"
    std::string zone;     ///< IANA: "Europe/Monaco"
};

/// Cities with 15,000 or more inhabitants, about 24,000 of them. Empty if the program was built without
/// libgeonames. Takes about 0.1 s. Backend: towns_geonames.cpp.
std::vector<Town> listTowns();

/// The nearest of listTowns(), else of findNearestZoneTown().
std::optional<ZoneTown> findNearestTown(LonLat place);

/// The English name of a country by the same database: "France" of "FR". The code where it states none.
std::string countryName(std::string_view code);

/// A warning if the clocks of the period's zone are more than 4 h from the mean solar time at the place: no
/// zone of the world is, summer time included. Nothing for UTC and fixed offsets ("Etc/GMT+5"), which are
/// chosen for other reasons, and for unknown zones.
std::optional<Warning> questionZone(const Period& period, LonLat place);

/// The names that a user who typed `text` may have meant: those that differ by few letters, as a whole or in
/// their last part ("New_York"). Best first.
std::vector<std::string> findCloseNames(std::string_view text, const std::vector<std::string>& names,
                                        std::size_t maximum = 3);

}  // namespace noonmark
