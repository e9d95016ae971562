#include "core/city/map_context.h"

#include <algorithm>

namespace noonmark {

namespace {

// By the value of the kind.
constexpr std::array<std::string_view, contextKinds.size()> names{"wood",   "grass", "park",   "cemetery",
                                                                  "sports", "plaza", "water",  "waterway",
                                                                  "path",   "rail",  "street", "tree"};

}  // namespace

std::string_view nameOf(ContextKind kind) { return names[std::size_t(kind)]; }

std::optional<ContextKind> parseContextKind(std::string_view name) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return std::nullopt;
    return ContextKind(found - names.begin());
}

std::string joinAttribution(const std::string& ofCity, const MapContext* context) {
    if (context == nullptr || !context->picture || context->picture->attribution.empty()) return ofCity;
    return (ofCity.empty() ? std::string() : ofCity + "; ") + context->picture->attribution;
}

}  // namespace noonmark
