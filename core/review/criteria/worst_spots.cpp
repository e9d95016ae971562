#include "core/review/criteria/worst_spots.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>

#include "core/engines/common/shadow_reach.h"
#include "core/engines/common/sun_packets.h"
#include "core/engines/ray/ray_reference.h"
#include "core/measures/places/place_run.h"
#include "core/receivers/place_names.h"
#include "core/simd/flush_denormals.h"

namespace noonmark {

namespace {

/// The buildings whose shadow can fall on a place, outside the centres of its cells too.
std::vector<std::uint32_t> findInReach(const City& city, std::span<const Place> places, double lowestM,
                                       const SunSteps& sun) {
    const Box2 box = bounds(places);
    const ShadowReach reach(sun);
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < city.buildings.size(); ++i) {
        const Building& building = *city.buildings[i];
        if (reach.touches(bounds(building), double(topM(building)) - lowestM, box))
            found.push_back(std::uint32_t(i));
    }
    return found;
}

double lowestM(const PlaceReceivers& receivers, std::optional<float> planeZ) {
    constexpr double belowCentresM = 20;  // the ground beside the lowest centre
    if (planeZ) return double(*planeZ);
    const bool flat = receivers.receivers.flat();
    return lowestGroundM(receivers.receivers) - (flat ? 0 : belowCentresM);
}

bool isIn(const std::vector<Footprint>& polygons, glm::dvec2 point) {
    return std::ranges::any_of(polygons, [&](const Footprint& one) { return contains(one, point); });
}

SunSteps stepsOf(const PlaceShadow& day) {
    SunSteps sun;
    sun.steps.assign(day.steps.begin(), day.steps.end());
    sun.days.push_back({.first = 0, .count = std::uint32_t(day.steps.size())});
    return sun;
}

StepMasks traceMasks(const RayScene& scene, std::span<const glm::vec3> origins,
                     std::span<const SunPacket> packets, std::size_t steps) {
    StepMasks masks(origins.size(), steps);
    std::vector<std::uint32_t> blocked(origins.size());
    for (std::size_t i = 0; i < packets.size(); ++i) {
        scene.blockedLanes(origins, packets[i].directions, blocked);
        for (std::size_t point = 0; point < origins.size(); ++point)
            for (int lane = 0; lane < packets[i].directions.count; ++lane)
                if ((blocked[point] >> lane & 1U) != 0)
                    masks.shade(i * DirectionPacket::capacity + std::size_t(lane), point);
    }
    return masks;
}

}  // namespace

Result<PlacePoints> PlacePoints::over(std::span<const City* const> cities, std::span<const Place> places,
                                      const PlaceReceivers& receivers, std::optional<float> planeZ,
                                      const SunSteps& sun, const std::stop_token& stop) {
    PlacePoints points;
    points.ground_ = cities.front();
    points.places_ = places;
    points.receivers_ = &receivers;
    points.planeZ_ = planeZ;
    points.built_ = findBuiltGround(cities, places);
    for (const City* city : cities) {
        const double lowest = lowestM(receivers, planeZ);
        auto scene = RayScene::over(*city, findInReach(*city, places, lowest, sun), stop);
        if (!scene) return tl::make_unexpected(scene.error());
        points.scenes_.push_back(*std::move(scene));
        points.crowns_.emplace_back(*city, bounds(places), float(lowest), sun);
    }
    return points;
}

glm::dvec2 PlacePoints::centreOf(std::size_t place, std::size_t cell) const {
    const Receivers& receivers = receivers_->receivers;
    const std::uint32_t index = receivers.cells[receivers_->receiverOf(place, cell)];
    return glm::dvec2(receivers.position(index));
}

bool PlacePoints::isOpen(std::size_t place, glm::dvec2 point) const {
    return isIn(places_[place].polygons, point) && !isIn(built_[place], point);
}

glm::vec3 PlacePoints::originAt(glm::dvec2 point) const {
    const float z = planeZ_ ? *planeZ_ : groundAt(*ground_, point);
    return placeRayOrigin({glm::vec2(point), z});
}

std::vector<glm::dvec2> PlacePoints::around(std::size_t place, std::span<const glm::dvec2> middles,
                                            const PointGrid& grid) const {
    std::set<std::pair<std::int64_t, std::int64_t>> squares;  // by row, so that neighbours follow each other
    for (const glm::dvec2 middle : middles) {
        const auto low = glm::floor((middle - grid.reachM) / grid.spacingM + 0.5),
                   high = glm::floor((middle + grid.reachM) / grid.spacingM + 0.5);
        for (auto row = std::int64_t(low.y); row < std::int64_t(high.y); ++row)
            for (auto column = std::int64_t(low.x); column < std::int64_t(high.x); ++column)
                squares.emplace(row, column);
    }
    std::vector<glm::dvec2> points;
    for (const auto& [row, column] : squares) {
        const glm::dvec2 point = (glm::dvec2(column, row) + 0.5) * grid.spacingM;
        if (isOpen(place, point)) points.push_back(point);
    }
    return points;
}

PlaceShadow PlacePoints::shade(std::span<const glm::dvec2> points, const PlaceShadow& day) const {
    const FlushDenormals flush;
    std::vector<glm::vec3> origins;
    for (const glm::dvec2 point : points) origins.push_back(originAt(point));
    const std::vector<SunPacket> packets = packSteps(stepsOf(day));
    PlaceShadow shadow{.day = day.day, .steps = day.steps, .cellAreaM2 = 0, .stepMinutes = day.stepMinutes};
    shadow.baseline = traceMasks(scenes_.front(), origins, packets, day.steps.size());
    shadow.scenario = traceMasks(scenes_[1], origins, packets, day.steps.size());
    crowns_.front().addTo(shadow.baseline, day.day, day.steps, origins);
    crowns_[1].addTo(shadow.scenario, day.day, day.steps, origins);
    if (scenes_.size() == 2) return shadow;
    const StepMasks bare = traceMasks(scenes_[2], origins, packets, day.steps.size());
    removeShadow(shadow.baseline, bare);
    removeShadow(shadow.scenario, bare);
    return shadow;
}

namespace {

/// One round of the search: so many spots, each with points around it. In cells.
struct SearchRound {
    std::size_t spots;
    double reach, spacing;
};

// A round covers the squares of the one before; the first also the strip beside a wall on which no centre is,
// and the squares around all suspects.
constexpr std::array<SearchRound, 3> rounds{{{8, 1, 0.5}, {3, 0.25, 0.125}, {2, 0.125, spotDistanceCells}}};

bool isNear(glm::dvec2 a, glm::dvec2 b, double distanceM) {
    const glm::dvec2 apart = glm::abs(a - b);
    return std::max(apart.x, apart.y) <= distanceM;
}

/// The worst spots of one search, at least `apartM` from each other.
void addWorstSpots(RunsOfDay& day, const SpotSearch& search,
                   const std::function<glm::dvec2(std::size_t)>& positionOf, std::size_t count, double apartM,
                   std::vector<glm::dvec2>& spots) {
    std::vector<std::uint32_t> steps =
        stepsOf(day.count(search.quantity, search.former, search.runs), search.measure);
    leaveOutBeside(day.shadow(), search.quantity, steps);
    const bool minimum = search.quantity == Quantity::sun;
    std::vector<std::size_t> order(steps.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t looked = std::min(order.size(), 16 * count);  // most of them beside each other
    std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(looked), order.end(),
                      [&](std::size_t a, std::size_t b) {
                          if (steps[a] != steps[b])
                              return minimum ? steps[a] < steps[b] : steps[a] > steps[b];
                          return a < b;
                      });
    std::vector<glm::dvec2> found;
    for (std::size_t i = 0; i < looked && found.size() < count; ++i) {
        if (steps[order[i]] == (minimum ? std::numeric_limits<std::uint32_t>::max() : 0))
            break;  // or beside the place
        const glm::dvec2 position = positionOf(order[i]);
        if (std::ranges::none_of(found, [&](glm::dvec2 other) { return isNear(position, other, apartM); }))
            found.push_back(position);
    }
    spots.insert(spots.end(), found.begin(), found.end());
}

/// The centres of a search's suspects.
void addSuspects(RunsOfDay& day, const SpotSearch& search,
                 const std::function<glm::dvec2(std::size_t)>& positionOf, std::vector<glm::dvec2>& spots) {
    const SpotRuns& runs = day.count(search.quantity, search.former, search.runs);
    for (const std::uint32_t cell :
         listSuspects(day.shadow(), search.quantity, stepsOf(runs, search.measure)).cells)
        spots.push_back(positionOf(cell));
}

void addSearch(std::vector<SpotSearch>& searches, const SpotSearch& search) {
    if (std::ranges::find(searches, search) == searches.end()) searches.push_back(search);
}

}  // namespace

bool isOfWorstSpot(Measure measure) {
    return measure == Measure::spotTotal || measure == Measure::spotLongestRun ||
           measure == Measure::spotLongestRuns;
}

std::vector<SpotSearch> listSpotSearches(const Rule& rule) {
    std::vector<SpotSearch> searches{{Quantity::incremental, Measure::spotTotal, {}, false},
                                     {Quantity::incremental, Measure::spotLongestRun, {}, false},
                                     {Quantity::shadow, Measure::spotTotal, {}, false},
                                     {Quantity::sun, Measure::spotTotal, {}, false},
                                     {Quantity::sun, Measure::spotLongestRun, {}, false}};
    for (const Criterion& criterion : rule.criteria) {
        if (!isOfWorstSpot(criterion.measure)) continue;
        const RunSettings runs{criterion.runs, criterion.dropShorterMin};
        addSearch(searches, {criterion.quantity, criterion.measure, runs, false});
        if (std::ranges::any_of(criterion.limits, &Limit::ofFormer))
            addSearch(searches, {criterion.quantity, criterion.measure, runs, true});
    }
    return searches;
}

const std::vector<std::uint32_t>& stepsOf(const SpotRuns& runs, Measure measure) {
    if (measure == Measure::spotTotal) return runs.total;
    return measure == Measure::spotLongestRun ? runs.longest : runs.longestRuns;
}

std::vector<std::uint32_t> boundSpots(const PlaceShadow& shadow, Quantity quantity,
                                      const std::vector<std::uint32_t>& steps) {
    std::vector<std::uint32_t> between(steps.size());  // most, between a cell and those beside it
    for (const NeighbourCells& pairs : shadow.neighbours)
        for (std::uint32_t i = 0; i < pairs.count; ++i) {
            const std::uint32_t a = pairs.first + i, b = pairs.second + i;
            const std::uint32_t apart = std::max(steps[a], steps[b]) - std::min(steps[a], steps[b]);
            between[a] = std::max(between[a], apart);
            between[b] = std::max(between[b], apart);
        }
    std::vector<std::uint32_t> bounds(steps.size());
    for (std::size_t cell = 0; cell < steps.size(); ++cell)
        bounds[cell] = quantity == Quantity::sun ? steps[cell] - std::min(steps[cell], between[cell])
                                                 : steps[cell] + between[cell];
    leaveOutBeside(shadow, quantity, bounds);
    return bounds;
}

Suspects listSuspects(const PlaceShadow& shadow, Quantity quantity, const std::vector<std::uint32_t>& steps) {
    if (steps.empty()) return {};
    std::vector<std::uint32_t> centres = steps;
    leaveOutBeside(shadow, quantity, centres);
    const bool minimum = quantity == Quantity::sun;
    const auto isWorse = [&](std::uint32_t a, std::uint32_t b) { return minimum ? a < b : a > b; };
    const std::uint32_t worst = std::ranges::min(centres, isWorse);
    const std::vector<std::uint32_t> bounds = boundSpots(shadow, quantity, steps);
    std::vector<std::uint32_t> cells;
    for (std::uint32_t cell = 0; cell < bounds.size(); ++cell)
        if (isWorse(bounds[cell], worst)) cells.push_back(cell);
    std::ranges::stable_sort(cells, isWorse, [&](std::uint32_t cell) { return bounds[cell]; });
    Suspects suspects;
    if (cells.size() > maxSuspects) suspects.next = bounds[cells[maxSuspects]];
    cells.resize(std::min(cells.size(), maxSuspects));
    suspects.cells = std::move(cells);
    return suspects;
}

// The first round has four points in a cell at most; the others look around few spots, which searches share.
std::size_t expectPoints(std::size_t cells, std::size_t searches) {
    constexpr std::size_t first = 100, others = 25;
    return cells == 0 ? 0 : std::min(searches * first, 4 * cells) + searches * others;
}

std::vector<PlaceShadow> refineWorstSpots(std::size_t place, const PlaceShadow& shadow,
                                          const PlacePoints& points, std::span<const SpotSearch> searches) {
    std::vector<PlaceShadow> near;
    if (shadow.steps.empty() || shadow.baseline.receivers == 0) return near;
    std::vector<glm::dvec2> at;  // of the points of the round before
    for (const SearchRound& round : rounds) {
        std::vector<glm::dvec2> spots;
        RunsOfDay coarser(near.empty() ? shadow : near.back());
        const auto positionOf = [&](std::size_t i) {
            return near.empty() ? points.centreOf(place, i) : at[i];
        };
        for (const SpotSearch& search : searches) {
            addWorstSpots(coarser, search, positionOf, round.spots, round.reach * points.cellM(), spots);
            if (near.empty()) addSuspects(coarser, search, positionOf, spots);
        }
        at = points.around(place, spots, {round.reach * points.cellM(), round.spacing * points.cellM()});
        if (at.empty()) return near;
        near.push_back(points.shade(at, shadow));
    }
    return near;
}

}  // namespace noonmark
