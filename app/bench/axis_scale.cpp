#include "app/bench/axis_scale.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

constexpr double maxTicks = 6;
constexpr double edge = 0.06;  // share of the span of a logarithmic axis left free at each end

QString powerText(int exponent) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = exponent < 0 ? QStringLiteral("10⁻") : QStringLiteral("10");
    for (const QChar digit : QString::number(std::abs(exponent))) text += digits[digit.digitValue()];
    return text;
}

QString numberText(double value) {
    const double exponent = std::log10(std::abs(value));
    const bool isPower = std::abs(exponent - std::round(exponent)) < 1e-9;
    if (value != 0 && isPower && std::abs(exponent) > 3.5) return powerText(int(std::lround(exponent)));
    return QString::number(value, 'g', 6);
}

/// 1, 2 or 5 times a power of ten, such that at most `maxTicks` steps fill the span.
double roundStep(double span) {
    double step = std::pow(10, std::floor(std::log10(span / maxTicks)));
    for (const double factor : {2.0, 2.5, 2.0})
        if (span / step > maxTicks) step *= factor;
    return step;
}

/// The multiples within a decade that get a tick.
std::vector<double> marksOfDecade(double decades) {
    if (decades > 2.2) return {1};
    if (decades > 1.2) return {1, 3};
    return {1, 2, 5};
}

}  // namespace

AxisScale::AxisScale(const bench::ChartAxis& axis, const std::vector<double>& values) : axis_(axis) {
    double least = INFINITY, most = -INFINITY;
    for (const double value : values) {
        if (!shows(value)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    if (least > most) least = most = 1;
    axis.logarithmic ? setLogarithmic(least, most) : setLinear(least, most);
}

double AxisScale::placeOf(double value) const { return axis_.logarithmic ? std::log10(value) : value; }

bool AxisScale::shows(double value) const {
    return std::isfinite(value) && (!axis_.logarithmic || value > 0);
}

void AxisScale::setLinear(double least, double most) {
    if (axis_.fromZero) least = std::min(least, 0.0);
    if (most - least < 1e-12) most = least + 1;
    const double step = std::max(roundStep(most - least), axis_.whole ? 1.0 : 0.0), slack = 1e-9 * step;
    low_ = std::floor((least + slack) / step) * step;
    high_ = std::ceil((most - slack) / step) * step;
    for (double value = low_; value < high_ + step / 2; value += step)
        ticks_.push_back({value, numberText(std::abs(value) < step / 2 ? 0 : value)});
}

void AxisScale::setLogarithmic(double least, double most) {
    const double decades = std::max(0.3, std::log10(most / least));
    low_ = std::log10(least) - edge * decades;
    high_ = std::max(std::log10(most), std::log10(least) + decades) + edge * decades;
    const int every = std::max(1, int(std::ceil(decades / maxTicks)));
    for (int decade = int(std::floor(low_)); decade <= int(std::ceil(high_)); ++decade)
        for (const double factor : marksOfDecade(decades)) {
            const double place = decade + std::log10(factor);
            if (decade % every == 0 && place >= low_ && place <= high_)
                ticks_.push_back({place, numberText(factor * std::pow(10, decade))});
        }
}

}  // namespace noonmark
