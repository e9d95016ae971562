#include "app/report/study_words.h"

#include <QLocale>
#include <cmath>

#include "app/report/shadow_measure.h"
#include "core/measures/has_runs.h"
#include "core/version.h"

namespace noonmark {

namespace {

const QLocale& english() {
    static const QLocale locale(QLocale::English, QLocale::UnitedStates);
    return locale;
}

QString minutesWords(double minutes) { return amountWords(minutes) + QStringLiteral(" min"); }

QString minutesADayWords(const Study& study, double minutes) {
    const double sunlit = study.field.sunlitMinutesPerDay;
    const QString share =
        sunlit > 0 ? QStringLiteral(" (%1 %)").arg(amountWords(100 * minutes / sunlit)) : QString();
    return amountWords(minutes) + QStringLiteral(" min/day") + share;
}

QString shadowAreaWords(const ShadowStatistics& s) {
    const double share = s.receiverAreaM2 > 0 ? 100 * s.shadowAreaM2 / s.receiverAreaM2 : 0;
    return QStringLiteral("%1 m² (%2 %)").arg(amountWords(s.shadowAreaM2, 0), amountWords(share));
}

void addMinutes(std::vector<Figure>& figures, const Study& study) {
    const ShadowStatistics& s = study.statistics;
    figures.push_back({QStringLiteral("Gross shadow, mean"), minutesADayWords(study, s.meanGrossMin)});
    figures.push_back({QStringLiteral("Gross shadow, largest"), minutesADayWords(study, s.maxGrossMin)});
    if (hasRuns(s)) {
        figures.push_back({QStringLiteral("Continuous shadow, mean"), minutesWords(s.meanContinuousMin)});
        figures.push_back({QStringLiteral("Continuous shadow, largest"), minutesWords(s.maxContinuousMin)});
    } else {
        figures.push_back({QStringLiteral("Continuous shadow"), QStringLiteral("not counted")});
    }
    figures.push_back({QStringLiteral("Sunlit time"),
                       amountWords(study.field.sunlitMinutesPerDay) + QStringLiteral(" min/day")});
}

}  // namespace

QString countWords(std::uint64_t count) { return english().toString(qulonglong(count)); }

QString amountWords(double amount, int decimals) {
    QString words = english().toString(amount, 'f', decimals);
    if (decimals == 0) return words;
    while (words.endsWith(u'0')) words.chop(1);
    if (words.endsWith(u'.')) words.chop(1);
    return words;
}

QString latLonWords(LonLat place) {
    return QStringLiteral("%1 %2, %3 %4")
        .arg(std::abs(place.latDeg), 0, 'f', 5)
        .arg(place.latDeg < 0 ? QLatin1Char('S') : QLatin1Char('N'))
        .arg(std::abs(place.lonDeg), 0, 'f', 5)
        .arg(place.lonDeg < 0 ? QLatin1Char('W') : QLatin1Char('E'));
}

QString placeWords(const Region& region, const Frame& frame) {
    const Box2 box = bounds(region);
    if (box.empty()) return {};
    const glm::vec2 size = box.high - box.low;
    const LonLat middle = frame.lonLatFromLocal(glm::dvec2(box.low + box.high) / 2.0);
    return QStringLiteral("%1 m east-west by %2 m north-south around %3 (WGS84)")
        .arg(amountWords(double(size.x), 0), amountWords(double(size.y), 0), latLonWords(middle));
}

QString sunlitWords(const Study& study) {
    if (isInstant(study.field)) return {};
    return QStringLiteral("sun above the horizon for %1 min a day")
        .arg(amountWords(study.field.sunlitMinutesPerDay));
}

QString dataWords(const Study& study) { return dataWords(study.provenance.attribution); }

QString dataWords(const std::string& attribution) {
    QString source = QString::fromStdString(attribution);
    source.replace(QStringLiteral("(c)"), QStringLiteral("©"));
    return source.isEmpty() ? QString() : QStringLiteral("Data: ") + source;
}

QString programWords() {
    const std::string_view number = version();
    return QStringLiteral("Noonmark ") + QString::fromUtf8(number.data(), qsizetype(number.size()));
}

std::vector<Figure> figuresOf(const Study& study) {
    const ShadowStatistics& s = study.statistics;
    std::vector<Figure> figures{{QStringLiteral("Shadow area"), shadowAreaWords(s)}};
    if (!isInstant(study.field)) addMinutes(figures, study);
    figures.push_back({QStringLiteral("Receivers"), countWords(s.receivers)});
    figures.push_back(
        {QStringLiteral("Their area"), amountWords(s.receiverAreaM2, 0) + QStringLiteral(" m²")});
    figures.push_back(
        {QStringLiteral("Cell size"), amountWords(study.field.grid.cellM, 2) + QStringLiteral(" m")});
    figures.push_back({QStringLiteral("Steps of the sun"), countWords(study.sun.steps.size())});
    return figures;
}

}  // namespace noonmark
