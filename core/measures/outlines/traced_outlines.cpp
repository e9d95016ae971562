#include "core/measures/outlines/traced_outlines.h"

#include "core/engines/ray/ray_reference.h"
#include "core/measures/place_receivers.h"
#include "core/receivers/band_polygons.h"
#include "core/receivers/plane_receivers.h"

namespace noonmark {

namespace {

constexpr int noBand = -1;
enum Band : int { baselineBand, incrementalBand, gainedBand, bandCount };

/// The outlines of one step, from the masks of both cities.
class MaskOutlines {
public:
    MaskOutlines(const Receivers& receivers, const StepMasks& baseline, const StepMasks& scenario)
        : receivers_(receivers), baseline_(baseline), scenario_(scenario) {}

    [[nodiscard]] ShadowOutlines trace(std::size_t step) const {
        std::vector<int> shadow(receivers_.grid.size(), noBand), change = shadow;
        for (std::size_t i = 0; i < receivers_.cells.size(); ++i) {
            const bool before = baseline_.shaded(step, i), after = scenario_.shaded(step, i);
            if (before) shadow[receivers_.cells[i]] = baselineBand;
            if (before != after) change[receivers_.cells[i]] = after ? incrementalBand : gainedBand;
        }
        ShadowOutlines outlines;
        outlines.cellM = receivers_.grid.cellM;
        add(std::move(shadow), outlines);
        add(std::move(change), outlines);
        return outlines;
    }

private:
    void add(std::vector<int> bands, ShadowOutlines& outlines) const {
        std::vector<Footprint>* const to[bandCount]{&outlines.baseline, &outlines.incremental,
                                                    &outlines.gained};
        for (BandPolygon& polygon : traceBands(receivers_.grid, std::move(bands)))
            to[polygon.band]->push_back(std::move(polygon.outline));
    }

    const Receivers& receivers_;
    const StepMasks& baseline_;
    const StepMasks& scenario_;
};

SunSteps dayOf(std::span<const SunStep> steps) {
    SunSteps sun;
    sun.steps.assign(steps.begin(), steps.end());
    sun.days.push_back({.first = 0, .count = std::uint32_t(steps.size())});
    return sun;
}

}  // namespace

Result<std::vector<ShadowOutlines>> traceOutlines(const City& baseline, const City* scenario,
                                                  std::span<const SunStep> steps,
                                                  const OutlineSettings& settings, Progress& progress,
                                                  const std::stop_token& stop) {
    std::vector<const City*> cities{&baseline};
    if (scenario != nullptr) cities.push_back(scenario);
    const Region area = makeRegionFromLocalBox(settings.area);
    auto placed = gridOver(area, {settings.cellM}).and_then([&](const Grid& grid) {
        return placeCommonReceivers(cities, area, grid, stop);
    });
    if (!placed) return tl::make_unexpected(placed.error());
    if (settings.planeM) raiseToPlane(*placed, *settings.planeM);
    std::vector<ShadowOutlines> all;
    const auto take = [&](std::size_t, std::span<StepMasks> masks) -> Result<void> {
        const MaskOutlines outlines(*placed, masks.front(), masks.back());
        for (std::size_t step = 0; step < steps.size() && !stop.stop_requested(); ++step)
            all.push_back(outlines.trace(step));
        return stop.stop_requested() ? Result<void>(cancelled()) : Result<void>();
    };
    const auto traced = RayReference().shadeSteps(cities, *placed, dayOf(steps), take, progress, stop);
    if (!traced) return tl::make_unexpected(traced.error());
    return all;
}

}  // namespace noonmark
