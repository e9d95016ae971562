#include "core/measures/places/place_screening.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/engines/common/changed_buildings.h"
#include "core/measures/places/place_run.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

double distanceToSide(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double share = square > 0 ? std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(point - (a + along * share));
}

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

double betweenBoxes(const Box2& a, const Box2& b) {
    const glm::dvec2 gap = glm::max(glm::dvec2(0), glm::max(glm::dvec2(a.low) - glm::dvec2(b.high),
                                                            glm::dvec2(b.low) - glm::dvec2(a.high)));
    return glm::length(gap);
}

double betweenRings(const Ring& a, const Ring& b, double atMost) {
    for (std::size_t i = 0, k = a.size() - 1; i < a.size(); k = i++)
        for (std::size_t j = 0, l = b.size() - 1; j < b.size(); l = j++) {
            const glm::dvec2 p(a[k]), q(a[i]), r(b[l]), s(b[j]);
            if (cross(p, q, r, s)) return 0;
            atMost = std::min({atMost, distanceToSide(p, r, s), distanceToSide(r, p, q)});
        }
    return atMost;
}

std::vector<const Ring*> ringsOf(const Footprint& polygon) {
    std::vector<const Ring*> rings{&polygon.outer};
    for (const Ring& hole : polygon.holes) rings.push_back(&hole);
    return rings;
}

double between(const Footprint& a, const Footprint& b, double atMost) {
    if (a.outer.empty() || b.outer.empty() || betweenBoxes(bounds(a), bounds(b)) >= atMost) return atMost;
    if (contains(a, glm::dvec2(b.outer.front())) || contains(b, glm::dvec2(a.outer.front()))) return 0;
    for (const Ring* one : ringsOf(a))
        for (const Ring* other : ringsOf(b)) atMost = betweenRings(*one, *other, atMost);
    return atMost;
}

}  // namespace

double measureDistanceM(const std::vector<Footprint>& a, const std::vector<Footprint>& b) {
    double minimum = std::numeric_limits<double>::infinity();
    for (const Footprint& one : a)
        for (const Footprint& other : b) minimum = between(one, other, minimum);
    return minimum;
}

namespace {

constexpr std::array<std::string_view, 4> resultNames{"beyond the longest shadow", "in the no-shadow sector",
                                                      "not reached", "reached"};

double toAzimuthDeg(glm::dvec2 direction) {
    const double deg = std::atan2(direction.x, direction.y) * 180 / std::numbers::pi;
    return deg < 0 ? deg + 360 : deg;
}

// Degrees clockwise from one azimuth to another, 0 to 360.
double clockwiseDeg(double from, double to) { return std::fmod(to - from + 720, 360); }

bool isWithin(const AzimuthSector& sector, double azimuthDeg) {
    return clockwiseDeg(sector.fromDeg, azimuthDeg) <= clockwiseDeg(sector.fromDeg, sector.toDeg);
}

glm::dvec2 middleOf(const Box2& box) { return (glm::dvec2(box.low) + glm::dvec2(box.high)) * 0.5; }

std::vector<Footprint> outlinesOf(const Building& building) {
    std::vector<Footprint> outlines;
    for (const Part& part : building.parts) outlines.push_back(part.footprint);
    return outlines;
}

/// The proposal's buildings and the tests that need no engine.
class Proposal {
public:
    Proposal(const City& city, Buildings buildings, double factor, std::optional<AzimuthSector> sector)
        : city_(city), buildings_(std::move(buildings)), factor_(factor), sector_(sector) {
        for (const auto& building : buildings_) box_.add(bounds(*building));
    }

    [[nodiscard]] const Buildings& buildings() const { return buildings_; }

    [[nodiscard]] ScreenedPlace screen(std::size_t index, const Place& place) const {
        ScreenedPlace screened{.place = index};
        screened.azimuthDeg = toAzimuthDeg(middleOf(bounds(place)) - middleOf(box_));
        double shortest = std::numeric_limits<double>::infinity();  // of what the shadow falls short by
        for (const auto& building : buildings_) {
            const double distance = measureDistanceM(outlinesOf(*building), place.polygons),
                         longest = longestShadowM(*building, place);
            if (distance - longest >= shortest) continue;
            shortest = distance - longest;
            screened.distanceM = distance;
            screened.longestM = longest;
        }
        if (shortest > 0) {
            screened.result = ScreeningResult::outOfLength;
            screened.reason = fmt::format("{:.0f} m away; the shadow is at most {:.0f} m long",
                                          screened.distanceM, screened.longestM);
        } else if (sector_ && std::ranges::all_of(buildings_, [&](const auto& building) {
                       return liesIn(*sector_, *building, place);
                   })) {
            screened.result = ScreeningResult::outOfSector;
            screened.reason = fmt::format("no shadow falls between {:.0f} and {:.0f} deg from north",
                                          sector_->fromDeg, sector_->toDeg);
        }
        return screened;
    }

private:
    // Above the ground under the place.
    [[nodiscard]] double longestShadowM(const Building& building, const Place& place) const {
        const double groundM = double(groundAt(city_, middleOf(bounds(place))));
        return std::max(0.0, double(topM(building)) - groundM) * factor_;
    }

    // The sector is convex, so corners decide.
    [[nodiscard]] static bool liesIn(const AzimuthSector& sector, const Building& building,
                                     const Place& place) {
        if (clockwiseDeg(sector.fromDeg, sector.toDeg) >= 180) return false;
        for (const Part& part : building.parts)
            for (const glm::vec2 from : part.footprint.outer)
                for (const Footprint& polygon : place.polygons)
                    for (const glm::vec2 to : polygon.outer)
                        if (!isWithin(sector, toAzimuthDeg(glm::dvec2(to) - glm::dvec2(from)))) return false;
        return true;
    }

    const City& city_;
    Buildings buildings_;
    double factor_;
    std::optional<AzimuthSector> sector_;
    Box2 box_;
};

// Marks the places that the proposal's shadow reaches when it stands alone.
Result<void> testReach(const City& baseline, const City& scenario, const Proposal& proposal,
                       std::span<const Place> places, const std::vector<std::size_t>& open,
                       const SunSteps& sun, const ScreeningSettings& settings, const Engine& engine,
                       std::vector<ScreenedPlace>& screened, Progress& progress, std::stop_token stop) {
    std::vector<Place> some;
    for (const std::size_t i : open) some.push_back(places[i]);
    const City* const cities[]{&baseline, &scenario};
    const auto cells = placeReceiversOnPlaces(cities, some, {.cellM = settings.cellM}, stop);
    if (!cells) return tl::make_unexpected(cells.error());
    const City alone{scenario.frame, proposal.buildings(), scenario.terrain};
    const auto take = [&](std::size_t, std::span<const PlaceShadow> shadows) -> Result<void> {
        for (std::size_t i = 0; i < shadows.size(); ++i) {
            ScreenedPlace& place = screened[open[i]];
            for (std::size_t step = 0; step < shadows[i].steps.size(); ++step) {
                const auto words = shadows[i].baseline.at(step);
                if (std::ranges::none_of(words, [](std::uint64_t word) { return word != 0; })) continue;
                if (!place.first) place.first = shadows[i].steps[step].at;
                place.minutes += shadows[i].stepMinutes;
            }
        }
        return {};
    };
    return shadePlaces(engine, alone, nullptr, *cells, sun, take, progress, std::move(stop));
}

}  // namespace

std::string_view nameOf(ScreeningResult result) { return resultNames[std::size_t(result)]; }

double findLengthFactor(const SunSteps& sun) {
    double factor = 0;
    for (const SunStep& step : sun.steps)
        factor = std::max(factor, std::hypot(double(step.direction.x), double(step.direction.y)) /
                                      std::max(double(step.direction.z), 1e-9));
    return factor;
}

std::optional<AzimuthSector> findNoShadowSector(const SunSteps& sun) {
    if (sun.steps.empty()) return std::nullopt;
    std::vector<double> azimuths;
    for (const SunStep& step : sun.steps)
        azimuths.push_back(toAzimuthDeg(-glm::dvec2(step.direction.x, step.direction.y)));
    std::ranges::sort(azimuths);
    AzimuthSector widest{azimuths.back(), azimuths.front()};
    double width = clockwiseDeg(widest.fromDeg, widest.toDeg);
    if (azimuths.size() == 1) width = 360;
    for (std::size_t i = 1; i < azimuths.size(); ++i)
        if (const double gap = azimuths[i] - azimuths[i - 1]; gap > width) {
            width = gap;
            widest = {azimuths[i - 1], azimuths[i]};
        }
    if (width < 1) return std::nullopt;
    constexpr double marginDeg = 0.25;  // the sun's path between two steps
    return AzimuthSector{std::fmod(widest.fromDeg + marginDeg, 360),
                         std::fmod(widest.toDeg - marginDeg + 360, 360)};
}

Result<std::vector<ScreenedPlace>> screenPlaces(const City& baseline, const City& scenario,
                                                std::span<const Place> places, const SunSteps& sun,
                                                const ScreeningSettings& settings, const Engine& engine,
                                                Progress& progress, std::stop_token stop) {
    Buildings added = findChangedBuildings(baseline.buildings, scenario.buildings).added;
    if (added.empty())
        return failure("The scenario adds no building, so it casts no new shadow", "screening",
                       "Choose a scenario with a proposal");
    const Proposal proposal(scenario, std::move(added), settings.lengthFactor.value_or(findLengthFactor(sun)),
                            settings.noShadow ? settings.noShadow : findNoShadowSector(sun));
    std::vector<ScreenedPlace> screened;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < places.size(); ++i) {
        screened.push_back(proposal.screen(i, places[i]));
        if (screened.back().result == ScreeningResult::reached) open.push_back(i);
        if (stop.stop_requested()) return cancelled();
    }
    if (!open.empty())
        if (auto done = testReach(baseline, scenario, proposal, places, open, sun, settings, engine, screened,
                                  progress, std::move(stop));
            !done)
            return tl::make_unexpected(done.error());
    for (const std::size_t i : open) {
        ScreenedPlace& place = screened[i];
        if (!place.first) place.result = ScreeningResult::notReached;
        place.reason = place.first
                           ? fmt::format("its shadow reaches it for {:.0f} min", place.minutes)
                           : fmt::format("{:.0f} m away; no shadow falls on it at any step", place.distanceM);
    }
    return screened;
}

}  // namespace noonmark
