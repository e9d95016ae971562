#include "app/gui/base/layers/ground_answer.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/base/layers/hover_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/report/maps/answer_legends.h"
#include "core/measures/shadow_figures.h"
#include "scenarios/impact/impact.h"

namespace noonmark {

namespace {

/// The change in the cell that contains a point, such as "change: gross +12.0 min a day" or "no change";
/// empty outside the grid. As sun: "change: sun -12.0 min a day".
QString formatChange(const Impact& impact, glm::dvec2 point, ShownAs show = ShownAs::shadow);

QString signedMinutes(float minutes) { return withPlus(minutes, groupDigits(double(minutes), 1)); }

/// The change of shadow as a picture for the ground. Transparent: cells that change by no more than a
/// thousandth of a minute, and cells that are not receivers in both cities; cells that became building or
/// ground have their own colour. O(cells).
GroundPicture impactPicture(const Impact& impact, ShadowMeasure measure, const ColourScale& scale) {
    GroundPicture picture;
    picture.grid = impact.grid;
    picture.pixels.reserve(impact.change.size());
    for (std::size_t cell = 0; cell < impact.change.size(); ++cell) {
        const auto colour = pickColour(impact, measure, cell, scale);
        picture.pixels.push_back(colour ? pixelOf(*colour) : GroundPicture::Pixel{});
    }
    return picture;
}

QString formatChange(const Impact& impact, glm::dvec2 point, ShownAs show) {
    const auto cell = cellAt(impact.grid, point);
    if (!cell) return {};
    if (impact.change[*cell] == CellChange::becameBuilding)
        return QObject::tr("formerly ground, now built over");
    if (impact.change[*cell] == CellChange::becameGround) return QObject::tr("formerly building, now ground");
    const float gross = impact.grossMin[*cell], continuous = impact.continuousMin[*cell];
    if (std::isnan(gross)) return QObject::tr("not measured");
    if (isInstant(impact))
        return gross > 0   ? QObject::tr("now in shadow")
               : gross < 0 ? QObject::tr("now in the sun")
                           : QObject::tr("no change");
    const ShownQuantity quantity{show, impact.sunlitMinutesPerDay};
    const QString words = quantity.isSun() ? QObject::tr("change: sun %1 min a day")
                                           : QObject::tr("change: gross %1 min a day");
    const QString text = words.arg(signedMinutes(float(quantity.ofChange(double(gross)))));
    if (std::isnan(continuous)) return text;
    if (quantity.isSun())
        return text + QObject::tr(", continuous shadow %1 min").arg(signedMinutes(continuous));
    return text + QObject::tr(", continuous %1 min").arg(signedMinutes(continuous));
}

}  // namespace

GroundPicture scorePicture(const Score& score, const ColourScale& scale) {
    GroundPicture picture;
    picture.grid = score.grid;
    picture.pixels.reserve(score.score.size());
    for (std::size_t cell = 0; cell < score.score.size(); ++cell) {
        const auto colour = pickColour(scale, double(score.score[cell]));
        picture.pixels.push_back(colour ? pixelOf(*colour) : GroundPicture::Pixel{});
    }
    return picture;
}

QString formatScore(const Score& score, glm::dvec2 point) {
    const auto cell = cellAt(score.grid, point);
    if (!cell) return {};
    const float value = score.score[*cell];
    if (std::isnan(value)) return QObject::tr("not measured");
    return QObject::tr("score %1 m² a m²").arg(withPlus(value, groupDigits(double(value), 3)));
}

namespace {

QString describeRunError(double meanPct, double p99Pct, double largestPct) {
    return QObject::tr(
               "Measured error of the longest shadow against rays, of the longest day: %1 % in the "
               "mean, %2 % at the 99th percentile, %3 % at most")
        .arg(groupDigits(meanPct, 2), groupDigits(p99Pct, 2), groupDigits(largestPct, 2));
}

}  // namespace

QString describeError(const std::optional<SampledError>& error, ShadowMeasure measure) {
    if (!error) return {};
    const CellError &gross = error->gross, &runs = error->continuous;
    if (measure == ShadowMeasure::continuous && hasRuns(*error))
        return describeRunError(runs.percent(runs.meanMin), runs.percent(runs.p99Min),
                                runs.percent(runs.maxMin));
    return QObject::tr("Measured error against rays: %1 % of the area, %2 % of the minutes of a cell")
        .arg(groupDigits(error->areaPct, 2), groupDigits(gross.percent(gross.meanMin), 2));
}

QString describeCellError(const SampledError& error, double sunlitMin, ShownAs show) {
    const ShownQuantity quantity{show, sunlitMin};
    const std::string_view unit = quantity.shortUnit();
    return QObject::tr("A cell: %1 %3 in the mean, 99 of 100 within %2 %3")
        .arg(groupDigits(quantity.ofError(error.gross.meanMin), 3),
             groupDigits(quantity.ofError(error.gross.p99Min), 2),
             QString::fromUtf8(unit.data(), qsizetype(unit.size())));
}

QString describeError(const ElementStudy& study, ShadowMeasure measure) {
    if (!study.error) return {};
    const QuantityError& runs = study.error->continuous;
    if (measure == ShadowMeasure::continuous)
        return describeRunError(runs.meanPct, runs.p99Pct, runs.largestPct);
    return QObject::tr("Measured error against rays: %1 % of the time in the sun")
        .arg(groupDigits(study.error->gross.meanPct, 3));
}

namespace {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

template <class... Cases>
auto over(const GroundAnswer::Map& map, Cases... cases) {
    return std::visit([visitor = Overloaded{cases...}](const auto& shared) { return visitor(*shared); }, map);
}

ShadowMeasure chooseShownMeasure(const GroundAnswer& answer, ShadowMeasure wanted) {
    return answer.grossOnly ? ShadowMeasure::gross : wanted;
}

double sunlitMinOf(const GroundAnswer::Map& map) {
    return over(
        map, [](const Score&) { return 0.0; },
        [](const auto& minutes) { return minutes.sunlitMinutesPerDay; });
}

// A moment has no minutes.
std::optional<SampledError> errorOfMinutes(const Study& study) {
    return isInstant(study.field) ? std::nullopt : study.error;
}

QString notCounted() { return QObject::tr("Continuous shadow was not counted"); }

// `owner` keeps the field alive.
std::vector<GroundAnswer::Column> columnsOf(const ShadowField& field,
                                            const std::shared_ptr<const void>& owner) {
    std::vector<GroundAnswer::Column> columns;
    for (const ShadeColumn& shade : listShadeColumns(field))
        columns.push_back(
            {shade.column, std::shared_ptr<const ShadowField>(owner, shade.field), !hasRuns(*shade.field)});
    return columns;
}

std::vector<GroundAnswer::Column> columnsOf(const std::shared_ptr<const ImpactAnswer>& comparison) {
    std::vector<GroundAnswer::Column> columns;
    for (const ShadeImpact& with : comparison->study.withTrees)
        columns.push_back(
            {with.column, std::shared_ptr<const Impact>(comparison, &with.impact), !hasRuns(with.impact)});
    return columns;
}

QString withoutTrees(const QString& note) {
    return note.isEmpty() ? note : QObject::tr("Without trees: %1").arg(note);
}

}  // namespace

GroundAnswer makeGroundAnswer(const std::shared_ptr<const Study>& study) {
    return markMissingRuns({.map = std::shared_ptr<const ShadowField>(study, &study->field),
                            .receivers = std::shared_ptr<const Receivers>(study, &study->receivers),
                            .note = describeError(study->error, ShadowMeasure::gross),
                            .runNote = describeError(study->error, ShadowMeasure::continuous),
                            .error = errorOfMinutes(*study),
                            .when = describeWhen(study->settings.period),
                            .withTrees = columnsOf(study->field, study)});
}

GroundAnswer makeGroundAnswer(const std::shared_ptr<const PartialField>& partial) {
    return {std::shared_ptr<const ShadowField>(partial, &partial->field), nullptr,
            QObject::tr("So far: %1 (%2 %)")
                .arg(QString::fromStdString(partial->part))
                .arg(int(partial->share * 100)),
            true, !hasRuns(partial->field)};
}

GroundAnswer markMissingRuns(GroundAnswer answer) {
    answer.grossOnly = over(
        answer.map, [](const Score&) { return false; },
        [](const auto& map) { return !hasRuns(map.continuousMin); });
    if (answer.grossOnly) answer.whyGross = notCounted();
    return answer;
}

GroundAnswer makeGroundAnswer(const std::shared_ptr<const ImpactAnswer>& comparison) {
    const QString names =
        QObject::tr("%1 compared with %2").arg(scenarioName(comparison->to), scenarioName(comparison->from));
    const auto noteOf = [&](ShadowMeasure measure) {
        const QString error = describeError(comparison->study.error, measure);
        return error.isEmpty() ? names : QObject::tr("%1. %2").arg(names, error);
    };
    return markMissingRuns({.map = std::shared_ptr<const Impact>(comparison, &comparison->study.total),
                            .note = noteOf(ShadowMeasure::gross),
                            .runNote = noteOf(ShadowMeasure::continuous),
                            .error = comparison->study.error,
                            .when = describeWhen(comparison->settings.study.period),
                            .withTrees = columnsOf(comparison)});
}

GroundAnswer makeGroundAnswer(const std::shared_ptr<const ImpactAnswer>& comparison,
                              const ShadowField& field) {
    return markMissingRuns({.map = std::shared_ptr<const ShadowField>(comparison, &field),
                            .when = describeWhen(comparison->settings.study.period),
                            .withTrees = columnsOf(field, comparison)});
}

GroundAnswer makeGroundAnswer(std::shared_ptr<const void> owner, const ShadowField& field) {
    return markMissingRuns(
        {.map = std::shared_ptr<const ShadowField>(owner, &field), .withTrees = columnsOf(field, owner)});
}

GroundAnswer showColumn(GroundAnswer answer, TreeColumns column) {
    const auto found = std::ranges::find(answer.withTrees, column, &GroundAnswer::Column::column);
    if (found == answer.withTrees.end()) return answer;
    answer.map = found->map;
    answer.trees = column;
    answer.grossOnly = found->grossOnly;
    answer.whyGross = answer.grossOnly ? notCounted() : QString();
    if (!answer.error) return answer;
    answer.note = withoutTrees(answer.note);
    answer.runNote = withoutTrees(answer.runNote);
    answer.error.reset();
    return answer;
}

GroundAnswer makeGroundAnswer(const std::shared_ptr<const ScoreAnswer>& score) {
    const std::shared_ptr<const Score> all(score, &score->score);
    std::vector<GroundAnswer::Column> columns;
    for (const ShadedScore& with : score->score.withTrees)
        if (!with.score.empty()) columns.push_back({with.column, showColumn(all, with.column), false});
    return {.map = all,
            .note = QObject::tr("%1 with the weights %2")
                        .arg(scenarioName(score->scenario), weightName(score->weights.name)),
            .when = describeWhen(score->settings.period),
            .withTrees = std::move(columns)};
}

QString makeNote(const GroundAnswer& answer, ShadowMeasure measure, ShownAs show) {
    const ShadowMeasure shown = chooseShownMeasure(answer, measure);
    const bool ofRuns = shown == ShadowMeasure::continuous && !answer.runNote.isEmpty();
    QStringList parts{answer.when, ofRuns ? answer.runNote : answer.note};
    if (answer.error && !ofRuns) parts << describeCellError(*answer.error, sunlitMinOf(answer.map), show);
    if (shown != measure) parts << answer.whyGross;
    parts.removeAll(QString());
    return parts.join(QStringLiteral(". "));
}

Legend makeLegend(const GroundAnswer& answer, ShadowMeasure measure, const ChangeScale& scale,
                  const LegendChoice& choice) {
    Legend legend = over(
        answer.map, [&](const Score& score) { return makeLegend(score, choice); },
        [&](const Impact& impact) {
            return makeLegend(impact, chooseShownMeasure(answer, measure), scale, choice);
        },
        [&](const ShadowField& field) {
            return makeLegend(field, chooseShownMeasure(answer, measure), choice);
        });
    if (!answer.withTrees.empty()) nameTrees(legend, answer.trees);
    return legend;
}

GroundPicture makePicture(const GroundAnswer& answer, ShadowMeasure measure, const Legend& legend) {
    const ColourScale colours = coloursOf(legend);
    return over(
        answer.map, [&](const Score& score) { return scorePicture(score, colours); },
        [&](const Impact& impact) {
            return impactPicture(impact, chooseShownMeasure(answer, measure), colours);
        },
        [&](const ShadowField& field) {
            return fieldPicture(field, answer.receivers.get(), chooseShownMeasure(answer, measure), colours);
        });
}

std::optional<GroundPicture> roofPictureOf(const GroundAnswer& answer, ShadowMeasure measure,
                                           const Legend& legend) {
    const auto* field = std::get_if<std::shared_ptr<const ShadowField>>(&answer.map);
    if (!field || !answer.receivers) return std::nullopt;
    return roofPicture(**field, *answer.receivers, chooseShownMeasure(answer, measure), coloursOf(legend));
}

bool isOnRoof(const GroundAnswer& answer, glm::dvec2 point) {
    if (!answer.receivers) return false;
    const auto cell = cellAt(answer.receivers->grid, point);
    return cell && answer.receivers->kind[*cell] == CellKind::roof;
}

QString textAt(const GroundAnswer& answer, glm::dvec2 point, ShownAs show) {
    return over(
        answer.map, [&](const Score& score) { return formatScore(score, point); },
        [&](const Impact& impact) { return formatChange(impact, point, show); },
        [&](const ShadowField& field) { return formatMinutes(field, point, show); });
}

}  // namespace noonmark
