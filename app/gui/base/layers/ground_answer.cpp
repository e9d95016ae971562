#include "app/gui/base/layers/ground_answer.h"

#include <QObject>

#include "app/gui/base/layers/error_notes.h"
#include "app/gui/base/layers/field_picture.h"
#include "app/gui/base/layers/hover_text.h"
#include "app/gui/base/layers/impact_picture.h"
#include "app/gui/base/layers/score_picture.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/report/maps/impact_legend.h"
#include "app/report/maps/score_legend.h"
#include "core/measures/has_runs.h"

namespace noonmark {

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

QString nameOf(const std::string& name) { return QString::fromStdString(name); }

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

}  // namespace

GroundAnswer makeGroundAnswer(const std::shared_ptr<const Study>& study) {
    return markMissingRuns({.map = std::shared_ptr<const ShadowField>(study, &study->field),
                            .receivers = std::shared_ptr<const Receivers>(study, &study->receivers),
                            .note = describeError(study->error, ShadowMeasure::gross),
                            .runNote = describeError(study->error, ShadowMeasure::continuous),
                            .error = errorOfMinutes(*study)});
}

GroundAnswer makeGroundAnswer(const std::shared_ptr<const PartialField>& partial) {
    return {std::shared_ptr<const ShadowField>(partial, &partial->field), nullptr,
            QObject::tr("So far: %1 (%2 %)").arg(nameOf(partial->part)).arg(int(partial->share * 100)), true,
            !hasRuns(partial->field)};
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
        QObject::tr("%1 compared with %2").arg(nameOf(comparison->to), nameOf(comparison->from));
    const auto noteOf = [&](ShadowMeasure measure) {
        const QString error = describeError(comparison->study.error, measure);
        return error.isEmpty() ? names : QObject::tr("%1. %2").arg(names, error);
    };
    return markMissingRuns({.map = std::shared_ptr<const Impact>(comparison, &comparison->study.total),
                            .note = noteOf(ShadowMeasure::gross),
                            .runNote = noteOf(ShadowMeasure::continuous),
                            .error = comparison->study.error});
}

GroundAnswer makeGroundAnswer(const std::shared_ptr<const ScoreAnswer>& score) {
    return {std::shared_ptr<const Score>(score, &score->score), nullptr,
            QObject::tr("%1 with the weights %2").arg(nameOf(score->scenario), nameOf(score->weights.name))};
}

QString makeNote(const GroundAnswer& answer, ShadowMeasure measure, ShownAs show) {
    const ShadowMeasure shown = chooseShownMeasure(answer, measure);
    if (shown == ShadowMeasure::continuous && !answer.runNote.isEmpty()) return answer.runNote;
    QStringList parts{answer.note};
    if (answer.error) parts << describeCellError(*answer.error, sunlitMinOf(answer.map), show);
    if (shown != measure) parts << answer.whyGross;
    parts.removeAll(QString());
    return parts.join(QStringLiteral(". "));
}

Legend makeLegend(const GroundAnswer& answer, ShadowMeasure measure, const ChangeScale& scale,
                  const LegendChoice& choice) {
    return over(
        answer.map, [&](const Score& score) { return makeLegend(score, choice); },
        [&](const Impact& impact) {
            return makeLegend(impact, chooseShownMeasure(answer, measure), scale, choice);
        },
        [&](const ShadowField& field) {
            return makeLegend(field, chooseShownMeasure(answer, measure), choice);
        });
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
