#include "app/gui/base/widgets/unit_columns.h"

#include <QObject>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/number_words.h"

namespace noonmark {

namespace {

QString inUnits(const QString& metric, const QString& imperial) {
    switch (unitsInUse()) {
        case UnitSystem::metric:
            return metric;
        case UnitSystem::imperial:
            return imperial;
        case UnitSystem::both:
            break;
    }
    return QStringLiteral("%1 (%2)").arg(metric, imperial);
}

}  // namespace

QString areaUnit() { return inUnits(QStringLiteral("m²"), QObject::tr("sq ft")); }

QString lengthUnit() { return inUnits(QStringLiteral("m"), QObject::tr("ft")); }

QString areaNumber(double squareMetres) {
    return inUnits(groupDigits(squareMetres), groupDigits(squareMetres / squareMetresPerSquareFoot));
}

QString lengthNumber(double metres) {
    return inUnits(groupDigits(metres, 1), groupDigits(metres / metresPerFoot, 1));
}

QString signedAreaNumber(double squareMetres) {
    return (squareMetres > 0 ? QStringLiteral("+") : QString()) + areaNumber(squareMetres);
}

}  // namespace noonmark
