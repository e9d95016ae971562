#include "core/receivers/parcels/parcel_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/base/safe_text.h"
#include "core/receivers/points/solid_parts.h"

namespace noonmark {

namespace {

double lengthOf(const Ring& ring) {
    double length = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        length += glm::distance(glm::dvec2(ring[i]), glm::dvec2(ring[(i + 1) % ring.size()]));
    return length;
}

std::size_t partsOf(const Ring& ring, double spacingM) {
    return std::size_t(std::max(1.0, std::round(lengthOf(ring) / spacingM)));
}

// The first corner, and the ends of the equal parts of the ring.
std::vector<glm::dvec2> spread(const Ring& ring, double spacingM) {
    const std::size_t parts = partsOf(ring, spacingM);
    const double part = lengthOf(ring) / double(parts);
    std::vector<glm::dvec2> places;
    double passed = 0;
    for (std::size_t i = 0; i < ring.size() && places.size() < parts; ++i) {
        const glm::dvec2 a(ring[i]), b(ring[(i + 1) % ring.size()]);
        const double side = glm::distance(a, b);
        for (; places.size() < parts && double(places.size()) * part < passed + side;)
            places.push_back(a + (double(places.size()) * part - passed) / side * (b - a));
        passed += side;
    }
    return places;
}

Result<void> checkLines(const LineSettings& settings) {
    const auto fits = [](double metres) {
        return metres >= LineSettings::minOffsetM && metres <= LineSettings::maxOffsetM;
    };
    if (settings.offsetsM.empty() || !std::ranges::all_of(settings.offsetsM, fits))
        return failure("The distances of the lines are out of range", "lines", "Give 0.1 to 500 m: 5,10");
    if (!(settings.spacingM >= LineSettings::minSpacingM && settings.spacingM <= LineSettings::maxSpacingM))
        return failure("The spacing of the points is out of range", "lines", "Give 0.1 to 100 m");
    return {};
}

/// Places the points of one line after the other.
class LinePlacer {
public:
    LinePlacer(const City& city, const LineSettings& settings, double planeM)
        : city_(city), settings_(settings), planeM_(planeM), solids_(city) {}

    void addLine(const std::vector<Ring>& rings, double offsetM) {
        std::size_t number = 0;
        for (const Ring& ring : rings)
            for (const glm::dvec2 place : spread(ring, settings_.spacingM))
                add(place, fmt::format("{:g} m, {}", offsetM, ++number));
    }

    void warnOfLeftOut(Warnings& warnings) const {
        const auto warn = [&](std::size_t points, const char* why) {
            if (points > 0)
                warnings.push_back(
                    {WarningKind::leftOut, why, fmt::format("{} points of the lines", points)});
        };
        warn(inside_, "the line is inside a building there");
        warn(below_, "the ground rises above the plane there");
    }
    PointReceivers take() { return std::move(placed_); }

private:
    void add(glm::dvec2 place, std::string id) {
        if (planeM_ < double(groundAt(city_, place))) return void(++below_);
        if (solids_.isSolid({place, planeM_})) return void(++inside_);
        placed_.points.positions.emplace_back(glm::dvec3(place, planeM_));
        placed_.points.normals.emplace_back(0, 0, 1);
        placed_.elements.push_back({.id = std::move(id), .kind = ElementKind::point});
        const double half = std::min(settings_.spacingM, 1.0) / 2;
        placed_.panes.push_back({glm::dvec2(-half), glm::dvec2(half)});
    }

    const City& city_;
    const LineSettings& settings_;
    double planeM_;
    SolidParts solids_;
    PointReceivers placed_;
    std::size_t inside_ = 0, below_ = 0;
};

}  // namespace

Result<PointReceivers> placeOnLines(const City& city, const std::vector<Footprint>& parcels,
                                    const LineSettings& settings, double planeM, Warnings& warnings,
                                    const std::stop_token& stop) {
    if (const auto ok = checkLines(settings); !ok) return tl::make_unexpected(ok.error());
    LinePlacer placer(city, settings, planeM);
    std::size_t points = 0;
    for (const double offset : settings.offsetsM) {
        if (stop.stop_requested()) return cancelled();
        const auto rings = drawLines(parcels, offset);
        if (!rings) return tl::make_unexpected(rings.error());
        for (const Ring& ring : *rings) points += partsOf(ring, settings.spacingM);
        if (points > maxReceivers)
            return limitReached("The lines have too many points", "lines", "Give a larger spacing");
        placer.addLine(*rings, offset);
    }
    placer.warnOfLeftOut(warnings);
    return placer.take();
}

namespace {

constexpr std::array names{"north", "northeast", "east", "southeast",
                           "south", "southwest", "west", "northwest"};

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
