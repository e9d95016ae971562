#include "app/gui/tools/massing/massing_text.h"

#include <QObject>
#include <QStringList>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/gui/base/widgets/number_text.h"

namespace noonmark {

QString describeAssumedStoreys(int storeys) { return QObject::tr("about %1").arg(describeStoreys(storeys)); }

QString describeStoreys(int storeys) {
    return QObject::tr("%1 storey(s)", "", storeys).arg(formatCount(quint64(storeys)));
}

QString describeFigures(const MassingFigures& figures, double groundElevationM) {
    return QObject::tr("%1, %2\n%3 floor area, FAR %4")
        .arg(describeHeight(figures.heightM, groundElevationM), describeStoreys(figures.storeys),
             describeSmallArea(figures.grossFloorM2), groupDigits(figures.floorAreaRatio, 2));
}

namespace {

QString describePercent(double share) { return groupDigits(share * 100) + QStringLiteral(" %"); }
QString describeDegrees(double degrees) { return formatAmount(degrees) + QStringLiteral("°"); }

QString describePlate(const PlateSize& plate) {
    if (plate.areaM2) return describeSmallArea(*plate.areaM2);
    return plate.shareOfLot ? describePercent(*plate.shareOfLot) : QObject::tr("the whole lot");
}

}  // namespace

QString describeNearest(const NearestFit& fit) {
    const MassingSettings& tower = fit.settings;
    const auto setback = [&]() -> const Setback& { return tower.setbacks.at(fit.setback); };
    switch (fit.number) {
        case MassingNumber::height:
            return tower.storeys > 0 ? describeStoreys(tower.storeys) : describeLength(tower.heightM);
        case MassingNumber::storeyHeight:
            return describeLength(tower.storeyHeightM);
        case MassingNumber::turn:
            return describeDegrees(tower.clockwiseDeg);
        case MassingNumber::plate:
            return describePlate(tower.plate);
        case MassingNumber::taper:
            return describePercent(tower.walls.taper);
        case MassingNumber::twist:
            return describeDegrees(tower.walls.twistDeg);
        case MassingNumber::podiumStoreys:
            return describeStoreys(tower.podium->storeys);
        case MassingNumber::podiumPlate:
            return describePlate(tower.podium->plate);
        case MassingNumber::podiumTaper:
            return describePercent(tower.podium->walls.taper);
        case MassingNumber::podiumTwist:
            return describeDegrees(tower.podium->walls.twistDeg);
        case MassingNumber::setbackAbove:
            return describeLength(setback().aboveM);
        case MassingNumber::setbackInset:
            return describeLength(setback().insetM);
        case MassingNumber::setbackTaper:
            return describePercent(setback().walls.taper);
        case MassingNumber::setbackTwist:
            return describeDegrees(setback().walls.twistDeg);
    }
    return {};
}

QString describeCopy(const CopiedMassing& copy) {
    QStringList changes;
    if (copy.plateReduced) changes << QObject::tr("the floor plate is smaller");
    if (copy.turnDropped) changes << QObject::tr("the tower is not turned");
    if (copy.twistDropped) changes << QObject::tr("the tower is not twisted");
    if (copy.setbacksDropped > 0) changes << QObject::tr("upper setbacks are left out");
    if (changes.isEmpty()) return {};
    return QObject::tr("To fit this lot: %1.").arg(changes.join(QStringLiteral(", ")));
}

QString describeMove(glm::dvec2 byM) {
    return QObject::tr("%1 %2, %3 %4")
        .arg(describeLength(std::abs(byM.x)), byM.x < 0 ? QObject::tr("west") : QObject::tr("east"),
             describeLength(std::abs(byM.y)), byM.y < 0 ? QObject::tr("south") : QObject::tr("north"));
}

}  // namespace noonmark
