#include "app/window/massing/figure_words.h"

#include <QObject>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/window/widgets/number_words.h"

namespace noonmark {

QString describeStoreys(int storeys) {
    return storeys == 1 ? QObject::tr("1 storey") : QObject::tr("%1 storeys").arg(storeys);
}

QString describeFigures(const MassingFigures& figures) {
    return QObject::tr("%1 m, %2\n%3 m² floor area, FAR %4")
        .arg(groupDigits(figures.heightM, 1), describeStoreys(figures.storeys),
             groupDigits(figures.grossFloorM2), groupDigits(figures.floorAreaRatio, 2));
}

QString describeMove(glm::dvec2 byM) {
    return QObject::tr("%1 m %2, %3 m %4")
        .arg(groupDigits(std::abs(byM.x), 1), byM.x < 0 ? QObject::tr("west") : QObject::tr("east"),
             groupDigits(std::abs(byM.y), 1), byM.y < 0 ? QObject::tr("south") : QObject::tr("north"));
}

}  // namespace noonmark
