#pragma once

#include <QString>

#include "core/describe/answer_page.h"
#include "core/describe/figure_text.h"
#include "core/study/study.h"
#include "core/sun/period.h"

namespace noonmark {

QString describeCount(std::uint64_t count);                         ///< "176,123"
QString describeCount(std::uint64_t count, std::string_view noun);  ///< "1 place", "1,204 places"
QString describeAmount(double amount, int decimals = 1);            ///< "61,234.5"; without trailing zeros

QString describeLatLon(LonLat place);  ///< "40.75400 N, 73.98401 W"
/// The name of a scenario: that of the existing city in the language of the sheet, the user's as it is.
QString scenarioText(const std::string& name);
/// The name of a region: one that the program made ("the whole city") in the language of the sheet.
QString regionText(const std::string& name);
/// The name of a weight table or of one of its intervals: months and that of the tables' default in the
/// language of the sheet.
QString weightText(const std::string& name);
/// What a figure is, as defineFigures() writes it.
QString definitionText(const Figure& figure);
/// Size and centre of a region.
QString describePlace(const Region& region, const Frame& frame);
QString describeSunlit(const Study& study);  ///< how long the sun is up during the measured hours
QString describeData(const Study& study);    ///< data credit: "Data: © OpenStreetMap contributors"
QString describeData(const std::string& attribution);
/// An engine's name and settings without the reason for an automatic choice: the command that repeats the
/// result names the engine, and must print the same page.
QString describeEngineUsed(const std::string& engine);
QString describeProgram();  ///< "Noonmark 0.1.0"

/// A figure as sheets print it: a row of their table.
struct FigureText {
    QString name;
    QString value;  ///< including its unit
};
std::vector<FigureText> figureTexts(const std::vector<FigureLine>& lines);
/// The definitions of those that are results as one paragraph.
QString defineFigures(std::vector<FigureLine> lines);
std::vector<FigureText> computeFigures(const Study& study, ShownAs show = ShownAs::shadow);
/// The same of a study whose settings are not known. `steps` of the sun.
std::vector<FigureText> makeStudyFigures(const ShadowStatistics& statistics, const ShadowField& field,
                                         std::uint64_t steps, ShownAs show = ShownAs::shadow);

QString describeDates(CivilDate date);  ///< the form of all dates on sheets, in their language
/// A date in the form of files ("2026-03-21"), alone or before a comma, as sheets write it; any other text as
/// it is.
std::string asOnSheets(const std::string& dateOrText);
/// The same of a sentence's arguments.
Sentence asOnSheets(Sentence sentence);

/// The days: "21 March 2026"; "21 March 2026 to 19 April 2026 (30 days)".
QString describeDays(const Period& period);

/// The hours of a day: "09:00 to 15:00, every 1 min"; "at 12:00"; "sunrise + 90 min to sunset - 90 min, every
/// 1 min".
QString describeHours(const Period& period);

/// Days, hours and zone in one line.
QString describePeriod(const Period& period);

}  // namespace noonmark
