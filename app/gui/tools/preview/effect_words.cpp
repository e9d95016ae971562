#include "app/gui/tools/preview/effect_words.h"

#include <QObject>
#include <QStringList>

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/session/study/region_words.h"
#include "app/report/maps/impact_legend.h"

namespace noonmark {

namespace {

constexpr std::size_t maxPlaces = 4;

QString minutesOf(double minutes) { return groupDigits(minutes, minutes < 10 ? 1 : 0); }

// "1,230 m² over 30 min"
QString overThreshold(double areaM2, double thresholdMin) {
    return QObject::tr("%1 over %2 min").arg(describeSmallArea(areaM2), minutesOf(thresholdMin));
}

QString describeNewShadow(const LiveChange& change) {
    if (change.figures.front().gross.touchedM2 == 0) return QObject::tr("No new shadow");
    if (isInstant(change.impact))
        return QObject::tr("New shadow: %1").arg(describeSmallArea(change.figures.front().gross.touchedM2));
    QStringList areas;
    for (const ImpactFigures& figures : change.figures)
        areas << overThreshold(figures.gross.gainedM2, figures.thresholdMin);
    return QObject::tr("New shadow a day: %1").arg(areas.join(QStringLiteral(", ")));
}

QString describeWorst(const LiveChange& change) {
    return QObject::tr("Worst spot: +%1 min a day")
        .arg(minutesOf(change.figures.front().gross.mostGainedMin));
}

QString describeLess(const LiveChange& change) {
    const ImpactFigures& figures = change.figures.front();
    if (isInstant(change.impact))
        return QObject::tr("Less shadow: %1").arg(describeSmallArea(figures.gross.easedM2));
    return QObject::tr("Less shadow a day: %1")
        .arg(overThreshold(figures.gross.lostM2, figures.thresholdMin));
}

QString describePlace(const PlaceChange& place, bool instant) {
    const ChangeFigures& gross = place.figures.gross;
    const QString name = QString::fromStdString(place.name);
    QString words = instant ? QObject::tr("%1: %2").arg(name, describeSmallArea(gross.touchedM2))
                            : QObject::tr("%1: %2, up to +%3 min")
                                  .arg(name, overThreshold(gross.gainedM2, place.figures.thresholdMin),
                                       minutesOf(gross.mostGainedMin));
    if (!place.whole) words += QObject::tr(" (of the part that is measured)");
    return words;
}

}  // namespace

QString describeEffect(const LiveChange& change, const QString& verdicts) {
    const bool instant = isInstant(change.impact);
    QStringList lines{describeNewShadow(change)};
    if (!instant && change.worst) lines << describeWorst(change);
    if (change.figures.front().gross.easedM2 > 0) lines << describeLess(change);
    const std::size_t shown = std::min(change.places.size(), maxPlaces);
    for (std::size_t i = 0; i < shown; ++i) lines << describePlace(change.places[i], instant);
    if (const std::size_t more = change.places.size() - shown; more > 0)
        lines << QObject::tr("and %1 more place(s)", "", pluralNumber(more)).arg(formatCount(more));
    if (change.reachesBeyond) lines << QObject::tr("The change reaches beyond the ground that is measured");
    if (!verdicts.isEmpty()) lines << verdicts;
    return lines.join(u'\n');
}

}  // namespace noonmark
