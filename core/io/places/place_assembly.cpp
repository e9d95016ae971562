#include "core/io/places/place_assembly.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/base/stop_scope.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/receivers/made_names.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

using Indices = std::vector<std::size_t>;

std::string sourceOf(const std::string& first, std::size_t count) {
    return count == 1 ? first : makeName(madeNames::severalSources, {first, std::to_string(count - 1)});
}

// Joins areas that lie near each other.
void groupNear(const std::vector<Place>& areas, const Indices& alike, double nearM, DisjointSets& sets) {
    std::vector<Box2> boxes, wide;
    const glm::vec2 margin{float(nearM)};
    for (const std::size_t i : alike) {
        boxes.push_back(bounds(areas[i]));
        wide.push_back({boxes.back().low - margin, boxes.back().high + margin});
    }
    for (const auto& [a, b] : findMeetingBoxes(wide, boxes)) sets.join(alike[a], alike[b]);
}

Place joined(std::vector<Place>& areas, const Indices& group) {
    Place place = std::move(areas[group.front()]);
    for (std::size_t i = 1; i < group.size(); ++i)
        std::ranges::move(areas[group[i]].polygons, std::back_inserter(place.polygons));
    if (group.size() > 1) place.polygons = uniteOverlapping(std::move(place.polygons));
    place.source = sourceOf(place.source, group.size());
    return place;
}

bool isUsable(const StreetPiece& piece, Warnings& warnings) {
    const auto finite = [](glm::dvec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    const bool whole = piece.line.points.size() > 1 && std::ranges::all_of(piece.line.points, finite);
    if (!whole)
        warnings.push_back({WarningKind::dropped, "the street's line has no length", piece.id});
    else if (areTangled({piece.line.points}))
        warnings.push_back({WarningKind::dropped, "the street's line crosses itself too often", piece.id});
    else
        return true;
    return false;
}

// GEOS gives up in each thread where a stop is requested in the caller's.
template <class Make>
void makeEach(std::size_t count, const Make& make) {
    const std::stop_token stop = StopScope::current();
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        const StopScope scope(stop);
        make(i);
    });
}

// The strips beside `street` that no carriageway covers.
std::vector<Footprint> cutSidewalks(StreetBlock street, double sidewalkM,
                                    const std::vector<Footprint>& carriageways) {
    constexpr MinPiece minimum{.areaM2 = 1, .widthM = 0.2};
    for (StreetLine& line : street.lines) line.widthM += 2 * sidewalkM;
    return cutPiecesOutside(widenStreet(street.lines), carriageways, minimum);
}

// `carriageways`: those of `streets`. A street between carriageways has no sidewalk and is left out.
std::vector<Place> makeSidewalks(const std::vector<Place>& carriageways,
                                 const std::vector<StreetBlock>& streets, double sidewalkM) {
    std::vector<Box2> boxes, wide;
    const glm::vec2 margin{float(sidewalkM)};
    for (const Place& place : carriageways) {
        boxes.push_back(bounds(place));
        wide.push_back({boxes.back().low - margin, boxes.back().high + margin});
    }
    std::vector<std::vector<Footprint>> near(streets.size());
    for (const auto& [a, b] : findMeetingBoxes(wide, boxes))
        near[a].insert(near[a].end(), carriageways[b].polygons.begin(), carriageways[b].polygons.end());
    std::vector<Place> places = carriageways;
    makeEach(streets.size(),
             [&](std::size_t i) { places[i].polygons = cutSidewalks(streets[i], sidewalkM, near[i]); });
    std::erase_if(places, [](const Place& place) { return place.polygons.empty(); });
    return places;
}

std::vector<Place> named(std::vector<Place> places, std::string_view pattern) {
    for (Place& place : places)
        place.name =
            makeName(pattern, {place.name.empty() ? fmt::format("street ({})", place.source) : place.name});
    return places;
}

std::string_view streetOf(const Place& place) {
    return std::string_view(place.name).substr(0, place.name.rfind(", "));
}

// The sidewalks of each street behind its carriageway.
std::vector<Place> alternate(std::vector<Place> carriageways, std::vector<Place> sidewalks) {
    std::map<std::string, std::vector<Place>, std::less<>> byStreet;
    for (Place& place : sidewalks) byStreet[std::string(streetOf(place))].push_back(std::move(place));
    std::vector<Place> all;
    for (Place& place : carriageways) {
        all.push_back(std::move(place));
        const auto beside = byStreet.find(streetOf(all.back()));
        if (beside == byStreet.end()) continue;
        std::ranges::move(beside->second, std::back_inserter(all));
        byStreet.erase(beside);
    }
    return all;
}

}  // namespace

std::vector<Place> joinAreas(std::vector<Place> areas, double nearM) {
    DisjointSets sets(areas.size());
    std::map<std::pair<std::string, PlaceKind>, Indices> alike;
    for (std::size_t i = 0; i < areas.size(); ++i)
        if (!areas[i].name.empty()) alike[{areas[i].name, areas[i].kind}].push_back(i);
    for (const auto& [name, some] : alike)
        if (some.size() > 1) groupNear(areas, some, nearM, sets);
    const std::vector<Indices> each = sets.list();
    std::vector<Place> places(each.size());
    makeEach(each.size(), [&](std::size_t i) { places[i] = joined(areas, each[i]); });
    return places;
}

std::vector<Place> makeStreets(const std::vector<StreetPiece>& pieces, const StreetPlaces& how,
                               const std::string& sourceStart, Warnings& warnings) {
    std::vector<StreetPiece> usable;
    for (const StreetPiece& piece : pieces)
        if (isUsable(piece, warnings)) usable.push_back(piece);
    std::vector<Place> places;
    std::vector<StreetBlock> all = how.whole ? joinByName(usable) : cutAtJunctions(usable), streets;
    std::vector<std::vector<Footprint>> wide(all.size());
    makeEach(all.size(), [&](std::size_t i) { wide[i] = widenStreet(all[i].lines); });
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (wide[i].empty()) {
            warnings.push_back({WarningKind::dropped, "the street could not be widened", all[i].id});
            continue;
        }
        places.push_back({all[i].name, PlaceKind::street, std::move(wide[i]),
                          sourceStart + sourceOf(all[i].id, all[i].lineCount)});
        streets.push_back(std::move(all[i]));
    }
    if (how.sidewalkM <= 0) return joinAreas(std::move(places));
    auto sidewalks = joinAreas(named(makeSidewalks(places, streets, how.sidewalkM), madeNames::sidewalks));
    return alternate(joinAreas(named(std::move(places), madeNames::carriageway)), std::move(sidewalks));
}

}  // namespace noonmark
