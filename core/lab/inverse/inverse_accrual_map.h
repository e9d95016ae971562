#pragma once

#include <memory>
#include <optional>

#include "core/describe/field.h"
#include "core/lab/graph/interval_engine.h"
#include "core/lab/inverse/shadow_lines.h"
#include "core/lab/inverse/sources/source_finder.h"

namespace noonmark {

// Inverse accrual maps (paper, section 5): find the occluders of each cell at both ends of an interval and
// move their shadows along straight lines between. The grid's cells are grouped into lanes (lanes.h, also for
// their sources and masks). sources/ finds the occluders, per block of lanes. lanes.h also joins neighbouring
// sources to runs; shadow_lines.h gives the steps at which a run shades a cell and draws these into masks, on
// the processor or with OpenCL. InverseAccrualScene draws an interval in parts for the receivers, combines
// the parts and uses rays for a low sun.

/// How the shadow sources at an interval's ends are found. Both ways find the same sources, except for
/// rounding at edges.
enum class SourceFinderKind : std::uint8_t {
    projected,  ///< building by building: the shadow of each surface is filled as a polygon of heights
    rays,       ///< Embree's first hits (paper, section 5)
};

struct InverseAccrualSettings {
    /// Number of occluders followed from each cell, nearest first; 1 to 8. Source of the default: paper,
    /// section 5.
    int levels = 3;
    /// Hits closer than this are ignored, metres, 0.01 to 10. Source: paper, section 5 ("100 cm provides good
    /// results").
    float nearestHitM = 1;
    /// Lines also begin up to this distance outside the region, and under its buildings, because shadows that
    /// enter the region lie there at t1. Metres, 0 to 500.
    double marginM = 24;
    /// Steps with a lower sun are traced with one ray each: their shadows come from farther away than lines
    /// are followed and pass more occluders than `levels`. Degrees, 0 to 45; 0: lines only, as in the paper.
    double minSunDeg = 10;
    SourceFinderKind sourceFinder = SourceFinderKind::projected;
    /// Number in listComputeDevices() of the device that draws; none: the processor.
    std::optional<int> openClDevice;
};

/// The options of the engine: "levels", "nearest", "rays" and "device".
const Fields<InverseAccrualSettings>& inverseFields();

/// Inverse accrual maps (paper, section 5). For each cell of flat ground, rays towards the sun at t1 and at
/// tn find the first occluders. The shadow of each occluder moves along a straight line, forward from t1 and
/// backward from tn, and is drawn into the cells' masks. If the sun is too low for that, rays are traced
/// instead. Error: some tenths of a percent of the area, from ignored levels, from rounding lines to cells,
/// and from the straight sun path.
class InverseAccrualMap final : public IntervalEngine {
public:
    /// Error if a setting is out of range or the OpenCL device cannot be used.
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

/// Steps [first, end) of an interval.
struct StepRange {
    int first = 0;
    int end = 0;
    [[nodiscard]] bool empty() const { return first >= end; }
};

/// Those steps as an interval of their own; `part` must not be empty.
SunInterval cutInterval(const SunInterval& interval, StepRange part);

/// Distinguishes sun positions below a limit of altitude.
class LowSun {
public:
    explicit LowSun(double limitDeg);

    [[nodiscard]] bool is(glm::vec3 towardsSun) const { return towardsSun.z < limitZ_; }

    /// The steps with the sun at or above the limit. They are contiguous, because the sun's altitude has a
    /// single maximum on its path.
    [[nodiscard]] StepRange stepsAbove(const SunInterval& interval) const;

    /// The directions below the limit, or those that are not.
    [[nodiscard]] SunSteps of(const SunSteps& directions, bool low) const;

private:
    float limitZ_;
};

/// The parts of an inverse accrual map.
struct InverseAccrualParts {
    std::unique_ptr<SourceFinder> finder;  ///< for the grid of the receivers, padded by `marginCells`
    std::shared_ptr<ShadowLineDrawer> drawer;
    std::unique_ptr<IntervalScene> rays;  ///< for steps with a low sun; null if there are none
    LowSun lowSun;
    int marginCells = 0;
    std::uint32_t buildingsUsed = 0;
};

/// Limit for the share of a block's receivers that are in shadow at an interval's middle step although no
/// line reaches them. If it is exceeded, the block is drawn in two halves. Only checked if most receivers
/// have a full list at both ends.
constexpr double maxMissedShare = 0.01;

/// `grid` extended by this many cells on each side.
Grid padGrid(const Grid& grid, int cells);

/// The receivers must outlive the scene.
std::unique_ptr<IntervalScene> makeInverseAccrualScene(InverseAccrualParts parts, const Receivers& receivers);

}  // namespace noonmark
