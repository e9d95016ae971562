#pragma once

#include <QString>
#include <vector>

#include "core/bench/chart.h"

namespace noonmark {

/// A mark on an axis.
struct AxisTick {
    double place = 0;  ///< where, as placeOf() has it
    QString text;      ///< "0.5", "10⁻⁴"
};

/// From values to places along an axis, and the marks that a reader wants there: round numbers, few enough to
/// stand side by side. Logarithmic axes are linear in their places.
class AxisScale {
public:
    /// Holds all `values` (on a logarithmic axis those above zero). Without any it runs from 0 or 1 on.
    AxisScale(const bench::ChartAxis& axis, const std::vector<double>& values);

    [[nodiscard]] double placeOf(double value) const;
    /// Whether the axis can show it: finite, and above zero on a logarithmic one.
    [[nodiscard]] bool shows(double value) const;

    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    [[nodiscard]] const std::vector<AxisTick>& ticks() const { return ticks_; }

private:
    void setLinear(double least, double most);
    void setLogarithmic(double least, double most);

    bench::ChartAxis axis_;
    double low_ = 0;
    double high_ = 1;
    std::vector<AxisTick> ticks_;
};

}  // namespace noonmark
