#include "app/gui/docks/places/sun_scale.h"

#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/gui/base/widgets/number_words.h"
#include "app/report/maps/palette.h"

namespace noonmark {

namespace {

constexpr int steps = 3;  // classes on each side of the threshold
constexpr QColor withoutCell{0xa8, 0xa8, 0xa8};
constexpr double minutesOfHour = 60;
constexpr double unlimited = std::numeric_limits<double>::infinity();

// The more sun, the lighter, also in grey print. Violet and orange differ for all kinds of colour blindness.
constexpr std::array<QColor, steps> below{QColor{0x2d, 0x10, 0x60}, QColor{0x5b, 0x3a, 0x9b},
                                          QColor{0x99, 0x8e, 0xc3}};
constexpr std::array<QColor, steps> above{QColor{0xf1, 0xa3, 0x40}, QColor{0xfc, 0xc8, 0x6a},
                                          QColor{0xfe, 0xec, 0xb5}};

}  // namespace

void SunScale::add(double from, double to, const QColor& colour, const QString& label) {
    if (!(to > from)) return;
    classes_.push_back({to, colour});
    legend_.classes.push_back({colour, label});
}

SunScale SunScale::ofHours(double thresholdHours, double topHours) {
    SunScale scale;
    scale.legend_.title = QObject::tr("Sun by place");
    scale.legend_.unit = QObject::tr("hours of sun a day");
    const auto addSide = [&](double from, double to, const std::array<QColor, steps>& colours) {
        for (int i = 0; i < steps; ++i) {
            const double low = from + (to - from) * i / steps, high = from + (to - from) * (i + 1) / steps;
            scale.add(low, high, colours[std::size_t(i)],
                      QObject::tr("%1 to %2").arg(formatAmount(low), formatAmount(high)));
        }
    };
    addSide(0, thresholdHours, below);
    addSide(thresholdHours, std::max(topHours, thresholdHours + 1), above);
    scale.classes_.back().to = unlimited;
    return scale;
}

SunScale SunScale::ofChange() {
    constexpr std::array limitsMin{-30.0, -10.0, -1.0, 1.0, 10.0, 30.0};
    SunScale scale;
    scale.legend_.title = QObject::tr("Change of sun by place");
    scale.legend_.unit = QObject::tr("minutes of sun a day");
    for (std::size_t i = 0; i <= limitsMin.size(); ++i) {
        const double from = i == 0 ? -unlimited : limitsMin[i - 1];
        const double to = i == limitsMin.size() ? unlimited : limitsMin[i];
        const QString label = i == 0 ? QObject::tr("below %1").arg(formatAmount(to))
                              : i == limitsMin.size()
                                  ? QObject::tr("from %1").arg(formatAmount(from))
                                  : QObject::tr("%1 to %2").arg(formatAmount(from), formatAmount(to));
        const double share = 1 - 2 * double(i) / double(limitsMin.size());
        scale.add(from / minutesOfHour, to / minutesOfHour, impactColour(share), label);
    }
    return scale;
}

QColor SunScale::colourOf(double hours) const {
    if (std::isnan(hours) || classes_.empty()) return withoutCell;
    const auto found = std::ranges::find_if(classes_, [&](const Class& one) { return hours < one.to; });
    return found == classes_.end() ? classes_.back().colour : found->colour;
}

}  // namespace noonmark
