#include "core/io/terrain/ground_filter.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace noonmark {

namespace {

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

}  // namespace

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

}  // namespace noonmark
