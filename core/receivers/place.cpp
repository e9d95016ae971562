#include "core/receivers/place.h"

#include <algorithm>

namespace noonmark {

namespace {

constexpr std::array<std::string_view, placeKinds.size()> kindNames{
    "park",     "playground", "schoolyard", "plaza",         "greenstreet",
    "cemetery", "street",     "facade",     "stained glass", "other"};

}  // namespace

std::string_view nameOf(PlaceKind kind) { return kindNames[std::size_t(kind)]; }

std::optional<PlaceKind> parsePlaceKind(std::string_view name) {
    const auto found = std::ranges::find(kindNames, name);
    if (found == kindNames.end()) return std::nullopt;
    return placeKinds[std::size_t(found - kindNames.begin())];
}

}  // namespace noonmark
