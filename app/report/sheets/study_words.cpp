#include "app/report/sheets/study_words.h"

#include <cmath>

#include "app/report/maps/shadow_measure.h"
#include "core/base/display_units.h"
#include "core/base/version.h"
#include "core/measures/has_runs.h"

namespace noonmark {

namespace {

QString describeMinutes(double minutes) { return describeAmount(minutes) + QStringLiteral(" min"); }

QString describeMinutesADay(double sunlit, double minutes) {
    const QString share =
        sunlit > 0 ? QStringLiteral(" (%1 %)").arg(describeAmount(100 * minutes / sunlit)) : QString();
    return describeAmount(minutes) + QStringLiteral(" min/day") + share;
}

QString describeShadowArea(const ShadowStatistics& s) {
    const double share = s.receiverAreaM2 > 0 ? 100 * s.shadowAreaM2 / s.receiverAreaM2 : 0;
    return QStringLiteral("%1 m² (%2 %)").arg(describeAmount(s.shadowAreaM2, 0), describeAmount(share));
}

void addMinutes(std::vector<FigureText>& figures, const ShadowStatistics& s, double sunlit) {
    figures.push_back({QStringLiteral("Gross shadow, mean"), describeMinutesADay(sunlit, s.meanGrossMin)});
    figures.push_back({QStringLiteral("Gross shadow, largest"), describeMinutesADay(sunlit, s.maxGrossMin)});
    if (hasRuns(s)) {
        figures.push_back({QStringLiteral("Continuous shadow, mean"), describeMinutes(s.meanContinuousMin)});
        figures.push_back(
            {QStringLiteral("Continuous shadow, largest"), describeMinutes(s.maxContinuousMin)});
    } else {
        figures.push_back({QStringLiteral("Continuous shadow"), QStringLiteral("not counted")});
    }
    figures.push_back({QStringLiteral("Sunlit time"), describeAmount(sunlit) + QStringLiteral(" min/day")});
}

}  // namespace

QString describeCount(std::uint64_t count) { return QString::fromStdString(formatNumber(double(count))); }

QString describeAmount(double amount, int decimals) {
    QString words = QString::fromStdString(formatNumber(amount, decimals));
    if (decimals == 0) return words;
    while (words.endsWith(u'0')) words.chop(1);
    if (words.endsWith(u'.')) words.chop(1);
    return words;
}

QString describeLatLon(LonLat place) {
    return QStringLiteral("%1 %2, %3 %4")
        .arg(std::abs(place.latDeg), 0, 'f', 5)
        .arg(place.latDeg < 0 ? QLatin1Char('S') : QLatin1Char('N'))
        .arg(std::abs(place.lonDeg), 0, 'f', 5)
        .arg(place.lonDeg < 0 ? QLatin1Char('W') : QLatin1Char('E'));
}

QString describePlace(const Region& region, const Frame& frame) {
    const Box2 box = bounds(region);
    if (box.empty()) return {};
    const glm::vec2 size = box.high - box.low;
    const LonLat middle = frame.lonLatFromLocal(glm::dvec2(box.low + box.high) / 2.0);
    return QStringLiteral("%1 m east-west by %2 m north-south around %3 (WGS84)")
        .arg(describeAmount(double(size.x), 0), describeAmount(double(size.y), 0), describeLatLon(middle));
}

QString describeSunlit(const Study& study) {
    if (isInstant(study.field)) return {};
    return QStringLiteral("sun above the horizon for %1 min a day")
        .arg(describeAmount(study.field.sunlitMinutesPerDay));
}

QString describeData(const Study& study) { return describeData(study.provenance.attribution); }

QString describeData(const std::string& attribution) {
    QString source = QString::fromStdString(attribution);
    source.replace(QStringLiteral("(c)"), QStringLiteral("©"));
    return source.isEmpty() ? QString() : QStringLiteral("Data: ") + source;
}

QString describeEngineUsed(const std::string& engine) {
    return QString::fromStdString(engine.substr(0, engine.find(" (chosen: ")));
}

QString describeProgram() {
    const std::string_view number = version();
    return QStringLiteral("Noonmark ") + QString::fromUtf8(number.data(), qsizetype(number.size()));
}

std::vector<FigureText> computeFigures(const Study& study) {
    return makeStudyFigures(study.statistics, study.field, study.sun.steps.size());
}

std::vector<FigureText> makeStudyFigures(const ShadowStatistics& s, const ShadowField& field,
                                         std::uint64_t steps) {
    std::vector<FigureText> figures{{QStringLiteral("Shadow area"), describeShadowArea(s)}};
    if (!isInstant(field)) addMinutes(figures, s, field.sunlitMinutesPerDay);
    figures.push_back({QStringLiteral("Receivers"), describeCount(s.receivers)});
    figures.push_back(
        {QStringLiteral("Area of receivers"), describeAmount(s.receiverAreaM2, 0) + QStringLiteral(" m²")});
    if (s.waterM2 > 0)
        figures.push_back(
            {QStringLiteral("Water left out"), describeAmount(s.waterM2, 0) + QStringLiteral(" m²")});
    figures.push_back(
        {QStringLiteral("Cell size"), describeAmount(field.grid.cellM, 2) + QStringLiteral(" m")});
    figures.push_back({QStringLiteral("Steps of the sun"), describeCount(steps)});
    return figures;
}

}  // namespace noonmark
