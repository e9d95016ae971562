#include "core/receivers/parcels/parcel_roads.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace noonmark {

namespace {

constexpr std::array names{"north", "northeast", "east", "southeast",
                           "south", "southwest", "west", "northwest"};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::optional<ParcelSide> sideNamed(std::string_view text) {
    std::string name(text);
    for (char& letter : name) letter = char(std::tolower(static_cast<unsigned char>(letter)));
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return std::nullopt;
    return ParcelSide(found - names.begin());
}

std::optional<double> widthFrom(std::string_view text) {
    double widthM = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), widthM);
    const bool isNumber = error == std::errc() && end == text.data() + text.size();
    if (!isNumber || !(widthM >= minRoadM && widthM <= maxRoadM)) return std::nullopt;
    return widthM;
}

Result<RoadFront> parseFront(std::string_view text) {
    const auto equals = text.find('=');
    const auto side = sideNamed(trimmed(text.substr(0, equals)));
    if (!side)
        return failure(fmt::format("'{}' names no side of a parcel", text), "road",
                       fmt::format("Sides are {}: for example south=8", fmt::join(names, ", ")));
    const auto width =
        equals == std::string_view::npos ? std::nullopt : widthFrom(trimmed(text.substr(equals + 1)));
    if (!width)
        return failure(fmt::format("'{}' has no width of a road", text), "road",
                       fmt::format("Widths are {:g} to {:g} m: for example south=8", minRoadM, maxRoadM));
    return RoadFront{*side, *width};
}

}  // namespace

std::string_view nameOf(ParcelSide side) { return names[std::size_t(side)]; }

std::string formatText(const std::vector<RoadFront>& roads) {
    std::string text;
    for (const RoadFront& road : roads)
        text += fmt::format("{}{}={}", text.empty() ? "" : ", ", nameOf(road.side), road.widthM);
    return text;
}

Result<std::vector<RoadFront>> parseRoads(std::string_view text) {
    std::vector<RoadFront> roads;
    if (trimmed(text).empty()) return roads;
    for (bool more = true; more;) {
        const auto comma = text.find(',');
        more = comma != std::string_view::npos;
        const auto road = parseFront(trimmed(text.substr(0, comma)));
        if (!road) return tl::make_unexpected(road.error());
        if (std::ranges::find(roads, road->side, &RoadFront::side) != roads.end())
            return failure(fmt::format("Two roads run along the {} side", nameOf(road->side)), "road",
                           "Give each side one width");
        roads.push_back(*road);
        if (more) text.remove_prefix(comma + 1);
    }
    return roads;
}

double shiftOf(const RoadShift& rule, double widthM) {
    return widthM <= rule.narrowM ? rule.share * widthM : widthM - rule.fromFarSideM;
}

}  // namespace noonmark
