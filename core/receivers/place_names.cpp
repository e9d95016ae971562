#include "core/receivers/place_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/base/safe_text.h"
#include "core/receivers/made_names.h"
#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

constexpr std::size_t maxLetters = 120;

std::string lowered(std::string_view text) {
    std::string low(text);
    for (char& c : low)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return low;
}

std::vector<std::string> namesLike(const std::vector<Place>& places, std::string_view text) {
    constexpr std::size_t maximum = 5;
    std::vector<std::string> names;
    for (const Place& place : places) names.push_back(place.name);
    std::vector<std::string> close = findCloseNames(text, names, maximum);
    const std::string wanted = lowered(text);
    for (const std::string& name : names)
        if (close.size() < maximum && !wanted.empty() && lowered(name).find(wanted) != std::string::npos &&
            std::ranges::find(close, name) == close.end())
            close.push_back(name);
    return close;
}

}  // namespace

std::string cleanName(std::string_view text) {
    const std::string name = cleanText(text, maxLetters);
    const auto first = name.find_first_not_of(' ');
    if (first == name.npos) return {};
    return name.substr(first, name.find_last_not_of(' ') - first + 1);
}

void makeNamesUnique(std::vector<Place>& places) {
    std::set<std::string> used;
    for (const Place& place : places) used.insert(place.name);
    std::set<std::string> given;
    for (Place& place : places) {
        if (place.name.empty()) place.name = fmt::format("{} ({})", nameOf(place.kind), place.source);
        const std::string name = place.name;
        for (std::size_t number = 2; given.contains(place.name); ++number) {
            const std::string numbered = numberName(name, number);
            if (!used.contains(numbered)) place.name = numbered;
        }
        given.insert(place.name);
        used.insert(place.name);
    }
}

Result<Place> findPlace(const std::vector<Place>& places, std::string_view name) {
    if (const auto exact = std::ranges::find(places, name, &Place::name); exact != places.end())
        return *exact;
    const std::string wanted = lowered(name);
    for (const Place& place : places)
        if (lowered(place.name) == wanted) return place;
    const std::vector<std::string> close = namesLike(places, name);
    if (close.empty())
        return failure("There is no place of this name", fmt::format("place '{}'", name),
                       "List the places: noonmark-cli places");
    return failure("There is no place of this name", fmt::format("place '{}'", name),
                   fmt::format("Did you mean {}?", fmt::join(close, ", ")));
}

Region regionOf(const Place& place) { return {place.name, place.polygons}; }

double area(const Place& place) { return area(place.polygons); }

Box2 bounds(const Place& place) {
    Box2 box;
    for (const Footprint& polygon : place.polygons) box.add(bounds(polygon));
    return box;
}

Box2 bounds(std::span<const Place> places) {
    Box2 box;
    for (const Place& place : places) box.add(bounds(place));
    return box;
}

bool hasOwnName(const Place& place) {
    return !place.name.starts_with(std::string(nameOf(place.kind)) + " (" + place.source);
}

Place makePlace(const Region& region) { return {region.name, PlaceKind::other, region.polygons, "region"}; }

}  // namespace noonmark
