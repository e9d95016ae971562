#pragma once

#include <memory>
#include <optional>

#include "core/engines/common/interval_engine.h"
#include "core/engines/inverse/shadow_lines.h"

namespace noonmark {

/// How the sources of shadow at an interval's ends are found. Both find the same, but for rounding at edges.
enum class SourceFinderKind : std::uint8_t {
    projected,  ///< in object order: each surface's shadow is filled as a polygon of heights
    rays,       ///< Embree's first hits (paper, section 5)
};

struct InverseAccrualSettings {
    /// Occluders followed from each place, nearest first; 1 to 8. Source of the default: paper, section 5.
    int levels = 3;
    static constexpr float lowestNearestHitM = 0.01F, highestNearestHitM = 10;
    /// Hits nearer than this are left out, metres, 0.01 to 10. Source: paper, section 5 ("100 cm provides
    /// good results").
    float nearestHitM = 1;
    /// Lines also begin up to this far outside the region, and under its buildings: a shadow that comes from
    /// there was somewhere at t1, too. Metres, 0 to 500.
    double marginM = 24;
    /// Steps with the sun lower than this are traced, a ray each: their shadows come from farther away than
    /// lines are followed, past more occluders than `levels`. Degrees, 0 to 45; 0: lines only, as the paper.
    double lowestSunDeg = 10;
    SourceFinderKind sourceFinder = SourceFinderKind::projected;
    /// Device of listComputeDevices() that draws; none: the processor.
    std::optional<int> openClDevice;
};

/// Inverse accrual maps (paper, section 5). For each cell of flat ground, rays towards the sun at t1 and at
/// tn find the first occluders; the shadow of each moves along a straight line, forward from t1 and backward
/// from tn, and is drawn into the cells' masks. Where the sun is too low for that, rays take over. Error:
/// some tenths of a percent of the area, from the levels left out, the cells that lines are rounded to, and
/// the sun's straight path.
class InverseAccrualMap final : public IntervalEngine {
public:
    /// Error when a setting is out of range or the OpenCL device cannot be used.
    static Result<std::shared_ptr<const InverseAccrualMap>> make(const InverseAccrualSettings& settings);

    [[nodiscard]] Result<std::unique_ptr<IntervalScene>> prepare(const City& city, const Receivers& receivers,
                                                                 const SunSteps& directions,
                                                                 std::stop_token stop) const override;
    [[nodiscard]] std::string_view name() const override { return "Inverse accrual map"; }
    [[nodiscard]] std::string describe() const override;

private:
    explicit InverseAccrualMap(InverseAccrualSettings settings);
    InverseAccrualSettings settings_;
    std::shared_ptr<ShadowLineDrawer> drawer_;
};

}  // namespace noonmark
