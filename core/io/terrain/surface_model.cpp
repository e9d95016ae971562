#include "core/io/terrain/ground_choice.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/geometric.hpp>
#include <limits>

#include "core/city/terrain/post_grid.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

/// Which posts of a surface model do not show the ground: the `covered` ones (by outlines of buildings), and
/// those of trees and the like, found by a progressive morphological filter (Zhang and others, 2003: openings
/// by windows that grow to 40 m; what they take away is no ground if it is higher than 0.5 m plus 0.3 of the
/// window's growth, at most 3 m). A ridge narrower than the window may count as raised. O(posts) for each
/// window, on all cores. Ends early when stopped.
std::vector<char> findRaisedPosts(const Terrain& surface, const std::vector<char>& covered,
                                  const std::stop_token& stop = {});

constexpr double widestM = 20;   // half of the widest window
constexpr float hiddenM = 1e6F;  // stands for elevations under buildings

enum class Extreme { lowest, highest };

// The extreme of each value and its neighbours up to a radius, of values `stride` apart.
void slideExtreme(const float* from, float* to, std::size_t stride, int count, int radius, Extreme extreme) {
    std::deque<int> best;  // places whose values may still be the extreme, the best one first
    const auto at = [&](int i) { return from[std::size_t(i) * stride]; };
    const auto isNoBetter = [&](float old, float next) {
        return extreme == Extreme::lowest ? old >= next : old <= next;
    };
    for (int i = 0; i < count + radius; ++i) {
        while (i < count && !best.empty() && isNoBetter(at(best.back()), at(i))) best.pop_back();
        if (i < count) best.push_back(i);
        const int middle = i - radius;
        if (middle < 0) continue;
        if (best.front() < middle - radius) best.pop_front();
        to[std::size_t(middle) * stride] = at(best.front());
    }
}

class Filter {
public:
    Filter(const PostGrid& posts, const std::stop_token& stop) : posts_(posts), stop_(stop) {}

    std::vector<float> find(const std::vector<float>& values, int radius, Extreme extreme) const {
        std::vector<float> rows(values.size()), both(values.size());
        const auto columns = std::size_t(posts_.columns);
        tbb::parallel_for(0, posts_.rows, [&](int row) {
            const std::size_t first = std::size_t(row) * columns;
            if (!stop_.stop_requested())
                slideExtreme(&values[first], &rows[first], 1, posts_.columns, radius, extreme);
        });
        tbb::parallel_for(std::size_t{0}, columns, [&](std::size_t column) {
            if (!stop_.stop_requested())
                slideExtreme(&rows[column], &both[column], columns, posts_.rows, radius, extreme);
        });
        return both;
    }

    std::vector<float> open(const std::vector<float>& values, int radius) const {
        return find(find(values, radius, Extreme::lowest), radius, Extreme::highest);
    }

private:
    const PostGrid& posts_;
    const std::stop_token& stop_;
};

// The surface with the lowest elevation around in place of what is covered.
std::vector<float> lowerCovered(const Terrain& surface, const std::vector<char>& covered,
                                const Filter& filter, int radius) {
    std::vector<float> values = surface.elevationM;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (covered[i]) values[i] = hiddenM;
    const std::vector<float> lowest = filter.find(values, radius, Extreme::lowest);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (covered[i]) values[i] = std::min(lowest[i], surface.elevationM[i]);
    return values;
}

std::vector<char> findRaisedPosts(const Terrain& surface, const std::vector<char>& covered,
                                  const std::stop_token& stop) {
    const Filter filter(surface.grid, stop);
    const double cellM = surface.grid.cellM;
    const int widest = std::max(1, int(std::ceil(widestM / cellM)));
    std::vector<char> raised = covered;
    std::vector<float> values = lowerCovered(surface, covered, filter, widest);
    int before = 0;
    for (int radius = 1; before < widest && !stop.stop_requested(); radius = std::min(2 * radius, widest)) {
        std::vector<float> opened = filter.open(values, radius);
        const auto maxM = float(std::min(3.0, 0.5 + 0.3 * 2 * (radius - before) * cellM));
        for (std::size_t i = 0; i < values.size(); ++i)
            if (values[i] - opened[i] > maxM) raised[i] = 1;
        values = std::move(opened);
        before = radius;
    }
    return raised;
}

constexpr double widestCellM = 10;
constexpr double minStepM = 1.5, minStepShare = 0.4;

double medianOf(std::vector<double>& values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Ring onPosts(const Ring& ring, const PostGrid& posts) {
    Ring placed;
    for (const glm::vec2 point : ring) placed.emplace_back(posts.columnRowOf(glm::dvec2(point)));
    return placed;
}

// Which posts lie in the outlines of buildings that stand on the ground.
std::vector<char> findCovered(const PostGrid& posts, const BuildingList& buildings,
                              const std::stop_token& stop) {
    std::vector<char> covered(posts.size());
    const Grid grid{-0.5, -0.5, 1, posts.columns, posts.rows};
    for (const auto& building : buildings)
        for (const Part& part : building->parts) {
            if (stop.stop_requested()) return covered;
            Footprint placed{onPosts(part.footprint.outer, posts), {}};
            for (const Ring& hole : part.footprint.holes) placed.holes.push_back(onPosts(hole, posts));
            forEachRun(placed, grid, [&](int row, int first, int end) {
                for (int column = first; column < end; ++column) covered[posts.index(column, row)] = 1;
            });
        }
    return covered;
}

// The posts beside marked ones, in rows and columns, are marked too.
std::vector<char> grow(const std::vector<char>& marked, const PostGrid& posts) {
    std::vector<char> grown = marked;
    tbb::parallel_for(0, posts.rows, [&](int row) {
        for (int column = 0; column < posts.columns; ++column) {
            const auto isMarked = [&](int c, int r) {
                return c >= 0 && r >= 0 && c < posts.columns && r < posts.rows && marked[posts.index(c, r)];
            };
            if (isMarked(column - 1, row) || isMarked(column + 1, row) || isMarked(column, row - 1) ||
                isMarked(column, row + 1))
                grown[posts.index(column, row)] = 1;
        }
    });
    return grown;
}

class StepMeasure {
public:
    StepMeasure(const Terrain& terrain, const std::vector<char>& covered)
        : terrain_(terrain), covered_(covered), beside_(1.5 * terrain.grid.cellM) {}

    // Nothing if the building is too narrow, or has neighbours all around.
    [[nodiscard]] std::optional<double> stepOf(const Building& building) const {
        std::vector<double> steps;
        for (const Part& part : building.parts)
            if (!part.isOverhanging) addSteps(part.footprint.outer, steps);
        constexpr std::size_t minimum = 4;
        if (steps.size() < minimum) return std::nullopt;
        return medianOf(steps);
    }

private:
    // Outer rings run counter-clockwise: the inside is to the left.
    void addSteps(const Ring& ring, std::vector<double>& steps) const {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 from(ring[i]), along = glm::dvec2(ring[(i + 1) % ring.size()]) - from;
            const double length = glm::length(along);
            if (!(length > 0)) continue;
            const glm::dvec2 inward = glm::dvec2(-along.y, along.x) / length * beside_;
            const int count = std::clamp(int(length / beside_), 1, 100);
            for (int k = 0; k < count; ++k) addStep(from + along * ((k + 0.5) / count), inward, steps);
        }
    }

    void addStep(glm::dvec2 at, glm::dvec2 inward, std::vector<double>& steps) const {
        const glm::dvec2 inside = at + inward, outside = at - inward;
        if (!isCovered(inside) || isCovered(outside) || beyondM(terrain_.grid, outside) > 0) return;
        steps.push_back(double(elevationAt(terrain_, inside)) - double(elevationAt(terrain_, outside)));
    }

    [[nodiscard]] bool isCovered(glm::dvec2 point) const {
        const PostGrid& posts = terrain_.grid;
        const glm::dvec2 at = posts.insideOf(posts.columnRowOf(point));
        return covered_[posts.index(int(std::lround(at.x)), int(std::lround(at.y)))] != 0;
    }

    const Terrain& terrain_;
    const std::vector<char>& covered_;
    double beside_;
};

// The height that the data states; nothing if it is assumed.
std::optional<double> statedHeight(const Building& building) {
    float low = 1e30F;
    for (const Part& part : building.parts) {
        if (part.heightSource == HeightSource::assumed) return std::nullopt;
        low = std::min(low, part.bottomM);
    }
    return double(topM(building)) - double(low);
}

bool isRoof(double stepM, const Building& building) {
    if (stepM <= minStepM) return false;
    const auto height = statedHeight(building);
    return !height || stepM > minStepShare * *height;
}

// Elevations of the surface at points of a grid in the footprint, at least `insideM` from its outline along
// the axes.
std::vector<double> sampleInside(const Footprint& footprint, const Terrain& surface, double insideM) {
    const Box2 box = bounds(footprint);
    const glm::dvec2 low(box.low), size = glm::dvec2(box.high) - low;
    constexpr double maxAcross = 32;
    const double step = std::max({surface.grid.cellM, size.x / maxAcross, size.y / maxAcross});
    std::vector<double> found;
    for (double y = low.y + step / 2; y < double(box.high.y); y += step)
        for (double x = low.x + step / 2; x < double(box.high.x); x += step) {
            const bool isInside =
                contains(footprint, {x - insideM, y}) && contains(footprint, {x + insideM, y}) &&
                contains(footprint, {x, y - insideM}) && contains(footprint, {x, y + insideM});
            if (isInside && beyondM(surface.grid, {x, y}) == 0)
                found.push_back(double(elevationAt(surface, {x, y})));
        }
    return found;
}

}  // namespace

OutlineSteps measureOutlineSteps(const Terrain& terrain, const BuildingList& buildings,
                                 const std::stop_token& stop) {
    OutlineSteps all;
    if (terrain.grid.cellM > widestCellM) return all;
    const std::vector<char> covered = findCovered(terrain.grid, buildings, stop);
    const StepMeasure measure(terrain, covered);
    std::vector<std::optional<double>> steps(buildings.size());
    tbb::parallel_for(std::size_t{0}, buildings.size(), [&](std::size_t i) {
        if (!stop.stop_requested()) steps[i] = measure.stepOf(*buildings[i]);
    });
    std::vector<double> stepped;
    for (std::size_t i = 0; i < buildings.size(); ++i) {
        if (!steps[i]) continue;
        ++all.buildings;
        if (isRoof(*steps[i], *buildings[i])) stepped.push_back(*steps[i]);
    }
    all.stepped = stepped.size();
    if (!stepped.empty()) all.medianM = medianOf(stepped);
    return all;
}

Terrain takeGroundAround(const Terrain& surface, const BuildingList& buildings, const std::stop_token& stop) {
    Terrain ground = surface;
    const PostGrid& posts = ground.grid;
    std::vector<char> covered = findCovered(posts, buildings, stop);
    const int rings = 1 + int(std::ceil(1 / posts.cellM));
    for (int i = 0; i < rings && !stop.stop_requested(); ++i) covered = grow(covered, posts);
    covered = grow(findRaisedPosts(surface, covered, stop), posts);
    if (stop.stop_requested()) return ground;
    const auto open = std::size_t(std::ranges::count(covered, 0));
    if (open == 0) return ground;
    for (std::size_t i = 0; i < posts.size(); ++i)
        if (covered[i]) ground.elevationM[i] = std::numeric_limits<float>::quiet_NaN();
    ground.source.underBuildings = posts.size() - open;
    fillFromAround(ground.elevationM, posts.columns, posts.rows, stop);
    fillGaps(ground.elevationM, posts.columns, posts.rows);
    return ground;
}

std::optional<float> measureHeight(const Part& part, const Terrain& surface, float lowestGroundM) {
    std::vector<double> roof = sampleInside(part.footprint, surface, surface.grid.cellM);
    if (roof.empty()) roof = sampleInside(part.footprint, surface, 0);
    if (roof.empty()) return std::nullopt;
    return float(medianOf(roof)) - lowestGroundM;
}

}  // namespace noonmark
