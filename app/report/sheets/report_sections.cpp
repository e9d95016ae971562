#include "app/report/sheets/report_sections.h"

#include <cmath>

#include "app/report/maps/shadow_measure.h"
#include "app/report/maps/sheet_text.h"
#include "app/report/sheets/study_text.h"
#include "core/city/trees/tree.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/text/error_text.h"
#include "core/study/text/height_facts_text.h"
#include "core/study/text/terrain_text.h"

namespace noonmark {

namespace {

QString describeEngine(const Study& study) {
    QString words = sheetText("Engine: %1.").arg(describeEngineUsed(study.field.engine));
    if (study.byReference())
        words += sheetText(
            " At each step a ray is traced from each receiver to the centre of the sun; the receiver is in "
            "shadow if a building or the terrain blocks the ray.");
    return words;
}

QString describeReceiver(const Study& study) {
    const ReceiverPlaces places = study.settings.receivers.places;
    if (places != ReceiverPlaces::ground)
        return sheetText("Receivers: centres of square cells of %1 m on %2, inside the region.")
            .arg(describeAmount(study.field.grid.cellM, 2), sheetText(describe(places)));
    const QString ground = study.city.terrain ? sheetText("the terrain") : sheetText("flat ground");
    return sheetText(
               "Receivers: centres of square cells of %1 m on %2, inside the region and not under a "
               "building.")
        .arg(describeAmount(study.field.grid.cellM, 2), ground);
}

QString describeTerrain(const Study& study) {
    QString words = sheetText("Terrain: %1.").arg(QString::fromStdString(formatText(*study.city.terrain)));
    if (const std::string beyond = formatText(study.terrainCoverage); !beyond.empty())
        words += QStringLiteral(" %1.").arg(QString::fromStdString(beyond));
    return words;
}

// States that the step length was adjusted so that whole steps fill the hours.
QString describeRounding(const Study& study) {
    const Period& period = study.settings.period;
    const double chosen = period.stepMinutes;
    const bool instant = !period.window && period.hours == 0;
    if (instant || std::abs(study.field.stepMinutes - chosen) < 1e-9) return {};
    const QString day = study.sun.maxOffADayMin < 0.005
                            ? QString()
                            : sheetText("; a single day is up to %1 min too long or too short")
                                  .arg(describeAmount(study.sun.maxOffADayMin, 2));
    return sheetText(
               " The requested step was %1 min; its length was adjusted so that whole steps fill the hours "
               "of each day and the period has the exact number of minutes%2.")
        .arg(describeAmount(chosen, 3), day);
}

QString describeStep(const Study& study) {
    return sheetText(
               "Time: %1 steps of %2 min used; %3 left out because the sun was below the horizon (night is "
               "not shadow). Shares of time refer to the time with the sun above the horizon.%4")
        .arg(describeCount(study.sun.steps.size()), describeAmount(study.field.stepMinutes, 4),
             describeCount(study.sun.belowHorizon), describeRounding(study));
}

QString describeAir(const StudySettings& settings) {
    if (!settings.period.refraction) return sheetText("geometric altitude, without refraction");
    return sheetText("apparent altitude, with refraction at %1 hPa and %2 °C")
        .arg(describeAmount(settings.pressureHPa, 2), describeAmount(settings.temperatureC));
}

QString describeSunFrame(const Study& study) {
    const SunFrameFacts facts = computeSunFrame(study.city, study.settings);
    const QString levelled = study.sun.levelled == 0
                                 ? QString()
                                 : sheetText(
                                       " At %1 steps the sun is just above the horizon but below the plane "
                                       "of the geometry; they are computed with the sun in that plane.")
                                       .arg(describeCount(study.sun.levelled));
    return sheetText(
               " In the frame of the geometry true north is rotated by %1° there and the vertical by %2°; at "
               "the farthest corner of the region the vertical differs by up to %3° (%4 s of the sun's "
               "motion).%5")
        .arg(describeAmount(facts.convergenceDeg, 3), describeAmount(facts.tiltDeg, 3),
             describeAmount(facts.verticalErrorDeg, 3), describeAmount(facts.verticalErrorDeg * 240, 1),
             levelled);
}

QString describeSun(const Study& study) {
    const Observer observer = makeObserver(study);
    return sheetText(
               "Sun: ERFA, topocentric, seen from the centre of the region (%1, %2 m); %3. Civil time of %4 "
               "from the tz database.%5")
        .arg(describeLatLon(observer.place), describeAmount(observer.elevationM), describeAir(study.settings),
             QString::fromStdString(study.settings.period.zone), describeSunFrame(study));
}

QString describeFrame(const Study& study) {
    return sheetText("Frame: metres to the east and true north of %1 (WGS84), the CRS of shadow.tif: %2")
        .arg(describeLatLon(study.city.frame.origin()),
             QString::fromStdString(study.city.frame.projString()));
}

QString describeCellError(const Study& study, const CellError& error) {
    const auto percent = [&](double minutes) { return describeAmount(error.percent(minutes), 3); };
    const LonLat worst = study.city.frame.lonLatFromLocal(error.worstM);
    return sheetText(
               "%1 % in the mean, %2 % at the 99th percentile, %3 % (%4 min) at the worst receiver (%5)")
        .arg(percent(error.meanMin), percent(error.p99Min), percent(error.maxMin),
             describeAmount(error.maxMin), describeLatLon(worst));
}

QString describeContinuousError(const Study& study, const SampledError& error) {
    if (!hasRuns(error)) return {};
    return sheetText("; continuous shadow by %1, of the longest day")
        .arg(describeCellError(study, error.continuous));
}

QString describeMeasuredError(const Study& study, const SampledError& error) {
    return sheetText(
               "Measured on %1 of the %2 receivers, spread over the region and traced again by the ray "
               "reference "
               "over the same %3 steps: shadow area off by %4 % of the ground (standard error %5); gross "
               "shadow "
               "by %6, of the sunlit time%7.")
        .arg(describeCount(error.receivers), describeCount(error.ofReceivers),
             describeCount(study.sun.steps.size()), describeAmount(error.areaPct, 4),
             describeAmount(error.areaStandardErrorPct, 4), describeCellError(study, error.gross),
             describeContinuousError(study, error));
}

QString describeEngineError(const Study& study) {
    if (study.error) return describeMeasuredError(study, *study.error);
    if (!study.byReference()) return QString::fromStdString(whyNoError(study));
    return sheetText(
               "All other engines are measured against the ray reference: for the city as modelled, one "
               "exact test decides each receiver and step. Changes between sun and shadow are resolved to "
               "one step (%1 min), edges of shadows to one cell (%2 m).")
        .arg(describeAmount(study.field.stepMinutes, 3), describeAmount(study.field.grid.cellM, 2));
}

QString describeModelError(const Study& study) {
    const bool hasTrees = study.city.trees && !study.city.trees->trees.empty();
    return sheetText(
               "Limits of the model: roofs are flat unless the data contains their shape; %1; the sun is a "
               "point, whereas its real disc of 0.53° blurs a shadow's edge by about 1 m per 100 m of "
               "distance "
               "from the occluder. An error in height moves the end of a shadow by error / tan(altitude of "
               "the "
               "sun): see the sources of the heights.")
        .arg(hasTrees ? sheetText("trees count only in figures that name them, street furniture in none")
                      : sheetText("trees and street furniture are not included"));
}

}  // namespace

TextBlocks definitionBlocks(const Study& study, ShownAs show) {
    TextBlocks blocks;
    for (const GeometryHeadline& headline : listGeometryHeadlines(study.city, study.heights))
        blocks.push_back(heading(QString::fromStdString(headline.text)));
    const QString shares = sheetText(" Shares: of the receivers' area and of the sunlit time.");
    blocks.push_back(body(defineFigures(listLines(shadowFigures().of(study.statistics),
                                                  {.isInstant = isInstant(study.field), .show = show})) +
                          shares));
    if (!isInstant(study.field) && !hasRuns(study.statistics))
        blocks.push_back(body(sheetText("Continuous shadow was not counted.")));
    return blocks;
}

TextBlocks errorBlocks(std::span<const ShownError> errors) {
    TextBlocks blocks{heading(sheetText("Error against the ray reference, on a sample"))};
    for (ShownError error : errors) {
        error.of = asOnSheets(error.of);
        blocks.push_back(body(QStringLiteral("%1: %2 (%3).")
                                  .arg(QString::fromStdString(labelOf(error)),
                                       QString::fromStdString(formatText(describe(error))),
                                       describeCount(error.count, "value"))));
    }
    if (errors.empty()) blocks.push_back(body(sheetText("Not measured.")));
    return blocks;
}

std::vector<TextBlocks> methodSections(const Study& study, const QString& errorOf) {
    TextBlocks method{heading(sheetText("Method")), body(describeEngine(study)),
                      body(describeReceiver(study))};
    if (study.city.terrain) method.push_back(body(describeTerrain(study)));
    for (const QString& words : {describeStep(study), describeSun(study), describeFrame(study)})
        method.push_back(body(words));
    TextBlocks error{heading(sheetText("Error")), body(describeEngineError(study)),
                     body(describeModelError(study))};
    if (!errorOf.isEmpty() && study.error) error.insert(error.begin() + 1, body(errorOf));
    if (study.monthError)
        error.push_back(body(
            QStringLiteral("%1: %2.").arg(QString::fromStdString(labelOf(*study.monthError)),
                                          QString::fromStdString(formatText(describe(*study.monthError))))));
    return {method, error};
}

}  // namespace noonmark
