#include "app/gui/tools/massing/figure_words.h"

#include <QObject>
#include <QStringList>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/gui/base/widgets/height_words.h"
#include "app/gui/base/widgets/number_words.h"

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
