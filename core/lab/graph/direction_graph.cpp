#include "core/lab/graph/direction_graph.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <compare>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <tuple>

#include "core/base/units.h"

namespace noonmark {

namespace {

// Shares of the bound for the two sides of a bin; the diagonal stays within the bound. The range of
// declinations in a year exceeds the range of hour angles at a given clock time, and columns must divide an
// hour evenly.
constexpr double columnShare = 0.6, ringShare = 0.42;
constexpr double degreesAMinute = 0.25;  // of hour angle

// Three directions of a day lie on a circle around the pole, passed clockwise as seen from the pole.
glm::dvec3 poleOf(const SunSteps& sun) {
    glm::dvec3 sum{};
    for (const SunDay& day : sun.days) {
        if (day.count < 3) continue;
        const auto at = [&](std::uint32_t step) { return glm::dvec3(sun.steps[day.first + step].direction); };
        const glm::dvec3 middle = at(day.count / 2);
        sum += glm::cross(at(day.count - 1) - middle, middle - at(0));
    }
    constexpr double noArc = 1e-9;  // directions have seven digits
    return glm::length(sum) < noArc ? glm::dvec3(0, 0, 1) : glm::normalize(sum);
}

// Where the meridian of noon crosses the celestial equator; arbitrary if the pole is the zenith.
glm::dvec3 noonOf(glm::dvec3 pole) {
    const glm::dvec3 up = glm::dvec3(0, 0, 1) - pole.z * pole;
    return glm::length(up) < 1e-6 ? glm::normalize(glm::cross(pole, glm::dvec3(1, 0, 0)))
                                  : glm::normalize(up);
}

int roundedDown(double value) { return int(std::floor(value)); }

}  // namespace

DirectionBins::DirectionBins(const SunSteps& sun, double boundDeg, double intervalMinutes)
    : pole_(poleOf(sun)),
      noon_(noonOf(pole_)),
      evening_(glm::cross(noon_, pole_)),
      ringDeg_(ringShare * boundDeg) {
    const double widest = columnShare * boundDeg;
    const double intervalDeg = intervalMinutes * degreesAMinute;
    const bool dividesWell = intervalDeg > widest / 2;
    columnDeg_ = dividesWell ? intervalDeg / std::ceil(intervalDeg / widest - 1e-9) : widest;
}

std::uint32_t DirectionBins::of(glm::dvec3 direction, double inMinutes) const {
    const double hourAngle =
        Radians{std::atan2(glm::dot(direction, evening_), glm::dot(direction, noon_))}.degrees().value +
        inMinutes * degreesAMinute;
    const double declination =
        Radians{std::asin(std::clamp(glm::dot(direction, pole_), -1.0, 1.0))}.degrees().value;
    // Bins are centred on noon and on the celestial equator, and numbered from the lowest hour angle and
    // declination.
    const int column = roundedDown((hourAngle + 180) / columnDeg_ + 0.5),
              ring = roundedDown((declination + 90) / ringDeg_ + 0.5);
    return std::uint32_t(ring) << 16U | std::uint32_t(column);
}

namespace {

// Edges are identified by both bins and the number of steps; without merging, by a running number.
using EdgeKey = std::tuple<std::uint32_t, std::uint32_t, int, std::uint64_t>;

class GraphBuilder {
public:
    GraphBuilder(const SunSteps& sun, const DirectionGraphSettings& settings)
        : sun_(sun),
          settings_(settings),
          stepsAnInterval_(std::max(1, int(std::floor(settings.intervalMinutes / sun.stepMinutes + 1e-9)))),
          graph_{.bins = {sun, settings.boundDeg, stepsAnInterval_ * sun.stepMinutes},
                 .stepMinutes = sun.stepMinutes} {}

    DirectionGraph build() {
        for (const SunDay& day : sun_.days) addDay(day);
        for (const PathKey& path : paths_) graph_.paths.push_back(legsOf(path));
        for (std::size_t i = 0; i < graph_.edges.size(); ++i) finish(graph_.edges[i], ends_[i]);
        orderPaths();
        return std::move(graph_);
    }

private:
    struct Ends {
        glm::dvec3 first{};
        glm::dvec3 last{};
    };
    using PathKey = std::vector<std::pair<std::uint32_t, bool>>;

    void addDay(const SunDay& day) {
        PathKey path;
        std::uint32_t step = day.first;
        const std::uint32_t end = day.first + day.count;
        while (step < end) {
            const std::uint32_t next = endOfInterval(step, end);
            const bool breaks = step > day.first && sun_.steps[step].slot != sun_.steps[step - 1].slot + 1;
            path.emplace_back(edgeFor(step, next - 1), breaks);
            step = next;
        }
        paths_.insert(std::move(path));
    }

    std::uint32_t endOfInterval(std::uint32_t step, std::uint32_t end) const {
        std::uint32_t next = step + 1;
        while (next < end && int(next - step) < stepsAnInterval_ &&
               sun_.steps[next].slot == sun_.steps[next - 1].slot + 1)
            ++next;
        return next;
    }

    std::uint32_t edgeFor(std::uint32_t first, std::uint32_t last) {
        const SunStep& from = sun_.steps[first];
        const SunStep& to = sun_.steps[last];
        const int steps = int(last - first) + 1;
        const std::uint32_t fromBin = graph_.bins.of(glm::dvec3(from.direction));
        // An interval ends where the next one begins.
        const std::uint32_t toBin = graph_.bins.of(glm::dvec3(to.direction), sun_.stepMinutes);
        const EdgeKey key{fromBin, toBin, steps, settings_.merge ? 0 : graph_.intervals};
        const auto [place, isNew] = edgeOf_.try_emplace(key, std::uint32_t(graph_.edges.size()));
        if (isNew) {
            graph_.edges.push_back({{.steps = steps}, fromBin, toBin, 0});
            ends_.emplace_back();
        }
        add(place->second, from, to);
        return place->second;
    }

    void add(std::uint32_t edge, const SunStep& from, const SunStep& to) {
        ++graph_.edges[edge].weight;
        ++graph_.intervals;
        ends_[edge].first += glm::dvec3(from.direction);
        ends_[edge].last += glm::dvec3(to.direction);
    }

    static void finish(DirectionGraph::Edge& edge, const Ends& ends) {
        edge.sun.first = glm::normalize(ends.first);
        edge.sun.last = glm::normalize(ends.last);
    }

    static DirectionGraph::Path legsOf(const PathKey& path) {
        DirectionGraph::Path legs;
        for (const auto& [edge, breaks] : path) legs.push_back({edge, breaks});
        return legs;
    }

    // Days in spring and autumn with the same sun positions share edges. Sorted by the sun's height they are
    // adjacent, so an edge's masks are needed only for a short time.
    void orderPaths() {
        const auto height = [&](const DirectionGraph::Path& path) {
            double sum = 0;
            for (const auto& leg : path)
                sum += graph_.edges[leg.edge].sun.first.z + graph_.edges[leg.edge].sun.last.z;
            return path.empty() ? 0 : sum / double(path.size());
        };
        std::stable_sort(graph_.paths.begin(), graph_.paths.end(),
                         [&](const auto& a, const auto& b) { return height(a) < height(b); });
    }

    const SunSteps& sun_;
    const DirectionGraphSettings& settings_;
    int stepsAnInterval_;
    DirectionGraph graph_;
    std::vector<Ends> ends_;
    std::map<EdgeKey, std::uint32_t> edgeOf_;
    std::set<PathKey> paths_;
};

Result<void> check(const SunSteps& sun, const DirectionGraphSettings& settings) {
    if (!(settings.boundDeg >= 0.1 && settings.boundDeg <= 20))
        return failure(fmt::format("A bin of {} degrees is out of range", settings.boundDeg),
                       "direction bound", "Choose 0.1 to 20 degrees");
    if (!(settings.intervalMinutes >= 0.1 && settings.intervalMinutes <= 120))
        return failure(fmt::format("An interval of {} minutes is out of range", settings.intervalMinutes),
                       "interval",
                       "Choose 0.1 to 120 minutes: beyond 2 hours the sun does not move in a straight line");
    if (settings.intervalMinutes / sun.stepMinutes > maxMaskSteps + 1e-9)
        return failure(fmt::format("An interval of {} minutes has more than 64 steps of {} minutes",
                                   settings.intervalMinutes, sun.stepMinutes),
                       "interval", "Choose a shorter interval or a longer step");
    return {};
}

}  // namespace

Result<DirectionGraph> buildDirectionGraph(const SunSteps& sun, const DirectionGraphSettings& settings) {
    if (const auto ok = check(sun, settings); !ok) return tl::make_unexpected(ok.error());
    return GraphBuilder(sun, settings).build();
}

}  // namespace noonmark
