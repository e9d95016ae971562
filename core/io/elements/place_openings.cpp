#include "core/io/elements/place_openings.h"

#include <fmt/format.h>

#include <cmath>

#include "core/geo/crs_to_lon_lat.h"
#include "core/geo/distance.h"
#include "core/geo/earth_drop.h"
#include "core/io/settings/place_advice.h"

namespace noonmark {

namespace {

constexpr const char* openingAdvice =
    "Give CityGML or CityJSON of level of detail 3, whose surfaces are marked as Window, or windows as "
    "points "
    "or polygons with heights";

// Whether an opening is too far away is told by its first corner.
void addOpenings(const std::vector<FileOpening>& openings, const CrsToLonLat& crs, const City& city,
                 const GlazingFileSettings& settings, GlazingRead& read) {
    std::vector<glm::dvec2> flat;
    for (const FileOpening& opening : openings)
        for (const glm::dvec3 corner : opening.corners) flat.emplace_back(corner);
    const std::vector<LonLat> places = crs.lonLat(flat);
    std::size_t next = 0;
    for (const FileOpening& opening : openings) {
        const LonLat first = places[next];
        GlazingShape window{.id = opening.id};
        for (const glm::dvec3 corner : opening.corners) {
            const glm::dvec2 local = city.frame.localFromLonLat(places[next++]);
            window.corners.emplace_back(local, corner.z * crs.metresPerElevationUnit() -
                                                   city.frame.originElevationM() -
                                                   (city.terrain ? earthDropM(local) : 0));
        }
        if (std::isfinite(first.lonDeg) && std::isfinite(first.latDeg) &&
            computeGreatCircleM(first, city.frame.origin()) <= settings.farAwayM)
            read.windows.push_back(std::move(window));
        else
            read.warnings.push_back(
                {WarningKind::leftOut, "the window is too far from the city", opening.id});
    }
}

}  // namespace

Result<void> placeOpenings(const std::vector<FileOpening>& openings, const std::string& crs,
                           const std::string& file, const GlazingFileSettings& settings, const City& city,
                           GlazingRead& read) {
    if (openings.empty())
        return failure("No surface of the city is marked as a window or a door", file, openingAdvice);
    if (openings.size() > GlazingFileSettings::maxWindows)
        return limitReached(fmt::format("It holds more than {} windows", GlazingFileSettings::maxWindows),
                            file, "Divide the file");
    const std::string stated = crs.empty() ? settings.crs.value_or("") : crs;
    if (stated.empty()) return failure("The city has no coordinate reference system", file, crsAdvice());
    const auto system = CrsToLonLat::of(stated);
    if (!system) return failure(system.error().what, file, system.error().advice);
    addOpenings(openings, *system, city, settings, read);
    if (!read.windows.empty()) return {};
    return failure("All windows are too far from the city", file,
                   "Check the coordinate reference system of both files");
}

}  // namespace noonmark
