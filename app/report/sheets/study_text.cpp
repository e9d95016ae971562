#include "app/report/sheets/study_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/maps/shadow_measure.h"
#include "app/report/maps/sheet_text.h"
#include "core/base/safe_text.h"
#include "core/base/units.h"
#include "core/base/version.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"

namespace noonmark {

namespace {

struct CountedNoun {
    std::string_view noun, one, several;
};
constexpr std::array countedNouns{CountedNoun{"day", NM_TEXT("%1 day"), NM_TEXT("%1 days")},
                                  CountedNoun{"step", NM_TEXT("%1 step"), NM_TEXT("%1 steps")},
                                  CountedNoun{"value", NM_TEXT("%1 value"), NM_TEXT("%1 values")},
                                  CountedNoun{"edit", NM_TEXT("%1 edit"), NM_TEXT("%1 edits")},
                                  CountedNoun{"place", NM_TEXT("%1 place"), NM_TEXT("%1 places")},
                                  CountedNoun{"building", NM_TEXT("%1 building"), NM_TEXT("%1 buildings")},
                                  CountedNoun{"part", NM_TEXT("%1 part"), NM_TEXT("%1 parts")}};

QString plainWords(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

QString describeCount(std::uint64_t count) { return sheetNumbers(formatNumber(double(count))); }

QString describeCount(std::uint64_t count, std::string_view noun) {
    if (isEnglishInUse()) return QString::fromStdString(countOf(count, noun));
    const auto known = std::ranges::find(countedNouns, noun, &CountedNoun::noun);
    if (known == countedNouns.end()) return describeCount(count) + u' ' + sheetText(noun);
    return (count == 1 ? sheetText(known->one) : sheetText(known->several)).arg(describeCount(count));
}

QString describeAmount(double amount, int decimals) {
    QString words = QString::fromStdString(formatNumber(amount, decimals));
    if (decimals > 0) {
        while (words.endsWith(u'0')) words.chop(1);
        if (words.endsWith(u'.')) words.chop(1);
    }
    return sheetNumbers(words.toStdString());
}

QString describeLatLon(LonLat place) {
    return QStringLiteral("%1 %2, %3 %4")
        .arg(fixedNumber(std::abs(place.latDeg), 5))
        .arg(place.latDeg < 0 ? sheetText("S") : sheetText("N"))
        .arg(fixedNumber(std::abs(place.lonDeg), 5))
        .arg(place.lonDeg < 0 ? sheetText("W") : sheetText("E"));
}

QString describePlace(const Region& region, const Frame& frame) {
    const Box2 box = bounds(region);
    if (box.empty()) return {};
    const glm::vec2 size = box.high - box.low;
    const LonLat middle = frame.lonLatFromLocal(glm::dvec2(box.low + box.high) / 2.0);
    return sheetText("%1 m east-west by %2 m north-south around %3 (WGS84)")
        .arg(describeAmount(double(size.x), 0), describeAmount(double(size.y), 0), describeLatLon(middle));
}

QString describeSunlit(const Study& study) {
    if (isInstant(study.field)) return {};
    return sheetText("sun above the horizon for %1 min a day")
        .arg(describeAmount(study.field.sunlitMinutesPerDay));
}

QString describeData(const Study& study) { return describeData(study.provenance.attribution); }

QString describeData(const std::string& attribution) {
    QString source = QString::fromStdString(attribution);
    source.replace(QStringLiteral("(c)"), QStringLiteral("©"));
    return source.isEmpty() ? QString() : sheetText("Data: ") + source;
}

QString describeEngineUsed(const std::string& engine) {
    return sheetText(engine.substr(0, engine.find(" (chosen: ")));
}

QString describeProgram() {
    const std::string_view number = version();
    return QStringLiteral("Noonmark ") + QString::fromUtf8(number.data(), qsizetype(number.size()));
}

std::vector<FigureText> figureTexts(const std::vector<FigureLine>& lines) {
    std::vector<FigureText> figures;
    for (const FigureLine& line : lines)
        figures.push_back({plainWords(labelOf(line)), plainWords(valueOf(line))});
    return figures;
}

QString defineFigures(std::vector<FigureLine> lines) {
    std::erase_if(lines, [](const FigureLine& line) { return line.figure->use != FigureUse::result; });
    return plainWords(definitionsOf(lines)).replace(QStringLiteral(" x "), QStringLiteral(" × "));
}

std::vector<FigureText> computeFigures(const Study& study, ShownAs show) {
    return makeStudyFigures(study.statistics, study.field, study.sun.steps.size(), show);
}

std::vector<FigureText> makeStudyFigures(const ShadowStatistics& s, const ShadowField& field,
                                         std::uint64_t steps, ShownAs show) {
    const double sunlit = field.sunlitMinutesPerDay;
    const FigureContext context{s.receiverAreaM2, sunlit, isInstant(field), show};
    std::vector<FigureText> figures = figureTexts(listLines(shadowFigures().of(s), context));
    for (const ShadeColumn& shade : listShadeColumns(field)) {
        const ShadowStatistics withTrees = computeStatistics(*shade.field);
        const auto lines = figureTexts(listLines({treeFigures(shade.column), &withTrees}, context));
        figures.insert(figures.end(), lines.begin(), lines.end());
    }
    if (!context.isInstant)
        figures.push_back({sheetText("Sunlit time"), describeAmount(sunlit) + sheetText(" min a day")});
    figures.push_back({sheetText("Cell size"), describeAmount(field.grid.cellM, 2) + QStringLiteral(" m")});
    figures.push_back({sheetText("Steps of the sun"), describeCount(steps)});
    return figures;
}

namespace {

QString describeClock(double minutes) {
    const long whole = std::lround(minutes);
    return QString::fromStdString(fmt::format("{:02}:{:02}", whole / 60, whole % 60));
}

/// "sunrise", "sunrise + 90 min", "sunrise - 10 min"
QString describeSun(const QString& event, long minutesLater) {
    if (minutesLater == 0) return event;
    const QString sign = minutesLater > 0 ? sheetText(" + %1 min") : sheetText(" - %1 min");
    return event + sign.arg(std::abs(minutesLater));
}

QString describeSolarHours(const SolarHours& window) {
    return describeSun(sheetText("sunrise"), long(window.afterSunrise.count())) + sheetText(" to ") +
           describeSun(sheetText("sunset"), -long(window.beforeSunset.count()));
}

QString describeWallClock(const Period& period) {
    const double from = double(period.from.count());
    const double until = from + period.hours * 60;
    if (until <= 24 * 60) return describeClock(from) + sheetText(" to ") + describeClock(until);
    return sheetText("%1 for %2 h").arg(describeClock(from), describeAmount(period.hours, 4));
}

}  // namespace

QString describeDates(CivilDate date) {
    static constexpr std::array months{"January", "February", "March",     "April",   "May",      "June",
                                       "July",    "August",   "September", "October", "November", "December"};
    if (!date.ok()) return sheetText("no date");
    if (!isEnglishInUse()) return QString::fromStdString(wordingInUse().date(date));
    return QString::fromStdString(
        fmt::format("{} {} {}", unsigned(date.day()), months[unsigned(date.month()) - 1], int(date.year())));
}

std::string asOnSheets(const std::string& dateOrText) {
    constexpr std::size_t dateLength = 10;
    const auto date = parseDate(dateOrText.substr(0, dateLength));
    const std::string rest = date ? dateOrText.substr(dateLength) : std::string();
    const bool isDate = date && (rest.empty() || rest.front() == ',');
    return isDate ? describeDates(*date).toStdString() + rest : dateOrText;
}

Sentence asOnSheets(Sentence sentence) {
    for (Sentence::Argument& argument : sentence.arguments)
        if (auto* const text = std::get_if<std::string>(&argument)) *text = asOnSheets(*text);
    return sentence;
}

QString describeDays(const Period& period) {
    if (period.days == 1 || !period.start.ok()) return describeDates(period.start);
    const CivilDate last = std::chrono::sys_days(period.start) + std::chrono::days(period.days - 1);
    return sheetText("%1 to %2 (%3)")
        .arg(describeDates(period.start), describeDates(last),
             describeCount(std::uint64_t(period.days), "day"));
}

QString describeHours(const Period& period) {
    if (!period.window && period.hours == 0)
        return sheetText("at ") + describeClock(double(period.from.count()));
    const QString hours = period.window ? describeSolarHours(*period.window) : describeWallClock(period);
    return hours + sheetText(", every %1 min").arg(shortNumber(period.stepMinutes, 6));
}

QString describePeriod(const Period& period) {
    return QStringLiteral("%1, %2, %3")
        .arg(describeDays(period), describeHours(period), QString::fromStdString(period.zone));
}

}  // namespace noonmark
