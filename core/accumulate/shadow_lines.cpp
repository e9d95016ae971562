#include "core/accumulate/shadow_lines.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/accumulate/lanes.h"

namespace noonmark {

namespace {

// Where the shadow of a point one metre up lies, seen from below it: metres.
glm::dvec2 throwOf(glm::dvec3 sun) { return -glm::dvec2(sun.x, sun.y) / sun.z; }

// The sun's great circle meets a horizontal plane in a straight line, so one number tells where on it the
// shadow is.
std::vector<double> fractions(const SunInterval& interval) {
    const glm::dvec2 start = throwOf(interval.first);
    const glm::dvec2 way = throwOf(interval.last) - start;
    const double length2 = way.x * way.x + way.y * way.y;
    std::vector<double> result;
    for (int step = 0; step < interval.steps; ++step) {
        const glm::dvec2 at = throwOf(interval.at(step)) - start;
        result.push_back(length2 == 0 ? 0 : std::clamp((at.x * way.x + at.y * way.y) / length2, 0.0, 1.0));
    }
    return result;
}

/// Draws all lines of one lane into a row of masks.
class LanePen {
public:
    LanePen(const StepTable& table, double cellsPerMetre)
        : table_(table), cellsPerMetre_(std::abs(float(cellsPerMetre))), sign_(cellsPerMetre < 0 ? -1 : 1) {}

    void line(std::span<ShadowMask> lane, int start, float heightM) const {
        const float length = heightM * cellsPerMetre_;
        const int room = sign_ > 0 ? int(lane.size()) - 1 - start : start;
        const int last = int(std::min(length + 0.5F, float(room)));  // a low sun draws lines past any int
        const float scale = float(StepTable::size) / std::max(length, 1e-6F);
        int from = 0;
        for (int cell = 0; cell <= last; ++cell) {
            const int to = table_.firstBeyond[entry((float(cell) + 0.5F) * scale)];
            // On a long line steps skip cells: the nearest step fills them, or the shadow would have holes.
            const int nearest = table_.nearest[entry(float(cell) * scale)];
            lane[std::size_t(start + sign_ * cell)] |=
                from < to ? between(from, to) : between(nearest, nearest + 1);
            from = to;
        }
    }

private:
    [[nodiscard]] ShadowMask between(int from, int to) const {
        return table_.upTo[std::size_t(to)] & ~table_.upTo[std::size_t(from)];
    }

    static std::size_t entry(float share) { return std::size_t(std::min(share, float(StepTable::size + 1))); }

    const StepTable& table_;
    float cellsPerMetre_;
    int sign_;
};

class ProcessorDrawer final : public ShadowLineDrawer {
public:
    Result<void> draw(const Grid& grid, const ShadowSources& sources, const ShadowMotion& motion,
                      std::span<ShadowMask> masks, std::stop_token stop) override {
        const Lanes lanes(grid, motion.shift);
        const StepTable table(motion.fraction);
        const LanePen pen(table, (lanes.alongX() ? motion.shift.x : motion.shift.y) / grid.cellM);
        tbb::parallel_for(tbb::blocked_range<int>(0, lanes.count(), 8), [&](const auto& range) {
            std::vector<ShadowMask> row;
            for (int lane = range.begin(); lane < range.end() && !stop.stop_requested(); ++lane)
                drawLane(lanes, lane, grid, sources, pen, masks, row);
        });
        if (stop.stop_requested()) return cancelled();
        return {};
    }

    [[nodiscard]] std::string describe() const override { return "lines drawn on the processor"; }

private:
    static void drawLane(const Lanes& lanes, int lane, const Grid& grid, const ShadowSources& sources,
                         const LanePen& pen, std::span<ShadowMask> masks, std::vector<ShadowMask>& row) {
        const auto [first, end] = lanes.stretch(lane);
        row.assign(std::size_t(end - first), 0);
        for (int major = first; major < end; ++major) {
            const std::size_t cell = lanes.cell(lane, major);
            for (int level = 0; level < sources.levels; ++level) {
                const float height = sources.heightM[std::size_t(level) * grid.size() + cell];
                if (height <= 0) break;
                pen.line(row, major - first, height);
            }
        }
        for (int major = first; major < end; ++major)
            masks[lanes.cell(lane, major)] |= row[std::size_t(major - first)];
    }
};

}  // namespace

ShadowMotion motionForward(const SunInterval& interval) {
    return {throwOf(interval.last) - throwOf(interval.first), fractions(interval)};
}

ShadowMotion motionBackward(const SunInterval& interval) {
    ShadowMotion motion = motionForward(interval);
    motion.shift = -motion.shift;
    for (double& fraction : motion.fraction) fraction = 1 - fraction;
    return motion;
}

StepTable::StepTable(const std::vector<double>& fraction) {
    // Positions along the line: the steps themselves forward, the steps in reverse backward.
    const bool falling = fraction.size() > 1 && fraction.front() > fraction.back();
    std::vector<double> ordered = fraction;
    if (falling) std::reverse(ordered.begin(), ordered.end());
    const int steps = int(ordered.size());
    upTo.push_back(0);
    for (int position = 0; position < steps; ++position)
        upTo.push_back(upTo.back() | ShadowMask{1} << (falling ? steps - 1 - position : position));
    for (int entry = 0; entry < size + 2; ++entry) {
        const double share = double(entry) / size;
        const auto beyond = std::lower_bound(ordered.begin(), ordered.end(), entry >= size ? 2.0 : share);
        firstBeyond.push_back(std::uint8_t(beyond - ordered.begin()));
        auto near = std::lower_bound(ordered.begin(), ordered.end(), share);
        if (near == ordered.end() || (near != ordered.begin() && share - *(near - 1) < *near - share)) --near;
        nearest.push_back(std::uint8_t(near - ordered.begin()));
    }
}

std::unique_ptr<ShadowLineDrawer> makeShadowLineDrawer() { return std::make_unique<ProcessorDrawer>(); }

}  // namespace noonmark
