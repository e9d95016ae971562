#include "app/window/massing/live_shadow.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/accumulate/blank_field.h"
#include "core/accumulate/projected/bit_raster.h"
#include "core/accumulate/projected_shadows.h"

namespace noonmark {

namespace {

constexpr int cellsToASide = 400;
constexpr int planes = 7;
static_assert(LiveShadow::mostMoments < (1U << planes));

// Moments from all of the period: of a long one, of many days and hours.
SunSteps spread(const SunSteps& sun, std::size_t most) {
    SunSteps chosen = sun;
    const std::size_t all = sun.steps.size();
    if (all <= most) return chosen;
    chosen.steps.clear();
    for (std::size_t k = 0; k < most; ++k) chosen.steps.push_back(sun.steps[(2 * k + 1) * all / (2 * most)]);
    return chosen;
}

/// How often each of the 64 cells of a word is in shadow: bit j of the numbers lies in plane j.
using Counter = std::array<std::uint64_t, planes>;

void count(Counter& counter, std::uint64_t shaded) {
    for (std::uint64_t& plane : counter) {
        const std::uint64_t carry = plane & shaded;
        plane ^= shaded;
        shaded = carry;
        if (shaded == 0) return;
    }
}

unsigned numberAt(const Counter& counter, int bit) {
    unsigned number = 0;
    for (int plane = 0; plane < planes; ++plane) number |= unsigned(counter[plane] >> bit & 1) << plane;
    return number;
}

std::vector<Counter> counted(const BitLayout& layout, std::size_t moments,
                             const std::vector<std::uint64_t>& city,
                             const std::vector<std::uint64_t>& shape) {
    std::vector<Counter> counters(layout.words(), Counter{});
    for (std::size_t moment = 0; moment < moments; ++moment)
        for (std::size_t word = 0; word < counters.size(); ++word) {
            const std::size_t at = moment * counters.size() + word;
            if (const std::uint64_t shaded = city[at] | shape[at]; shaded != 0) count(counters[word], shaded);
        }
    return counters;
}

}  // namespace

Result<std::shared_ptr<const LiveShadow>> LiveShadow::around(const City& city, glm::dvec2 centre,
                                                             double halfM, const Period& period,
                                                             const Observer& observer, Progress& progress,
                                                             const std::stop_token& stop) {
    const auto sun = sunSteps(period, observer, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    if (sun->steps.empty())
        return failure("The sun is below the horizon all the time", textOf(period),
                       "Choose other hours or days");
    const auto half = glm::vec2(float(halfM));
    const Region region = regionFromLocalBox({glm::vec2(centre) - half, glm::vec2(centre) + half});
    auto receivers = receiversOnGround(city, region, {.cellM = 2 * halfM / cellsToASide}, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    std::shared_ptr<LiveShadow> live(new LiveShadow);
    live->receivers_ = *std::move(receivers);
    live->sun_ = spread(*sun, mostMoments);
    live->all_ = sun->steps.size();
    live->blank_ = blankField(live->receivers_, *sun);
    progress.report(0.1, "shadow of the city around");
    auto rasters = projectedRasters(city, live->receivers_, live->sun_);
    if (!rasters) return tl::make_unexpected(rasters.error());
    if (stop.stop_requested()) return cancelled();
    live->rasters_ = *std::move(rasters);
    return std::shared_ptr<const LiveShadow>(std::move(live));
}

ShadowField LiveShadow::with(const std::vector<std::shared_ptr<const Building>>& shape) const {
    City alone;
    alone.buildings = shape;
    const BitLayout layout(receivers_.grid);
    const std::vector<std::uint64_t> own = projectedRasters(alone, receivers_, sun_).value();
    const std::vector<Counter> counters = counted(layout, moments(), rasters_, own);
    ShadowField field = blank_;
    const double minutes = field.sunlitMinutesPerDay / double(moments());
    for (const std::uint32_t cell : receivers_.cells) {
        const int column = int(cell) % receivers_.grid.columns, row = int(cell) / receivers_.grid.columns;
        field.grossMin[cell] = float(minutes * numberAt(counters[layout.word(column, row)], column & 63));
    }
    std::ranges::fill(field.continuousMin, std::numeric_limits<float>::quiet_NaN());
    return field;
}

}  // namespace noonmark
