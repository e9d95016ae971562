#pragma once

#include <QString>
#include <vector>

#include "core/bench/chart.h"

namespace noonmark {

/// A tick of an axis.
struct AxisTick {
    double place = 0;  ///< position along the axis, as placeOf() returns it
    QString text;      ///< "0.5", "10⁻⁴"
};

/// Maps values to positions along an axis and computes its ticks: round numbers, few enough to fit side by
/// side. Positions on a logarithmic axis are logarithms.
class AxisScale {
public:
    /// The axis covers all `values`; a logarithmic axis ignores values of 0 or less. Without values it covers
    /// a default range around 1.
    AxisScale(const bench::ChartAxis& axis, const std::vector<double>& values);

    [[nodiscard]] double placeOf(double value) const;
    /// Whether the axis can show the value: finite, and above zero on a logarithmic axis.
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
