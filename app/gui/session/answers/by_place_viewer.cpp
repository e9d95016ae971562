#include <fmt/format.h>

#include <QObject>
#include <algorithm>
#include <cmath>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/study/region_text.h"
#include "core/describe/text.h"
#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

// The table of places paints the view (app/gui/docks/places).
std::optional<AnswerLayer> layerOfPlaces(const std::shared_ptr<const Answer>&) { return std::nullopt; }

std::string errorOf(const SunByPlace& sun) {
    if (!sun.error) return {};
    const CellError& gross = sun.error->gross;
    return fmt::format("cells: {:.3f} % mean, {:.2f} % largest", gross.percent(gross.meanMin),
                       gross.percent(gross.maxMin));
}

std::vector<ResultRow> rowsOfPlaces(const Answer& answer, ShownAs show) {
    const auto& sun = *answer.as<SunOfCities>();
    const SunByPlace& baseline = sun.baseline;
    return makeRows(
        PlaceFigures{sun, baseline.daylight.steps.size(), baseline.daylight.belowHorizon, answer.seconds(),
                     statePeriod(answer.settings()->period), errorOf(baseline), baseline.field.engine},
        show);
}

std::vector<ResultRow> rowsOfSavedPlaces(const SavedContent& saved, ShownAs show) {
    const auto& places = *saved.as<SavedSunByPlace>();
    return makeRows(PlaceFigures{places.sun, places.steps, places.belowHorizon, places.seconds,
                                 saved.answer.origin.period, places.error, saved.answer.origin.engine},
                    show);
}

Sentence titleOfPlaces(const MeasuredPart& part) {
    if (part.baseline.empty()) return {NM_TEXT("Sun by place in %1"), {part.scenario}};
    return {NM_TEXT("Sun by place in %1 compared with %2"), {part.scenario, part.baseline}};
}

QString hoursText(double hours) { return QObject::tr("%1 h of sun a day").arg(groupDigits(hours, 2)); }

QString textOf(double sunHours, const SunOrShadow& as) {
    if (as.isSun()) return hoursText(sunHours);
    return QObject::tr("%1 min of shadow a day").arg(groupDigits(as.amount(sunHours).value));
}

// Of the place with least, or with most. Those without a name of their own only where no other has one.
ResultRow extremeRow(const QString& name, const QString& meaning, const SunByPlace& sun, bool maximum,
                     const SunOrShadow& as) {
    std::optional<std::size_t> found;
    const bool anyNamed = std::ranges::any_of(sun.places, hasOwnName);
    for (std::size_t i = 0; i < sun.sun.size(); ++i) {
        const double hours = sun.sun[i].meanHours;
        if (std::isnan(hours) || (anyNamed && !hasOwnName(sun.places[i]))) continue;
        if (!found || (maximum ? hours > sun.sun[*found].meanHours : hours < sun.sun[*found].meanHours))
            found = i;
    }
    if (!found) return {name, QObject::tr("none"), meaning};
    return {name,
            QStringLiteral("%1\n%2").arg(placeName(sun.places[*found].name),
                                         textOf(sun.sun[*found].meanHours, as)),
            meaning};
}

QString countText(const SunByPlace& sun) {
    const auto without = std::size_t(
        std::ranges::count_if(sun.sun, [](const SunOfPlace& one) { return std::isnan(one.meanHours); }));
    const QString all = formatCount(sun.places.size());
    return without == 0 ? all : QObject::tr("%1, %2 without a cell").arg(all, formatCount(without));
}

// Least sun is most shadow.
QString shadowLabel(const Figure& figure) {
    return figure.key == "hours_min"   ? QObject::tr("Max shadow")
           : figure.key == "hours_max" ? QObject::tr("Min shadow")
                                       : QObject::tr("Mean shadow");
}

ResultRow placeFigureRow(const Figure& figure, const SunOfPlace& of, const SunOrShadow& as) {
    const double value = figure.get(&of);
    const QString text = figure.unit == FigureUnit::share ? QObject::tr("%1 %").arg(groupDigits(100 * value))
                         : figure.unit == FigureUnit::squareMetres ? describeArea(value)
                                                                   : textOf(value, as);
    const bool isHours = figure.unit != FigureUnit::share && figure.unit != FigureUnit::squareMetres;
    return {isHours && !as.isSun() ? shadowLabel(figure) : translated(figure.label), text,
            translatedSentence(figure.definition)};
}

ResultRow contributorRow(const Contribution& one) {
    const bool isTerrain = one.id == terrainId;
    return {.name = isTerrain    ? QObject::tr("Terrain")
                    : one.isTree ? nameOfTree(one)
                                 : QString::fromStdString(nameOf(one)),
            .value = QObject::tr("takes %1 min of sun a day, %2 % of its shadow")
                         .arg(formatAmount(one.attributedMin), formatAmount(100 * one.share)),
            .meaning = translatedSentence(attributedDefinition()),
            .subject = isTerrain ? QString() : QString::fromStdString(one.id)};
}

}  // namespace

std::shared_ptr<const SunOfCities> sunOf(const std::shared_ptr<const Answer>& answer) {
    if (auto sun = contentOf<SunOfCities>(answer)) return sun;
    const auto saved = contentOf<SavedContent>(answer);
    const auto* places = saved ? saved->as<SavedSunByPlace>() : nullptr;
    return places ? std::shared_ptr<const SunOfCities>(saved, &places->sun) : nullptr;
}

std::vector<ResultRow> makePlaceRows(const SunOfCities& sun, std::size_t place, ShownAs show,
                                     const ContributionTable* contributions) {
    const SunByPlace& shown = shownCity(sun);
    const SunOfPlace& of = shown.sun[place];
    std::vector<ResultRow> rows{{QObject::tr("Kind"), describeKind(shown.places[place].kind), {}}};
    for (const std::string_view remark : listRemarks(of))
        rows.push_back({QObject::tr("Remark"), translatedSentence(remark), {}});
    if (!std::isnan(of.meanHours))
        for (const Figure& figure : sunOfPlaceFigures().rows())
            rows.push_back(placeFigureRow(figure, of, {show, sun.baseline.possibleHours}));
    if (contributions == nullptr) return rows;
    constexpr std::size_t maximum = 8;  // the panel Contributions lists all
    const std::vector<Contribution> all =
        rankWithTrees(contributions->rows, contributions->trees,
                      chooseRankedColumn(contributions->trees, TreeColumns::seasonal));
    for (std::size_t i = 0; i < std::min(maximum, all.size()); ++i) rows.push_back(contributorRow(all[i]));
    return rows;
}

const AnswerViewer& byPlaceViewer() {
    static const AnswerViewer viewer{.question = byPlaceQuestion().key,
                                     .layer = layerOfPlaces,
                                     .rows = rowsOfPlaces,
                                     .title = titleOfPlaces,
                                     .savedRows = rowsOfSavedPlaces};
    return viewer;
}

std::vector<ResultRow> makeRows(const PlaceFigures& shown, ShownAs show) {
    const SunOrShadow as{show, shown.sun.baseline.possibleHours};
    const SunByPlace& sun = shownCity(shown.sun);
    std::vector<ResultRow> rows{
        {QObject::tr("Places"), countText(sun), QObject::tr("Each is a row of the panel Places")},
        {QObject::tr("Without shadow"), hoursText(shown.sun.baseline.possibleHours),
         QObject::tr("Sun above the horizon, mean over the days")},
        extremeRow(as.isSun() ? QObject::tr("Least sun") : QObject::tr("Most shadow"),
                   QObject::tr("The place with least sun in the mean"), sun, false, as),
        extremeRow(as.isSun() ? QObject::tr("Most sun") : QObject::tr("Least shadow"),
                   QObject::tr("The place with most sun in the mean"), sun, true, as)};
    rows.push_back(methodRow(QObject::tr("Period"), periodText(shown.period)));
    rows.push_back(methodRow(QObject::tr("Steps of the sun"), formatCount(shown.steps),
                             describeSteps(shown.belowHorizon)));
    rows.push_back(methodRow(QObject::tr("Engine"), QString::fromStdString(shown.engine)));
    addErrors(rows, sun.errors);
    if (sun.errors.empty() && !shown.error.empty())
        rows.push_back(methodRow(QObject::tr("Error"), localiseNumbers(QString::fromStdString(shown.error)),
                                 QObject::tr("Against the ray reference, on a sample of the cells over the "
                                             "same steps")));
    rows.push_back(methodRow(QObject::tr("Time"), formatAmount(shown.seconds, 2) + QStringLiteral(" s"),
                             QObject::tr("Time taken by all of it")));
    return rows;
}

}  // namespace noonmark
