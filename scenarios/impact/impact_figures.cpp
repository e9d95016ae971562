#include "scenarios/impact/impact_figures.h"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "core/receivers/rasterize.h"
#include "scenarios/impact/impact_figure_tables.h"

namespace noonmark {

namespace {

// Counts cells and sums minutes of one measure.
class Sum {
public:
    explicit Sum(double thresholdMin) : thresholdMin_(std::max(noChangeMin, thresholdMin)) {}

    void add(double change) {
        figures_.gainedM2 += change > thresholdMin_;
        figures_.lostM2 += change < -thresholdMin_;
        figures_.touchedM2 += change > noChangeMin;
        figures_.easedM2 += change < -noChangeMin;
        figures_.meanMin += change;
        figures_.mostGainedMin = std::max(figures_.mostGainedMin, change);
        figures_.mostLostMin = std::max(figures_.mostLostMin, -change);
    }

    [[nodiscard]] ChangeFigures figures(double cellM2, double receivers) const {
        if (std::isnan(figures_.meanMin)) return notComputed();
        ChangeFigures figures = figures_;
        for (double* areaM2 : {&figures.gainedM2, &figures.lostM2, &figures.touchedM2, &figures.easedM2})
            *areaM2 *= cellM2;
        figures.meanMin = receivers > 0 ? figures.meanMin / receivers : 0;
        return figures;
    }

private:
    double thresholdMin_;
    ChangeFigures figures_;  // areas count cells until figures()
};

template <class Cells>
ImpactFigures countCells(const Impact& impact, double thresholdMin, const Cells& cells) {
    const double cellM2 = impact.grid.cellAreaM2();
    ImpactFigures figures{.thresholdMin = thresholdMin};
    Sum gross(thresholdMin), continuous(thresholdMin);
    double receivers = 0;
    for (const std::size_t i : cells) {
        figures.becameBuildingM2 += impact.change[i] == CellChange::becameBuilding ? cellM2 : 0;
        figures.becameGroundM2 += impact.change[i] == CellChange::becameGround ? cellM2 : 0;
        if (std::isnan(impact.grossMin[i])) continue;
        gross.add(double(impact.grossMin[i]));
        continuous.add(double(impact.continuousMin[i]));
        ++receivers;
    }
    figures.receiverAreaM2 = receivers * cellM2;
    figures.gross = gross.figures(cellM2, receivers);
    figures.continuous = continuous.figures(cellM2, receivers);
    if (impact.sunlitMinutesPerDay > 0)
        figures.shadowAreaChangeM2 =
            figures.gross.meanMin / impact.sunlitMinutesPerDay * figures.receiverAreaM2;
    return figures;
}

}  // namespace

ImpactFigures computeFigures(const Impact& impact, double thresholdMin) {
    return countCells(impact, thresholdMin, std::views::iota(std::size_t{0}, impact.grossMin.size()));
}

ImpactFigures computeFigures(const Impact& impact, const Region& region, double thresholdMin) {
    return computeFigures(impact, collectCells(region.polygons, impact.grid), thresholdMin);
}

ImpactFigures computeFigures(const Impact& impact, const std::vector<std::uint32_t>& cells,
                             double thresholdMin) {
    return countCells(impact, thresholdMin, cells);
}

}  // namespace noonmark
