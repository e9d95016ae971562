#include "app/gui/docks/scenarios/use_words.h"

#include <QObject>
#include <QStringList>

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/tools/massing/figure_words.h"

namespace noonmark {

namespace {

QString nameOf(const UseArea& area) {
    return area.use.empty() ? QObject::tr("Use not stated") : QString::fromStdString(area.use);
}

// Imported buildings, and towers whose height was changed after they were designed.
QString describeNotCounted(int towers) {
    return QObject::tr("Not counted: %1 building(s) whose floors are not known", "", towers)
        .arg(formatCount(quint64(towers)));
}

}  // namespace

QString describeUses(const ScenarioUses& uses) {
    QStringList words;
    for (const UseArea& area : uses.areas)
        if (area.storeys > 0)
            words << QStringLiteral("%1 %2").arg(nameOf(area), describeSmallArea(area.grossFloorM2));
    return words.join(QStringLiteral(", "));
}

QString describeUseLines(const ScenarioUses& uses) {
    QStringList lines;
    for (const UseArea& area : uses.areas)
        if (area.storeys > 0)
            lines << QStringLiteral("%1: %2, %3")
                         .arg(nameOf(area), describeStoreys(area.storeys),
                              describeSmallArea(area.grossFloorM2));
    if (uses.towersNotCounted > 0) lines << describeNotCounted(uses.towersNotCounted);
    return lines.join(QLatin1Char('\n'));
}

}  // namespace noonmark
